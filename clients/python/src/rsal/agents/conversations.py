"""Conversations by FIPA's protocols: a request (SC00026H) and a contract net (SC00029H). What is said is a dict."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rsal.agents.convert import encode
from rsal.agents.waiting import Pending

if TYPE_CHECKING:
    from rsal.agents.agent import Agent


@dataclass(frozen=True)
class Result:
    """The one way in which a conversation ended.

    :param how: ``informed``, ``refused``, ``failed``, ``not understood``, ``silent`` or ``cancelled``
    :param content: the answer, of one that was informed; else empty
    :param why: in words, of all others
    """

    how: str
    content: dict[str, Any]
    why: str

    @property
    def informed(self) -> bool:
        """Whether the other agent answered; else ``why`` has the reason."""
        return self.how == "informed"


class Refusal(Exception):
    """Raised by one who was asked: it does not want to, or cannot. The other gets the words."""


@dataclass(frozen=True)
class Question:
    """What another agent asks for, or the task that it has accepted a bid for.

    :param sender: name of that agent
    """

    sender: str
    content: dict[str, Any]


@dataclass(frozen=True)
class Call:
    """A task that one may bid for.

    :param sender: name of the manager
    :param reply_by: later bids are of no use [s]
    """

    sender: str
    task: dict[str, Any]
    reply_by: float


@dataclass(frozen=True)
class Award:
    """How a task ended that was given to one whose bid was accepted."""

    sender: str
    bid: dict[str, Any]
    result: Result


def check_name(to: object) -> None:
    """Raise TypeError unless it is a text: names are what agents are told apart by."""
    if not isinstance(to, str):
        remedy = " Maybe add '.name' to it." if isinstance(getattr(to, "name", None), str) else ""
        raise TypeError(f"A message goes to the name of an agent, not to '{type(to).__name__}'.{remedy}")


def _result(words: dict[str, Any]) -> Result:
    return Result(words["how"], words["content"], words["why"])


def ask(agent: Agent, to: str, service: str, question: dict[str, Any], silence: float) -> Pending[Result]:
    """Begin a FIPA Request; see :meth:`Agent.ask`."""
    check_name(to)
    pending: Pending[Result] = Pending(agent._run)
    link = agent._link

    def heard(words: Any, _arrays: memoryview) -> None:
        del link.heard[number]
        pending._end(_result(words))

    number = link.listen(heard)
    link.do("ask", number, to, service, encode(question), float(silence))
    return pending


def answer(agent: Agent, service: str, method: Callable[[Question], object]) -> None:
    """Answer FIPA Requests; see :meth:`Agent.answer`."""

    def heard(words: Any, _arrays: memoryview) -> None:
        _reply(agent, words["dialogue"], method, Question(words["sender"], words["content"]))

    agent._link.do("answer", agent._link.listen(heard), service)


def _reply(agent: Agent, dialogue: int, method: Callable[[Question], object], question: Question) -> None:
    """Says what the method returns, now or when its coroutine ends."""
    link = agent._link

    def inform(content: object) -> None:
        if not isinstance(content, dict):
            raise TypeError(f"The answer to '{question.sender}' is a dict, not '{type(content).__name__}'.")
        link.do("inform", dialogue, encode(content))

    async def later(coroutine: Any) -> None:
        try:
            inform(await coroutine)
        except Refusal as why:
            link.do("fail", dialogue, str(why))

    try:
        result = method(question)
        if inspect.iscoroutine(result):
            link.do("agree", dialogue)
            agent.spawn(later(result))
        else:
            inform(result)
    except Refusal as why:
        link.do("refuse", dialogue, str(why))


def call(
    agent: Agent,
    service: str,
    task: dict[str, Any],
    to: Sequence[str],
    *,
    criterion: str,
    least: bool,
    count: int,
    within: float,
) -> Pending[list[Award]]:
    """Begin a FIPA Contract Net as its manager; see :meth:`Agent.call`."""
    if isinstance(to, str):
        raise TypeError(f"A call goes to a list of names, not to the text '{to}'. Maybe write ['{to}'].")
    for each in to:
        check_name(each)
    pending: Pending[list[Award]] = Pending(agent._run)
    link = agent._link
    open_bids: dict[str, dict[str, Any]] = {}
    awards: list[Award] = []

    def heard(words: Any, _arrays: memoryview) -> None:
        if "chosen" in words:
            open_bids.update({each["sender"]: each["bid"] for each in words["chosen"]})
        else:
            awards.append(Award(words["sender"], open_bids.pop(words["sender"]), _result(words)))
        if not open_bids:
            del link.heard[number]
            pending._end(awards)

    number = link.listen(heard)
    link.do("tender", number, service, encode(task), list(to), float(within), criterion, least, count)
    return pending


def bid(
    agent: Agent,
    service: str,
    propose: Callable[[Call], dict[str, Any] | None],
    perform: Callable[[Question], object],
) -> None:
    """Answer calls for proposals; see :meth:`Agent.bid`."""
    link = agent._link

    def heard(words: Any, _arrays: memoryview) -> None:
        if "replyBy" in words:
            try:
                offered = propose(Call(words["sender"], words["content"], words["replyBy"]))
            except Refusal as why:
                link.do("refuse", words["dialogue"], str(why))
                return
            if offered is None:
                link.do("refuse", words["dialogue"], "")
            else:
                link.do("propose", words["dialogue"], encode(offered))
        else:
            _reply(agent, words["dialogue"], perform, Question(words["sender"], words["content"]))

    link.do("bid", link.listen(heard), service)

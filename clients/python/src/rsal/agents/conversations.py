"""Conversations by FIPA's protocols. What is said is a dict.

These are Request (SC00026H), Contract Net (SC00029H), English and Dutch Auction (XC00031F, XC00032F), Propose
(SC00036H) and Subscribe (SC00035H).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from rsal.agents.convert import encode
from rsal.agents.waiting import Pending

if TYPE_CHECKING:
    from rsal.agents.agent import Agent

R = TypeVar("R")


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


@dataclass(frozen=True)
class Offer:
    """What is sold in an auction, at the price that stands now."""

    lot: dict[str, Any]
    price: float


@dataclass(frozen=True)
class Sale:
    """How an auction ended.

    :param winner: name of the agent that has it; empty when nobody paid enough
    :param price: the last that somebody wanted, or that was called when nobody did
    :param why: in words, when it could not be held to its end; ``price`` is NaN then
    """

    winner: str
    price: float
    why: str = ""


def check_name(to: object) -> None:
    """Raise TypeError unless it is a text: names are what agents are told apart by."""
    if not isinstance(to, str):
        remedy = " Maybe add '.name' to it." if isinstance(getattr(to, "name", None), str) else ""
        raise TypeError(f"A message goes to the name of an agent, not to '{type(to).__name__}'.{remedy}")


def _check_names(to: Sequence[str]) -> None:
    if isinstance(to, str):
        raise TypeError(f"A call goes to a list of names, not to the text '{to}'. Maybe write ['{to}'].")
    for each in to:
        check_name(each)


def _result(words: dict[str, Any]) -> Result:
    return Result(words["how"], words["content"], words["why"])


def ask(agent: Agent, to: str, service: str, question: dict[str, Any], silence: float) -> Pending[Result]:
    """Begin a FIPA Request; see :meth:`Agent.ask`."""
    check_name(to)
    return _begin(agent, _result, "ask", to, service, encode(question), float(silence))


def propose(agent: Agent, to: str, service: str, proposal: dict[str, Any], silence: float) -> Pending[Result]:
    """Begin a FIPA Propose; see :meth:`Agent.propose`."""
    check_name(to)
    return _begin(agent, _result, "suggest", to, service, encode(proposal), float(silence))


def _begin(agent: Agent, ended: Callable[[dict[str, Any]], R], verb: str, *words: Any) -> Pending[R]:
    """Begin what RSAL answers once."""
    pending: Pending[R] = Pending(agent._run)
    link = agent._link

    def heard(answer: Any, _arrays: memoryview) -> None:
        del link.heard[number]
        pending._end(ended(answer))

    number = link.listen(heard)
    link.do(verb, number, *words)
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
    _check_names(to)
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


def sell(
    agent: Agent,
    service: str,
    lot: dict[str, Any],
    to: Sequence[str],
    *,
    first: float,
    step: float,
    reserve: float,
    stands: float,
) -> Pending[Sale]:
    """Sell in an auction; see :meth:`Agent.sell`."""
    _check_names(to)
    prices = float(first), float(step), float(reserve)
    return _begin(agent, _sale, "sell", service, encode(lot), list(to), *prices, float(stands))


def _sale(words: dict[str, Any]) -> Sale:
    return Sale(words["winner"], float(words["price"]), words["why"])


def buy(
    agent: Agent,
    service: str,
    pays: Callable[[Offer], object],
    *,
    dutch: bool,
    on_end: Callable[[dict[str, Any], Sale], object] | None,
) -> None:
    """Bid in auctions; see :meth:`Agent.buy`."""
    link = agent._link

    def decide(dialogue: int, wanted: object) -> None:
        if not isinstance(wanted, (bool, np.bool_)):
            raise TypeError(f"Whether an agent pays a price is True or False, not '{wanted!r}'.")
        if wanted:
            link.do("propose", dialogue, {})
        else:
            link.do("refuse", dialogue, "")

    async def later(dialogue: int, coroutine: Any) -> None:
        decide(dialogue, await coroutine)

    def heard(words: Any, _arrays: memoryview) -> None:
        if "winner" in words:
            if on_end is not None:
                agent._run(on_end, words["content"], _sale(words))
            return
        result = pays(Offer(words["content"], float(words["price"])))
        if inspect.iscoroutine(result):
            agent.spawn(later(words["dialogue"], result))
        else:
            decide(words["dialogue"], result)

    link.do("buy", link.listen(heard), service, dutch)


def judge(agent: Agent, service: str, method: Callable[[Question], object]) -> None:
    """Decide about proposals; see :meth:`Agent.judge`."""
    link = agent._link

    def decide(dialogue: int, accepted: object) -> None:
        if not isinstance(accepted, bool):
            raise TypeError(f"A proposal is accepted by True and rejected by False, not by '{accepted!r}'.")
        if accepted:
            link.do("inform", dialogue, {})
        else:
            link.do("refuse", dialogue, "")

    async def later(dialogue: int, coroutine: Any) -> None:
        try:
            decide(dialogue, await coroutine)
        except Refusal as why:
            link.do("refuse", dialogue, str(why))

    def heard(words: Any, _arrays: memoryview) -> None:
        dialogue = words["dialogue"]
        try:
            result = method(Question(words["sender"], words["content"]))
        except Refusal as why:
            link.do("refuse", dialogue, str(why))
            return
        if inspect.iscoroutine(result):
            agent.spawn(later(dialogue, result))
        else:
            decide(dialogue, result)

    link.do("judge", link.listen(heard), service)


class Subscriber:
    """An agent that wants news; see :meth:`Agent.admit`. What is told to one that has gone does nothing."""

    def __init__(self, agent: Agent, dialogue: int, sender: str, content: dict[str, Any]) -> None:
        self.sender = sender
        """Name of that agent."""
        self.content = content
        """What it wants news about."""
        self._agent = agent
        self._dialogue = dialogue
        self._gone = False
        self._on_end: Callable[[], object] | None = None

    @property
    def gone(self) -> bool:
        """Whether it does not want news any more."""
        return self._gone

    def inform(self, news: dict[str, Any]) -> None:
        """Tell it news. Each comes once and in order."""
        if not self._gone:
            self._agent._link.do("tell", self._dialogue, encode(news))

    def fail(self, why: str) -> None:
        """Tell it that there will be no more."""
        self._end(why, refused=False)

    def on_end(self, method: Callable[[], object]) -> None:
        """Call a method when it does not want news any more, or has gone."""
        self._on_end = method

    def _end(self, why: str, refused: bool) -> None:
        if not self._gone:
            self._gone = True
            self._agent._link.do("endTelling", self._dialogue, why, refused)

    def _leave(self) -> None:
        if not self._gone:
            self._gone = True
            if self._on_end is not None:
                self._agent._run(self._on_end)


def admit(agent: Agent, service: str, method: Callable[[Subscriber], object]) -> None:
    """Admit subscribers; see :meth:`Agent.admit`."""
    subscribers: dict[int, Subscriber] = {}

    def heard(words: Any, _arrays: memoryview) -> None:
        if "over" in words:
            known = subscribers.pop(words["over"], None)
            if known is not None:
                known._leave()
            return
        subscriber = Subscriber(agent, words["dialogue"], words["sender"], words["content"])
        try:
            agent._run(method, subscriber)
            subscribers[words["dialogue"]] = subscriber
        except Refusal as why:
            subscriber._end(str(why), refused=True)

    agent._link.do("admit", agent._link.listen(heard), service)


def follow(
    agent: Agent,
    to: str,
    service: str,
    question: dict[str, Any],
    on_news: Callable[[dict[str, Any]], object],
    *,
    on_end: Callable[[Result], object] | None,
    silence: float,
) -> int:
    """Begin a FIPA Subscribe; see :meth:`Agent.follow`."""
    link = agent._link

    def heard(words: Any, _arrays: memoryview) -> None:
        if words["how"] == "":
            agent._run(on_news, words["content"])
            return
        del link.heard[number]
        if on_end is not None:
            agent._run(on_end, _result(words))

    number = link.listen(heard)
    link.do("follow", number, to, service, encode(question), float(silence))
    return number

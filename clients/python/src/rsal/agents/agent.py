"""What agents are written with: a class that inherits from :class:`Agent`."""

from __future__ import annotations

import inspect
import random
from collections.abc import Callable, Coroutine, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, TypeVar, overload

import numpy as np

from rsal.agents import conversations as talk
from rsal.agents import values as v
from rsal.agents.boards import TeamBoard
from rsal.agents.convert import decoder
from rsal.agents.devices import Device, Robot, Sensor, Simulation, Stamped, Subscription
from rsal.agents.link import Link
from rsal.agents.topics import Topic, topic_content, topic_of
from rsal.agents.waiting import Pending, Task

M = TypeVar("M")
T = TypeVar("T")


@dataclass(frozen=True)
class Message(Generic[M]):
    """Something said.

    :param sender: name of the agent that said it, or ``operator``
    :param to: name of the agent it is for; empty when it is for all
    :param time: when it was said [s]
    """

    sender: str
    to: str
    time: float
    content: M


@dataclass(frozen=True)
class Entry:
    """An agent that runs, as the directory has it.

    :param kind: its type, as the scenario names it
    :param robot: id of its robot; empty when it has none
    :param services: what it offers, by name, with details
    """

    name: str
    role: str
    kind: str
    robot: str
    robot_role: str
    services: dict[str, dict[str, str]]


@dataclass(frozen=True)
class Note(Generic[M]):
    """A note on an agent's own blackboard.

    :param written: when [s]
    """

    name: str
    content: M
    written: float


class Blackboard:
    """An agent's own notes, which fade when their time is up."""

    def __init__(self, link: Link) -> None:
        self._link = link

    def write(self, topic: type[M] | Topic[M], name: str, content: M, lifetime: float | None = None) -> None:
        """Write a note, in place of the one of that name.

        :param lifetime: after which it fades [s]; ``None`` for one that stays
        """
        key, words = topic_content(topic, content)
        self._link.do("write", key, name, words, lifetime)

    def erase(self, topic: type[M] | Topic[M], name: str) -> None:
        """Erase the note of that name; without one, nothing happens."""
        self._link.do("erase", topic_of(topic)[0], name)

    def read(self, topic: type[M] | Topic[M]) -> list[Note[M]]:
        """All notes of a topic, the oldest first."""
        key, kind = topic_of(topic)
        words, arrays = self._link.ask("notes", key)
        decode = decoder(kind)
        return [Note(each["name"], decode(each["content"], arrays), each["written"]) for each in words]


class Mind:
    """Beliefs and goals, as the page shows them."""

    def __init__(self, link: Link) -> None:
        self._link = link

    def believe(self, name: str, value: object) -> None:
        """Show a belief; replace the one of that name."""
        self._link.do("believe", name, str(value))

    def forget(self, name: str) -> None:
        """Show a belief no more."""
        self._link.do("forget", name)

    def pursue(self, goal: str, step: str = "") -> None:
        """Show a goal as pursued, with what is done for it now. Another one that was pursued waits."""
        self._link.do("pursue", goal, step)

    def reach(self, goal: str) -> None:
        """Show a goal as reached."""
        self._link.do("reached", goal)

    def drop(self, goal: str) -> None:
        """Show a goal no more."""
        self._link.do("drop", goal)


class Agent:
    """Decides what a robot, or a team, should do. Write a class that inherits from this, with :meth:`on_start`.

    Its methods are called one after the other. None may block: the run waits for it in simulated time. What a method
    throws ends this agent alone, with the line in the run's log.
    """

    needs: ClassVar[Sequence[type[Device]]] = ()
    """Devices without which it cannot work. Checked before a run."""

    name: str
    """Unique in a run (``follow-1``)."""
    role: str
    """What the scenario calls agents of its kind (``follow``)."""
    random: random.Random
    """A stream of this agent's own, by the seed of the run."""

    _link: Link
    _robot: Robot | None
    _simulation: Simulation | None
    _seed: int
    _rng: np.random.Generator | None
    _tasks: list[Task]
    _boards: dict[str, TeamBoard]

    def on_start(self) -> Any:
        """Begins: subscribe, set timers, set off. May be ``async``."""

    def on_stop(self) -> Any:
        """Clean up: the run ends, or the agent is stopped. Not called after an exception.

        When the run ends, its result and events are complete before: what is printed or measured here is not in them.
        In real time nothing can be asked here, as the run does not wait for it.
        """

    # What it is and has

    @property
    def time(self) -> float:
        """Time of the run [s]: since its begin in simulated time, else since 1970."""
        return self._link.time

    @property
    def robot(self) -> Robot:
        """The robot it acts for.

        :raises LookupError: when it has none
        """
        if self._robot is None:
            raise LookupError(f"Agent '{self.name}' has no robot. Maybe add 'robot: ROLE' to it in the scenario.")
        return self._robot

    @property
    def simulation(self) -> Simulation | None:
        """The truth of the simulated world; ``None`` where all is real."""
        return self._simulation

    @property
    def rng(self) -> np.random.Generator:
        """A generator of numpy, by the seed of the run."""
        if self._rng is None:
            self._rng = np.random.Generator(np.random.PCG64(self._seed))
        return self._rng

    @property
    def blackboard(self) -> Blackboard:
        """The agent's own notes."""
        return Blackboard(self._link)

    def team_board(self, name: str) -> TeamBoard:
        """Return this agent's end of a board that its team shares. Some agent must keep it: :meth:`keep_board`."""
        board = self._boards.get(name)
        if board is None:
            board = self._boards[name] = TeamBoard(self, name)
        return board

    def keep_board(self, name: str) -> None:
        """Keep a board of the team as its master. Of two masters, the one that started first keeps it."""
        self._link.do("keepBoard", name)

    @property
    def mind(self) -> Mind:
        """Beliefs and goals that people see on the page."""
        return Mind(self._link)

    # Messages

    @overload
    def publish(self, topic: Topic[M], message: M) -> None: ...
    @overload
    def publish(self, topic: object) -> None: ...
    def publish(self, topic: Any, message: Any = None) -> None:
        """Send a message to all who listen: ``publish(PoseReport(…))``, or ``publish(BIDS, {"price": 3})``."""
        self._link.do("publish", *topic_content(topic, message))

    @overload
    def send(self, to: str, topic: Topic[M], message: M) -> None: ...
    @overload
    def send(self, to: str, topic: object) -> None: ...
    def send(self, to: str, topic: Any, message: Any = None) -> None:
        """Send a message to one agent, if it listens."""
        talk.check_name(to)
        self._link.do("send", to, *topic_content(topic, message))

    @overload
    def subscribe(self, source: Sensor[T], listener: Callable[[Stamped[T]], object]) -> Subscription: ...
    @overload
    def subscribe(
        self, source: Topic[M] | type[M], listener: Callable[[Message[M]], object], *, at_most_every: float = 0.0
    ) -> Subscription: ...
    def subscribe(self, source: Any, listener: Callable[[Any], object], *, at_most_every: float = 0.0) -> Subscription:
        """Call a method with each reading of a device, or with each message of a topic.

        :param at_most_every: least time between two messages of one sender [s]
        """
        if isinstance(source, Sensor):
            return source.subscribe(listener)
        name, kind = topic_of(source)
        decode = decoder(kind)

        def heard(words: Any, arrays: memoryview) -> None:
            content = decode(words["content"], arrays)
            self._run(listener, Message(words["sender"], words["to"], words["time"], content))

        number = self._link.listen(heard)
        self._link.do("subscribe", number, name, float(at_most_every))
        return Subscription(self, number)

    # Time

    def after(self, seconds: float, method: Callable[..., object], *arguments: Any) -> Subscription:
        """Call a method once."""

        def heard(_words: Any, _arrays: memoryview) -> None:
            del self._link.heard[number]
            self._run(method, *arguments)

        number = self._link.listen(heard)
        self._link.do("after", number, float(seconds))
        return Subscription(self, number)

    def every(self, seconds: float, method: Callable[..., object], *arguments: Any) -> Subscription:
        """Call a method again and again, first after that time.

        An ``async`` method that takes longer than that begins again while it goes on.
        """
        number = self._link.listen(lambda _words, _arrays: self._run(method, *arguments))
        self._link.do("every", number, float(seconds))
        return Subscription(self, number)

    def sleep(self, seconds: float) -> Pending[None]:
        """``await self.sleep(2)`` waits in the time of the run."""
        pending: Pending[None] = Pending(self._run)
        self.after(seconds, pending._end, None)
        return pending

    def spawn(self, coroutine: Coroutine[Any, Any, Any]) -> None:
        """Begins a coroutine beside what is running."""
        task = Task(coroutine, self._tasks.remove)
        self._tasks.append(task)
        task.go_on()

    def _run(self, method: Callable[..., object], *arguments: Any) -> None:
        result = method(*arguments)
        if result is not None and inspect.iscoroutine(result):
            self.spawn(result)

    # Others

    def agents(self, role: str = "", offering: str = "") -> list[Entry]:
        """Return running agents, in the order in which they started: of a role, or those that offer a service."""
        words, _ = self._link.ask("agents")
        found = [
            Entry(each["name"], each["role"], each["type"], each["robot"], each["robotRole"], each["services"])
            for each in words
        ]
        return [each for each in found if role in ("", each.role) and (not offering or offering in each.services)]

    def on_departure(self, listener: Callable[[str, str], object]) -> Subscription:
        """Call a method with the name of each agent that goes, and why.

        The reason is empty when it ended as it should.
        """
        number = self._link.listen(lambda words, _arrays: self._run(listener, words["name"], words["reason"]))
        self._link.do("departures", number)
        return Subscription(self, number)

    def offer(self, service: str, **details: object) -> Subscription:
        """Show in the directory what it can do for others, until that is cancelled."""
        number = self._link.listen(lambda _words, _arrays: None)
        self._link.do("offer", number, service, {name: str(value) for name, value in details.items()})
        return Subscription(self, number)

    # Conversations

    def ask(self, to: str, service: str, question: dict[str, Any], silence: float = 5.0) -> Pending[talk.Result]:
        """Asks an agent (FIPA Request): ``result = await self.ask("amy", "weight", {"thing": "box"})``.

        :param silence: after how long without a sign the other counts as silent [s]
        """
        return talk.ask(self, to, service, question, silence)

    def answer(self, service: str, method: Callable[[talk.Question], object]) -> None:
        """Answers those who ask: what the method returns is the answer, a dict. It may be ``async``, and refuse."""
        talk.answer(self, service, method)

    def call(
        self,
        service: str,
        task: dict[str, Any],
        to: Sequence[str],
        *,
        least: str = "",
        most: str = "",
        count: int = 1,
        within: float = 2.0,
    ) -> Pending[list[talk.Award]]:
        """Call for proposals (FIPA Contract Net), and wait until those whose bids were accepted have ended.

        :param to: names of those called
        :param least: name of the number in the bids of which less is better, as ``cost``
        :param most: name of the number of which more is better; give one of both
        :param count: how many bids are accepted at most
        :param within: after this the round is over [s]
        """
        if bool(least) == bool(most):
            raise ValueError("A call for proposals needs 'least' or 'most': the number of the bids to choose by.")
        return talk.call(
            self, service, task, to, criterion=least or most, least=bool(least), count=count, within=within
        )

    def bid(
        self,
        service: str,
        propose: Callable[[talk.Call], dict[str, Any] | None],
        perform: Callable[[talk.Question], object],
    ) -> None:
        """Answers calls for proposals.

        :param propose: returns the bid, a dict; ``None`` refuses
        :param perform: does what was accepted, and returns the result, a dict; it may be ``async``
        """
        talk.bid(self, service, propose, perform)

    def sell(
        self,
        service: str,
        lot: dict[str, Any],
        to: Sequence[str],
        *,
        first: float,
        step: float,
        reserve: float = 0.0,
        stands: float = 1.0,
    ) -> Pending[talk.Sale]:
        """Sell something in an auction (FIPA English and Dutch Auction): ``sale = await self.sell(…)``.

        :param to: names of those who may bid
        :param first: first price
        :param step: from one price to the next: above 0 in an English auction, below 0 in a Dutch one
        :param reserve: it is not sold for less
        :param stands: how long each price stands [s]
        """
        return talk.sell(self, service, lot, to, first=first, step=step, reserve=reserve, stands=stands)

    def buy(
        self,
        service: str,
        pays: Callable[[talk.Offer], object],
        *,
        dutch: bool = False,
        on_end: Callable[[dict[str, Any], talk.Sale], object] | None = None,
    ) -> None:
        """Bid in auctions of a service.

        :param pays: returns whether it would have the lot at this price; it may be ``async``, while the price stands
        :param dutch: whether prices fall
        :param on_end: is called with each lot and its sale
        """
        talk.buy(self, service, pays, dutch=dutch, on_end=on_end)

    def propose(self, to: str, service: str, proposal: dict[str, Any], silence: float = 5.0) -> Pending[talk.Result]:
        """Propose to do something (FIPA Propose): ``result = await self.propose("amy", "swap", {"goal": 3})``.

        The result is informed when the proposal was accepted, and refused with the reason when it was rejected.
        """
        return talk.propose(self, to, service, proposal, silence)

    def judge(self, service: str, method: Callable[[talk.Question], object]) -> None:
        """Decide about proposals: the method returns whether it accepts. It may be ``async``, and raise a refusal."""
        talk.judge(self, service, method)

    def follow(
        self,
        to: str,
        service: str,
        question: dict[str, Any],
        on_news: Callable[[dict[str, Any]], object],
        *,
        on_end: Callable[[talk.Result], object] | None = None,
        silence: float = 5.0,
    ) -> Subscription:
        """Want news of one agent (FIPA Subscribe). Each comes once and in order, also when messages get lost.

        For what all may hear, and of what only the newest counts, there are topics: :meth:`subscribe`.

        :param on_news: is called with each, a dict
        :param on_end: is called once when no more will come
        """
        return Subscription(self, talk.follow(self, to, service, question, on_news, on_end=on_end, silence=silence))

    def admit(self, service: str, method: Callable[[talk.Subscriber], object]) -> None:
        """Give news to others: the method is called with each subscriber, whom it tells now or later.

        It raises a refusal for one that gets none.
        """
        talk.admit(self, service, method)

    # For people

    def state(self, words: str) -> None:
        """Says in a few words what it is doing (``hunting prey-1``)."""
        self._link.do("state", str(words))

    def show(self, name: str, value: object) -> None:
        """Show a value; replace what it showed under this name."""
        self._link.do("show", name, str(value))

    def metric(self, name: str, value: float) -> None:
        """Publish a value for the results of the run, where a metric names it as ``metric(name)``."""
        self._link.do("metric", name, float(value))


__all__ = ["Agent", "Blackboard", "Entry", "Message", "Mind", "Note", "Topic", "v"]

"""Blackboards that a team shares. One agent keeps a board as its master; the others write notes, ask and watch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rsal.agents import values as v
from rsal.agents.convert import Decoder, decoder, encode
from rsal.agents.devices import Subscription
from rsal.agents.topics import Topic, topic_content, topic_of
from rsal.agents.waiting import Pending

if TYPE_CHECKING:
    from rsal.agents.agent import Agent

M = TypeVar("M")


@dataclass(frozen=True)
class BoardNote(Generic[M]):
    """A note on a board of a team.

    :param author: name of the agent that wrote it
    :param written: when its author wrote it [s]
    :param fades: when it is forgotten [s]
    :param place: where it is about, in the map frame; ``None`` when it is about no place
    """

    name: str
    content: M
    author: str
    written: float
    fades: float
    place: v.Point2d | None


@dataclass(frozen=True)
class BoardEvent:
    """What becomes of a board.

    :param kind: ``kept`` when there is a master, ``gone`` when it has ended, ``silent`` when nothing is heard of it,
        ``heard`` when it is heard again, ``refused`` when a note or a query was
    :param about: name of the master; of what was refused, the topic and the name
    :param why: in words; empty when there is nothing to say
    """

    kind: str
    about: str
    why: str


@dataclass(frozen=True)
class Found(Generic[M]):
    """What a board knew.

    :param notes: the newest first
    :param left: how many more there are
    :param why: why it is not known; empty when it is
    """

    notes: list[BoardNote[M]]
    left: int
    why: str


_place = decoder(v.Point2d | None)


def _notes(words: Any, arrays: memoryview, decode: Decoder) -> list[BoardNote[Any]]:
    return [
        BoardNote(
            each["name"],
            decode(each["content"], arrays),
            each["author"],
            each["written"],
            each["fades"],
            _place(each["place"], arrays),
        )
        for each in words
    ]


class BoardWatch(Subscription, Generic[M]):
    """What an agent has heard of a part of a board. It can be read without asking."""

    def __init__(self, agent: Agent, number: int) -> None:
        super().__init__(agent, number)
        self._notes: list[BoardNote[M]] = []
        self._current = False

    @property
    def notes(self) -> list[BoardNote[M]]:
        """Notes that have not faded, the newest first."""
        now = self._agent.time
        return [note for note in self._notes if note.fades > now]

    @property
    def current(self) -> bool:
        """Whether the master reported changes when something was heard last."""
        return self._current


class TeamBoard:
    """An agent's end of a board; see :meth:`Agent.team_board`."""

    def __init__(self, agent: Agent, name: str) -> None:
        self._agent = agent
        self.name = name
        self._keeper = ""
        self._listeners: list[Callable[[BoardEvent], object]] = []

        def heard(words: Any, _arrays: memoryview) -> None:
            event = BoardEvent(words["type"].lower(), words.get("keeper", words.get("what", "")), words.get("why", ""))
            if event.kind in ("kept", "gone"):
                self._keeper = event.about if event.kind == "kept" else ""
            for listener in list(self._listeners):
                agent._run(listener, event)

        agent._link.do("board", name, agent._link.listen(heard))

    @property
    def keeper(self) -> str:
        """Name of the master, as far as is known; empty when there is none."""
        return self._keeper

    def on_event(self, listener: Callable[[BoardEvent], object]) -> None:
        """Call a method with what becomes of the board."""
        self._listeners.append(listener)

    def write(
        self,
        topic: type[M] | Topic[M],
        name: str,
        content: M,
        lifetime: float,
        place: v.Point2d | v.Pose2d | None = None,
    ) -> None:
        """Write a note, in place of this agent's one of that name.

        :param lifetime: after which it is forgotten [s]
        :param place: where it is about, in the map frame
        """
        key, words = topic_content(topic, content)
        where = None if place is None else encode(v.Point2d(place.x, place.y))
        self._agent._link.do("writeBoard", self.name, key, name, words, float(lifetime), where)

    def erase(self, topic: type[M] | Topic[M], name: str) -> None:
        """Take back a note of this agent."""
        self._agent._link.do("eraseBoard", self.name, topic_of(topic)[0], name)

    def ask(
        self,
        topic: type[M] | Topic[M],
        *,
        name: str = "",
        author: str = "",
        near: v.Point2d | v.Pose2d | None = None,
        distance: float = 0.0,
        newest: int = 100,
    ) -> Pending[Found[M]]:
        """Ask the master for notes: ``found = await board.ask(Sighting, near=here, distance=5)``."""
        pending: Pending[Found[M]] = Pending(self._agent._run)
        key, kind = topic_of(topic)
        decode = decoder(kind)
        link = self._agent._link

        def heard(words: Any, arrays: memoryview) -> None:
            del link.heard[number]
            content = words["content"]
            notes = _notes(content.get("notes", []), arrays, decode)
            why = "" if words["how"] == "informed" else words["why"] or words["how"]
            pending._end(Found(notes, content.get("left", 0), why))

        number = link.listen(heard)
        link.do("askBoard", self.name, key, _query(name, author, near, distance, newest), number)
        return pending

    def watch(
        self,
        topic: type[M] | Topic[M],
        on_change: Callable[[BoardWatch[M]], object] | None = None,
        *,
        name: str = "",
        author: str = "",
        near: v.Point2d | v.Pose2d | None = None,
        distance: float = 0.0,
        newest: int = 100,
    ) -> BoardWatch[M]:
        """Keep what the master tells of notes, also of the next master.

        :param on_change: called when something was written or erased, at most ten times a second
        :param name: only notes of that name
        :param author: only notes of that agent
        :param near: only notes about places around there, in the map frame
        :param distance: how far from there [m]
        :param newest: how many at most
        """
        key, kind = topic_of(topic)
        decode = decoder(kind)
        link = self._agent._link

        def heard(words: Any, arrays: memoryview) -> None:
            watch._notes = _notes(words["notes"], arrays, decode)
            watch._current = words["current"]
            if on_change is not None:
                self._agent._run(on_change, watch)

        number = link.listen(heard)
        watch: BoardWatch[M] = BoardWatch(self._agent, number)
        link.do("watchBoard", self.name, key, _query(name, author, near, distance, newest), number)
        return watch


def _query(name: str, author: str, near: v.Point2d | v.Pose2d | None, distance: float, newest: int) -> dict[str, Any]:
    place = None if near is None else encode(v.Point2d(near.x, near.y))
    return {"name": name, "author": author, "near": place, "distance": float(distance), "newest": newest}

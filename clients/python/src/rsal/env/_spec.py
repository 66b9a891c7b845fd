"""What an environment is to be."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

Words = dict[str, Any]


class Observe:
    """What learners observe: each of these gives some numbers of an observation."""

    @staticmethod
    def ranges(*, sectors: int = 36, max_range: float = 8.0, device: str = "") -> Words:
        """Observe ranges of a laser or of sonars [m]: of each sector the least one.

        A laser's sectors are from right to left; those of sonars are in the order of the device, which is from left to
        right for a Pioneer's. With fewer beams than sectors, each sector has the beam that is next to its middle.
        Nothing in reach, and no reading, are ``max_range``. ``device`` is the sensor's name; the first one by default.
        """
        return {"type": "ranges", "sectors": sectors, "max": max_range, "device": device}

    @staticmethod
    def pose(*, source: str = "localizer", reach: float = 100.0) -> Words:
        """Observe the position in the map [m], and cosine and sine of the heading.

        ``source`` is the ``localizer`` or the ``truth``. Coordinates beyond ``reach`` count as this one.
        """
        return {"type": "pose", "from": source, "max": reach}

    @staticmethod
    def velocity() -> Words:
        """Observe the measured velocity: forward and left [m/s], counter-clockwise [rad/s]."""
        return {"type": "velocity"}

    @staticmethod
    def nearest(role: str = "", *, count: int = 1, reach: float = 100.0) -> Words:
        """Observe the nearest other robots, by the truth: x and y in the base frame [m], and 1 if there is one.

        Robots that are farther than ``reach`` do not count; walls do not hide robots.
        """
        return {"type": "nearest", "role": role, "count": count, "max": reach}

    @staticmethod
    def place(x: float, y: float, *, source: str = "truth", reach: float = 100.0) -> Words:
        """Observe where a place of the map is: x and y in the base frame [m].

        ``source`` of the robot's pose is the ``localizer`` or the ``truth``.
        """
        return {"type": "place", "x": x, "y": y, "from": source, "max": reach}

    @staticmethod
    def markers(
        *,
        first: int = 0,
        last: int = 1_000_000,
        count: int = 1,
        visited: float = 0.0,
        home: float = 0.0,
        reach: float = 10.0,
    ) -> Words:
        """Observe the nearest markers that the robot sees: x and y in the base frame [m], and 1 if there is one.

        Only ids from ``first`` to ``last`` count. With ``visited``, a marker does not count any more once it has been
        nearer than this; with ``home``, markers that near the robot's start do not count.
        """
        return {
            "type": "markers",
            "first": first,
            "last": last,
            "count": count,
            "visited": visited,
            "home": home,
            "max": reach,
        }

    @staticmethod
    def messages(
        topic: str, fields: Sequence[str], *, source: str = "", newest: int = 1, reach: float = 100.0
    ) -> Words:
        """Observe numbers of the newest messages of a topic that the learner's agent has heard, the newest first.

        ``fields`` name numbers in a message, as ``["map_from_base.x", "map_from_base.y"]`` of the topic ``pose``, or
        keys of dicts. Numbers beyond ``reach`` count as this one, flags as 0 or 1, and what a message leaves out as 0.
        After them come how long ago it was said [s], at most 1000, and 1 if there is such a message.

        ``source`` is the name or role of an agent or of its robot, whose messages alone count. By default all count.
        """
        return {
            "type": "messages",
            "topic": topic,
            "fields": fields if isinstance(fields, str) else " ".join(fields),
            "from": source,
            "newest": newest,
            "max": reach,
        }

    @staticmethod
    def slot(leader: int, slots: str, *, reach: float = 10.0) -> Words:
        """Observe the robot's own slot in a formation: x and y in the base frame [m], and what it sees of the leader.

        ``leader`` is the id of the leader's marker; ``slots`` are in the leader's frame, ``"-1 1; -1 -1"``, the first
        one for the first robot of the role. Then come cosine and sine of the leader's heading, and 1 while it is seen.
        """
        return {"type": "slot", "leader": leader, "slots": slots, "max": reach}

    @staticmethod
    def visited(*, directions: int = 8, distance: float = 1.5, cell: float = 0.75) -> Words:
        """Observe in which directions the robot has been already, by its localizer: 1 for each where it has been."""
        return {"type": "visited", "directions": directions, "distance": distance, "cell": cell}

    @staticmethod
    def home(*, reach: float = 100.0) -> Words:
        """Observe where the robot has started, by its localizer: x and y in the base frame [m]."""
        return {"type": "home", "max": reach}

    @staticmethod
    def gripper() -> Words:
        """Observe whether the gripper holds something: 1 if so."""
        return {"type": "gripper"}

    @staticmethod
    def goal() -> Words:
        """Observe the newest goal of the robot's navigator, which :meth:`Act.goal` or :meth:`Act.place` has set.

        Four numbers, 1 if so: it is under way, it is reached, no path leads there, it was given up. Before the first
        goal, all are 0. A robot gives up a goal that it does not get nearer to for too long.
        """
        return {"type": "goal"}

    @staticmethod
    def idleness(places: str, *, role: str = "", radius: float = 1.0, most: float = 1000.0) -> Words:
        """Observe places by the truth: x and y in the base frame [m], and for how many steps nobody was there.

        ``places`` are in the map, ``"2 3; 4 -1"``; ``role`` is that of the robots that visit them.
        """
        return {"type": "idleness", "places": places, "role": role, "radius": radius, "max": most}


class Act:
    """How learners act: one of these."""

    @staticmethod
    def velocity(*, forward: float = 0.5, backward: float = 0.0, turn: float = 1.5) -> Words:
        """Drive at a velocity: forward [m/s] and turn [rad/s], with these limits."""
        return {"type": "velocity", "forward": forward, "backward": backward, "turn": turn}

    @staticmethod
    def discrete(*, speed: float = 0.4, turn: float = 1.0) -> Words:
        """Choose: stand (0), forward (1), turn left (2), turn right (3), backward (4); speed [m/s] and turn [rad/s].

        Other numbers are an error.
        """
        return {"type": "discrete", "speed": speed, "turn": turn}

    @staticmethod
    def goal(*, reach: float = 3.0) -> Words:
        """Send the robot's navigator to a position in the base frame [m], at most ``reach`` along each axis.

        :meth:`Observe.goal` tells what becomes of it.
        """
        return {"type": "goal", "reach": reach}

    @staticmethod
    def carry(*, forward: float = 0.5, backward: float = 0.2, turn: float = 1.5) -> Words:
        """Drive at a velocity, and open the gripper if the third number is at least 0.5 and it holds something."""
        return {"type": "carry", "forward": forward, "backward": backward, "turn": turn}

    @staticmethod
    def place(places: str) -> Words:
        """Send the robot's navigator to one of some places of the map, ``"2 3; 4 -1"``.

        :meth:`Observe.goal` tells what becomes of it.
        """
        return {"type": "place", "places": places}


def _words(given: str | Mapping[str, Any]) -> Words:
    return {"type": given} if isinstance(given, str) else {name: _plain(value) for name, value in given.items()}


def _plain(value: Any) -> Any:
    """Return numbers and arrays of numpy as those of Python."""
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else value


@dataclass(frozen=True)
class Spec:
    """What all episodes of an environment have in common."""

    scenario: str
    """Name or file, with a configuration: ``hunt-and-prey:advanced``."""
    learners: str
    """The role of the robots that learn."""
    observe: tuple[Words, ...]
    act: Words
    steps: int
    """Steps of the scenario in a step of the environment."""
    arguments: Words = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        *,
        scenario: str | Path,
        configuration: str | None = None,
        learners: str,
        observe: Sequence[str | Mapping[str, Any]] | None,
        act: str | Mapping[str, Any] | None,
        steps: int,
        arguments: Mapping[str, Any] | None,
    ) -> Spec:
        """Fill in what was left out: ranges and velocity are observed, and actions are velocities."""
        seen = [Observe.ranges(), Observe.velocity()] if observe is None else observe
        return cls(
            scenario=f"{scenario}:{configuration}" if configuration else str(scenario),
            learners=learners,
            observe=tuple(_words(each) for each in seen),
            act=_words(Act.velocity() if act is None else act),
            steps=_plain(steps),
            arguments=dict(arguments or {}),
        )

    def opening(self, seeds: Sequence[int], threads: int) -> Words:
        """Return the words that open the worlds."""
        name, _, configuration = self.scenario.partition(":")
        if len(name) == 1 and configuration[:1] in ("/", "\\"):  # a drive of Windows
            drive, rest = self.scenario[:2], self.scenario[2:]
            name, _, configuration = rest.partition(":")
            name = drive + name
        return {
            "request": "open",
            "scenario": name,
            "configuration": configuration,
            "arguments": {key: _text(value) for key, value in self.arguments.items()},
            "learners": self.learners,
            "observe": list(self.observe),
            "act": self.act,
            "steps": self.steps,
            "seeds": list(seeds),
            "threads": threads,
        }


def _text(given: object) -> str:
    value = _plain(given)
    return str(value).lower() if isinstance(value, bool) else str(value)

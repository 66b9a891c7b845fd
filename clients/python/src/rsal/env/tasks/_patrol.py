"""Robots visit places again and again."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import Rules, View
from rsal.env.tasks._scripted import patrol
from rsal.env.tasks._task import Task

PLACES = "-4.5 -3.5; -1.5 -1.5; -4.5 3.5; -1.5 1.5; 4.5 3.5; 1.5 1.5; 4.5 -3.5; 1.5 -1.5"
_NEAR = 1.0  # m


class _Visiting(Rules):
    """Costs the team the mean idleness of all places, in minutes, in each step."""

    def __init__(self) -> None:
        self._places = np.array([[float(n) for n in place.split()] for place in PLACES.split(";")])
        self._visited: dict[int, npt.NDArray[np.float64]] = {}
        self._means: dict[int, list[float]] = {}

    def __call__(self, view: View) -> npt.ArrayLike:
        if view.is_first:
            self._visited[view.world] = np.zeros(len(self._places))
            self._means[view.world] = []
        robots = view.poses("robot")[:, :2].astype(float)
        near = (np.hypot(*(robots[:, None] - self._places[None]).transpose(2, 0, 1)) <= _NEAR).any(0)
        self._visited[view.world][near] = view.time
        mean = float((view.time - self._visited[view.world]).mean())
        self._means[view.world].append(mean)
        return np.full(len(robots), -mean / 60.0)

    def score(self, world: int, ending: dict[str, Any]) -> float:  # noqa: ARG002 - of the interface
        return float(np.mean(self._means[world]))


PATROL = Task(
    name="Patrol",
    title="Visit eight places in four rooms with two robots, so that none is without a visit for long",
    scenario="patrol.yaml:learn",
    learners="robot",
    observe=(
        Observe.idleness(PLACES, role="robot"),
        Observe.nearest("robot"),
    ),
    act=Act.place(PLACES),
    rules=_Visiting,
    score="mean time for which nobody was at a place [s], over 180 s",
    better="less",
    max_steps=90,
    steps=20,
    scripted={"learn": "scripted"},
    by_hand=patrol,
)

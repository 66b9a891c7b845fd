"""Robots bring cans home."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import Rules, View
from rsal.env.tasks._scripted import foraging
from rsal.env.tasks._task import Task

_HOMES = np.array([[2.0, 5.0], [10.0, 5.0]])


class _Bringing(Rules):
    """Pays 10 for each can that was brought home, 1 for taking one, and meters on the way home with it."""

    def __init__(self) -> None:
        self._held: dict[int, npt.NDArray[np.bool_]] = {}
        self._before: dict[int, npt.NDArray[np.float64]] = {}

    def __call__(self, view: View) -> npt.ArrayLike:
        position = view.poses("robot")[:, :2].astype(float)
        distance = np.hypot(*(position - _HOMES).T)
        if not view.layout.learners:
            return np.zeros(len(position))
        held = view.observations[:, -1] > 0
        before = np.zeros(len(held), bool) if view.is_first else self._held[view.world]
        far = distance if view.is_first else self._before[view.world]
        self._held[view.world], self._before[view.world] = held, distance
        taken = held & ~before & (distance > 1.2)  # noqa: PLR2004 - not one that is at home
        home = before & ~held & (distance < 1.0)
        lost = before & ~held & (distance >= 1.2)  # noqa: PLR2004
        way = np.where(held & before, far - distance, 0.0)
        rewards: npt.ArrayLike = 10.0 * home + 1.0 * taken - 1.0 * lost + way - 0.2 * view.collisions
        return rewards

    def score(self, world: int, ending: dict[str, Any]) -> float:  # noqa: ARG002 - of the interface
        return float(ending["metrics"].get("collected", 0.0))


FORAGING = Task(
    name="Foraging",
    title="Find cans by their markers, take them with the gripper, and bring them home",
    scenario="foraging.yaml:learn",
    learners="robot",
    observe=(
        Observe.ranges(sectors=12, max_range=5.0),
        Observe.velocity(),
        Observe.markers(first=11, last=18, home=1.2),
        Observe.home(),
        Observe.gripper(),
    ),
    act=Act.carry(),
    rules=_Bringing,
    score="cans at home after 120 s, of 8",
    better="more",
    max_steps=600,
    by_hand=foraging,
)

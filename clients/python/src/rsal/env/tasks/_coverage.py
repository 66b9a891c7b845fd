"""Robots drive over as much of the floor as they can."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import Rules, View
from rsal.env.tasks._scripted import coverage
from rsal.env.tasks._task import Task

_CELL = 0.25  # m
_NEAR = 0.5  # m


class _Covering(Rules):
    """Pays each robot for the share of the floor [%] that it covers first; touching something costs 0.2."""

    def __init__(self) -> None:
        self._centers: npt.NDArray[np.float64] | None = None
        self._covered: dict[int, npt.NDArray[np.bool_]] = {}

    def _floor(self, view: View) -> npt.NDArray[np.float64]:
        """Return the centers of the parts of the floor that are free."""
        if self._centers is None:
            cells, resolution, (left, low) = view.floor()
            every = max(1, round(_CELL / resolution))
            rows, columns = np.nonzero(cells[every // 2 :: every, every // 2 :: every] == 0)
            shift = (every // 2 + 0.5) * resolution
            self._centers = np.stack([left + columns * every * resolution, low + rows * every * resolution], 1) + shift
        return self._centers

    def __call__(self, view: View) -> npt.ArrayLike:
        centers = self._floor(view)
        if view.is_first:
            self._covered[view.world] = np.zeros(len(centers), bool)
        covered = self._covered[view.world]
        rewards = []
        for x, y in view.poses("robot")[:, :2]:
            new = ~covered & (np.abs(centers[:, 0] - x) < _NEAR) & (np.abs(centers[:, 1] - y) < _NEAR)
            new &= np.hypot(centers[:, 0] - x, centers[:, 1] - y) < _NEAR
            covered |= new
            rewards.append(100.0 * new.sum() / len(centers))
        touched = view.collisions if view.layout.learners else np.zeros(len(rewards))
        paid: npt.ArrayLike = np.array(rewards) - 0.2 * touched
        return paid

    def score(self, world: int, ending: dict[str, Any]) -> float:  # noqa: ARG002 - of the interface
        return float(100.0 * self._covered[world].mean())


COVERAGE = Task(
    name="Coverage",
    title="Drive over as much of the floor of four rooms as three robots can in two minutes",
    scenario="coverage.yaml:learn",
    learners="robot",
    observe=(
        Observe.ranges(sectors=12, max_range=5.0),
        Observe.velocity(),
        Observe.visited(),
    ),
    act=Act.velocity(forward=0.5, turn=1.5),
    rules=_Covering,
    score="share of the floor that is covered after 120 s [%]",
    better="more",
    max_steps=600,
    scripted={"learn": "scripted", "wander": "wander"},
    by_hand=coverage,
)

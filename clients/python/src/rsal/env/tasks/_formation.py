"""Robots keep their slots beside a leader."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import Rules, View
from rsal.env.tasks._scripted import formation
from rsal.env.tasks._task import Task

SLOTS = "-1.3 0; -1.3 -1.3; 0 -1.3"
_FAR = 3.0  # m, beyond which an error counts as this
_BEGIN = 20.0  # s, after which errors count for the score


class _Keeping(Rules):
    """Costs each robot its distance from its slot [m] in each second; touching something costs 0.5."""

    def __init__(self) -> None:
        self._slots = np.array([[float(n) for n in slot.split()] for slot in SLOTS.split(";")])
        self._errors: dict[int, list[float]] = {}

    def __call__(self, view: View) -> npt.ArrayLike:
        if view.is_first:
            self._errors[view.world] = []
        x, y, theta = view.poses("leader")[0].astype(float)
        cosine, sine = np.cos(theta), np.sin(theta)
        wanted = np.array([x, y]) + self._slots @ np.array([[cosine, sine], [-sine, cosine]])
        error = np.minimum(np.hypot(*(view.poses("follower")[:, :2] - wanted).T), _FAR)
        if view.time >= _BEGIN:
            self._errors[view.world].append(float((error**2).mean()))
        rewards: npt.ArrayLike = -error * view.layout.period - 0.5 * view.collisions
        return rewards

    def score(self, world: int, ending: dict[str, Any]) -> float:  # noqa: ARG002 - of the interface
        return float(np.sqrt(np.mean(self._errors[world]))) if self._errors[world] else _FAR


FORMATION = Task(
    name="Formation",
    title="Keep three slots behind and beside a leader that follows the wall",
    scenario="formation.yaml:hall",
    learners="follower",
    observe=(
        Observe.ranges(sectors=12, max_range=5.0),
        Observe.velocity(),
        Observe.slot(1, SLOTS),
    ),
    act=Act.velocity(forward=0.7, turn=1.5),
    rules=_Keeping,
    score=f"root of the mean squared distance from the slots [m], after the first {_BEGIN:.0f} s",
    better="less",
    max_steps=300,
    held_out=("ring",),
    by_hand=formation,
)

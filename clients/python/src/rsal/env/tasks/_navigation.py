"""A robot crosses a dense field of posts."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import View
from rsal.env.tasks._rules import Approach
from rsal.env.tasks._scripted import navigation
from rsal.env.tasks._task import Task

_GOAL = (13.0, 3.0)
_LIMIT = 90.0


class _Crossing(Approach):
    def distances(self, view: View) -> npt.NDArray[np.float64]:
        distances: npt.NDArray[np.float64] = np.hypot(*(view.poses("robot")[:, :2].astype(float) - _GOAL).T)
        return distances


NAVIGATION = Task(
    name="Navigation",
    title="Cross a dense field of posts that is on no map, without a collision",
    scenario="navigation.yaml:learn",
    learners="robot",
    observe=(
        Observe.ranges(sectors=24, max_range=5.0),
        Observe.velocity(),
        Observe.place(*_GOAL, source="localizer", reach=14.0),
    ),
    act=Act.velocity(forward=0.5, turn=1.5),
    rules=lambda: _Crossing(_LIMIT, failure=3.0),
    score=f"time until the goal [s]; {_LIMIT:.0f} after a collision",
    better="less",
    max_steps=450,
    scripted={"learn": "scripted"},
    by_hand=navigation,
)

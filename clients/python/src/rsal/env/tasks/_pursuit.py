"""Two hunters catch a prey that flees."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Act, Observe
from rsal.env._view import View
from rsal.env.tasks._rules import Approach
from rsal.env.tasks._scripted import pursuit
from rsal.env.tasks._task import Task

_LIMIT = 60.0


class _Chase(Approach):
    """The team is paid for the nearer hunter, so that the other one is free to cut off the way."""

    def distances(self, view: View) -> npt.NDArray[np.float64]:
        prey = view.poses("prey")[0, :2].astype(float)
        each = np.hypot(*(view.poses("hunter")[:, :2].astype(float) - prey).T)
        return np.full(len(each), 0.5 * each.min() + 0.5 * each.mean())


PURSUIT = Task(
    name="Pursuit",
    title="Catch a prey that flees, with two hunters that see it where no wall hides it",
    scenario="pursuit.yaml:columns",
    learners="hunter",
    observe=(
        Observe.ranges(sectors=12, max_range=5.0),
        Observe.velocity(),
        Observe.markers(first=11, last=11),
        Observe.markers(first=101, last=102),
    ),
    act=Act.velocity(forward=0.5, turn=1.5),
    rules=lambda: _Chase(_LIMIT, collision=0.2),
    score=f"time until the capture [s]; {_LIMIT:.0f} without one",
    better="less",
    max_steps=300,
    held_out=("ring",),
    scripted={"columns": "columns-scripted", "walls": "walls-scripted", "ring": "ring-scripted"},
    by_hand=pursuit,
)

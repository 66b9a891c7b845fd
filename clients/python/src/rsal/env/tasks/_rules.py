"""Rewards and scores that several tasks have."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._view import Rules, View


class Approach(Rules):
    """Rewards getting nearer [m] to a goal that moves or stands, and scores the time until the scenario's success."""

    def __init__(self, limit: float, success: float = 10.0, failure: float = 10.0, collision: float = 0.0) -> None:
        self._limit = limit
        self._success = success
        self._failure = failure
        self._collision = collision
        self._before: dict[int, npt.NDArray[np.float64]] = {}

    def distances(self, view: View) -> npt.NDArray[np.float64]:
        """Return how far each learner is from its goal [m]."""
        raise NotImplementedError

    def __call__(self, view: View) -> npt.ArrayLike:
        """Return meters of approach, and what success, failure and collisions give and cost."""
        now = self.distances(view)
        before = now if view.is_first else self._before[view.world]
        self._before[view.world] = now
        end = {"success": self._success, "failure": -self._failure}.get(view.outcome, 0.0)
        reward = before - now + end
        return reward - self._collision * view.collisions if view.layout.learners else reward

    def score(self, world: int, ending: dict[str, Any]) -> float:  # noqa: ARG002 - of the interface
        """Return the time until success [s]; the limit for all other ends."""
        return float(min(ending["seconds"], self._limit)) if ending["outcome"] == "success" else self._limit

"""What a reward can look at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._worlds import Floats, Integers, Layout
from rsal.launch import RsalError


@dataclass(frozen=True)
class Before:
    """What was known of all worlds before a step."""

    observations: Floats
    poses: Floats
    collisions: Integers


@dataclass(frozen=True)
class View:
    """One world after a step, by the truth of the simulation. Arrays are valid during the call only."""

    layout: Layout
    """What the numbers mean. Rewards are in the order of ``layout.learners``."""
    world: int
    """The number of the world, for rewards that remember something of each."""
    observations: Floats
    """By learner, then by number."""
    actions: Floats
    """By learner, then by number."""
    all_poses: Floats
    """Of all robots: x, y [m] and heading [rad] in the map."""
    all_collisions: Integers
    """How often each robot has touched something in this episode."""
    new_collisions: Integers
    """The same in this step."""
    time: float
    """Simulated time since the first observation [s]."""
    outcome: str
    """How the scenario ended the episode; empty while it goes on."""
    metrics: Callable[[], dict[str, float]] = field(repr=False)
    """Asks for the metrics of the scenario as they are now, which takes some time."""
    floor: Callable[[], tuple[npt.NDArray[np.int8], float, tuple[float, float]]] = field(repr=False)
    """Asks for the map: its cells by rows from below, the side of a cell [m], and the lower left corner [m]."""

    past: Before = field(repr=False)
    """What was known of all worlds before the step: :attr:`before` is made of it."""

    @property
    def before(self) -> View:
        """The same world before the step, for rewards of progress. It has no actions, and its metrics are not known."""
        return View(
            layout=self.layout,
            world=self.world,
            observations=self.past.observations[self.world],
            actions=np.zeros_like(self.actions),
            all_poses=self.past.poses[self.world],
            all_collisions=self.past.collisions[self.world],
            new_collisions=np.zeros_like(self.new_collisions),
            time=self.time - self.layout.period,
            outcome="",
            metrics=_unknown,
            floor=self.floor,
            past=self.past,
        )

    @property
    def is_first(self) -> bool:
        """Whether this is the first step of its episode."""
        return self.time <= 1.5 * self.layout.period

    def robots(self, role: str) -> npt.NDArray[np.intp]:
        """Return the numbers of the robots with a role."""
        return np.array([i for i, each in enumerate(self.layout.robots.values()) if each == role], np.intp)

    def poses(self, role: str) -> Floats:
        """Return the poses of the robots with a role: x, y [m] and heading [rad] in the map."""
        poses: Floats = self.all_poses[self.robots(role)]
        return poses

    @property
    def learners(self) -> npt.NDArray[np.intp]:
        """The numbers of the learners among all robots."""
        ids = list(self.layout.robots)
        return np.array([ids.index(learner) for learner in self.layout.learners], np.intp)

    @property
    def collisions(self) -> Integers:
        """How often each learner has touched something in this step."""
        touched: Integers = self.new_collisions[self.learners]
        return touched


def _unknown() -> dict[str, float]:
    raise RsalError("Metrics are known of the newest step only. Use view.metrics(), not view.before.metrics().")


Reward = Callable[[View], "npt.ArrayLike"]
"""Gives the reward of each learner after a step, or one number for all of them."""

Leave = Callable[[View], "npt.ArrayLike"]
"""Says of each learner whether it leaves its episode after a step."""


class Rules:
    """A reward that also scores whole episodes: each end of an episode then has a ``score``."""

    def __call__(self, view: View) -> npt.ArrayLike:
        """Return the reward of each learner after a step, or one number for all of them."""
        raise NotImplementedError

    def score(self, world: int, ending: dict[str, Any]) -> float:
        """Return the score of the episode that has just ended in a world.

        :param ending: its outcome, seconds, metrics, event hash and failed agents
        """
        raise NotImplementedError

"""Episodes of several worlds: rewards, ends and seeds, which all kinds of environments share."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Spec
from rsal.env._view import Reward, View
from rsal.env._worlds import Floats, Integers, Layout, Worlds
from rsal.launch import RsalError

_TIMEOUT = "timeout"
_SEEDS = 2**31


@dataclass(frozen=True)
class Step:
    """What a step gave, by world."""

    observations: Floats
    rewards: Floats
    """By world and learner."""
    terminated: npt.NDArray[np.bool_]
    truncated: npt.NDArray[np.bool_]
    endings: dict[int, dict[str, Any]]
    """Outcome, seconds, metrics and event hash of the episodes that have ended."""


class Episodes:
    """Worlds with rewards. Their process starts when it is needed first, in the process that needs it."""

    def __init__(
        self, spec: Spec, count: int, threads: int | None, reward: Reward | str | None, max_steps: int | None
    ) -> None:
        if max_steps is not None and max_steps < 1:
            raise RsalError(f"max_steps must be at least 1, not '{max_steps}'.")
        self.spec = spec
        self.count = count
        self._threads = threads or min(count, os.cpu_count() or 1)
        self._reward = reward
        self._max_steps = max_steps
        self._worlds: Worlds | None = None
        self._random = np.random.default_rng()
        self._steps = np.zeros(count, np.int64)
        self._collisions: Integers = np.zeros((count, 0), np.int32)  # after the last step or reset
        self._measured: list[float] = [0.0] * count

    @property
    def worlds(self) -> Worlds:
        """The process, which is started if it was not."""
        if self._worlds is None:
            self._worlds = Worlds(self.spec, self._draw(self.count), self._threads)
            self._begun(range(self.count))
        return self._worlds

    @property
    def layout(self) -> Layout:
        """What the numbers mean."""
        return self.worlds.layout

    def _draw(self, count: int) -> list[int]:
        return [int(seed) for seed in self._random.integers(_SEEDS, size=count)]

    def reset(self, seeds: list[int] | None = None) -> Floats:
        """Begin a new episode in each world; without seeds, with the next ones of the generator."""
        if seeds is not None:
            self._random = np.random.default_rng(seeds)
            first: list[int] = [int(seed) for seed in seeds]
        else:
            first = self._draw(self.count)
        if self._worlds is None:
            self._worlds = Worlds(self.spec, first, self._threads)
        else:
            self._worlds.reset(range(self.count), first)
        self._begun(range(self.count))
        return self._worlds.observations

    def restart(self, which: list[int]) -> Floats:
        """Begin a new episode in some worlds, with the next seeds of the generator."""
        self.worlds.reset(which, self._draw(len(which)))
        self._begun(which)
        return self.worlds.observations

    def _begun(self, which: range | list[int]) -> None:
        self._collisions = self.worlds.collisions.copy()
        for world in which:
            self._steps[world] = 0
            self._measured[world] = 0.0

    def step(self, actions: npt.ArrayLike) -> Step:
        """Act in all worlds."""
        worlds = self.worlds
        given = np.asarray(actions, np.float32)
        over = worlds.step(given)
        self._steps += 1
        rewards = self._rewards(given, over)
        terminated = np.zeros(self.count, bool)
        truncated = np.zeros(self.count, bool) if self._max_steps is None else self._steps >= self._max_steps
        for world, outcome in over.items():
            terminated[world] = outcome != _TIMEOUT
            truncated[world] = outcome == _TIMEOUT
        endings: dict[int, dict[str, Any]] = {}
        if over or self._max_steps is not None:
            endings = {int(world): worlds.finish(int(world)) for world in np.flatnonzero(terminated | truncated)}
        return Step(worlds.observations, rewards, terminated, truncated, endings)

    def _rewards(self, given: Floats, over: dict[int, str]) -> Floats:
        worlds = self.worlds
        layout = worlds.layout
        rewards = np.zeros((self.count, len(layout.learners)), np.float32)
        if isinstance(self._reward, str):
            for world, metrics in enumerate(worlds.metrics()):
                value = metrics.get(self._reward, self._measured[world])
                rewards[world] = value - self._measured[world]
                self._measured[world] = value
        elif self._reward is not None:
            actions = given.reshape(self.count, len(layout.learners), -1)
            new = worlds.collisions - self._collisions
            self._collisions = worlds.collisions.copy()
            for world in range(self.count):
                rewards[world] = self._reward(
                    View(
                        layout=layout,
                        observations=worlds.observations[world],
                        actions=actions[world],
                        all_poses=worlds.poses[world],
                        all_collisions=worlds.collisions[world],
                        new_collisions=new[world],
                        time=float(self._steps[world]) * layout.period,
                        outcome=over.get(world, ""),
                        metrics=lambda world=world: worlds.metrics()[world],  # type: ignore[misc]
                    )
                )
        return rewards

    def close(self) -> None:
        """End the process; the next reset starts another one."""
        if self._worlds is not None:
            self._worlds.close()
            self._worlds = None

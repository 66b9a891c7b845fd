"""Episodes of several worlds: rewards, ends and seeds, which all kinds of environments share."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
import numpy.typing as npt

from rsal.env._spec import Spec
from rsal.env._view import Before, Leave, Reward, Rules, View
from rsal.env._worlds import Floats, Layout, Worlds
from rsal.launch import RsalError

_TIMEOUT = "timeout"
_SEEDS = 2**31
_CLOSED = "The environment is closed. Call reset() to begin again."


@dataclass(frozen=True)
class Step:
    """What a step gave, by world."""

    observations: Floats
    rewards: Floats
    """By world and learner."""
    leaving: npt.NDArray[np.bool_]
    """By world and learner: whether it leaves before the others."""
    terminated: npt.NDArray[np.bool_]
    truncated: npt.NDArray[np.bool_]
    endings: dict[int, dict[str, Any]]
    """Outcome, seconds, metrics, event hash and failed agents of the episodes that have ended."""


class Episodes:
    """Worlds with rewards. Their process starts when it is needed first, in the process that needs it."""

    def __init__(
        self,
        spec: Spec,
        count: int,
        threads: int | None,
        reward: Reward | str | None,
        max_steps: int | None,
        *,
        leave: Leave | None = None,
    ) -> None:
        self.spec = spec
        self.count = whole("num_envs", count)
        self._threads = min(self.count, os.cpu_count() or 1) if threads is None else whole("threads", threads)
        self._reward = reward
        self._leave = leave
        self._max_steps = None if max_steps is None else whole("max_steps", max_steps)
        self._worlds: Worlds | None = None
        self._layout: Layout | None = None
        self._closed = False
        self._begun = False
        self._random = [np.random.default_rng() for _ in range(self.count)]
        self._steps = np.zeros(self.count, np.int64)
        self._before: Before | None = None
        self._measured: list[float | None] = [None] * self.count
        self._over = np.zeros(self.count, bool)
        self._terminated = np.zeros(self.count, bool)  # in the last step
        self._map: tuple[npt.NDArray[np.int8], float, tuple[float, float]] | None = None

    @property
    def worlds(self) -> Worlds:
        """The process, which is started if it was not."""
        if self._closed:
            raise RsalError(_CLOSED)
        return self._worlds or self._start([self._draw(world) for world in range(self.count)])

    def _start(self, seeds: list[int]) -> Worlds:
        worlds = Worlds(self.spec, seeds, self._threads)
        try:
            if isinstance(self._reward, str) and self._reward not in worlds.layout.metrics:
                raise RsalError(
                    f"The scenario has no metric '{self._reward}' for a reward. "
                    f"It has: {', '.join(worlds.layout.metrics) or '(none)'}."
                )
            self._worlds, self._layout, self._closed = worlds, worlds.layout, False
            self._begin(range(self.count))
        except BaseException:
            self._worlds = None
            worlds.close()
            raise
        return worlds

    @property
    def layout(self) -> Layout:
        """What the numbers mean. It starts the process if nothing did, and stays known when that has ended."""
        return self._layout or self.worlds.layout

    def _draw(self, world: int) -> int:
        return int(self._random[world].integers(_SEEDS))

    def reset(self, seeds: Sequence[int] | None = None) -> Floats:
        """Begin a new episode in each world; without seeds, with the next one of each world's generator."""
        if seeds is not None:
            first = self._checked(seeds)
            self._random = [np.random.default_rng(seed) for seed in first]
        else:
            first = [self._draw(world) for world in range(self.count)]
        if self._worlds is not None and self._worlds.is_broken:
            self._worlds.close()
            self._worlds = None
        if self._worlds is None:
            worlds = self._start(first)
        else:
            worlds = self._worlds
            worlds.reset(range(self.count), first)
            self._begin(range(self.count))
        self._begun = True
        return worlds.observations

    def _checked(self, seeds: Sequence[int]) -> list[int]:
        if len(seeds) != self.count:
            raise RsalError(f"There are {len(seeds)} seeds for {self.count} worlds: each world needs one.")
        for seed in seeds:
            if not isinstance(seed, int | np.integer) or seed < 0:
                raise RsalError(f"A seed must be a whole number from 0 on, not '{seed}'.")
        return [int(seed) for seed in seeds]

    def restart(self, which: list[int]) -> Floats:
        """Begin a new episode in some worlds, with the next seed of each world's generator."""
        self.worlds.reset(which, [self._draw(world) for world in which])
        self._begin(which)
        return self.worlds.observations

    def _begin(self, which: Sequence[int]) -> None:
        self._look()
        measured = self.worlds.metrics() if isinstance(self._reward, str) else None
        for world in which:
            self._steps[world] = 0
            self._over[world] = False
            self._measured[world] = measured[world].get(str(self._reward)) if measured else None

    def step(self, actions: npt.ArrayLike, *, ended_too: bool = False) -> Step:
        """Act in all worlds that are not over.

        :param ended_too: whether it is no error when all of them are over
        """
        self.require_running(ended_too=ended_too)
        worlds = self.worlds
        given = np.asarray(actions, np.float32)
        over = worlds.step(given)
        running = ~self._over
        self._steps += running
        rewards = self._rewards(given, over)
        leaving = self._leaving(given, over)
        self._look()
        terminated = np.zeros(self.count, bool)
        truncated = np.zeros(self.count, bool) if self._max_steps is None else self._steps >= self._max_steps
        for world, outcome in over.items():
            terminated[world] = outcome != _TIMEOUT
            truncated[world] = outcome == _TIMEOUT
        if not running.all():  # those that have ended before did so as they did then
            terminated = np.where(running, terminated, self._terminated)
            truncated = np.where(running, truncated, ~self._terminated)
        self._terminated = terminated
        endings: dict[int, dict[str, Any]] = {}
        if over or self._max_steps is not None:
            ended = np.flatnonzero((terminated | truncated) & running)
            endings = {int(world): worlds.finish(int(world)) for world in ended}
        for world, ending in endings.items():
            if isinstance(self._reward, Rules):
                ending["score"] = self._reward.score(world, ending)
            for agent, why in ending["failed"].items():
                warnings.warn(
                    f"Agent '{agent}' failed in an episode of '{self.spec.scenario}': {why}", RuntimeWarning, 4
                )
        self._over |= terminated | truncated
        return Step(worlds.observations, rewards, leaving, terminated.copy(), truncated, endings)

    def _look(self) -> None:
        """Remember what a reward may compare with, as the next step writes into the same arrays."""
        if callable(self._reward) or self._leave is not None:
            worlds = self.worlds
            self._before = Before(worlds.observations.copy(), worlds.poses.copy(), worlds.collisions.copy())

    def require_running(self, *, ended_too: bool = False) -> None:
        """Check that a step can be made.

        :raises RsalError: when the environment is closed, or has no episode that goes on
        """
        if self._closed:
            raise RsalError(_CLOSED)
        if not self._begun:
            raise RsalError("No episode has begun. Call reset() first.")
        if self._over.all() and not ended_too:
            raise RsalError("The episode is over. Call reset() first.")

    def _rewards(self, given: Floats, over: dict[int, str]) -> Floats:
        worlds = self.worlds
        layout = worlds.layout
        rewards = np.zeros((self.count, len(layout.learners)), np.float32)
        if isinstance(self._reward, str):
            for world, metrics in enumerate(worlds.metrics()):
                value = metrics.get(self._reward)
                if self._over[world] or value is None:
                    continue
                known = self._measured[world]
                rewards[world] = 0 if known is None else value - known
                self._measured[world] = value
        elif self._reward is not None:
            for world in map(int, np.flatnonzero(~self._over)):
                reward = self._reward(self._view(world, given, over))
                if layout.learners:  # without any, only scores are asked for
                    rewards[world] = reward
        return rewards

    def _leaving(self, given: Floats, over: dict[int, str]) -> npt.NDArray[np.bool_]:
        leaving = np.zeros((self.count, len(self.worlds.layout.learners)), bool)
        if self._leave is not None:
            for world in map(int, np.flatnonzero(~self._over)):
                leaving[world] = self._leave(self._view(world, given, over))
        return leaving

    def _view(self, world: int, given: Floats, over: dict[int, str]) -> View:
        worlds = self.worlds
        layout = worlds.layout
        before = cast(Before, self._before)
        return View(
            layout=layout,
            world=world,
            observations=worlds.observations[world],
            actions=given.reshape(self.count, len(layout.learners), len(layout.action_fields))[world],
            all_poses=worlds.poses[world],
            all_collisions=worlds.collisions[world],
            new_collisions=worlds.collisions[world] - before.collisions[world],
            time=float(self._steps[world]) * layout.period,
            outcome=over.get(world, ""),
            metrics=lambda: worlds.metrics()[world],
            floor=self._floor,
            past=before,
        )

    def _floor(self) -> tuple[npt.NDArray[np.int8], float, tuple[float, float]]:
        if self._map is None:
            self._map = self.worlds.map()
        return self._map

    def close(self) -> None:
        """End the process; the next reset starts another one."""
        self._closed = True
        self._begun = False
        if self._worlds is not None:
            self._worlds.close()
            self._worlds = None


def whole(name: str, value: int) -> int:
    """Return a number of things, of Python or numpy, from 1 on."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < 1:
        raise RsalError(f"{name} must be a whole number of at least 1, not '{value}'.")
    return int(value)

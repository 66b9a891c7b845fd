"""Many worlds of a scenario at once, in one process and in one array."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._episodes import Episodes
from rsal.env._spec import Spec
from rsal.env._view import Reward
from rsal.env._worlds import Floats, Layout


class VectorScenario:
    """Worlds that step together. A world whose episode has ended begins another one in the next step.

    That step gives its first observations and no reward, whatever its action is: ``AutoresetMode.NEXT_STEP`` of
    Gymnasium. Without ``autoreset``, such a world gives no reward and stays over until the next reset.
    """

    def __init__(
        self,
        spec: Spec,
        num_envs: int,
        *,
        threads: int | None = None,
        reward: Reward | str | None = None,
        max_steps: int | None = None,
        autoreset: bool = True,
    ) -> None:
        self.num_envs = num_envs
        self._autoreset = autoreset
        self._episodes = Episodes(spec, num_envs, threads, reward, max_steps)
        self._ended = np.zeros(num_envs, bool)

    @property
    def layout(self) -> Layout:
        """What the numbers mean."""
        return self._episodes.layout

    @property
    def observation_shape(self) -> tuple[int, int, int]:
        """Worlds, learners, numbers of an observation."""
        return self.num_envs, len(self.layout.learners), len(self.layout.fields)

    @property
    def action_shape(self) -> tuple[int, int, int]:
        """Worlds, learners, numbers of an action."""
        return self.num_envs, len(self.layout.learners), len(self.layout.action_fields)

    def reset(self, *, seed: int | Sequence[int] | None = None) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode in each world: of one seed, the worlds have this one and those after it."""
        seeds = None
        if isinstance(seed, int | np.integer):
            seeds = [int(seed) + world for world in range(self.num_envs)]
        elif seed is not None:
            seeds = [int(each) for each in seed]
        self._ended[:] = False
        return self._episodes.reset(seeds).copy(), {}

    def step(
        self, actions: npt.ArrayLike
    ) -> tuple[Floats, Floats, npt.NDArray[np.bool_], npt.NDArray[np.bool_], dict[str, Any]]:
        """Act in all worlds.

        Observations are by world, learner and number; rewards by world and learner; ends by world. The infos have
        ``episodes``: outcome, seconds, metrics and event hash of those that have ended, by world.
        """
        before = self._ended
        done = self._episodes.step(actions)
        observations, rewards = done.observations, done.rewards
        terminated, truncated, endings = done.terminated, done.truncated, done.endings
        again = [int(world) for world in np.flatnonzero(before)] if self._autoreset else []
        if again:
            observations = self._episodes.restart(again)
            rewards[again] = 0
            terminated[again] = truncated[again] = False
            endings = {world: ending for world, ending in endings.items() if world not in again}
        self._ended = terminated | truncated
        return observations.copy(), rewards, terminated, truncated, {"episodes": endings} if endings else {}

    def close(self) -> None:
        """End the process that simulates."""
        self._episodes.close()


def make_vec(
    scenario: str,
    *,
    num_envs: int,
    learners: str,
    observe: Sequence[str | Mapping[str, Any]] | None = None,
    act: str | Mapping[str, Any] | None = None,
    reward: Reward | str | None = None,
    steps: int = 1,
    max_steps: int | None = None,
    threads: int | None = None,
    arguments: Mapping[str, Any] | None = None,
    autoreset: bool = True,
) -> VectorScenario:
    """Make many worlds of a scenario, of which ``threads`` are simulated at once.

    Without ``autoreset``, a world whose episode has ended stays over until the next reset. All other parameters are
    those of :func:`parallel_env`.
    """
    spec = Spec.of(scenario=scenario, learners=learners, observe=observe, act=act, steps=steps, arguments=arguments)
    return VectorScenario(spec, num_envs, threads=threads, reward=reward, max_steps=max_steps, autoreset=autoreset)

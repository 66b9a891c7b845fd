"""Many worlds of a scenario at once, in one process and in one array."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
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

    This is no ``gymnasium.vector.VectorEnv``, whose worlds have one agent each: rewards are by world and learner here.
    :class:`TeamVector` makes it one.
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
        self.autoreset = autoreset
        """Whether a world whose episode has ended begins another one in the next step."""
        self._episodes = Episodes(spec, num_envs, threads, reward, max_steps)
        self.num_envs = self._episodes.count
        self._ended = np.zeros(self.num_envs, bool)
        self._spaces: tuple[Any, Any] | None = None

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

    def _known_spaces(self) -> tuple[Any, Any]:
        if self._spaces is None:
            from rsal.env._spaces import action_space, observation_space  # noqa: PLC0415 - it needs gymnasium

            self._spaces = observation_space(self.layout), action_space(self.layout)
        return self._spaces

    @property
    def single_observation_space(self) -> Any:
        """The space of one learner's observations; it needs the package gymnasium."""
        return self._known_spaces()[0]

    @property
    def single_action_space(self) -> Any:
        """The space of one learner's actions; it needs the package gymnasium."""
        return self._known_spaces()[1]

    def reset(
        self,
        *,
        seed: int | Sequence[int] | None = None,
        options: dict[str, Any] | None = None,  # noqa: ARG002 - as Gymnasium has it
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode in each world: of one seed, the worlds have this one and those after it."""
        seeds = None
        if isinstance(seed, int | np.integer):
            seeds = [int(seed) + world for world in range(self.num_envs)]
        elif seed is not None:
            seeds = list(seed)
        observations = self._episodes.reset(seeds).copy()
        self._ended[:] = False
        return observations, {}

    def step(
        self, actions: npt.ArrayLike
    ) -> tuple[Floats, Floats, npt.NDArray[np.bool_], npt.NDArray[np.bool_], dict[str, Any]]:
        """Act in all worlds.

        Observations are by world, learner and number; rewards by world and learner; ends by world. The infos have
        ``episodes``: outcome, seconds, metrics and event hash of those that have ended, by world.
        """
        before = self._ended
        done = self._episodes.step(actions, ended_too=self.autoreset)
        observations, rewards = done.observations, done.rewards
        terminated, truncated, endings = done.terminated, done.truncated, done.endings
        again = [int(world) for world in np.flatnonzero(before)] if self.autoreset else []
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
    scenario: str | Path,
    *,
    configuration: str | None = None,
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

    :param threads: how many worlds are simulated at once; by default as many as there are processors
    :param autoreset: whether a world whose episode has ended begins another one in the next step

    All other parameters are those of :func:`parallel_env`.
    """
    spec = Spec.of(
        scenario=scenario,
        configuration=configuration,
        learners=learners,
        observe=observe,
        act=act,
        steps=steps,
        arguments=arguments,
    )
    return VectorScenario(spec, num_envs, threads=threads, reward=reward, max_steps=max_steps, autoreset=autoreset)

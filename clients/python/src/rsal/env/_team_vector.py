"""Many worlds as a vector environment of Gymnasium."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from gymnasium import spaces
from gymnasium import vector as vectors
from gymnasium.vector import VectorEnv
from gymnasium.vector.utils import batch_space

from rsal.env._single import repeated
from rsal.env._spaces import action_space, observation_space
from rsal.env._vector import VectorScenario
from rsal.env._worlds import Floats
from rsal.launch import RsalError

_Rewards = npt.NDArray[np.float64]
_Flags = npt.NDArray[np.bool_]


class TeamVector(VectorEnv[Floats, Any, Any]):
    """Worlds of :func:`make_vec` as a ``gymnasium.vector.VectorEnv``: in each one agent acts for all robots that learn.

    Its observation and its action are those of all robots, one robot after the other. Its reward is the mean of theirs,
    so rewards are by world. All episodes are those of ``gymnasium.vector.SyncVectorEnv`` with the same seeds.

    :param worlds: which are closed with it
    """

    def __init__(self, worlds: VectorScenario) -> None:
        self._worlds = worlds
        self.num_envs = worlds.num_envs
        self.metadata = {"render_modes": []}
        if hasattr(vectors, "AutoresetMode"):  # since Gymnasium 1.1; in 1.0, all vectors begin in the next step
            modes = vectors.AutoresetMode
            self.metadata["autoreset_mode"] = modes.NEXT_STEP if worlds.autoreset else modes.DISABLED
        self._single: tuple[spaces.Space[Any], spaces.Space[Any]] | None = None
        self._all: tuple[spaces.Space[Any], spaces.Space[Any]] | None = None

    @property
    def single_observation_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of observations of one world, always the same object."""
        return self._single_spaces()[0]

    @property
    def single_action_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of actions of one world, always the same object."""
        return self._single_spaces()[1]

    @property
    def observation_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of observations of all worlds, always the same object."""
        return self._all_spaces()[0]

    @property
    def action_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of actions of all worlds, always the same object."""
        return self._all_spaces()[1]

    def _single_spaces(self) -> tuple[spaces.Space[Any], spaces.Space[Any]]:
        if self._single is None:
            layout = self._worlds.layout
            count = len(layout.learners)
            self._single = repeated(observation_space(layout), count), repeated(action_space(layout), count)
        return self._single

    def _all_spaces(self) -> tuple[spaces.Space[Any], spaces.Space[Any]]:
        if self._all is None:
            observed, acted = self._single_spaces()
            self._all = batch_space(observed, self.num_envs), batch_space(acted, self.num_envs)
        return self._all

    def reset(
        self,
        *,
        seed: int | Sequence[int] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode in each world: of one seed, the worlds have this one and those after it."""
        if options and "reset_mask" in options:
            raise RsalError("RSAL begins episodes in all worlds. Leave out 'reset_mask'; ended worlds begin again.")
        super().reset(seed=seed if isinstance(seed, int) else None)
        observed, infos = self._worlds.reset(seed=seed)
        return observed.reshape(self.num_envs, -1), infos

    def step(self, actions: Any) -> tuple[Floats, _Rewards, _Flags, _Flags, dict[str, Any]]:
        """Act in all worlds.

        The infos have outcome, seconds, metrics and event hash of those that have ended, as Gymnasium has them: each an
        array, and under ``_outcome`` and so on which worlds have it.
        """
        given = np.asarray(actions, np.float32).reshape(self._worlds.action_shape)
        observed, rewards, terminated, truncated, ended = self._worlds.step(given)
        infos: dict[str, Any] = {}
        for world, ending in ended.get("episodes", {}).items():
            infos = self._add_info(infos, ending, world)
        means = rewards.mean(1).astype(np.float64)
        return observed.reshape(self.num_envs, -1), means, terminated, truncated, infos

    def close_extras(self, **_: Any) -> None:
        """End the process that simulates."""
        self._worlds.close()

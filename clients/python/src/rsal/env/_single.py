"""A scenario with one learner as an environment of Gymnasium."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import gymnasium
import numpy as np

from rsal.env._drawing import Picture, Pictures
from rsal.env._episodes import Episodes
from rsal.env._spaces import action_space, observation_space
from rsal.env._spec import Spec
from rsal.env._view import Reward
from rsal.env._worlds import Floats
from rsal.launch import RsalError


class SingleScenario(gymnasium.Env[Floats, Any]):
    """One robot learns."""

    def __init__(
        self,
        spec: Spec,
        *,
        reward: Reward | str | None = None,
        max_steps: int | None = None,
        render_mode: str | None = None,
    ) -> None:
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": 10}
        self.render_mode = render_mode
        self._episodes = Episodes(spec, 1, 1, reward, max_steps)
        self._pictures = Pictures(self._episodes, render_mode)
        layout = self._episodes.layout
        if len(layout.learners) != 1:
            self.close()
            raise RsalError(
                f"The role '{spec.learners}' has {len(layout.learners)} robots, and Gymnasium needs one. "
                "Use parallel_env, or an argument of the scenario for one robot."
            )
        self.observation_space = observation_space(layout)
        self.action_space = action_space(layout)

    @property
    def fields(self) -> tuple[str, ...]:
        """What each number of an observation is, with its unit."""
        return self._episodes.layout.fields

    def reset(
        self,
        *,
        seed: int | None = None,
        options: dict[str, Any] | None = None,  # noqa: ARG002 - of the interface
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode. Without a seed, it gets the next one of the generator that the last seed has set."""
        super().reset(seed=seed)
        return self._episodes.reset(None if seed is None else [seed])[0, 0].copy(), {}

    def step(self, action: Any) -> tuple[Floats, float, bool, bool, dict[str, Any]]:
        """Act, and simulate the time of a step."""
        done = self._episodes.step(np.asarray(action, np.float32).reshape(1, 1, -1))
        return (
            done.observations[0, 0].copy(),
            float(done.rewards[0, 0]),
            bool(done.terminated[0]),
            bool(done.truncated[0]),
            done.endings.get(0, {}),
        )

    def render(self) -> Picture | None:
        """Return a picture of the map and the robots, if the render mode is ``rgb_array``."""
        return self._pictures.render()

    def close(self) -> None:
        """End the process that simulates."""
        self._episodes.close()


def single_env(
    scenario: str,
    *,
    learners: str,
    observe: Sequence[str | Mapping[str, Any]] | None = None,
    act: str | Mapping[str, Any] | None = None,
    reward: Reward | str | None = None,
    steps: int = 1,
    max_steps: int | None = None,
    arguments: Mapping[str, Any] | None = None,
    render_mode: str | None = None,
) -> SingleScenario:
    """Make a scenario with one learner an environment of Gymnasium; parameters are those of :func:`parallel_env`."""
    spec = Spec.of(scenario=scenario, learners=learners, observe=observe, act=act, steps=steps, arguments=arguments)
    return SingleScenario(spec, reward=reward, max_steps=max_steps, render_mode=render_mode)

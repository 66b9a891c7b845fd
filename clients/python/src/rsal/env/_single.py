"""A scenario with one learner as an environment of Gymnasium."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

import gymnasium
import numpy as np
from gymnasium import spaces

from rsal.env._drawing import Picture, Pictures
from rsal.env._episodes import Episodes
from rsal.env._spaces import action_space, observation_space
from rsal.env._spec import Spec
from rsal.env._view import Reward
from rsal.env._worlds import Floats, Layout
from rsal.launch import RsalError


class OneAgent(gymnasium.Env[Floats, Any]):
    """One agent acts for all robots that learn.

    Observations and actions are those of all robots, one robot after the other; the reward is the mean of theirs.
    """

    def __init__(self, episodes: Episodes, render_mode: str | None) -> None:
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": 10.0}
        self.render_mode = render_mode
        self._episodes = episodes
        self._pictures = Pictures(episodes, render_mode)
        self._spaces: tuple[spaces.Space[Any], spaces.Space[Any]] | None = None

    @property
    def layout(self) -> Layout:
        """What the numbers of one robot mean. It starts the process that simulates, if nothing did."""
        layout = self._episodes.layout
        self.metadata["render_fps"] = 1 / layout.period
        return layout

    def _known_spaces(self) -> tuple[spaces.Space[Any], spaces.Space[Any]]:
        if self._spaces is None:
            layout = self.layout
            count = len(layout.learners)
            self._spaces = repeated(observation_space(layout), count), repeated(action_space(layout), count)
        return self._spaces

    @property
    def observation_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of observations, always the same object."""
        return self._known_spaces()[0]

    @property
    def action_space(self) -> spaces.Space[Any]:  # type: ignore[override]
        """The space of actions, always the same object."""
        return self._known_spaces()[1]

    @property
    def fields(self) -> tuple[str, ...]:
        """What each number of an observation is, with its unit."""
        layout = self.layout
        return layout.fields * len(layout.learners)

    def reset(
        self,
        *,
        seed: int | None = None,
        options: dict[str, Any] | None = None,  # noqa: ARG002 - of the interface
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode. Without a seed, it gets the next one of the generator that the last seed has set."""
        super().reset(seed=seed)
        observed = self._episodes.reset(None if seed is None else [seed])
        _ = self.layout  # which may refuse
        return observed[0].ravel().copy(), {}

    def step(self, action: Any) -> tuple[Floats, float, bool, bool, dict[str, Any]]:
        """Act, and simulate the time of a step."""
        self._episodes.require_running()
        given = np.asarray(action, np.float32).reshape(1, len(self._episodes.layout.learners), -1)
        done = self._episodes.step(given)
        return (
            done.observations[0].ravel().copy(),
            float(done.rewards[0].mean()),
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


def repeated(space: spaces.Space[Any], count: int) -> spaces.Space[Any]:
    """Return the space of several robots, one after the other."""
    if count == 1:
        return space
    if isinstance(space, spaces.Box):
        return spaces.Box(np.tile(space.low, count), np.tile(space.high, count), dtype=np.float32)
    return spaces.MultiDiscrete([int(cast("spaces.Discrete", space).n)] * count)


class SingleScenario(OneAgent):
    """One robot learns."""

    def __init__(
        self,
        spec: Spec,
        *,
        reward: Reward | str | None = None,
        max_steps: int | None = None,
        render_mode: str | None = None,
    ) -> None:
        super().__init__(Episodes(spec, 1, 1, reward, max_steps), render_mode)
        self._made = (spec, reward, max_steps, render_mode)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, self._made

    @property
    def layout(self) -> Layout:
        """What the numbers mean. It starts the process that simulates, if nothing did.

        :raises RsalError: when not exactly one robot learns
        """
        layout = super().layout
        if len(layout.learners) != 1:
            self.close()
            raise RsalError(
                f"The role '{self._made[0].learners}' has {len(layout.learners)} robots, and Gymnasium needs one. "
                "Use parallel_env, or an argument of the scenario for one robot, as in arguments={'hunters': 1}."
            )
        return layout


def _made(spec: Spec, reward: Reward | str | None, max_steps: int | None, render_mode: str | None) -> SingleScenario:
    return SingleScenario(spec, reward=reward, max_steps=max_steps, render_mode=render_mode)


def single_env(
    scenario: str | Path,
    *,
    configuration: str | None = None,
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
    spec = Spec.of(
        scenario=scenario,
        configuration=configuration,
        learners=learners,
        observe=observe,
        act=act,
        steps=steps,
        arguments=arguments,
    )
    return SingleScenario(spec, reward=reward, max_steps=max_steps, render_mode=render_mode)

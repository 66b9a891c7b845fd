"""A scenario as an environment of PettingZoo."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from gymnasium import spaces
from pettingzoo import ParallelEnv

from rsal.env._drawing import Picture, Pictures
from rsal.env._episodes import Episodes
from rsal.env._spaces import action_space, observation_space
from rsal.env._spec import Spec
from rsal.env._view import Leave, Reward
from rsal.env._worlds import Floats, Layout
from rsal.launch import RsalError


class ParallelScenario(ParallelEnv[str, Floats, Any]):  # type: ignore[misc]
    """Robots of one role learn together.

    All learners act in each step until the episode ends for all of them, or until they leave.
    """

    metadata: ClassVar[dict[str, Any]] = {"render_modes": ["rgb_array"], "is_parallelizable": True, "render_fps": 10.0}

    def __init__(
        self,
        spec: Spec,
        *,
        reward: Reward | str | None = None,
        max_steps: int | None = None,
        render_mode: str | None = None,
        leave: Leave | None = None,
    ) -> None:
        self._made = (spec, reward, max_steps, render_mode, leave)
        self._episodes = Episodes(spec, 1, 1, reward, max_steps, leave=leave)
        self.metadata = {**type(self).metadata, "name": f"rsal/{spec.scenario}_v0"}  # type: ignore[misc]
        self.render_mode = render_mode
        self.agents: list[str] = []
        self._pictures = Pictures(self._episodes, render_mode)
        self._spaces: dict[str, tuple[spaces.Space[Any], spaces.Space[Any]]] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, self._made

    @property
    def layout(self) -> Layout:
        """What the numbers mean. It starts the process that simulates, if nothing did."""
        layout = self._episodes.layout
        self.metadata["render_fps"] = 1 / layout.period
        return layout

    @property
    def possible_agents(self) -> list[str]:
        """Ids of the robots that learn."""
        return list(self.layout.learners)

    def _space(self, agent: str) -> tuple[spaces.Space[Any], spaces.Space[Any]]:
        if not self._spaces:
            layout = self.layout
            self._spaces = {each: (observation_space(layout), action_space(layout)) for each in layout.learners}
        return self._spaces[agent]

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """Return the space of observations, always the same object."""
        return self._space(agent)[0]

    def action_space(self, agent: str) -> spaces.Space[Any]:
        """Return the space of actions, always the same object."""
        return self._space(agent)[1]

    @property
    def fields(self) -> tuple[str, ...]:
        """What each number of an observation is, with its unit."""
        return self.layout.fields

    def reset(
        self,
        seed: int | None = None,
        options: dict[str, Any] | None = None,  # noqa: ARG002 - of the interface
    ) -> tuple[dict[str, Floats], dict[str, dict[str, Any]]]:
        """Begin an episode. Without a seed, it gets the next one of the generator that the last seed has set."""
        observed = self._episodes.reset(None if seed is None else [seed])
        self.agents = self.possible_agents
        return self._by_agent(observed), {agent: {} for agent in self.agents}

    def _by_agent(self, observed: Floats) -> dict[str, Floats]:
        own = dict(zip(self.possible_agents, observed[0].copy(), strict=True))
        return {agent: own[agent] for agent in self.agents}

    def step(
        self, actions: dict[str, Any]
    ) -> tuple[dict[str, Floats], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Act, and simulate the time of a step.

        Observations are rows of one array. It is new in each step, so they stay as they are.
        """
        agents = self.agents
        if not agents:
            self._episodes.require_running()
        missing = [agent for agent in agents if agent not in actions]
        if missing:
            raise RsalError(f"There is no action of {', '.join(repr(agent) for agent in missing)}.")
        size = len(self._episodes.layout.action_fields)
        still = np.zeros(size, np.float32)  # of those that have left
        given = np.array(
            [np.reshape(actions[agent], size) if agent in agents else still for agent in self.possible_agents],
            np.float32,
        )[np.newaxis]
        done = self._episodes.step(given)
        observations = self._by_agent(done.observations)
        terminated, truncated = bool(done.terminated[0]), bool(done.truncated[0])
        info = done.endings.get(0, {})
        leaving = {agent for agent, leaves in zip(self.possible_agents, done.leaving[0], strict=True) if leaves}
        staying = [agent for agent in agents if agent not in leaving]
        if not staying and not info:
            info = self._episodes.worlds.finish(0)
        rewards = dict(zip(self.possible_agents, done.rewards[0], strict=True))
        result = (
            observations,
            {agent: float(rewards[agent]) for agent in agents},
            {agent: terminated or agent in leaving for agent in agents},
            {agent: truncated and agent not in leaving for agent in agents},
            {agent: dict(info) for agent in agents},
        )
        self.agents = [] if terminated or truncated else staying
        return result

    def state(self) -> Floats:
        """Return the true poses of all robots, one after the other: x, y [m] and heading [rad] in the map."""
        state: Floats = self._episodes.worlds.poses[0].ravel().copy()
        return state

    def render(self) -> Picture | None:
        """Return a picture of the map and the robots, if the render mode is ``rgb_array``."""
        return self._pictures.render()

    def close(self) -> None:
        """End the process that simulates."""
        self._episodes.close()
        self.agents = []


def _made(
    spec: Spec, reward: Reward | str | None, max_steps: int | None, render_mode: str | None, leave: Leave | None
) -> ParallelScenario:
    return ParallelScenario(spec, reward=reward, max_steps=max_steps, render_mode=render_mode, leave=leave)


def parallel_env(
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
    leave: Leave | None = None,
) -> ParallelScenario:
    """Make a scenario an environment of PettingZoo.

    :param scenario: its name or file, maybe with a configuration: ``hunt-and-prey:advanced``
    :param configuration: the configuration, if the name has none; by default the first one
    :param learners: the role of the robots that learn; their agents are replaced
    :param observe: what they observe (:class:`Observe`); ranges and velocity by default
    :param act: how they act (:class:`Act`); velocities by default
    :param reward: a function of a :class:`View`, whose numbers are in the order of ``view.layout.learners``; or the
        name of a metric, whose change in a step is the reward of each learner. A metric that has no value at the
        reset gives 0 until it has one, and then its changes. By default rewards are 0
    :param steps: steps of the scenario in a step of the environment
    :param max_steps: steps of the environment after which an episode is truncated
    :param arguments: arguments of the scenario, for a curriculum
    :param render_mode: ``rgb_array`` for pictures by ``render()``; by default there are none
    :param leave: a function of a :class:`View` which says of each learner whether it leaves after this step, as one
        that was caught: it terminates alone, is in ``agents`` no more, and its robot stands
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
    return ParallelScenario(spec, reward=reward, max_steps=max_steps, render_mode=render_mode, leave=leave)

"""What a task is, and the kinds of environments that it is made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt

from rsal.agents.policy import PolicyAgent
from rsal.env._episodes import Episodes
from rsal.env._parallel import ParallelScenario
from rsal.env._single import OneAgent
from rsal.env._spec import Spec, Words
from rsal.env._team_vector import TeamVector
from rsal.env._vector import VectorScenario
from rsal.env._view import Rules
from rsal.env._worlds import Floats
from rsal.launch import RsalError

Policy = Callable[[Floats], "npt.NDArray[np.floating[Any]]"]
"""Gives actions for observations; the last axis of both has the numbers of one learner."""

_FOLDER = Path(__file__).parent


@dataclass(frozen=True)
class Task:
    """One thing to learn. Immutable: each environment has its own rules."""

    name: str
    """As in ``rsal/Navigation-v0``."""
    title: str
    scenario: str
    """The file beside this one, with the configuration for learners."""
    learners: str
    observe: tuple[Words, ...]
    act: Words
    rules: Callable[[], Rules]
    """Makes the reward and the score of an environment."""
    score: str
    """What the score of an episode is, with its unit."""
    better: str
    """``less`` or ``more``: which scores are better."""
    max_steps: int
    """Steps of an episode."""
    steps: int = 2
    """Steps of the scenario, of 0.1 s, in a step of the environment."""
    held_out: tuple[str, ...] = ()
    """Other configurations, which no policy has been trained in."""
    scripted: Mapping[str, str] = field(default_factory=dict)
    """Configurations with agents of RSAL in place of learners, by the configuration for learners."""
    by_hand: Policy | None = None
    """A short policy that somebody has written, with the same observations as learners."""
    arguments: Mapping[str, Any] = field(default_factory=dict)
    """Arguments of the scenario."""

    @property
    def file(self) -> Path:
        """The file of its scenario."""
        return _FOLDER / self.scenario.partition(":")[0]

    @property
    def configuration(self) -> str:
        """The configuration for learners."""
        return self.scenario.partition(":")[2]

    def spec(self, configuration: str | None = None, arguments: Mapping[str, Any] | None = None) -> Spec:
        """Return what all episodes of it have in common."""
        return Spec.of(
            scenario=f"{self.file}:{configuration or self.configuration}",
            learners=self.learners,
            observe=self.observe,
            act=self.act,
            steps=self.steps,
            arguments={**self.arguments, **(arguments or {})},
        )

    def learned(self) -> Policy | None:
        """Return the policy that was trained in this task and comes with RSAL; None where there is none."""
        module = f"{self.name.lower()}_policy"
        if not (_FOLDER / f"{module}.py").is_file():
            return None
        agent: type[PolicyAgent] = getattr(import_module(f"rsal.env.tasks.{module}"), f"{self.name}Policy")
        return agent.network

    def at_random(self, seed: int = 1) -> Policy:
        """Return a policy that draws each action uniformly: the least that a score must be better than."""
        worlds = self.make_vec(1)
        layout = worlds.layout
        worlds.close()
        random = np.random.default_rng(seed)
        if layout.choices:
            return lambda observed: random.integers(0, layout.choices, (*observed.shape[:-1], 1)).astype(float)
        size = len(layout.action_low)
        return lambda observed: random.uniform(layout.action_low, layout.action_high, (*observed.shape[:-1], size))

    def parallel_env(
        self,
        *,
        configuration: str | None = None,
        arguments: Mapping[str, Any] | None = None,
        max_steps: int | None = None,
        render_mode: str | None = None,
    ) -> ParallelScenario:
        """Make it an environment of PettingZoo, with an agent for each robot that learns."""
        made = ParallelScenario(
            self.spec(configuration, arguments),
            reward=self.rules(),
            max_steps=max_steps or self.max_steps,
            render_mode=render_mode,
        )
        made.metadata["name"] = f"rsal/{self.name}-v0"  # a dictionary of its own
        return made

    def gym_env(
        self,
        *,
        configuration: str | None = None,
        arguments: Mapping[str, Any] | None = None,
        max_steps: int | None = None,
        render_mode: str | None = None,
    ) -> Team:
        """Make it an environment of Gymnasium, in which one agent acts for all robots that learn."""
        return Team(self, self.spec(configuration, arguments), max_steps or self.max_steps, render_mode)

    def gym_vec(
        self,
        num_envs: int,
        *,
        configuration: str | None = None,
        arguments: Mapping[str, Any] | None = None,
        max_steps: int | None = None,
        threads: int | None = None,
    ) -> TeamVector:
        """Make many worlds of it at once for Gymnasium, in each of which one agent acts for all robots that learn."""
        return TeamVector(
            self.make_vec(
                num_envs, configuration=configuration, arguments=arguments, max_steps=max_steps, threads=threads
            )
        )

    def make_vec(
        self,
        num_envs: int,
        *,
        configuration: str | None = None,
        arguments: Mapping[str, Any] | None = None,
        max_steps: int | None = None,
        threads: int | None = None,
        autoreset: bool = True,
    ) -> VectorScenario:
        """Make many worlds of it at once."""
        return VectorScenario(
            self.spec(configuration, arguments),
            num_envs,
            threads=threads,
            reward=self.rules(),
            max_steps=max_steps or self.max_steps,
            autoreset=autoreset,
        )

    def evaluate(
        self,
        policy: Policy,
        *,
        seeds: range,
        configuration: str | None = None,
        arguments: Mapping[str, Any] | None = None,
    ) -> list[dict[str, Any]]:
        """Return how episodes ended in which all learners act by a policy, by seed: with the ``score`` of each."""
        worlds = self.make_vec(len(seeds), configuration=configuration, arguments=arguments, autoreset=False)
        try:
            observations, _ = worlds.reset(seed=list(seeds))
            endings: dict[int, dict[str, Any]] = {}
            while len(endings) < len(seeds):
                observations, _, _, _, infos = worlds.step(policy(observations))
                endings.update(infos.get("episodes", {}))
        finally:
            worlds.close()
        return [endings[world] for world in range(len(seeds))]

    def evaluate_scripted(
        self, *, seeds: range, configuration: str | None = None, arguments: Mapping[str, Any] | None = None
    ) -> list[dict[str, Any]]:
        """Return how episodes ended in which RSAL's own agents take the place of the learners, by seed.

        :raises RsalError: when the task has no such agents
        """
        of = configuration or self.configuration
        if of not in self.scripted:
            raise RsalError(f"The task '{self.name}' has no scripted agents for its configuration '{of}'.")
        spec = Spec.of(
            scenario=f"{self.file}:{self.scripted[of]}",
            learners="",
            observe=("velocity",),
            act=self.act,
            steps=self.steps,
            arguments={**self.arguments, **(arguments or {})},
        )
        worlds = VectorScenario(spec, len(seeds), reward=self.rules(), max_steps=self.max_steps, autoreset=False)
        try:
            worlds.reset(seed=list(seeds))
            endings: dict[int, dict[str, Any]] = {}
            while len(endings) < len(seeds):
                endings.update(worlds.step(np.zeros(worlds.action_shape))[-1].get("episodes", {}))
        finally:
            worlds.close()
        return [endings[world] for world in range(len(seeds))]


class Team(OneAgent):
    """A task in which one agent acts for all robots that learn.

    Observations and actions are those of all robots, one robot after the other; the reward is the mean of theirs.
    """

    def __init__(self, task: Task, spec: Spec, max_steps: int, render_mode: str | None = None) -> None:
        super().__init__(Episodes(spec, 1, 1, task.rules(), max_steps), render_mode)
        self._made = (task, spec, max_steps, render_mode)

    def __reduce__(self) -> tuple[Any, ...]:
        task, *others = self._made
        return _team, (task.name if _KNOWN.get(task.name) is task else task, *others)


def _team(task: Task | str, spec: Spec, max_steps: int, render_mode: str | None) -> Team:
    return Team(_KNOWN[task] if isinstance(task, str) else task, spec, max_steps, render_mode)


_KNOWN: dict[str, Task] = {}


def register(tasks: Mapping[str, Task]) -> None:
    """Register tasks for ``gymnasium.make``, those that are not registered yet."""
    _KNOWN.update(tasks)
    for name in tasks:
        if f"rsal/{name}-v0" not in gymnasium.registry:
            gymnasium.register(
                id=f"rsal/{name}-v0",
                entry_point="rsal.env.tasks:make",
                vector_entry_point="rsal.env.tasks:make_vec",
                kwargs={"task": name},
            )


def make(task: str, **parameters: Any) -> Team:
    """Make a task an environment of Gymnasium, by its name.

    :param parameters: those of :meth:`Task.gym_env`
    """
    return _known(task).gym_env(**parameters)


vars(make)["metadata"] = {"render_modes": ["rgb_array"]}  # so that Gymnasium shows pictures in a window of its own


def make_vec(task: str, num_envs: int = 1, *, render_mode: str | None = None, **parameters: Any) -> TeamVector:
    """Make many worlds of a task a vector environment of Gymnasium, by its name.

    :param parameters: those of :meth:`Task.gym_vec`
    """
    if render_mode is not None:
        raise RsalError(
            f"Many worlds at once have no pictures, so 'render_mode' cannot be '{render_mode}'. Try "
            "gymnasium.make_vec(…, vectorization_mode='sync'), which makes each world an environment of its own."
        )
    return _known(task).gym_vec(num_envs, **parameters)


def _known(task: str) -> Task:
    known = _KNOWN.get(task)
    if known is None:
        raise RsalError(f"There is no task '{task}'. Tasks are {', '.join(_KNOWN)}.")
    return known

"""Train hunters of the task Pursuit by MAPPO of BenchMARL: ``pip install "rsal[env]" benchmarl``, then run this file.

BenchMARL saves its results in the folder that is named, by default the one it is started in.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarl.algorithms import MappoConfig
from benchmarl.environments.common import Task, TaskClass
from benchmarl.experiment import Experiment, ExperimentConfig
from benchmarl.models.mlp import MlpConfig
from torchrl.envs.libs.pettingzoo import PettingZooWrapper

from rsal.env import TASKS


class Pursuit(TaskClass):  # type: ignore[misc]
    """The task Pursuit, whose hunters are one group, which shares a policy."""

    def get_env_fun(self, *_: Any, **__: Any) -> Callable[[], Any]:
        """Return what makes an environment."""
        return self._make

    def _make(self) -> Any:
        made = TASKS["Pursuit"].parallel_env(max_steps=self.config["max_steps"])
        return PettingZooWrapper(made, group_map={"hunters": made.possible_agents})

    def supports_continuous_actions(self) -> bool:
        """Hunters choose their velocity."""
        return True

    def supports_discrete_actions(self) -> bool:
        """Hunters have no list of actions."""
        return False

    def has_render(self, env: Any) -> bool:  # noqa: ARG002
        """No pictures are made."""
        return False

    def max_steps(self, env: Any) -> int:  # noqa: ARG002
        """Return the most steps of an episode."""
        return int(self.config["max_steps"])

    def group_map(self, env: Any) -> Any:
        """Return the names of the hunters."""
        return env.group_map

    def observation_spec(self, env: Any) -> Any:
        """Return what hunters observe."""
        spec = env.observation_spec.clone()
        for key in [key for key in spec["hunters"] if key != "observation"]:
            del spec["hunters"][key]
        return spec

    def action_spec(self, env: Any) -> Any:
        """Return what hunters choose."""
        return env.full_action_spec

    def state_spec(self, env: Any) -> None:
        """There is no state of all together."""

    def action_mask_spec(self, env: Any) -> None:
        """All actions are possible."""

    def info_spec(self, env: Any) -> None:
        """Nothing else is learned from."""

    @staticmethod
    def env_name() -> str:
        """Return the name by which results are filed."""
        return "rsal"


class RsalTask(Task):  # type: ignore[misc]
    """Tasks of RSAL."""

    PURSUIT = None

    @staticmethod
    def associated_class() -> type[TaskClass]:
        """Return what makes the task."""
        return Pursuit


def learn(folder: Path, iterations: int = 100, frames: int = 6000, steps: int = 300) -> Experiment:
    """Learn from so many frames in each iteration, and return the experiment."""
    settings = ExperimentConfig.get_from_yaml()
    settings.max_n_iters = iterations
    settings.max_n_frames = None
    settings.on_policy_collected_frames_per_batch = frames
    settings.on_policy_n_minibatch_iters = 4
    settings.on_policy_minibatch_size = max(frames // 10, 40)
    settings.on_policy_n_envs_per_worker = 2
    settings.evaluation = False
    settings.loggers = ["csv"]
    settings.save_folder = str(folder)
    model = MlpConfig.get_from_yaml()
    learner = Experiment(
        task=RsalTask.PURSUIT.get_task(config={"max_steps": steps}),
        algorithm_config=MappoConfig.get_from_yaml(),
        model_config=model,
        critic_model_config=model,
        seed=1,
        config=settings,
    )
    learner.run()
    return learner


if __name__ == "__main__":
    learn(Path(sys.argv[1] if len(sys.argv) > 1 else "."))

"""Libraries that learn, which only ``pytest -m learning`` runs: they are large, and not needed for anything else."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

import rsal.env
from rsal.env import TASKS

pytestmark = pytest.mark.learning


@pytest.fixture
def sb3() -> Any:
    return pytest.importorskip("stable_baselines3", reason="stable-baselines3 is not installed", exc_type=ImportError)


@pytest.mark.parametrize("name", TASKS)
def test_stable_baselines_accepts_it(name: str, sb3: Any) -> None:  # noqa: ARG001 - it says whether it is installed
    from stable_baselines3.common.env_checker import check_env  # noqa: PLC0415

    made = gymnasium.make(f"rsal/{name}-v0", max_steps=20)
    check_env(made.unwrapped, warn=False, skip_render_check=True)
    made.close()


def test_stable_baselines_learns_in_a_task(sb3: Any) -> None:
    made = gymnasium.make("rsal/Navigation-v0", max_steps=100)
    learner = sb3.PPO("MlpPolicy", made, n_steps=128, batch_size=64, n_epochs=2, seed=1, device="cpu")
    before = learner.policy.parameters_to_vector()
    learner.learn(512)
    assert learner.num_timesteps == 512
    after = learner.policy.parameters_to_vector()
    assert np.isfinite(after).all()
    assert not np.array_equal(after, before)
    observed, _ = made.reset(seed=3)
    action, _ = learner.predict(observed, deterministic=True)
    assert action in made.action_space
    made.close()


def test_stable_baselines_learns_one_policy_for_all_learners(scenario: str, sb3: Any) -> None:
    supersuit = pytest.importorskip("supersuit", reason="SuperSuit is not installed")
    made = rsal.env.parallel_env(scenario, learners="learner", max_steps=50)
    vector = supersuit.pettingzoo_env_to_vec_env_v1(made)
    vector = supersuit.concat_vec_envs_v1(vector, 2, num_cpus=0, base_class="stable_baselines3")
    # without a seed, which SuperSuit's wrapper cannot hand on
    learner = sb3.PPO("MlpPolicy", vector, n_steps=32, batch_size=64, n_epochs=1, device="cpu")
    learner.learn(256)
    assert learner.num_timesteps == 256
    vector.close()
    made.close()


def test_torchrl_accepts_teams_and_steps_them(scenario: str) -> None:
    pettingzoo = pytest.importorskip("torchrl.envs.libs.pettingzoo", reason="TorchRL is not installed")
    from torchrl.envs.utils import check_env_specs  # noqa: PLC0415

    made = rsal.env.parallel_env(scenario, learners="learner", max_steps=20)
    wrapped = pettingzoo.PettingZooWrapper(made, group_map={"team": made.possible_agents})
    check_env_specs(wrapped, seed=1)
    steps = wrapped.rollout(10)
    assert steps["team", "observation"].shape[:2] == (10, 2)
    assert steps["next", "team", "reward"].isfinite().all()
    wrapped.close()


def test_torchrl_accepts_tasks_of_gymnasium() -> None:
    torchrl = pytest.importorskip("torchrl.envs", reason="TorchRL is not installed")
    made = gymnasium.make("rsal/Navigation-v0", max_steps=20)
    wrapped = torchrl.GymWrapper(made)
    torchrl.check_env_specs(wrapped)
    steps = wrapped.rollout(10)
    assert steps["next", "reward"].shape[1:] == (1,)
    assert steps["next", "reward"].isfinite().all()
    wrapped.close()


def test_rllib_learns_one_policy_for_all_learners(scenario: str) -> None:
    ray = pytest.importorskip("ray", reason="Ray is not installed")
    wrappers = pytest.importorskip("ray.rllib.env.wrappers.pettingzoo_env", reason="RLlib is not installed")
    from ray.rllib.algorithms.ppo import PPOConfig  # noqa: PLC0415
    from ray.tune.registry import register_env  # noqa: PLC0415

    def make(_: Any) -> Any:
        return wrappers.ParallelPettingZooEnv(rsal.env.parallel_env(scenario, learners="learner", max_steps=50))

    register_env("rsal-team", make)
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        learner = (
            PPOConfig()
            .environment("rsal-team")
            .multi_agent(policies={"shared"}, policy_mapping_fn=lambda *_, **__: "shared")
            .env_runners(num_env_runners=2, rollout_fragment_length=50)
            .training(train_batch_size_per_learner=200, minibatch_size=50, num_epochs=1)
            .build_algo()
        )
        result = learner.train()
        assert result["env_runners"]["num_env_steps_sampled_lifetime"] >= 200
        learner.stop()
    finally:
        ray.shutdown()


def test_benchmarl_learns_in_a_task(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("benchmarl", reason="BenchMARL is not installed")
    monkeypatch.syspath_prepend(str(Path(__file__).parents[1] / "examples"))
    learn = importlib.import_module("train_benchmarl").learn
    assert learn(tmp_path, iterations=1, frames=80, steps=20).total_frames == 80

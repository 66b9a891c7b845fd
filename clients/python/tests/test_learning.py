"""Libraries that learn, which only ``pytest -m learning`` runs: they are large, and not needed for anything else."""

from __future__ import annotations

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

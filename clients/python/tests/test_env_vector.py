"""Many worlds as vector environments of Gymnasium and of SuperSuit."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from gymnasium.wrappers.vector import RecordEpisodeStatistics

import rsal.env
from rsal import RsalError
from rsal.env import Act


def test_gymnasium_makes_many_worlds_that_are_those_of_single_environments() -> None:
    made = gymnasium.make_vec("rsal/Pursuit-v0", num_envs=2, max_steps=4)
    alone = gymnasium.make_vec("rsal/Pursuit-v0", num_envs=1, max_steps=4, vectorization_mode="sync")
    assert isinstance(made, rsal.env.TeamVector)
    assert made.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    assert made.single_observation_space == alone.single_observation_space
    assert made.single_action_space == alone.single_action_space
    counted: Any = RecordEpisodeStatistics(made)
    observed, _ = counted.reset(seed=3)
    expected: Any
    expected, _ = alone.reset(seed=4)
    assert observed[1].tobytes() == expected[0].tobytes()
    ends = 0
    for step in range(10):  # two episodes
        actions = np.full((2, 4), 0.1 * step, np.float32)
        *told, infos = counted.step(actions)
        *wanted, others = alone.step(actions[1:])
        for ours, expected in zip(told, wanted, strict=True):
            assert ours.dtype == expected.dtype
            assert ours.shape == (2, *expected.shape[1:])
            assert ours[1].tobytes() == expected[0].tobytes()
        assert set(infos) - {"episode", "_episode"} == set(others)
        if "outcome" in infos:
            ends += 1
            assert infos["event_hash"][1] == others["event_hash"][0]
            assert infos["episode"]["l"].tolist() == [4, 4]
    assert ends == 2
    counted.close()
    alone.close()
    with pytest.raises(RsalError, match="vectorization_mode='sync'"):
        gymnasium.make_vec("rsal/Pursuit-v0", num_envs=2, render_mode="rgb_array")


def test_worlds_of_any_scenario_are_a_vector_of_gymnasium(scenario: str) -> None:
    worlds = rsal.env.make_vec(scenario, num_envs=3, learners="learner", act=Act.discrete(), autoreset=False)
    made = rsal.env.TeamVector(worlds)
    assert made.metadata["autoreset_mode"] is AutoresetMode.DISABLED
    assert made.single_action_space == spaces.MultiDiscrete([5, 5])
    observed, _ = made.reset(seed=1)
    assert observed in made.observation_space
    observed, rewards, *_ = made.step(made.action_space.sample())
    assert observed in made.observation_space
    assert rewards.shape == (3,)
    with pytest.raises(RsalError, match="reset_mask"):
        made.reset(options={"reset_mask": np.array([True, False, False])})
    made.close()
    with pytest.raises(RsalError, match="closed"):
        made.step(np.zeros((3, 2)))


def test_supersuit_makes_vectors_of_agents(scenario: str) -> None:
    supersuit = pytest.importorskip("supersuit", reason="SuperSuit is not installed")
    made = rsal.env.parallel_env(
        scenario, learners="learner", reward=lambda view: view.learners.astype(float), max_steps=4
    )
    one = supersuit.pettingzoo_env_to_vec_env_v1(made)
    vector: Any = supersuit.concat_vec_envs_v1(one, 2, num_cpus=0, base_class="gymnasium")
    observed, _ = vector.reset(seed=3)
    assert observed.shape == (4, len(made.fields))
    alone, _ = made.reset(seed=3)
    assert observed[0].tobytes() == alone["learner-1"].tobytes()
    for step in range(1, 9):
        observed, rewards, terminated, truncated, _ = vector.step(np.zeros((4, 2), np.float32))
        assert rewards.tolist() == [0, 1, 0, 1]
        assert truncated.tolist() == [step % 4 == 0] * 4
        assert not terminated.any()
    assert observed.shape == (4, len(made.fields))
    vector.close()
    made.close()

"""Environments for learning: the suites of PettingZoo and Gymnasium, and the same bytes for the same seed."""

from __future__ import annotations

import gc
import os
import pickle
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import max_cycles_test, parallel_api_test, parallel_seed_test
from pettingzoo.utils.conversions import parallel_to_aec

from rsal import RsalError, env
from rsal.env import Act, Observe, View
from rsal.env._worlds import Worlds


@pytest.fixture
def parallel(scenario: str) -> Iterator[env.ParallelScenario]:
    made = env.parallel_env(
        scenario,
        learners="learner",
        observe=[Observe.ranges(sectors=12), Observe.pose(source="truth"), Observe.nearest(count=2), "velocity"],
        reward=lambda view: -view.collisions.astype(float),
        max_steps=20,
        render_mode="rgb_array",
    )
    yield made
    made.close()


def test_pettingzoo_accepts_it(parallel: env.ParallelScenario) -> None:
    parallel_api_test(parallel, num_cycles=50)
    assert parallel.fields[:2] == ("range 0 [m]", "range 1 [m]")
    assert parallel.possible_agents == ["learner-1", "learner-2"]


def test_pettingzoo_finds_equal_episodes_for_equal_seeds(scenario: str) -> None:
    def make() -> env.ParallelScenario:
        return env.parallel_env(scenario, learners="learner", max_steps=10)

    parallel_seed_test(make, num_cycles=20)


def test_agents_that_leave_are_gone_before_the_others(scenario: str) -> None:
    def leaving(view: View) -> list[bool]:
        return [view.time > 0.35, view.time > 0.75]

    made = env.parallel_env(scenario, learners="learner", max_steps=50, leave=leaving)
    made.reset(seed=3)
    first, second = made.possible_agents
    left: list[tuple[list[str], dict[str, bool]]] = []
    start = made.state()
    while made.agents:
        acted = {agent: np.array([0.5, 0.0], np.float32) for agent in made.agents}
        observations, rewards, terminated, truncated, infos = made.step(acted)
        assert set(observations) == set(rewards) == set(terminated) == set(infos) == set(acted)
        assert not any(truncated.values())
        left.append((list(made.agents), terminated))
        if len(left) == 5:
            moved = made.state()
    assert left[3] == ([second], {first: True, second: False})
    assert left[-1] == ([], {second: True})
    assert len(left) == 8
    assert len(infos[second]["event_hash"]) == 64
    assert not np.allclose(start[:3], moved[:3])
    parallel_api_test(made, num_cycles=50)
    made.close()


def test_pettingzoo_finds_the_end_of_an_episode(scenario: str) -> None:
    class Module:
        """The two functions of a module of PettingZoo that its test calls."""

        @staticmethod
        def parallel_env(max_cycles: int) -> env.ParallelScenario:
            return env.parallel_env(scenario, learners="learner", max_steps=max_cycles)

        @staticmethod
        def env(max_cycles: int) -> Any:
            return parallel_to_aec(Module.parallel_env(max_cycles))

    max_cycles_test(Module)
    made = Module.parallel_env(4)
    made.reset(seed=1)
    lengths = 0
    while made.agents:
        made.step({agent: np.zeros(2, np.float32) for agent in made.agents})
        lengths += 1
    assert lengths == 4
    made.close()


def test_gymnasium_accepts_it(scenario: str) -> None:
    made = env.single_env(scenario, learners="learner", arguments={"count": 1}, max_steps=10, act=Act.discrete())
    assert isinstance(made.action_space, spaces.Discrete)
    check_env(made, skip_render_check=True)
    made.close()


def test_the_same_seed_and_actions_give_the_same_bytes_beside_other_worlds(scenario: str) -> None:
    def observed(seeds: list[int], threads: int, world: int) -> bytes:
        made = env.make_vec(scenario, num_envs=len(seeds), learners="learner", threads=threads)
        seen, _ = made.reset(seed=seeds)
        generator = np.random.default_rng(2)
        parts = [seen[world].tobytes()]
        for _ in range(10):
            own = generator.uniform(-1, 1, made.action_shape[1:]).astype(np.float32)
            seen, *_ = made.step(np.broadcast_to(own, made.action_shape))
            parts.append(seen[world].tobytes())
        made.close()
        return b"".join(parts)

    alone = observed([5], 1, 0)
    assert observed([5], 1, 0) == alone
    assert observed([1, 5, 9], 2, 1) == alone
    assert observed([6], 1, 0) != alone


def test_rewards_come_from_functions_and_from_metrics(scenario: str) -> None:
    views: list[View] = []

    def reward(view: View) -> npt.ArrayLike:
        views.append(view)
        return [view.time, float(view.poses("other")[0, 0])]

    made = env.parallel_env(scenario, learners="learner", reward=reward, steps=3)
    made.reset(seed=1)
    _, rewards, *_ = made.step({agent: np.zeros(2) for agent in made.agents})
    assert rewards["learner-1"] == pytest.approx(0.3)
    assert rewards["learner-2"] == pytest.approx(-20, abs=1)
    assert list(views[0].learners) == [0, 1]
    made.close()
    by_metric = env.parallel_env(scenario, learners="learner", reward="way", steps=10)
    by_metric.reset(seed=1)
    ways = [by_metric.step({agent: np.zeros(2) for agent in by_metric.agents})[1]["learner-1"] for _ in range(5)]
    assert all(way >= 0 for way in ways)
    assert sum(ways) > 0.3
    by_metric.close()


def test_an_episode_ends_as_its_scenario_says(team: Callable[..., str]) -> None:
    for outcome, terminates in (("success", True), ("timeout", False)):
        made = env.parallel_env(team("time >= 1", outcome), learners="learner")
        made.reset(seed=1)
        while made.agents:
            _, _, terminated, truncated, infos = made.step({agent: np.zeros(2) for agent in made.agents})
        assert set(terminated.values()) == {terminates}
        assert set(truncated.values()) == {not terminates}
        assert infos["learner-1"]["outcome"] == outcome
        assert infos["learner-1"]["seconds"] == pytest.approx(1)
        assert len(infos["learner-1"]["event_hash"]) == 64
        with pytest.raises(RsalError, match="reset"):
            made.step({})
        made.close()


def test_a_vector_begins_ended_episodes_again(scenario: str) -> None:
    made = env.make_vec(scenario, num_envs=2, learners="learner", max_steps=3, reward=lambda _: 1.0)
    first, _ = made.reset(seed=3)
    still = np.zeros(made.action_shape)
    for step in range(1, 4):
        _, rewards, _, truncated, infos = made.step(still)
        assert truncated.tolist() == [step == 3] * 2
        assert rewards.tolist() == [[1, 1], [1, 1]]
    assert set(infos["episodes"]) == {0, 1}
    seen, rewards, _, truncated, infos = made.step(still)
    assert not rewards.any()
    assert not truncated.any()
    assert not infos
    assert seen.shape == first.shape
    assert not np.array_equal(seen, first)
    made.close()


def test_it_draws_itself(parallel: env.ParallelScenario) -> None:
    parallel.reset(seed=1)
    picture = parallel.render()
    assert picture is not None
    assert picture.dtype == np.uint8
    assert picture.shape[2] == 3
    for robot, color in parallel.layout.colors.items():
        assert (picture == tuple(bytes.fromhex(color[1:]))).all(2).sum() > 30, f"{robot} has its color of the page"
    parallel.step({agent: np.array([0.5, 0]) for agent in parallel.agents})
    moved = parallel.render()
    assert moved is not None
    assert not np.array_equal(moved, picture)


def test_colors_are_those_of_the_scenario(scenario: str) -> None:
    file = Path(scenario)
    text = file.read_text(encoding="utf-8").replace("other: {", "other: {color: '#12ab34', ")
    file.write_text(text, encoding="utf-8")
    made = env.single_env(scenario, learners="other", render_mode="rgb_array")
    made.reset(seed=1)
    assert made.layout.colors["other"] == "#12ab34"
    assert len({made.layout.colors[robot] for robot in ("learner-1", "learner-2")}) == 1
    made.close()
    with pytest.raises(RsalError, match=r"render_mode 'human'.*'rgb_array'"):
        env.parallel_env(scenario, learners="learner", render_mode="human")


def test_it_goes_through_pickle_without_its_process(scenario: str) -> None:
    made = env.parallel_env(scenario, learners="learner", max_steps=5)
    made.reset(seed=1)
    other = pickle.loads(pickle.dumps(made))  # noqa: S301 - it was made here
    mine, _ = made.reset(seed=9)
    theirs, _ = other.reset(seed=9)
    np.testing.assert_array_equal(mine["learner-1"], theirs["learner-1"])
    made.close()
    other.close()


def test_errors_say_what_is_wrong(scenario: str) -> None:
    with pytest.raises(RsalError, match=r"no observation 'rangs'.*ranges"):
        env.parallel_env(scenario, learners="learner", observe=["rangs"]).reset()
    with pytest.raises(RsalError, match=r"No robot has the role 'hunter'. Roles are: learner, other."):
        env.parallel_env(scenario, learners="hunter").reset()
    with pytest.raises(RsalError, match="'sectors'"):
        env.parallel_env(scenario, learners="learner", observe=[Observe.ranges(sectors=0)]).reset()
    with pytest.raises(RsalError, match=r"nowhere\.yaml"):
        env.parallel_env("nowhere.yaml", learners="learner").reset()
    with pytest.raises(RsalError, match="has 2 robots"):
        env.single_env(scenario, learners="learner").reset()
    with pytest.raises(RsalError, match="'count'"):
        env.parallel_env(scenario, learners="learner", arguments={"count": "many"}).reset()


def test_a_process_that_dies_is_an_exception_with_its_last_words(scenario: str) -> None:
    spec = env.parallel_env(scenario, learners="learner")._episodes.spec
    worlds = Worlds(spec, [1])
    worlds._process.kill()
    with pytest.raises(env.RsalCrashed, match="exit code"):
        worlds.step(np.zeros((1, 2, 2)))
    worlds.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_no_process_is_left(scenario: str) -> None:
    made = env.make_vec(scenario, num_envs=1, learners="learner")
    made.reset(seed=1)
    process = made._episodes.worlds._process
    del made
    gc.collect()
    assert process.poll() == 0

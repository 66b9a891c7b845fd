"""Rewards, seeds, spaces and actions of environments."""

from __future__ import annotations

import copy
import inspect
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from rsal import RsalError, env
from rsal.env import Act, Observe, View

_MEASURED = """
rsal: 1
scenario: measured
world: {map: office}
robots:
  learner: {model: pioneer2dx, pose: [-20, 4, 0], devices: {laser: urg04lx}}
  other: {model: pioneer2dx, pose: [-18, 4, 0], devices: {laser: urg04lx}}
metrics:
  - {name: apart, from: "max(distance(learner, other))"}
  - {name: late, from: firstTime(time >= 0.5)}
"""


@pytest.fixture
def measured(tmp_path: Path) -> Path:
    file = tmp_path / "measured.yaml"
    file.write_text(_MEASURED, encoding="utf-8")
    return file


def test_a_metric_is_rewarded_from_its_value_at_the_reset_on(measured: Path) -> None:
    """The robots are 2 m apart at the reset: that is no merit of the first step."""
    made = env.single_env(measured, learners="learner", reward="apart", act=Act.velocity(backward=0.5))
    for _ in range(2):
        made.reset(seed=1)
        rewards = [made.step(np.array([-0.5, 0]))[1] for _ in range(20)]
        assert max(rewards) < 0.2
        assert sum(rewards) == pytest.approx(0.8, abs=0.3)
    made.close()


def test_a_metric_that_comes_later_does_not_jump(measured: Path) -> None:
    made = env.single_env(measured, learners="learner", reward="late")
    made.reset(seed=1)
    assert [made.step(np.zeros(2))[1] for _ in range(10)] == [0] * 10
    made.close()


def test_metrics_that_are_not_there_are_refused(measured: Path) -> None:
    with pytest.raises(RsalError, match=r"no metric 'appart' for a reward. It has: apart, late"):
        env.single_env(measured, learners="learner", reward="appart").reset()


def test_rewards_of_progress_know_the_world_before_the_step(scenario: str) -> None:
    seen: list[tuple[int, bool, float, float, float]] = []

    def progress(view: View) -> npt.ArrayLike:
        before = view.before
        moved = float(np.hypot(*(view.all_poses[0, :2] - before.all_poses[0, :2])))
        seen.append((view.world, view.is_first, view.time, before.time, moved))
        assert before.observations.shape == view.observations.shape
        assert (view.all_collisions - before.all_collisions == view.new_collisions).all()
        with pytest.raises(RsalError, match="newest step"):
            before.metrics()
        return moved

    made = env.make_vec(scenario, num_envs=2, learners="learner", reward=progress, max_steps=2)
    made.reset(seed=1)
    drive = np.full(made.action_shape, (0.5, 0))
    for _ in range(3):
        made.step(drive)
    assert [(world, first) for world, first, *_ in seen] == [(0, True), (1, True), (0, False), (1, False)]
    assert all(time - before == pytest.approx(0.1) for _, _, time, before, _ in seen)
    assert all(0 < moved < 0.06 for *_, moved in seen)
    made.step(drive)  # of the episodes after these
    assert [each[1] for each in seen[4:]] == [True, True]
    assert all(moved < 0.06 for *_, moved in seen), "a robot does not move from one episode to the next"
    made.close()


def test_rewards_are_not_asked_for_worlds_that_are_over(scenario: str) -> None:
    asked: list[int] = []

    def noted(view: View) -> float:
        asked.append(view.world)
        return 0.0

    made = env.make_vec(scenario, num_envs=1, learners="learner", reward=noted)
    made.reset(seed=1)
    made._episodes._over[:] = True
    made._episodes.step(np.zeros(made.action_shape), ended_too=True)
    assert asked == []
    made.close()


def test_scenarios_are_measured_without_learners(scenario: str) -> None:
    seen: list[tuple[int, float]] = []

    def noted(view: View) -> float:
        seen.append((view.world, float(view.before.poses("other")[0, 0])))
        return 1.0

    made = env.make_vec(scenario, num_envs=2, learners="", observe=["velocity"], reward=noted)
    made.reset(seed=1)
    _, rewards, *_ = made.step(np.zeros(made.action_shape))
    assert rewards.shape == (2, 0)
    assert [world for world, _ in seen] == [0, 1]
    assert [x for _, x in seen] == pytest.approx([-20, -20], abs=1)
    made.close()


def test_second_episodes_do_not_depend_on_other_worlds(scenario: str) -> None:
    def second(seeds: list[int], world: int) -> bytes:
        made = env.make_vec(scenario, num_envs=len(seeds), learners="learner", threads=1, max_steps=1)
        made.reset(seed=seeds)
        for _ in range(2):
            seen, *_ = made.step(np.zeros(made.action_shape))
        third, _ = made.reset()
        made.close()
        return b"".join([seen[world].tobytes(), third[world].tobytes()])

    alone = second([5], 0)
    assert second([1, 5], 1) == alone
    assert second([5, 2, 3], 0) == alone
    assert second([6], 0) != alone


def test_seeds_are_checked(scenario: str) -> None:
    made = env.make_vec(scenario, num_envs=np.int64(2), learners="learner")
    with pytest.raises(RsalError, match="1 seeds for 2 worlds"):
        made.reset(seed=[1])
    with pytest.raises(RsalError, match="whole number from 0 on, not '-1'"):
        made.reset(seed=[1, -1])
    assert made._episodes._worlds is None, "nothing was started"
    with pytest.raises(RsalError, match="num_envs must be a whole number of at least 1, not '0'"):
        env.make_vec(scenario, num_envs=0, learners="learner")
    with pytest.raises(RsalError, match="threads"):
        env.make_vec(scenario, num_envs=1, threads=-1, learners="learner")
    with pytest.raises(RsalError, match="max_steps"):
        env.make_vec(scenario, num_envs=1, max_steps=0, learners="learner")


def test_spaces_have_limits_for_each_number(scenario: str) -> None:
    observe = [Observe.pose(source="truth", reach=40), Observe.nearest(count=np.int64(1), reach=np.float64(30))]
    made = env.make_vec(scenario, num_envs=1, learners="learner", observe=observe)
    space = made.single_observation_space
    assert space.low.tolist() == [-40, -40, -1, -1, -30, -30, 0]
    assert space.high.tolist() == [40, 40, 1, 1, 30, 30, 1]
    assert made.single_observation_space is space
    assert made.single_action_space.shape == (2,)
    seen, _ = made.reset(seed=1, options={})
    assert all(space.contains(each) for each in seen[0])
    made.close()


def test_wrong_actions_are_refused_on_several_threads(scenario: str) -> None:
    made = env.make_vec(scenario, num_envs=4, threads=2, learners="learner")
    made.reset(seed=1)
    actions = np.zeros(made.action_shape)
    actions[3, 1, 0] = np.nan
    with pytest.raises(RsalError, match=r"'forward \[m/s\]' of robot 'learner-2' must be finite"):
        made.step(actions)
    _, rewards, *_ = made.step(np.zeros(made.action_shape))
    assert rewards.shape == (4, 2)
    made.close()


@pytest.mark.parametrize("choice", [7, -3, 1.5])
def test_choices_that_are_not_there_are_refused(scenario: str, choice: float) -> None:
    made = env.single_env(scenario, learners="learner", arguments={"count": np.int64(1)}, act=Act.discrete())
    made.reset(seed=1)
    with pytest.raises(RsalError, match=rf"whole number from 0 to 4, not '{float(choice)}'"):
        made.step(choice)
    made.step(4)
    made.close()


def test_an_environment_of_gymnasium_starts_late_and_is_copied(measured: Path) -> None:
    made = env.single_env(measured, learners="learner", steps=2, max_steps=5)
    assert made._episodes._worlds is None
    copies = [copy.deepcopy(made), pickle.loads(pickle.dumps(made))]  # noqa: S301 - it was made here
    seen, _ = made.reset(seed=4)
    assert made.metadata["render_fps"] == pytest.approx(5)
    for each in copies:
        np.testing.assert_array_equal(each.reset(seed=4)[0], seen)
        each.close()
    made.close()


def test_a_configuration_is_a_name_or_a_parameter() -> None:
    for made in (
        env.parallel_env("hunt-and-prey:random", learners="hunter"),
        env.parallel_env("hunt-and-prey", configuration="random", learners="hunter"),
    ):
        words = made._episodes.spec.opening([1], 1)
        assert (words["scenario"], words["configuration"]) == ("hunt-and-prey", "random")


_WITHOUT = """
import sys
sys.modules["pettingzoo"] = None
import rsal, rsal.env
rsal.make_vec
try:
    rsal.parallel_env
except rsal.RsalError as error:
    print(error)
"""


def test_all_kinds_of_environments_have_the_same_parameters() -> None:
    """They are written out in each signature, as people read them in their editors."""

    makers: list[Callable[..., object]] = [env.parallel_env, env.single_env, env.make_vec]
    parallel, single, vector = (inspect.signature(maker).parameters for maker in makers)
    assert parallel.keys() - single.keys() == {"leave"}
    assert parallel.keys() - vector.keys() == {"leave", "render_mode"}
    assert single.keys() - parallel.keys() == set()
    assert vector.keys() - parallel.keys() == {"num_envs", "threads", "autoreset"}
    for other in (single, vector):
        for name in other.keys() & parallel.keys():
            assert other[name] == parallel[name]
        shared = [name for name in parallel if name in other]
        assert shared == [name for name in other if name in parallel]


def test_many_worlds_need_numpy_only() -> None:
    said = subprocess.run([sys.executable, "-c", _WITHOUT], capture_output=True, text=True, check=False)
    assert "'parallel_env' needs the package pettingzoo" in said.stdout, said.stderr
    assert 'pip install "rsal[env]"' in said.stdout

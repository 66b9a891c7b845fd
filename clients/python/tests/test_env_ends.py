"""Environments whose process, episode or program ends: by interrupts, errors, forks, and agents that fail."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rsal import RsalError, env, launch
from rsal.env import _worlds as _worlds_module
from rsal.env._worlds import Worlds

_POSIX = pytest.mark.skipif(not hasattr(os, "fork"), reason="signals and forks are those of POSIX")


def _worlds(scenario: str, **options: Any) -> env.VectorScenario:
    return env.make_vec(scenario, num_envs=1, learners="learner", **options)


@_POSIX
def test_an_interrupted_request_breaks_the_worlds_and_reset_makes_others(
    scenario: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else each further request would get the answer of the one before."""
    made = _worlds(scenario)
    made.reset(seed=1)
    worlds = made._episodes.worlds
    process = worlds._process
    read = worlds._frames._read

    def interrupted(size: int) -> bytes:
        signal.raise_signal(signal.SIGINT)  # as the first byte of the answer is awaited
        return read(size)

    monkeypatch.setattr(worlds._frames, "_read", interrupted)
    with pytest.raises(KeyboardInterrupt):
        made.step(np.zeros(made.action_shape))
    assert process.wait(60) != 0
    with pytest.raises(env.RsalCrashed, match="interrupted"):
        made.step(np.zeros(made.action_shape))
    seen, _ = made.reset(seed=1)
    other = _worlds(scenario)
    np.testing.assert_array_equal(seen, other.reset(seed=1)[0])
    other.close()
    made.close()


_INTERRUPTED = """
import sys, time
import numpy as np
from rsal import env
made = env.make_vec(sys.argv[1], num_envs=1, learners="learner")
made.reset(seed=1)
try:
    print("ready", flush=True)
    time.sleep(60)
except KeyboardInterrupt:
    pass
made.step(np.zeros(made.action_shape))
made.reset()
print("goes on", flush=True)
made.close()
"""


@_POSIX
def test_ctrl_c_of_a_terminal_does_not_reach_java(scenario: str) -> None:
    words = [sys.executable, "-c", _INTERRUPTED, scenario]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, start_new_session=True) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == "ready\n"
        os.killpg(program.pid, signal.SIGINT)  # as a terminal sends it
        assert program.stdout.readline() == "goes on\n"
    assert program.returncode == 0


@_POSIX
def test_close_does_not_wait_for_a_forked_child(scenario: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_worlds_module, "_PATIENCE", 60)  # s, then it would be killed
    made = _worlds(scenario)
    made.reset(seed=1)
    process = made._episodes.worlds._process
    child = os.fork()  # it has the pipes, too
    if child == 0:
        time.sleep(300)
        os._exit(0)
    try:
        made.close()
        assert process.returncode == 0
    finally:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)


@_POSIX
def test_another_process_is_told_to_make_its_own(scenario: str) -> None:
    made = _worlds(scenario)
    made.reset(seed=1)
    child = os.fork()
    if child == 0:
        try:
            made.step(np.zeros((1, 2, 2)))
        except RsalError as error:
            os._exit(7 if "another process" in str(error) else 8)
        os._exit(9)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
    made.step(np.zeros(made.action_shape))
    made.close()


def test_no_process_is_left_when_opening_fails(scenario: str, monkeypatch: pytest.MonkeyPatch) -> None:
    processes: list[subprocess.Popen[bytes]] = []
    start = subprocess.Popen

    def noted(*words: Any, **options: Any) -> subprocess.Popen[bytes]:
        processes.append(start(*words, **options))
        return processes[-1]

    monkeypatch.setattr(subprocess, "Popen", noted)
    spec = _worlds(scenario, observe=["rangs"])._episodes.spec
    with pytest.raises(RsalError, match="rangs") as kept:
        Worlds(spec, [1])
    assert kept is not None
    assert processes[0].returncode is not None
    monkeypatch.setattr(launch, "command", lambda _: ["/nowhere/java"])
    with pytest.raises(RsalError, match="'/nowhere/java' cannot be started"):
        Worlds(spec, [1])


def test_closed_environments_do_not_begin_by_themselves(scenario: str) -> None:
    vector = _worlds(scenario)
    parallel = env.parallel_env(scenario, learners="learner")
    single = env.single_env(scenario, learners="learner", arguments={"count": 1})
    every: list[tuple[Any, Any]] = [(vector, np.zeros((1, 2, 2))), (parallel, {}), (single, np.zeros(2))]
    for made, still in every:
        with pytest.raises(RsalError, match=r"No episode has begun. Call reset\(\)"):
            made.step(still)
        made.reset(seed=1)
        made.close()
        with pytest.raises(RsalError, match=r"closed. Call reset\(\)"):
            made.step(still)
        assert made._episodes._worlds is None
    assert parallel.possible_agents == ["learner-1", "learner-2"]
    assert parallel._episodes._worlds is None
    seen, _ = vector.reset(seed=1)
    assert seen.shape == (1, 2, 39)
    vector.close()
    with pytest.raises(RsalError, match="closed"):
        parallel.state()


def test_an_episode_that_is_over_does_not_go_on(scenario: str) -> None:
    single = env.single_env(scenario, learners="learner", arguments={"count": 1}, max_steps=2)
    single.reset(seed=1)
    assert [single.step(np.zeros(2))[3] for _ in range(2)] == [False, True]
    with pytest.raises(RsalError, match=r"over. Call reset\(\)"):
        single.step(np.zeros(2))
    single.reset()
    assert not single.step(np.zeros(2))[3]
    single.close()
    stays = _worlds(scenario, max_steps=1, autoreset=False)
    stays.reset(seed=1)
    assert stays.step(np.zeros(stays.action_shape))[3].all()
    with pytest.raises(RsalError, match="over"):
        stays.step(np.zeros(stays.action_shape))
    stays.close()


_AGENT = """
from rsal.agents import Agent

class Other(Agent):
    def on_start(self):
        self.after(0.5, self.late)

    def late(self):
        {does}
"""


def _with_agent(folder: Path, does: str) -> str:
    (folder / "late.py").write_text(_AGENT.format(does=does), encoding="utf-8")
    file = folder / "failing.yaml"
    text = """
rsal: 1
scenario: failing
world: {map: office}
robots:
  learner: {model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx}}
  other: {model: pioneer2dx, pose: [-20, 4, 0], devices: {laser: urg04lx}}
agents:
  late: {type: late.py, robot: other}
"""
    file.write_text(text, encoding="utf-8")
    return str(file)


def test_agents_that_fail_are_told(tmp_path: Path) -> None:
    scenario = _with_agent(tmp_path, "raise ValueError('no way')")
    made = env.single_env(scenario, learners="learner", max_steps=10)
    made.reset(seed=1)
    with pytest.warns(RuntimeWarning, match="Agent 'late' failed .*no way"):
        infos = [made.step(np.zeros(2))[-1] for _ in range(10)]
    assert "no way" in infos[-1]["failed"]["late"]
    assert infos[:-1] == [{}] * 9
    made.close()


def test_an_agent_that_never_returns_ends_the_process_and_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    command = launch.command
    monkeypatch.setattr(launch, "command", lambda words: command([*words, "--patience", "2"]))
    made = _worlds(_with_agent(tmp_path, "while True: pass"), steps=10)
    made.reset(seed=1)
    with pytest.raises(env.RsalCrashed, match=r"Agent 'late' has not returned for 2 s; it is at late\.py:9 in late"):
        made.step(np.zeros(made.action_shape))
    made.close()


def test_the_team_ends_as_its_scenario_says(team: Callable[..., str]) -> None:
    made = env.make_vec(team("time >= 0.5", "success"), num_envs=2, learners="learner", threads=2)
    made.reset(seed=1)
    while True:
        _, _, terminated, truncated, infos = made.step(np.zeros(made.action_shape))
        if infos:
            break
    assert terminated.all()
    assert not truncated.any()
    assert [ending["failed"] for ending in infos["episodes"].values()] == [{}, {}]
    made.close()

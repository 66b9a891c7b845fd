"""Tasks to learn: the suites of Gymnasium and PettingZoo, and scores that a random policy does not reach."""

from __future__ import annotations

import pickle
import re
import subprocess
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import parallel_api_test

from rsal import RsalError, launch
from rsal.agents.network import Network
from rsal.agents.policy import Model, PolicyAgent
from rsal.env import tasks
from rsal.env.tasks import TASKS, Task

_LEARNED = [task for task in TASKS.values() if task.learned() is not None]
_DRIVING = [task for task in _LEARNED if "\n  learned:" in task.file.read_text(encoding="utf-8")]
"""Those whose policies can be agents: that of Patrol cannot, as it observes the truth about the whole team."""


def _short(task: Task) -> dict[str, Any]:
    """Return what keeps episodes of a task short: Patrol plans paths for robots that localize themselves."""
    return {"max_steps": 5 if task.steps == 2 else 2}


@pytest.mark.parametrize("name", TASKS)
def test_gymnasium_accepts_it(name: str) -> None:
    made = gymnasium.make(f"rsal/{name}-v0", **_short(TASKS[name]))
    check_env(made.unwrapped, skip_render_check=True, skip_close_check=True)
    assert made.observation_space.shape == (len(made.unwrapped.fields),)  # type: ignore[attr-defined]
    made.close()


def test_gymnasium_shows_pictures_in_a_window(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pygame", reason="pygame is not installed")
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")  # a window that nobody sees
    made: Any = gymnasium.make("rsal/Formation-v0", render_mode="human", **_short(TASKS["Formation"]))
    made.reset(seed=1)
    made.step(made.action_space.sample())
    window = made.screen_size
    made.close()
    alone = gymnasium.make("rsal/Formation-v0", render_mode="rgb_array")
    alone.reset(seed=1)
    picture: Any = alone.render()
    alone.close()
    assert window == picture.shape[1::-1]


def test_pettingzoo_accepts_it() -> None:
    task = TASKS["Pursuit"]
    team = task.parallel_env(**_short(task))
    parallel_api_test(team, num_cycles=12)
    assert team.metadata["name"] == "rsal/Pursuit-v0"
    team.close()


def test_one_agent_acts_for_the_whole_team() -> None:
    made = TASKS["Pursuit"].gym_env(max_steps=10)
    together, _ = made.reset(seed=3)
    apart = TASKS["Pursuit"].parallel_env(max_steps=10)
    each, _ = apart.reset(seed=3)
    np.testing.assert_array_equal(together, np.concatenate(list(each.values())))
    together, reward, *_ = made.step(np.array([0.5, 0, 0.2, 1], np.float32))
    actions = {"hunter-1": np.array([0.5, 0]), "hunter-2": np.array([0.2, 1])}
    each, rewards, *_ = apart.step(actions)
    np.testing.assert_array_equal(together, np.concatenate(list(each.values())))
    assert reward == pytest.approx(np.mean(list(rewards.values())))
    copied = pickle.loads(pickle.dumps(made))  # noqa: S301 - it was made here
    assert copied.action_space == made.action_space
    copied.close()
    made.close()
    apart.close()


def test_a_task_that_is_not_there_is_named() -> None:
    with pytest.raises(RsalError, match=r"no task 'Pursiut'. Tasks are .*Pursuit"):
        tasks.make("Pursiut")
    with pytest.raises(RsalError, match="no scripted agents"):
        TASKS["Foraging"].evaluate_scripted(seeds=range(1))


def test_a_policy_by_hand_brings_cans_home_and_a_random_one_does_not() -> None:
    task = TASKS["Foraging"]
    assert task.by_hand is not None
    brought = [ending["score"] for ending in task.evaluate(task.by_hand, seeds=range(1, 4))]
    assert np.mean(brought) >= 3
    by_chance = task.evaluate(task.at_random(), seeds=range(1, 4))
    assert np.mean([ending["score"] for ending in by_chance]) <= 1


@pytest.mark.parametrize("task", _LEARNED, ids=lambda task: str(task.name))
def test_a_shipped_policy_reaches_what_a_random_one_does_not(task: Task) -> None:
    learned = task.learned()
    assert learned is not None
    good, bad = (
        np.mean([ending["score"] for ending in task.evaluate(policy, seeds=range(1, 7))])
        for policy in (learned, task.at_random())
    )
    assert good < 0.9 * bad if task.better == "less" else good > 1.1 * bad


@pytest.mark.parametrize("task", _DRIVING, ids=lambda task: str(task.name))
def test_a_policy_acts_as_an_agent_as_it_does_in_its_environment(task: Task, tmp_path: Path) -> None:
    """The same scenario by 'rsal run', with an agent that prints what it observes and does, bit by bit."""
    for file in task.file.parent.glob("*.yaml"):
        (tmp_path / file.name).write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
    name = f"{task.name.lower()}_policy"
    for module in task.file.parent.glob("*_policy.py"):
        (tmp_path / module.name).write_text(module.read_text(encoding="utf-8"), encoding="utf-8")
    with (tmp_path / f"{name}.py").open("a", encoding="utf-8") as out:
        out.write(
            "    def decide(self, observation):\n"
            "        action = self.network(observation).astype('float32')\n"
            "        print('decided', self.robot.id, observation.tobytes().hex(), action.tobytes().hex())\n"
            "        return action\n"
        )
    scenario = f"{tmp_path / task.file.name}:learned"
    command = launch.command(["run", scenario, "--headless", "--speed", "max", "--seed", "5", "--for", "4"])
    ended = subprocess.run(command, env=launch.environment(), capture_output=True, text=True, check=True)
    ran = ended.stdout + ended.stderr
    decided: dict[str, list[tuple[str, str]]] = {}
    for robot, seen, did in re.findall(r"decided (\S+) ([0-9a-f]+) ([0-9a-f]+)", ran):
        decided.setdefault(robot, []).append((seen, did))
    learned = task.learned()
    assert learned is not None
    made = task.parallel_env()
    observations, _ = made.reset(seed=5)
    for step in range(15):
        actions = {}
        for robot, observation in observations.items():
            actions[robot] = learned(observation).astype(np.float32)
            assert decided[robot][step] == (observation.tobytes().hex(), actions[robot].tobytes().hex()), step
        observations, *_ = made.step(actions)
    made.close()


@pytest.mark.parametrize("task", _LEARNED, ids=lambda task: str(task.name))
def test_what_an_agent_observes_is_what_its_task_declares(task: Task) -> None:
    from importlib import import_module  # noqa: PLC0415 - of policies only

    module = import_module(f"rsal.env.tasks.{task.name.lower()}_policy")
    agent: type[PolicyAgent] = getattr(module, f"{task.name}Policy")
    assert list(agent.observe) == list(task.observe)
    assert agent.act == task.act
    assert agent.period == pytest.approx(task.steps / 10)


def test_a_model_in_onnx_acts_as_the_network_that_it_was_made_of(tmp_path: Path) -> None:
    onnx = pytest.importorskip("onnx")
    pytest.importorskip("onnxruntime")
    network = tasks.NAVIGATION.learned()
    assert isinstance(network, Network)
    make, tensor = onnx.helper.make_node, onnx.numpy_helper.from_array
    constants = {"scale": network.scale, "least": np.array(-1), "most": np.array(1)}
    constants |= {"half": (network.high - network.low) / 2, "middle": (network.high + network.low) / 2}
    nodes = [make("Div", ["seen", "scale"], ["scaled"]), make("Clip", ["scaled", "least", "most"], ["in0"])]
    for number, layer in enumerate(network.layers):
        constants |= {f"w{number}": layer[:, :-1], f"b{number}": layer[:, -1]}
        nodes.append(make("Gemm", [f"in{number}", f"w{number}", f"b{number}"], [f"sum{number}"], transB=1))
        nodes.append(make("Tanh", [f"sum{number}"], [f"in{number + 1}"]))
    nodes += [make("Mul", [f"in{len(network.layers)}", "half"], ["spread"]), make("Add", ["spread", "middle"], ["act"])]
    value = onnx.helper.make_tensor_value_info
    graph = onnx.helper.make_graph(
        nodes,
        "navigation",
        [value("seen", onnx.TensorProto.FLOAT, [1, len(network.scale)])],
        [value("act", onnx.TensorProto.FLOAT, [1, 2])],
        [tensor(np.asarray(each, np.float32), name) for name, each in constants.items()],
    )
    opset = onnx.helper.make_opsetid("", 17)
    onnx.save(onnx.helper.make_model(graph, opset_imports=[opset], ir_version=8), tmp_path / "navigation.onnx")
    agent = PolicyAgent.__new__(PolicyAgent)
    agent._model = Model(str(tmp_path / "navigation.onnx"))
    for seed in range(5):
        seen = np.random.default_rng(seed).uniform(-3, 3, len(network.scale)).astype(np.float32)
        np.testing.assert_allclose(agent.decide(seen), network(seen), atol=1e-5)
    with pytest.raises(FileNotFoundError, match=r"no model 'nowhere\.onnx'"):
        Model("nowhere.onnx")

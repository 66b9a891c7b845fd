"""The process of agents, as RSAL sees it: frames go in, frames come out."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import rsal
from rsal.protocol import Frames

HOME = str(Path(rsal.__file__).parents[1])
BEGIN = [
    sys.executable,
    "-c",
    "import sys; sys.path[0] = sys.argv[1]; from rsal.agents.process import main; main()",
    HOME,
]


BASE = [{"index": 0, "name": "base", "contract": "DriveBase"}]


class Java:
    """What RSAL's other side does: it starts agents, tells them what happens, and answers questions with ``None``."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(
            BEGIN, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
        )
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.frames = Frames(self.process.stdout, self.process.stdin)  # type: ignore[arg-type]
        self.asked: list[Any] = []
        self.count = 0
        assert self._read()["protocol"] == 1

    def _read(self) -> dict[str, Any]:
        frame = self.frames.read()
        assert frame is not None, self.process.communicate()[1].decode()
        return frame[0]

    def exchange(self, turn: dict[str, Any] | None, ended: list[int] | None = None) -> dict[str, Any]:
        """Return how a turn ended, with all that the agent asked for in it."""
        self.frames.write({"time": 0.0, "ended": ended or [], "turns": [] if turn is None else [turn]})
        done: list[Any] = []
        while True:
            words = self._read()
            if "ask" in words:
                done += words["do"]
                self.asked.append(words["ask"])
                self.frames.write({"value": None})
            elif turn is None:
                assert words["turns"] == []
                return {}
            elif words["turns"]:
                (over,) = words["turns"]
                return {**over, "do": done + over["do"]}

    def start(self, body: str, devices: list[dict[str, Any]] = BASE) -> dict[str, Any]:
        """Start one more agent."""
        self.count += 1
        module = f"agent{self.count}"
        text = "import asyncio\nimport numpy as np\nimport rsal\nfrom rsal.agents import Pose2d\nclass A(rsal.Agent):\n"
        start = {
            "files": {f"{module}.py": text + textwrap.indent(textwrap.dedent(body), "    ")},
            "folder": "",
            "module": module,
            "class": "A",
            "name": module,
            "role": "tested",
            "seed": 1,
            "simulation": False,
            "robot": {
                "id": "r",
                "role": "r",
                "model": "m",
                "devices": devices,
            },
            "arguments": {},
        }
        return self.exchange({"agent": self.count, "start": start})

    def tell(self, agent: int, number: int, value: Any = None) -> dict[str, Any]:
        return self.exchange({"agent": agent, "events": [{"id": number, "value": value}]})


@pytest.fixture
def java() -> Iterator[Java]:
    java = Java()
    yield java
    java.process.kill()
    java.process.communicate()


def lines(turn: dict[str, Any]) -> list[str]:
    return [each[2] for each in turn["do"] if each[0] == "print"]


HEALTHY = """
    def on_start(self):
        print("begins")
        self.every(1.0, self.beat)
    def beat(self):
        print("beats")
"""


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("self.send(self.robot, rsal.Topic('t', dict), {})", "TypeError: A message goes to the name of an agent"),
        ("self._link.do('show', 'x', object())", "TypeError: A value of type 'object' cannot be sent."),
        ("self.publish(rsal.Topic('t', dict), {'a': '\\udcff'})", "UnicodeEncodeError: "),
        ("self.ask('b', 's', {'a': print})", "TypeError: A value of type 'builtin_function_or_method' cannot be sent."),
        ("self.call('s', {}, 'amy', least='x')", "TypeError: A call goes to a list of names, not to the text 'amy'."),
        ("self.show('x', 'y' * 20_000_000)", "ValueError: An agent cannot send 20000"),
        ("raise asyncio.CancelledError('so')", "CancelledError: so"),
        ("raise GeneratorExit", "GeneratorExit"),
        ("raise KeyboardInterrupt", "KeyboardInterrupt"),
        ("raise SystemExit(3)", "SystemExit: 3"),
        ("raise ValueError('\\udcff')", "ValueError: \\udcff"),
    ],
)
def test_what_one_agent_throws_or_cannot_send_ends_it_alone(java: Java, line: str, words: str) -> None:
    java.start(HEALTHY)
    ended = java.start(f"def on_start(self):\n    {line}\n")
    assert ended["failed"]["message"].startswith(f"agent2.py:7 in on_start: {words}")
    assert lines(java.tell(1, 1)) == ["beats"]


def test_what_cannot_be_sent_can_be_caught_where_it_is_said(java: Java) -> None:
    said = java.start("""
        def on_start(self):
            try:
                self.publish(rsal.Topic("t", dict), {"a": object()})
            except TypeError:
                print("caught")
            self.publish(rsal.Topic("t", dict), {"a": np.int64(3), "b": np.float32(0.5), "c": np.arange(2)})
    """)
    assert lines(said) == ["caught"]
    assert said["do"][1][2:] == ["t", {"a": 3, "b": 0.5, "c": [0, 1]}]


def test_printed_text_may_have_any_character(java: Java) -> None:
    assert lines(java.start('def on_start(self):\n    print("a\\udcffb")\n    print("ä€", end="")\n')) == [
        "a\\udcffb",
        "ä€",
    ]


def test_finally_blocks_of_an_agent_that_has_ended_ask_for_nothing(java: Java) -> None:
    java.start(HEALTHY)
    java.start("""
        async def on_start(self):
            try:
                await self.sleep(100)
            finally:
                self.robot.base.stop()
                print(self.robot.base.latest)
    """)
    java.exchange(None, ended=[2])
    assert lines(java.tell(1, 1)) == ["beats"]
    assert java.asked == []


def test_many_long_turns_go_in_several_frames(java: Java) -> None:
    for _ in range(4):
        java.start("""
            def on_start(self):
                self.every(1.0, self.beat)
            def beat(self):
                self.show("x", "y" * 15_000_000)
        """)
    java.frames.write(
        {
            "time": 0.0,
            "ended": [],
            "turns": [{"agent": each, "events": [{"id": 1, "value": None}]} for each in (1, 2, 3, 4)],
        }
    )
    over: list[int] = []
    frames = 0
    while len(over) < 4:
        frames += 1
        over += [each["agent"] for each in java._read()["turns"]]
    assert over == [1, 2, 3, 4]
    assert frames == 2
    assert "failed" not in java.exchange({"agent": 1, "stop": True})


def test_ctrl_c_of_the_terminal_is_for_rsal(java: Java) -> None:
    java.start("""
        def on_start(self):
            self.every(1.0, self.beat)
        def beat(self):
            import time
            print("busy")
            time.sleep(0.3)
        def on_stop(self):
            print("stops")
    """)
    os.killpg(java.process.pid, signal.SIGINT)
    time.sleep(0.1)
    assert lines(java.tell(1, 1)) == ["busy"]
    assert lines(java.exchange({"agent": 1, "stop": True})) == ["stops"]


NAVIGATOR = [{"index": 0, "name": "navigator", "contract": "Navigator"}]

DRIVES = """
    def on_start(self):
        goal = self.robot.navigator.go_to(Pose2d(1, 2, 3))
        goal.on_feedback(self.on_feedback)
        goal.on_result(self.on_arrival)
    def on_feedback(self, progress):
        print("feedback", progress.value.remaining)
    async def on_arrival(self, result):
        print("arrived", type(result).__name__)
        await self.sleep(1.0)
        print("rests")
"""


def test_listeners_may_be_async_and_reports_end_with_their_goal(java: Java) -> None:
    begun = java.start(DRIVES, NAVIGATOR)
    (_, _, goal, *_), (_, _, _, reports) = begun["do"]
    here = {"x": 0, "y": 0, "theta": 0}
    progress = {"mapFromBase": here, "remaining": 2.5, "waypoint": here, "driving": 0}
    report = {"time": 0.0, "frame": "map", "value": progress}
    assert lines(java.tell(1, reports, report)) == ["feedback 2.5"]
    ended = java.tell(1, goal, {"value": {"type": "Reached", "mapFromBase": here, "doubt": ""}})
    assert lines(ended) == ["arrived NavigatorReached"]
    assert ["cancel", reports] in [[each[0], each[2]] for each in ended["do"]]
    (sleeps,) = [each[2] for each in ended["do"] if each[0] == "after"]
    assert lines(java.tell(1, reports, report)) == []
    assert lines(java.tell(1, sleeps)) == ["rests"]


def test_a_request_that_fails_is_an_error_where_it_is_waited_for(java: Java) -> None:
    asked = java.start(
        """
        async def on_start(self):
            try:
                await self.robot.navigator.go_to(Pose2d(1, 2, 3))
            except rsal.RsalError as error:
                print("no:", error)
            await self.robot.navigator.go_to(Pose2d(1, 2, 3))
        """,
        NAVIGATOR,
    )
    again = java.tell(1, asked["do"][0][2], {"error": "The robot is gone.", "place": ""})
    assert lines(again) == ["no: The robot is gone."]
    ended = java.tell(1, again["do"][1][2], {"error": "The robot is gone.", "place": ""})
    assert ended["failed"]["message"] == "agent1.py:12 in on_start: RsalError: The robot is gone."

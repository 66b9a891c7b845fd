"""A debugger on the terminal: RSAL learns of it, and the agent goes on when the person does."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import pytest

import rsal
from rsal.protocol import Frames

pty = pytest.importorskip("pty", reason="NOT CHECKED: a debugger needs a terminal, which Windows has otherwise")

AGENT = """\
import rsal

class A(rsal.Agent):
    def on_start(self):
        secret = 41
        breakpoint()
        print("goes on with", secret)
"""


def _start(file: str, text: str) -> dict[str, Any]:
    start = {
        "files": {file: text},
        "folder": "",
        "module": file.removesuffix(".py"),
        "class": "A",
        "name": "amy",
        "role": "tested",
        "seed": 1,
        "simulation": False,
        "robot": None,
        "arguments": {},
    }
    return {"time": 0.0, "ended": [], "turns": [{"agent": 1, "start": start}]}


def _until(terminal: int, words: str) -> str:
    said = ""
    while words not in said:
        said += os.read(terminal, 1000).decode()
    return said


@pytest.mark.skipif(sys.platform == "win32", reason="has no terminals of this kind")
def test_breakpoint_is_a_conversation_on_the_terminal() -> None:
    events, to_agent = os.pipe()
    from_agent, answers = os.pipe()
    from_errors, errors = os.pipe()
    child, terminal = pty.fork()
    if child == 0:
        os.set_inheritable(os.dup(0), True)  # the terminal: it ends when nobody has it open
        for descriptor, of in ((events, 0), (answers, 1), (errors, 2)):
            os.dup2(descriptor, of)
        home = str(Path(rsal.__file__).parents[1])
        program = "import sys; sys.path[0] = sys.argv[1]; from rsal.agents.process import main; main()"
        os.execv(sys.executable, [sys.executable, "-c", program, home])  # noqa: S606 - this very Python
    for descriptor in (events, answers, errors):
        os.close(descriptor)
    try:
        frames = Frames(os.fdopen(from_agent, "rb"), os.fdopen(to_agent, "wb"))
        hello = frames.read()
        assert hello is not None
        assert "error" not in hello[0]
        frames.write(_start("amy.py", AGENT))
        assert os.read(from_errors, 100) == b"\x01debug\n"
        assert "amy.py(7)on_start()" in _until(terminal, "(Pdb)")
        os.write(terminal, b"p secret + 1\n")
        assert "42" in _until(terminal, "(Pdb)")
        os.write(terminal, b"c\n")
        answer = frames.read()
        assert answer is not None
        (turn,) = answer[0]["turns"]
        assert "failed" not in turn
        assert [each[2] for each in turn["do"]] == ["goes on with 41"]
    finally:
        os.kill(child, 9)
        os.waitpid(child, 0)
        os.close(terminal)

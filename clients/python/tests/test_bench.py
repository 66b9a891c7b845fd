"""What ``rsal bench python`` reads from the program in Python, whatever other packages print."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

_NOISY = """
import os
import subprocess
import sys

print("a word of a package")
os.write(1, b"a word of a library in C")
subprocess.run([sys.executable, "-c", "print('a word of a child')"], check=True)


class World:
    def step(self):
        print("a step")

    def end(self):
        print("the end, drawn by", os.environ["MPLBACKEND"])


def make(*_, **__):
    return World()
"""
_BRIEF = """
from rsal import _bench

_bench._WARM = _bench._PATIENCE = _bench._MEASURED = 0.01
_bench._WARM_STEPS = 1
_bench.main()
"""


def test_what_other_packages_print_is_not_in_the_results(tmp_path: Path) -> None:
    (tmp_path / "irsim.py").write_text(_NOISY, encoding="utf-8")
    program = tmp_path / "brief.py"  # its folder is on the path, and so is that package
    program.write_text(_BRIEF, encoding="utf-8")
    name = "python.peer.irsim.10.agents"
    asked = json.dumps({"wanted": [name], "repeats": 2, "episodes": 1, "command": []})
    done = subprocess.run([sys.executable, str(program)], input=asked, capture_output=True, text=True, check=True)
    (line,) = done.stdout.splitlines()
    told = json.loads(line)
    assert told["name"] == name
    assert len(told["values"]) == 2
    for word in ("of a package", "in C", "of a child", "a step", "drawn by Agg"):
        assert word in done.stderr

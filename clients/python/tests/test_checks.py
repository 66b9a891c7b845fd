"""Types and style, as tests, so that they are counted and named like all others."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

_FOLDER = Path(__file__).parents[1]


@pytest.mark.parametrize("command", ["mypy", "ruff check", "ruff format --check"])
def test_it_has_no_complaints(command: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-m", *command.split()], cwd=_FOLDER, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr

"""Modules in files of a scenario, and of another one that joins it."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator

import pytest

from rsal.agents.worker import Files


@pytest.fixture
def files() -> Iterator[Files]:
    known = set(sys.modules)
    finder = Files()
    sys.meta_path.insert(0, finder)
    yield finder
    sys.meta_path.remove(finder)
    for name in set(sys.modules) - known:
        del sys.modules[name]


FIRST = {
    "hunter_a.py": "import helper_a, parts_a.deep\nfrom parts_a import scan\nWORDS = [helper_a.WORD, scan.WORD]",
    "helper_a.py": "WORD = 'first helper'",
    "parts_a/__init__.py": "",
    "parts_a/scan.py": "from .deep import WORD",
    "parts_a/deep.py": "WORD = 'first deep'",
}


def test_folders_are_packages(files: Files) -> None:
    assert files.add("", FIRST) == ""
    assert importlib.import_module("hunter_a").WORDS == ["first helper", "first deep"]
    assert importlib.import_module("parts_a.scan").WORD == "first deep"


def test_files_of_one_name_from_two_folders_are_two_modules(files: Files) -> None:
    second = {path: text.replace("first", "second") for path, text in FIRST.items()}
    assert files.add("", FIRST) == ""
    prefix = files.add("", second)
    assert prefix
    assert importlib.import_module("hunter_a").WORDS == ["first helper", "first deep"]
    module = importlib.import_module(prefix + "hunter_a")
    assert module.WORDS == ["second helper", "second deep"]
    assert module.__spec__ is not None
    assert module.__spec__.origin == "hunter_a.py"
    assert files.add("", {"helper_a.py": second["helper_a.py"]}) == prefix
    assert files.add("", {"helper_a.py": FIRST["helper_a.py"]}) == ""


def test_an_agent_has_no_modules_of_another_folder(files: Files) -> None:
    files.add("a/", {"a/guard_a.py": "", "a/helper_a.py": ""})
    prefix = files.add("b/", {"b/guard_b.py": ""})
    importlib.import_module("guard_a")
    importlib.import_module(prefix + "guard_b")
    with pytest.raises(ImportError, match="helper_a"):
        importlib.import_module(prefix + "helper_a")

from __future__ import annotations

import ast
import importlib
import json
import subprocess
import sys
from pathlib import Path

import pytest

import rsal
from rsal import agents, launch

_IMPORT = """
import json, sys, time
before = set(sys.modules)
begun = time.process_time()
import rsal
spent = time.process_time() - begun
print(json.dumps([spent, sorted(set(sys.modules) - before)]))
"""


def _imported() -> tuple[float, list[str]]:
    text = subprocess.run([sys.executable, "-c", _IMPORT], check=True, capture_output=True, text=True).stdout
    spent, modules = json.loads(text)
    return spent, modules


def test_importing_it_is_fast_and_loads_nothing() -> None:
    spent, modules = min(_imported() for _ in range(3))
    assert spent <= 0.05  # s of the processor
    assert not {"numpy", "pandas", "subprocess", "rsal.launch", "rsal.studies"} & set(modules)


@pytest.mark.parametrize("name", sorted(rsal._NAMES))
def test_each_name_is_in_its_module(name: str) -> None:
    assert getattr(rsal, name) is getattr(importlib.import_module(rsal._NAMES[name]), name)
    assert name in dir(rsal)


def test_names_for_type_checkers_are_those_of_the_table() -> None:
    tree = ast.parse(Path(rsal.__file__).read_text(encoding="utf-8"))
    (block,) = (node for node in tree.body if isinstance(node, ast.If))
    imported = {
        alias.asname: node.module for node in block.body if isinstance(node, ast.ImportFrom) for alias in node.names
    }
    assert imported == rsal._NAMES


def test_a_name_that_is_not_there_is_an_error_that_lists_the_others() -> None:
    with pytest.raises(AttributeError, match=r"no name 'runn'.*sweep"):
        getattr(rsal, "runn")  # noqa: B009 - type checkers know that it is not there


def test_its_version_is_that_of_the_project() -> None:
    project = (Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8")
    assert f'version = "{rsal.__version__}"' in project


def test_it_is_typed() -> None:
    assert (Path(rsal.__file__).parent / "py.typed").is_file()


def test_errors_of_agents_are_those_of_studies_and_need_nothing_else() -> None:
    assert rsal.RsalError is agents.RsalError
    assert rsal.RsalError is launch.RsalError
    words = "import sys, rsal; rsal.RsalError; print('rsal.launch' in sys.modules)"  # a jar has no launch
    text = subprocess.run([sys.executable, "-c", words], check=True, capture_output=True, text=True).stdout
    assert text.strip() == "False"

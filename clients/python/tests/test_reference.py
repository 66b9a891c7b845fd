"""The reference of rsal.studies and rsal.env is made of its docstrings: RSAL_UPDATE=true writes it again."""

from __future__ import annotations

import ast
import dataclasses
import inspect
import itertools
import os
import re
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import cast

from rsal import env, studies
from rsal.agents import messages
from rsal.env import tasks

_FILE = Path(__file__).resolve().parents[3] / "docs" / "reference" / "python.md"

_HEAD = """# Python: studies

This page describes the functions and classes of the package `rsal` for studies. [Python](../how-to/python.md) shows how
to install and use it. It is made of the docstrings of `rsal.studies`; `rsal.run` and the other functions are the same
under shorter names.

Lengths are in m, angles in rad (counter-clockwise), times in s, and poses in the map frame.
"""

_ENVIRONMENTS = _FILE.with_name("python-environments.md")

_ENVIRONMENTS_HEAD = """# Python: learning environments

This page describes `rsal.env`, which makes a scenario an environment of PettingZoo or Gymnasium. It is made of the
docstrings. `pip install "rsal[env]"` installs what it needs.

Lengths are in m, angles in rad (counter-clockwise), times in s, and poses in the map frame.
"""


def _text(documented: object) -> str:
    """Return a docstring as Markdown: sections become lists."""
    lines: list[str] = []
    in_list = False
    for line in (inspect.getdoc(documented) or "").splitlines():
        item = re.match(r"    (\w+): (.*)", line)
        parameter = re.match(r":param (\w+): (.*)", line)
        if re.fullmatch(r"(Args|Attributes|Raises):", line):
            in_list = True
            lines += [line, ""] if line != "Args:" else []
        elif parameter:
            lines.append(f"* `{parameter.group(1)}`: {parameter.group(2)}")
        elif in_list and item:
            lines.append(f"* `{item.group(1)}`: {item.group(2)}")
        elif in_list and line.startswith("        "):
            lines.append(f"  {line.strip()}")
        else:
            in_list = in_list and not line
            lines.append(line)
    return re.sub(r"``([^`]*)``|:\w+:`([^`]*)`", r"`\1\2`", "\n".join(lines)).strip()


def _parameters(function: object, *, method: bool) -> list[str]:
    """Return parameters as they are written, annotations being texts."""
    assert callable(function)
    written: list[str] = []
    for parameter in list(inspect.signature(function).parameters.values())[1 if method else 0 :]:
        stars = "**" if parameter.kind is parameter.VAR_KEYWORD else ""
        if parameter.kind is parameter.KEYWORD_ONLY and "*" not in written:
            written.append("*")
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}".replace("'", '"')
        written.append(f"{stars}{parameter.name}: {parameter.annotation}{default}")
    return written


def _result(function: object) -> str:
    assert callable(function)
    return str(inspect.signature(function).return_annotation)


def _signature(name: str, function: object) -> str:
    return f"{name}({', '.join(_parameters(function, method=True))}) -> {_result(function)}"


def _fields(of: type) -> list[str]:
    """Return the fields of a dataclass whose texts are below them, as a list."""
    if not dataclasses.is_dataclass(of) or "Attributes:" in (of.__doc__ or ""):
        return []
    body = cast(ast.ClassDef, ast.parse(inspect.getsource(of)).body[0]).body
    lines = []
    for field, after in itertools.pairwise([*body, ast.Pass()]):
        if isinstance(field, ast.AnnAssign):
            said = ""
            if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
                said = re.sub(r"``([^`]*)``|:\w+:`([^`]*)`", r"`\1\2`", f": {after.value.value!s}")
            lines.append(f"* `{ast.unparse(field.target)}: {ast.unparse(field.annotation)}`{said}")
    return ["\n".join([*lines, ""])]


def _members(of: type) -> Iterator[str]:
    """Describe its own members, and those that it inherits from classes of the package."""
    members: dict[str, object] = {}
    for base in reversed(of.__mro__):
        if base.__module__.startswith("rsal."):
            members.update(vars(base))
    for name, member in members.items():
        documented = getattr(member, "func", member)  # of a cached property
        if name.startswith("_") or not (inspect.getdoc(documented) and hasattr(documented, "__doc__")):
            continue
        if inspect.isfunction(member):
            yield f"### `{_signature(f'{of.__name__}.{name}', member)}`\n\n{_text(member)}\n"
        elif isinstance(member, staticmethod):
            written = ", ".join(_parameters(member.__func__, method=False))
            yield f"### `{of.__name__}.{name}({written}) -> {_result(member.__func__)}`\n\n{_text(member.__func__)}\n"
        elif isinstance(member, property) or documented is not member:
            yield f"### `{of.__name__}.{name}`\n\n{_text(documented)}\n"


def _reference(module: ModuleType = studies, head: str = _HEAD, prefix: str = "rsal") -> str:
    functions = sorted(name for name in module.__all__ if inspect.isfunction(getattr(module, name)))
    classes = sorted(name for name in module.__all__ if inspect.isclass(getattr(module, name)))
    parts = [head]
    for name in functions:
        function = getattr(module, name)
        parts.append(f"## {prefix}.{name}\n\n```python\n{_wrapped(name, function)}\n```\n\n{_text(function)}\n")
    for name in classes:
        described = getattr(module, name)
        parts.append(f"## {name}\n\n{_text(described)}\n")
        parts += _fields(described)
        parts += _members(described)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(parts))


def _wrapped(name: str, function: object) -> str:
    """Return a signature with a parameter a line."""
    lines = "".join(f"    {each},\n" for each in _parameters(function, method=False))
    return f"{name}(\n{lines}) -> {_result(function)}"


def test_it_is_that_of_the_docstrings() -> None:
    text = _reference()
    if os.environ.get("RSAL_UPDATE") == "true":
        _FILE.write_text(text, encoding="utf-8")
    assert _FILE.read_text(encoding="utf-8") == text, (
        "Write it by: RSAL_UPDATE=true python -m pytest tests/test_reference.py"
    )


def _tasks() -> str:
    """Return what the declarations of the tasks say, and their module."""
    lines = ["# Tasks", "", "| Task | Learners | They observe | They do | Score of an episode | Steps | Held out |"]
    lines.append("|---|---|---|---|---|---|---|")
    for task in tasks.TASKS.values():
        seen = ", ".join(f"`{each['type']}`" for each in task.observe)
        held = ", ".join(f"`{each}`" for each in task.held_out)
        lines.append(
            f"| `rsal/{task.name}-v0` | `{task.learners}` | {seen} | `{task.act['type']}` | "
            f"{task.score}; {task.better} is better | {task.max_steps} of {task.steps / 10} s | {held} |"
        )
    head = "\n".join(lines).replace("# Tasks", "## Tasks", 1)
    return _reference(tasks, f"{head}\n", "rsal.env.tasks")


def test_that_of_environments_is_that_of_the_docstrings() -> None:
    text = f"{_reference(env, _ENVIRONMENTS_HEAD, 'rsal.env')}\n{_tasks()}"
    if os.environ.get("RSAL_UPDATE") == "true":
        _ENVIRONMENTS.write_text(text, encoding="utf-8")
    assert _ENVIRONMENTS.read_text(encoding="utf-8") == text


_MESSAGES = _FILE.with_name("python-messages.md")

_MESSAGES_HEAD = """# Python: messages

This page lists the classes of `rsal.agents.messages` by topic. A class names its topic where one is asked for:
`self.subscribe(PoseReport, self.on_pose)` hears `pose`, and `self.publish(PoseReport(...))` says it.
[Messages](messages.md) describes them for all languages. Lengths are in m, angles in rad, times in s.

| Topic | Class | Fields |
|---|---|---|
"""


def _messages() -> str:
    """Return a row for each topic."""
    rows = []
    for kind in vars(messages).values():
        if dataclasses.is_dataclass(kind) and isinstance(kind, type) and hasattr(kind, "topic"):
            fields = ", ".join(
                f"`{field.name}: {field.type}`".replace("|", "\\|") for field in dataclasses.fields(kind)
            )
            rows.append(f"| `{kind.topic}` | `{kind.__name__}` | {fields or 'none'} |")
    return _MESSAGES_HEAD + "\n".join(sorted(rows)) + "\n"


def test_that_of_messages_has_all_topics() -> None:
    text = _messages()
    if os.environ.get("RSAL_UPDATE") == "true":
        _MESSAGES.write_text(text, encoding="utf-8")
    assert _MESSAGES.read_text(encoding="utf-8") == text


def test_all_that_is_public_has_a_docstring() -> None:
    for name in studies.__all__:
        assert (inspect.getdoc(getattr(studies, name)) or "").strip(), name

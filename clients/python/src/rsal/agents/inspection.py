"""Reads what the file of an agent says of it, without running it."""

from __future__ import annotations

import ast
import difflib
import sys
from importlib.abc import InspectLoader
from importlib.machinery import ModuleSpec
from typing import Any

from rsal.protocol import Frames

KINDS = {"float": "NUMBER", "int": "INTEGER", "str": "TEXT", "bool": "FLAG"}
BASES = {"Agent", "PolicyAgent"}
"""Names of the classes that agents inherit from."""
KEYWORDS = ["min", "max", "unit", "choices", "robots", "description"]

TAKEN = frozenset({*sys.stdlib_module_names, "rsal", "numpy"})
"""Names of modules that are loaded when an agent begins, or that these load."""


class _InvalidFileError(Exception):
    def __init__(self, node: ast.AST, message: str, remedy: str = "") -> None:
        super().__init__(message)
        self.words = problem(getattr(node, "lineno", 1), getattr(node, "col_offset", 0) + 1, message, remedy)


def problem(line: int, column: int, message: str, remedy: str = "") -> dict[str, Any]:
    """Return a problem of a file as RSAL shows it; lines and columns count from 1."""
    return {"line": line, "column": column, "message": message, "remedy": remedy}


def inspect(text: str, name: str, wanted: str) -> dict[str, Any]:
    """Return what a file says of an agent: ``class``, ``description``, ``parameters`` and ``needs``; or ``problems``.

    :param name: of the file
    :param wanted: name of the class; empty when there is one only
    """
    try:
        tree = ast.parse(text, name)
    except SyntaxError as error:
        return {"problems": [problem(error.lineno or 1, error.offset or 1, f"This is not Python: {error.msg}.")]}
    except ValueError as error:  # a null byte
        return {"problems": [problem(1, 1, f"This is not Python: {error}.")]}
    problems: list[dict[str, Any]] = []
    try:
        agent = _agent(tree, wanted)
    except _InvalidFileError as error:
        return {"problems": [error.words]}
    parameters: dict[str, Any] = {}
    needs: list[Any] = []
    for each in _line_of(agent, _classes(tree)):
        for statement in each.body:
            try:
                _read(statement, parameters, needs)
            except _InvalidFileError as error:
                problems.append(error.words)
    if problems:
        return {"problems": problems}
    doc = ast.get_docstring(agent) or ast.get_docstring(tree) or ""
    return {
        "class": agent.name,
        "description": doc.split("\n\n")[0].replace("\n", " "),
        "parameters": list(parameters.values()),
        "needs": needs,
        "warnings": _warnings(tree),
        "problems": [],
    }


BLOCKING = {
    "asyncio.run": "Start a coroutine by 'self.spawn(…)'; it waits for goals, requests and 'self.sleep(…)'.",
    "asyncio.sleep": "Write 'await self.sleep(seconds)', which has the time of the run.",
    "input": "Let people send messages: 'self.subscribe(Text, …)'.",
    "time.sleep": "Write 'await self.sleep(seconds)', or 'self.after(seconds, …)', which have the time of the run.",
}
"""Functions that no agent should call, and what to write."""


def _warnings(tree: ast.Module) -> list[dict[str, Any]]:
    """Return calls for which the run, or all agents in Python, would wait."""
    names = {"input": "input"}  # by what they are called in the file
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names.update({each.asname or each.name: each.name for each in node.names})
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names.update({each.asname or each.name: f"{node.module}.{each.name}" for each in node.names})
    found = []
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        called = node.func
        if isinstance(called, ast.Attribute) and isinstance(called.value, ast.Name):
            name = f"{names.get(called.value.id, '')}.{called.attr}"
        else:
            name = names.get(called.id, "") if isinstance(called, ast.Name) else ""
        if name in BLOCKING:
            message = f"'{name}' makes the run wait, or all agents in Python in real time."
            found.append(problem(node.lineno, node.col_offset + 1, message, BLOCKING[name]))
    return sorted(found, key=lambda each: (each["line"], each["column"]))


def _classes(tree: ast.Module) -> dict[str, ast.ClassDef]:
    return {each.name: each for each in tree.body if isinstance(each, ast.ClassDef)}


def _bases(each: ast.ClassDef) -> list[str]:
    return [base.attr if isinstance(base, ast.Attribute) else getattr(base, "id", "") for base in each.bases]


def _line_of(agent: ast.ClassDef, classes: dict[str, ast.ClassDef]) -> list[ast.ClassDef]:
    """Return the classes of the file that it inherits from, the farthest first, and itself."""
    line: list[ast.ClassDef] = []

    def add(each: ast.ClassDef) -> None:
        if each not in line:
            for base in reversed(_bases(each)):
                if base in classes and classes[base] is not each:
                    add(classes[base])
            if each not in line:
                line.append(each)

    add(agent)
    return line


def _agent(tree: ast.Module, wanted: str) -> ast.ClassDef:
    classes = _classes(tree)
    agents = {
        name: each
        for name, each in classes.items()
        if any(BASES.intersection(_bases(one)) for one in _line_of(each, classes))
    }
    if wanted:
        if wanted in agents:
            return agents[wanted]
        raise _InvalidFileError(
            classes.get(wanted, tree.body[0] if tree.body else tree),
            f"There is no class '{wanted}' that inherits from 'rsal.Agent' in this file.",
            _known(wanted, list(agents)),
        )
    inherited = {base for each in agents.values() for base in _bases(each)}
    leaves = [each for name, each in agents.items() if name not in inherited]
    if not leaves:
        raise _InvalidFileError(
            tree,
            "This file has no class that inherits from 'rsal.Agent'.",
            "Write 'import rsal' and 'class Hunter(rsal.Agent):'.",
        )
    if len(leaves) > 1:
        raise _InvalidFileError(
            leaves[1],
            f"This file has several agents: {', '.join(each.name for each in leaves)}.",
            f"Name one of them in the scenario, as 'type: FILE.py:{leaves[0].name}'.",
        )
    return leaves[0]


def _known(word: str, names: list[str]) -> str:
    close = difflib.get_close_matches(word, names, 1)
    return f"Maybe '{close[0]}'?" if close else f"Known are: {', '.join(names)}." if names else ""


def _read(statement: ast.stmt, parameters: dict[str, Any], needs: list[Any]) -> None:
    if isinstance(statement, (ast.Assign, ast.AnnAssign)):
        targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
        target = targets[0]
        if not isinstance(target, ast.Name):
            return
        if target.id == "needs" and statement.value is not None:
            needs[:] = [_device(each) for each in _items(statement.value)]
        elif isinstance(statement.value, ast.Call) and _name(statement.value.func) == "Param":
            if isinstance(statement, ast.Assign):
                raise _InvalidFileError(
                    statement,
                    f"Parameter '{target.id}' has no type.",
                    f"Write '{target.id}: float = Param(…)', or int, str or bool.",
                )
            parameters[target.id] = _parameter(target.id, statement, statement.value)


def _name(node: ast.AST) -> str:
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def _items(node: ast.expr) -> list[ast.expr]:
    if not isinstance(node, (ast.List, ast.Tuple)):
        raise _InvalidFileError(node, "'needs' is a list of devices.", "Write 'needs = [LaserScanner, Navigator]'.")
    return node.elts


def _device(node: ast.expr) -> list[Any]:
    if not _name(node):
        raise _InvalidFileError(
            node, "'needs' has names of devices only.", "Write 'needs = [LaserScanner, Navigator]'."
        )
    return [_name(node), node.lineno, node.col_offset + 1]


def _literal(node: ast.expr, what: str) -> Any:
    try:
        return ast.literal_eval(node)
    except (ValueError, TypeError, SyntaxError):
        raise _InvalidFileError(
            node,
            f"{what} is not a literal: '{ast.unparse(node)}'.",
            "RSAL reads it without running the file: write the number or the text itself.",
        ) from None


def _parameter(name: str, statement: ast.AnnAssign, call: ast.Call) -> dict[str, Any]:
    kind = KINDS.get(ast.unparse(statement.annotation).strip("'\""))
    if kind is None:
        raise _InvalidFileError(
            statement.annotation,
            f"A parameter cannot have the type '{ast.unparse(statement.annotation)}'.",
            "Types are float, int, str and bool.",
        )
    found: dict[str, Any] = {"name": name, "kind": kind, "line": statement.lineno, "column": statement.col_offset + 1}
    if len(call.args) > 1:
        raise _InvalidFileError(
            call.args[1], "'Param' has one default; all else has a name.", "Write 'min=0, unit=\"m\"'."
        )
    if call.args:
        found["default"] = _literal(call.args[0], f"The default of '{name}'")
    for keyword in call.keywords:
        if keyword.arg == "default":
            found["default"] = _literal(keyword.value, f"The default of '{name}'")
        elif keyword.arg in KEYWORDS:
            found[keyword.arg] = _literal(keyword.value, f"'{keyword.arg}' of '{name}'")
        else:
            raise _InvalidFileError(
                keyword.value, f"'Param' has no '{keyword.arg}'.", _known(str(keyword.arg), ["default", *KEYWORDS])
            )
    _check(found, call)
    return found


def _check(found: dict[str, Any], call: ast.Call) -> None:
    name, kind = found["name"], found["kind"]
    number = kind in ("NUMBER", "INTEGER")
    for bound in ("min", "max"):
        if bound in found and (not number or not isinstance(found[bound], (int, float))):
            raise _InvalidFileError(call, f"'{bound}' of '{name}' must be a number, of a parameter that is one.")
    for text in ("unit", "description"):
        if not isinstance(found.get(text, ""), str):
            raise _InvalidFileError(call, f"'{text}' of '{name}' must be a text.")
    choices = found.get("choices", [])
    if not isinstance(choices, (list, tuple)) or not all(isinstance(each, str) for each in choices):
        raise _InvalidFileError(call, f"'choices' of '{name}' must be a list of texts.")
    found["choices"] = list(choices)
    if (found.get("robots") or found["choices"]) and kind != "TEXT":
        raise _InvalidFileError(call, f"'{name}' names robots or has choices, so its type must be 'str'.")
    if "default" in found:
        default = found["default"]
        kinds: dict[str, tuple[type, ...]] = {
            "NUMBER": (int, float),
            "INTEGER": (int,),
            "TEXT": (str,),
            "FLAG": (bool,),
        }
        fits = isinstance(default, kinds[kind]) and (kind == "FLAG") == isinstance(default, bool)
        if fits and number:
            fits = found.get("min", default) <= default <= found.get("max", default)
        if fits and found["choices"]:
            fits = default in found["choices"]
        if not fits:
            raise _InvalidFileError(call, f"The default of '{name}' does not fit: '{default}'.")


def installed(module: str) -> tuple[str, str]:
    """Return the path and the text of an installed module, without running it or the packages that it is in.

    :raises LookupError: when there is none
    """
    found: ModuleSpec | None = None
    where: list[str] | None = None
    name = ""
    for part in module.split("."):
        name = f"{name}.{part}" if name else part
        found = next((spec for finder in sys.meta_path if (spec := finder.find_spec(name, where)) is not None), None)
        if found is None:
            raise LookupError(f"There is no module '{name}' in '{sys.executable}'.")
        where = list(found.submodule_search_locations or [])
    text = found.loader.get_source(module) if found and isinstance(found.loader, InspectLoader) else None
    if found is None or text is None:
        raise LookupError(f"Module '{module}' has no text that could be read.")
    return found.origin or module, text


def answer(words: dict[str, Any]) -> dict[str, Any]:
    """Return what the file of a question says of its agent."""
    if not words["module"]:
        for file in words["files"]:
            name = file.split("/")[0].removesuffix(".py")
            if name in TAKEN:
                message = f"A module of an agent cannot be called '{name}': Python has one of that name."
                return {"problems": [problem(1, 1, message, f"Give '{file}' another name.")]}
        return inspect(words["text"], words["path"], words["class"])
    try:
        path, text = installed(words["module"])
    except LookupError as error:
        remedy = "Install the package for that Python, or name another one by RSAL_PYTHON=/path/to/python3."
        return {"problems": [problem(1, 1, str(error), remedy)]}
    return {**inspect(text, path, words["class"]), "file": path}


def main() -> None:
    """Answers each frame with what the file in it says of its agent."""
    frames = Frames(sys.stdin.buffer, sys.stdout.buffer)
    while (question := frames.read()) is not None:
        words, _ = question
        frames.write(answer(words))

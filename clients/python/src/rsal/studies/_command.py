"""Runs RSAL's commands as child processes."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from rsal import launch

if TYPE_CHECKING:
    from pandas import DataFrame

LAST_LINES = 20
"""Of what a command has printed, in an error."""

_PATIENCE = 5.0  # s, for a command that was asked to end


class CommandFailed(launch.RsalError):
    """A command of RSAL that has failed, with its last words.

    Attributes:
        command: the words of the command.
        code: its exit code: 2 usage, 3 invalid input, 5 something cannot be reached; below 0 the signal that ended it.
        message: what it has printed.

    """

    def __init__(self, command: Sequence[str], code: int, message: str) -> None:
        """Make it of what is known of the command."""
        self.command = list(command)
        self.code = code
        self.message = message
        super().__init__(f"'rsal {' '.join(command)}' failed with exit code {code}:\n{message or '(no message)'}")

    def __reduce__(self) -> tuple[type[CommandFailed], tuple[list[str], int, str]]:
        """Let it be pickled, for runs in other processes."""
        return (CommandFailed, (self.command, self.code, self.message))


def call(
    arguments: Sequence[str], *, accepted: Sequence[int] = (0,), while_waiting: Callable[[], object] = bool
) -> str:
    """Run a command and return what it prints to stdout.

    An interrupt (Ctrl-C, or "Interrupt the kernel" in Jupyter) ends the command, too.

    Args:
        arguments: of ``rsal``.
        accepted: exit codes that are no failure.
        while_waiting: is called every 0.2 s.

    """
    words = [str(each) for each in arguments]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:  # pipes that nobody reads could fill
        process = start(words, stdout=out, stderr=err)
        with ended(process):
            while True:
                with contextlib.suppress(subprocess.TimeoutExpired):
                    process.wait(timeout=0.2)
                    break
                while_waiting()
        while_waiting()
        out.seek(0)
        err.seek(0)
        text = out.read().decode("utf-8", "replace")
        if process.returncode not in accepted:
            raise CommandFailed(words, process.returncode, last_lines(err.read().decode("utf-8", "replace")))
    return text


def call_json(arguments: Sequence[str], **options: Any) -> Any:
    """Run a command with ``--json`` and return its result."""
    text = call([*arguments, "--json"], **options)
    try:
        return json.loads(text)
    except ValueError as error:
        raise launch.RsalError(f"'rsal {' '.join(arguments)}' printed no JSON: '{text[:200]}'.") from error


def start(arguments: Sequence[str], **options: Any) -> subprocess.Popen[bytes]:
    """Start a command that reads nothing, and that Ctrl-C of a terminal does not reach. It ends with this program."""
    words = launch.command(arguments)
    variables = {**launch.environment(), "RSAL_END_WITH": str(os.getpid())}
    try:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, env=variables, **launch.apart(), **options)
    except OSError as error:
        raise launch.RsalError(f"'{words[0]}' cannot be started: {error.strerror}.") from error


@contextlib.contextmanager
def ended(process: subprocess.Popen[bytes]) -> Iterator[None]:
    """End a process whatever happens, if it has not ended by itself."""
    try:
        yield
    finally:
        stop(process)


def stop(process: subprocess.Popen[bytes]) -> None:
    """End a process, so that it closes its files; by force if it does not end in time. Windows knows force only."""
    if process.poll() is not None:
        return
    with contextlib.suppress(OSError):
        process.terminate()  # a program that was started in the background ignores Ctrl-C, and so do its children
    deadline = time.monotonic() + _PATIENCE
    while process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    if process.poll() is None:
        process.kill()
        process.wait()


def last_lines(text: str) -> str:
    """Return the end of what a command has printed."""
    return "\n".join(text.strip().splitlines()[-LAST_LINES:])


def settings(arguments: Mapping[str, object], option: str = "--set") -> list[str]:
    """Return options that set arguments of a scenario."""
    words: list[str] = []
    for name, value in arguments.items():
        words += [option, f"{name}={word(value)}"]
    return words


def word(value: object) -> str:
    """Return a value as the command line reads it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return str(value.item() if hasattr(value, "item") else value)  # numpy's numbers as Python's


def scenario_word(scenario: object, configuration: str | None) -> str:
    """Return the scenario as the command line names it, ``NAME:CONFIGURATION``."""
    return f"{scenario}:{configuration}" if configuration else str(scenario)


def pandas() -> ModuleType:
    """Return the package pandas, which only tables need."""
    try:
        import pandas as package  # noqa: PLC0415 - takes a second
    except ImportError as error:
        raise launch.RsalError(
            f"Tables need the package pandas, which is not here ({error}). Try 'pip install \"rsal[notebook]\"'."
        ) from error
    tables: ModuleType = package
    return tables


def read_csv(file: Path, **options: Any) -> DataFrame:
    """Return a table of RSAL with numbers to the last digit, which pandas before 3.0 reads only when it is told."""
    package = pandas()
    if int(str(package.__version__).split(".")[0]) < 3:  # noqa: PLR2004 - see above
        options["float_precision"] = "round_trip"
    frame: DataFrame = package.read_csv(file, **options)
    return frame

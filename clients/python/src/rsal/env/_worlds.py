"""The child process that simulates all worlds of an environment."""

from __future__ import annotations

import contextlib
import math
import os
import subprocess
import tempfile
import weakref
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import IO, Any, BinaryIO, cast

import numpy as np
import numpy.typing as npt

from rsal import launch
from rsal.env._spec import Spec
from rsal.protocol import Frames, ProtocolError, encode

Floats = npt.NDArray[np.float32]
Integers = npt.NDArray[np.int32]

_LAST_WORDS = 4000  # characters of what a process has said on stderr
_STEP = encode({"request": "step"})
_PATIENCE = 5.0  # s for a process that is to end


class RsalCrashed(launch.RsalError):
    """The process that simulates has ended: with its exit code, and the last lines that it wrote."""


@dataclass(frozen=True)
class Layout:
    """What the numbers of an environment mean."""

    learners: tuple[str, ...]
    """Ids of the robots that learn, in the order of observations, actions and rewards."""
    robots: dict[str, str]
    """Roles of all robots, by id."""
    period: float
    """Simulated time of a step [s]."""
    fields: tuple[str, ...]
    """What each number of an observation is, with its unit."""
    low: Floats
    """The least value of each number of an observation."""
    high: Floats
    """The greatest value of each."""
    action_fields: tuple[str, ...]
    """What each number of an action is, with its unit."""
    action_low: Floats
    """The least value of each number of an action."""
    action_high: Floats
    """The greatest value of each."""
    choices: int
    """Number of choices; 0 for actions of continuous numbers."""
    metrics: tuple[str, ...] = ()
    """Names of the scenario's metrics."""
    colors: dict[str, str] = field(default_factory=dict)
    """Colors of all robots as on the page, by id: ``#rrggbb``."""


class Worlds:
    """Many worlds of one environment, in one child process.

    Arrays are always the same ones, read-only: each step and each reset overwrites them.
    """

    def __init__(self, spec: Spec, seeds: Sequence[int], threads: int = 1) -> None:
        self._owner = os.getpid()
        words = launch.command(["environments"])
        self._log: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115 - it lives as long as the process
        try:
            self._process = subprocess.Popen(
                words,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._log,
                env=launch.environment(),
                **launch.apart(),
            )
        except OSError as error:
            self._log.close()
            raise launch.RsalError(f"'{words[0]}' cannot be started: {error.strerror}.") from error
        self._frames = Frames(cast(BinaryIO, self._process.stdout), cast(BinaryIO, self._process.stdin))
        self._end = weakref.finalize(self, _end, self._process, self._frames, self._log, self._owner)
        self._broken = ""
        try:
            self._open(spec, seeds, threads)
        except BaseException:
            self.close()
            raise

    def _open(self, spec: Spec, seeds: Sequence[int], threads: int) -> None:
        self.count = len(seeds)
        words = self._ask(spec.opening(seeds, threads))
        self.layout = Layout(
            learners=tuple(words["learners"]),
            robots=dict(words["robots"]),
            period=words["period"],
            fields=tuple(words["fields"]),
            low=np.array(words["low"], np.float32),
            high=np.array(words["high"], np.float32),
            action_fields=tuple(words["actionFields"]),
            action_low=np.array(words["actionLow"], np.float32),
            action_high=np.array(words["actionHigh"], np.float32),
            choices=words["choices"],
            metrics=tuple(words["metrics"]),
            colors=dict(words["colors"]),
        )
        learners, robots = len(self.layout.learners), len(self.layout.robots)
        self._observed = (self.count, learners, len(self.layout.fields))
        self._posed = (self.count, robots, 3)
        self._touched = (self.count, robots)
        self._acted = (self.count, learners, len(self.layout.action_fields))
        self._actions = math.prod(self._acted)
        self._buffer = bytearray(self._arrays)  # of each answer to a step or a reset
        data = memoryview(self._buffer).toreadonly()
        observed, posed, touched = (math.prod(shape) for shape in (self._observed, self._posed, self._touched))
        self.observations: Floats = np.frombuffer(data, "<f4", observed).reshape(self._observed)
        self.poses: Floats = np.frombuffer(data, "<f4", posed, 4 * observed).reshape(self._posed)
        """True poses of all robots in the map: x, y [m] and heading [rad]."""
        self.collisions: Integers = np.frombuffer(data, "<i4", touched, 4 * (observed + posed)).reshape(self._touched)
        """How often all robots have touched something in their episode."""

    def _ask(self, words: dict[str, Any]) -> dict[str, Any]:
        """Ask for what is not in the arrays of all worlds."""

        def exchange() -> dict[str, Any] | None:
            self._frames.write(words)
            answer = self._frames.read()
            if answer is None:
                return None
            self._arrays = answer[1]
            return answer[0]

        return self._answered(exchange)

    def _advance(self, text: bytes, arrays: bytes = b"") -> dict[str, Any]:
        """Ask for what changes the arrays of all worlds."""

        def exchange() -> dict[str, Any] | None:
            self._frames.write_text(text, arrays)
            return self._frames.read_into(self._buffer)

        return self._answered(exchange)

    def _answered(self, exchange: Callable[[], dict[str, Any] | None]) -> dict[str, Any]:
        """Return the words of an answer. After an interrupt and without an answer, there is no other one."""
        self._must_own()
        if self._broken:
            raise RsalCrashed(self._broken)
        try:
            answered = exchange()
        except (OSError, ValueError, ProtocolError):
            answered = None
        except BaseException:  # the rest of the answer would be taken for the next one
            self._broken = (
                "A request was interrupted, and the process of RSAL was ended with it. reset() starts another."
            )
            self._process.kill()
            raise
        if answered is None:
            self._broken = self._last_words()
            raise RsalCrashed(self._broken)
        if "error" in answered:
            raise launch.RsalError(answered["error"])
        return answered

    def _must_own(self) -> None:
        if os.getpid() != self._owner:
            raise launch.RsalError(
                "This environment was made in another process. Make it in the process that uses it: pass a function "
                "that makes it, as gymnasium.vector.AsyncVectorEnv does."
            )

    @property
    def is_broken(self) -> bool:
        """Whether its process has ended, or does not answer any more."""
        return bool(self._broken)

    def _last_words(self) -> str:
        try:
            code: int | None = self._process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            code = None
        if self._log.closed:
            return "The environment is closed."
        self._log.seek(0)
        said = self._log.read().decode(errors="replace").strip()[-_LAST_WORDS:]
        ended = "does not answer" if code is None else f"has ended with exit code {code}"
        return f"The process of RSAL {ended}." + (f" Its last words were:\n{said}" if said else "")

    def step(self, actions: npt.ArrayLike) -> dict[int, str]:
        """Act in all worlds that are not over, and return how those ended that are over, by number."""
        given = np.ascontiguousarray(actions, "<f4")
        if given.size != self._actions:
            raise launch.RsalError(f"Actions must have the shape {self._acted}, not {given.shape}.")
        answered = self._advance(_STEP, given.tobytes())
        over: dict[str, str] = answered.get("over", {})
        return {int(world): outcome for world, outcome in over.items()}

    def reset(self, worlds: Sequence[int], seeds: Sequence[int]) -> None:
        """Begin new episodes in some worlds."""
        self._advance(encode({"request": "reset", "worlds": list(worlds), "seeds": list(seeds)}))

    def metrics(self) -> list[dict[str, float]]:
        """Return the metrics of the scenario as they are now, of each world."""
        metrics: list[dict[str, float]] = self._ask({"request": "metrics"})["metrics"]
        return metrics

    def finish(self, world: int) -> dict[str, Any]:
        """End the episode of a world, and return its outcome, seconds, metrics, event hash and failed agents."""
        words = self._ask({"request": "finish", "world": world})
        words["event_hash"] = words.pop("eventHash")
        return words

    def map(self) -> tuple[npt.NDArray[np.int8], float, tuple[float, float]]:
        """Return the cells of the map by rows from below, the side of a cell [m], and the lower left corner [m]."""
        words = self._ask({"request": "map"})
        cells = np.frombuffer(self._arrays, np.int8, words["width"] * words["height"])
        x, y = words["origin"]
        return cells.reshape(words["height"], words["width"]).copy(), words["resolution"], (x, y)

    def close(self) -> None:
        """End the process."""
        self._end()


def _end(process: subprocess.Popen[bytes], frames: Frames, log: IO[bytes], owner: int) -> None:
    if os.getpid() == owner:
        if process.poll() is None:
            with contextlib.suppress(OSError, ValueError):
                frames.write({"request": "close"})  # its stdin may be open in a forked child, too
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with contextlib.suppress(OSError):  # it has ended before
                    pipe.close()
        try:
            process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
    log.close()

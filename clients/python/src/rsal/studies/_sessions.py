"""Running sessions: what has a page, on this machine or another one."""

from __future__ import annotations

import asyncio
import json
import math
import os
import re
import ssl
import struct
import subprocess
import tempfile
import threading
import time
import urllib.error
import urllib.request
import weakref
from collections.abc import AsyncIterator, Generator, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from rsal.launch import RsalError
from rsal.studies._command import CommandFailed, last_lines, scenario_word, settings, start, stop
from rsal.studies._websocket import WebSocket, WebSocketClosed

DEFAULT_PORT = 8735
_LOOK = 0.1  # s, between two looks at what is awaited
_PATIENCE = 15.0  # s, for an answer
_START = 60.0  # s, until the page of a new session is there
_BUSY = 503  # HTTP's status when the run did not answer in time
_EXECUTING = "executing"
_PAGE = re.compile(rb"Watch it at (http://\S+)")
_METRIC = re.compile(r"^(\w+(?:\{.*\})?) (\S+)$")
# Browsers take 127.0.0.1 and localhost for different sites, so the frame has the name that the notebook has.
_FRAME = """<iframe src="{page}" width="100%" height="600" style="border: 0"></iframe><script>
{{
  const frame = document.currentScript.previousElementSibling;
  if (location.hostname === "localhost") frame.src = frame.src.replace("//127.0.0.1:", "//localhost:");
}}</script>"""
_FRAME_NUMBER = 8  # offset in a frame


class SessionError(RsalError):
    """A session refuses something, or cannot be reached. ``status`` is HTTP's status, 0 without an answer."""

    def __init__(self, message: str, status: int = 0) -> None:
        """Make it of a sentence."""
        super().__init__(message)
        self.status = status


@dataclass(frozen=True)
class Event:
    """What has happened in a run.

    Attributes:
        sequence: number, from 1 in each run, without gaps.
        time: of the run [s].
        kind: ``agent``, ``message``, ``collision``, ``fault``, ``run``, …
        subject: the agent or robot.
        text: in words.
        said: of messages ``to``, ``topic``, ``conversation``, ``protocol``, ``act``; otherwise empty.

    """

    sequence: int
    time: float
    kind: str
    subject: str
    text: str
    said: dict[str, Any]


@dataclass(frozen=True)
class GoalResult:
    """What became of a goal.

    Attributes:
        goal: its number.
        robot: the robot that was sent.
        status: ``executing``, ``succeeded``, ``canceled`` or ``aborted``.
        why: the reason, if it was aborted.
        seconds: time that the robot took [s]; nan while it executes.

    """

    goal: int
    robot: str
    status: str
    why: str
    seconds: float

    @property
    def ok(self) -> bool:
        """Whether the robot has reached the goal."""
        return self.status == "succeeded"


def connect(
    page: int | str | None = None, *, token: str | None = None, certificate: str | Path | None = None
) -> Session:
    """Connect to a session that has a page: ``rsal run``, ``rsal serve``.

    Args:
        page: port of the page on this machine, or its address as ``rsal`` prints it (with ``#token=…``). By default
            your only page, or the one at port 8735.
        token: for changes, and for pages on other machines. On this machine, that of your own pages is found.
        certificate: the certificate of the server (PEM), if it is self-signed.

    Raises:
        SessionError: there is no such page.

    """
    session = _session(page, token, certificate)
    session.status()
    return session


def _session(page: int | str | None = None, token: str | None = None, certificate: str | Path | None = None) -> Session:
    if isinstance(page, str) and not page.isdigit():
        address = urlsplit(page)
        if address.scheme not in ("http", "https") or not address.hostname:
            raise SessionError(f"page is '{page}'. It must be a port, or an address such as 'http://127.0.0.1:8735/'.")
        found = re.search(r"token=([\w-]+)", address.fragment)
        token = token or (found.group(1) if found else None)
        base = f"{address.scheme}://{address.netloc}"
        local = address.hostname in ("127.0.0.1", "localhost", "::1")
        key = token or (_tokens().get(address.port or 80) if local else None)
        return Session(base, key, certificate)
    port = _port() if page is None else int(page)
    return Session(f"http://127.0.0.1:{port}", token or _tokens().get(port))


def _tokens() -> dict[int, str]:
    """Return the tokens of this person's pages by port: they are in files that nobody else may read."""
    tokens: dict[int, str] = {}
    for folder in _token_folders():
        for file in sorted(folder.glob("page-*.token")):
            with suppress(OSError, ValueError):
                tokens[int(file.stem.split("-")[1])] = file.read_text(encoding="ascii").strip()
    return tokens


def _token_folders() -> list[Path]:
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if runtime:
        return [Path(runtime) / "rsal"]
    homes = [Path.home()]
    with suppress(ImportError, KeyError):  # not on Windows; users of containers may have no entry
        import pwd  # noqa: PLC0415

        homes.append(Path(pwd.getpwuid(os.getuid()).pw_dir))  # Java takes this one, whatever HOME is
    return [home / ".cache" / "rsal" for home in dict.fromkeys(homes)]


def _port() -> int:
    ports = [port for port in _tokens() if _is_open(port)]
    if len(ports) > 1 and DEFAULT_PORT not in ports:
        raise SessionError(f"There are several sessions, at the ports {ports}. Say which: rsal.connect({ports[0]}).")
    return DEFAULT_PORT if DEFAULT_PORT in ports or not ports else ports[0]


def _is_open(port: int) -> bool:
    with suppress(SessionError):
        Session(f"http://127.0.0.1:{port}", None).ask("/healthz")
        return True
    return False


def serve(
    scenario: str | Path = "hunt-and-prey",
    *,
    configuration: str | None = None,
    seed: int | None = None,
    speed: float | str = 1,
    port: int = 0,
    record: str | Path | None = None,
    arguments: Mapping[str, object] | None = None,
    **more_arguments: object,
) -> Session:
    """Start a run with a page, and connect to it. ``close()`` ends it, and so does the end of this program.

    Args:
        scenario: a scenario of RSAL, a scenario file or its folder, or a world.
        configuration: of the scenario; by default its first.
        seed: of all random numbers.
        speed: simulated time over real time, from 0.1 to 1000, or ``"max"``.
        port: of the page; 0: any free port.
        record: a file for the recording (``.mcap``).
        arguments: of the scenario, by name.
        more_arguments: the same, as keywords.

    Raises:
        CommandFailed: the scenario or an argument is wrong, or the port is in use.

    """
    words = [
        "run",
        scenario_word(scenario, configuration),
        "--port",
        str(port),
        "--speed",
        str(speed),
        "--quiet",
        "--frames",
    ]
    if seed is not None:
        words += ["--seed", str(seed)]
    if record is not None:
        words += ["--record", str(record)]
    words += settings({**(arguments or {}), **more_arguments})
    said = tempfile.TemporaryFile()  # noqa: SIM115 - the process has it
    process = start(words, stdout=said, stderr=subprocess.STDOUT)
    try:
        deadline = time.monotonic() + _START
        while True:
            text = os.pread(said.fileno(), 1 << 20, 0) if hasattr(os, "pread") else _read(said)
            found = _PAGE.search(text)
            if found:
                break
            if process.poll() is not None:
                raise CommandFailed(words, process.returncode, last_lines(text.decode("utf-8", "replace")))
            if time.monotonic() > deadline:
                raise SessionError(f"'rsal {' '.join(words)}' has no page after {_START:.0f} s.")
            time.sleep(0.05)
        session = _session(found.group(1).decode("ascii"))
        session._asked("/api/status", max(deadline, time.monotonic() + _PATIENCE))
        session._process = process
        weakref.finalize(session, stop, process)  # also at the end of this program
        return session
    except BaseException:
        stop(process)
        raise


def _read(file: Any) -> bytes:
    file.seek(0)  # Windows: the child has a position of its own
    data: bytes = file.read()
    return data


class Session:
    """A running session. Made by ``connect`` and ``serve``; its methods may be called from any thread.

    In Jupyter, it shows the state of its robots and a link to its page. Sessions of ``serve`` also show the page
    itself, in notebooks at ``localhost`` or ``127.0.0.1``. What is shown is saved with the notebook: for sessions of
    ``serve`` with the token of the page, which is of no use once the session has ended; for others without a token.
    """

    def __init__(self, address: str, token: str | None, certificate: str | Path | None = None) -> None:
        """Make it of an address, without asking there."""
        self.address = address
        self._token = token
        self._process: subprocess.Popen[bytes] | None = None
        self._context: ssl.SSLContext | None = None
        if certificate is not None:
            self._context = ssl.create_default_context(cafile=str(certificate))

    def ask(self, path: str, body: Mapping[str, object] | None = None) -> Any:
        """Send a request of docs/reference/live-protocol.md, and return the answer: of JSON its value, otherwise text.

        Args:
            path: such as ``/api/status``.
            body: makes it a POST.

        """
        request = urllib.request.Request(self.address + path)  # noqa: S310 - http and https only, see connect
        if self._token:
            request.add_header("Authorization", f"Bearer {self._token}")
        if body is not None:
            request.data = json.dumps(body).encode("utf-8")
            request.add_header("Content-Type", "application/json")
        handlers: list[urllib.request.BaseHandler] = [urllib.request.ProxyHandler({})]
        if self._context:
            handlers.append(urllib.request.HTTPSHandler(context=self._context))
        try:
            with urllib.request.build_opener(*handlers).open(request, timeout=_PATIENCE) as answer:
                text = answer.read().decode("utf-8")
                is_json = "json" in (answer.headers.get("Content-Type") or "")
        except urllib.error.HTTPError as error:
            raise SessionError(self._refusal(path, error), error.code) from None
        except OSError as error:
            reason = getattr(error, "reason", error)
            raise SessionError(
                f"There is no session at '{self.address}': {reason}. "
                "'rsal run' prints the address of its page; 'rsal status' finds your only one."
            ) from None
        return json.loads(text) if is_json and text else text

    def _refusal(self, path: str, error: urllib.error.HTTPError) -> str:
        text = error.read().decode("utf-8", "replace")
        try:
            said = json.loads(text)
        except ValueError:
            said = text
        sentence = said.get("message") or said.get("error") or text if isinstance(said, dict) else text
        hint = ""
        if error.code == 401:  # noqa: PLR2004 - unauthorized
            hint = " Give the token: rsal.connect(…, token='…'), or the whole address that 'rsal' has printed."
        return f"'{self.address}{path}' is refused ({error.code}): {sentence}{hint}"

    def status(self) -> dict[str, Any]:
        """Return the state: ``time``, ``outcome`` (empty while the run lasts), ``robots``, ``agents``, ``goals``.

        It waits for a run that is busy, for 15 s.
        """
        answer: dict[str, Any] = self._asked("/api/status", time.monotonic() + _PATIENCE)
        return answer

    def _asked(self, path: str, deadline: float) -> Any:
        """Ask until the run answers: a server whose run has not answered in time says so after a second."""
        while True:
            try:
                return self.ask(path)
            except SessionError as error:
                if error.status != _BUSY or time.monotonic() > deadline:
                    raise
            time.sleep(_LOOK)

    @property
    def time(self) -> float:
        """Time of the run [s]."""
        return float(self.status()["time"])

    @property
    def outcome(self) -> str:
        """The outcome of the run; empty while it runs."""
        return str(self.status()["outcome"])

    def metrics(self) -> dict[str, float]:
        """Return the numbers for Prometheus (docs/how-to/metrics.md), by name with labels."""
        found = (
            _METRIC.match(line) for line in str(self._asked("/metrics", time.monotonic() + _PATIENCE)).splitlines()
        )
        return {each.group(1): float(each.group(2)) for each in found if each}

    def tell(self, command: str, **parameters: object) -> dict[str, Any]:
        """Give any operator command: ``session.tell("say", topic="…", fields={…})``. ``rsal tell`` lists them."""
        answer = self.ask(f"/api/run/{command}", parameters)
        return answer if isinstance(answer, dict) else {}

    def pause(self) -> None:
        """Pause simulated time."""
        self.tell("pause")

    def resume(self) -> None:
        """Resume simulated time."""
        self.tell("resume")

    def step(self, steps: int = 1) -> None:
        """Run some steps of a run that is paused."""
        for _ in range(steps):
            self.tell("step")

    def speed(self, factor: float | str) -> None:
        """Set simulated time over real time: from 0.1 to 1000, or ``"max"``."""
        self.tell("speed", factor=str(factor))

    def stop(self) -> None:
        """End the run. The page stays."""
        self.tell("stop")

    def estop(self) -> int:
        """Emergency stop: switch off the motors of all robots. Return how many robots have confirmed it."""
        return int(self.tell("estop")["robots"])

    def rearm(self) -> int:
        """Switch the motors on after an emergency stop. Return of how many robots."""
        return int(self.tell("rearm")["on"])

    def place(self, name: str, x: float, y: float, theta: float = 0.0) -> None:
        """Move a robot or a thing of a simulated world to a pose in the map frame."""
        self.tell("place", robot=name, x=x, y=y, heading=theta)

    def goal(
        self, robot: str, x: float, y: float, theta: float = 0.0, *, wait: bool = False, timeout: float = math.inf
    ) -> GoalResult:
        """Send a robot to a pose in the map frame.

        Args:
            robot: id of the robot.
            x: [m].
            y: [m].
            theta: [rad].
            wait: until the goal has ended. An interrupt ends the waiting, not the goal.
            timeout: of the waiting [s of real time]; the result then is ``executing``.

        """
        number = int(self.tell("goal", robot=robot, x=x, y=y, heading=theta)["goal"])
        return self.wait_for_goal(number, timeout=timeout) if wait else self.goal_result(number)

    def goal_result(self, goal: int) -> GoalResult:
        """Return what became of a goal until now."""
        for each in self.status()["goals"]:
            if each["id"] == goal:
                executes = each["status"] == _EXECUTING
                seconds = math.nan if executes else each["ended"] - each["sent"]
                return GoalResult(goal, each["robot"], each["status"], each.get("why") or "", seconds)
        raise SessionError(f"Goal {goal} is not known any more: another run is there now, or it ended long ago.")

    def wait_for_goal(self, goal: int, *, timeout: float = math.inf) -> GoalResult:
        """Wait until a goal has ended, and return what became of it."""
        deadline = time.monotonic() + timeout
        while True:
            result = self.goal_result(goal)
            if result.status != _EXECUTING or time.monotonic() > deadline:
                return result
            time.sleep(_LOOK)

    def wait(self, *, timeout: float = math.inf) -> str:
        """Wait until the run has ended, and return its outcome; empty when it still runs after the timeout [s]."""
        deadline = time.monotonic() + timeout
        while not self.outcome and time.monotonic() < deadline:
            time.sleep(_LOOK)
        return self.outcome

    def events(self) -> Events:
        """Return all events of the run, from its first one, as they come: until the run ends.

        The result can be iterated by ``for`` and by ``async for``.
        """
        return Events(self)

    def _live(self) -> WebSocket:
        headers = {"Authorization": f"Bearer {self._token}"} if self._token else {}
        try:
            return WebSocket(self.address + "/api/live", headers=headers, context=self._context, patience=1.0)
        except (OSError, WebSocketClosed) as error:
            raise SessionError(f"There is no session at '{self.address}': {error}.") from None

    def _is_over(self) -> bool:
        """Whether the run is known to have ended."""
        with suppress(SessionError):
            return bool(self.outcome)
        return False

    def close(self) -> None:
        """End the session, if ``serve`` has started it; otherwise do nothing."""
        if self._process is not None:
            stop(self._process)

    def __enter__(self) -> Session:
        """Return the session."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close it."""
        self.close()

    @property
    def page(self) -> str:
        """Address of the page, with the token that lets it change the run."""
        return f"{self.address}/" + (f"#token={self._token}" if self._token else "")

    def _repr_html_(self) -> str:
        status = self.status()
        rows = "".join(
            f"<tr><td>{escape(robot['id'])}</td><td>{_number(robot.get('x'))}</td><td>{_number(robot.get('y'))}</td>"
            f"<td>{escape(str(robot.get('inCharge') or ''))}</td></tr>"
            for robot in status["robots"]
        )
        state = status["outcome"] or ("paused" if status["paused"] else "running")
        frame, link = "", f"{self.address}/"
        if self._process is not None:  # a token that ends with this session may be saved in a notebook
            frame, link = _FRAME.format(page=escape(self.page)), self.page
        return (
            f"<b>{escape(status['scenario'])}:{escape(status['configuration'])}</b>, "
            f"seed {escape(str(status['seed']))}: "
            f"{escape(state)} at {status['time']:.1f} s. "
            f'<a href="{escape(link)}" target="_blank">Open the page</a>'
            f"<table><tr><th>robot</th><th>x [m]</th><th>y [m]</th><th>active controller</th></tr>{rows}</table>{frame}"
        )


class Events:
    """Events of a run, as they come. Each iteration has its own connection and begins with the first event."""

    def __init__(self, session: Session) -> None:
        """Make it of a session."""
        self._session = session

    def __iter__(self) -> Iterator[Event]:
        """Iterate until the run ends or another one begins.

        Raises:
            SessionError: the session cannot be reached, or ends before its run does.

        """
        return _events(self._session, threading.Event())

    async def __aiter__(self) -> AsyncIterator[Event]:
        """Iterate without blocking the event loop: waiting is done in another thread."""
        left = threading.Event()
        events = _events(self._session, left)
        coming: asyncio.Future[Event | None] | None = None
        try:
            while True:
                coming = asyncio.ensure_future(asyncio.to_thread(next, events, None))
                event = await asyncio.shield(coming)  # a thread cannot be canceled
                if event is None:
                    return
                yield event
        finally:
            left.set()  # which it sees within a second
            await asyncio.shield(asyncio.ensure_future(_ended(events, coming)))


async def _ended(events: Generator[Event, None, None], coming: asyncio.Future[Event | None] | None) -> None:
    """Close a generator when the thread that is in it has left it."""
    if coming is not None:
        with suppress(Exception):
            await coming
    await asyncio.to_thread(events.close)


def _events(session: Session, left: threading.Event) -> Generator[Event, None, None]:
    socket = session._live()
    run: int | None = None
    try:
        while not left.is_set():
            message = socket.receive()
            if message is None:
                if session.outcome:
                    return
            elif isinstance(message, bytes):
                socket.send(json.dumps({"frame": struct.unpack_from("<I", message, _FRAME_NUMBER)[0]}))
            else:
                said = json.loads(message)
                if "run" in said:
                    if run is not None and said["run"]["number"] != run:
                        return
                    run = said["run"]["number"]
                batch = said.get("events", {}).get("events", [])
                for each in batch:
                    yield Event(
                        each["sequence"], each["time"], each["kind"], each["subject"], each["text"], each["said"] or {}
                    )
                if batch:
                    socket.send(json.dumps({"events": batch[-1]["sequence"]}))
    except WebSocketClosed:
        if left.is_set() or session._is_over():
            return
        raise SessionError(
            f"The session at '{session.address}' has ended the connection, and its run had not ended."
        ) from None
    finally:
        socket.close()


def _number(value: object) -> str:
    return f"{value:.2f}" if isinstance(value, (int, float)) else ""

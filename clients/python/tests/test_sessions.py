from __future__ import annotations

import asyncio
import base64
import hashlib
import http.server
import itertools
import math
import os
import socket
import struct
import subprocess
import sys
import threading
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

import rsal
from rsal.studies import CommandFailed, Event, Session, SessionError, _sessions
from rsal.studies._websocket import WebSocket, WebSocketClosed


@pytest.fixture(scope="module")
def session() -> Iterator[Session]:
    with rsal.serve("teleop", seed=7, speed=5) as served:
        yield served
    assert served._process is not None
    assert served._process.poll() is not None


@pytest.mark.skipif(sys.platform != "linux", reason="Linux shows processes as files")
def test_a_session_ends_with_a_program_that_is_killed() -> None:
    text = "import rsal, time; s = rsal.serve('teleop'); print(s._process.pid, flush=True); time.sleep(100)"
    with subprocess.Popen([sys.executable, "-c", text], stdout=subprocess.PIPE) as program:
        assert program.stdout is not None
        session = int(program.stdout.readline())
        assert _is_there(session)
        program.kill()
    deadline = time.monotonic() + 30
    while _is_there(session) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not _is_there(session)


def _is_there(process: int) -> bool:
    """Whether it has not ended; one that nobody has waited for counts as ended."""
    try:
        state = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


def test_the_status_has_robots(session: Session) -> None:
    status = session.status()
    assert status["scenario"] == "teleop"
    assert status["robots"]
    assert session.time >= 0
    assert session.outcome == ""


def test_a_goal_has_a_result(session: Session) -> None:
    robot = session.status()["robots"][0]
    x = robot["x"] + 2
    result = session.goal(robot["id"], x, robot["y"], robot["heading"], wait=True, timeout=120)
    assert result.ok, result
    assert result.robot == robot["id"]
    assert result.seconds > 2
    here = session.status()["robots"][0]
    assert math.hypot(here["x"] - x, here["y"] - robot["y"]) < 0.7
    assert session.goal_result(result.goal) == result


def test_a_goal_of_nobody_is_refused(session: Session) -> None:
    with pytest.raises(SessionError, match="nobody"):
        session.goal("nobody", 0, 0)
    with pytest.raises(SessionError, match="Goal 99"):
        session.goal_result(99)


def test_it_stops_robots_and_time(session: Session) -> None:
    robots = len(session.status()["robots"])
    assert session.estop() == robots
    assert session.status()["stopped"]
    assert session.rearm() == robots
    session.pause()
    assert session.status()["paused"]
    time = session.time
    session.step(3)
    assert session.time == pytest.approx(time + 0.3)
    session.resume()
    assert not session.status()["paused"]


@pytest.mark.skipif(not hasattr(os, "getpgid"), reason="groups of processes are those of POSIX")
def test_ctrl_c_of_a_terminal_does_not_reach_it(session: Session) -> None:
    assert session._process is not None
    assert os.getpgid(session._process.pid) != os.getpgid(0)


def test_it_has_numbers_for_prometheus(session: Session) -> None:
    metrics = session.metrics()
    assert metrics['rsal_robots{state="present"}'] == len(session.status()["robots"])
    assert metrics["rsal_run_ended"] == 0


def test_events_come_in_order_by_both_ways(session: Session) -> None:
    first = list(itertools.islice(session.events(), 3))
    assert [event.sequence for event in first] == [1, 2, 3]

    async def some() -> list[Event]:
        found = []
        async for event in session.events():
            found.append(event)
            if len(found) == 3:
                break
        return found

    assert asyncio.run(some()) == first


def test_another_program_connects_by_port_or_address(session: Session) -> None:
    port = int(session.address.rsplit(":", 1)[1])
    assert rsal.connect(port)._token == session._token  # found in the file of the page
    assert rsal.connect(session.page).time >= 0
    watching = Session(session.address, None)
    with pytest.raises(SessionError, match="token") as refused:
        watching.pause()
    assert refused.value.status == 401


def test_it_shows_itself_in_notebooks(session: Session) -> None:
    html = session._repr_html_()
    assert "teleop" in html
    assert f'<iframe src="{session.page}"' in html
    with urllib.request.urlopen(session.address + "/") as page:  # noqa: S310 - http
        assert "http://localhost:*" in page.headers["Content-Security-Policy"]
    other = rsal.connect(session.page)._repr_html_()
    assert "<iframe" not in other
    assert session._token is not None
    assert session._token not in other, "a notebook is saved, and shown to others"


def test_events_end_with_the_run(session: Session) -> None:
    session.stop()
    assert session.wait(timeout=60) == "stopped"
    events = list(session.events())
    assert [event.sequence for event in events] == list(range(1, len(events) + 1))


def test_nobody_is_there() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with pytest.raises(SessionError, match=f"no session at 'http://127.0.0.1:{port}'"):
        rsal.connect(port)
    with pytest.raises(SessionError, match="page is 'ftp://x'"):
        rsal.connect("ftp://x")


def test_a_scenario_that_is_not_there_is_not_served() -> None:
    with pytest.raises(CommandFailed, match="no-such-thing"):
        rsal.serve("no-such-thing")


def _frame(kind: int, data: bytes, *, last: bool = True) -> bytes:
    size = len(data)
    head = bytes([(128 if last else 0) | kind])
    if size < 126:
        return head + bytes([size]) + data
    if size < 1 << 16:
        return head + struct.pack(">BH", 126, size) + data
    return head + struct.pack(">BQ", 127, size) + data


def _unmasked(stream: socket.socket) -> tuple[int, bytes]:
    head = stream.recv(2, socket.MSG_WAITALL)
    if len(head) < 2:
        return 8, b""
    first, second = head
    size = second & 127
    if size == 126:
        size = struct.unpack(">H", stream.recv(2, socket.MSG_WAITALL))[0]
    mask = stream.recv(4, socket.MSG_WAITALL)
    data = stream.recv(size, socket.MSG_WAITALL) if size else b""
    return first & 15, bytes(byte ^ mask[i % 4] for i, byte in enumerate(data))


class _Server:
    """A WebSocket server for one client; it sends what it is told, in pieces of some size."""

    def __init__(self, frames: list[bytes], piece: int) -> None:
        self.heard: list[tuple[int, bytes]] = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"ws://127.0.0.1:{self._listener.getsockname()[1]}/api/live"
        self._thread = threading.Thread(target=self._serve, args=(frames, piece), daemon=True)
        self._thread.start()

    def _serve(self, frames: list[bytes], piece: int) -> None:
        client, _ = self._listener.accept()
        with client, self._listener:
            asked = b""
            while b"\r\n\r\n" not in asked:
                asked += client.recv(1000)
            key = next(line.split(b": ")[1] for line in asked.split(b"\r\n") if line.startswith(b"Sec-WebSocket-Key"))
            digest = hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11", usedforsecurity=False).digest()
            answer = b"HTTP/1.1 101 Switching Protocols\r\nSec-WebSocket-Accept: " + base64.b64encode(digest)
            data = answer + b"\r\n\r\n" + b"".join(frames)
            for i in range(0, len(data), piece):
                client.sendall(data[i : i + piece])
            while True:
                self.heard.append(_unmasked(client))
                if self.heard[-1][0] == 8:
                    return

    def join(self) -> None:
        self._thread.join(5)
        assert not self._thread.is_alive()


@pytest.mark.parametrize("piece", [1 << 20, 1000, 7])
def test_messages_of_any_size_come_whole(piece: int) -> None:
    sizes = [0, 1, 125, 126, 65535, 65536, 70000] if piece > 7 else [0, 125, 126, 300]
    frames = [_frame(1, "ä€".encode() * 10), *(_frame(2, bytes(size)) for size in sizes), _frame(9, b"ping")]
    frames += [_frame(1, b"in ", last=False), _frame(9, b"between"), _frame(0, b"two"), _frame(8, b"")]
    server = _Server(frames, piece)
    client = WebSocket(server.url, headers={"X": "y"}, context=None, patience=5)
    assert client.receive() == "ä€" * 10
    assert [client.receive() for _ in sizes] == [bytes(size) for size in sizes]
    assert client.receive() == "in two"
    with pytest.raises(WebSocketClosed):
        client.receive()
    client.send("x" * 200)
    client.close()
    server.join()
    assert server.heard[:3] == [(10, b"ping"), (10, b"between"), (1, b"x" * 200)]
    assert server.heard[3][0] == 8


def test_what_does_not_come_is_none_and_comes_later() -> None:
    server = _Server([_frame(1, b"whole"), _frame(1, b"part")[:3]], 100)
    client = WebSocket(server.url, headers={}, context=None, patience=0.2)
    assert client.receive() == "whole"
    assert client.receive() is None
    client.close()
    server.join()


def _silent(monkeypatch: pytest.MonkeyPatch, frames: list[bytes]) -> Session:
    """A session of which nothing is there but its events."""
    server = _Server(frames, 1000)
    session = Session("http://127.0.0.1:9", None)
    client = WebSocket(server.url, headers={}, context=None, patience=0.3)
    monkeypatch.setattr(session, "_live", lambda: client)
    return session


_STARTED = b'{"run": {"number": 1}, "events": {"events": [%s]}}' % (
    b'{"sequence": 1, "time": 0.5, "kind": "run", "subject": "", "text": "starts", "said": null}'
)


def test_a_lost_connection_is_no_end_of_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    events = iter(_silent(monkeypatch, [_frame(1, _STARTED), _frame(8, b"")]).events())
    assert next(events).text == "starts"
    with pytest.raises(SessionError, match="its run had not ended"):
        next(events)
    over = _silent(monkeypatch, [_frame(1, _STARTED), _frame(8, b"")])
    monkeypatch.setattr(over, "status", lambda: {"outcome": "success"})
    assert len(list(over.events())) == 1


def test_waiting_for_events_can_be_canceled(monkeypatch: pytest.MonkeyPatch) -> None:
    session = _silent(monkeypatch, [_frame(1, _STARTED)])
    monkeypatch.setattr(session, "status", lambda: {"outcome": ""})
    seen: list[Event] = []

    async def watch() -> None:
        async for event in session.events():
            seen.append(event)

    async def for_a_while() -> None:
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(watch(), 0.5)

    asyncio.run(for_a_while())
    assert [event.text for event in seen] == ["starts"]


class _Busy(http.server.BaseHTTPRequestHandler):
    """Answers 503 some times, then with a state."""

    left = 0

    def do_GET(self) -> None:
        type(self).left -= 1
        body = b'{"outcome": "success", "time": 3}' if self.left < 0 else b'{"message": "in time"}'
        self.send_response(200 if self.left < 0 else 503)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Say nothing."""


def test_it_waits_for_a_run_that_is_busy(monkeypatch: pytest.MonkeyPatch) -> None:
    with http.server.HTTPServer(("127.0.0.1", 0), _Busy) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        session = Session(f"http://127.0.0.1:{server.server_port}", None)
        _Busy.left = 2
        assert session.wait(timeout=60) == "success"
        _Busy.left = 2
        assert session.time == 3
        _Busy.left = 1000
        monkeypatch.setattr(_sessions, "_PATIENCE", 0.3)
        with pytest.raises(SessionError, match="in time") as refused:
            session.status()
        assert refused.value.status == 503
        server.shutdown()


def test_a_pong_to_nobody_closes(monkeypatch: pytest.MonkeyPatch) -> None:
    client = WebSocket(_Server([_frame(9, b"ping")], 100).url, headers={}, context=None, patience=2)

    def broken(*_: object) -> None:
        raise BrokenPipeError

    monkeypatch.setattr(client, "_send", broken)
    with pytest.raises(WebSocketClosed):
        client.receive()
    client.close()

"""A client of WebSockets (RFC 6455), as much of it as the server of a page needs: no extensions, no subprotocols."""

from __future__ import annotations

import base64
import contextlib
import hashlib
import os
import socket
import ssl
import struct
from urllib.parse import urlsplit

from rsal.launch import RsalError

_MAGIC = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"  # section 1.3
_CONTINUATION, _TEXT, _BINARY, _CLOSE, _PING, _PONG = 0, 1, 2, 8, 9, 10  # section 5.2
_EXTENDED_16, _EXTENDED_64 = 126, 127
_LARGEST = 64 * 1024 * 1024


class WebSocketClosed(Exception):
    """The server has closed the connection."""


class WebSocket:
    """A connection for one thread."""

    def __init__(self, url: str, *, headers: dict[str, str], context: ssl.SSLContext | None, patience: float) -> None:
        """Connect, and wait for each further message no longer than the patience [s]."""
        parts = urlsplit(url)
        secure = parts.scheme in ("wss", "https")
        port = parts.port or (443 if secure else 80)
        host = parts.hostname or ""
        self._socket = socket.create_connection((host, port), timeout=patience)
        self._bytes = b""
        self._parts: list[bytes] = []
        self._kind = _TEXT
        try:
            if secure:
                self._socket = (context or ssl.create_default_context()).wrap_socket(self._socket, server_hostname=host)
            self._shake_hands(parts.path or "/", parts.netloc, headers)
        except BaseException:
            self._socket.close()
            raise

    def _shake_hands(self, path: str, host: str, headers: dict[str, str]) -> None:
        key = base64.b64encode(os.urandom(16)).decode("ascii")
        lines = [f"GET {path} HTTP/1.1", f"Host: {host}", "Upgrade: websocket", "Connection: Upgrade"]
        lines += [f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13"]
        lines += [f"{name}: {value}" for name, value in headers.items()]
        self._socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode("ascii"))
        while b"\r\n\r\n" not in self._bytes:
            self._receive()
        head, self._bytes = self._bytes.split(b"\r\n\r\n", 1)
        answer = head.decode("latin-1").split("\r\n")
        accept = base64.b64encode(hashlib.sha1((key + _MAGIC).encode("ascii"), usedforsecurity=False).digest())
        fields = {
            name.strip().lower(): value.strip() for name, _, value in (line.partition(":") for line in answer[1:])
        }
        if " 101" not in answer[0] or fields.get("sec-websocket-accept") != accept.decode("ascii"):
            raise RsalError(f"'{host}{path}' is not a WebSocket of RSAL: it answered '{answer[0]}'.")

    def _receive(self) -> None:
        more = self._socket.recv(65536)
        if not more:
            raise WebSocketClosed
        self._bytes += more

    def receive(self) -> str | bytes | None:
        """Return the next message: text or bytes; None when there was none within the patience."""
        while True:
            try:
                kind, last, data = self._frame()
            except TimeoutError:
                return None
            except OSError as error:  # TLS has its own
                raise WebSocketClosed from error
            if kind == _CLOSE:
                raise WebSocketClosed
            if kind == _PING:
                try:
                    self._send(_PONG, data)
                except OSError as error:
                    raise WebSocketClosed from error
            if kind in (_CONTINUATION, _TEXT, _BINARY):
                if kind != _CONTINUATION:
                    self._kind, self._parts = kind, []
                self._parts.append(data)
                if last:
                    whole = b"".join(self._parts)
                    return whole.decode("utf-8") if self._kind == _TEXT else whole

    def _frame(self) -> tuple[int, bool, bytes]:
        """Return the next frame. One that has not come whole stays in the buffer."""
        while True:
            size, start = self._size()
            if size is not None and len(self._bytes) >= start + size:
                first = self._bytes[0]
                data = self._bytes[start : start + size]
                self._bytes = self._bytes[start + size :]
                return first & 15, bool(first & 128), data
            self._receive()

    def _size(self) -> tuple[int | None, int]:
        if len(self._bytes) < 2:  # noqa: PLR2004 - a head's least size
            return None, 0
        size, start = self._bytes[1] & 127, 2
        if size == _EXTENDED_16:
            start = 4
            size = struct.unpack(">H", self._bytes[2:4])[0] if len(self._bytes) >= start else -1
        elif size == _EXTENDED_64:
            start = 10
            size = struct.unpack(">Q", self._bytes[2:10])[0] if len(self._bytes) >= start else -1
        if size > _LARGEST:
            raise WebSocketClosed
        return (size if size >= 0 else None), start

    def send(self, text: str) -> None:
        """Send a text."""
        try:
            self._send(_TEXT, text.encode("utf-8"))
        except OSError as error:
            raise WebSocketClosed from error

    def _send(self, kind: int, data: bytes) -> None:
        mask = os.urandom(4)
        size = len(data)
        if size < _EXTENDED_16:
            head = struct.pack(">BB", 128 | kind, 128 | size)
        elif size < 1 << 16:
            head = struct.pack(">BBH", 128 | kind, 128 | _EXTENDED_16, size)
        else:
            head = struct.pack(">BBQ", 128 | kind, 128 | _EXTENDED_64, size)
        self._socket.sendall(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(data)))

    def close(self) -> None:
        """Close the connection; it may be closed already."""
        with contextlib.suppress(OSError):
            self._send(_CLOSE, struct.pack(">H", 1000))
        self._socket.close()

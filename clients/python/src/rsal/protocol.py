"""Frames between RSAL in Java and Python, over pipes.

A frame is the length of what follows its head, the length of its words (both as little-endian 32-bit integers), the
words as a JSON object in UTF-8, and arrays as little-endian bytes. Where a value is an array, the words have an object
``{"array": "f4", "at": 0, "count": 180}``: the type of its numbers as numpy names it, the first byte among the arrays,
and how many numbers there are.
"""

from __future__ import annotations

import json
import struct
from io import BufferedIOBase
from typing import Any, BinaryIO, cast

VERSION = 1
LONGEST = 64 * 1024 * 1024
"""A longer frame is an error of the sender [bytes]."""

_HEAD = struct.Struct("<ii")
_decode = json.JSONDecoder().decode


class ProtocolError(Exception):
    """The other side sent what is no frame, or a frame that is too long would be sent."""


def _number(value: Any) -> Any:
    """Return a number of numpy as one of Python, without loading numpy."""
    if type(value).__module__ == "numpy" and not getattr(value, "shape", True):
        return value.item()
    raise TypeError(
        f"A value of type '{type(value).__name__}' cannot be sent. Maybe use numbers, texts, lists or dicts."
    )


_text = json.JSONEncoder(ensure_ascii=False, check_circular=False, separators=(",", ":"), default=_number).encode


def encode(words: Any) -> bytes:
    """Return words as JSON in UTF-8.

    :raises TypeError: when a value is not a number, text, list or dict
    :raises ValueError: when a text has a character that UTF-8 cannot have
    """
    return _text(words).encode()


class Frames:
    """Reads and writes frames. Not for two threads at a time."""

    def __init__(self, source: BinaryIO, sink: BinaryIO) -> None:
        """``sink`` has no buffer, or ``write`` flushes it."""
        self._read = source.read
        self._write = sink.write
        self._flush = sink.flush
        self._source = source
        self._again: tuple[bytes, dict[str, Any]] = (b"{}", {})

    def read(self) -> tuple[dict[str, Any], memoryview] | None:
        """Return the words and the arrays of the next frame; ``None`` when the other side has ended."""
        lengths = self._lengths()
        if lengths is None:
            return None
        length, words = lengths
        body = self._read(length)
        if len(body) < length:
            return None
        return _decode(str(body[:words], "utf-8")), memoryview(body)[words:]

    def _lengths(self) -> tuple[int, int] | None:
        """Read how long a frame is, and its words."""
        head = self._read(_HEAD.size)
        if len(head) < _HEAD.size:
            return None
        length, words = _HEAD.unpack(head)
        if not 0 <= words <= length <= LONGEST:
            raise ProtocolError(f"A frame cannot have {length} bytes with {words} of words.")
        return length, words

    def read_into(self, arrays: bytearray) -> dict[str, Any] | None:
        """Read a frame whose arrays have a known size into a buffer, and return its words, which must not be changed.

        A frame without arrays leaves the buffer as it is. ``None`` when the other side has ended.
        """
        lengths = self._lengths()
        if lengths is None:
            return None
        length, words = lengths
        if length - words not in (0, len(arrays)):
            raise ProtocolError(f"A frame has arrays of {length - words} bytes instead of {len(arrays)}.")
        text = self._read(words)
        if text != self._again[0]:  # most are like the one before
            self._again = (text, _decode(str(text, "utf-8")))
        if length > words and cast(BufferedIOBase, self._source).readinto(arrays) < len(arrays):
            return None
        return self._again[1]

    def write(self, words: dict[str, Any], arrays: bytes = b"") -> None:
        """Write a frame.

        :raises TypeError: when a value cannot be sent
        :raises ProtocolError: when it is too long; then nothing was written
        """
        self.write_text(encode(words), arrays)

    def write_text(self, text: bytes, arrays: bytes = b"") -> None:
        """Write a frame of words that :func:`encode` gave.

        :raises ProtocolError: when it is too long; then nothing was written
        """
        length = len(text) + len(arrays)
        if length > LONGEST:
            raise ProtocolError(f"A frame cannot have {length} bytes; at most {LONGEST} can be sent.")
        frame = _HEAD.pack(length, len(text)) + text + arrays
        written = self._write(frame)
        while written < len(frame):  # a sink without a buffer may take a part, when a signal comes
            frame = frame[written:]
            written = self._write(frame)
        self._flush()

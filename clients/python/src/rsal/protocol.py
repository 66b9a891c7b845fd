"""Frames between RSAL in Java and Python, over pipes.

A frame is the length of what follows its head, the length of its words (both as little-endian 32-bit integers), the
words as a JSON object in UTF-8, and arrays as little-endian bytes. Where a value is an array, the words have an object
``{"array": "f4", "at": 0, "count": 180}``: the type of its numbers as numpy names it, the first byte among the arrays,
and how many numbers there are.
"""

from __future__ import annotations

import json
import struct
from typing import Any, BinaryIO

VERSION = 1
LONGEST = 64 * 1024 * 1024
"""A longer frame is an error of the sender [bytes]."""

_HEAD = struct.Struct("<ii")
_decode = json.JSONDecoder().decode
_encode = json.JSONEncoder(ensure_ascii=False, check_circular=False, separators=(",", ":")).encode


class ProtocolError(Exception):
    """The other side sent what is no frame."""


class Frames:
    """Reads and writes frames. Not for two threads at a time."""

    def __init__(self, source: BinaryIO, sink: BinaryIO) -> None:
        """``sink`` has no buffer, or ``write`` flushes it."""
        self._read = source.read
        self._write = sink.write
        self._flush = sink.flush

    def read(self) -> tuple[dict[str, Any], memoryview] | None:
        """The words and the arrays of the next frame; ``None`` when the other side has ended."""
        head = self._read(8)
        if len(head) < 8:
            return None
        length, words = _HEAD.unpack(head)
        if not 0 <= words <= length <= LONGEST:
            raise ProtocolError(f"A frame cannot have {length} bytes with {words} of words.")
        body = self._read(length)
        if len(body) < length:
            return None
        return _decode(str(body[:words], "utf-8")), memoryview(body)[words:]

    def write(self, words: dict[str, Any], arrays: bytes = b"") -> None:
        text = _encode(words).encode()
        self._write(_HEAD.pack(len(text) + len(arrays), len(text)) + text + arrays)
        self._flush()

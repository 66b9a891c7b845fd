"""How an agent in Python reaches RSAL: what it asks for is done in its own turn, in order."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

from rsal.errors import RsalError
from rsal.protocol import LONGEST, Frames, encode

HOME = str(Path(__file__).absolute().parents[1])
"""The folder of this package: frames of a stack in it are none of an agent's."""

Heard = Callable[[Any, memoryview], None]
"""Takes the words and arrays of something that an agent waits for."""

MOST = LONGEST // 4
"""What an agent may ask for at once [bytes]: turns of several agents are in one frame."""


class Outbox:
    """Turns that are over and that RSAL does not know yet, as JSON."""

    def __init__(self, frames: Frames) -> None:
        self._frames = frames
        self._turns: list[bytes] = []
        self._size = 0

    def add(self, turn: bytes) -> None:
        """Keep a turn until the next frame. What does not fit into one frame is sent before."""
        if self._size + len(turn) > LONGEST // 2:
            self.send()
        self._turns.append(turn)
        self._size += len(turn) + 1

    def send(self, question: bytes = b"") -> None:
        """Send the turns, with members of a question after them."""
        turns, self._turns, self._size = self._turns, [], 0
        self._frames.write_text(b'{"turns":[' + b",".join(turns) + b"]" + question + b"}")


class Link:
    """One agent's. What needs no answer is kept until the end of the turn, or until something is asked."""

    def __init__(self, frames: Frames, number: int, outbox: Outbox) -> None:
        self._frames = frames
        self._outbox = outbox
        self._last = 0
        self._asked: list[bytes] = []
        self._size = 0
        self.number = number
        self.heard: dict[int, Heard] = {}
        self.time = 0.0
        self.ended = False

    def listen(self, heard: Heard) -> int:
        """Return a new number, under which something is heard."""
        self._last += 1
        self.heard[self._last] = heard
        return self._last

    def do(self, verb: str, *arguments: Any) -> None:
        """Keep a request without an answer until the end of the turn. After the agent's end it is dropped.

        :raises TypeError: when an argument cannot be sent
        """
        if self.ended:
            return
        request = encode([verb, place(), *arguments])
        self._size += len(request) + 1
        if self._size > MOST:
            self._size -= len(request) + 1
            raise _too_long(self._size + len(request))
        self._asked.append(request)

    def ask(self, verb: str, *arguments: Any) -> tuple[Any, memoryview]:
        """Do what was kept, and ask.

        :raises TypeError: when an argument cannot be sent
        :raises RsalError: when RSAL cannot answer, or the agent has ended
        """
        if self.ended:
            raise RsalError("The agent has ended: RSAL answers it no more.")
        request = encode([verb, place(), *arguments])
        if len(request) > MOST:
            raise _too_long(len(request))
        self._outbox.send(b',"agent":%d,"do":%b,"ask":%b' % (self.number, self.take(), request))
        answer = self._frames.read()
        if answer is None:
            os._exit(0)  # the run is over
        words, arrays = answer
        if "error" in words:
            raise RsalError(words["error"])
        return words["value"], arrays

    def take(self) -> bytes:
        """Return what was kept, as JSON, and keep it no more."""
        asked, self._asked, self._size = self._asked, [], 0
        return b"[" + b",".join(asked) + b"]"

    def cancel(self, number: int) -> None:
        """End the callbacks of a number. Cancelling twice does nothing."""
        if self.heard.pop(number, None) is not None:
            self.do("cancel", number)


def _too_long(size: int) -> ValueError:
    return ValueError(f"An agent cannot send {size} bytes in one turn; at most {MOST} can be. Maybe send less at once.")


_OWN: dict[CodeType, bool] = {}
_PLACES: dict[tuple[CodeType, int], str] = {}
_MOST_PLACES = 10_000


def place() -> str:
    """Where the agent's own code is: ``hunter.py:42 in on_scan``."""
    frame: FrameType | None = sys._getframe(2)
    while frame is not None:
        code = frame.f_code
        own = _OWN.get(code)
        if own is None:
            own = _OWN[code] = not code.co_filename.startswith(HOME)
        if own:
            break
        frame = frame.f_back
    else:
        return ""
    key = (code, frame.f_lasti)
    known = _PLACES.get(key)
    if known is None:
        if len(_PLACES) >= _MOST_PLACES:  # of code that is made again and again
            _PLACES.clear()
            _OWN.clear()
        known = _PLACES[key] = f"{code.co_filename}:{frame.f_lineno} in {code.co_name}"
    return known

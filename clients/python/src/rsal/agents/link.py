"""How an agent in Python reaches RSAL: what it asks for is done in its own turn, in order."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

from rsal.protocol import Frames

HOME = str(Path(__file__).absolute().parents[1])
"""The folder of this package: frames of a stack in it are none of an agent's."""

Heard = Callable[[Any, memoryview], None]
"""Takes the words and arrays of something that an agent waits for."""


class RsalError(Exception):
    """RSAL cannot do what the agent asked for. The message says why."""


class Link:
    """One agent's. What needs no answer is kept until the end of the turn, or until something is asked."""

    def __init__(self, frames: Frames, number: int, over: list[Any]) -> None:
        """``over`` has the turns that are over and that RSAL does not know yet."""
        self._frames = frames
        self._over = over
        self.number = number
        self._last = 0
        self.heard: dict[int, Heard] = {}
        self.asked: list[Any] = []
        self.time = 0.0
        self.ended = False

    def listen(self, heard: Heard) -> int:
        """Return a new number, under which something is heard."""
        self._last += 1
        self.heard[self._last] = heard
        return self._last

    def do(self, verb: str, *arguments: Any) -> None:
        """Keep a request without an answer until the end of the turn."""
        self.asked.append([verb, place(), *arguments])

    def ask(self, verb: str, *arguments: Any) -> tuple[Any, memoryview]:
        """Do what was kept, and ask.

        :raises RsalError: when RSAL cannot answer
        """
        kept, self.asked = self.asked, []
        self._frames.write({"turns": self._over, "agent": self.number, "do": kept, "ask": [verb, place(), *arguments]})
        self._over.clear()
        answer = self._frames.read()
        if answer is None:
            os._exit(0)  # the run is over
        words, arrays = answer
        if "error" in words:
            raise RsalError(words["error"])
        return words["value"], arrays

    def cancel(self, number: int) -> None:
        """End the callbacks of a number. Cancelling twice does nothing."""
        if self.heard.pop(number, None) is not None:
            self.do("cancel", number)


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
        if len(_PLACES) >= _MOST_PLACES:  # of code that is made anew again and again
            _PLACES.clear()
            _OWN.clear()
        known = _PLACES[key] = f"{code.co_filename}:{frame.f_lineno} in {code.co_name}"
    return known

"""What agents wait for, in the time of the run. A coroutine goes on in the turn of its agent; no event loop is used."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Generator
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class Pending(Generic[T]):
    """Something that comes later, once: ``result = await pending``, or ``pending.on_result(self.on_arrival)``."""

    def __init__(self) -> None:
        self._done = False
        self._value: Any = None
        self._listeners: list[Callable[[T], object]] = []

    @property
    def done(self) -> bool:
        """Whether the result is there."""
        return self._done

    @property
    def result(self) -> T | None:
        """What came; ``None`` before."""
        value: T | None = self._value
        return value

    def on_result(self, listener: Callable[[T], object]) -> None:
        """Call a method with the result, when it comes; at once when it has come."""
        if self._done:
            listener(self._value)
        else:
            self._listeners.append(listener)

    def _end(self, value: T) -> None:
        self._done = True
        self._value = value
        listeners, self._listeners = self._listeners, []
        for listener in listeners:
            listener(value)

    def __await__(self) -> Generator[Any, Any, T]:
        if not self._done:
            yield self
        value: T = self._value
        return value


class Task:
    """A coroutine of an agent. What it throws ends the agent, in the turn in which it goes on."""

    def __init__(self, coroutine: Coroutine[Any, Any, Any], over: Callable[[Task], None]) -> None:
        self._coroutine = coroutine
        self._over = over

    def go_on(self, value: Any = None) -> None:
        """Run the coroutine until it waits again, with the value that it waited for."""
        try:
            waited = self._coroutine.send(value)
            while not isinstance(waited, Pending):
                waited = self._coroutine.throw(
                    TypeError(
                        f"An agent cannot wait for '{type(waited).__name__}'. It waits for goals, requests and"
                        " 'self.sleep(seconds)', in the time of the run; asyncio has the time of the machine."
                    )
                )
        except StopIteration:
            self._over(self)
            return
        waited.on_result(self.go_on)

    def close(self) -> None:
        """End the coroutine early; its ``finally`` blocks run."""
        self._coroutine.close()

"""What agents wait for, in the time of the run. A coroutine goes on in the turn of its agent; no event loop is used."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Generator
from inspect import iscoroutine
from typing import Any, Generic, TypeVar

from rsal.errors import RsalError

T = TypeVar("T")


def _call(method: Callable[..., object], *arguments: Any) -> None:
    result = method(*arguments)
    if iscoroutine(result):
        result.close()
        raise TypeError(f"'{getattr(method, '__name__', method)}' is async, and nobody can begin it here.")


class Pending(Generic[T]):
    """Something that comes later, once: ``result = await pending``, or ``pending.on_result(self.on_arrival)``.

    Where RSAL cannot do what was asked for, ``await`` raises :class:`RsalError`. Where nobody awaits it, that ends the
    agent.
    """

    def __init__(self, run: Callable[..., object] = _call) -> None:
        """``run`` calls listeners, and begins those that are async: it is ``_run`` of the agent."""
        self._run = run
        self._done = False
        self._value: Any = None
        self._why = ""
        self._listeners: list[Callable[[T], object] | Task] = []

    @property
    def done(self) -> bool:
        """Whether the result is there, or there will be none."""
        return self._done

    @property
    def result(self) -> T | None:
        """What came; ``None`` before."""
        value: T | None = self._value
        return value

    def on_result(self, listener: Callable[[T], object]) -> None:
        """Call a method with the result, when it comes; at once when it has come. It may be ``async``."""
        if not self._done:
            self._listeners.append(listener)
        elif not self._why:
            self._run(listener, self._value)

    def _end(self, value: T) -> None:
        self._done = True
        self._value = value
        listeners, self._listeners = self._listeners, []
        for listener in listeners:
            if isinstance(listener, Task):
                listener.go_on(value)
            else:
                self._run(listener, value)

    def _fail(self, why: str, place: str) -> None:
        """End without a result, for a reason; ``place`` is where it was asked for."""
        self._done = True
        self._why = why or "There is no result."
        listeners, self._listeners = self._listeners, []
        tasks = [each for each in listeners if isinstance(each, Task)]
        if not tasks:
            raise RsalError(f"asked for at {place}: {self._why}")
        for task in tasks:
            task.go_on()

    def __await__(self) -> Generator[Any, Any, T]:
        if not self._done:
            yield self
        if self._why:
            raise RsalError(self._why)
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
        if waited.done:
            self.go_on()
        else:
            waited._listeners.append(self)

    def close(self) -> None:
        """End the coroutine early; its ``finally`` blocks run."""
        self._coroutine.close()

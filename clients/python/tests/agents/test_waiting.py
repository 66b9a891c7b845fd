"""Coroutines of agents, without an event loop."""

from __future__ import annotations

import asyncio

import pytest

from rsal.agents.waiting import Pending, Task
from rsal.errors import RsalError


def test_a_coroutine_goes_on_when_what_it_waits_for_comes() -> None:
    first: Pending[int] = Pending()
    second: Pending[str] = Pending()
    said: list[object] = []
    over: list[Task] = []

    async def both() -> None:
        said.append(await first)
        said.append(await second)
        said.append(await second)  # which is there

    task = Task(both(), over.append)
    task.go_on()
    assert said == []
    second._end("two")
    assert said == []
    first._end(1)
    assert said == [1, "two", "two"]
    assert over == [task]


def test_listeners_are_told_once() -> None:
    pending: Pending[int] = Pending()
    said: list[int] = []
    pending.on_result(said.append)
    assert pending.result is None
    pending._end(3)
    pending.on_result(said.append)
    assert said == [3, 3]
    assert pending.done
    assert pending.result == 3


def test_what_a_coroutine_throws_comes_out_where_it_goes_on() -> None:
    pending: Pending[int] = Pending()

    async def fails() -> None:
        await pending
        raise ValueError("so")

    Task(fails(), lambda _task: None).go_on()
    with pytest.raises(ValueError, match="so"):
        pending._end(1)


def test_asyncio_is_refused() -> None:
    async def sleeps() -> None:
        await asyncio.sleep(0)

    with pytest.raises(TypeError, match=r"self\.sleep"):
        Task(sleeps(), lambda _task: None).go_on()


def test_an_error_is_thrown_where_it_is_waited_for() -> None:
    pending: Pending[int] = Pending()
    said: list[str] = []

    async def waits(name: str) -> None:
        try:
            await pending
        except RsalError as error:
            said.append(f"{name}: {error}")

    for name in ("a", "b"):
        Task(waits(name), lambda _task: None).go_on()
    pending.on_result(lambda _value: said.append("never"))
    pending._fail("lost", "")
    Task(waits("late"), lambda _task: None).go_on()
    assert said == ["a: lost", "b: lost", "late: lost"]
    assert pending.done
    assert pending.result is None


def test_an_error_for_which_nobody_waits_is_not_lost() -> None:
    pending: Pending[int] = Pending()
    pending.on_result(print)
    with pytest.raises(RsalError, match=r"asked for at a\.py:1 in f: lost"):
        pending._fail("lost", "a.py:1 in f")


def test_an_async_listener_without_an_agent_is_refused() -> None:
    async def listens(_value: int) -> None:
        pass

    pending: Pending[int] = Pending()
    pending.on_result(listens)
    with pytest.raises(TypeError, match="'listens' is async"):
        pending._end(1)

"""Coroutines of agents, without an event loop."""

from __future__ import annotations

import asyncio

import pytest

from rsal.agents.waiting import Pending, Task


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

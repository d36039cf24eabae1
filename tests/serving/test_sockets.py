"""A socket's queue after its visitor has left."""

from __future__ import annotations

import asyncio
from collections import deque
from time import monotonic, thread_time
from typing import Any

import pytest
from bokeh.protocol.messages.patch_doc import patch_doc

from components.serving.sockets import CHEAP, Socket, metered


def test_who_leaves_while_a_change_is_answered_is_no_visitor_any_more() -> None:
    """The connection has no session then: nothing is counted, and no error occurs."""

    async def leave(_: Any) -> None:
        socket.gone.set()

    socket: Any = Socket.__new__(Socket)
    socket._waiting, socket._rests, socket._work = deque([(0.0, patch_doc.__new__(patch_doc))]), 0.0, "at it"
    socket.gone, socket.connection, socket._answer = asyncio.Event(), object(), leave
    asyncio.run(socket._work_off())
    assert socket._work is None


def test_who_asks_for_much_waits_for_longer_than_it_took() -> None:
    """A cheap answer is awaited for as long again, an expensive one many times as long."""

    def rest_after(seconds: float) -> float:
        async def work(_: Any) -> None:
            await busy(seconds)

        socket: Any = Socket.__new__(Socket)
        socket._waiting, socket._rests, socket._work = deque([(0.0, patch_doc.__new__(patch_doc))]), 0.0, "at it"
        socket.gone, socket.connection, socket._answer = asyncio.Event(), None, work
        asyncio.run(socket._work_off())
        return float(socket._rests) - monotonic()

    assert rest_after(0.5 * CHEAP) < CHEAP
    assert rest_after(5 * CHEAP) > 20 * CHEAP


async def busy(seconds: float) -> None:
    end = thread_time() + seconds
    while thread_time() < end:
        pass


def test_nobody_pays_for_what_another_asks_for_meanwhile() -> None:
    async def patient() -> None:
        await busy(0.01)
        await asyncio.sleep(0.01)
        await asyncio.sleep(0)

    async def both() -> float:
        other = asyncio.create_task(busy(0.2))
        took = await metered(patient())
        await other
        return took

    assert 0.01 <= asyncio.run(both()) < 0.1


def test_what_is_metered_fails_and_is_cancelled_as_it_is_without() -> None:
    async def fail() -> None:
        await asyncio.sleep(0)
        raise ValueError("as it is")

    async def cancelled() -> bool:
        ended = asyncio.Event()

        async def wait() -> None:
            try:
                await asyncio.sleep(60)
            finally:
                ended.set()

        async def pay() -> None:
            await metered(wait())

        task = asyncio.create_task(pay())
        await asyncio.sleep(0)
        task.cancel()
        await asyncio.wait([task])
        return ended.is_set() and task.cancelled()

    with pytest.raises(ValueError, match="as it is"):
        asyncio.run(metered(fail()))  # type: ignore[arg-type]
    assert asyncio.run(cancelled())

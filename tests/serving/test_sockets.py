"""A socket's queue: what becomes of it when its visitor leaves."""

from __future__ import annotations

import asyncio
from collections import deque
from typing import Any

from bokeh.protocol.messages.patch_doc import patch_doc

from components.serving.sockets import Socket


def test_who_leaves_while_a_change_is_answered_is_no_visitor_any_more() -> None:
    """The connection has no session then: nothing is counted, and nothing goes wrong."""

    async def leave(_: Any) -> None:
        socket.gone.set()

    socket: Any = Socket.__new__(Socket)
    socket._waiting, socket._rests, socket._work = deque([(0.0, patch_doc.__new__(patch_doc))]), 0.0, "at it"
    socket.gone, socket.connection, socket._answer = asyncio.Event(), object(), leave
    asyncio.run(socket._work_off())
    assert socket._work is None

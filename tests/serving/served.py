"""A server in the process of the test, on a free port of this machine."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import asynccontextmanager
from typing import Any

from bokeh.document import Document
from bokeh.server.session import ServerSession

from app import SHEETS, open_page
from components.serving.server import Extension, Server
from components.serving.settings import Settings
from tests.attack.caller import Reply, ask

MUCH = 10**6


@asynccontextmanager
async def served(
    page: Callable[[Document], None] = open_page,
    *,
    figures: Mapping[str, tuple[str, Callable[[], float]]] | None = None,
    extensions: Sequence[Extension] = (),
    **settings: Any,
) -> AsyncIterator[Server]:
    """Yield a server with these settings that can open any number of pages, and end it."""
    made = Settings(**{"address": "127.0.0.1", "port": 0, "arrivals": MUCH, **settings})
    server = Server(page, made, figures, SHEETS, extensions)
    try:
        yield server
    finally:
        await server.end()


def url(server: Server) -> str:
    return f"http://127.0.0.1:{server.port}/"


async def page_of(server: Server, path: str = "/", method: str = "GET", **headers: str) -> Reply:
    """Return the reply to a request that another thread sends."""
    return await asyncio.to_thread(ask, url(server), path, method, **headers)


def sessions(server: Server) -> list[ServerSession]:
    found: list[ServerSession] = server.lecture.get_sessions("/")
    return found


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(30):
        while not condition():
            await asyncio.sleep(0.01)

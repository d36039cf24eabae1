"""A server with a live class, and the requests that tests send to it."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from typing import Any

from app import SHEETS, walked
from components.live_class.routes import LiveClass
from components.live_class.store import MemoryStore, Store
from components.serving.server import Server
from components.serving.settings import Settings
from tests.live_class.caller import streams_closed

LECTURE = walked([])
CHOICE = {"walk": "d31", "step": "d31-03"}


@asynccontextmanager
async def served(store: Store | None = None, **settings: Any) -> AsyncIterator[tuple[Server, str]]:
    """Yield such a server. At the end, close all streams that the test has opened."""
    made = Settings(**{"address": "127.0.0.1", "port": 0, **settings})
    live_class = LiveClass(store or MemoryStore(), LECTURE.bank, made.class_passphrase, made.bokeh_secret_key)
    page = partial(LECTURE.open_page, lead=live_class.lead)
    server = Server(page, made, sheets={**SHEETS, **LECTURE.files}, extensions=[live_class], start=LECTURE.start)
    server.classes = live_class.context
    try:
        async with streams_closed():
            yield server, f"http://127.0.0.1:{server.port}/"
    finally:
        await server.end()

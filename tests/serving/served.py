"""A server in the process of the test, on a free port of this machine."""

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from concurrent.futures import Future
from contextlib import asynccontextmanager
from functools import cache
from typing import Any

from bokeh.document import Document
from bokeh.server.session import ServerSession

from app import Lectured, walked
from components.serving.server import Extension, Server
from components.serving.settings import Settings
from components.serving.start import StartPage
from components.session.worker import Replied, WorkerJob
from tests.live_class.caller import Answered
from tests.serving.visitor import ask

MUCH = 10**6


@cache
def lecture() -> Lectured:
    """The lecture without walks of an instructor. It takes seconds, and browser tests do not need it."""
    return walked([])


@asynccontextmanager
async def served(
    page: Callable[[Document], None] | None = None,
    *,
    figures: Mapping[str, tuple[str, Callable[[], float]]] | None = None,
    extensions: Sequence[Extension] = (),
    start: StartPage | None = None,
    **settings: Any,
) -> AsyncIterator[Server]:
    """Yield a server with these settings that can open any number of pages, and end it."""
    made = Settings(**{"address": "127.0.0.1", "port": 0, "arrivals": MUCH, **settings})
    server = Server(page or lecture().open_page, made, figures, lecture().files, extensions, start)
    try:
        yield server
    finally:
        await server.end()


class FakeWorker:
    """A worker that keeps its jobs. It gives each the same reply at once, or none."""

    def __init__(self, reply: Replied | None = None) -> None:
        self.reply = reply
        self.jobs: list[tuple[WorkerJob, str]] = []
        self.replies: list[Future[Replied]] = []

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        self.jobs.append((asked, network))
        self.replies.append(Future())
        if self.reply:
            self.replies[-1].set_result(self.reply)
        return self.replies[-1]


def url(server: Server) -> str:
    return f"http://127.0.0.1:{server.port}/"


async def page_of(server: Server, path: str = "/", method: str = "GET", **headers: str) -> Answered:
    """Return the reply to a request that another thread sends."""
    return await asyncio.to_thread(ask, url(server), path, method, **headers)


def sessions(server: Server) -> list[ServerSession]:
    found: list[ServerSession] = server.lecture.get_sessions("/")
    return found

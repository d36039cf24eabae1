"""CSV files by address: `/data.csv?scene=coupled&k2=3` is the file that a page with this link saves."""

from __future__ import annotations

import asyncio
from concurrent.futures import Future
from typing import Any

from components.serving.handlers import RefusedError, VisitorHandler
from components.serving.metrics import Looked
from components.serving.pages import LONGEST_LINK, TOO_LONG, TOO_MANY
from components.serving.server import Route
from components.serving.visitors import Arrivals, network_of
from components.session.exports import LinkExport
from components.session.worker import Replied, Worker


class NumbersHandler(VisitorHandler):
    """The handler of the table of a link. The worker makes it; an impossible link is refused in a sentence."""

    asked: Future[Replied] | None = None

    def initialize(self, worker: Worker, arrivals: Arrivals) -> None:
        self.worker, self.arrivals = worker, arrivals

    async def get(self) -> None:
        if len(self.request.query) > LONGEST_LINK:
            raise RefusedError(414, TOO_LONG)
        if seconds := self.arrivals.admit(self.visitor):
            raise RefusedError(429, TOO_MANY, after=seconds)
        page = self.context.settings.public_url or f"{self.request.protocol}://{self.request.host}/"
        self.asked = self.worker.ask(LinkExport(self.request.arguments, page), str(network_of(self.visitor)))
        replied = await asyncio.wrap_future(self.asked)
        if replied.file is None:
            raise RefusedError(429 if replied.is_busy else 400, replied.refused, after=replied.after)
        self.set_header("Content-Type", f"{replied.file.kind}; charset=ascii")
        self.set_header("Content-Disposition", f'attachment; filename="{replied.file.name}"')
        self.set_header("Cache-Control", "no-cache")
        self.write(replied.file.content)

    head = get

    def on_connection_close(self) -> None:
        """Remove the job from the line, because the client has left."""
        if self.asked:
            self.asked.cancel()

    def write_notice(self, sentence: str) -> None:
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(sentence + "\n")


class NumbersRoute:
    """The extension for this address. One network may request as many tables per minute as it may open pages."""

    def __init__(self, worker: Worker, arrivals: int) -> None:
        self._given: dict[str, Any] = {"worker": worker, "arrivals": Arrivals(arrivals)}

    def routes(self) -> list[Route]:
        return [(r"/data\.csv", NumbersHandler, self._given)]

    def figures(self) -> Looked:
        return {}

    def start(self) -> None:
        """Do nothing, because this address has no background work."""

    async def end(self) -> None:
        """Do nothing, because this address has no background work."""

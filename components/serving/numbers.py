"""Numbers by address: `/data.csv?scene=coupled&k2=3` has what a page of that link takes away, for programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from components.language.messages import File
from components.serving.handlers import RefusedError, VisitorHandler
from components.serving.metrics import Looked
from components.serving.pages import LONGEST_LINK, TOO_LONG, TOO_MANY
from components.serving.server import Route
from components.serving.visitors import Arrivals

NumbersOf = Callable[[Mapping[str, Sequence[bytes]], str], File]


class NumbersHandler(VisitorHandler):
    """The table of a link as a file; a link that cannot be is refused in a sentence."""

    def initialize(self, numbers_of: NumbersOf, arrivals: Arrivals) -> None:
        self.numbers_of, self.arrivals = numbers_of, arrivals

    def get(self) -> None:
        if len(self.request.query) > LONGEST_LINK:
            raise RefusedError(414, TOO_LONG)
        if seconds := self.arrivals.admit(self.visitor):
            raise RefusedError(429, TOO_MANY, after=seconds)
        page = self.context.settings.public_url or f"{self.request.protocol}://{self.request.host}/"
        try:
            file = self.numbers_of(self.request.arguments, page)
        except ValueError as reason:
            raise RefusedError(400, str(reason)) from reason
        self.set_header("Content-Type", f"{file.kind}; charset=ascii")
        self.set_header("Content-Disposition", f'attachment; filename="{file.name}"')
        self.set_header("Cache-Control", "no-cache")
        self.write(file.content)

    head = get


class NumbersRoute:
    """The extension of a server by this address; one network asks for as many tables a minute as it may open pages."""

    def __init__(self, numbers_of: NumbersOf, arrivals: int) -> None:
        self._given = {"numbers_of": numbers_of, "arrivals": Arrivals(arrivals)}

    def routes(self) -> list[Route]:
        return [(r"/data\.csv", NumbersHandler, self._given)]

    def figures(self) -> Looked:
        return {}

    def start(self) -> None:
        """Nothing goes on beside it."""

    async def end(self) -> None:
        """Nothing is left."""

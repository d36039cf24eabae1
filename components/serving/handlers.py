"""Base classes of all handlers. A refusal or an error becomes a page with one sentence."""

from __future__ import annotations

import logging
from functools import cache
from math import ceil
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, Template
from tornado.web import HTTPError, RequestHandler

from components.serving.context import Context
from components.serving.headers import SAFE, policy
from components.serving.hosts import answers_to
from components.serving.visitors import address_of

log = logging.getLogger(__name__)

SENTENCES = {
    400: "This request is not one that a browser sends.",
    403: "This is not open to visitors.",
    404: "There is no such page here.",
    405: "This page can only be read.",
    500: "Something went wrong on the server and was logged. The page may open if you try again.",
}


class RefusedError(HTTPError):
    """A refused request. The sentence says why, and what you can do; `after` is the number of seconds to wait."""

    def __init__(self, status: int, sentence: str, after: float = 0.0) -> None:
        super().__init__(status)
        self.sentence = sentence
        self.after = after


@cache
def templates() -> Environment:
    return Environment(loader=FileSystemLoader(Path(__file__).parent), autoescape=True)


@cache
def notice() -> Template:
    return templates().get_template("notice.html")


class LectureHandler(RequestHandler):
    """A handler that reports failures in a sentence."""

    log_level = logging.INFO
    """Level of the log line of a successful request."""

    @property
    def context(self) -> Context:
        context: Context = self.settings["context"]
        return context

    def set_default_headers(self) -> None:
        self.clear_header("Server")  # the version of the server is not public
        self.set_header("Content-Security-Policy", policy(self.context.settings.frame_ancestors))
        for name, value in SAFE.items():
            self.set_header(name, value)

    @property
    def visitor(self) -> str:
        """Return the address that the request comes from."""
        return address_of(self.request, self.context.trusted)

    def log_exception(self, kind: Any, error: Any, trace: Any) -> None:
        """Log each error once, without address or query; refusals are in the access log."""
        if not isinstance(error, HTTPError):
            log.error("%s %s failed", self.request.method, self.request.path, exc_info=(kind, error, trace))

    def write_error(self, status_code: int, **more: Any) -> None:
        error = more.get("exc_info", (None, None, None))[1]
        sentence = error.sentence if isinstance(error, RefusedError) else SENTENCES.get(status_code, SENTENCES[400])
        self.set_header("Cache-Control", "no-store")
        if isinstance(error, RefusedError) and error.after:
            self.set_header("Retry-After", str(ceil(error.after)))
        self.context.metrics.refused.labels(f"request {status_code}").inc()
        self.write_notice(sentence)

    def write_notice(self, sentence: str) -> None:
        """Finish with a page that has one sentence."""
        self.finish(notice().render(sentence=sentence))


class VisitorHandler(LectureHandler):
    """A handler that answers only under the server's own host names."""

    async def prepare(self) -> None:
        host = self.request.headers.get("Host", "")
        if not answers_to(host, self.context.hosts):
            raise RefusedError(
                403, "This server is not known by this address. Its operator can allow the address with ALLOWED_ORIGIN."
            )
        if more := super().prepare():
            await more


class Missing(LectureHandler):
    """The handler of unknown addresses."""

    async def prepare(self) -> None:
        raise HTTPError(404)


class Moved(LectureHandler):
    """A redirect from a former address of the page, with the query. It is relative, because a proxy may serve the
    lecture under a path.
    """

    def initialize(self, to: str) -> None:
        self.to = to

    def get(self) -> None:
        query = f"?{self.request.query}" if self.request.query else ""
        self.redirect(f"{self.to}{query}")

    head = get

"""The page itself: a new session for each visit, the HTML around it, and the token that opens the session."""

from __future__ import annotations

import gzip
import logging
from collections.abc import Callable
from functools import lru_cache
from secrets import token_urlsafe
from typing import Any

from bokeh.application.handlers.handler import Handler
from bokeh.document import Document
from bokeh.server.session import ServerSession
from bokeh.server.views.session_handler import SessionHandler
from jinja2 import Template
from panel.io.state import set_curdoc
from tornado.httputil import HTTPServerRequest
from tornado.web import HTTPError

from components.serving.admission import ASK_AGAIN, ordinal
from components.serving.assets import takes
from components.serving.bokeh_patches import patch_curdoc
from components.serving.context import Context
from components.serving.handlers import RefusedError, VisitorHandler, templates
from components.serving.headers import policy, scripts_of
from components.serving.shell import follow_template
from components.serving.start import StartPage, start_template
from components.serving.tokens import page_name
from components.serving.visitors import address_of, network_of

log = logging.getLogger(__name__)

LONGEST_LINK = 8000
"""Maximum length of the query in characters: the token contains it, and a header of the WebSocket contains the token.
"""

TOO_LONG = f"This link is too long: at most {LONGEST_LINK} characters are allowed after the question mark."
TOO_MANY = "Too many pages were opened from this network within a minute. Try again in a moment."

OWN_TOKEN, TICKET = "Page-Token", "Page-Ticket"
"""Headers of a page that requests itself again: its old token, and its place in the line."""

OpenPage = Callable[[Document], None]


class Filled(Handler):  # type: ignore[misc]  # Bokeh's are not looked into
    """Fill the document of a new session. If that fails, the document stays empty and the error is logged."""

    def __init__(self, open_page: OpenPage, context: Context) -> None:
        super().__init__()
        self._open_page = open_page
        self._context = context

    def process_request(self, request: HTTPServerRequest) -> dict[str, object]:
        """Data in the page's token. It identifies the visitor's network and the page for every replica; a page that
        fetches itself again keeps its name."""
        page = page_name(request.headers.get(OWN_TOKEN, ""), self._context.secret) or token_urlsafe(9)
        return {"network": str(network_of(address_of(request, self._context.trusted))), "page": page}

    def modify_document(self, doc: Document) -> None:
        # The script of the page reconnects and reports failures.
        doc.config.update(reconnect_session=False, notifications=None, notify_connection_status=False)
        try:
            with patch_curdoc(doc), set_curdoc(doc):
                self._open_page(doc)
        except Exception:
            log.exception("A page could not be opened")
            doc.clear()


@lru_cache(maxsize=4)
def zipped(page: str) -> bytes:
    """Return a page compressed by gzip; 55 kB take 3 ms."""
    return gzip.compress(page.encode(), 6, mtime=0)


class Page(VisitorHandler, SessionHandler):  # type: ignore[misc]  # Bokeh's are not looked into
    """The page of one visitor."""

    def initialize(self, start: StartPage | None = None, **application: Any) -> None:
        super().initialize(**application)
        self._start = start

    async def prepare(self) -> None:
        await super().prepare()
        if len(self.request.query) > LONGEST_LINK:
            raise RefusedError(414, TOO_LONG)
        if "Bokeh-Session-Id" in self.request.headers or any(
            name.startswith("bokeh-") for name in self.request.arguments
        ):
            raise RefusedError(403, "A link cannot name a session: each visitor gets a separate one.")

    async def get(self) -> None:
        if "class" in self.request.arguments:
            self._write_plain(follow_template().render(), follow_template())
            return
        if page := self._begin():
            self._write_plain(page, start_template())
            return
        asked = self.request.arguments.pop("ticket", [b""])[0]  # not part of the link
        shown = self.request.headers.get(TICKET) or asked.decode("latin-1")
        place, ticket = self.context.admission.queue.knock(shown, str(network_of(self.visitor)))
        if place:
            self._wait(place, ticket)
            return
        page = page_name(self.request.headers.get(OWN_TOKEN, ""), self.context.secret)
        if seconds := self.context.admission.wait(self.visitor, page):
            raise RefusedError(429, TOO_MANY, after=seconds)
        session = await self.get_session()
        self.context.admission.note_activity(session)
        if not session.document.roots:
            raise HTTPError(500)
        self.context.metrics.arrivals.inc()
        # The token is valid for this visit only, so a cached page could not connect.
        scripts = scripts_of(session.document.template)
        self.set_header("Cache-Control", "no-store")
        self.set_header("Content-Security-Policy", policy(self.context.settings.frame_ancestors, scripts))
        self.write(page_of(session))

    def _write_plain(self, page: str, template: Template) -> None:
        """A page without a session: the page of a phone in a class, or the start page."""
        self.set_header("Cache-Control", "no-cache")
        self.set_header("Content-Security-Policy", policy(self.context.settings.frame_ancestors, scripts_of(template)))
        self.set_header("Vary", "Accept-Encoding")
        if takes(self.request.headers.get("Accept-Encoding", ""), "gzip"):
            self.set_header("Content-Encoding", "gzip")
            self.write(zipped(page))
        else:
            self.write(page)

    def _begin(self) -> str | None:
        """The start page, unless the link opens a scene. In a frame of another page, a scene opens at once."""
        if not self._start or self.request.headers.get("Sec-Fetch-Dest") == "iframe":
            return None
        return self._start.asked(self.request.arguments)

    def _wait(self, place: int, ticket: str) -> None:
        """A page that needs no session, and polls."""
        parts = [part for part in self.request.query.split("&") if part and not part.startswith("ticket=")]
        page = templates().get_template("waiting.html", globals={"seconds": ASK_AGAIN})
        self.context.metrics.refused.labels("full").inc()
        self.set_status(503)
        self.set_header("Retry-After", str(ASK_AGAIN))
        self.set_header(TICKET, ticket)
        self.set_header("Cache-Control", "no-store")
        self.set_header("Content-Security-Policy", policy(self.context.settings.frame_ancestors, scripts_of(page)))
        address = "?" + "&".join([*parts, f"ticket={ticket}"])
        places = self.context.admission.queue.places
        self.write(page.render(places=places, place=ordinal(place), address=address))

    def head(self) -> None:
        """Report that a page exists, without a session."""


def page_of(session: ServerSession) -> str:
    """Return the page's HTML, with the first picture and the token that opens the session."""
    variables = session.document.template_variables
    html: str = session.document.template.render(token=session.token, data=variables.pop("opening"), **variables)
    return html

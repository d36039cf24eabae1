"""The server of one process: Bokeh's application with our own list of routes, from start to end."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Mapping, Sequence
from contextlib import suppress
from secrets import token_urlsafe
from typing import Any, Protocol

from bokeh.server.tornado import BokehTornado
from bokeh.server.util import bind_sockets
from panel.io.application import Application
from tornado.httpserver import HTTPServer
from tornado.ioloop import IOLoop, PeriodicCallback

from components.serving.admission import Admission
from components.serving.assets import Asset, AssetFiles, assets
from components.serving.bokeh_patches import mend
from components.serving.context import Context
from components.serving.handlers import Missing, Moved
from components.serving.health import Figures, Liveness, Readiness
from components.serving.incoming import MOST_BYTES
from components.serving.logs import log_request
from components.serving.metrics import Looked, Metrics
from components.serving.pages import Filled, OpenPage, Page
from components.serving.settings import Settings
from components.serving.shell import version
from components.serving.sockets import Socket
from components.serving.start import StartPage
from components.serving.visitors import networks

PULSE = 15.0
"""Seconds between pings: proxies drop a socket after a minute of silence."""
PATIENCE = 10.0
"""Seconds for a whole request, and until the next one on the same connection."""
ENDING = 9.0
"""Seconds for the end of a server; container engines allow ten."""

Route = tuple[Any, ...]
"""An address pattern, a handler, and its arguments."""


class Extension(Protocol):
    """An addition to the server: routes, figures for Prometheus, and background work."""

    def routes(self) -> list[Route]: ...

    def figures(self) -> Looked: ...

    def start(self) -> None: ...

    async def end(self) -> None: ...


class Server:
    """The lecture on one port, listening. Create it in a running event loop."""

    def __init__(
        self,
        open_page: OpenPage,
        settings: Settings,
        figures: Looked | None = None,
        sheets: Mapping[str, Asset] | None = None,
        extensions: Sequence[Extension] = (),
        start: StartPage | None = None,
    ) -> None:
        listening, self.port = bind_sockets(settings.address, settings.port)
        self._extensions = extensions
        admission = Admission(settings.sessions, settings.arrivals, lambda: self.lecture.get_sessions("/"))
        looked = {**admission.figures(), **(figures or {})}
        for extension in extensions:
            looked |= extension.figures()
        self.context = Context(
            settings=settings,
            secret=(settings.bokeh_secret_key or token_urlsafe()).encode(),
            hosts=settings.hosts(self.port),
            trusted=networks(settings.trusted_proxies),
            admission=admission,
            metrics=Metrics(version(), **looked),
        )
        self.lecture = _application(open_page, self.context)
        # Routes of Bokeh and Panel (autoload.js, metadata, components, extensions, ...) come after the last of these
        # and are never reached.
        self.lecture.add_handlers(".*", [*self._routes(start, sheets or {}), (r".*", Missing)])
        self.lecture.initialize(IOLoop.current())
        self._http = HTTPServer(
            self.lecture,
            idle_connection_timeout=PATIENCE,
            body_timeout=PATIENCE,
            max_body_size=MOST_BYTES,
            max_buffer_size=16 * MOST_BYTES,
        )
        self._http.add_sockets(listening)
        assets()  # read and compressed before the first request
        self._start()

    def _routes(self, start: StartPage | None, sheets: Mapping[str, Asset]) -> list[Route]:
        page = {"application_context": self.lecture.applications["/"], "bokeh_websocket_path": "/ws"}
        readers = networks(("127.0.0.0/8", "::1", *self.context.settings.metrics_for))
        return [
            (r"/", Page, {**page, "start": start}),
            (r"/ws", Socket, page),
            (r"/app", Moved, {"to": "./"}),
            (r"/app/", Moved, {"to": "../"}),
            (r"/assets/(.*)", AssetFiles, {"more": sheets}),
            *(route for extension in self._extensions for route in extension.routes()),
            (r"/liveness", Liveness),
            (r"/readiness", Readiness),
            (r"/metrics", Figures, {"readers": readers}),
        ]

    def _start(self) -> None:
        self.lecture.start()
        self._pulse = PeriodicCallback(self._check_pulses, 1000 * PULSE)
        self._pulse.start()
        self._watch = asyncio.create_task(self.context.metrics.watch())
        logging.getLogger().addHandler(self.context.metrics.errors)
        for extension in self._extensions:
            extension.start()

    def _check_pulses(self) -> None:
        for socket in list(self.context.admission.sockets):
            socket.pulse()

    async def end(self, notice: float = 0.0) -> None:
        """Close all connections and stop; wait for the sockets to close, but not for long.

        Before that, the server reports for `notice` seconds that it is not ready, so that proxies stop using it.
        """
        self.context.ending.set()
        await asyncio.sleep(notice)
        self._http.stop()
        sockets = list(self.context.admission.sockets)
        for socket in sockets:
            socket.drop(1001, "The server is shutting down.")
        with suppress(TimeoutError):
            async with asyncio.timeout(ENDING - notice):
                await asyncio.gather(*(socket.gone.wait() for socket in sockets))
        for extension in self._extensions:
            await extension.end()
        self._pulse.stop()
        self._watch.cancel()
        logging.getLogger().removeHandler(self.context.metrics.errors)
        self.lecture.stop()
        await self._http.close_all_connections()


def _application(open_page: OpenPage, context: Context) -> BokehTornado:
    """Return Bokeh's application, which manages the sessions. Requests never reach its own routes."""
    mend()
    settings, secret = context.settings, context.secret
    return BokehTornado(
        {"/": Application(Filled(open_page, context))},
        extra_websocket_origins=context.hosts,
        secret_key=secret,
        sign_sessions=True,
        include_headers=["Host"],
        include_cookies=[],
        keep_alive_milliseconds=0,  # our own pings replace Bokeh's, whose answers are not counted
        check_unused_sessions_milliseconds=max(1, min(10_000, int(1000 * settings.unused_seconds))),
        unused_session_lifetime_milliseconds=max(1, int(1000 * settings.unused_seconds)),
        websocket_max_message_size_bytes=MOST_BYTES,
        use_index=False,
        ico_path="none",
        log_function=log_request,
        context=context,
    )

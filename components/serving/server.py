"""The server of one process: Bokeh's application with a list of routes of our own, and its life from start to end."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import suppress
from typing import Any
from urllib.parse import urlsplit

from bokeh.server.tornado import BokehTornado
from bokeh.server.util import bind_sockets
from panel.io.application import Application
from tornado.httpserver import HTTPServer
from tornado.ioloop import IOLoop, PeriodicCallback

from components.rooms.codes import Tokens
from components.rooms.hall import Hall
from components.rooms.lessons import Lessons
from components.rooms.store import MemoryStore
from components.rooms.upkeep import Upkeep
from components.serving.answers import Missing, Moved
from components.serving.assets import AssetFiles, assets, packed_files
from components.serving.classroutes import class_routes
from components.serving.door import Door
from components.serving.health import Figures, Liveness, Readiness
from components.serving.hosts import is_named
from components.serving.incoming import MOST_BYTES
from components.serving.logs import log_request
from components.serving.mended import mend
from components.serving.metrics import Looked, Metrics
from components.serving.pages import Filled, OpenPage, Page
from components.serving.settings import Settings
from components.serving.sockets import Socket
from components.serving.visitors import Arrivals, Rate, networks

PULSE = 15.0
"""Seconds between pings: proxies drop a socket after a minute of silence."""
PATIENCE = 10.0
"""Seconds for the whole of a request, and for the next one on the same connection."""
OF_A_CLASS = 1200
"""Messages a minute of one instructor, follower or remote control."""
OPENINGS = 60
"""Classes that one network may open in a minute."""
ENDING = 9.0
"""Seconds for the end of a server, of which container engines give ten."""


class Lecture(BokehTornado):  # type: ignore[misc]  # Bokeh's are not looked into
    """The lecture on one port."""

    def __init__(
        self,
        open_page: OpenPage,
        settings: Settings,
        port: int,
        figures: Looked,
        sheets: Mapping[str, bytes],
        hall: Hall,
    ) -> None:
        self.sockets: set[Socket] = set()
        self.ending = False
        self._sheets = packed_files(sheets)
        mend()
        super().__init__(
            {"/": Application(Filled(open_page))},  # type: ignore[no-untyped-call]  # Panel's own has no types
            extra_websocket_origins=settings.hosts(port),
            secret_key=settings.bokeh_secret_key.encode(),
            sign_sessions=True,
            include_headers=["Host"],
            include_cookies=[],
            keep_alive_milliseconds=0,  # in place of Bokeh's pings, which nobody counts, come ours
            check_unused_sessions_milliseconds=max(1, min(10_000, int(1000 * settings.unused_seconds))),
            unused_session_lifetime_milliseconds=max(1, int(1000 * settings.unused_seconds)),
            websocket_max_message_size_bytes=MOST_BYTES,
            use_index=False,
            ico_path="none",
            log_function=log_request,
            frame_ancestors=settings.frame_ancestors,
            log_visitors=settings.log_visitors,
            trusted_proxies=networks(settings.trusted_proxies),
        )
        self.asked = settings
        self.hall = hall
        self.upkeep = Upkeep(hall)
        self.tokens = Tokens(settings.bokeh_secret_key)
        self.class_rate = Rate(OF_A_CLASS)
        self.openings = Arrivals(OPENINGS)
        self.arrivals = Arrivals(settings.arrivals)
        self.door = Door(settings.sessions, taken=self._taken)
        self.metrics = Metrics(
            sessions=("Sessions, with and without a visitor", self._taken),
            sockets=("Visitors who are connected", lambda: len(self.sockets)),
            rooms=("Live classes that somebody here leads or follows", lambda: len(hall.rooms)),
            followers=("Those who follow one", lambda: hall.followers),
            **figures,
        )
        # What Bokeh and Panel register (autoload.js, metadata, components, extensions, ...) lies behind the last of
        # these and is never reached.
        self.add_handlers(".*", [*self._routes(), (r".*", Missing)])
        self._pulse = PeriodicCallback(self._feel_pulses, 1000 * PULSE)

    def _routes(self) -> list[tuple[Any, ...]]:
        context = {"application_context": self.applications["/"], "bokeh_websocket_path": "/ws"}
        return [
            (r"/", Page, context),
            (r"/ws", Socket, context),
            (r"/app", Moved, {"to": "./"}),
            (r"/app/", Moved, {"to": "../"}),
            (r"/assets/(.*)", AssetFiles, {"more": self._sheets}),
            *class_routes(),
            (r"/liveness", Liveness),
            (r"/readiness", Readiness),
            (r"/metrics", Figures),
        ]

    def goes_by(self, origin: str) -> bool:
        """Whether pages of that origin are ours."""
        return is_named(urlsplit(origin).netloc, self.websocket_origins)

    def _taken(self) -> int:
        return len(self.get_sessions("/"))

    def start(self) -> None:
        super().start()
        self._pulse.start()
        self.upkeep.start()

    def stop(self, wait: bool = True) -> None:
        self._pulse.stop()
        super().stop(wait)

    def _feel_pulses(self) -> None:
        for socket in list(self.sockets):
            socket.pulse()


class Server:
    """The lecture, listening. To be made in a running event loop."""

    def __init__(
        self,
        open_page: OpenPage,
        settings: Settings,
        figures: Looked | None = None,
        sheets: Mapping[str, bytes] | None = None,
        hall: Hall | None = None,
    ) -> None:
        listening, self.port = bind_sockets(settings.address, settings.port)
        hall = hall or Hall(MemoryStore(), Lessons({}, {}))
        self.lecture = Lecture(open_page, settings, self.port, figures or {}, sheets or {}, hall)
        self.lecture.initialize(IOLoop.current())
        self._http = HTTPServer(
            self.lecture,
            idle_connection_timeout=PATIENCE,
            body_timeout=PATIENCE,
            max_body_size=MOST_BYTES,
            max_buffer_size=16 * MOST_BYTES,
        )
        self._http.add_sockets(listening)
        assets()  # read and compressed before anybody asks
        self.lecture.start()

    async def end(self, notice: float = 0.0) -> None:
        """Send everybody away, and wait until they have gone, but not for long.

        `notice` is how many seconds before that a proxy may see that this server is not ready any more.
        """
        self.lecture.ending = True
        await asyncio.sleep(notice)
        self._http.stop()
        sockets = list(self.lecture.sockets)
        for socket in sockets:
            socket.drop(1001, "The server goes away.")
        with suppress(TimeoutError):
            async with asyncio.timeout(ENDING - notice):
                await asyncio.gather(*(socket.gone.wait() for socket in sockets))
        await self.lecture.upkeep.end()
        self.lecture.stop()
        await self._http.close_all_connections()

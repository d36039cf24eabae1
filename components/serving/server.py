"""The server of one process: Bokeh's application with a list of routes of our own, and its life from start to end."""

from __future__ import annotations

import asyncio
import logging
from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from time import monotonic
from typing import Any
from urllib.parse import urlsplit
from weakref import WeakKeyDictionary

from bokeh.server.session import ServerSession
from bokeh.server.tornado import BokehTornado
from bokeh.server.util import bind_sockets
from bokeh.util.token import get_token_payload
from panel.io.application import Application
from tornado.httpserver import HTTPServer
from tornado.ioloop import IOLoop, PeriodicCallback

from components.live_class.codes import Tokens
from components.live_class.question_bank import QuestionBank
from components.live_class.registry import Registry
from components.live_class.routes import class_routes
from components.live_class.store import MemoryStore
from components.live_class.upkeep import Upkeep
from components.serving.admission import Admission, Guest, gives_way
from components.serving.answers import Missing, Moved
from components.serving.assets import AssetFiles, assets, packed_files
from components.serving.health import Figures, Liveness, Readiness
from components.serving.hosts import is_named
from components.serving.incoming import MOST_BYTES
from components.serving.logs import log_request
from components.serving.mended import mend
from components.serving.metrics import Looked, Metrics
from components.serving.pages import Filled, OpenPage, Page
from components.serving.settings import Settings
from components.serving.shell import version
from components.serving.sockets import Socket
from components.serving.visitors import Arrivals, Rate, networks

PULSE = 15.0
"""Seconds between pings: proxies drop a socket after a minute of silence."""
PATIENCE = 10.0
"""Seconds for the whole of a request, and for the next one on the same connection."""
OF_A_CLASS = 1200
"""Messages a minute of one instructor, follower or remote control."""
RETURNS = 10
"""Times that one page may come back in a minute, not counted among strangers; of a network so many for each arrival."""
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
        registry: Registry,
    ) -> None:
        self.sockets: set[Socket] = set()
        self.ending = False
        self._sheets = packed_files(sheets)
        mend()
        filled = Filled(open_page, networks(settings.trusted_proxies), settings.bokeh_secret_key.encode())
        super().__init__(
            {"/": Application(filled)},  # type: ignore[no-untyped-call]  # Panel's own has no types
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
            metrics_for=networks(("127.0.0.0/8", "::1", *settings.metrics_for)),
        )
        self.asked = settings
        self.registry = registry
        self.upkeep = Upkeep(registry)
        self.tokens = Tokens(settings.bokeh_secret_key)
        self.class_rate = Rate(OF_A_CLASS)
        self.openings = Arrivals(OPENINGS)
        self.arrivals = Arrivals(settings.arrivals)
        self.returns = Rate(RETURNS)
        self.returning = Arrivals(RETURNS * settings.arrivals)
        self.guests: WeakKeyDictionary[ServerSession, Guest] = WeakKeyDictionary()
        self.admission = Admission(settings.sessions, taken=self._taken, make_way=self._make_way, held=self._held)
        self.metrics = Metrics(
            version(),
            line=("Visitors who wait for a place", lambda: len(self.admission)),
            answers=(
                "Answers of live classes that were looked up here",
                lambda: sum(len(votes) for room in registry.rooms.values() for votes in room.votes.values()),
            ),
            sessions=("Sessions, with and without a visitor", self._taken),
            sockets=("Visitors who are connected", lambda: len(self.sockets)),
            rooms=("Live classes that somebody here leads or follows", lambda: len(registry.rooms)),
            followers=("Those who follow one", lambda: registry.followers),
            store_rooms=("Live classes that the store has, of all replicas", lambda: self.upkeep.rooms),
            store_up=("1 while the store of live classes answers, else 0", lambda: self.upkeep.listening),
            store_skew_seconds=("By how much this clock is ahead of the store's", lambda: self.upkeep.skew),
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
        return sum(not session.expiration_requested for session in self.get_sessions("/"))

    def heard(self, session: ServerSession) -> None:
        """A visitor has come in, or said something."""
        guest = self.guests.get(session)
        network = guest.network if guest else get_token_payload(session.token).get("network", "")
        self.guests[session] = Guest(network, monotonic())

    def _here(self) -> dict[ServerSession, Guest]:
        return {session: guest for session, guest in self.guests.items() if not session.expiration_requested}

    def _held(self) -> Counter[str]:
        return Counter(guest.network for guest in self._here().values())

    def _make_way(self, network: str) -> bool:
        """Send somebody away for a visitor of a network; False where nobody gives way."""
        leaves = gives_way(self._here(), self.admission.places, network, monotonic())
        if leaves is None:
            return False
        leaves.request_expiration()
        for socket in [one for one in self.sockets if one.connection and one.connection.session is leaves]:
            socket.drop(1013, "All places are taken, and others wait.")
        return True

    def start(self) -> None:
        super().start()
        self._pulse.start()
        self._watch = asyncio.create_task(self.metrics.watch())
        logging.getLogger().addHandler(self.metrics.errors)
        self.upkeep.start()

    def stop(self, wait: bool = True) -> None:
        self._pulse.stop()
        self._watch.cancel()
        logging.getLogger().removeHandler(self.metrics.errors)
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
        registry: Registry | None = None,
    ) -> None:
        listening, self.port = bind_sockets(settings.address, settings.port)
        registry = registry or Registry(MemoryStore(), QuestionBank({}, {}))
        self.lecture = Lecture(open_page, settings, self.port, figures or {}, sheets or {}, registry)
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
            socket.drop(1001, "The server is shutting down.")
        with suppress(TimeoutError):
            async with asyncio.timeout(ENDING - notice):
                await asyncio.gather(*(socket.gone.wait() for socket in sockets))
        await self.lecture.upkeep.end()
        self.lecture.stop()
        await self._http.close_all_connections()

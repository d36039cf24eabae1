"""The WebSocket of a page: checks each message, queues it, and answers one at a time."""

from __future__ import annotations

import asyncio
import logging
from collections import deque
from collections.abc import Coroutine, Generator
from contextlib import suppress
from functools import partial
from time import monotonic, thread_time
from types import coroutine
from typing import Any

from bokeh.core.serialization import UnknownReferenceError
from bokeh.protocol.message import Message
from bokeh.protocol.messages.patch_doc import patch_doc
from bokeh.server.session import ServerSession
from bokeh.server.tornado import BokehTornado
from bokeh.server.views.ws import WSHandler
from tornado.websocket import WebSocketClosedError

from components.serving.handlers import RefusedError, VisitorHandler
from components.serving.incoming import Incoming, ViolationError
from components.serving.tokens import opens_session

log = logging.getLogger(__name__)

MOST_WAITING = 8
"""Maximum number of waiting messages. The page has one in flight at a time; the queue of a visitor who has left is
dropped.
"""
CHEAP, SURCHARGE = 0.01, 8
"""CPU seconds that an answer may take, and the factor on the excess for which the visitor then has to wait."""
MOST_PINGS = 30
"""Number of pings from a visitor, between two of ours, after which the socket is closed."""
MOST_MISSED = 2
"""Pings that may stay unanswered."""


class Socket(VisitorHandler, WSHandler):  # type: ignore[misc]  # Bokeh's are not looked into
    """The socket of a page. It replaces Bokeh's, which assembles and deserialises any message."""

    application: BokehTornado

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._incoming = Incoming()
        self._waiting: deque[tuple[float, Message[Any]]] = deque()
        self._work: asyncio.Task[None] | None = None
        self._missed = self._pinged = 0
        self._rests = 0.0
        """The time until which a visitor waits because of the cost of the last answer. This leaves other visitors at
        least half of the CPU time, and much more if one visitor is expensive.
        """
        self.gone = asyncio.Event()

    async def prepare(self) -> None:
        await super().prepare()
        name, _, token = self.request.headers.get("Sec-WebSocket-Protocol", "").partition(",")
        if name.strip() != "bokeh" or not opens_session(token.strip(), self.context.secret):
            raise RefusedError(403, "The server no longer knows this page; reload it.")

    def check_origin(self, origin: str) -> bool:
        """Tornado calls this if the page does not come from the host that it connects to."""
        return self.context.goes_by(origin)

    def open(self, *args: str, **kwargs: str) -> None:
        self.context.admission.sockets.add(self)
        # An answer is several small frames. By default TCP holds the later ones back until the browser has acknowledged
        # the first, which it delays by up to 40 ms.
        self.set_nodelay(True)
        super().open()

    async def _async_open(self, token: str) -> None:
        """Open the socket as Bokeh does. The visitor may have left before this is done."""
        await super()._async_open(token)
        assert self.connection is not None
        if self.gone.is_set():
            self.application.client_lost(self.connection)
        elif not self.connection.session.document.roots:
            self.drop(1011, "This page could not be opened.")
        elif self.connection.session.expiration_requested:
            self.drop(1013, "This page's place has been given to another visitor.")
        else:
            self.context.admission.note_activity(self.connection.session)
            self._be_the_only_one()

    def _be_the_only_one(self) -> None:
        """A page has one socket; otherwise its messages would go to all sockets of the session."""
        assert self.connection is not None
        for other in list(self.connection.session._subscribed_connections):
            if other is not self.connection:
                other._socket.drop(1008, "This page has a newer connection.")

    def on_message(self, frame: str | bytes) -> None:
        """Read on at once, regardless of the queue, so that a flood is noticed when it arrives."""
        if self.ws_connection is None or self.ws_connection.is_closing():
            return
        try:
            if message := self._incoming.take(frame):
                self._admit(message)
        except ViolationError as violation:
            self._refuse(violation)

    def on_close(self) -> None:
        self.gone.set()
        self._waiting.clear()
        self.context.admission.sockets.discard(self)
        super().on_close()

    def drop(self, code: int, reason: str) -> None:
        self._waiting.clear()
        self.close(code, reason)

    def pulse(self) -> None:
        """Test the connection; called at intervals."""
        if self._missed == MOST_MISSED:
            self.drop(1001, "No answer to two pings.")
            return
        self._missed += 1
        self._pinged = 0
        with suppress(WebSocketClosedError):  # on_close is about to be called
            self.ping(b"")

    def on_pong(self, data: bytes) -> None:
        self._missed = 0

    def on_ping(self, data: bytes) -> None:
        """Answer a ping at once, without the queue. Browsers send none."""
        self._pinged += 1
        if self._pinged == MOST_PINGS:
            self._refuse(ViolationError("Too many pings."))

    def _refuse(self, violation: ViolationError) -> None:
        log.warning("A socket is closed: %s", violation.reason)
        self.context.metrics.refused.labels(f"socket {violation.code}").inc()
        self.drop(violation.code, violation.reason)

    def _admit(self, message: Message[Any]) -> None:
        if self.connection is None:
            raise ViolationError("A page must wait for the first message of the server.")
        if len(self._waiting) == MOST_WAITING:
            raise ViolationError("Too many messages at once: a page must wait for the answer to its last message.")
        self._waiting.append((monotonic(), message))
        if self._work is None:
            self._work = asyncio.create_task(self._work_off())

    async def _work_off(self) -> None:
        while self._waiting:
            await asyncio.sleep(self._rests - monotonic())
            if not self._waiting:  # the visitor was dropped meanwhile
                break
            arrived, message = self._waiting.popleft()
            took = await metered(self._answer(message))
            self._rests = monotonic() + took + SURCHARGE * max(0.0, took - CHEAP)
            if isinstance(message, patch_doc) and self.connection and not self.gone.is_set():
                self.context.admission.note_activity(self.connection.session)
                self.context.metrics.change.observe(monotonic() - arrived)
        self._work = None

    async def _answer(self, message: Message[Any]) -> None:
        try:
            if isinstance(message, patch_doc):
                # Send no acknowledgement of Bokeh's, because our own message has the result.
                await ServerSession.patch(message, self.connection)
            elif document := await ServerSession.pull(message, self.connection):
                await self.send_message(document)
        except UnknownReferenceError:
            self.drop(1008, "This message refers to something that is not on the page.")
        except Exception:
            log.exception("A message could not be answered")
            self.drop(1011, "Something went wrong on the server and was logged.")


@coroutine
def metered(work: Coroutine[Any, Any, None]) -> Generator[Any, Any, float]:
    """Await `work`, and return its CPU seconds, without other work that ran meanwhile."""
    took, step = 0.0, partial(work.send, None)
    while True:
        begun = thread_time()
        try:
            awaited = step()
        except StopIteration:
            return took + thread_time() - begun
        took += thread_time() - begun
        step = partial(work.send, None)
        try:
            yield awaited
        except BaseException as error:  # if cancelled
            step = partial(work.throw, error)

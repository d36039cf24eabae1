"""The live class over HTTP for a phone: enter, get updates, answer."""

from __future__ import annotations

import asyncio
import socket
from functools import lru_cache
from time import monotonic, time

from msgspec.structs import replace
from tornado.iostream import IOStream, StreamClosedError

from components.language.class_messages import Entered
from components.language.messages import Given, Taught
from components.live_class.codes import as_code, is_key
from components.live_class.context import ClassContext
from components.live_class.handler import ClassHandler
from components.live_class.room import LEADERS, ClassRoom, RoomListener, as_event, name_of
from components.serving.handlers import LectureHandler, RefusedError
from components.serving.visitors import network_of

MOST_FOLLOWERS = 5000
"""Limit for one room, on one replica."""
ALL_FOLLOWERS = 20_000
"""Limit for all rooms together, on one replica."""
MISSES = 300
"""Wrong codes of one network in a minute. With 10 rooms among 30^4 codes, an attacker expects 0.9 hits in 4 hours, and
a class that mistypes still gets in.
"""
ALL_MISSES = 3000
"""Wrong codes from all networks. An attacker with many networks finds a class in half an hour at best, and may only
follow it.
"""
TOO_MANY = "Many wrong codes were typed. The QR code opens the class at once, the right code within a minute."
NO_CODE = "This is no code of a class. A code has four letters and digits, none of them 0, 1, I, L, O or Q."
UNREACHABLE = "The class cannot be reached at the moment. If it continues, this phone reconnects by itself."
MINUTE = 60.0
BUFFER = 2**14
"""Bytes that the system may buffer for a slow reader (some systems double it): a few updates."""
GIVEN_UP = 60.0
"""Seconds for which a follower may read nothing."""
MOST_STREAMS = 8
"""Streams of one follower. A page has one, and leaves another when it sleeps. If there are more, the oldest ends."""


class Follower(ClassHandler):
    """The base handler of a follower's requests; requires a token of the room, or its key."""

    leads = False

    async def entered(self, code: str) -> ClassRoom:
        self.leads = "." not in self.word  # a key has no name, only tokens have one
        if self.leads:
            return await self.led(code)
        room = await self.outcome(self.classes.registry.followed(as_code(code), self.word))
        if room is None:
            raise RefusedError(404, UNREACHABLE)
        return room

    def take_place(self, room: ClassRoom) -> None:
        """Refuse a new phone if all places are taken. The instructor needs no place."""
        if self.leads or room.follows(self.name):
            return
        if room.places >= MOST_FOLLOWERS:
            raise RefusedError(503, f"This class is full: {MOST_FOLLOWERS} follow it.", after=60)
        if self.classes.registry.places >= ALL_FOLLOWERS:
            raise RefusedError(503, f"This server is full: {ALL_FOLLOWERS} follow its classes.", after=60)

    @property
    def name(self) -> str:
        return name_of(self.word)

    @property
    def after(self) -> str:
        """The number of the newest state that the page has."""
        return self.get_query_argument("after", "")


class MovedByCode(LectureHandler):
    """The handler of an address with a code, such as lecture.example/EUW5; redirects to the page of the class."""

    def get(self, typed: str, slash: str) -> None:
        code = as_code(typed)
        if not code:
            raise RefusedError(404, NO_CODE)
        query = f"&{self.request.query}" if self.request.query else ""
        self.redirect(
            f"{'../' if slash else './'}?class={code}{query}"
        )  # relative, because a proxy may serve the lecture under a path

    head = get


class Enter(ClassHandler):
    """The handler that gives a token for a code, with a limit on wrong codes."""

    async def post(self, code: str) -> None:
        room = await self._shown(code) or await self._typed(code)
        self.reply(Entered(code=room.code, token=self.classes.registry.token(room)))

    async def _shown(self, code: str) -> ClassRoom | None:
        """Return the room of a QR code. The network's limit on wrong codes does not apply to it."""
        try:
            room = await self.outcome(self.classes.registry.room(as_code(code) if self.word else ""))
        except RefusedError as refusal:
            if refusal.status_code == 404:
                return None
            raise
        return room if is_key(self.word, room.parts.get("join", b"")) else None

    async def _typed(self, code: str) -> ClassRoom:
        store, names = self.classes.registry.store, {f"miss {network_of(self.visitor)}": MISSES, "miss": ALL_MISSES}
        for name, most in names.items():
            if await self.outcome(store.count(name, MINUTE, 0)) >= most:
                raise RefusedError(429, TOO_MANY, MINUTE)
        try:
            return await self.outcome(self.classes.registry.room(as_code(code)))
        except RefusedError as refusal:
            if refusal.status_code == 404:
                for name in names:
                    await self.outcome(store.count(name, MINUTE))
            raise


class Events(Follower):
    """The stream of updates, as server-sent events. A slow reader skips some, and then gets the latest."""

    _pipe: IOStream
    _behind = 0.0
    _known = ""

    def initialize(self, classes: ClassContext) -> None:
        super().initialize(classes)
        self._gone = asyncio.Event()

    async def get(self, code: str) -> None:
        room = await self.entered(code)
        self.take_place(room)
        self.limit(f"stream {self.word}")
        self.set_header("Content-Type", "text/event-stream; charset=utf-8")
        self.set_header("X-Accel-Buffering", "no")
        self.set_header("Cache-Control", "no-store, no-transform")
        self._room, self._known = room, self.after
        self._pipe = self.request.connection.stream  # type: ignore[union-attr]  # it is one of HTTP/1
        if self._pipe.closed():  # the phone has connected again meanwhile
            return
        self._pipe.socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER)
        self._pipe.set_nodelay(True)
        room.polls.pop(self.name, None)  # this handler may be closed twice; count it once
        room.seen[self.name] = monotonic()
        room.listeners.add(self)  # before the first await, so that no update is missed
        try:
            self.write(self._all())
            await asyncio.wait_for(self.flush(), GIVEN_UP)
            self._catch_up()
            await self._stay(room.streams.setdefault(self.name, []))
        except (TimeoutError, StreamClosedError):
            self._pipe.close()
        finally:
            room.listeners.discard(self)

    async def _stay(self, own: list[RoomListener]) -> None:
        """Count this stream among the follower's open streams."""
        own.append(self)
        for older in own[:-MOST_STREAMS]:
            older.end()
        try:
            await self._gone.wait()
        finally:
            own.remove(self)
            if not own:
                self._room.streams.pop(self.name, None)
            self._room.seen[self.name] = monotonic()

    def _all(self) -> bytes:
        """Send the current state of the room, and to an instructor's page also the news that it has missed."""
        missed = self._room.news_after(self._known) if self.leads else []
        self._known = self._room.number
        return b"".join(map(as_event, [self._room.whole(self.leads), *missed]))

    def receive(self, event: bytes) -> None:
        """Send a chunk, encoded once for all followers, straight to the connection, unless earlier ones are unread."""
        if self._behind:
            if monotonic() - self._behind > GIVEN_UP:
                self._pipe.close()
        elif self._pipe.writing():
            self._behind = monotonic()
        else:
            self._known = self._room.number
            self._send(event if self.request.version == "HTTP/1.0" else chunk(event))

    def _send(self, data: bytes) -> None:
        """Send an event straight to the socket if Tornado's buffer is empty; its bookkeeping takes 80 % of the time."""
        if self._pipe.closed():
            return
        try:
            sent = self._pipe.socket.send(data)
        except BlockingIOError:
            sent = 0
        except OSError:
            self._pipe.close()
            return
        if sent < len(data):
            self._pipe.write(data[sent:]).add_done_callback(lambda _: self._catch_up())

    def _catch_up(self) -> None:
        if self._behind and not self._gone.is_set():
            self._behind = 0.0
            self.receive(self._all())

    def end(self) -> None:
        self._gone.set()

    def on_connection_close(self) -> None:
        self._gone.set()


@lru_cache(maxsize=64)
def chunk(event: bytes) -> bytes:
    """Return a chunk in the encoding of HTTP/1.1 for responses of unknown length."""
    return b"%x\r\n%s\r\n" % (len(event), event)


class Now(Follower):
    """The handler of polling requests, for a page whose stream is held back by a proxy."""

    async def get(self, code: str) -> None:
        room = await self.entered(code)
        self.take_place(room)
        self.limit(f"poll {self.word}")
        room.polled(self.word, self.leads)
        missed = room.news_after(self.after) if self.leads else []
        if missed:  # send one change; the next request asks for later ones
            own = {name: getattr(missed[0], name) for name in ("number", *LEADERS)}
            self.reply(replace(room.whole(leads=True), **own))
        elif self.after == room.number:
            self.set_status(204)
        else:
            self.reply(room.whole(self.leads))


class Answers(Follower):
    """The handler of a follower's answer and, when the right answer is shown, of the lesson on it."""

    async def put(self, code: str) -> None:
        room = await self.entered(code)
        voter = room.voter(self.word)
        self.limit(f"vote {voter}")
        if not await self.outcome(self.classes.registry.follows(room, voter)):
            raise RefusedError(
                503, "This phone does not follow the class at the moment. Its answer counts when it does.", 1
            )
        if "question" not in room.parts:  # the instructor's page has not restored it yet, or put none at all
            raise RefusedError(503, "The class has no question yet. Your answer counts when it has its question.", 1)
        await self.outcome(self.classes.registry.vote(room, voter, self.body(Given)))
        self.set_status(204)

    async def post(self, code: str) -> None:
        room, vote = await self.entered(code), self.body(Given)
        self.limit(f"vote {self.word}")
        put = room.question
        if put.lesson is None or (put.walk, put.step) != (vote.walk, vote.step):
            self.set_status(204)  # the answer is not shown, or not any more
            return
        try:
            lesson = self.classes.registry.bank_of(room).lesson(vote)
        except ValueError as reason:
            raise RefusedError(400, "This answer does not fit the question.") from reason
        self.reply(Taught(walk=vote.walk, step=vote.step, lesson=lesson))


class TimeOfDay(ClassHandler):
    """The handler of the server's clock, in ms. A page estimates the error of its clock from the round trip."""

    def get(self) -> None:
        self.reply(1000 * time())

"""Clients of a live class without a browser: instructor, followers and their streams; all messages by route, each of
which a client can send any number of times; questions of every kind, with answers and what is refused.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager, suppress
from http.client import HTTPConnection
from typing import Any, NamedTuple, TypeVar
from urllib.parse import urlsplit

from components.live_class.codes import SIGNS, Keys, code_of, join_key

PATIENCE = 60.0
"""Seconds to wait for an answer of the server."""
TRACES = ("Traceback", 'File "', "site-packages", "Error:")
Found = TypeVar("Found")


async def until(condition: Callable[[], Found]) -> Found:
    """Wait for a condition, and return what fulfils it."""
    async with asyncio.timeout(PATIENCE):
        while not (found := condition()):
            await asyncio.sleep(0.005)
    return found


class Answered(NamedTuple):
    status: int
    text: str
    headers: dict[str, str]

    @property
    def json(self) -> Any:
        return json.loads(self.text)

    @property
    def refused(self) -> bool:
        """True for a client error (4xx) whose text shows nothing of the program."""
        return 400 <= self.status < 500 and self.quiet

    @property
    def quiet(self) -> bool:
        return not any(sign in self.text for sign in TRACES)


def call(
    url: str, path: str = "/", method: str = "GET", body: object = None, word: str = "", **headers: str
) -> Answered:
    """Send one request with a key or token. Underscores in header names become hyphens."""
    connection = HTTPConnection(urlsplit(url).netloc, timeout=PATIENCE)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    if word:
        named["Authorization"] = f"Bearer {word}"
    try:
        sent = body if body is None or isinstance(body, bytes) else json.dumps(body)
        connection.request(method, path, sent, named)
        answer = connection.getresponse()
        return Answered(answer.status, answer.read().decode("utf-8", "replace"), dict(answer.headers))
    finally:
        connection.close()


async def called(*given: Any, **more: Any) -> Answered:
    return await asyncio.to_thread(call, *given, **more)


def events_of(url: str, code: str, word: str) -> bytes:
    """Return the request for a stream."""
    host = urlsplit(url).netloc
    return f"GET /class/{code}/events HTTP/1.1\r\nHost: {host}\r\nAuthorization: Bearer {word}\r\n\r\n".encode()


class Stream:
    """The events of a class. `heard` has those read so far."""

    begun: set[Stream] = set()
    """Streams that are still open."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, word: str) -> None:
        self.word, self.headers, self.ended = word, "", False
        self.heard: list[dict[str, Any]] = []
        self._reader, self._writer = reader, writer
        self._task = asyncio.create_task(self._read())
        self.begun.add(self)

    @classmethod
    async def open(cls, url: str, code: str, word: str) -> Stream:
        host = urlsplit(url)
        reader, writer = await asyncio.open_connection(host.hostname, host.port, limit=2**20)
        writer.write(events_of(url, code, word))
        stream = cls(reader, writer, word)
        await until(lambda: stream.headers)
        return stream

    async def _read(self) -> None:
        self.headers = (await self._reader.readuntil(b"\r\n\r\n")).decode()
        with suppress(ConnectionError, asyncio.IncompleteReadError, ValueError):
            while size := int(await self._reader.readline() or b"0", 16):
                events = (await self._reader.readexactly(size + 2)).strip().split(b"\n\n")
                self.heard += [json.loads(event.removeprefix(b"data: ")) for event in events]
        self.ended = True

    async def until(self, holds: Callable[[dict[str, Any]], Any]) -> dict[str, Any]:
        """Wait for an event that fulfils a condition, and return the last such event."""
        return await until(lambda: next(filter(holds, reversed(self.heard)), {}))

    async def close(self) -> None:
        self.begun.discard(self)
        self._writer.close()
        await self._task


@asynccontextmanager
async def streams_closed() -> AsyncIterator[None]:
    """Close all streams at the end, so that a failed test does not affect later ones."""
    try:
        yield
    finally:
        await asyncio.gather(*(stream.close() for stream in list(Stream.begun)))


class Class:
    """A class, and its instructor, whose requests a proxy may have sent for an address."""

    words: Mapping[str, str] = {}
    """The words of its members; without it each message of a phone has a new one."""

    def __init__(self, url: str, opened: dict[str, Any], address: str = "") -> None:
        self.url, self.opened, self.headers = url, opened, {"X_Forwarded_For": address}
        self.code, self.key = opened["code"], opened["key"]

    @classmethod
    async def open(cls, url: str) -> Class:
        answer = await called(url, "/class", "POST")
        assert answer.status == 200, answer.text
        return cls(url, answer.json)

    async def ask(
        self, path: str, method: str = "GET", body: object = None, word: str | None = None, url: str = ""
    ) -> Answered:
        """Send a request to an address of the class: with its key, or with another word or none."""
        word = self.key if word is None else word
        return await called(url or self.url, f"/class/{self.code}/{path}", method, body, word, **self.headers)

    async def order(self, type: str, **order: Any) -> Answered:
        return await self.ask("lead", "POST", {"type": type, **order})

    async def tally(self) -> Any:
        return (await self.ask("tally")).json

    async def token(self, url: str = "") -> str:
        """Send the request of a follower who asks for news; the server counts everyone who asks."""
        token: str = (await self.ask("token", "POST", word="", url=url)).json["token"]
        assert (await self.ask("now", word=token, url=url)).status == 200
        return token

    async def follow(self, url: str = "") -> Stream:
        return await Stream.open(url or self.url, self.code, await self.token(url))

    async def lead(self) -> Stream:
        """Open the instructor's stream."""
        return await Stream.open(self.url, self.code, self.key)

    async def vote(self, token: str, url: str = "", **vote: Any) -> Answered:
        return await self.ask("answer", "PUT", vote, token, url)

    async def voted(self, token: str, **vote: Any) -> None:
        """Send an answer, which is accepted."""
        assert (await self.vote(token, **vote)).status == 204

    async def send(self, name: str, n: int = 0, **other: Any) -> Answered | None:
        """Send a message, or one with another code, word, body, method or headers."""
        method, route, *_ = name.split(" ")
        kind, body, query = MESSAGES[name]
        own = {"code": self.code, "body": body(n) if body else None, "method": method}
        own |= {"word": self.words.get(kind, "")} if self.words else await self._new(kind, n)
        sent = {**own, **self.headers, **other}
        code = sent.pop("code")
        if route.endswith("events") and not self.words:
            await (await Stream.open(self.url, code, sent["word"])).close()
            return None
        return await called(self.url, route.replace("CODE", code).replace("WORD", "ABCDEFGH") + query(n), **sent)

    async def _new(self, kind: str, n: int) -> dict[str, Any]:
        """Return a word of a kind, with the code or the body that belongs to it."""
        match kind:
            case "new key":
                word = Keys().new()
                return {"word": word, "code": code_of(word)}
            case "none":  # almost certainly the code of no class; each number gives another
                return {"word": f"{n}.x", "code": "".join(SIGNS[n // 30**i % 30] for i in range(4))}
            case "phone":  # enters by the QR code and asks for news
                token = (await self.ask("token", "POST", word=join_key(self.key))).json["token"]
                await self.ask("now", word=token)
                return {"word": token}
            case "ticket":
                return {"word": "", "body": {"address": await Remote.secret(self)}}
            case "remote":  # replaces the last one; some are refused, because too many wait
                remote = await Remote.wait(self)
                return {"word": remote.key if remote and (await remote.decide()).status == 200 else ""}
        return {"word": {"key": self.key, "join": join_key(self.key)}.get(kind, "")}


class Remote:
    """A phone as a remote control."""

    def __init__(self, lesson: Class, digits: str, key: str) -> None:
        self.lesson, self.digits, self.key = lesson, digits, key

    @staticmethod
    async def secret(lesson: Class) -> str:
        """Return the secret of a new ticket."""
        ticket = (await lesson.ask("tickets", "POST")).json["address"]
        return str(ticket.partition("remote=")[2])

    @classmethod
    async def wait(cls, lesson: Class) -> Remote | None:
        """Return a phone that has scanned a ticket and waits to be admitted; None if too many wait."""
        paired = await lesson.ask("remote", "PUT", {"address": await cls.secret(lesson)}, word="")
        return cls(lesson, **paired.json) if paired.status == 200 else None

    @classmethod
    async def pair(cls, lesson: Class) -> Remote:
        remote = await cls.wait(lesson)
        assert remote and (await remote.decide()).status == 200
        return remote

    async def decide(self, method: str = "PUT", digits: str = "") -> Answered:
        """The instructor's page admits or refuses it."""
        return await self.lesson.ask("tickets", method, {"digits": digits or self.digits})

    async def ask(self, path: str = "remote", method: str = "GET", **done: str) -> Answered:
        return await self.lesson.ask(path, method, done or None, self.key)


CHOICE, NUMBER = {"walk": "d31", "step": "d31-03"}, {"walk": "d31", "step": "d31-02"}
SKETCH = {"walk": "d34", "step": "d34-14"}
WORDS = """[[step]]
id = "why"
kind = "words"
title = "Energy goes to and fro"
state = "?scene=oscillator"
show = ["stage", "plot:x"]
question = "Why does it swing on?"
explain = "Energy goes to and fro."
"""
OWN = {
    "mine": 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n',
    "why": f"""title = "Why"
{WORDS}[[step]]
id = "vote"
kind = "choice"
poll = true
fixed = true
title = "Vote"
state = "?scene=coupled&k2=3"
question = "What is your answer to the question just asked?"
options = [{{ text = "A" }}, {{ text = "B" }}]
explain = "The question was asked aloud."
""",
}
"""Walks from the instructor's files."""


class Answer(NamedTuple):
    """An answer: the fields that a phone sends, its text, judgement and unit in the table, and how it is counted."""

    fields: dict[str, Any]
    text: str
    right: str
    counted: Any
    unit: str = ""


class Asked(NamedTuple):
    """A question: its place in its walk, the field of `Counted` that has the answers, answers, and what is none."""

    walk: str
    step: str
    place: int
    counts: str
    answers: tuple[Answer, ...]
    unfit: tuple[dict[str, Any], ...]


def drawn(value: int, points: int = 101) -> dict[str, Any]:
    return {"curves": {"Xp1": [value] * points}}


OPTIONS = (
    Answer({"option": 0}, "Just as long as it did before", "yes", 0),
    Answer({"option": 1}, "Longer: the distance is longer", "no", 1),
    Answer({"option": 2}, "Shorter: the spring pulls harder", "no", 2),
)
NO_OPTION = ({}, {"option": 3}, {"option": 0, "text": "=cmd"}, {"option": 0, "value": 0.5}, {"option": 0, **drawn(5)})
QUESTIONS = (
    Asked("d31", "d31-03", 3, "options", OPTIONS, NO_OPTION),
    Asked("mine", "one", 1, "options", OPTIONS, NO_OPTION),
    Asked(
        "d31", "d31-02", 2, "numbers",
        (
            Answer({"text": "2"}, "2", "yes", 2.0, "s"), Answer({"text": "−2"}, "-2", "no", -2.0, "s"),
            Answer({"text": "-1,5"}, "-1.5", "no", -1.5, "s"), Answer({"text": "+3"}, "3", "no", 3.0, "s"),
            Answer({"text": "-10^3"}, "-1000", "no", -1000.0, "s"),
        ),
        ({"text": "two"}, {"option": 0}, {"text": "2", "option": 0}),
    ),
    Asked(
        "d34", "d34-08", 8, "numbers",
        (Answer({"value": 1.5}, "1.5", "yes", 1.5, "m"), Answer({"value": 0.5}, "0.5", "no", 0.5, "m")),
        ({"option": 1}, {"value": 1.5, "text": "=cmd"}, {"value": 1.5, **drawn(5)}),
    ),
    Asked(
        "d34", "d34-14", 14, "sketches",
        (Answer(drawn(500), "Xp1: 0 2.5", "no", 500, "SI"), Answer(drawn(100), "Xp1: 0 0.5", "no", 100, "SI")),
        (drawn(5, 50), {"curves": {"Xp9": [5] * 101}}, {**drawn(5), "text": "=cmd"}),
    ),
    Asked(
        "why", "why", 1, "words",
        (
            Answer({"text": "Energy"}, "Energy", "", "energy"), Answer({"text": " energy. "}, "energy.", "", "energy"),
            Answer({"text": "=1+1"}, "'=1+1", "", "=1+1"), Answer({"text": "x" * 80}, "x" * 80, "", "x" * 80),
            Answer({"text": "a\u202eb\nc"}, "a b c", "", "a b c"),
            Answer({"text": "🙂👩\u200d🔬"}, "🙂👩\u200d🔬", "", "🙂👩\u200d🔬"),
        ),
        ({"text": ""}, {"text": " \u200b "}, {"option": 0}),
    ),
    Asked(
        "why", "vote", 2, "options",
        (Answer({"option": 0}, "A", "", 0), Answer({"option": 1}, "B", "", 1)),
        ({"option": 2}, {"text": "A"}),
    ),
)  # fmt: skip


class Sent(NamedTuple):
    """A message: whose word it has, its body, and its query; the number makes each one different."""

    word: str = ""
    body: Callable[[int], Any] | None = None
    query: Callable[[int], str] = lambda n: ""


def order(type: str, **fields: Callable[[int], Any]) -> Sent:
    return Sent("key", lambda n: {"type": type, **{name: of(n) for name, of in fields.items()}})


def answers(n: int) -> dict[str, Any]:
    return {f"{60 * n + i:011x}abcdefgh": {**SKETCH, **drawn(500), "vote": n % 9 + 1} for i in range(60)}


MESSAGES = {
    "POST /class": Sent(),
    "GET /class/time": Sent(),
    "GET /class/CODE/lead": Sent("key"),
    "PUT /class/CODE/lead": Sent("new key", lambda n: {}),
    "POST /class/CODE/lead clock": order("clock", t=float, rate=float, end=float, at=float),
    "POST /class/CODE/lead put": Sent(
        "key", lambda n: {"type": "put", **(NUMBER, CHOICE, SKETCH)[n % 3], "vote": n % 9}
    ),
    "POST /class/CODE/lead walk": order(
        "walk",
        name=lambda n: f"mine-{n}",
        text=lambda n: OWN["mine"].replace("Mine", "x" * 90) + f"# {n}".ljust(20_000, "x"),
    ),
    **{f"POST /class/CODE/lead {type}": order(type) for type in ("show", "close", "sure", "withdraw")},
    "POST /class/CODE/lead countdown": order("countdown", seconds=int, closes=lambda n: n % 2 == 0),
    "POST /class/CODE/lead moderate": order("moderate", text=str, shows=lambda n: n % 2 == 0),
    "POST /class/CODE/lead screen": order("screen", next=lambda n: f"{n}".ljust(60, "x")),
    "POST /class/CODE/lead restore": order("restore", answers=answers),
    "GET /class/CODE/tally": Sent("key"),
    "GET /class/CODE/answers": Sent("key", query=lambda n: f"?question=d34/d34-14/{n % 9 + 1}"),
    "GET /class/CODE/answers of none": Sent("key", query=lambda n: f"?question=d34/none-{n}/1"),
    **{f"GET /class/CODE/{path}": Sent("key") for path in ("answers.csv", "summary", "stored")},
    "POST /class/CODE/word": Sent("key", lambda n: {"query": f"{n}".ljust(4000, "x")}),
    "PUT /class/CODE/word": Sent("", lambda n: {"word": f"{n}"}),
    "PUT /class/CODE/word of none": Sent("none", lambda n: {"word": ""}),
    "POST /class/CODE/tickets": Sent("key"),
    **{f"{of} /class/CODE/tickets": Sent("key", lambda n: {"digits": f"{n % 90 + 10}"}) for of in ("PUT", "DELETE")},
    "PUT /class/CODE/remote": Sent("ticket", lambda n: {"address": "x"}),
    "GET /class/CODE/remote": Sent("remote"),
    "POST /class/CODE/remote": Sent("remote", lambda n: {"deed": "next"}),
    "GET /class/CODE/steps": Sent("remote"),
    "POST /class/CODE/token": Sent("join"),
    "POST /class/CODE/token of none": Sent("none"),
    "GET /class/CODE/events": Sent("phone"),
    "GET /class/CODE/events of the leader": Sent("key"),
    "GET /class/CODE/now": Sent("phone"),
    "GET /class/CODE/now of none": Sent("none"),
    **{f"{of} /class/CODE/answer": Sent("phone", lambda n: {**CHOICE, "option": n % 3}) for of in ("PUT", "POST")},
    **dict.fromkeys(("GET /CODE", "HEAD /CODE", "GET /CODE-WORD", "HEAD /CODE-WORD"), Sent("none")),
    "POST /class/CODE/lead end": order("end"),
}
"""Messages by method and route, with whatever distinguishes several of one route. An order has its type in the name."""

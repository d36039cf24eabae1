"""Abuse of the protocol: what a client other than our page can send to a server on this machine.

At most 30 clients run at once, for a few seconds each. Nothing here depends on the scenes.
"""

from __future__ import annotations

import asyncio
import base64
import gzip
import json
from collections.abc import Awaitable, Callable
from contextlib import suppress
from random import Random
from statistics import quantiles
from time import monotonic
from urllib.parse import urlsplit

from tornado.websocket import WebSocketClosedError

from tests.serving.visitor import Caller, Visitor, ask, contents, event, header, patch, refused, said, token_of
from tools.attack.greedy import greedy
from tools.attack.result import AttackResult

ALPHABET = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.="
FLOODERS, SECONDS = 30, 3.0
SCENE = "/?scene=oscillator"
CLOSED = (
    "/autoload.js?bokeh-autoload-element=a",
    "/app/autoload.js?bokeh-autoload-element=a",
    "/components/antigravity/a/_css/a",
    "/metadata",
    "/static/js/bokeh.js",
    "/static/extensions/panel/panel.js",
    "/rest/session_info",
    "/favicon.ico",
    "/assets/../app.py",
    "/assets/%2e%2e/app.py",
    "/app.py",
    "//",
)
LINKS = ("theme=%ff", "bokeh%00=1", "=", "&&&", "k2=%", "scene=%f0%9f", "a[]=1", "k2=" + "9" * 4000, "x" * 9000)
BOMB = base64.b64encode(gzip.compress(bytes(20_000_000))).decode()
ARRAY = {"type": "ndarray", "array": {"type": "bytes", "data": BOMB}, "shape": [20_000_000], "dtype": "uint8"}

# Frames that each client sends; the server closes its socket with a code and a reason.
ABUSES: dict[str, tuple[str | bytes, ...]] = {
    "a message too long": ("x" * 70_000,),
    "three frames too long together": (header(), "{}" + " " * 40_000, " " * 40_000),
    "a binary frame": (b"\x00",),
    "no JSON": ("{", "{}", "{}"),
    "a kind of message that pages do not send": (header("PUSH-DOC"), "{}", json.dumps({"doc": {}})),
    "a question for the server": (header("SERVER-INFO-REQ"), "{}", "{}"),
    "a million buffers": (header(num_buffers=1_000_000), "{}", "{}"),
    "unknown words in the header": (header(more=1), "{}", "{}"),
    "metadata": (header(), '{"a": 1}', "{}"),
    "no event": patch(),
    "many events": patch(*[event("document_ready")] * 100),
    "a changed model": patch({"kind": "ModelChanged", "model": {"id": "p1"}, "attr": "name", "new": 1}),
    "a column": patch({"kind": "ColumnDataChanged", "model": {"id": "p1"}, "attr": "data", "data": {}, "cols": None}),
    "a removed root": patch({"kind": "RootRemoved", "model": {"id": "p1"}}),
    "another event": patch(event("button_click", model={"id": "p1"})),
    "an unknown model": said(None, model="p0"),
    "packed bytes that inflate": said(ARRAY),
    "a dtype without end": said({**ARRAY, "dtype": "u1," * 9000}),
    "a model to be made": said({"type": "object", "name": "Div", "id": "p1"}),
    "a type to be looked up": said({"type": "symbol", "name": "os"}),
    "a slice": said({"type": "slice", "start": 0, "stop": 1, "step": 1}),
    "nested without end": (*said("here")[:2], said("here")[2].replace('"here"', "[" * 9000 + "]" * 9000)),
    "a number beyond doubles": (*said("here")[:2], said("here")[2].replace('"here"', "1e999")),
    "two types in one": (*said("here")[:2], said("here")[2].replace('"here"', '{"type":"map","type":"ndarray"}')),
    "rows of a record without end": said({"type": "map", "entries": [["type", "rows"], ["t", [0.5] * 20_000]]}),
    "a flood": said(None) * 50,
}


def attack(url: str, short: bool = False) -> list[AttackResult]:
    """Run all attacks; `short` leaves out the slow ones."""
    findings = [*_links(url), *_closed(url), *_token(url)]
    hunts: list[Callable[[str], Awaitable[list[AttackResult]]]] = [_forged, _abused]
    if not short:
        hunts += [_slow, _flood, greedy]
    for hunt in hunts:
        findings += asyncio.run(hunt(url))  # type: ignore[arg-type]
    return findings


def _links(url: str) -> list[AttackResult]:
    token = token_of(ask(url, SCENE).text)
    naming = {
        "a session named in a link": ask(url, "/?bokeh-session-id=klass"),
        "a session named in a header": ask(url, Bokeh_Session_Id="klass"),
        "a session named in both": ask(url, "/?bokeh-session-id=klass", Bokeh_Session_Id="klass"),
        "a token in a link": ask(url, f"/?bokeh-token={token}"),
        "a malformed token in a link": ask(url, "/?bokeh-token=%ff.a"),
        "another name": ask(url, Host="attacker.example"),
        "an impossible name": ask(url, Host="["),
    }
    found = [AttackResult(name, reply.refused, f"{reply.status}") for name, reply in naming.items()]
    for link in LINKS:
        reply = ask(url, f"/?{link}")
        found.append(AttackResult(f"the link {link[:20]}", reply.status < 500 and reply.quiet, f"{reply.status}"))
    for link in (*LINKS, "scene=absorber&m1=1e300&window=1e-300", "table=%ff", "cover=" + "plot:x," * 900):
        reply = ask(url, f"/data.csv?{link}")
        found.append(AttackResult(f"the numbers of {link[:20]}", reply.status < 500 and reply.quiet, f"{reply.status}"))
    found.append(AttackResult("numbers to write", (reply := ask(url, "/data.csv", "POST")).refused, f"{reply.status}"))
    for method in ("POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"):
        reply = ask(url, "/", method)
        found.append(AttackResult(f"the method {method}", reply.refused, f"{reply.status}"))
    return found


def _closed(url: str) -> list[AttackResult]:
    replies = {path: ask(url, path) for path in CLOSED}
    return [AttackResult(f"closed: {path}", reply.refused, f"{reply.status}") for path, reply in replies.items()]


def _token(url: str) -> list[AttackResult]:
    secret = "a-word-that-only-this-visitor-knows"
    page = ask(url, SCENE, Cookie=f"name={secret}", Authorization=f"Basic {secret}", X_Other=secret)
    claims = contents(token_of(page.text))
    alone = {name.lower() for name in claims["headers"]} == {"host"} and not claims["cookies"]
    return [
        AttackResult("the token holds the Host alone", alone and secret not in json.dumps(claims), f"{sorted(claims)}")
    ]


async def _forged(url: str) -> list[AttackResult]:
    """Try tokens that the server did not make."""
    random = Random(1)
    token = token_of(ask(url, SCENE).text)
    text, _, signature = token.partition(".")
    unsigned = base64.urlsafe_b64encode(json.dumps({"session_id": "klass", "session_expiry": 9e9}).encode()).decode()
    forged = {
        "a token without a signature": text,
        "a token with another's signature": f"{unsigned.rstrip('=')}.{signature}",
        "a session's id as the token": contents(token)["session_id"],
        "no JSON in a token": f"AAAA.{signature}",
        "half a token": token[: len(token) // 2],
        "a dot for a token": ".",
    }
    for number in range(20):
        noise = "".join(random.choices(ALPHABET, k=random.randrange(1, 200)))
        place = random.randrange(len(token))
        forged[f"noise {number}"] = noise
        forged[f"a changed letter {number}"] = (
            token[:place] + ("A" if token[place] != "A" else "B") + token[place + 1 :]
        )
    found = []
    for name, one in forged.items():
        status = await refused(url, one)
        found.append(AttackResult(name, 400 <= status < 500, f"{status}"))
    return found


async def _abused(url: str) -> list[AttackResult]:
    """Each abuse closes its own socket; another visitor continues to work."""
    witness = await Visitor.arrive(url, "scene=coupled")
    found = []
    for number, (name, frames) in enumerate(ABUSES.items()):
        caller = await Caller.arrive(url)
        with suppress(WebSocketClosedError):  # the server may close before the last frame
            await caller.write(*frames)
        code, reason = await caller.closed()
        found.append(AttackResult(name, code in (1003, 1008, 1009) and bool(reason), f"{code} {reason}"))
        await witness.move("k2", 1 + number / 100)
    await witness.depart()
    return found


async def _slow(url: str) -> list[AttackResult]:
    """Requests that never end are dropped."""
    address = urlsplit(url)
    begun = {
        "a request without an end": b"GET / HTTP/1.1\r\nHost: localhost\r\n",
        "a body that does not come": b"POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\n",
    }

    async def held(text: bytes) -> float:
        start = monotonic()
        reader, writer = await asyncio.open_connection(address.hostname, address.port)
        writer.write(text)
        await reader.read()
        writer.close()
        return monotonic() - start

    times = await asyncio.gather(*(asyncio.wait_for(held(text), 30) for text in begun.values()))
    return [
        AttackResult(name, took < 15, f"dropped after {took:.0f} s") for name, took in zip(begun, times, strict=True)
    ]


async def _flood(url: str) -> list[AttackResult]:
    """Measure others' waits before, during and a second after 30 clients send as much as they can."""
    witness = await Visitor.arrive(url, "scene=coupled")
    before = await _latency(witness)
    flooders = [asyncio.create_task(_flooder(url)) for _ in range(FLOODERS)]
    during = await _latency(witness, windows=1)
    await asyncio.gather(*flooders)
    await asyncio.sleep(1)
    after = await _latency(witness)
    for _ in range(5):  # repeat, so that other load on this machine does not count as an effect of the flood
        if after >= 1.2 * before:
            after = await _latency(witness)
    await witness.depart()
    detail = f"95 of 100 answers within {before:.0f} ms before, {during:.0f} ms during, {after:.0f} ms a second after"
    return [AttackResult("a flood leaves nothing behind", after < 1.2 * before, detail)]


async def _flooder(url: str) -> None:
    """Connect again and again, and send as much as the server accepts."""
    end = monotonic() + SECONDS
    while monotonic() < end:
        caller = await Caller.arrive(url)
        with suppress(WebSocketClosedError):
            while monotonic() < end:
                await caller.write(header("PULL-DOC-REQ"), "{}", "{}")
        await caller.depart()


async def _latency(visitor: Visitor, windows: int = 3, changes: int = 100) -> float:
    """Return the 95th percentile of the time for a change in ms: the smallest of several windows, to exclude other
    load.
    """
    found = []
    for _ in range(windows):
        times = []
        for step in range(changes):
            start = monotonic()
            await visitor.move("k2", 1 + step / changes)
            times.append(1000 * (monotonic() - start))
        found.append(quantiles(times, n=20)[-1])
    return min(found)

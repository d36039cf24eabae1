"""Sessions: who opens one and who does not; none is left open. In one process, on a port of this machine."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from socket import IPPROTO_TCP, TCP_NODELAY
from types import SimpleNamespace
from typing import Any

import pytest
from bokeh.document import Document
from bokeh.io.doc import _PATCHED_CURDOCS
from bokeh.server.contexts import ApplicationContext
from bokeh.server.session import ServerSession
from bokeh.util.token import generate_jwt_token, generate_session_id

from app import SHEETS, open_page
from components.serving.server import Server
from components.serving.settings import Settings
from components.serving.sockets import CHEAP, MOST_MISSED, MOST_PINGS, SURCHARGE, Socket
from components.serving.tokens import opens_session
from tests.attack.caller import Caller, Reply, ask, connect, contents, event, header, patch, refused, said, token_of
from tests.serving.visitor import Visitor

SECRET = "a secret of sixteen letters"


@asynccontextmanager
async def served(page: Callable[[Document], None] = open_page, **settings: Any) -> AsyncIterator[Server]:
    server = Server(page, Settings(**{"address": "127.0.0.1", "port": 0, **settings}), sheets=SHEETS)
    try:
        yield server
    finally:
        await server.end()


def url(server: Server) -> str:
    return f"http://127.0.0.1:{server.port}/"


async def page_of(server: Server, path: str = "/", **headers: str) -> Reply:
    return await asyncio.to_thread(ask, url(server), path, **headers)


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(30):
        while not condition():
            await asyncio.sleep(0.01)


def sessions(server: Server) -> list[ServerSession]:
    return server.lecture.get_sessions("/")


def broken(document: Document) -> None:
    raise ArithmeticError("the word that is for the log")


async def test_a_token_opens_its_session_on_every_server_with_the_secret() -> None:
    async with (
        served(bokeh_secret_key=SECRET) as first,
        served(bokeh_secret_key=SECRET) as second,
        served() as other,
    ):
        token = token_of((await page_of(first, "/?scene=coupled&k2=7")).text)
        caller = Caller(await connect(url(second), token))
        await until(lambda: len(sessions(second)) == 1)
        assert sessions(second)[0].document.title == sessions(first)[0].document.title
        assert await refused(url(other), token) == 403
        await caller.depart()


async def test_a_secret_that_is_not_set_is_made_for_each_start() -> None:
    async with served() as first, served() as second:
        assert first.context.secret != second.context.secret and len(first.context.secret) > 32


async def test_a_token_holds_the_host_and_the_query() -> None:
    async with served() as server:
        page = await page_of(server, "/?k2=3", Cookie="a=b", Authorization="Basic eDp5", User_Agent="me")
        told = contents(token_of(page.text))
        host = f"127.0.0.1:{server.port}"
        assert (told["headers"], told["cookies"], set(told["arguments"])) == ({"Host": host}, {}, {"k2"})


def test_tokens_expire_and_only_tokens_open() -> None:
    secret = SECRET.encode()

    def token(expiration: int, key: bytes = secret) -> str:
        name = generate_session_id(secret_key=key, signed=True)
        made: str = generate_jwt_token(name, secret_key=key, signed=True, expiration=expiration)
        return made

    assert opens_session(token(60), secret)
    assert not opens_session(token(-1), secret)
    assert not opens_session(token(60, b"another"), secret)
    assert not opens_session(generate_session_id(secret_key=secret, signed=True), secret)


@pytest.mark.parametrize("path", ["/?bokeh-session-id=klass", "/?bokeh-token=a.b", "/?k2=3&bokeh-session-id=klass"])
async def test_a_link_names_no_session(path: str) -> None:
    async with served() as server:
        page = await page_of(server, path)
        assert page.status == 403
        assert "A link cannot name a session" in page.text
        assert not sessions(server)


async def test_looking_whether_there_is_a_page_opens_no_session() -> None:
    async with served() as server:
        reply = await asyncio.to_thread(ask, url(server), "/", "HEAD")
        assert (reply.status, reply.text) == (200, "")
        assert not sessions(server)


async def test_a_page_that_fails_says_so_in_a_sentence_and_the_log_says_why(caplog: pytest.LogCaptureFixture) -> None:
    async with served(broken, bokeh_secret_key=SECRET) as server, served(bokeh_secret_key=SECRET) as sound:
        page = await page_of(server)
        assert page.status == 500
        assert "Something went wrong on the server" in page.text
        assert page.quiet
        assert "the word" not in page.text
        caller = Caller(await connect(url(server), token_of((await page_of(sound)).text)))
        assert (await caller.closed())[0] == 1011
    assert "the word that is for the log" in caplog.text


async def test_what_fails_for_one_visitor_leaves_no_document_to_the_others() -> None:
    def fail(_: object) -> None:
        raise ArithmeticError("the word that is for the log")

    def page(document: Document) -> None:
        open_page(document)
        document.on_event("document_ready", fail)

    before = len(_PATCHED_CURDOCS)
    async with served(broken) as server:
        await page_of(server)
    async with served(page) as server:
        for message in (patch(event("document_ready")), said(None, model="p0")):
            caller = await Caller.arrive(url(server))
            await caller.send(*message)
            assert (await caller.closed())[0] in (1008, 1011)
    assert len(_PATCHED_CURDOCS) == before


async def test_a_message_that_fails_closes_the_socket_and_the_log_says_why_once(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def fail(*_: object) -> None:
        raise ArithmeticError("the word that is for the log")

    async with served() as server:
        caller = await Caller.arrive(url(server))
        monkeypatch.setattr(ServerSession, "pull", fail)
        await caller.send(header("PULL-DOC-REQ"), "{}", "{}")
        code, reason = await caller.closed()
        assert code == 1011
        assert "Something went wrong on the server" in reason
    assert [record.levelno for record in caplog.records if record.exc_info] == [logging.ERROR]


async def test_who_leaves_at_the_door_leaves_nothing_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    create = ApplicationContext.create_session_if_needed

    async with served(unused_seconds=0.05) as server:
        token = token_of((await page_of(server)).text)

        async def slowly(*arguments: Any) -> ServerSession:
            session = await create(*arguments)
            await until(lambda: not server.context.admission.sockets)
            return session

        monkeypatch.setattr(ApplicationContext, "create_session_if_needed", slowly)
        await Caller(await connect(url(server), token)).depart()
        await until(lambda: not sessions(server))


async def test_a_session_waits_for_its_visitor_and_ends_without() -> None:
    async with served(unused_seconds=0.05) as server:
        visitor = await Visitor.arrive(url(server), "scene=coupled")
        await page_of(server)
        await until(lambda: len(sessions(server)) == 1)
        await visitor.move("k2", 3)
        await visitor.depart()
        await until(lambda: not sessions(server))


async def test_a_socket_that_misses_two_pings_is_dropped() -> None:
    async with served() as server:
        caller, silent = await Caller.arrive(url(server)), await Caller.arrive(url(server))
        silent.socket.protocol._send_pong = lambda _: None  # type: ignore[union-attr]
        for _ in range(MOST_MISSED + 1):
            for socket in list(server.context.admission.sockets):
                socket.pulse()
            await caller.send(header("PULL-DOC-REQ"), "{}", "{}")
            for _ in range(3):  # the answer comes after the pong
                await caller.receive()
        assert await silent.closed() == (1001, "No answer to two pings.")
        assert len(server.context.admission.sockets) == 1
        await caller.depart()


async def test_a_page_has_one_socket() -> None:
    async with served() as server:
        token = token_of((await page_of(server)).text)
        first, second = Caller(await connect(url(server), token)), Caller(await connect(url(server), token))
        assert await first.closed() == (1008, "This page has a newer connection.")
        await until(lambda: len(server.context.admission.sockets) == 1)
        for _ in range(3):  # the greeting
            await second.receive()
        await second.send(header("PULL-DOC-REQ"), "{}", "{}")
        assert await second.receive()
        await second.depart()


async def test_pings_without_end_close_their_socket() -> None:
    async with served() as server:
        caller = await Caller.arrive(url(server))
        for _ in range(MOST_PINGS):
            caller.socket.ping(b"")
        assert await caller.closed() == (1008, "Too many pings.")


async def test_a_visitor_waits_for_what_the_last_answer_took(monkeypatch: pytest.MonkeyPatch) -> None:
    now, slept = [100.0], list[float]()

    async def answer(self: Socket, message: object) -> None:
        now[0] += 3.0

    async def sleep(seconds: float) -> None:
        slept.append(seconds)
        now[0] += max(0.0, seconds)

    async with served() as server:
        caller = await Caller.arrive(url(server))
        (socket,) = server.context.admission.sockets
        monkeypatch.setattr(Socket, "_answer", answer)
        for clock in ("monotonic", "thread_time"):
            monkeypatch.setattr(f"components.serving.sockets.{clock}", lambda: now[0])
        monkeypatch.setattr("components.serving.sockets.asyncio", SimpleNamespace(sleep=sleep))
        socket._waiting.extend([(0.0, None)] * 3)
        await socket._work_off()
        monkeypatch.undo()
        await caller.depart()
    assert slept == [-100.0, *[pytest.approx(3.0 + SURCHARGE * (3.0 - CHEAP))] * 2]


async def test_answers_are_not_held_back() -> None:
    async with served() as server:
        caller = await Caller.arrive(url(server))
        (socket,) = server.context.admission.sockets
        assert socket.ws_connection.stream.socket.getsockopt(IPPROTO_TCP, TCP_NODELAY)
        await caller.depart()


async def test_the_end_of_the_server_closes_its_sockets_as_going_away() -> None:
    async with served() as server:
        caller = await Caller.arrive(url(server))
        await server.end()
        assert (await caller.closed())[0] == 1001

"""Sessions: who opens one and who does not; none is left open. In one process, on a port of this machine."""

from __future__ import annotations

import asyncio
import logging
from socket import IPPROTO_TCP, TCP_NODELAY
from time import thread_time

import pytest
from bokeh.document import Document
from bokeh.io.doc import _PATCHED_CURDOCS
from bokeh.server.session import ServerSession
from bokeh.util.token import generate_jwt_token, generate_session_id

from app import open_page
from components.serving.sockets import MOST_MISSED, MOST_PINGS, Socket, metered
from components.serving.tokens import opens_session
from tests.attack.caller import Caller, connect, event, header, patch, refused, said, token_of
from tests.serving.served import page_of, served, sessions, until, url

SECRET = "a secret of sixteen letters"
PULL = (header("PULL-DOC-REQ"), "{}", "{}")
WORD = "the word that is for the log"


def fail(_: object) -> None:
    raise ArithmeticError(WORD)


async def test_a_token_opens_its_session_on_every_server_with_the_secret() -> None:
    async with served(bokeh_secret_key=SECRET) as first, served(bokeh_secret_key=SECRET) as second, served() as other:
        token = token_of((await page_of(first, "/?scene=coupled&k2=7")).text)
        caller = Caller(await connect(url(second), token))
        await until(lambda: len(sessions(second)) == 1)
        assert sessions(second)[0].document.title == sessions(first)[0].document.title
        name = generate_session_id(secret_key=SECRET.encode(), signed=True)
        late, good = (generate_jwt_token(name, SECRET.encode(), True, expiration=seconds) for seconds in (-1, 60))
        assert opens_session(good, SECRET.encode())
        for server, wrong in ((other, token), (first, late), (first, name)):
            assert await refused(url(server), wrong) == 403
        assert other.context.secret != second.context.secret and len(other.context.secret) > 32
        await caller.depart()


async def test_what_fails_for_one_visitor_is_said_in_a_sentence_logged_once_and_leaves_no_document_to_others(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(document: Document) -> None:
        open_page(document)
        document.on_event("document_ready", fail)

    async def fails(*_: object) -> None:
        fail(None)

    before = len(_PATCHED_CURDOCS)
    async with served(fail, bokeh_secret_key=SECRET) as server, served(failing, bokeh_secret_key=SECRET) as sound:
        page = await page_of(server)
        assert page.status == 500 and page.quiet and WORD not in page.text
        assert "Something went wrong on the server" in page.text
        caller = Caller(await connect(url(server), token_of((await page_of(sound)).text)))
        assert (await caller.closed())[0] == 1011
        monkeypatch.setattr(ServerSession, "pull", fails)
        for message, code in ((patch(event("document_ready")), 1011), (said(None, model="p0"), 1008), (PULL, 1011)):
            caplog.clear()
            caller = await Caller.arrive(url(sound))
            await caller.send(*message)
            found, reason = await caller.closed()
            assert found == code and (code == 1008 or "Something went wrong on the server" in reason)
            errors = [record.levelno for record in caplog.records if record.exc_info]
            assert errors == [logging.ERROR] * (code == 1011) and (WORD in caplog.text) is (code == 1011)
    assert len(_PATCHED_CURDOCS) == before


async def test_a_socket_is_closed_that_misses_two_pings_or_sends_pings_without_end_and_all_at_the_end() -> None:
    async with served() as server:
        caller, silent, noisy = [await Caller.arrive(url(server)) for _ in range(3)]
        silent.socket.protocol._send_pong = lambda _: None  # type: ignore[union-attr]
        for _ in range(MOST_MISSED + 1):
            for socket in list(server.context.admission.sockets):
                socket.pulse()
            await caller.send(*PULL)
            for _ in range(3):  # the answer comes after the pong
                await caller.receive()
        assert await silent.closed() == (1001, "No answer to two pings.")
        assert len(server.context.admission.sockets) == 2
        for _ in range(MOST_PINGS):
            noisy.socket.ping(b"")
        assert await noisy.closed() == (1008, "Too many pings.")
        await server.end()
        assert (await caller.closed())[0] == 1001


async def test_a_page_has_one_socket_which_delays_no_answer() -> None:
    async with served() as server:
        token = token_of((await page_of(server)).text)
        first, second = Caller(await connect(url(server), token)), Caller(await connect(url(server), token))
        assert await first.closed() == (1008, "This page has a newer connection.")
        await until(lambda: len(server.context.admission.sockets) == 1)
        (socket,) = server.context.admission.sockets
        assert isinstance(socket, Socket) and socket.ws_connection is not None
        assert socket.ws_connection.stream.socket.getsockopt(IPPROTO_TCP, TCP_NODELAY)
        for _ in range(3):  # the greeting
            await second.receive()
        await second.send(*PULL)
        assert await second.receive()
        await second.depart()


async def busy(seconds: float) -> None:
    end = thread_time() + seconds
    while thread_time() < end:
        pass


async def test_nobody_pays_for_what_another_asks_for_meanwhile() -> None:
    async def patient() -> None:
        await busy(0.01)
        await asyncio.sleep(0.01)
        await asyncio.sleep(0)

    other = asyncio.create_task(busy(0.2))
    took = await metered(patient())
    await other
    assert 0.01 <= took < 0.1

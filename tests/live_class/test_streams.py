"""Edge cases of the streams of a live class: news while a stream starts or its reader is slow."""

from __future__ import annotations

import asyncio
import re
import socket
from typing import Any

import pytest

from components.live_class import room as rooms
from components.live_class.follower_routes import Events
from components.live_class.registry import Registry
from components.live_class.store import MemoryStore
from tests.live_class.caller import Class, Stream, streams_closed
from tests.live_class.listening import until
from tests.live_class.served import LECTURE, served, teaching
from tests.live_class.stores import Valkey, made


async def test_news_during_the_start_of_a_stream_is_received(monkeypatch: pytest.MonkeyPatch) -> None:
    usual, begun, free = Events.flush, asyncio.Event(), asyncio.Event()

    def slow(handler: Events, *given: Any) -> asyncio.Future[None]:
        sent = usual(handler, *given)

        async def held() -> None:
            await sent
            begun.set()
            await free.wait()

        return asyncio.ensure_future(held())

    monkeypatch.setattr(Events, "flush", slow)

    async with teaching() as (server, url):
        lesson = await Class.open(url)
        leader, follower = await lesson.lead(), await lesson.follow()
        await begun.wait()
        server.classes.registry.leave(server.classes.registry.rooms[lesson.code])  # as upkeep does once a second
        registry = server.classes.registry
        await registry.store.publish(lesson.code, {"deed": b'"next"'})
        await lesson.order("clock", t=1.0, rate=0.0, end=20.0, at=0.0)
        free.set()
        assert await leader.until(lambda event: event.get("deed") == "next")
        for stream in (leader, follower):
            assert (await stream.until(lambda event: event.get("clock")))["clock"]["t"] == 1.0
            await stream.close()


@pytest.mark.parametrize("leads", [False, True])
async def test_who_reads_slowly_gets_the_latest_picture_and_an_instructor_each_deed_once(leads: bool) -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        quick, word = await lesson.follow(), lesson.key if leads else await lesson.token()
        slow = socket.create_connection(("127.0.0.1", server.port))
        slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        head = f"GET /class/{lesson.code}/events HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer {word}\r\n\r\n"
        slow.sendall(head.encode())
        room = server.classes.registry.rooms[lesson.code]
        await until(lambda: room.is_led if leads else room.followers == 2)
        room.deliver({"deed": b'"back"'})
        for i in range(400):
            room.deliver({"picture": b'{"sheet":"%d","data":"%s"}' % (i, b"A" * 4000)})
            await asyncio.sleep(0)
        room.deliver({"deed": b'"next"'})
        await quick.until(lambda event: event.get("picture", {}).get("sheet") == "399")
        slow.settimeout(30)
        read = b""
        while (b'"deed":"next"' if leads else b'"sheet":"399"') not in read:
            read += await asyncio.to_thread(slow.recv, 65536)
        seen = [int(number) for number in re.findall(rb'"sheet":"(\d+)"', read)]
        assert len(seen) < 200 and seen == sorted(seen) and seen[-1] == 399
        assert read.count(b'"deed":"back"') == read.count(b'"deed":"next"') == leads
        slow.close()
        await quick.close()


def test_a_deed_of_long_ago_is_not_done(monkeypatch: pytest.MonkeyPatch) -> None:
    room = rooms.ClassRoom("K7HM", {})
    before = room.number
    room.deliver({"deed": b'"next"'})
    room.deliver({"answers": b"true"})
    assert [(news.deed, news.answers) for news in room.news_after(before)] == [("next", False), ("", True)]
    monkeypatch.setattr(rooms, "OBEYED", 0.0)
    assert [(news.deed, news.answers) for news in room.news_after(before)] == [("", True)]


async def test_a_room_is_kept_while_somebody_is_on_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    registry = Registry(MemoryStore(), LECTURE.bank)
    code, key = await registry.open()
    room = await registry.led(code, key)
    registry.leave(room)
    assert await registry.room(code) is room
    monkeypatch.setattr(rooms, "SILENCE", 0.0)
    registry.leave(room)
    assert not registry.rooms


async def test_a_phone_whose_tabs_are_at_two_replicas_is_one_and_asleep_none(valkey: Valkey) -> None:
    async with (
        made("valkey", valkey.url) as store,
        made("valkey", valkey.url) as other,
        served(store) as (_, url),
        served(other) as (_, second),
        streams_closed(),
    ):
        lesson = await Class.open(url)
        leader, token = await lesson.lead(), await lesson.token()
        tabs = [await Stream(at, lesson.code, token).open() for at in (url, second)]
        await lesson.follow(second)
        heard = leader.heard
        await leader.until(lambda event: event.get("here") == 2)
        assert max(event.get("here", 0) for _, event in heard) == 2  # never three
        await tabs[0].close()
        await tabs[1].close()  # both are asleep
        await leader.until(lambda event: event is heard[-1][1] and event.get("here") == 1)

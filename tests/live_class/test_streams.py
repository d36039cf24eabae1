"""Streams of a live class and the places that they take: slow readers, several tabs, sleeping phones."""

from __future__ import annotations

import asyncio
import re
import socket

import pytest

from components.live_class import follower_routes
from components.live_class import registry as registries
from components.live_class import room as rooms
from components.live_class.room import name_of
from tests.live_class.caller import Class, Stream, called
from tests.live_class.served import CHOICE, served, taught
from tests.live_class.stores import Valkey, made
from tests.serving.served import until


def unread(lesson: Class, port: int, word: str) -> socket.socket:
    """Open a stream that nobody reads."""
    mute = socket.socket()
    mute.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    mute.connect(("127.0.0.1", port))
    head = f"GET /class/{lesson.code}/events HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer {word}\r\n\r\n"
    mute.sendall(head.encode())
    return mute


def picture(sheet: object) -> dict[str, bytes]:
    return {"picture": b'{"sheet":"%s","data":"%s"}' % (str(sheet).encode(), b"A" * 4000)}


@pytest.mark.parametrize("leads", [False, True])
async def test_who_reads_slowly_gets_the_latest_picture_and_an_instructor_each_deed_once(leads: bool) -> None:
    async with taught() as (server, _, lesson):
        quick, word = await lesson.follow(), lesson.key if leads else await lesson.token()
        slow, room = unread(lesson, server.port, word), server.classes.registry.rooms[lesson.code]
        await until(lambda: room.is_led if leads else room.followers == 2)
        room.deliver({"deed": b'"back"'})
        for i in range(400):
            room.deliver(picture(i))
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


async def test_a_follower_that_never_reads_is_let_go(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(follower_routes, "GIVEN_UP", 0.3)

    async with taught() as (server, _, lesson):
        mute = unread(lesson, server.port, await lesson.token())
        room = server.classes.registry.rooms[lesson.code]
        await until(lambda: room.listeners)
        async with asyncio.timeout(30):
            while room.listeners:
                room.deliver(picture("s"))
                await asyncio.sleep(0.01)
        mute.close()


async def test_a_storm_of_streams_takes_no_places_and_a_phone_at_two_replicas_is_one(
    valkey: Valkey, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The newest streams of a phone stay open, and so do those of others. Asleep, it is none."""
    monkeypatch.setattr(follower_routes, "MOST_STREAMS", 2)
    async with (
        made("valkey", valkey.url) as store,
        made("valkey", valkey.url) as other,
        served(store=store) as (server, url),
        served(other) as (_, second),
    ):
        lesson = await Class.open(url)
        leader, token = await lesson.lead(), await lesson.token()
        friend, there = await lesson.follow(second), await Stream(second, lesson.code, token).open()
        tabs = [await Stream(url, lesson.code, token).open() for _ in range(3 * follower_routes.MOST_STREAMS)]
        await until(lambda: sum(tab.ended for tab in tabs) >= 2 * follower_routes.MOST_STREAMS)
        room = server.classes.registry.rooms[lesson.code]
        assert (room.followers, room.places) == (1, 2) and not tabs[-1].ended and not friend.ended
        await leader.until(lambda event: event.get("here") == 2)
        assert max(event.get("here", 0) for _, event in leader.heard) == 2  # never three
        await asyncio.gather(*(tab.close() for tab in (*tabs, there)))
        await leader.until(lambda event: event is leader.heard[-1][1] and event.get("here") == 1)
        await until(lambda: len(room.streams) == 1)  # the leader's


async def test_a_vote_is_of_somebody_who_follows_or_was_here_a_moment_ago(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rooms, "SILENCE", 0.05)

    async with taught() as (server, url, lesson):
        token, store = await lesson.token(), server.classes.registry.store
        stream = await Stream(url, lesson.code, token).open()
        early = await lesson.vote(token, **CHOICE, option=0)  # before its question is restored
        assert early.status == 503 and "no question yet" in early.json["sentence"]
        await lesson.order("put", **CHOICE)
        stranger = (await called(url, f"/class/{lesson.code}/token", "POST")).json["token"]
        refused = await lesson.vote(stranger, **CHOICE, option=0)
        assert refused.status == 503 and refused.json["sentence"].startswith("This phone does not follow")
        await asyncio.sleep(0.2)
        assert (await lesson.vote(token, **CHOICE, option=0)).status == 204
        await stream.close()
        room = server.classes.registry.rooms[lesson.code]
        await until(lambda: not room.follows(name_of(token)))
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 503
        await store.name(lesson.code, "another replica", [name_of(token)])
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 204
        assert (await lesson.tally())["now"]["options"] == [0, 1, 0]


async def test_one_client_does_not_fill_a_vote(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registries, "SPARE", 2)

    async with taught() as (server, _, lesson):
        await lesson.order("put", **CHOICE)
        early, late = await lesson.token(), await lesson.token()
        assert (await lesson.vote(early, **CHOICE, option=1)).status == 204
        room = server.classes.registry.rooms[lesson.code]
        for _ in range(10):  # joins, votes and leaves
            token = await lesson.token()
            assert (await lesson.vote(token, **CHOICE, option=0)).status == 204
            del room.polls[name_of(token)]
        del room.polls[name_of(early)]  # a sleeping phone
        assert (await lesson.vote(late, **CHOICE, option=2)).status == 204
        now = (await lesson.tally())["now"]
        assert now["answered"] <= 2 + 2 * 3 and now["options"][1:] == [1, 1]

"""Attacks on a class: guessing its code, controlling it without its key, flooding it, taking its places."""

from __future__ import annotations

import asyncio
import socket

import pytest

from components.live_class import follower_routes, instructor_routes, registry
from components.live_class import room as rooms
from components.live_class.room import name_of
from tests.live_class.caller import Class, Stream, called
from tests.live_class.listening import until
from tests.live_class.served import CHOICE, teaching

SKETCH = {"walk": "d34", "step": "d34-14"}


async def test_no_response_reveals_if_a_code_belongs_to_a_class() -> None:
    asked = [
        ("GET", "lead", None), ("POST", "lead", {"type": "end"}), ("GET", "tally", None), ("GET", "answers.csv", None),
        ("PUT", "lead", {}), ("GET", "answers?question=d31/d31-03/1", None),
        ("POST", "tickets", None), ("PUT", "tickets", {"digits": "10"}), ("GET", "remote", None), ("GET", "now", None),
        ("DELETE", "tickets", {"digits": "10"}),
        ("POST", "remote", {"deed": "next"}), ("PUT", "remote", {"address": "x"}), ("GET", "events", None),
        ("PUT", "answer", {**CHOICE, "option": 0}), ("POST", "answer", {**CHOICE, "option": 0}),
    ]  # fmt: skip

    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        none = "2222" if lesson.code != "2222" else "3333"
        for word in ("", "x" * 32, "made.up"):
            for method, path, body in asked:
                there, nowhere = [
                    await called(url, f"/class/{code}/{path}", method, body, word) for code in (lesson.code, none)
                ]
                assert there[:2] == nowhere[:2], path
                assert there.status in (403, 404, 409) and there.json["sentence"].endswith(".")


async def test_a_remote_control_without_its_ticket_drives_nothing() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        leader = await lesson.lead()
        path = f"/class/{lesson.code}/remote"
        for word in (
            "",
            await lesson.token(),
            lesson.key,
        ):  # neither a follower's token nor the key makes a remote control
            assert (await called(url, path, "POST", {"deed": "next"}, word)).status == 403
        await lesson.order("withdraw")
        await leader.until(lambda event: event.get("question"))
        assert not any(event.get("deed") for _, event in leader.heard)
        await leader.close()


async def test_who_floods_an_instructors_door_does_not_close_it() -> None:
    async with teaching() as (server, url):
        server.classes.rate.most = 5
        lesson, path = await Class.open(url), "/class/{}/{}"
        for _ in range(10):
            assert (await called(url, path.format(lesson.code, "lead"), "POST", {"type": "end"}, "x")).status == 404
            assert (await called(url, path.format(lesson.code, "remote"), "PUT", {"address": "x"})).status == 403
        ticket = (await called(url, path.format(lesson.code, "tickets"), "POST", word=lesson.key)).json
        secret = {"address": ticket["address"].partition("remote=")[2]}
        assert (await called(url, path.format(lesson.code, "remote"), "PUT", secret)).status == 200
        assert [(await lesson.order("withdraw")).status for _ in range(6)][-1] == 429


async def test_sketches_that_are_too_large_are_refused_in_words() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **SKETCH)
        token = await lesson.token()
        for curves, status in (
            ({"Xp1": [500] * 101}, 204), ({"Xp1": [500] * 102}, 400), ({"Xp1": [1101] * 101}, 400),
            ({"Xp1": [5] * 100}, 409), ({"Xp9": [5] * 101}, 409), ({f"X{i}": [5] * 101 for i in range(3)}, 400),
            ({"Xp1": [1e3] * 101, "Xp2": [-1e-7] * 101}, 400), ({"Xp1": [500] * 5_000}, 413),
        ):  # fmt: skip
            reply = await lesson.vote(token, **SKETCH, curves=curves)
            assert reply.status == status, reply.text
            assert status == 204 or reply.json["sentence"].endswith(".")
        tally = (await lesson.tally())["now"]
        assert [sketch["curves"] for sketch in tally["sketches"]] == [{"Xp1": [500] * 101}]


async def test_a_storm_of_streams_takes_no_places() -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        other, token = await lesson.follow(), await lesson.token()
        streams = [await Stream(url, lesson.code, token).open() for _ in range(3 * follower_routes.MOST_STREAMS)]
        room = server.classes.registry.rooms[lesson.code]
        await until(lambda: sum(stream.ended for stream in streams) >= 2 * follower_routes.MOST_STREAMS)
        assert room.followers == 2  # any number of tabs of one phone
        assert not streams[-1].ended and not other.ended  # the newest streams stay open, and so do those of others
        for stream in streams:
            await stream.close()
        await until(lambda: len(room.streams) <= 1)
        await other.close()


async def test_a_follower_that_never_reads_is_let_go(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(follower_routes, "GIVEN_UP", 0.3)

    async with teaching() as (server, url):
        lesson = await Class.open(url)
        mute = socket.socket()
        mute.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        mute.connect(("127.0.0.1", server.port))
        head = f"GET /class/{lesson.code}/events HTTP/1.1\r\nHost: 127.0.0.1\r\n"
        mute.sendall(f"{head}Authorization: Bearer {await lesson.token()}\r\n\r\n".encode())
        room = (await called(url, f"/class/{lesson.code}/lead", word=lesson.key)) and server.classes.registry.rooms
        async with asyncio.timeout(30):
            while room[lesson.code].followers < 1:
                await asyncio.sleep(0.01)
            while room[lesson.code].followers:
                room[lesson.code].deliver({"picture": b'{"sheet":"s","data":"%s"}' % (b"A" * 4000)})
                await asyncio.sleep(0.01)
        mute.close()


async def test_a_vote_is_of_somebody_who_follows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rooms, "SILENCE", 0.05)

    async with teaching() as (server, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        stranger = (await called(url, f"/class/{lesson.code}/token", "POST")).json["token"]
        refused = await lesson.vote(stranger, **CHOICE, option=0)
        assert refused.status == 503 and refused.json["sentence"].startswith("This phone does not follow")
        token = await lesson.token()
        stream = await Stream(url, lesson.code, token).open()
        await asyncio.sleep(0.2)
        assert (await lesson.vote(token, **CHOICE, option=0)).status == 204
        await stream.close()
        room = server.classes.registry.rooms[lesson.code]
        await until(lambda: not room.follows(name_of(token)))
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 503
        await server.classes.registry.store.name(lesson.code, "another replica", [name_of(token)])
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 204
        assert (await lesson.tally())["now"]["options"] == [0, 1, 0]


async def test_one_client_does_not_fill_a_vote(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "SPARE", 2)

    async with teaching() as (server, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        early, late = await lesson.token(), await lesson.token()
        assert (await lesson.vote(early, **CHOICE, option=1)).status == 204
        room = server.classes.registry.rooms[lesson.code]
        for _ in range(20):  # joins, votes and leaves
            token = await lesson.token()
            assert (await lesson.vote(token, **CHOICE, option=0)).status == 204
            del room.polls[name_of(token)]
        del room.polls[name_of(early)]  # a sleeping phone
        assert (await lesson.vote(late, **CHOICE, option=2)).status == 204
        now = (await lesson.tally())["now"]
        assert now["answered"] <= 2 + 2 * 3 and now["options"][1:] == [1, 1]


async def test_one_network_does_not_take_all_rooms(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 2)

    async with teaching(trusted_proxies=("127.0.0.1",)) as (_, url):

        async def opened(address: str) -> int:
            return (await called(url, "/class", "POST", X_Forwarded_For=address)).status

        assert [await opened(f"198.51.100.{i}") for i in range(4)] == [200, 200, 429, 429]
        assert await opened("203.0.113.9") == 200

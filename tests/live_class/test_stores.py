"""The contract of every store of classes: one set of tests for memory and for Valkey."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable
from contextlib import AbstractAsyncContextManager, suppress
from functools import partial
from itertools import count
from random import Random

import pytest
import redis

from components.live_class import shared_store, store
from components.live_class.codes import code_of, new_key
from components.live_class.store import Parts, Store
from tests.live_class.stores import KINDS, Valkey, made, valkey_running

Kept = Callable[..., AbstractAsyncContextManager[Store]]


@pytest.fixture(params=KINDS)
def on(request: pytest.FixtureRequest) -> Kept:
    """A store of each kind."""
    kind = request.param
    url = request.getfixturevalue("valkey").url if kind == "valkey" else ""

    if url:
        with redis.Redis.from_url(url) as client:
            client.flushall()

    return partial(made, kind, url)


async def until(happens: Callable[[], Awaitable[bool]], seconds: float = 30.0) -> None:
    async with asyncio.timeout(seconds):
        while not await happens():
            await asyncio.sleep(0.01)


async def test_a_room_is_opened_once_and_keeps_its_parts(on: Kept) -> None:
    async with on() as kept:
        code = code_of(new_key())
        assert await kept.parts(code) == {}
        assert await kept.open(code, {"key": b"1"})
        assert not await kept.open(code, {"key": b"2"})
        assert await kept.keep(code, {"clock": b"3", "picture": b"\x00\xff"})
        assert await kept.keep(code, {"clock": b"4"})
        assert await kept.parts(code) == {"key": b"1", "clock": b"4", "picture": b"\x00\xff"}
        await kept.end(code)
        assert await kept.parts(code) == {}
        assert not await kept.keep(code, {"clock": b"5"})
        assert await kept.parts(code) == {}


@pytest.mark.slow
async def test_a_room_ends_some_time_after_the_last_sign_of_its_instructor(on: Kept) -> None:
    async with on(life=0.8) as kept:
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        await kept.vote(code, "d31/a/1", "one", b"1")
        for _ in range(4):
            await asyncio.sleep(0.3)
            assert await kept.keep(code, {})

        async def over() -> bool:
            await kept.present(code, "here", {"one"})  # followers do not show that the instructor is there
            return await kept.parts(code) == {}

        await until(over)
        assert await kept.votes(code, "d31/a/1") == {}
        assert not await kept.vote(code, "d31/a/1", "two", b"1")


async def test_a_room_that_nobody_leads_or_follows_ends_soon(on: Kept) -> None:
    async with on(alone=0.6) as kept:
        followed, alone = code_of(new_key()), code_of(new_key())
        for code in (followed, alone):
            await kept.open(code, {"key": b"1"})
            await kept.vote(code, "d31/a/1", "one", b"1")
        assert await kept.rooms() == 2

        async def over() -> bool:
            await kept.present(followed, "here", {"one"})
            await kept.present(alone, "here", ())
            return await kept.parts(alone) == {}

        await until(over)
        assert await kept.parts(followed) and await kept.votes(followed, "d31/a/1")
        assert await kept.votes(alone, "d31/a/1") == {} and await kept.rooms() == 1


@pytest.mark.slow
async def test_where_all_rooms_are_taken_one_that_is_alone_makes_way(on: Kept, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (store, shared_store):
        monkeypatch.setattr(module, "QUIET", 2.0)

    async with on(rooms=2) as kept:
        assert await kept.open("AAAA", {"key": b"1"}) and await kept.open("BBBB", {"key": b"1"})
        assert not await kept.open("CCCC", {"key": b"1"})
        await asyncio.sleep(2.2)
        await kept.keep("AAAA", {})
        assert await kept.open("CCCC", {"key": b"1"})
        assert await kept.parts("AAAA") and not await kept.parts("BBBB")
        assert not await kept.open("BBBB", {"key": b"1"})


async def test_a_room_has_so_many_bytes_of_answers_and_says_so(on: Kept) -> None:
    two = 2 * (store.OF_A_VOTE + store.OF_AN_ANSWER)
    async with on(size=two + 100) as kept:
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        assert await kept.vote(code, "a", "one", b"x" * 60)
        with pytest.raises(store.FullError, match="cannot store more answers"):
            await kept.vote(code, "b", "two", b"x" * 60)
        assert await kept.vote(code, "a", "one", b"x" * 30)  # in place of the longer one
        assert await kept.vote(code, "b", "two", b"x" * 60)
        await kept.unvote(code, "b", "two")
        assert await kept.vote(code, "b", "three", b"x" * 60)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stores with 100 kB in all, a tenth of it for pictures and questions only."""
    for module in (store, shared_store):
        monkeypatch.setattr(module, "ALL_BYTES", 100_000)
        monkeypatch.setattr(module, "RESERVE", 10_000)


async def fill(kept: Store, code: str) -> int:
    """Fill a class with as many answers as it accepts, and return their bytes."""
    for number in count():
        try:
            assert await kept.vote(code, f"d31/a/{number % 9}", f"{number:019}", b"x" * 1000, 10**6)
        except store.FullError:
            return 1000 * number
    raise AssertionError


async def test_a_greedy_owner_leaves_the_others_a_share(on: Kept, small: None) -> None:
    """The limit holds for any number of classes; a class keeps the picture it has shown."""
    async with on() as kept:
        for code, owner in (("AAAA", b"greedy"), ("BBBB", b"greedy"), ("CCCC", b"other"), ("DDDD", b"")):
            await kept.open(code, {"key": b"1", **({store.OWNER: owner} if owner else {})})
        first, second, other, none = [await fill(kept, code) for code in ("AAAA", "BBBB", "CCCC", "DDDD")]
        assert first + second < 50_000 and second == 0  # half of it
        assert 12_000 < other < 25_000 and 5_000 < none < 12_500
        assert await kept.keep("DDDD", {"picture": b"x" * 3000})
        with pytest.raises(store.FullError, match="memory for live classes is full"):
            await kept.keep("DDDD", {"walks": b"x" * 30_000})
        await kept.end("AAAA")
        assert await fill(kept, "CCCC") > 3000  # ended classes free their bytes


async def test_rooms_that_are_over_take_no_bytes(on: Kept, small: None) -> None:
    async with on(alone=0.3) as kept:
        await kept.open("AAAA", {"key": b"1"})
        first = await fill(kept, "AAAA")

        async def over() -> bool:
            return await kept.parts("AAAA") == {}

        await until(over)
        await kept.open("BBBB", {"key": b"1"})
        assert await fill(kept, "BBBB") == first


async def test_the_bytes_that_are_counted_are_no_fewer_than_those_of_the_store(valkey: Valkey, small: None) -> None:
    """The smallest answers need more bytes than they contain; many votes have only one answer."""
    async with made("valkey", valkey.url) as kept:
        with redis.Redis.from_url(valkey.url) as client:
            client.flushall()
            for room in range(5):
                code = code_of(f"{room}")
                await kept.open(code, {"key": b"1"})
                with suppress(store.FullError):
                    for number in range(1000):
                        question = "d31/d31-03/1" if room % 2 else f"d31/d31-{number:03}/1"
                        assert await kept.vote(code, question, f"{number:019}", b"x" * 130)
            taken = sum(int(client.memory_usage(key) or 0) for key in client.scan_iter())  # type: ignore[arg-type]
        assert store.ALL_BYTES // 3 < taken < store.ALL_BYTES


async def test_an_existing_answer_is_kept_unless_it_may_be_replaced(on: Kept) -> None:
    async with on() as kept:
        await kept.open("AAAA", {"key": b"1"})
        assert await kept.vote("AAAA", "a", "one", b"new", replace=False)
        assert await kept.vote("AAAA", "a", "one", b"old", replace=False)
        assert await kept.votes("AAAA", "a") == {"one": b"new"}


async def test_a_full_store_says_so_and_forgets_no_class() -> None:
    with valkey_running() as server:
        async with made("valkey", server.url) as kept:
            await kept.open("AAAA", {"key": b"1"})
            await kept.vote("AAAA", "a", "one", b"1")
            with redis.Redis.from_url(server.url) as client:
                client.config_set("maxmemory", 1)
            for act in (kept.keep("AAAA", {"clock": b"1"}), kept.open("BBBB", {"key": b"1"}), kept.count("x", 60)):
                with pytest.raises(store.FullError, match="memory for live classes is full"):
                    await act
            assert await kept.count("x", 60, 0) == 0
            assert await kept.parts("AAAA") == {"key": b"1"} and await kept.votes("AAAA", "a") == {"one": b"1"}


async def test_who_follows_is_known_to_all_replicas(on: Kept) -> None:
    async with on() as kept:
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        await kept.name(code, "a", ["one", "two"])
        await kept.name(code, "b", {"three"})
        await kept.name(code, "a", ["two"])
        assert await kept.named(code) == {"two", "three"}
        assert abs(await kept.time() - time.time()) < 5


async def test_one_answer_for_a_voter_and_no_more_than_there_is_place_for(on: Kept) -> None:
    async with on() as kept:
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        assert [await kept.vote(code, "b", voter, b"1", 2) for voter in ("one", "two", "three")] == [True, True, False]
        assert await kept.vote(code, "b", "one", b"2")
        assert await kept.votes(code, "b") == {"one": b"2", "two": b"1"}
        assert await kept.vote(code, "a", "three", b"1")
        assert await kept.questions(code) == ["b", "a"]
        await kept.unvote(code, "b", "two")
        assert await kept.vote(code, "b", "three", b"3", 2)
        assert await kept.votes(code, "b") == {"one": b"2", "three": b"3"}


async def test_rooms_are_bounded(on: Kept) -> None:
    async with on(rooms=1) as kept:
        assert await kept.open("AAAA", {"key": b"1"})
        assert not await kept.open("BBBB", {"key": b"1"})
        await kept.end("AAAA")
        assert await kept.open("BBBB", {"key": b"1"})


async def test_listeners_get_what_is_stored_published_and_ended(on: Kept) -> None:
    async with on() as kept:
        heard: list[tuple[str, Parts]] = []
        ready = asyncio.Event()
        task = asyncio.create_task(kept.listen(lambda code, parts: heard.append((code, dict(parts))), ready.set))
        await asyncio.wait_for(ready.wait(), 30)
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        await kept.keep(code, {"clock": b"1"})
        await kept.keep(code, {})
        await kept.publish(code, {"deed": b'"next"'})
        await kept.end(code)

        async def whole() -> bool:
            return len(heard) == 3

        await until(whole)
        assert heard == [(code, {"clock": b"1"}), (code, {"deed": b'"next"'}), (code, {})]
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)


async def test_former_listeners_get_nothing(on: Kept) -> None:
    async with on() as kept:
        heard: dict[str, list[Parts]] = {"left": [], "stays": []}
        tasks = {}
        for name, updates in heard.items():
            ready = asyncio.Event()
            receive = partial(_append, updates)
            tasks[name] = asyncio.create_task(kept.listen(receive, ready.set))
            await asyncio.wait_for(ready.wait(), 30)
        tasks["left"].cancel()
        await asyncio.gather(tasks["left"], return_exceptions=True)
        await kept.publish("AAAA", {"clock": b"1"})

        async def arrived() -> bool:
            return bool(heard["stays"])

        await until(arrived)
        assert heard == {"left": [], "stays": [{"clock": b"1"}]}
        tasks["stays"].cancel()
        await asyncio.gather(tasks["stays"], return_exceptions=True)


def _append(updates: list[Parts], code: str, parts: Parts) -> None:
    updates.append(dict(parts))


async def test_those_present_are_counted_over_replicas(on: Kept) -> None:
    async with on() as kept:
        code = code_of(new_key())
        await kept.open(code, {"key": b"1"})
        assert await kept.present(code, "a", ["one", "two"]) == 2
        assert (
            await kept.present(code, "b", ["two", "three", "four"]) == 4
        )  # one phone with two tabs at two replicas counts once
        assert await kept.present(code, "a", ["one"]) == 4
        assert await kept.present(code, "b", ()) == 1


async def test_what_is_counted_adds_up_and_what_is_lent_is_taken_once(on: Kept) -> None:
    async with on() as kept:
        name = code_of(new_key())
        assert [await kept.count(name, 3600, more) for more in (1, 1, 0, 3)] == [1, 2, 2, 5]
        assert await kept.count(f"{name} too", 3600) == 1
        await kept.lend(name, b"key", b"ticket", 60)
        taken = [await kept.take(*asked) for asked in ((name, b"wrong"), ("other", b"key"), (name, b"key"))]
        assert taken == [b"", b"", b"ticket"] and await kept.take(name, b"key") == b""
        for key in (b"first", b"second"):  # it replaces the first
            await kept.lend(name, key, b"of the " + key, 60)
        assert [await kept.take(name, key) for key in (b"first", b"second")] == [b"", b"of the second"]
        await kept.lend(name, b"key", b"short", 0.05)
        await asyncio.sleep(0.1)
        assert await kept.take(name, b"key") == b""


@pytest.mark.parametrize("seconds", [60.0, 4 * 3600.0])
async def test_whatever_is_counted_counts_for_the_whole_span_and_a_twelfth_more_at_most(
    on: Kept, seconds: float
) -> None:
    """At any time, so that no interval boundary gives anybody a new allowance."""
    chance, now = Random(45), time.time()
    async with on(clock=lambda: now) as kept:
        for name in ("steady", "bursts"):
            happened: list[float] = []
            for _ in range(150):
                now += chance.choice([0.0, 0.001, 0.3, 0.4, 1.0]) * seconds * chance.random()
                if name == "steady" or chance.random() < 0.3:
                    more = chance.choice([1, 1, 4])
                    happened += [now] * more
                    times = await kept.count(name, seconds, more)
                else:
                    times = await kept.count(name, seconds, 0)
                least, most = (sum(at > now - span for at in happened) for span in (seconds, seconds * 13.01 / 12))
                assert least <= times <= most


async def test_no_number_of_names_makes_a_count_forgotten(on: Kept) -> None:
    now = time.time()
    async with on(counts=20, clock=lambda: now) as kept:
        assert await kept.count("first", 60, 3) == 3
        for name in range(100):  # names that are only looked up take no place
            assert await kept.count(f"asked {name}", 60, 0) == 0
        for name in range(19):
            assert await kept.count(f"other {name}", 6) == 1
        for more in (0, 1):  # its count is unknown, so it is not reported as 0
            with pytest.raises(store.UnreachableError):
                await kept.count("one too many", 60, more)
        assert await kept.count("first", 60) == 4
        now += 10  # the others have expired
        assert await kept.count("one too many", 60) == 1 and await kept.count("first", 60) == 5


async def test_a_store_that_goes_away_is_an_error_of_ours(valkey: Valkey) -> None:
    async with made("valkey", "redis://127.0.0.1:1/0") as kept:
        with pytest.raises(store.UnreachableError):
            await kept.parts("K7HM")
        with pytest.raises(store.UnreachableError):
            await kept.listen(lambda code, parts: None, lambda: None)


async def test_a_store_that_falls_silent_is_noticed_and_one_that_has_nothing_to_say_is_not(
    valkey: Valkey, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shared_store, "PULSE", 0.1)

    async with made("valkey", valkey.url) as kept:
        listening = asyncio.create_task(kept.listen(lambda code, parts: None, lambda: None))
        await asyncio.sleep(1)
        assert not listening.done()
        with valkey.silent(), pytest.raises(store.UnreachableError):
            await asyncio.wait_for(listening, 30)

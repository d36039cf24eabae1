"""The contract of every store of classes: one set of tests for memory and for Valkey, and both do the same."""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import Awaitable, Callable
from contextlib import AbstractAsyncContextManager, suppress
from functools import partial
from itertools import count
from random import Random
from typing import Any

import pytest
import redis
from hypothesis import given, settings
from hypothesis import strategies as st

from components.live_class import shared_store, store
from components.live_class.codes import code_of
from components.live_class.store import FullError, Store, UnreachableError
from tests.grids import tries
from tests.live_class.stores import KINDS, Valkey, made, set_limits
from tests.serving.served import until

Kept = Callable[..., AbstractAsyncContextManager[Store]]
LIMITS = {"rooms": 3, "size": 2500}


@pytest.fixture(params=KINDS)
def on(request: pytest.FixtureRequest) -> Kept:
    """A store of each kind."""
    url = emptied(request.getfixturevalue("valkey")).url if request.param == "valkey" else ""
    return partial(made, request.param, url)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stores with 100 kB in all, a tenth of it for pictures and questions only."""
    set_limits(monkeypatch, 100_000, 10_000)


def emptied(valkey: Valkey) -> Valkey:
    with redis.Redis.from_url(valkey.url) as client:
        client.flushall()
    return valkey


# Both stores do the same, and what others do changes nothing of mine.

CODES = ("AAAA", "BBBB", "CCCC", "DDDD")
CODE, QUESTION, VOTER = st.sampled_from(CODES), st.sampled_from("qr"), st.sampled_from(["one", "two", "three"])
BYTES = st.sampled_from([b"", b"1", b"x" * 300, b"x" * 900])
PARTS = st.dictionaries(st.sampled_from(["clock", "picture"]), BYTES, max_size=2)
REPLICA, NAMES, NAME, KEY = (
    st.sampled_from("ab"),
    st.sets(st.sampled_from("wxyz")),
    st.sampled_from("mn"),
    st.sampled_from([b"k", b"l"]),
)


def does(name: str, *given: st.SearchStrategy[Any]) -> st.SearchStrategy[tuple[Any, ...]]:
    return st.tuples(st.just(name), *given)


OPEN = does("open", CODE, st.sampled_from([{"key": b"1"}, {"key": b"2", store.OWNER: b"greedy"}]))
VOTE = does("vote", CODE, QUESTION, VOTER, BYTES, st.sampled_from([2, 5000]), st.booleans())
OF_A_CLASS = (
    *(OPEN, VOTE, VOTE, VOTE),
    does("keep", CODE, PARTS),
    does("publish", CODE, PARTS),
    does("end", CODE),
    does("unvote", CODE, QUESTION, VOTER),
    does("present", CODE, REPLICA, NAMES),
    does("name", CODE, REPLICA, NAMES),
)
OF_ALL = (
    does("rooms"),
    does("wait", st.sampled_from([1.0, 2.5])),
    does("count", NAME, st.just(6.0), st.integers(0, 2)),
    does("lend", NAME, KEY, BYTES, st.just(3600.0)),
    does("take", NAME, KEY),
)


async def outcome(work: Awaitable[Any]) -> Any:
    try:
        return await work
    except (FullError, UnreachableError) as refusal:
        return type(refusal), str(refusal)


async def contents(kept: Store, code: str) -> Any:
    """Everything of a class."""
    parts = await kept.parts(code)
    named = await kept.named(code) if parts else set()  # a store may remember those of no class
    return parts, await kept.questions(code), {one: await kept.votes(code, one) for one in "qr"}, named


@pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")
@settings(max_examples=tries(80))
@given(done=st.lists(st.one_of(*OF_A_CLASS, *OF_ALL), min_size=5, max_size=30))
def test_both_stores_do_the_same_and_nothing_to_other_classes(valkey: Valkey, done: list[tuple[Any, ...]]) -> None:
    async def go(patch: pytest.MonkeyPatch) -> None:
        set_limits(patch, 6000, 1000)
        now, heard = 1.7e9, {"memory": list[Any](), "valkey": list[Any]()}
        async with (
            made("memory", "", clock=lambda: now, **LIMITS) as memory,
            made("valkey", emptied(valkey).url, clock=lambda: now, **LIMITS) as shared,
        ):
            both = {"memory": memory, "valkey": shared}
            listening, left = [await listens(kept, heard[kind]) for kind, kept in both.items()], list[Any]()
            for kept in both.values():
                await ended(await listens(kept, left))
            for name, *rest in [("open", "AAAA", {"key": b"3"}), ("vote", "AAAA", "q", "one", b"1"), *done]:
                if name == "wait":
                    now += rest[0] if now < 1.7e9 + 20 else 0.0  # later, who follows is not known any more
                    continue
                others = [code for code in CODES if code not in rest[:1]]
                before = [await contents(memory, code) for code in others]
                first, second = [await outcome(getattr(kept, name)(*rest)) for kept in both.values()]
                assert first == second and before == [await contents(memory, code) for code in others]
            for code in CODES:
                assert await contents(memory, code) == await contents(shared, code)
            for kept in both.values():
                await kept.publish("over", {})
            await until(lambda: all(("over", {}) in one for one in heard.values()))
            assert heard["memory"] == heard["valkey"] and left == [], "former listeners get nothing"
            for task in listening:
                await ended(task)
            for kept in both.values():
                assert abs(await kept.time() - time.time()) < 5

    with pytest.MonkeyPatch.context() as patch:
        asyncio.run(go(patch))


async def listens(kept: Store, heard: list[Any]) -> asyncio.Task[None]:
    ready = asyncio.Event()
    task = asyncio.create_task(kept.listen(lambda code, parts: heard.append((code, dict(parts))), ready.set))
    await asyncio.wait_for(ready.wait(), 30)
    return task


async def ended(task: asyncio.Task[None]) -> None:
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


# Limits of time.


async def test_a_room_lives_as_long_as_it_is_led_and_for_some_time_while_it_is_followed(on: Kept) -> None:
    now = time.time()

    async def wait(kept: Store) -> None:
        nonlocal now
        now += 0.1
        if isinstance(kept, shared_store.SharedStore):
            await asyncio.sleep(0.1)

    async with on(life=2.0, alone=1.0, clock=lambda: now) as kept:
        for code in ("LEDX", "FOLL", "ALON"):
            assert await kept.open(code, {"key": b"1"}) and await kept.vote(code, "q", "one", b"1")
        await kept.lend("name", b"key", b"short", 0.2)
        ended = list[str]()
        for _ in range(26):
            await wait(kept)
            assert await kept.keep("LEDX", {})
            await kept.present("FOLL", "here", {"a phone"})  # followers do not show that the instructor is there
            await kept.present("ALON", "here", ())
            ended += [code for code in ("LEDX", "FOLL", "ALON") if code not in ended and not await kept.parts(code)]
        assert ended == ["ALON", "FOLL"] and await kept.rooms() == 1
        assert await kept.take("name", b"key") == b""
        for code, is_there in {"LEDX": True, "FOLL": False, "ALON": False}.items():
            assert bool(await kept.votes(code, "q")) is await kept.vote(code, "q", "two", b"1") is is_there


async def test_where_all_rooms_are_taken_one_that_is_alone_makes_way(on: Kept) -> None:
    now = time.time()
    async with on(rooms=2, clock=lambda: now) as kept:
        assert await kept.open("AAAA", {"key": b"1"}) and await kept.open("BBBB", {"key": b"1"})
        now += store.QUIET - 1
        await kept.keep("AAAA", {})
        assert not await kept.open("CCCC", {"key": b"1"})
        now += 2
        assert await kept.open("CCCC", {"key": b"1"})
        assert await kept.parts("AAAA") and not await kept.parts("BBBB")
        assert not await kept.open("BBBB", {"key": b"1"})


@pytest.mark.parametrize("seconds", [60.0, 4 * 3600.0])
async def test_whatever_is_counted_counts_for_the_whole_span_and_a_twelfth_more_at_most(
    on: Kept, seconds: float
) -> None:
    """At any time, so that no interval boundary gives anybody a new allowance."""
    chance, now = Random(45), time.time()
    async with on(clock=lambda: now) as kept:
        for name in ("steady", "bursts"):
            happened: list[float] = []
            for _ in range(100):
                now += chance.choice([0.0, 0.001, 0.3, 0.4, 1.0]) * seconds * chance.random()
                more = chance.choice([1, 1, 4]) if name == "steady" or chance.random() < 0.3 else 0
                happened += [now] * more
                times = await kept.count(name, seconds, more)
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
            with pytest.raises(UnreachableError):
                await kept.count("one too many", 60, more)
        assert await kept.count("first", 60) == 4
        now += 10  # the others have expired
        assert await kept.count("one too many", 60) == 1 and await kept.count("first", 60) == 5


# Limits of bytes.


async def fill(kept: Store, code: str) -> int:
    """Fill a class with as many answers as it accepts, and return their bytes."""
    for number in count():
        try:
            assert await kept.vote(code, f"d31/a/{number % 9}", f"{number:019}", b"x" * 1000, 10**6)
        except FullError:
            return 1000 * number
    raise AssertionError


async def test_a_greedy_owner_leaves_the_others_a_share(on: Kept, small: None) -> None:
    """The limit holds for any number of classes; a class keeps the picture it has shown. Ended ones take no bytes."""
    now = time.time()
    async with on(clock=lambda: now) as kept:
        for code, owner in (("AAAA", b"greedy"), ("BBBB", b"greedy"), ("CCCC", b"other"), ("DDDD", b"")):
            await kept.open(code, {"key": b"1", **({store.OWNER: owner} if owner else {})})
        first, second, other, none = [await fill(kept, code) for code in ("AAAA", "BBBB", "CCCC", "DDDD")]
        assert first + second < 50_000 and second == 0  # half of it
        assert 12_000 < other < 25_000 and 5_000 < none < 12_500
        assert await kept.keep("DDDD", {"picture": b"x" * 3000})
        with pytest.raises(FullError, match="memory for live classes is full"):
            await kept.keep("DDDD", {"walks": b"x" * 30_000})
        await kept.end("AAAA")
        assert await fill(kept, "CCCC") > 3000
        now += store.ALONE + 1
        await kept.open("EEEE", {"key": b"1", store.OWNER: b"greedy"})
        assert await fill(kept, "EEEE") == first


async def test_a_room_has_so_many_bytes_of_answers_and_removed_ones_make_place(on: Kept) -> None:
    async with on(size=2 * (store.OF_A_VOTE + store.OF_AN_ANSWER) + 100) as kept:
        await kept.open("AAAA", {"key": b"1"})
        assert await kept.vote("AAAA", "b", "one", b"x" * 60)
        with pytest.raises(FullError, match="cannot store more answers"):
            await kept.vote("AAAA", "a", "two", b"x" * 60)
        assert await kept.vote("AAAA", "b", "one", b"x" * 30)  # in place of the longer one
        assert await kept.vote("AAAA", "a", "two", b"x" * 60)
        assert await kept.questions("AAAA") == ["b", "a"]  # in the order of their first answers
        await kept.unvote("AAAA", "a", "two")
        assert await kept.vote("AAAA", "a", "three", b"x" * 60)


async def test_the_bytes_that_are_counted_are_no_fewer_than_those_of_the_store(valkey: Valkey, small: None) -> None:
    """The smallest answers need more bytes than they contain; many votes have only one answer."""
    async with made("valkey", emptied(valkey).url) as kept:
        for room in range(5):
            code = code_of(f"{room}")
            await kept.open(code, {"key": b"1"})
            with suppress(FullError):
                for number in range(1000):
                    question = "d31/d31-03/1" if room % 2 else f"d31/d31-{number:03}/1"
                    assert await kept.vote(code, question, f"{number:019}", b"x" * 130)
        with redis.Redis.from_url(valkey.url) as client:
            taken = sum(int(client.memory_usage(key) or 0) for key in client.scan_iter())  # type: ignore[arg-type]
    assert store.ALL_BYTES // 3 < taken < store.ALL_BYTES


# A store that has no place, is away, or says nothing.


async def test_a_full_store_says_so_and_forgets_no_class(valkey: Valkey) -> None:
    async with made("valkey", emptied(valkey).url) as kept:
        await kept.open("AAAA", {"key": b"1"})
        await kept.vote("AAAA", "a", "one", b"1")
        with redis.Redis.from_url(valkey.url) as client:
            client.config_set("maxmemory", 1)
            try:
                for act in (kept.keep("AAAA", {"clock": b"1"}), kept.open("BBBB", {"key": b"1"}), kept.count("x", 60)):
                    with pytest.raises(FullError, match="memory for live classes is full"):
                        await act
                assert await kept.count("x", 60, 0) == 0
                assert await kept.parts("AAAA") == {"key": b"1"} and await kept.votes("AAAA", "a") == {"one": b"1"}
            finally:
                client.config_set("maxmemory", 0)


async def test_a_store_that_is_away_or_falls_silent_is_noticed_and_one_that_has_nothing_to_say_is_not(
    valkey: Valkey, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shared_store, "PULSE", 0.05)

    async with made("valkey", "redis://127.0.0.1:1/0") as away:
        for work in (away.parts("K7HM"), away.listen(lambda code, parts: None, lambda: None)):
            with pytest.raises(UnreachableError):
                await work
    async with made("valkey", valkey.url) as kept:
        listening = await listens(kept, [])
        await asyncio.sleep(0.3)
        assert not listening.done()
        with valkey.silent(), pytest.raises(UnreachableError):
            await asyncio.wait_for(listening, 30)

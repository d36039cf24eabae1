"""The contract of every store of classes: one set of tests for memory and for Valkey, and both do the same."""

import asyncio
import time
from collections import defaultdict
from collections.abc import AsyncIterator, Awaitable
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.live_class import shared_store, store
from components.live_class.codes import code_of
from components.live_class.store import FullError, Store, UnreachableError
from tests.grids import tries
from tests.live_class.caller import until
from tests.live_class.served import Valkey, contents, made, set_limits

LIMITS = {"rooms": 3, "size": 2500, "counts": 1}
CODES = ("AAAA", "BBBB", "CCCC", "DDDD")
CODE, QUESTION, VOTER = st.sampled_from(CODES), st.sampled_from("qr"), st.sampled_from(["one", "two", "three"])
BYTES = st.sampled_from([b"", b"1", b"x" * 300, b"x" * 900])
PARTS = st.dictionaries(st.sampled_from(["clock", "picture"]), BYTES, max_size=2)
REPLICA, NAMES = st.sampled_from("ab"), st.sets(st.sampled_from("wxyz"))
NAME, KEY = st.sampled_from("mno"), st.sampled_from([b"k", b"l"])


def does(name: str, *given: st.SearchStrategy[Any]) -> st.SearchStrategy[tuple[Any, ...]]:
    return st.tuples(st.just(name), *given)


GREEDY = {"key": b"2", store.OWNER: b"greedy"}
VOTE = does("vote", CODE, QUESTION, VOTER, BYTES, st.sampled_from([2, 5000]), st.booleans())
OPEN, KEEP = does("open", CODE, st.sampled_from([{"key": b"1"}, GREEDY])), does("keep", CODE, PARTS)
OF_BYTES = (OPEN, *[VOTE] * 5, *[does("unvote", CODE, QUESTION, VOTER)] * 2, KEEP, KEEP, does("end", CODE))
OF_TIME = (
    *(OPEN, OPEN, KEEP, does("publish", CODE, PARTS), does("end", CODE), does("rooms")),
    *[does("wait", st.sampled_from([1.0, 2.5, 3.0, 7.0]))] * 3,
    *[does("count", NAME, st.just(6.0), st.integers(0, 2))] * 3,
    *(does("present", CODE, REPLICA, NAMES), does("name", CODE, REPLICA, NAMES)),
    *(does("lend", NAME, KEY, BYTES, st.just(3600.0)), does("take", NAME, KEY)),
)
DONE = st.one_of(*(st.lists(st.one_of(*deeds), min_size=20, max_size=50) for deeds in (OF_BYTES, OF_TIME)))
BEGUN = (
    *(("open", "AAAA", {"key": b"3"}), ("open", "BBBB", GREEDY), ("open", "CCCC", GREEDY)),
    *(("vote", "BBBB", "q", "one", b"x" * 900), ("vote", "AAAA", "r", "one", b"x" * 900)),
    *(("vote", "AAAA", "q", "one", b"1"), ("wait", 0.45), ("count", "m", 6.0, 1)),
    *(("wait", 5.6), ("count", "m", 6.0, 0)),
)


async def outcome(work: Awaitable[Any]) -> Any:
    try:
        return await work
    except (FullError, UnreachableError) as refusal:
        return type(refusal), str(refusal)


async def everything(kept: Store, code: str) -> Any:
    parts, *votes = await contents(kept, code)
    return parts, votes, await kept.named(code) if parts else set()  # a store may remember those of no class


@settings(max_examples=tries(500))
@given(done=DONE)
def test_both_stores_do_the_same_and_nothing_to_other_classes(running: Valkey, done: list[tuple[Any, ...]]) -> None:
    async def go(patch: pytest.MonkeyPatch) -> None:
        set_limits(patch, 6000, 1000)
        for module in (store, shared_store):
            patch.setattr(module, "QUIET", 3.0)
        now, times = 1.7e9, defaultdict[str, list[float]](list)
        async with (
            made("", clock=lambda: now, **LIMITS) as memory,
            made(running.emptied().url, clock=lambda: now, **LIMITS) as shared,
            AsyncExitStack() as listeners,
        ):
            both, heard, left = (memory, shared), (list[Any](), list[Any]()), list[Any]()
            for kept, news in zip(both, heard, strict=True):
                await listeners.enter_async_context(listening(kept, news))
                async with listening(kept, left):
                    """It gets nothing later."""
            for name, *rest in (*BEGUN, *done):
                now += 0.001  # no two classes are equally quiet
                if name == "wait":
                    now += rest[0] if now < 1.7e9 + 20 else 0.0  # later, who follows is not known any more
                    continue
                before = {code: await everything(memory, code) for code in CODES if code not in rest[:1]}
                first, second = [await outcome(getattr(kept, name)(*rest)) for kept in both]
                if name == "present":  # a shared store notes only now and then that a class is followed
                    assert await memory.keep(rest[0], {}) == await shared.keep(rest[0], {})
                changed = [code for code, one in before.items() if one != await everything(memory, code)]
                assert first == second and len(changed) <= (name == "open")  # one that is alone makes way
                if name == "count" and isinstance(first, int):  # the whole span, and a twelfth more at most
                    times[rest[0]] += [now] * rest[2]
                    least, most = (sum(at > now - span for at in times[rest[0]]) for span in (6.0, 6.51))
                    assert least <= first <= most
            assert [await everything(memory, one) for one in CODES] == [await everything(shared, one) for one in CODES]
            for kept in both:
                await kept.publish("over", {})
                assert abs(await kept.time() - time.time()) < 5
            await until(lambda: all(("over", {}) in one for one in heard))
            assert heard[0] == heard[1] and left == [], "former listeners get nothing"

    with pytest.MonkeyPatch.context() as patch:
        asyncio.run(go(patch))


@asynccontextmanager
async def listening(kept: Store, heard: list[Any]) -> AsyncIterator[asyncio.Task[None]]:
    ready = asyncio.Event()
    task = asyncio.create_task(kept.listen(lambda code, parts: heard.append((code, dict(parts))), ready.set))
    await asyncio.wait_for(ready.wait(), 30)
    yield task
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


ROOMS = ("LEDX", "FOLL", "ALON")


async def test_a_room_lives_as_long_as_it_is_led_and_for_some_time_while_it_is_followed(url: str) -> None:
    now = time.time()
    async with made(url, life=2.0, alone=1.0, clock=lambda: now) as kept:
        for code in ROOMS:
            assert await kept.open(code, {"key": b"1"}) and await kept.vote(code, "q", "one", b"1")
        await kept.lend("name", b"key", b"short", 0.2)
        assert await kept.count("name", 60) == 1
        ended = list[str]()
        for _ in range(26):
            now += 0.1
            if url:
                await asyncio.sleep(0.1)
            assert await kept.keep("LEDX", {})
            await kept.present("FOLL", "here", {"a phone"})  # followers do not show that the instructor is there
            await kept.present("ALON", "here", ())
            ended += [code for code in ROOMS if code not in ended and not await kept.parts(code)]
        assert ended == ["ALON", "FOLL"] and await kept.rooms() == 1
        assert await kept.take("name", b"key") == b"" and await kept.count("name", 60) == 2
        for code in ROOMS:
            assert bool(await kept.votes(code, "q")) is await kept.vote(code, "q", "two", b"1") is (code == "LEDX")


async def test_a_room_has_so_many_bytes_of_answers_and_removed_ones_make_place(url: str) -> None:
    async with made(url, size=2 * (store.OF_A_VOTE + store.OF_AN_ANSWER) + 100) as kept:
        await kept.open("AAAA", {"key": b"1"})
        assert await kept.vote("AAAA", "b", "one", b"x" * 60)
        with pytest.raises(FullError, match="cannot store more answers"):
            await kept.vote("AAAA", "a", "two", b"x" * 60)
        assert await kept.vote("AAAA", "b", "one", b"x" * 30)  # in place of the longer one
        assert await kept.vote("AAAA", "a", "two", b"x" * 60)
        assert await kept.questions("AAAA") == ["b", "a"]  # in the order of their first answers
        await kept.unvote("AAAA", "a", "two")
        assert await kept.vote("AAAA", "a", "three", b"x" * 60)


async def test_no_fewer_bytes_are_counted_than_are_stored(valkey: Valkey, monkeypatch: pytest.MonkeyPatch) -> None:
    """The smallest answers need more bytes than they contain; many votes have only one answer."""
    set_limits(monkeypatch, 100_000, 10_000)
    async with made(valkey.url) as kept:
        for room in range(5):
            code = code_of(f"{room}")
            await kept.open(code, {"key": b"1"})
            with suppress(FullError):
                for number in range(1000):
                    question = "d31/d31-03/1" if room % 2 else f"d31/d31-{number:03}/1"
                    assert await kept.vote(code, question, f"{number:019}", b"x" * 130)
    assert store.ALL_BYTES // 3 < valkey.bytes() < store.ALL_BYTES


async def test_a_full_store_says_so_and_forgets_no_class(valkey: Valkey) -> None:
    async with made(valkey.url) as kept:
        await kept.open("AAAA", {"key": b"1"})
        await kept.vote("AAAA", "a", "one", b"1")
        with valkey.client() as client:
            client.config_set("maxmemory", 1)
            try:
                for act in (kept.keep("AAAA", {"clock": b"1"}), kept.open("BBBB", {"key": b"1"}), kept.count("x", 60)):
                    with pytest.raises(FullError, match="memory for live classes is full"):
                        await act
                assert await kept.count("x", 60, 0) == 0
                assert await kept.parts("AAAA") == {"key": b"1"} and await kept.votes("AAAA", "a") == {"one": b"1"}
            finally:
                client.config_set("maxmemory", 0)


async def test_a_store_that_is_away_or_silent_is_noticed(valkey: Valkey, monkeypatch: pytest.MonkeyPatch) -> None:
    """A store that has nothing to say is not away."""
    monkeypatch.setattr(shared_store, "PULSE", 0.05)
    async with made("redis://127.0.0.1:1/0") as away:
        for work in (away.parts("K7HM"), away.listen(lambda code, parts: None, lambda: None)):
            with pytest.raises(UnreachableError):
                await work
    async with made(valkey.url) as kept, listening(kept, []) as task:
        await asyncio.sleep(0.3)
        assert not task.done()
        with valkey.silent(), pytest.raises(UnreachableError):
            await asyncio.wait_for(task, 30)

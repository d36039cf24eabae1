"""Changes while a class is looked up or its store is unreachable: newer data is never replaced by older."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from time import monotonic, time

import msgspec
import pytest

from components.language.class_messages import PutQuestion, RunClock, SentPicture
from components.language.messages import Given
from components.live_class import publisher
from components.live_class import room as room_of
from components.live_class.publisher import Publisher
from components.live_class.registry import ClosedError, Registry
from components.live_class.room import ClassRoom
from components.live_class.store import FullError, MemoryStore, Parts, UnreachableError
from components.live_class.upkeep import Upkeep
from components.scenes import SCENES
from components.session.session import Session
from components.state.page_state import fitted
from tests.live_class.listening import BANK, CHOICE, Listener, replicas, until
from tests.live_class.stores import Valkey, made

CLOCK = RunClock(t=1.0, rate=0.0, end=20.0, at=0.0)
CLOCK_PART = msgspec.json.encode(CLOCK)


class Wayward(MemoryStore):
    """A store that can become unreachable; `meanwhile` runs between its look-up of a class and its answer."""

    away = False
    meanwhile: Callable[[], Awaitable[object]] | None = None

    async def parts(self, code: str) -> Parts:
        self._check()
        found, meanwhile = await super().parts(code), self.meanwhile
        self.meanwhile = None
        if meanwhile:
            await meanwhile()
        return found

    async def keep(self, code: str, parts: Parts) -> bool:
        self._check()
        return await super().keep(code, parts)

    def _check(self) -> None:
        if self.away:
            raise UnreachableError("away")


@asynccontextmanager
async def rooms() -> AsyncIterator[tuple[Wayward, Registry, Upkeep, str, str]]:
    """A registry that listens to its store, and an open class."""
    store = Wayward()
    registry = Registry(store, BANK)
    listening = asyncio.create_task(store.listen(registry.receive, lambda: None))
    await asyncio.sleep(0)
    yield store, registry, Upkeep(registry), *await registry.open()
    listening.cancel()


async def test_news_during_the_look_up_of_a_class_is_received() -> None:
    async with rooms() as (store, registry, _, code, key):
        store.meanwhile = lambda: MemoryStore.keep(store, code, {"clock": CLOCK_PART})
        room = await registry.room(code)
        assert room.whole().clock == CLOCK and await registry.led(code, key) is room
        del registry.rooms[code]
        store.meanwhile = lambda: store.end(code)
        with pytest.raises(ClosedError):
            await registry.room(code)
        assert not registry.rooms


async def test_a_look_at_the_store_brings_nothing_older_back() -> None:
    async with rooms() as (store, registry, upkeep, code, key):
        room = await registry.led(code, key)
        listener = Listener()
        room.listeners.add(listener)
        await registry.show(room, SentPicture(sheet="s", data=b"1"))
        store.meanwhile = lambda: registry.show(room, SentPicture(sheet="s", data=b"2"))
        await upkeep._restore(room)
        assert [news.picture and news.picture.data for news in listener.news] == [b"1", b"2"]


async def test_what_a_store_that_was_away_has_missed_takes_the_place_of_what_it_knows() -> None:
    async with rooms() as (store, registry, upkeep, code, key):
        room = await registry.led(code, key)
        await registry.obey(room, PutQuestion(walk="d31", step="d31-02"))
        store.away = True
        await registry.obey(room, PutQuestion(walk=CHOICE[0], step=CHOICE[1]))
        assert room.used and room.question.step == CHOICE[1]  # followers who are connected receive it at once
        store.away = False
        await upkeep._restore(room)
        assert room.question.step == CHOICE[1] and not room.unsaved
        assert b'"d31-03"' in (await store.parts(code))["question"]


async def test_a_picture_waits_for_a_store_that_is_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(publisher, "AGAIN", 0.01)

    async with rooms() as (store, registry, _, code, key):
        store.away = True  # this replica does not know the class, because its instructor's stream is at another
        Publisher(registry, code, key)(lambda: {"sheet": "s", "data": b"1"})
        await asyncio.sleep(0.05)
        store.away = False
        await until(lambda: code in registry.rooms and registry.rooms[code].whole().picture)


async def test_who_leads_again_and_leaves_asks_a_store_that_is_away_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(publisher, "AGAIN", 0.001)

    async with rooms() as (store, registry, _, code, key):
        store.away = True
        session, asked = Session(fitted(SCENES["coupled"]().value)), 0
        session.lead = lambda *given: Publisher(registry, *given)
        led = registry.led

        async def counted(*given: str) -> ClassRoom:
            nonlocal asked
            asked += 1
            return await led(*given)

        monkeypatch.setattr(registry, "led", counted)
        before = len(asyncio.all_tasks())
        for number in range(50):
            session.handle({"type": "lead", "code": code, "key": key, "number": number})
            await asyncio.sleep(0)
        assert len(asyncio.all_tasks()) - before <= 2  # the last picture, and the one before it, which is being sent
        await until(lambda: asked > 60)
        session.close()
        await asyncio.sleep(0.01)
        assert len(asyncio.all_tasks()) == before
        store.away = False
        await asyncio.sleep(0.01)
        assert not registry.rooms


async def test_news_that_cannot_be_read_are_no_reason_to_listen_no_more(caplog: pytest.LogCaptureFixture) -> None:
    async with rooms() as (_, registry, upkeep, code, _):
        room = await registry.room(code)
        upkeep._receive(code, {"clock": b'{"type":"another version"}'})
        upkeep._receive(code, {"clock": CLOCK_PART})
        assert room.whole().clock == CLOCK and "could not be read" in caplog.text


async def test_who_has_no_stream_is_counted_as_long_as_it_asks_and_its_replica_goes_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with rooms() as (store, registry, upkeep, code, key):
        room = await registry.led(code, key)
        room.polled(key, leads=True)
        for name, leads in ((key, True), ("a follower's", False)):
            room.polled(name, leads=leads)
        numbers = [room.number]
        for _ in range(2):
            await upkeep._look_at(room)
            numbers.append(room.number)
        # Nothing has changed the second time, so nobody gets the complete state again.
        assert numbers[0] != numbers[1] == numbers[2] and room.whole().here == 1
        assert await store.present(code, "another", {"a phone"}) == 2
        monkeypatch.setattr(room_of, "monotonic", lambda: monotonic() + room_of.ASKED)
        await upkeep._look_at(room)
        assert room.here == 1 and room.names  # whose answers count for some more time
        room.polled("a follower's", leads=False)
        await upkeep._look_at(room)
        assert await store.present(code, "another", {"a phone"}) == 2
        await upkeep._look_at(room)
        assert await registry.room(code) is room
        await upkeep.end()
        assert await store.present(code, "another", {"a phone"}) == 1
        monkeypatch.setattr(room_of, "monotonic", lambda: monotonic() + 2 * room_of.SILENCE)
        registry.leave(room)  # nobody uses it any more
        assert not registry.rooms


async def test_a_store_that_stays_away_is_logged_once(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async with rooms() as (store, _, upkeep, _, _):
        asked = 0

        async def listen(_: object, ready: Callable[[], None]) -> None:
            nonlocal asked
            asked += 1
            if asked < 5:
                raise UnreachableError("away") from OSError("no route to it")
            ready()
            await asyncio.Event().wait()

        monkeypatch.setattr(store, "listen", listen)
        monkeypatch.setattr("components.live_class.upkeep.AGAIN", 0.001)
        upkeep.start()
        await until(lambda: upkeep.listening)
        await upkeep.end()
    assert caplog.text.count("is away") == caplog.text.count("is away: no route to it") == 1
    assert caplog.text.count("is back after") == 1


async def test_clocks_that_differ_and_a_full_store_are_noticed_once(caplog: pytest.LogCaptureFixture) -> None:
    async with rooms() as (store, registry, upkeep, code, key):
        await upkeep._look_at_store()
        assert (upkeep.rooms, caplog.text) == (1, "") and abs(upkeep.skew) < 0.1

        async def behind() -> float:
            return time() - 3.0

        store.time = behind  # type: ignore[method-assign]
        for _ in range(3):
            await upkeep._look_at_store()
        assert upkeep.skew == pytest.approx(3.0, abs=0.1) and caplog.text.count("clock is +3.0 s off") == 1

        async def full(*_: object) -> int:
            raise FullError("The store is full.")

        room = await registry.led(code, key)
        store.present = full  # type: ignore[assignment,method-assign]
        for _ in range(3):
            await upkeep._safely(upkeep._look_at(room))
        assert caplog.text.count("The store is full.") == 1 and "Traceback" not in caplog.text


async def test_a_class_continues_without_the_store_and_is_written_back(valkey: Valkey) -> None:
    one, other = made("valkey", valkey.url), made("valkey", valkey.url)
    async with one as store, other as another, replicas(store, another) as (registry, second):
        code, key = await registry.open()
        room, there = await registry.led(code, key), await second.room(code)
        leader, follower = Listener(leads=True), Listener()
        room.listeners.add(leader)
        there.listeners.add(follower)
        await registry.obey(room, PutQuestion(walk=CHOICE[0], step=CHOICE[1]))
        await until(lambda: there.question.step)
        await second.vote(there, "one", Given(walk=CHOICE[0], step=CHOICE[1], option=1))
        assert await registry.tally(room)
        valkey.kill()
        await until(lambda: any(news.lost for news in follower.news) and room.lost)
        await registry.show(room, SentPicture(sheet="s", data=b"meanwhile"))
        assert leader.news[-1].picture and not any(news.picture for news in follower.news)
        valkey.start()
        await until(lambda: any(news.picture for news in follower.news) and not there.lost)
        tally = await second.tally(there)
        assert tally and tally.now.options == (0, 1, 0)
        assert await second.led(code, key) is there

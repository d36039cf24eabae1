"""Changes while a class is looked up or its store is unreachable: newer data is never replaced by older."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from time import time
from typing import Any

import msgspec
import pytest

from components.language.class_messages import PutQuestion, RunClock, SentPicture
from components.language.messages import Given
from components.live_class import publisher
from components.live_class import upkeep as upkeeps
from components.live_class.publisher import Publisher
from components.live_class.registry import ClosedError, Registry
from components.live_class.room import ClassRoom
from components.live_class.store import FullError, MemoryStore, Parts, Store, UnreachableError
from components.live_class.upkeep import Upkeep
from components.scenes import SCENES
from components.session.session import Session
from components.state.page_state import fitted
from tests.live_class.served import BANK, CHOICE, Listener
from tests.live_class.stores import Valkey, made
from tests.serving.served import until

CLOCK = RunClock(t=1.0, rate=0.0, end=20.0, at=0.0)
CLOCK_PART = msgspec.json.encode(CLOCK)


class Wayward(MemoryStore):
    """A store that can become unreachable; `meanwhile` runs between its look-up of a class and its answer."""

    away, refused = False, 0
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
            self.refused += 1
            raise UnreachableError("away")


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Upkeep that looks at rooms and its store all the time."""
    for name, seconds in (("COUNTING", 0.005), ("SILENCE", 0.01), ("AGAIN", 0.001)):
        monkeypatch.setattr(upkeeps, name, seconds)


@asynccontextmanager
async def kept(store: Store) -> AsyncIterator[tuple[Registry, Upkeep, str, ClassRoom, Listener]]:
    """A registry with its upkeep, and the key of a class that is led."""
    registry = Registry(store, BANK)
    upkeep, listener = Upkeep(registry), Listener(leads=True)
    upkeep.start()
    await until(lambda: upkeep.listening)
    code, key = await registry.open()
    room = await registry.led(code, key)
    room.listeners.add(listener)
    try:
        yield registry, upkeep, key, room, listener
    finally:
        await upkeep.end()


async def test_news_during_the_look_up_of_a_class_is_received() -> None:
    store = Wayward()
    async with kept(store) as (registry, _, key, room, _):
        code = registry.rooms.pop(room.code).code
        store.meanwhile = lambda: MemoryStore.keep(store, code, {"clock": CLOCK_PART})
        room = await registry.room(code)
        assert room.whole().clock == CLOCK and await registry.led(code, key) is room
        del registry.rooms[code]
        store.meanwhile = lambda: store.end(code)
        with pytest.raises(ClosedError):
            await registry.room(code)
        assert not registry.rooms


async def test_a_look_at_the_store_brings_nothing_older_back_and_the_store_gets_what_it_has_missed(quick: None) -> None:
    store, first, second = Wayward(), SentPicture(sheet="s", data=b"1"), SentPicture(sheet="s", data=b"2")
    async with kept(store) as (registry, _, _, room, listener):
        await registry.show(room, first)
        store.meanwhile = lambda: registry.show(room, second)
        await until(lambda: store.meanwhile is None and room.whole().picture == second)
        assert [news.picture for news in listener.news if news.picture] == [first, second]
        await registry.obey(room, PutQuestion(walk="d31", step="d31-02"))
        store.away = True
        await registry.obey(room, PutQuestion(**CHOICE))
        assert room.used and room.question.step == CHOICE["step"]  # followers who are connected receive it at once
        store.away = False
        await until(lambda: not room.unsaved)
        assert room.question.step == CHOICE["step"] and b'"d31-03"' in (await store.parts(room.code))["question"]


async def test_who_leads_again_and_leaves_asks_a_store_that_is_away_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(publisher, "AGAIN", 0.001)
    store = Wayward()
    async with kept(store) as (registry, _, key, room, _):
        code, session = registry.rooms.pop(room.code).code, Session(fitted(SCENES["coupled"]().value))
        session.lead = lambda *given: Publisher(registry, *given)
        store.away, before = True, len(asyncio.all_tasks())
        for number in range(50):
            session.handle({"type": "lead", "code": code, "key": key, "number": number})
            await asyncio.sleep(0)
        assert len(asyncio.all_tasks()) - before <= 2  # the last picture, and the one before it, which is being sent
        await until(lambda: store.refused > 60)
        session.close()
        await asyncio.sleep(0.01)
        assert len(asyncio.all_tasks()) == before
        store.away = False
        await asyncio.sleep(0.01)
        assert not registry.rooms


async def test_a_store_that_cannot_be_used_as_it_should_is_logged_once(
    quick: None, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """It has news of another version, stays away, has another time, or is full."""
    asked, listen, refused = 0, Wayward.listen, list[object]()

    async def listened(own: Wayward, receive: Any, ready: Callable[[], None]) -> None:
        nonlocal asked
        asked += 1
        if asked < 5:
            raise UnreachableError("away") from OSError("no route to it")
        await listen(own, receive, ready)

    async def behind(_: Wayward) -> float:
        return time() - 3.0

    async def full(*given: object) -> int:
        refused.append(given)
        raise FullError("The store is full.")

    monkeypatch.setattr(Wayward, "listen", listened)
    async with kept(store := Wayward()) as (_, upkeep, _, room, _):
        await store.publish(room.code, {"clock": b'{"type":"another version"}'})
        await store.publish(room.code, {"clock": CLOCK_PART})
        await until(lambda: upkeep.rooms == 1)
        assert room.whole().clock == CLOCK and abs(upkeep.skew) < 0.1
        monkeypatch.setattr(Wayward, "time", behind)
        monkeypatch.setattr(Wayward, "present", full)
        await until(lambda: upkeep.skew > 2.9 and len(refused) > 9)
    assert upkeep.skew == pytest.approx(3.0, abs=0.1)
    for said in ("could not be read", "is away: no route to it", "is back after", "clock is +3.0 s off", "is full."):
        assert caplog.text.count(said) == 1, said


async def test_a_class_continues_without_the_store_and_is_written_back(valkey: Valkey) -> None:
    async with (
        made("valkey", valkey.url) as one,
        made("valkey", valkey.url) as other,
        kept(one) as (registry, _, key, room, leader),
        kept(other) as (second, *_),
    ):
        there, follower = await second.room(room.code), Listener()
        there.listeners.add(follower)
        await registry.obey(room, PutQuestion(**CHOICE))
        await until(lambda: there.question.step)
        await second.vote(there, "one", Given(**CHOICE, option=1))
        assert await registry.tally(room)
        valkey.kill()
        await until(lambda: any(news.lost for news in follower.news) and room.lost)
        await registry.show(room, SentPicture(sheet="s", data=b"meanwhile"))
        assert leader.news[-1].picture and not any(news.picture for news in follower.news)
        valkey.start()
        await until(lambda: any(news.picture for news in follower.news) and not there.lost)
        tally = await second.tally(there)
        assert tally and tally.now.options == (0, 1, 0)
        assert await second.led(room.code, key) is there

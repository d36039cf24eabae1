"""The rooms of a replica: changes while a class is looked up or its store is unreachable, where newer data is never
replaced by older; work that is done once or in slices; limits of walks, words and waiting phones.
"""

import asyncio
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from operator import itemgetter
from time import time
from typing import Any
from unittest.mock import AsyncMock, Mock

import msgspec
import pytest

from components.language.class_messages import HandWalk, Moderate, PutQuestion, RunClock, SentPicture
from components.language.messages import Given
from components.live_class import moderation, question_bank, remotes
from components.live_class import registry as registry_of
from components.live_class import upkeep as upkeeps
from components.live_class.moderation import Moderation
from components.live_class.registry import ClosedError, Registry
from components.live_class.remotes import begun, decided, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from components.live_class.slices import Turns
from components.live_class.store import FullError, MemoryStore, Parts, Store, UnreachableError
from components.live_class.upkeep import Upkeep
from components.live_class.votes_csv import cell, votes_csv
from components.walks.loading import read_walk
from components.walks.questions.question import Written
from components.walks.questions.sketch import SketchStep
from tests.grids import WHOLE, sample
from tests.live_class.caller import CHOICE, NUMBER, OWN, SKETCH, drawn, until
from tests.live_class.served import ANSWERS, BANK, READ, Listener, Valkey, fill, made, taught

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
        await store.keep(code, {"clock": msgspec.json.encode(RunClock(t=9.0, rate=0.0, end=20.0, at=0.0))})
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


async def test_a_store_that_cannot_be_used_as_it_should_is_logged_once(
    quick: None, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """It stays away, has news of another version, has another time, or is full."""
    store = Wayward()
    listen, away, full = store.listen, iter(range(5)), AsyncMock(side_effect=FullError("The store is full."))

    async def listened(receive: Any, ready: Callable[[], None]) -> None:
        if next(away, None) is not None:
            raise UnreachableError("away") from OSError("no route to it")
        await listen(receive, ready)

    monkeypatch.setattr(store, "listen", listened)
    async with kept(store) as (_, upkeep, _, room, _):
        await store.publish(room.code, {"clock": b'{"type":"another version"}'})
        await store.publish(room.code, {"clock": CLOCK_PART})
        await until(lambda: upkeep.rooms == 1)
        assert room.whole().clock == CLOCK and abs(upkeep.skew) < 0.1
        monkeypatch.setattr(store, "time", AsyncMock(side_effect=lambda: time() - 3.0))
        monkeypatch.setattr(store, "present", full)
        await until(lambda: upkeep.skew > 2.9 and full.call_count > 9)
    for said in ("could not be read", "is away: no route to it", "is back after", "clock is +3.0 s off", "is full."):
        assert caplog.text.count(said) == 1, said


async def test_a_class_continues_without_the_store_and_is_written_back(valkey: Valkey) -> None:
    async with (
        made(valkey.url) as one,
        made(valkey.url) as other,
        kept(one) as (registry, _, key, room, leader),
        kept(other) as (second, *_),
    ):
        there, follower = await second.room(room.code), Listener()
        there.listeners.add(follower)
        await registry.obey(room, PutQuestion(**CHOICE))
        await until(lambda: there.question.step)
        await second.vote(there, "one", Given(**CHOICE, option=1))
        assert await registry.tally(room)
        valkey.close()
        await until(lambda: any(news.lost for news in follower.news) and room.lost)
        await registry.show(room, SentPicture(sheet="s", data=b"meanwhile"))
        assert leader.news[-1].picture and not any(news.picture for news in follower.news)
        valkey.start()
        await until(lambda: any(news.picture for news in follower.news) and not there.lost)
        tally = await second.tally(there)
        assert tally and tally.now.options == (0, 1, 0)
        assert await second.led(room.code, key) is there


def test_no_spreadsheet_works_a_cell_out() -> None:
    for text in ("@SUM(A1)", "+1", "-2+3", "\t=1", "\r=1", "＝1"):
        assert cell(text) == f"'{text}"
    assert cell("-1e-300") == "-1e-300"


def test_phones_that_wait_are_asked_for_for_a_minute_by_different_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    room, leader, follower = ClassRoom("K7HM", {}), Listener(leads=True), Listener()
    room.listeners |= {leader, follower}
    for digits, key in (("47", "one"), ("12", "two")):
        room.deliver(begun(digits, key))
    room.deliver(decided(room.parts, "12", is_in=True))
    assert is_in(room.parts, "two") and not is_in(room.parts, "one") and waits(room.parts, "one")
    number = room.number
    monkeypatch.setattr(remotes, "time", lambda: 4e9)
    room.look()
    assert [news.remotes for news in leader.news] == [("47",), ("12", "47"), ("47",), ()] and not follower.news
    assert room.number != number  # a page that only polls gets it too
    for digits in ("12", "47", "99"):
        with pytest.raises(ValueError, match="No remote control with"):
            decided(room.parts, digits, is_in=True)
    taken = {f"{n}" for n in range(10, 100)}
    assert new_digits(taken - {"47"}) == "47"
    with pytest.raises(ValueError, match="Too many remote controls"):
        new_digits(taken)


async def test_a_walk_is_read_once_and_limits_of_walks_and_words_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """If only the store has the walks, each is read once there. Answers to an earlier form of a walk do not count."""
    monkeypatch.setattr(moderation, "MOST", 2)
    registry = Registry(MemoryStore(), BANK)
    room = await registry.led(*await registry.open())
    text, read = OWN["mine"], list[str]()
    monkeypatch.setattr(question_bank, "read_walk", lambda *given: (read.append(given[1]), read_walk(*given))[1])
    for n in range(registry_of.MOST_OWN):
        await registry.obey(room, HandWalk(name=f"mine-{n}", text=text))
    with pytest.raises(ValueError, match="one too many"):
        await registry.obey(room, HandWalk(name="too-many", text=text))
    assert read == [] and room.walks == registry.bank.read_own(room.own, {})
    read.clear()
    elsewhere = ClassRoom(room.code, dict(room.parts))
    for _ in range(2):
        assert registry.bank_of(elsewhere).step("mine-0", "one")
    assert sorted(read) == sorted(name for name, _ in room.walks)
    await registry.obey(room, PutQuestion(walk="mine-0", step="one"))
    await registry.vote(room, "one", Given(walk="mine-0", step="one", option=0))
    await registry.obey(room, HandWalk(name="mine-0", text=text.replace("d31-03", "d31-02")))  # now a number
    tally = await registry.tally(room)
    assert tally and tally.now.answered == 0 and len(await votes_csv(registry, room)) == 2
    now = Moderation()
    for word in ("a", "b", "a"):
        now = now.after(Moderate(text=word, shows=True), "one")
    with pytest.raises(ValueError, match="At most 2 answers"):
        now.after(Moderate(text="c", shows=True), "one")
    assert now.after(Moderate(text="c", shows=True), "two").shown == ("c",)


MOST_WORK = 20_000
"""Function calls in one turn of the event loop: a few milliseconds."""


@pytest.mark.parametrize(
    "asked",
    sample([{**SKETCH, **drawn(500)}, {**NUMBER, "text": "7"}, {**CHOICE, "option": 1}]),
    ids=itemgetter("step"),
)
async def test_many_answers_do_not_hold_the_event_loop(asked: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    store, calls, write = MemoryStore(size=2**30), [0], Mock(return_value=Written("drawn"))
    monkeypatch.setattr(SketchStep, "written", write)

    async def turn() -> None:
        while True:
            calls.append(0)
            await asyncio.sleep(0)

    def count(frame: object, event: str, of: object) -> None:
        calls[-1] += event in ("call", "c_call")

    async with taught(store) as (_, _, lesson):
        await fill(lesson, store, asked, votes=3 if WHOLE else 1)
        turning = asyncio.create_task(turn())
        for path in READ:
            calls[:] = [0]
            sys.setprofile(count)
            try:
                replied = await lesson.ask(path.format(**asked))
            finally:
                sys.setprofile(None)
            assert (replied.status == 200 and str(ANSWERS) in replied.text) or len(replied.text) > 100 * ANSWERS
            assert max(calls) < MOST_WORK
            assert path == "answers.csv" or not write.called  # sketches are not encoded if nobody reads them
            write.reset_mock()
        turning.cancel()


async def test_one_costly_request_of_a_network_is_answered_at_a_time() -> None:
    turns, begun = Turns(), list[str]()

    async def ask(network: str) -> None:
        async with turns.of(network):
            begun.append(network)
            await asyncio.sleep(0.01)

    asked = [asyncio.create_task(ask(network)) for network in ("a", "a", "a", "b")]
    await asyncio.sleep(0.001)
    assert begun == ["a", "b"]
    await asyncio.gather(*asked)
    assert begun == ["a", "b", "a", "a"]

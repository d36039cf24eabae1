"""Work that a class does once or in slices between which others run; limits of walks, words and waiting phones."""

from __future__ import annotations

import asyncio
import sys
from typing import Any

import pytest

from components.language.class_messages import HandWalk, Moderate, PutQuestion
from components.language.messages import Given
from components.live_class import moderation, question_bank, remotes
from components.live_class import registry as registry_of
from components.live_class.moderation import Moderation
from components.live_class.registry import Registry
from components.live_class.remotes import begun, decided, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from components.live_class.slices import Turns
from components.live_class.store import MemoryStore
from components.live_class.votes_csv import cell, votes_csv
from components.walks.loading import read_walk
from components.walks.questions.question import Judged, Written
from components.walks.questions.sketch import SketchStep
from tests.grids import WHOLE, sample
from tests.live_class.caller import called
from tests.live_class.messages import NUMBER, SKETCH
from tests.live_class.questions import OWN
from tests.live_class.served import ANSWERS, BANK, CHOICE, READ, Listener, fill, taught


async def opened() -> tuple[Registry, ClassRoom]:
    registry = Registry(MemoryStore(), BANK)
    return registry, await registry.led(*await registry.open())


@pytest.mark.parametrize("text", ["@SUM(A1)", "+1", "-2+3", "\t=1", "\r=1", "＝1"])
def test_no_spreadsheet_works_a_cell_out(text: str) -> None:
    assert cell(text) == f"'{text}" and cell("-1e-300") == "-1e-300"


def told(listener: Listener) -> list[tuple[str, ...]]:
    return [news.remotes for news in listener.news if news.remotes is not None]


def test_phones_that_wait_are_asked_for_for_a_minute_by_different_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    room, leader, follower = ClassRoom("K7HM", {}), Listener(leads=True), Listener()
    room.listeners |= {leader, follower}
    room.deliver(begun("47", "one"))
    room.deliver(begun("12", "two"))
    assert told(leader) == [("47",), ("12", "47")] and not told(follower)
    assert room.whole(leads=True).remotes == ("12", "47") and room.whole().remotes is None
    room.deliver(decided(room.parts, "12", is_in=True))
    assert is_in(room.parts, "two") and not is_in(room.parts, "one") and waits(room.parts, "one")
    number = room.number
    monkeypatch.setattr(remotes, "time", lambda: 4e9)
    room.look()
    assert told(leader)[2:] == [("47",), ()] and room.number != number  # a page that only polls gets it too
    for digits in ("12", "47", "99"):
        with pytest.raises(ValueError, match="No remote control with"):
            decided(room.parts, digits, is_in=True)
    all_but_one = {f"{n}" for n in range(10, 100)} - {"47"}
    assert new_digits(all_but_one) == "47"
    with pytest.raises(ValueError, match="Too many remote controls"):
        new_digits(all_but_one | {"47"})


async def test_a_walk_is_read_once_and_limits_of_walks_and_words_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """If only the store has the walks, each is read once there. Answers to an earlier form of a walk do not count."""
    monkeypatch.setattr(moderation, "MOST", 2)
    registry, room = await opened()
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


class Work:
    """Measures the most function calls of this thread in one turn of its event loop."""

    def __init__(self) -> None:
        self.most = self._calls = 0

    def _count(self, frame: object, event: str, of: object) -> None:
        self._calls += event in ("call", "c_call")

    async def _look(self) -> None:
        while True:
            self._calls = 0
            await asyncio.sleep(0)
            self.most = max(self.most, self._calls)

    async def __aenter__(self) -> Work:
        self._looking = asyncio.create_task(self._look())
        sys.setprofile(self._count)
        return self

    async def __aexit__(self, *error: object) -> None:
        sys.setprofile(None)
        self._looking.cancel()
        await asyncio.gather(self._looking, return_exceptions=True)


@pytest.mark.parametrize(
    "asked", sample([SKETCH, {**NUMBER, "text": "7"}, {**CHOICE, "option": 1}]), ids=lambda one: one["step"]
)
async def test_no_number_of_answers_holds_the_event_loop(
    asked: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    written = list[Judged]()

    def write(step: SketchStep, given: Judged, subject: object) -> Written:
        written.append(given)
        return Written("drawn")

    monkeypatch.setattr(SketchStep, "written", write)
    kept = MemoryStore(size=2**30)
    async with taught(kept) as (_, url, lesson):
        await fill(lesson, kept, asked, votes=3 if WHOLE else 1)
        for path in READ:
            async with Work() as work:
                replied = await called(url, f"/class/{lesson.code}/{path.format(**asked)}", word=lesson.key)
            assert (replied.status == 200 and str(ANSWERS) in replied.text) or len(replied.text) > 100 * ANSWERS
            assert work.most < MOST_WORK
            assert path == "answers.csv" or not written  # sketches are not encoded if nobody reads them
            written.clear()


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

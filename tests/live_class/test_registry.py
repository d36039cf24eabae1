"""Work that a class does once or in slices between which others run; limits of walks, words and waiting phones."""

from __future__ import annotations

import asyncio

import msgspec
import pytest

from components.language.class_messages import HandWalk, Moderate, PutQuestion
from components.language.messages import Given
from components.live_class import moderation, question_bank, remotes, slices
from components.live_class import registry as registry_of
from components.live_class import room as room_of
from components.live_class.moderation import Moderation
from components.live_class.registry import Registry
from components.live_class.remotes import begun, decided, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from components.live_class.store import MemoryStore
from components.live_class.votes_csv import cell, votes_csv
from components.walks.loading import read_walk
from components.walks.questions import sketch
from components.walks.questions.sketch import SketchStep
from tests.live_class.listening import BANK, Listener
from tests.live_class.questions import OWN

SKETCH = ("d34", "d34-14")


async def opened() -> tuple[Registry, ClassRoom]:
    registry = Registry(MemoryStore(), BANK)
    return registry, await registry.led(*await registry.open())


async def test_an_answer_is_judged_once_and_a_vote_reads_its_question_once(monkeypatch: pytest.MonkeyPatch) -> None:
    registry, room = await opened()
    read, judged = list[type](), list[object]()
    decode, judge = msgspec.json.decode, SketchStep.judge
    walk, step = SKETCH
    await registry.obey(room, PutQuestion(walk=walk, step=step))
    monkeypatch.setattr(
        room_of.msgspec.json,
        "decode",
        lambda part, **how: (read.append(how.get("type", object)), decode(part, **how))[1],
    )
    monkeypatch.setattr(SketchStep, "judge", lambda *given: (judged.append(given), judge(*given))[1])
    for voter in map(str, range(20)):
        await registry.vote(room, voter, Given(walk=walk, step=step, curves={"Xp1": [int(voter)] * 101}))
    assert read.count(type(room.question)) <= 1
    for _ in range(3):
        tally = await registry.tally(room)
    assert tally and tally.now.answered == 20 and len(judged) == 20
    assert len(await votes_csv(registry, room)) == 21 and len(judged) == 20


async def test_all_sketches_of_a_large_class_are_counted_in_slices_and_some_are_sent(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sketch, "MOST_SKETCHES", 3)
    monkeypatch.setattr(slices, "SLICE", 0.0)
    registry, room = await opened()
    walk, step = SKETCH
    await registry.obey(room, PutQuestion(walk=walk, step=step))
    for voter in "abcde":
        await registry.vote(room, voter, Given(walk=walk, step=step, curves={"Xp1": [500] * 101}))
    turns = 0

    async def others() -> None:
        nonlocal turns
        while True:
            turns += 1
            await asyncio.sleep(0)

    beside = asyncio.create_task(others())
    await asyncio.sleep(0)
    before = turns
    judged = await registry.given(room, f"{walk}/{step}/1")
    assert turns - before >= len(judged) == 5  # other tasks run between the answers
    beside.cancel()
    tally = await registry.tally(room)
    assert tally and (tally.now.answered, len(tally.now.sketches)) == (5, 3)


async def test_a_walk_from_a_file_is_read_once_and_answers_to_its_earlier_form_do_not_count(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """If only the store has the walks, each is read once there."""
    registry, room = await opened()
    text, read = OWN["mine"], list[str]()
    monkeypatch.setattr(question_bank, "read_walk", lambda *given: (read.append(given[1]), read_walk(*given))[1])
    for n in range(registry_of.MOST_OWN):
        for _ in range(2):  # a reloaded page sends it again
            await registry.obey(room, HandWalk(name=f"mine-{n}", text=text))
        await registry.obey(room, PutQuestion(walk=f"mine-{n}", step="one"))
    assert room.question.place == "D31, slide 1 · 1 of 1"
    with pytest.raises(ValueError, match="one too many"):
        await registry.obey(room, HandWalk(name="too-many", text=text))
    assert read == [] and room.walks == registry.bank.read_own(room.own, {})
    read.clear()
    elsewhere = ClassRoom(room.code, dict(room.parts))
    for _ in range(2):
        assert registry.bank_of(elsewhere).step("mine-0", "one")
    assert sorted(read) == sorted(name for name, _ in room.walks)
    elsewhere.parts["walks"] = b'{"mine-0":' + msgspec.json.encode(text + "# mended") + b"}"
    registry.bank_of(elsewhere)
    assert read[-1] == "mine-0" and len(read) == registry_of.MOST_OWN + 1 and len(elsewhere.walks) == 1
    name = room.question.walk
    await registry.vote(room, "one", Given(walk=name, step="one", option=0))
    await registry.obey(room, HandWalk(name=name, text=text.replace("d31-03", "d31-02")))  # now a number
    tally = await registry.tally(room)
    assert tally and tally.now.answered == 0 and len(await votes_csv(registry, room)) == 2


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("=1+1", "'=1+1"), ("@SUM(A1)", "'@SUM(A1)"), ("+1", "'+1"), ("-2+3", "'-2+3"), ("\t=1", "'\t=1"),
        ("\r=1", "'\r=1"), ("＝1", "'＝1"), ("-1.5", "-1.5"), ("-1e-300", "-1e-300"), ("2", "2"), ("Xp1: 5", "Xp1: 5"),
    ],
)  # fmt: skip
def test_no_spreadsheet_works_a_cell_out(text: str, safe: str) -> None:
    assert cell(text) == safe


def test_so_many_are_moderated_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(moderation, "MOST", 2)
    now = Moderation()
    for text in ("a", "b", "a"):
        now = now.after(Moderate(text=text, shows=True), "one")
    with pytest.raises(ValueError, match="At most 2 answers"):
        now.after(Moderate(text="c", shows=True), "one")
    assert now.after(Moderate(text="c", shows=True), "two").shown == ("c",)


def told(listener: Listener) -> list[tuple[str, ...]]:
    return [news.remotes for news in listener.news if news.remotes is not None]


def test_two_phones_that_wait_at_once_are_both_asked_for() -> None:
    room, leader, follower = ClassRoom("K7HM", {}), Listener(leads=True), Listener()
    room.listeners |= {leader, follower}
    room.deliver(begun("47", "one"))
    room.deliver(begun("12", "two"))
    assert told(leader) == [("47",), ("12", "47")] and not told(follower)
    assert room.whole(leads=True).remotes == ("12", "47") and room.whole().remotes is None
    room.deliver(decided(room.parts, "12", is_in=True))
    assert is_in(room.parts, "two") and not is_in(room.parts, "one") and waits(room.parts, "one")
    room.deliver(decided(room.parts, "47", is_in=False))
    assert not is_in(room.parts, "one") and not waits(room.parts, "one") and is_in(room.parts, "two")
    assert told(leader)[2:] == [("47",), ()]
    for digits in ("12", "47", "99"):
        with pytest.raises(ValueError, match="No remote control with"):
            decided(room.parts, digits, is_in=True)


def test_who_waits_longer_than_a_minute_is_asked_for_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    room, leader = ClassRoom("K7HM", {}), Listener(leads=True)
    room.listeners.add(leader)
    room.deliver(begun("47", "one"))
    number = room.number
    room.look()
    assert len(leader.news) == 1
    monkeypatch.setattr(remotes, "time", lambda: 4e9)
    room.look()
    assert told(leader) == [("47",), ()] and room.number != number  # a page that only polls gets it too
    with pytest.raises(ValueError, match="No remote control with"):
        decided(room.parts, "47", is_in=True)


def test_no_two_phones_show_the_same_digits() -> None:
    all_but_one = {f"{n}" for n in range(10, 100)} - {"47"}
    assert new_digits(all_but_one) == "47"
    with pytest.raises(ValueError, match="Too many remote controls"):
        new_digits(all_but_one | {"47"})

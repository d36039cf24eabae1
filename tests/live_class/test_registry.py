"""Work that a class does once or in slices between which others run; limits of walks, words and waiting phones."""

from __future__ import annotations

import pytest

from components.language.class_messages import HandWalk, Moderate, PutQuestion
from components.language.messages import Given
from components.live_class import moderation, question_bank, remotes
from components.live_class import registry as registry_of
from components.live_class.moderation import Moderation
from components.live_class.registry import Registry
from components.live_class.remotes import begun, decided, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from components.live_class.store import MemoryStore
from components.live_class.votes_csv import cell, votes_csv
from components.walks.loading import read_walk
from tests.live_class.listening import BANK, Listener
from tests.live_class.questions import OWN


async def opened() -> tuple[Registry, ClassRoom]:
    registry = Registry(MemoryStore(), BANK)
    return registry, await registry.led(*await registry.open())


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("=1+1", "'=1+1"), ("@SUM(A1)", "'@SUM(A1)"), ("+1", "'+1"), ("-2+3", "'-2+3"), ("\t=1", "'\t=1"),
        ("\r=1", "'\r=1"), ("＝1", "'＝1"), ("-1.5", "-1.5"), ("-1e-300", "-1e-300"), ("2", "2"), ("Xp1: 5", "Xp1: 5"),
    ],
)  # fmt: skip
def test_no_spreadsheet_works_a_cell_out(text: str, safe: str) -> None:
    assert cell(text) == safe


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
    room.look()
    assert told(leader)[2:] == [("47",)] and room.number == number
    monkeypatch.setattr(remotes, "time", lambda: 4e9)
    room.look()
    assert told(leader)[3:] == [()] and room.number != number  # a page that only polls gets it too
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

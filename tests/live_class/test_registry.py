"""A class without a browser: questions, news, answers, and an unreachable store."""

from __future__ import annotations

import asyncio
import csv
import io
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from time import time

import msgspec
import pytest

from components.language.class_messages import (
    EndRoom,
    HandWalk,
    PutQuestion,
    PutTo,
    RunClock,
    SentPicture,
    ShowAnswer,
    Tally,
    Withdraw,
)
from components.language.messages import Given
from components.live_class import question_bank, slices
from components.live_class import registry as registry_of
from components.live_class import room as room_of
from components.live_class.codes import SIGNS, Keys, as_code, code_of, digest, new_key, new_token, voter_of
from components.live_class.registry import ClosedError, Registry
from components.live_class.room import ClassRoom
from components.live_class.votes_csv import cell, votes_csv
from components.walks.loading import read_walk
from components.walks.questions import sketch
from components.walks.questions.sketch import SketchStep
from tests.live_class.listening import CHOICE, Listener, replicas, until
from tests.live_class.stores import KINDS, made, valkey_running

NUMBER, POINT, SKETCH = ("d31", "d31-02"), ("d34", "d34-08"), ("d34", "d34-14")
Opened = Callable[[], AbstractAsyncContextManager[tuple[Registry, ClassRoom]]]


@pytest.fixture(params=KINDS)
def in_class(request: pytest.FixtureRequest) -> Opened:
    """An open class on each kind of store."""
    kind = request.param
    url = request.getfixturevalue("valkey").url if kind == "valkey" else ""

    @asynccontextmanager
    async def opened() -> AsyncIterator[tuple[Registry, ClassRoom]]:
        async with made(kind, url) as store, replicas(store) as (registry,):
            yield registry, await registry.led(*await registry.open())

    return opened


def test_codes_have_no_signs_that_look_alike_and_are_read_as_they_are_typed() -> None:
    assert not set("0OQ1IL") & set(SIGNS) and len(SIGNS) == 30
    assert all(as_code(code) == code for code in (code_of(new_key()) for _ in range(20)))
    assert as_code(" k7h-m ") == "K7HM"
    assert [as_code(text) for text in ("K7H", "K7HMM", "K7H0", "<b>x", "ÄÖÜß")] == [""] * 5


def test_a_token_is_good_for_one_room_and_cannot_be_made_up() -> None:
    room, other = digest(new_key()), digest(new_key())
    token = new_token(room)
    assert voter_of(token, room) and voter_of(token, other) == voter_of(token, b"") == ""
    assert [voter_of(text, room) for text in ("", ".", "a.b", "ä.b")] == [""] * 4


def test_who_does_not_know_the_passphrase_makes_no_key() -> None:
    assert all(Keys(phrase).is_own(Keys(phrase).new()) for phrase in ("", "swinging springs"))
    for key in (Keys().new(), Keys("another phrase").new(), "", "x" * 48, "ä" * 48):
        assert not Keys("swinging springs").is_own(key)


async def test_followers_get_news_and_late_ones_everything(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        follower = Listener()
        room.listeners.add(follower)
        await registry.show(room, SentPicture(sheet="s", data=b"\x01\x02"))
        await registry.obey(room, RunClock(t=2.0, rate=1.0, end=20.0, at=0.0))
        await registry.obey(room, PutQuestion(walk=CHOICE[0], step=CHOICE[1]))
        await until(lambda: any(news.question for news in follower.news))
        assert follower.news[0].picture == SentPicture(sheet="s", data=b"\x01\x02")
        told = room.whole()
        assert told.picture and told.clock and told.question and told.question.place == "D31, slide 1 · 3 of 16"
        assert 1000 * time() - 6000 < told.clock.at < 1000 * time()  # no clock has run since 1970
        await registry.obey(room, Withdraw())
        await registry.obey(room, EndRoom())
        await until(lambda: follower.ended)
        assert follower.news[-1].ended
        with pytest.raises(ClosedError):
            await registry.obey(room, Withdraw())


async def test_only_the_instructor_gets_answers(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        follower, leader = Listener(), Listener(leads=True)
        room.listeners |= {follower, leader}
        await registry.obey(room, PutQuestion(walk=CHOICE[0], step=CHOICE[1]))
        await registry.vote(room, "one", Given(walk=CHOICE[0], step=CHOICE[1], option=1))
        await until(lambda: any(news.answers for news in leader.news))
        assert not any(news.answers for news in follower.news)
        assert room.followers == 1 and room.is_led


async def test_asked_again_the_first_vote_is_kept(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        walk, step = CHOICE
        assert await registry.tally(room) is None
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        for voter, option in (("one", 0), ("two", 0), ("three", 1), ("one", 1)):
            await registry.vote(room, voter, Given(walk=walk, step=step, option=option))
        await registry.obey(room, PutQuestion(walk=walk, step=step))  # a reloaded page asks the same vote
        tally = await registry.tally(room)
        assert tally and tally.now.options == (1, 2, 0) and tally.before is None and tally.now.answered == 3
        await registry.obey(room, PutQuestion(walk=walk, step=step, vote=2))
        with pytest.raises(ValueError, match="closed"):
            await registry.vote(room, "one", Given(walk=walk, step=step, option=0))
        await registry.vote(room, "one", Given(walk=walk, step=step, option=2, vote=2))
        tally = await registry.tally(room)
        assert tally and tally.before and (tally.before.options, tally.now.options) == ((1, 2, 0), (0, 0, 1))
        await registry.obey(room, ShowAnswer())
        with pytest.raises(ValueError, match="closed"):
            await registry.vote(room, "two", Given(walk=walk, step=step, option=0, vote=2))
        assert room.question.lesson and room.question.lesson.right is None
        assert [verdict.right for verdict in room.question.lesson.verdicts] == [True, False, False]
        rows = list(csv.DictReader(io.StringIO("".join(await votes_csv(registry, room)))))
        assert [(row["vote"], row["right"]) for row in rows if row["right"] == "yes"] == [("1", "yes")]
        phones = {row["phone"]: row["answer"] for row in rows if row["vote"] == "1"}
        (again,) = (row for row in rows if row["vote"] == "2")
        assert sorted(phones) == ["1", "2", "3"] and len(set(phones.values())) == 2
        assert phones[again["phone"]] != again["answer"]  # one phone, under one number


async def test_a_vote_whose_answer_was_shown_takes_no_more_answers(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        walk, step = CHOICE
        late = Given(walk=walk, step=step, option=0)
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        await registry.vote(room, "one", late)
        await registry.obey(room, ShowAnswer())
        assert not room.question.answered
        for _ in range(2):  # withdrawn, and asked again by a reloaded page
            await registry.obey(room, PutQuestion(walk=walk, step=step, vote=1))
            assert room.question.answered and room.question.closed and room.question.lesson is None
            with pytest.raises(ValueError, match="closed"):
                await registry.vote(room, "two", late)
        await registry.obey(room, ShowAnswer())
        assert room.question.lesson and not room.question.answered
        await registry.obey(room, PutQuestion(walk=NUMBER[0], step=NUMBER[1]))
        assert not room.question.answered and not room.question.closed
        await registry.obey(room, PutQuestion(walk=walk, step=step, vote=1, answered=True))  # from another step
        assert room.question.answered and room.question.closed
        tally = await registry.tally(room)
        assert tally and tally.now.answered == 1
        await registry.obey(room, PutQuestion(walk=walk, step=step, vote=2))
        assert not room.question.answered and not room.question.closed
        tally = await registry.tally(room)
        assert tally and tally.before and tally.before.answered == 1


async def test_numbers_points_and_sketches(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        drawn: list[int | None] = [round(10 * i) for i in range(101)]
        for (walk, step), good, bad in (
            (NUMBER, {"text": "2"}, {"text": "two"}),
            (POINT, {"value": 1.5}, {"option": 1}),
            (SKETCH, {"curves": {"Xp1": drawn}}, {"curves": {"Xp1": drawn[:50]}}),
        ):
            await registry.obey(room, PutQuestion(walk=walk, step=step))
            await registry.vote(room, "one", msgspec.convert({"walk": walk, "step": step, **good}, Given))
            with pytest.raises(ValueError):
                await registry.vote(room, "two", msgspec.convert({"walk": walk, "step": step, **bad}, Given))
            for more in ({"text": "=cmd"}, {"option": 0}, {"value": 0.5}, {"curves": {"Xp1": drawn}}):
                if more.keys() != good.keys():  # a field of another type is also stored in the table of answers
                    with pytest.raises(ValueError, match="does not fit"):
                        fields = {"walk": walk, "step": step, **good, **more}
                        await registry.vote(room, "three", msgspec.convert(fields, Given))
            tally = await registry.tally(room)
            assert isinstance(tally, Tally) and tally.now.answered == 1
            if step == SKETCH[1]:
                assert tally.now.sketches[0].curves == {"Xp1": drawn}
                assert len(tally.features) == len(tally.now.sketches[0].has) == 5
            else:
                assert tally.now.numbers == (2.0 if step == NUMBER[1] else 1.5,)


async def test_an_answer_is_judged_once_and_a_vote_reads_its_question_once(
    in_class: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    read: list[type] = []
    decode = msgspec.json.decode
    monkeypatch.setattr(
        room_of.msgspec.json,
        "decode",
        lambda part, **how: (read.append(how.get("type", object)), decode(part, **how))[1],
    )

    async with in_class() as (registry, room):
        judged: list[object] = []
        judge = SketchStep.judge
        monkeypatch.setattr(SketchStep, "judge", lambda *given: (judged.append(given), judge(*given))[1])
        walk, step = SKETCH
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        await until(lambda: PutTo in read)
        read.clear()
        for voter in map(str, range(20)):
            await registry.vote(room, voter, Given(walk=walk, step=step, curves={"Xp1": [int(voter)] * 101}))
        assert read.count(PutTo) <= 1
        for _ in range(3):
            tally = await registry.tally(room)
        assert tally and tally.now.answered == 20 and len(judged) == 20
        assert tally.now.having == tuple(sum(one.has[i] for one in tally.now.sketches) for i in range(5))
        assert len(await votes_csv(registry, room)) == 21 and len(judged) == 20


async def test_all_sketches_of_a_large_class_are_counted_and_some_are_sent(
    in_class: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sketch, "MOST_SKETCHES", 3)
    monkeypatch.setattr(slices, "SLICE", 0.0)

    async with in_class() as (registry, room):
        walk, step = SKETCH
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        for voter in "abcde":
            await registry.vote(room, voter, Given(walk=walk, step=step, curves={"Xp1": [500] * 101}))
        turns, ended = 0, asyncio.Event()

        async def others() -> None:
            nonlocal turns
            while not ended.is_set():
                turns += 1
                await asyncio.sleep(0)

        beside = asyncio.create_task(others())
        await asyncio.sleep(0)
        before = turns
        judged = await registry.given(room, f"{walk}/{step}/1")
        assert turns - before >= len(judged) == 5  # other tasks run between the answers
        ended.set()
        await beside
        tally = await registry.tally(room)
        assert tally and (tally.now.answered, len(tally.now.sketches)) == (5, 3)


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("=1+1", "'=1+1"), ("@SUM(A1)", "'@SUM(A1)"), ("+1", "'+1"), ("-2+3", "'-2+3"), ("\t=1", "'\t=1"),
        ("\r=1", "'\r=1"), ("＝1", "'＝1"), ("-1.5", "-1.5"), ("-1e-300", "-1e-300"), ("2", "2"), ("Xp1: 5", "Xp1: 5"),
    ],
)  # fmt: skip
def test_no_spreadsheet_works_a_cell_out(text: str, safe: str) -> None:
    assert cell(text) == safe


async def test_a_number_is_written_as_one(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        walk, step = NUMBER
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        for voter, text in enumerate(("−2", "-1,5", "+3", "-10^3", "2")):
            await registry.vote(room, str(voter), Given(walk=walk, step=step, text=text))
        rows = [line.strip().split(",")[-4:-1] for line in (await votes_csv(registry, room))[1:]]
        assert sorted((answer, right) for answer, _, right in rows) == sorted(
            [("-2", "no"), ("-1.5", "no"), ("3", "no"), ("-1000", "no"), ("2", "yes")]
        )


async def test_a_walk_that_the_server_does_not_know_is_refused(in_class: Opened) -> None:
    async with in_class() as (registry, room):
        with pytest.raises(ValueError, match="does not know its walk"):
            await registry.obey(room, PutQuestion(walk="mine", step="one"))
        with pytest.raises(ValueError, match="No question"):
            await registry.obey(room, ShowAnswer())


async def test_a_walk_from_a_file_is_read_once(in_class: Opened, monkeypatch: pytest.MonkeyPatch) -> None:
    """Answers are read once, not again after each other one that arrives; if only the store has them, each is read
    once.
    """
    text, read = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n', list[str]()
    monkeypatch.setattr(question_bank, "read_walk", lambda *given: (read.append(given[1]), read_walk(*given))[1])

    async with in_class() as (registry, room):
        for n in range(registry_of.MOST_OWN):
            await registry.obey(room, HandWalk(name=f"mine-{n}", text=text))
            await registry.obey(room, PutQuestion(walk=f"mine-{n}", step="one"))
        assert read == [] and room.walks == registry.bank.read_own(room.own, {})
        read.clear()
        elsewhere = ClassRoom(room.code, dict(room.parts))
        for _ in range(2):
            assert registry.bank_of(elsewhere).step("mine-0", "one")
        assert sorted(read) == sorted(name for name, _ in room.walks)
        elsewhere.parts["walks"] = b'{"mine-0":' + msgspec.json.encode(text + "# mended") + b"}"
        registry.bank_of(elsewhere)
        assert read[-1] == "mine-0" and len(read) == registry_of.MOST_OWN + 1 and len(elsewhere.walks) == 1


async def test_a_walk_from_a_file_is_asked_as_any_other(in_class: Opened) -> None:
    text = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'

    async with in_class() as (registry, room):
        listener, (walk, step) = Listener(), ("mine", "one")
        room.listeners.add(listener)
        with pytest.raises(ValueError, match="is no step that is known"):
            await registry.obey(room, HandWalk(name=walk, text=text.replace("d31-03", "d31-99")))
        for _ in range(2):  # a reloaded page sends it again
            await registry.obey(room, HandWalk(name=walk, text=text))
        await registry.obey(room, PutQuestion(walk=walk, step=step))
        put = listener.news[-1].question
        assert put and put.card and put.place == "D31, slide 1 · 1 of 1" and len(put.card.options) == 3
        await registry.vote(room, "one", Given(walk=walk, step=step, option=0))
        await registry.vote(room, "two", Given(walk=walk, step=step, option=2))
        await registry.obey(room, ShowAnswer())
        tally = await registry.tally(room)
        assert tally and tally.now.options == (1, 0, 1) and tally.right == 1
        rows = [row.strip() for row in (await votes_csv(registry, room))[1:]]
        assert {row.split(",")[-2] for row in rows} == {"yes", "no"} and all(",mine,one,1," in row for row in rows)
        await registry.obey(room, HandWalk(name=walk, text=text.replace("d31-03", "d31-02")))  # now a number
        tally = await registry.tally(room)
        assert tally and tally.now.answered == 0
        for n in range(registry_of.MOST_OWN - 1):
            await registry.obey(room, HandWalk(name=f"more-{n}", text=text))
        with pytest.raises(ValueError, match="one too many"):
            await registry.obey(room, HandWalk(name="too-many", text=text))


async def test_a_class_continues_without_the_store_and_is_written_back() -> None:
    with valkey_running() as valkey:
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

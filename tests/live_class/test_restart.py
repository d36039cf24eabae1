"""A server that has lost a class gets it back from the instructor's page, and from nobody else."""

from __future__ import annotations

import asyncio
import time
from csv import DictReader
from typing import Any

import pytest

from components.language.class_messages import YEAR_2100, PutQuestion, RestoreAnswers, Voted
from components.language.messages import Given
from components.live_class import instructor_routes, registry
from components.live_class.codes import Keys, code_of, digest, is_given, new_token
from components.live_class.registry import Registry
from components.live_class.store import MemoryStore
from tests.live_class.caller import Answered, Class, called, streams_closed
from tests.live_class.listening import BANK
from tests.live_class.served import CHOICE, served, teaching
from tests.live_class.stores import KINDS, Valkey, made

SECRET = "a secret of these tests alone"
VOTE = f"{CHOICE['walk']}/{CHOICE['step']}/1"
SKETCH = {"walk": "d34", "step": "d34-14"}


async def reopened(url: str, code: str, key: str, body: object = None, **more: Any) -> Answered:
    return await called(url, f"/class/{code}/lead", "PUT", body or {}, key, **more)


async def test_a_restarted_server_has_the_room_its_answers_and_its_phones_again() -> None:
    async with streams_closed():
        async with served() as (_, url):
            lesson = await Class.open(url)
            tokens = [await lesson.token() for _ in range(3)]
            await lesson.order("put", **CHOICE)
            for token, option in zip(tokens, (0, 1, 1), strict=True):
                assert (await lesson.vote(token, **CHOICE, option=option)).status == 204
            path = f"/class/{lesson.code}/answers?question={VOTE}"
            kept = (await called(url, path, word=lesson.key)).json
            before = await lesson.tally()
        async with served() as (_, url):
            lesson.url = url
            assert (await lesson.order("withdraw")).status == 404
            again = await reopened(url, lesson.code, lesson.key)
            assert again.json["key"] == lesson.key and again.json["address"].endswith(
                lesson.opened["address"].rpartition("/")[2]
            )
            assert (await lesson.order("put", **CHOICE, vote=2)).status == 204
            assert (await lesson.order("put", **CHOICE, vote=1)).status == 204  # numbers continue and never go back
            assert (await lesson.tally())["vote"] == 2
            await lesson.order("put", **SKETCH)
            await lesson.order("put", **CHOICE)
            assert (await called(url, f"/class/{lesson.code}/now", word=tokens[0])).status == 200
            assert (await lesson.vote(tokens[0], **CHOICE, option=2)).status == 204
            assert (await reopened(url, lesson.code, lesson.key)).status == 200  # as often as requested
            assert (await lesson.order("restore", answers=kept)).status == 204
            now = (await lesson.tally())["now"]
            assert now["options"] == [0, 2, 1] and before["now"]["options"] == [1, 2, 0]
            followed = await lesson.follow()
            await followed.until(lambda event: event.get("question", {}).get("step") == CHOICE["step"])


async def test_an_answer_waits_until_a_restored_class_has_its_question() -> None:
    """The phones are back before the question, by seconds if the server must read its walk from a file first."""
    async with teaching() as (_, url):
        lesson = await Class.open(url)
    async with teaching() as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 200
        lesson.url = url
        token = await lesson.token()
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 503  # the phone tries again
        await lesson.order("put", **CHOICE)
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 204
        await lesson.order("withdraw")
        late = await lesson.vote(token, **CHOICE, option=2)
        assert (late.status, late.json["sentence"]) == (409, "This question is closed.")


async def test_a_class_is_reopened_only_with_its_key() -> None:
    async with teaching() as (server, url):
        lesson, other = await Class.open(url), await Class.open(url)
        forged = Keys().new()
        for code, key in (
            (lesson.code, other.key), (lesson.code, forged), (lesson.code, ""), ("ZZZZ", forged), ("0000", forged),
            (lesson.code, f"{lesson.key}="), (lesson.code, "x" * 5000),
        ):  # fmt: skip
            refused = await reopened(url, code, key)
            assert refused.status == 409 and refused.json["sentence"].startswith("This is not the key of a class")
        assert await server.classes.registry.store.rooms() == 2
        assert (await lesson.order("withdraw")).status == (await other.order("withdraw")).status == 204
        for body in ([], {"control": "x"}, {"control": "a" * 65}, {"control": 5}, {"key": lesson.key}):
            refused = await reopened(url, lesson.code, lesson.key, body)
            assert refused.status == 400 or not body
        await lesson.order("end")
        refused = await reopened(url, lesson.code, lesson.key)
        assert (refused.status, refused.json["sentence"]) == (404, "The class is over.")


async def test_a_code_that_is_another_class_s_by_now_stays_that_one_s(monkeypatch: pytest.MonkeyPatch) -> None:
    async with teaching() as (_, url):
        lesson, key = await Class.open(url), Keys().new()
        monkeypatch.setattr(Keys, "code_of", lambda keys, key: lesson.code)
        refused = await reopened(url, lesson.code, key)
        assert refused.status == 409 and refused.json["sentence"].startswith("Another class has this code")
        assert (await lesson.order("withdraw")).status == 204


async def test_reopened_classes_count_like_new_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 2)

    async with teaching() as (server, url):
        keys = [Keys().new() for _ in range(3)]
        answers = [await reopened(url, code_of(key), key) for key in keys]
        assert [answer.status for answer in answers] == [200, 200, 429]
        assert answers[-1].json["sentence"].endswith("minutes.")
        phrase = "swinging springs"
        assert await server.classes.registry.store.rooms() == 2 and not Keys(phrase).is_own(keys[0])


@pytest.mark.parametrize("secret", ["", SECRET])
async def test_a_server_that_is_started_again_finds_the_code_of_a_key(secret: str) -> None:
    """A secret made at start-up is safe too, because the code does not contain it."""
    settings = {"bokeh_secret_key": secret} if secret else {}
    async with teaching(**settings) as (_, url):
        lesson = await Class.open(url)
    async with teaching(**settings) as (_, url), teaching(bokeh_secret_key=f"{SECRET}, another") as (_, other):
        assert (await reopened(url, lesson.code, lesson.key)).status == 200
        assert (await reopened(other, lesson.code, lesson.key)).status == 409
    assert (code_of(lesson.key) == lesson.code) is not bool(secret)  # nobody finds a key without the secret


async def test_an_answer_that_is_given_back_has_a_time_that_can_be_written() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        good = {**CHOICE, "option": 1}
        for at, status in ((0, 204), (1.7e9, 204), (YEAR_2100, 204), (1e300, 400), (-1, 400), (1e11, 400)):
            name = f"{int(at) % 10**9:011x}abcdefgh"
            assert (await lesson.order("restore", answers={name: {**good, "at": at}})).status == status
        assert (await lesson.order("restore", answers={name: {**good, "here": 10**30}})).status == 400
        table = await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)
        times = {row["time"] for row in DictReader(table.text.splitlines())}
        assert (
            len(times) == 3
            and "" in times
            and max(times) <= time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(time.time() + 1))
        )


async def test_what_is_no_answer_is_not_given_back() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        token = await lesson.token()
        name = token.partition(".")[0]
        good = {**CHOICE, "option": 1}
        for answers, status in (
            ({name: {**good, "option": 10}}, 400), ({"me": good}, 400), ({f"{name}x": good}, 400), ({name: []}, 400),
            ({name: {**good, "who": "me"}}, 400), ([good], 400), ({name: {**good, "text": "x" * 81}}, 400),
            ({name: {**good, "walk": "none"}}, 409), ({name: {**good, "curves": {"x": [0] * 102}}}, 400),
            ({name: {**good, "vote": 10}}, 400),
        ):  # fmt: skip
            refused = await lesson.order("restore", answers=answers)
            assert refused.status == status and refused.json["sentence"].endswith(".")
        unfit = {f"{i:011x}abcdefgh": {**good, "option": i} for i in range(9)}
        assert (await lesson.order("restore", answers=unfit)).status == 204
        await lesson.order("put", **CHOICE)
        assert (await lesson.tally())["now"]["options"] == [1, 1, 1]  # answers that fit no question do not count
        refused = await called(
            url, f"/class/{lesson.code}/lead", "POST", {"type": "restore", "answers": {name: good}}, token
        )
        assert refused.status == 404


@pytest.mark.parametrize("kind", KINDS)
async def test_workers_that_share_a_store_have_it_again_from_any_of_them(kind: str, valkey: Valkey) -> None:
    async with made(kind, valkey.url) as store:
        first, second, third = (Registry(store, BANK) for _ in range(3))
        code, key = await first.open()
        room = await first.led(code, key)
        token = new_token(room.parts["key"])
        await first.obey(room, PutQuestion(**CHOICE))
        voter = room.voter(token)
        await first.vote(room, voter, Given(**CHOICE, option=2))
        kept = await first.copied(room, VOTE)
        await store.end(code)  # like a store that was restarted empty
        again, at_once = await asyncio.gather(second.reopen(code, key, "a" * 64), third.reopen(code, key, "a" * 64))
        assert again.parts["key"] == at_once.parts["key"] == room.parts["key"]
        await second.obey(again, RestoreAnswers(answers=kept))
        assert await third.copied(at_once, VOTE) == kept and isinstance(kept[voter], Voted)
        assert await Registry(store, BANK).followed(code, token)
        assert await store.rooms() == 1
        await second.obey(again, PutQuestion(**CHOICE))
        tally = await second.tally(again)
        assert tally and tally.now.options == (0, 0, 1)


async def test_answers_given_back_are_those_of_phones(monkeypatch: pytest.MonkeyPatch) -> None:
    """A server with a secret knows its names even after a restart; otherwise it accepts what connected phones could
    send.
    """
    monkeypatch.setattr(registry, "SPARE", 2)
    async with teaching(bokeh_secret_key=SECRET) as (_, url):
        lesson = await Class.open(url)
        answer = {**CHOICE, "option": 1}
        own = {(await lesson.token()).partition(".")[0]: answer for _ in range(8)}
    made_up = {f"{i:011x}abcdefgh": answer for i in range(8)}
    async with teaching(bokeh_secret_key=SECRET) as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 200
        lesson.url = url
        refused = await lesson.order("restore", answers=made_up)
        assert refused.status == 409 and refused.json["sentence"].startswith("6 answers were not kept: more than")
        assert (await lesson.order("restore", answers=own)).status == 204
        copies = await called(url, f"/class/{lesson.code}/answers?question={VOTE}", word=lesson.key)
        assert len(copies.json) == 2 + 8 and own.keys() <= copies.json.keys()


def test_a_name_is_of_the_room_and_the_server_that_gave_it() -> None:
    room = digest("a room")
    name = new_token(room, SECRET).partition(".")[0]
    assert is_given(name, room, SECRET) and is_given(name, room, "")
    for strange in (is_given(name, digest("another"), SECRET), is_given(name, room, f"{SECRET}.")):
        assert not strange
    assert not any(is_given(new_token(room, other).partition(".")[0], room, SECRET) for other in ("", "another"))


async def test_answers_given_back_fill_no_more_than_a_room() -> None:
    registry = Registry(MemoryStore(size=2000), BANK)
    code, key = await registry.open()
    room = await registry.led(code, key)
    answers = {f"{i:011x}abcdefgh": Voted(**CHOICE, option=1) for i in range(50)}
    with pytest.raises(ValueError, match="cannot store more answers of this class"):
        await registry.obey(room, RestoreAnswers(answers=answers))
    assert 0 < len(await registry.copied(room, VOTE)) < 50

"""A server that has lost a class gets it back from the instructor's page, and from nobody else."""

from __future__ import annotations

from typing import Any

import pytest

from components.live_class import instructor_routes, registry
from components.live_class.codes import Keys, as_code, code_of, digest, is_given, new_key, new_token, voter_of
from tests.live_class.caller import Answered, Class, called
from tests.live_class.served import CHOICE, served

SECRET = "a secret of these tests alone"
VOTE = f"{CHOICE['walk']}/{CHOICE['step']}/1"


async def reopened(url: str, code: str, key: str, **more: Any) -> Answered:
    return await called(url, f"/class/{code}/lead", "PUT", {}, key, **more)


async def test_a_restarted_server_has_the_room_its_answers_and_its_phones_again() -> None:
    async with served() as (_, url):
        lesson = await Class.open(url)
        tokens = [await lesson.token() for _ in range(3)]
        await lesson.order("put", **CHOICE)
        for token, option in zip(tokens, (0, 1, 1), strict=True):
            assert (await lesson.vote(token, **CHOICE, option=option)).status == 204
        kept = (await called(url, f"/class/{lesson.code}/answers?question={VOTE}", word=lesson.key)).json
    async with served() as (_, url):
        lesson.url = url
        assert (await lesson.order("withdraw")).status == 404
        again = await reopened(url, lesson.code, lesson.key)
        assert again.json["address"].partition("?")[2] == lesson.opened["address"].partition("?")[2]
        assert (await called(url, f"/class/{lesson.code}/now", word=tokens[0])).status == 200
        assert (await lesson.vote(tokens[0], **CHOICE, option=2)).status == 503  # the phone tries again
        await lesson.order("put", **CHOICE)
        assert (await lesson.vote(tokens[0], **CHOICE, option=2)).status == 204
        assert (await reopened(url, lesson.code, lesson.key)).status == 200  # as often as requested
        await lesson.order("show")
        phone = await lesson.follow()
        assert (await lesson.order("restore", answers=kept)).status == 204
        await phone.until(lambda event: (event.get("question", {}).get("split") or {}).get("options") == [0, 2, 1])
        assert (await lesson.tally())["now"]["options"] == [0, 2, 1]


async def test_a_class_is_reopened_only_with_its_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 12)

    async with served() as (server, url):
        lesson, other = await Class.open(url), await Class.open(url)
        forged = Keys().new()
        for code, key in (
            (lesson.code, other.key), (lesson.code, forged), (lesson.code, ""), ("ZZZZ", forged), ("0000", forged),
            (lesson.code, f"{lesson.key}="), (lesson.code, "x" * 5000),
        ):  # fmt: skip
            refused = await reopened(url, code, key)
            assert refused.status == 409 and refused.json["sentence"].startswith("This is not the key of a class")
        assert await server.classes.registry.store.rooms() == 2
        with monkeypatch.context() as patch:
            patch.setattr(Keys, "code_of", lambda keys, key: lesson.code)
            refused = await reopened(url, lesson.code, forged)
            assert refused.status == 409 and refused.json["sentence"].startswith("Another class has this code")
        assert (await lesson.order("withdraw")).status == (await other.order("withdraw")).status == 204
        statuses = [(await reopened(url, code_of(key), key)).status for key in (Keys().new() for _ in range(3))]
        assert statuses == [200, 200, 429]  # reopened classes count like new ones


async def test_answers_given_back_are_those_of_phones(monkeypatch: pytest.MonkeyPatch) -> None:
    """A server with a secret knows its names even after a restart; otherwise it accepts what connected phones could
    send. Answers that fit no question do not count.
    """
    monkeypatch.setattr(registry, "SPARE", 2)
    async with served(bokeh_secret_key=SECRET) as (_, url):
        lesson = await Class.open(url)
        own = {(await lesson.token()).partition(".")[0]: {**CHOICE, "option": i} for i in range(8)}
    async with served(bokeh_secret_key=f"{SECRET}, another") as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 409
    made_up = {f"{i:011x}abcdefgh": {**CHOICE, "option": 1} for i in range(8)}
    async with served(bokeh_secret_key=SECRET) as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 200
        lesson.url = url
        refused = await lesson.order("restore", answers=made_up)
        assert refused.status == 409 and refused.json["sentence"].startswith("6 answers were not kept: more than")
        assert (await lesson.order("restore", answers=own)).status == 204
        copies = await called(url, f"/class/{lesson.code}/answers?question={VOTE}", word=lesson.key)
        assert len(copies.json) == 2 + 8 and own.keys() <= copies.json.keys()
        await lesson.order("put", **CHOICE)
        assert (await lesson.tally())["now"]["options"] == [1, 1 + 2, 1]


def test_codes_tokens_and_keys_are_those_that_a_server_gave() -> None:
    assert as_code(" k7h-m ") == "K7HM" and all(as_code(code_of(new_key())) for _ in range(20))
    assert [as_code(text) for text in ("K7H", "K7HMM", "K7H0", "<b>x", "ÄÖÜß")] == [""] * 5
    room, other = digest("a room"), digest("another")
    token = new_token(room, SECRET)
    name = token.partition(".")[0]
    assert voter_of(token, room) == name and voter_of(token, other) == voter_of(token, b"") == ""
    assert [voter_of(text, room) for text in ("", ".", "a.b", "ä.b")] == [""] * 4
    assert is_given(name, room, SECRET) and is_given(name, room, "")
    assert not is_given(name, other, SECRET) and not is_given(name, room, f"{SECRET}.")
    assert not is_given(new_token(room).partition(".")[0], room, SECRET)
    assert all(Keys(phrase).is_own(Keys(phrase).new()) for phrase in ("", "swinging springs"))
    for key in (Keys().new(), Keys("another phrase").new(), "", "x" * 48, "ä" * 48):
        assert not Keys("swinging springs").is_own(key)

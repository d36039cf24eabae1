"""Short text answers: equal ones form a group, and no group is visible before the instructor shows it."""

from __future__ import annotations

from csv import DictReader
from io import StringIO
from typing import Any

import pytest

from components.language.class_messages import Moderate
from components.live_class import moderation
from components.live_class.moderation import Moderation
from tests.live_class.caller import Class, called
from tests.live_class.served import teaching

WALK = """title = "Why"
[[step]]
id = "why"
kind = "words"
title = "Energy goes to and fro"
state = "?scene=oscillator"
question = "Why does it swing on?"
explain = "Energy goes to and fro."
"""
ASKED = {"walk": "why", "step": "why"}


async def asked(url: str) -> Class:
    lesson = await Class.open(url)
    assert (await lesson.order("walk", name="why", text=WALK)).status == 204
    assert (await lesson.order("put", **ASKED)).status == 204
    return lesson


async def words(lesson: Class) -> Any:
    return [(one["text"], one["count"], one["shown"]) for one in (await lesson.tally())["now"]["words"]]


async def test_equal_answers_are_one_group_and_hidden_until_they_are_shown() -> None:
    async with teaching() as (_, url):
        lesson = await asked(url)
        for text in ("Energy", " energy. ", "ENERGY!", "Because"):
            assert (await lesson.vote(await lesson.token(), **ASKED, text=text)).status == 204
        found = await words(lesson)
        assert sorted((text.casefold().strip(" .!"), count, shown) for text, count, shown in found) == [
            ("because", 1, False), ("energy", 3, False)
        ]  # fmt: skip
        assert (await lesson.order("moderate", text="energy", shows=True)).status == 204
        assert [shown for text, _, shown in await words(lesson) if text != "Because"] == [True]
        await lesson.vote(await lesson.token(), **ASKED, text="energy")  # one more of a visible group
        assert (4, True) in [(count, shown) for _, count, shown in await words(lesson)]
        await lesson.order("moderate", text="Energy", shows=False)
        assert await words(lesson) == [("Because", 1, False)]
        table = (await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)).text
        assert len(list(DictReader(StringIO(table)))) == 5  # the table has removed answers too
        await lesson.order("put", **ASKED, vote=2)
        assert (await lesson.vote(await lesson.token(), **ASKED, vote=2, text="Energy")).status == 204
        assert await words(lesson) == [("Energy", 1, False)]  # another vote starts hidden


@pytest.mark.parametrize(
    ("text", "status", "kept"),
    [
        ("🙂👩\u200d🔬", 204, "🙂👩\u200d🔬"), ("<b>so</b>", 204, "<b>so</b>"), ("=1+1", 204, "=1+1"),
        ("a\u202eb\nc", 204, "a b c"), ("x" * 80, 204, "x" * 80), ("x" * 81, 400, ""), ("x" * 10_000, 413, ""),
        ("", 409, ""), (" \u200b ", 409, ""),
    ],
)  # fmt: skip
async def test_any_text_is_kept_as_text_or_refused_in_a_sentence(text: str, status: int, kept: str) -> None:
    async with teaching() as (_, url):
        lesson = await asked(url)
        answer = await lesson.vote(await lesson.token(), **ASKED, text=text)
        assert answer.status == status
        if kept:
            assert [one[0] for one in await words(lesson)] == [kept]
            table = (await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)).text
            (row,) = DictReader(StringIO(table))
            assert row["answer"].removeprefix("'") == kept and not row["answer"].startswith("=")
        else:
            assert answer.json["sentence"].endswith(".") and await words(lesson) == []


async def test_phones_do_not_get_the_words_of_others() -> None:
    async with teaching() as (_, url):
        lesson = await asked(url)
        phone = await lesson.follow()
        await lesson.vote(await lesson.token(), **ASKED, text="secret")
        await lesson.order("moderate", text="secret", shows=True)
        await lesson.order("show")
        await phone.until(lambda event: event.get("question", {}).get("split"))
        assert "secret" not in str(phone.heard)
        await phone.close()


def test_so_many_are_moderated_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(moderation, "MOST", 2)
    now = Moderation()
    for text in ("a", "b", "a"):
        now = now.after(Moderate(text=text, shows=True), "one")
    with pytest.raises(ValueError, match="At most 2 answers"):
        now.after(Moderate(text="c", shows=True), "one")
    assert now.after(Moderate(text="c", shows=True), "two").shown == ("c",)

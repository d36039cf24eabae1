"""Confidence in a class: asked with any vote, counted with it, in the table."""

from __future__ import annotations

from csv import DictReader
from io import StringIO

from tests.live_class.caller import Class, called
from tests.live_class.served import CHOICE, teaching


async def test_how_sure_those_are_who_answer_is_counted_with_the_vote() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        refused = await lesson.order("sure")
        assert refused.status == 409 and refused.json["sentence"] == "No question is open now."
        await lesson.order("put", **CHOICE)
        phone = await lesson.follow()
        assert (await lesson.order("sure")).status == 204
        await phone.until(lambda event: event.get("question", {}).get("sure"))
        for option, sure in ((0, 3), (0, 1), (1, 3), (2, 0)):
            assert (await lesson.vote(await lesson.token(), **CHOICE, option=option, sure=sure)).status == 204
        for wrong in (4, -1, "certain", 10**40):
            assert (await lesson.vote(await lesson.token(), **CHOICE, option=0, sure=wrong)).status == 400
        assert (await lesson.tally())["now"]["sure"] == [[1, 1], [0, 0], [2, 1]]
        table = (await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)).text
        assert sorted(row["sure"] for row in DictReader(StringIO(table))) == ["", "certain", "certain", "guessed"]
        await lesson.order(
            "put", **CHOICE, vote=2
        )  # it is asked again with the next vote, but not with another question
        again = await phone.until(lambda event: event.get("question", {}).get("vote") == 2)
        assert again["question"]["sure"]
        await lesson.order("put", walk="d31", step="d31-02")
        other = await phone.until(lambda event: event.get("question", {}).get("step") == "d31-02")
        assert not other["question"]["sure"]
        assert (await lesson.tally())["now"]["sure"] == []
        await phone.close()


async def test_without_an_answer_nothing_is_said_of_it() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        refused = await lesson.vote(await lesson.token(), **CHOICE, sure=2)
        assert refused.status == 409 and refused.json["sentence"] == "This answer does not fit the question."

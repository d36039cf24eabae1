"""The information of phones on a class's answers: their number during the vote, the split with the answer."""

from __future__ import annotations

from typing import Any

import pytest

from tests.live_class.caller import Class
from tests.live_class.served import CHOICE, teaching

GIVEN: list[tuple[dict[str, Any], dict[str, Any], dict[str, Any]]] = [
    (CHOICE, {"option": 1}, {"answered": 1, "right": 0, "judges": True, "options": [0, 1, 0]}),
    ({"walk": "d31", "step": "d31-02"}, {"text": "2"}, {"answered": 1, "right": 1, "judges": True, "options": []}),
    ({"walk": "d34", "step": "d34-14"}, {"curves": {"Xp1": [500] * 101}}, {"answered": 1, "right": 0}),
]


@pytest.mark.parametrize(("asked", "given", "split"), GIVEN)
async def test_the_split_comes_with_the_answer_and_goes_with_it(asked: Any, given: Any, split: Any) -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **asked)
        phone = await lesson.follow()
        assert (await phone.until(lambda event: event.get("question")))["question"]["split"] is None
        assert (await lesson.vote(await lesson.token(), **asked, **given)).status == 204
        await phone.until(lambda event: event.get("answered") == 1)
        await lesson.order("show")
        shown = (await phone.until(lambda event: event.get("question", {}).get("lesson")))["question"]
        assert split.items() <= shown["split"].items() and "sketches" not in shown["split"]
        await lesson.order("put", **asked, vote=2)
        again = await phone.until(lambda event: event.get("question", {}).get("vote") == 2)
        assert again["question"]["split"] is None
        await phone.close()


async def test_answers_that_come_back_after_a_restart_are_in_the_split() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        await lesson.order("show")
        phone = await lesson.follow()
        await lesson.order("restore", answers={"0" * 11 + "abcdefgh": {**CHOICE, "option": 0}})
        await phone.until(lambda event: (event.get("question", {}).get("split") or {}).get("options") == [1, 0, 0])
        await phone.close()

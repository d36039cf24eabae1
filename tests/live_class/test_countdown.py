"""The countdown of a vote: by the server's clock, sent to everybody, bounded."""

from __future__ import annotations

from time import time
from typing import Any

from tests.live_class.caller import Class, Stream
from tests.live_class.served import CHOICE, teaching


async def put(phone: Stream, last: float = 0.0) -> Any:
    """Return the question as it is sent after its countdown is extended."""
    return (await phone.until(lambda event: event.get("question", {}).get("until", 0) > last))["question"]


async def test_it_counts_and_counts_longer_and_belongs_to_one_vote() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        refused = await lesson.order("countdown", seconds=30)
        assert refused.status == 409 and refused.json["sentence"] == "No question is open now."
        await lesson.order("put", **CHOICE)
        phone, start = await lesson.follow(), 1000 * time()
        await lesson.order("countdown", seconds=30, closes=True)
        first = await put(phone)
        assert start + 30_000 <= first["until"] <= 1000 * time() + 30_000 and first["closes"]
        await lesson.order("countdown", seconds=15)
        longer = await put(phone, first["until"])
        assert longer["until"] == first["until"] + 15_000 and not longer["closes"]
        await lesson.order("countdown", seconds=0, closes=True)  # it only decides what happens at 0
        put_so = {"until": longer["until"], "closes": True}
        await phone.until(lambda event: put_so.items() <= event.get("question", {}).items())
        await lesson.order("put", **CHOICE)  # a reloaded page sends the order again without changing the countdown
        await lesson.order("put", **CHOICE, vote=2)
        again = await phone.until(lambda event: event.get("question", {}).get("vote") == 2)
        assert again["question"]["until"] == 0 and not again["question"]["closes"]
        await phone.close()


async def test_it_is_no_longer_than_ten_minutes() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        phone = await lesson.follow()
        for wrong in (601, -1, 1e9, "30", None):
            assert (await lesson.order("countdown", seconds=wrong)).status == 400
        await lesson.order("countdown", seconds=600)
        first = await put(phone)
        await lesson.order("countdown", seconds=600)
        assert (await put(phone, first["until"]))["until"] <= 1000 * time() + 600_000
        await phone.close()

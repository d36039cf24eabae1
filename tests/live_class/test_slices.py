"""The work of a class with many answers in one turn of the event loop."""

from __future__ import annotations

import asyncio
import sys
from typing import Any

import pytest

from components.live_class.slices import Turns
from components.live_class.store import MemoryStore
from components.walks.questions.question import Judged, Written
from components.walks.questions.sketch import SketchStep
from tests.live_class.caller import Class, called
from tests.live_class.full_class import ANSWERS, READ, fill
from tests.live_class.messages import NUMBER, SKETCH
from tests.live_class.served import CHOICE, served

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
    "asked", [SKETCH, {**NUMBER, "text": "7"}, {**CHOICE, "option": 1}], ids=lambda one: one["step"]
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
    async with served(kept) as (_, url):
        lesson = await Class.open(url)
        await fill(lesson, kept, asked)
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

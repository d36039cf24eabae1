"""Listeners of a class in tests, and the questions asked in it."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import msgspec

from components.language.class_messages import News
from components.live_class.question_bank import QuestionBank
from components.live_class.registry import Registry
from components.live_class.store import Store
from components.live_class.upkeep import Upkeep
from components.scenes import SCENES
from components.walks.registry import all_walks
from tests.serving.served import until

BANK = QuestionBank(all_walks((), SCENES), SCENES)
CHOICE = ("d31", "d31-03")


class Listener:
    """A listener of a class."""

    def __init__(self, leads: bool = False) -> None:
        self.leads = leads
        self.name = str(id(self))
        self.news: list[News] = []
        self.ended = False

    def receive(self, event: bytes) -> None:
        self.news.append(msgspec.json.decode(event.removeprefix(b"data: "), type=News))

    def end(self) -> None:
        self.ended = True


@asynccontextmanager
async def replicas(*stores: Store) -> AsyncIterator[list[Registry]]:
    """Open the class at several replicas, each of which listens to its own store."""
    registries = [Registry(store, BANK) for store in stores]
    upkeeps = [Upkeep(registry) for registry in registries]
    for upkeep in upkeeps:
        upkeep.start()
    try:
        await until(lambda: all(upkeep.listening for upkeep in upkeeps))
        yield registries
    finally:
        for upkeep in upkeeps:
            await upkeep.end()

"""The live class as an extension of the server: its routes, its metrics, and the upkeep of its rooms."""

from __future__ import annotations

from functools import partial
from typing import Any

from components.live_class.codes import Keys
from components.live_class.context import ClassContext
from components.live_class.follower_routes import Answers, Enter, Events, MovedByCode, Now, TimeOfDay
from components.live_class.instructor_routes import (
    CopyAnswers,
    CountAnswers,
    CountStored,
    LeadClass,
    OpenClass,
    SumUp,
    TakeAnswers,
)
from components.live_class.lead_routes import MovedByWord, PassLead
from components.live_class.publisher import Publisher
from components.live_class.question_bank import QuestionBank
from components.live_class.registry import Registry
from components.live_class.remote_routes import LetIn, Listing, RemoteControl
from components.live_class.store import Store
from components.live_class.upkeep import Upkeep
from components.serving.metrics import Looked

CODE = r"([0-9A-Za-z]{4})"


class LiveClass:
    """The live classes of one server. If the server has a passphrase, only visitors who know it can open one. `secret`
    is the one of the settings, "" if none is set.
    """

    def __init__(self, store: Store, bank: QuestionBank, passphrase: str = "", secret: str = "") -> None:
        registry = Registry(store, bank, Keys(passphrase, secret))
        self.context = ClassContext(registry)
        self.lead = partial(Publisher, registry)
        self._upkeep = Upkeep(registry)
        self.start, self.end = self._upkeep.start, self._upkeep.end

    def routes(self) -> list[tuple[Any, ...]]:
        handlers = {
            r"/class": OpenClass,
            r"/class/time": TimeOfDay,
            rf"/class/{CODE}/lead": LeadClass,
            rf"/class/{CODE}/tally": CountAnswers,
            rf"/class/{CODE}/answers": CopyAnswers,
            rf"/class/{CODE}/answers.csv": TakeAnswers,
            rf"/class/{CODE}/summary": SumUp,
            rf"/class/{CODE}/stored": CountStored,
            rf"/class/{CODE}/word": PassLead,
            rf"/class/{CODE}/tickets": LetIn,
            rf"/class/{CODE}/remote": RemoteControl,
            rf"/class/{CODE}/steps": Listing,
            rf"/class/{CODE}/token": Enter,
            rf"/class/{CODE}/events": Events,
            rf"/class/{CODE}/now": Now,
            rf"/class/{CODE}/answer": Answers,
        }
        own = [(address, handler, {"classes": self.context}) for address, handler in handlers.items()]
        return [*own, (rf"/{CODE}(/?)", MovedByCode), (rf"/{CODE}-([0-9A-Za-z]{{8}})", MovedByWord)]

    def figures(self) -> Looked:
        registry, upkeep = self.context.registry, self._upkeep
        return {
            "answers": (
                "Answers of live classes in this process",
                lambda: sum(len(votes) for room in registry.rooms.values() for votes in room.votes.values()),
            ),
            "rooms": ("Live classes with an instructor or follower in this process", lambda: len(registry.rooms)),
            "followers": ("Followers of live classes", lambda: registry.followers),
            "store_rooms": ("Live classes in the store, of all replicas", lambda: upkeep.rooms),
            "store_up": ("1 while the store of live classes answers, else 0", lambda: upkeep.listening),
            "store_skew_seconds": ("By how much this clock is ahead of the store's", lambda: upkeep.skew),
        }

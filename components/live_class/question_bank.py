"""The questions of the walks for a class: the lesson of a step, and the judgement of an answer."""

from __future__ import annotations

from asyncio import wrap_future
from collections.abc import Mapping, Sequence
from functools import lru_cache
from hashlib import sha256
from typing import Any

import msgspec
from msgspec.structs import asdict, replace

from components.language.class_messages import Counted, Listed, PutTo, Voted
from components.language.messages import Given
from components.language.walk import Lesson
from components.layout.text import plain, rich
from components.quantities.formatting import excerpt
from components.session.worker import Here, Reading, Worker
from components.walks import Walks
from components.walks.cards import asked, parted, place_in_lecture, step_card
from components.walks.links import Scenes
from components.walks.loading import WalkError, read_walk, steps_of
from components.walks.questions.question import UNFIT, Judged, Written
from components.walks.subject import Subject
from components.walks.walk import Step, Walk

SURE = {1: "guessed", 2: "fairly sure", 3: "certain"}
"""The levels of a student's certainty."""
ReadWalks = Mapping[tuple[str, str], Walk]
"""Walks from files, by name and text."""


class BusyError(ValueError):
    """A temporary refusal, because other files are read first."""


class QuestionBank:
    """The questions of walks, with all data that a room needs."""

    def __init__(self, walks: Walks, scenes: Scenes) -> None:
        self._walks = walks
        self._scenes = scenes
        self.worker: Worker = Here(walks, scenes)
        self._subject = lru_cache(maxsize=64)(self._subject_of)
        self.unanswered = lru_cache(maxsize=64)(self._unanswered)
        self._form = lru_cache(maxsize=512)(self._form_of)
        self._judged_again = lru_cache(maxsize=5000)(self._judge_again)

    def read_own(self, own: Mapping[str, str], before: ReadWalks) -> ReadWalks:
        """Read walks from texts by name; `before` has the walks read earlier. Raises WalkError for an invalid one."""
        known = steps_of(self._walks.values())
        return {(name, text): before.get((name, text)) or read_walk(text, name, known) for name, text in own.items()}

    def taking(self, own: ReadWalks) -> QuestionBank:
        """The question bank with walks from files as well."""
        return QuestionBank({**self._walks, **{name: walk for (name, _), walk in own.items()}}, self._scenes)

    async def try_own(self, name: str, text: str, network: str = "") -> Walk:
        """Read the walk of a file. Raises WalkError if it is invalid, and BusyError if others come first."""
        replied = await wrap_future(self.worker.ask(Reading(name, text), network))
        if not replied.walk:
            raise (BusyError if replied.is_busy else WalkError)(replied.refused)
        return replied.walk

    def step(self, walk: str, step: str) -> Step:
        """Return a step. Raises ValueError, with a reason, if there is none."""
        for one in self._walks[walk].steps if walk in self._walks else ():
            if one.id == step:
                return one
        raise ValueError(f"The step “{excerpt(step)}” cannot be asked in a class: the server does not know its walk.")

    def listed(self, walk: str) -> tuple[Listed, ...]:
        """Return the steps of a walk by their titles; empty for an unknown walk."""
        steps = self._walks[walk].steps if walk in self._walks else ()
        return tuple(Listed(step=one.id, title=rich(one.title)) for one in steps)

    def put(self, walk: str, step: str, vote: int) -> PutTo:
        """Return a question for everyone in the room."""
        found = self.step(walk, step)
        steps = self._walks[walk].steps
        place = " · ".join(filter(None, (place_in_lecture(found.slides), f"{steps.index(found) + 1} of {len(steps)}")))
        return PutTo(walk=walk, step=step, card=step_card(walk, found, self._scenes), place=place, vote=vote)

    def lesson(self, given: Given) -> Lesson:
        """Return the lesson of a step, with an answer or without. Raises ValueError for an answer that does not fit."""
        return self.step(given.walk, given.step).lesson(given, self._subject(given.walk, given.step))

    def judge(self, given: Given) -> Judged:
        """Return an answer with its judgement. Raises ValueError, with a reason, if it does not fit the question."""
        found = self.step(given.walk, given.step).judged(given, self._subject(given.walk, given.step))
        if found is None:
            raise ValueError(UNFIT)
        form = self._form(given.walk, given.step)
        return Judged(**asdict(given), number=found.number, right=bool(found.right), has=found.has, form=form)

    def counted(self, walk: str, step: str, given: Sequence[Judged]) -> Counted:
        rated = [(one.sure, one.right) for one in given if one.sure]
        levels = tuple((sum(sure == n for sure, _ in rated), rated.count((n, True))) for n in SURE) if rated else ()
        return replace(self.step(walk, step).count(given), sure=levels)

    def written(self, given: Judged) -> Written:
        """An answer in the table of a class."""
        return self.step(given.walk, given.step).written(given, self._subject(given.walk, given.step))

    def judges(self, walk: str, step: str) -> bool:
        """Return True if answers to a step can be right or wrong."""
        return self.step(walk, step).judges

    def asked(self, walk: str, step: str) -> str:
        """Return the text of a step's question without markup."""
        _, question = parted(asked(self.step(walk, step), self._subject(walk, step)))
        return plain(question)

    def place(self, walk: str, step: str) -> int:
        """The place of a step in its walk, from 1 on."""
        return self._walks[walk].steps.index(self.step(walk, step)) + 1

    def features(self, walk: str, step: str) -> tuple[str, ...]:
        """Return the names of the features of a correct sketch."""
        return tuple(one.name for one in self.unanswered(walk, step).findings)

    def notes(self, walk: str, step: str) -> tuple[str, ...]:
        """Return the instructor's notes on a step, a paragraph for each line."""
        return tuple(map(rich, self.step(walk, step).noted))

    def _unanswered(self, walk: str, step: str) -> Lesson:
        return self.lesson(Given(walk=walk, step=step))

    def read(self, kept: bytes) -> Judged | None:
        """Return a stored answer, or None if its step has changed so that the answer does not fit."""
        known = _JUDGED.decode(kept)
        if known.form == self._form(known.walk, known.step):
            return known
        found = self._judged_again(kept)
        return None if found is None else replace(known, **found)

    @staticmethod
    def voted(kept: bytes) -> Voted:
        """Return a stored answer without its judgement."""
        known = _JUDGED.decode(kept)
        return Voted(**{name: getattr(known, name) for name in Voted.__struct_fields__})

    def _judge_again(self, kept: bytes) -> dict[str, Any] | None:
        """Return the current judgement of an answer, without the answer, because thousands are cached."""
        known = _JUDGED.decode(kept)
        try:
            judged = self.judge(Given(**{name: getattr(known, name) for name in Given.__struct_fields__}))
        except ValueError:
            return None
        return {name: getattr(judged, name) for name in ("number", "right", "has", "form")}

    def _form_of(self, walk: str, step: str) -> str:
        """Return a hash of a step, to tell it from a step of the same name in an earlier file."""
        try:
            return sha256(msgspec.json.encode(self.step(walk, step))).hexdigest()[:12]
        except ValueError:
            return "none"

    def _subject_of(self, walk: str, step: str) -> Subject:
        return Subject(walk, self.step(walk, step), self._scenes)


_JUDGED = msgspec.json.Decoder(Judged)

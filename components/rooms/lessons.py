"""The questions of the walks as a class is asked them: what a step teaches, and what is right of an answer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import msgspec

from components.numbers import excerpt, parse_number
from components.page.messages import Given, Stroke
from components.page.room import HEIGHTS, Counted, PutTo, Sketched, SketchOf, Vote
from components.page.walk import Lesson
from components.walks import Walks
from components.walks.cards import place_in_lecture, step_card
from components.walks.curves import PlotAxes, axes_of, true_curves
from components.walks.findings import findings
from components.walks.judging import lesson_of
from components.walks.links import Scenes, scene_at
from components.walks.loading import read_walk, steps_of
from components.walks.registry import read_own
from components.walks.sketch import Sketch
from components.walks.types import ChoiceStep, NumberStep, PointStep, SketchStep, Step


class Judged(NamedTuple):
    """An answer, whether it is right, and which of the features asked for a sketch has."""

    vote: Vote
    right: bool
    has: tuple[bool, ...]


class Lessons:
    """All that a room must know of walks."""

    def __init__(self, walks: Walks, scenes: Scenes) -> None:
        self._walks = walks
        self._scenes = scenes
        self._drawn = lru_cache(maxsize=64)(self._drawn_on)
        self.read = lru_cache(maxsize=20_000)(self._read)
        """An answer as it was kept, read and judged once; None where its step is another by now."""

    def taking(self, own: Mapping[str, str]) -> Lessons:
        """With walks from files, their texts by name; WalkError for what is none."""
        known = steps_of(self._walks.values())
        return Lessons(
            {**self._walks, **{name: read_walk(text, name, known) for name, text in own.items()}}, self._scenes
        )

    def try_own(self, name: str, text: str) -> None:
        """WalkError, in words, for what is no walk to be asked."""
        read_own(text, name, self._walks, self._scenes)

    def step(self, walk: str, step: str) -> Step:
        """ValueError, in words, where there is none."""
        for one in self._walks[walk].steps if walk in self._walks else ():
            if one.id == step:
                return one
        raise ValueError(f"A class cannot be asked the step “{excerpt(step)}”: the server does not know its walk.")

    def put(self, walk: str, step: str, vote: int) -> PutTo:
        """A question as it is told to all."""
        asked = self.step(walk, step)
        steps = self._walks[walk].steps
        place = " · ".join(filter(None, (place_in_lecture(asked.slides), f"{steps.index(asked) + 1} of {len(steps)}")))
        return PutTo(walk=walk, step=step, card=step_card(walk, asked, self._scenes), place=place, vote=vote)

    def lesson(self, walk: str, step: str) -> Lesson:
        """What a step teaches whoever has answered whatever."""
        return lesson_of(self.step(walk, step), Given(walk=walk, step=step), self._scenes)

    def judged(self, vote: Vote) -> Lesson:
        """The same with what is said of an answer; ValueError for what is none."""
        step = self.step(vote.walk, vote.step)
        given = Given(walk=vote.walk, step=vote.step, option=vote.option, text=vote.text, value=vote.value)
        if isinstance(step, SketchStep):
            field, _ = self._drawn(vote.walk, vote.step)
            given = Given(walk=vote.walk, step=vote.step, curves=_strokes(vote.curves, field))
        return lesson_of(step, given, self._scenes)

    def check(self, vote: Vote) -> None:
        """ValueError, in words, for what is no answer to its question."""
        step = self.step(vote.walk, vote.step)
        match step:
            case ChoiceStep():
                fits = vote.option is not None and vote.option < len(step.options)
            case NumberStep():
                parse_number(vote.text)
                fits = True
            case PointStep():
                fits = vote.value is not None
            case SketchStep():
                fits = bool(vote.curves) and all(
                    name in step.curves and len(curve) == HEIGHTS for name, curve in vote.curves.items()
                )
        if not fits:
            raise ValueError("This is no answer to that question.")

    def counted(self, walk: str, step: str, given: Sequence[Judged]) -> Counted:
        asked, votes = self.step(walk, step), [one.vote for one in given]
        match asked:
            case ChoiceStep():
                options = tuple(sum(vote.option == i for vote in votes) for i in range(len(asked.options)))
                return Counted(answered=len(votes), options=options)
            case SketchStep():
                return Counted(
                    answered=len(votes), sketches=tuple(SketchOf(curves=one.vote.curves, has=one.has) for one in given)
                )
            case NumberStep():
                return Counted(answered=len(votes), numbers=tuple(parse_number(vote.text) for vote in votes))
        return Counted(answered=len(votes), numbers=tuple(vote.value for vote in votes if vote.value is not None))

    def features(self, walk: str, step: str) -> tuple[str, ...]:
        """What a right sketch has, by name."""
        return tuple(one.name for one in self.lesson(walk, step).findings)

    def _read(self, kept: bytes) -> Judged | None:
        vote = msgspec.json.decode(kept, type=Vote)
        try:
            self.check(vote)
        except ValueError:
            return None
        asked = self.step(vote.walk, vote.step)
        if not isinstance(asked, SketchStep):
            return Judged(vote, bool(self.judged(vote).right), ())
        field, true = self._drawn(vote.walk, vote.step)
        found = findings(asked, field.drawn(_strokes(vote.curves, field), asked.curves), true, field)
        has = tuple(one.has for one in found)
        return Judged(vote, all(has), has)

    def _drawn_on(self, walk: str, step: str) -> tuple[PlotAxes, Mapping[str, Sketch]]:
        """The axes that a sketch is drawn on, and the true curves."""
        asked = self.step(walk, step)
        assert isinstance(asked, SketchStep)
        scene = scene_at(asked.state, self._scenes)
        return axes_of(scene, asked.plot), true_curves(asked, scene)


def _strokes(curves: Mapping[str, Sketched], field: PlotAxes) -> dict[str, Stroke]:
    """Heights in thousandths of the frame as places on the axes."""
    left, right = (field.x.place(end) for end in (field.x.start, field.x.end))
    low, high = (field.y.place(end) for end in (field.y.start, field.y.end))
    return {
        name: [
            (left + (right - left) * i / (HEIGHTS - 1), low + (high - low) * height / 1000)
            for i, height in enumerate(heights)
            if height is not None
        ]
        for name, heights in curves.items()
    }

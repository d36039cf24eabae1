"""The questions of the walks as a class is asked them: what a step teaches, and what is right of an answer."""

from __future__ import annotations

from asyncio import wrap_future
from collections import Counter
from collections.abc import Mapping, Sequence
from functools import lru_cache
from hashlib import sha256

import msgspec

from components.axes import Axis
from components.numbers import excerpt
from components.page.messages import Given, Stroke
from components.page.room import HEIGHTS, Counted, PutTo, Sketched, SketchOf, Vote
from components.page.walk import Lesson
from components.typed import typed_number
from components.walks import Walks
from components.walks.apart import Apart, Here, Reading
from components.walks.cards import place_in_lecture, step_card
from components.walks.curves import PlotAxes, axes_of, number_at, pad_axes, true_curves
from components.walks.findings import findings
from components.walks.judging import lesson_of
from components.walks.links import Scenes, scene_at
from components.walks.loading import WalkError, read_walk, steps_of
from components.walks.sketch import Sketch
from components.walks.types import BaseStep, ChoiceStep, NumberStep, PointStep, SketchStep, Step, Walk

MOST_SKETCHES = 500
"""Of one vote, that are told; all are counted."""
OF_A_KIND: dict[type[BaseStep], str] = {
    ChoiceStep: "option",
    NumberStep: "text",
    PointStep: "value",
    SketchStep: "curves",
}
"""The one field of an answer to a step of each kind."""


ReadWalks = Mapping[tuple[str, str], Walk]
"""Walks from files, by name and text."""


class Judged(Vote, frozen=True, kw_only=True):
    """An answer as it is kept: with the number that was typed, whether it is right, which of the features asked for a
    sketch has, and by which form of its step it was judged."""

    number: float = 0.0
    right: bool = False
    has: tuple[bool, ...] = ()
    form: str = ""


class QuestionBank:
    """All that a room must know of walks."""

    def __init__(self, walks: Walks, scenes: Scenes) -> None:
        self._walks = walks
        self._scenes = scenes
        self.apart: Apart = Here(walks, scenes)
        self._drawn = lru_cache(maxsize=64)(self._drawn_on)
        self._marked_on = lru_cache(maxsize=64)(self._axis_of)
        self.features = lru_cache(maxsize=64)(self._features)
        self._form = lru_cache(maxsize=512)(self._form_of)
        self._anew = lru_cache(maxsize=5000)(self._judged_anew)

    def read_own(self, own: Mapping[str, str], before: ReadWalks) -> ReadWalks:
        """Walks from files, their texts by name: those read before are not read again; WalkError for what is none."""
        known = steps_of(self._walks.values())
        return {(name, text): before.get((name, text)) or read_walk(text, name, known) for name, text in own.items()}

    def taking(self, own: ReadWalks) -> QuestionBank:
        """With walks from files."""
        return QuestionBank({**self._walks, **{name: walk for (name, _), walk in own.items()}}, self._scenes)

    async def try_own(self, name: str, text: str, network: str = "") -> Walk:
        """The walk of a file; WalkError, in words, for what is none to be asked."""
        replied = await wrap_future(self.apart.ask(Reading(name, text), network))
        if not replied.walk:
            raise WalkError(replied.refused)
        return replied.walk

    def step(self, walk: str, step: str) -> Step:
        """ValueError, in words, where there is none."""
        for one in self._walks[walk].steps if walk in self._walks else ():
            if one.id == step:
                return one
        raise ValueError(f"The step “{excerpt(step)}” cannot be asked in a class: the server does not know its walk.")

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
            pad = self._drawn(vote.walk, vote.step)[0]
            given = Given(walk=vote.walk, step=vote.step, curves=_strokes(vote.curves, pad))
        return lesson_of(step, given, self._scenes)

    def judge(self, vote: Vote) -> Judged:
        """An answer with what is to be known of it later; ValueError, in words, for what is none to its question."""
        step = self.step(vote.walk, vote.step)
        number, right, name = 0.0, False, OF_A_KIND[type(step)]
        has: tuple[bool, ...] = ()
        said = {"walk": vote.walk, "step": vote.step, "vote": vote.vote, name: getattr(vote, name)}
        fits = Vote(**said) == vote
        match step:
            case ChoiceStep():
                fits = fits and vote.option is not None and vote.option < len(step.options)
                right = fits and step.options[vote.option or 0].right
            case NumberStep():
                number = typed_number(vote.text, step.answer.unit)
                right = step.is_right(number)
            case PointStep():
                fits = fits and vote.value is not None
                right = fits and step.is_right(number_at(self._marked_on(vote.walk, vote.step), vote.value or 0.0))
            case SketchStep():
                fits = fits and bool(vote.curves) and _are_drawn(vote.curves, step.curves)
                has = self._seen(vote, step) if fits else ()
                right = all(has)
        if not fits:
            raise ValueError("This answer does not fit the question.")
        return Judged(**said, number=number, right=right, has=has, form=self._form(vote.walk, vote.step))

    def counted(self, walk: str, step: str, given: Sequence[Judged]) -> Counted:
        answered, asked = len(given), self.step(walk, step)
        match asked:
            case ChoiceStep():
                counts = Counter(one.option for one in given)
                return Counted(answered=answered, options=tuple(counts[i] for i in range(len(asked.options))))
            case SketchStep():
                sketches = tuple(SketchOf(curves=one.curves, has=one.has) for one in given[:MOST_SKETCHES])
                having = tuple(sum(each) for each in zip(*(one.has for one in given), strict=True))
                return Counted(answered=answered, sketches=sketches, having=having)
            case NumberStep():
                return Counted(answered=answered, numbers=tuple(one.number for one in given))
        return Counted(answered=answered, numbers=tuple(one.value for one in given if one.value is not None))

    def _features(self, walk: str, step: str) -> tuple[str, ...]:
        """What a right sketch has, by name."""
        return tuple(one.name for one in self.lesson(walk, step).findings)

    def read(self, kept: bytes) -> Judged | None:
        """An answer as it was kept; None where its step is another by now, to which it is no answer."""
        known = _JUDGED.decode(kept)
        return known if known.form == self._form(known.walk, known.step) else self._anew(kept)

    def _judged_anew(self, kept: bytes) -> Judged | None:
        known = msgspec.to_builtins(_JUDGED.decode(kept))
        try:
            return self.judge(Vote(**{name: known[name] for name in Vote.__struct_fields__}))
        except ValueError:
            return None

    def _form_of(self, walk: str, step: str) -> str:
        """What tells a step from the one of its name in a walk's file before."""
        try:
            return sha256(msgspec.json.encode(self.step(walk, step))).hexdigest()[:12]
        except ValueError:
            return "none"

    def _seen(self, vote: Vote, asked: SketchStep) -> tuple[bool, ...]:
        pad, field, true = self._drawn(vote.walk, vote.step)
        found = findings(asked, field.drawn(_strokes(vote.curves, pad), asked.curves), true, field)
        return tuple(one.has for one in found)

    def _axis_of(self, walk: str, step: str) -> Axis:
        """The axis that a place is marked on."""
        asked = self.step(walk, step)
        assert isinstance(asked, PointStep)
        axes = axes_of(scene_at(asked.state, self._scenes), asked.plot)
        return axes.x if asked.which == "x" else axes.y

    def _drawn_on(self, walk: str, step: str) -> tuple[PlotAxes, PlotAxes, Mapping[str, Sketch]]:
        """The axes that a sketch is drawn on, those of the picture that it is of, and the true curves."""
        asked = self.step(walk, step)
        assert isinstance(asked, SketchStep)
        scene = scene_at(asked.state, self._scenes)
        return pad_axes(asked, scene), axes_of(scene, asked.plot), true_curves(asked, scene)


_JUDGED = msgspec.json.Decoder(Judged)


def _are_drawn(curves: Mapping[str, Sketched], names: Sequence[str]) -> bool:
    return all(name in names and len(curve) == HEIGHTS for name, curve in curves.items())


def _strokes(curves: Mapping[str, Sketched], pad: PlotAxes) -> dict[str, Stroke]:
    """Heights in thousandths of the pad as places on its axes."""
    left, right = (pad.x.place(end) for end in (pad.x.start, pad.x.end))
    low, high = (pad.y.place(end) for end in (pad.y.start, pad.y.end))
    return {
        name: [
            (left + (right - left) * i / (HEIGHTS - 1), low + (high - low) * height / 1000)
            for i, height in enumerate(heights)
            if height is not None
        ]
        for name, heights in curves.items()
    }

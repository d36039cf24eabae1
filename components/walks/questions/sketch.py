"""The question for a curve, drawn on the empty axes of a plot and judged by its features."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Annotated, Any

from msgspec import Meta

from components.language.class_messages import Counted, SketchOf
from components.language.messages import HEIGHTS, Given
from components.language.walk import Lesson, StepCard
from components.quantities.formatting import excerpt
from components.walks.features import Feature
from components.walks.questions.question import UNFIT, Judged, Judgement, Question, Written, astray, refused
from components.walks.sketch import Sketch
from components.walks.subject import Subject
from components.walks.types import Reply, Sentence

MOST_SKETCHES = 500
"""Number of sketches of one vote that are sent; all are counted."""
Curves = Mapping[str, Sketch]


class Wrong(Reply, frozen=True, kw_only=True):
    """A frequent wrong sketch: the features that it has, the kinds of required features that it lacks, and its
    reply."""

    draws: Sentence
    has: tuple[Feature, ...] = ()
    fails: Annotated[tuple[str, ...], Meta(min_length=1)]
    idea: Sentence
    reply: Sentence


class SketchStep(Question, frozen=True, kw_only=True, tag="sketch"):
    """A curve to draw on the empty axes of a plot, then a `second` one if given."""

    takes = "curves"
    usual_minutes = 4.0
    plot: str
    curve: str
    second: str = ""
    must: Annotated[tuple[Feature, ...], Meta(min_length=1)]
    wrong: tuple[Wrong, ...] = ()

    @property
    def curves(self) -> tuple[str, ...]:
        return (self.curve, self.second) if self.second else (self.curve,)

    def links(self) -> Iterator[str]:
        yield from super().links()
        yield from (wrong.where for wrong in self.wrong if wrong.where)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, feature in enumerate(self.must):
            yield f"must[{i}].says", feature.says
        for i, wrong in enumerate(self.wrong):
            yield f"wrong[{i}].reply", wrong.reply

    def problems(self, subject: Subject) -> Iterator[str]:
        try:
            true = subject.true(self.plot, self.curves)
        except ValueError as reason:
            yield f"curve: {reason}."
            return
        for i, feature in enumerate(self.must):
            if self._on(feature) not in true:
                yield f"must[{i}].on: “{excerpt(self._on(feature))}” is not drawn."
            elif strange := [*refused(f"must[{i}]", partial(self.told, [feature], subject))]:
                yield from strange
            elif not all(self.seen(self.told([feature], subject), true)):
                yield f"must[{i}]: the scene's own curve does not have this feature."
        yield from astray("wrong", self.wrong, subject)
        kinds = {feature.kind for feature in self.must}
        for i, wrong in enumerate(self.wrong):
            yield from refused(f"wrong[{i}].has", partial(self.told, wrong.has, subject))
            strange = [feature.on for feature in wrong.has if self._on(feature) not in true]
            yield from (f"wrong[{i}].has: “{excerpt(on)}” is not drawn." for on in strange)
            yield from (f"wrong[{i}].fails: “{kind}” is not in must." for kind in wrong.fails if kind not in kinds)

    def card(self, subject: Subject, **step: Any) -> StepCard:
        pad = subject.pad(self.plot)
        return StepCard(plot=self.plot, curves=self.curves, frame=(pad.x.ruler, pad.y.ruler), **step)

    def judge(self, given: Given, subject: Subject) -> Judgement:
        if any(name not in self.curves or len(curve) != HEIGHTS for name, curve in given.curves.items()):
            raise ValueError(UNFIT)
        drawn = subject.drawn(self.plot, given.curves, self.curves)
        has = self.seen(self.told(self.must, subject), drawn)
        missed = {feature.kind for feature, found in zip(self.must, has, strict=True) if not found}
        wrong = self._wrong(drawn, missed, subject)
        return Judgement(all(has), has=has, reply=wrong.reply, where=wrong.where)

    def told(self, features: Iterable[Feature], subject: Subject) -> tuple[Feature, ...]:
        """Return features with evaluated expressions. Raises ValueError, with a reason, for other texts."""
        axes = subject.axes(self.plot)
        return tuple(feature.worked_out(subject.numbers_asked, axes) for feature in features)

    def seen(self, features: Iterable[Feature], drawn: Curves) -> tuple[bool, ...]:
        """Return for each feature whether the sketch has it."""
        return tuple(feature.seen(drawn[self._on(feature)]).has for feature in features)

    def _on(self, feature: Feature) -> str:
        """Return the curve of a feature."""
        return feature.on or self.curve

    def _wrong(self, drawn: Curves, missed: set[str], subject: Subject) -> Reply:
        """Return the reply to the frequent wrong sketch that matches this one best: it has only features that this one
        has, and lacks most of those that this one lacks.
        """
        fails = (one for one in self.wrong if missed.issuperset(one.fails))
        alike = [one for one in fails if all(self.seen(self.told(one.has, subject), drawn))]
        return max(alike, key=lambda one: len(one.fails)) if alike else Reply()

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        axes, true = subject.axes(self.plot), subject.true(self.plot, self.curves)
        drawn = subject.drawn(self.plot, given.curves, self.curves)
        must = self.told(self.must, subject)
        found = (feature.finding(drawn[on], true[on], axes) for feature in must if (on := self._on(feature)))
        return Lesson(findings=tuple(found), **step)

    def count(self, given: Sequence[Judged]) -> Counted:
        sketches = tuple(SketchOf(curves=one.curves, has=one.has) for one in given[:MOST_SKETCHES])
        having = tuple(sum(each) for each in zip(*(one.has for one in given), strict=True))
        return Counted(answered=len(given), sketches=sketches, having=having)

    def written(self, given: Judged, subject: Subject) -> Written:
        """Return the points of each curve, horizontal and vertical."""
        axes = subject.pad(self.plot)
        across, up = axes.x.factor, axes.y.factor
        told = (
            f"{name}: " + "; ".join(f"{x * across:.4g} {y * up:.4g}" for x, y in axes.numbers(curve))
            for name, curve in given.curves.items()
        )
        return Written(" | ".join(told), "SI")

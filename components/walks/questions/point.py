"""The question for a position on an axis of a plot. The answer may set a parameter to this position."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal

from msgspec import Meta
from msgspec.structs import replace

from components.language.class_messages import Counted
from components.language.messages import Given
from components.language.walk import Lesson, StepCard
from components.quantities.axes import Axis
from components.quantities.formatting import excerpt
from components.quantities.typed import unit_size
from components.walks.questions.number import NumericStep
from components.walks.questions.question import Judged, Written
from components.walks.subject import Subject, number_at, place_of


class PointStep(NumericStep, frozen=True, kw_only=True, tag="point"):
    """A place to mark on an axis of a plot: `axis` is "swing.x" for the horizontal one of the plot swing.

    After the answer, the parameter that it `sets` has the marked value.
    """

    takes = "value"
    usual_minutes = 2.0
    axis: Annotated[str, Meta(pattern=r"^\w+\.[xy]$")]
    sets: str = ""

    @property
    def plot(self) -> str:
        return self.axis.partition(".")[0]

    @property
    def which(self) -> Literal["x", "y"]:
        return "x" if self.axis.endswith(".x") else "y"

    def on(self, subject: Subject) -> Axis:
        """The axis to mark."""
        axes = subject.axes(self.plot)
        return axes.x if self.which == "x" else axes.y

    def number(self, given: Given, subject: Subject) -> float:
        return number_at(self.on(subject), given.value or 0.0)

    def problems(self, subject: Subject) -> Iterator[str]:
        yield from super().problems(subject)
        if self.sets and self.sets not in subject.page_state.kind.linked():
            yield f"sets: “{excerpt(self.sets)}” is not a parameter."
        try:
            axis = self.on(subject)
        except ValueError as reason:
            yield f"axis: {reason}."
            return
        low, high = sorted((axis.place(axis.start), axis.place(axis.end)))
        try:
            places = (*self.right(subject), *self.wrong(subject))
        except ValueError:
            return  # reported already
        for value in places:
            if not low <= place_of(axis, value) <= high:
                yield f"answer: {value:g} lies outside the axis."

    def doubts(self, subject: Subject) -> Iterator[str]:
        yield from super().doubts(subject)
        value = subject.numbers.get(self.sets, 0.0) / unit_size(self.answer.unit)
        if self.sets and not self.is_near(value, self.right(subject)):
            yield f"reveal: there {self.sets} is {value:g}; the answer is {self.truth(subject)}."

    def card(self, subject: Subject, **step: Any) -> StepCard:
        return StepCard(unit=self.answer.unit, plot=self.plot, axis=self.which, **step)

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        axis, shows = self.on(subject), None
        if self.sets and given.value is not None:
            state, number = subject.answer, self.number(given, subject)
            shows = replace(state, parameters={**state.parameters, self.sets: number * axis.factor})
        places = tuple(place_of(axis, one) for one in self.right(subject))
        return Lesson(truth=self.truth(subject), places=places, shows=shows, **step)

    def count(self, given: Sequence[Judged]) -> Counted:
        """The right positions on the axis."""
        return Counted(answered=len(given), numbers=tuple(one.value or 0.0 for one in given))

    def written(self, given: Judged, subject: Subject) -> Written:
        return Written(f"{given.number:.6g}", self.answer.unit)

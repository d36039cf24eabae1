"""A walk, its steps, the four kinds of question and the features of a sketch, as its TOML file has them.

Places and values are in the unit written at the axis (without its power of ten), numbers asked for in the unit that
their answer names.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct, field

Slug: TypeAlias = Annotated[str, Meta(pattern=r"^[a-z0-9][a-z0-9-]*$", max_length=40)]
Sentence: TypeAlias = Annotated[str, Meta(min_length=1, max_length=600)]
Address: TypeAlias = Annotated[str, Meta(max_length=8000)]
"""A link, as long as a server takes one: components/serving/pages.py."""
Slide: TypeAlias = Annotated[str, Meta(pattern=r"^[A-Z0-9]+-N?\d+$")]
Above0: TypeAlias = Annotated[float, Meta(gt=0)]


class Entry(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Whatever stands in a walk's file: a field that is not known is a mistake."""


class OptionEntry(Entry, frozen=True, kw_only=True):
    """An answer to choose: the right one, or one with its own sentence, `reply`, the misconception behind it, and
    `where` it would be right: a link."""

    text: Sentence
    right: bool = False
    idea: str = ""
    reply: str = ""
    where: Address = ""


class AnswerEntry(Entry, frozen=True, kw_only=True):
    """A number, or several of which each is right, and how far off still counts."""

    value: Annotated[tuple[float, ...], Meta(min_length=1)] = field(name="is")
    tol: Above0
    unit: str = ""


class Miss(Entry, frozen=True, kw_only=True):
    """A wrong number that is often given, with the sentence that is its own."""

    value: float = field(name="is")
    idea: Sentence
    reply: Sentence


class Wrong(Entry, frozen=True, kw_only=True):
    """A sketch that is often drawn: the features that it has, the kinds of those asked for that it fails, and the
    sentence that is its own."""

    draws: Sentence
    has: tuple[Feature, ...] = ()
    fails: Annotated[tuple[str, ...], Meta(min_length=1)]
    idea: Sentence
    reply: Sentence


class Asked(Entry, frozen=True, kw_only=True, tag_field="f"):
    """A feature that a right sketch has: `says` names it, `on` the curve that is meant where two are drawn."""

    says: str = ""
    on: str = ""


class ValueAt(Asked, frozen=True, kw_only=True, tag="value"):
    """As high as `is` there."""

    at: float
    value: float = field(name="is")
    tol: Above0


class Slope(Asked, frozen=True, kw_only=True, tag="slope"):
    """Upwards or downwards from there on."""

    at: float
    way: Literal["up", "down"] = field(name="is")


class Zero(Asked, frozen=True, kw_only=True, tag="zero"):
    """Through zero there."""

    at: float
    tol: Above0


class Extreme(Asked, frozen=True, kw_only=True):
    """A turning point there, as high as `is`."""

    at: float
    value: float = field(name="is")
    tol: Above0
    tol_y: Above0


class Peak(Extreme, frozen=True, kw_only=True, tag="peak"):
    """The highest of its surroundings."""


class Trough(Extreme, frozen=True, kw_only=True, tag="trough"):
    """The lowest of its surroundings."""


class Pole(Asked, frozen=True, kw_only=True, tag="pole"):
    """Out through the top of the frame there."""

    at: float
    tol: Above0


class Within(Asked, frozen=True, kw_only=True):
    """Something of the part between two places."""

    start: float | None = field(default=None, name="from")
    end: float | None = field(default=None, name="to")


class Period(Within, frozen=True, kw_only=True, tag="period"):
    """One swing takes as long as `is`."""

    value: Above0 = field(name="is")
    tol: Above0


class Farthest(Within, frozen=True, kw_only=True, tag="reach"):
    """The farthest from zero is `is`."""

    value: float = field(name="is")
    tol: Above0


class Least(Asked, frozen=True, kw_only=True, tag="least"):
    """The lowest of all is `is`."""

    value: float = field(name="is")
    tol: Above0


class Sum(Asked, frozen=True, kw_only=True, tag="sum"):
    """With the other curve it adds up to `is` everywhere."""

    other: str = field(name="with")
    value: float = field(name="is")
    tol: Above0


Feature: TypeAlias = ValueAt | Slope | Zero | Peak | Trough | Pole | Period | Farthest | Least | Sum


class BaseStep(Entry, frozen=True, kw_only=True, tag_field="kind"):
    """One idea: a question, the state that it is asked of, what is covered until it is answered, and what it means.

    `state` and `reveal` are links: what is shown with the question and, where that is something else, with the answer.
    `controls` are the parameters that may be moved after the answer, `next` says what to try with the first of them.
    """

    id: Slug
    title: Sentence
    question: Sentence
    state: Address
    explain: Sentence
    follows: Annotated[str, Meta(max_length=2000)] = ""
    next: str = ""
    slides: tuple[Slide, ...] = ()
    reveal: Address = ""
    cover: tuple[str, ...] = ()
    controls: Annotated[tuple[str, ...], Meta(max_length=3)] = ()
    minutes: float | None = None

    @property
    def shown(self) -> str:
        """The link of what is shown with the answer."""
        return self.reveal or self.state

    def links(self) -> Iterator[str]:
        """Every link."""
        yield from (self.state, self.shown)

    @property
    def equations(self) -> tuple[str, ...]:
        """The lines of `follows`, each a formula."""
        return tuple(line for line in map(str.strip, self.follows.splitlines()) if line)

    def sentences(self) -> Iterator[tuple[str, str]]:
        """Every text by the name of its field."""
        for name in ("title", "question", "explain", "next"):
            yield name, getattr(self, name)


class ChoiceStep(BaseStep, frozen=True, kw_only=True, tag="choice"):
    """One of a few answers."""

    options: Annotated[tuple[OptionEntry, ...], Meta(min_length=2, max_length=5)]

    def links(self) -> Iterator[str]:
        yield from super().links()
        yield from (option.where for option in self.options if option.where)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, option in enumerate(self.options):
            yield f"options[{i}].text", option.text
            yield f"options[{i}].reply", option.reply


class NumericStep(BaseStep, frozen=True, kw_only=True):
    """A number: typed, or a place on an axis."""

    answer: AnswerEntry
    misses: tuple[Miss, ...] = ()

    def is_right(self, number: float) -> bool:
        return any(abs(number - one) <= self.answer.tol for one in self.answer.value)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, miss in enumerate(self.misses):
            yield f"misses[{i}].reply", miss.reply


class NumberStep(NumericStep, frozen=True, kw_only=True, tag="number"):
    """A number to type."""


class PointStep(NumericStep, frozen=True, kw_only=True, tag="point"):
    """A place to mark on an axis of a plot: `axis` is "swing.x" for the horizontal one of the plot swing.

    With the answer the parameter that it `sets` is shown at the place that was marked.
    """

    axis: Annotated[str, Meta(pattern=r"^\w+\.[xy]$")]
    sets: str = ""

    @property
    def plot(self) -> str:
        return self.axis.partition(".")[0]

    @property
    def which(self) -> Literal["x", "y"]:
        return "x" if self.axis.endswith(".x") else "y"


class SketchStep(BaseStep, frozen=True, kw_only=True, tag="sketch"):
    """A curve to draw on the empty axes of a plot, `second` after it where two are asked for."""

    plot: str
    curve: str
    second: str = ""
    must: Annotated[tuple[Feature, ...], Meta(min_length=1)]
    wrong: tuple[Wrong, ...] = ()

    @property
    def curves(self) -> tuple[str, ...]:
        return (self.curve, self.second) if self.second else (self.curve,)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, feature in enumerate(self.must):
            yield f"must[{i}].says", feature.says
        for i, wrong in enumerate(self.wrong):
            yield f"wrong[{i}].reply", wrong.reply


Step: TypeAlias = ChoiceStep | NumberStep | PointStep | SketchStep
MINUTES = {"choice": 2.0, "point": 2.0, "number": 3.0, "sketch": 4.0}
"""How long a question of a kind takes, where its step says nothing else."""


def kind_of(step: BaseStep) -> str:
    return str(step.__struct_config__.tag)


def minutes_of(step: BaseStep) -> float:
    return step.minutes or MINUTES[kind_of(step)]


class Walk(Struct, frozen=True, kw_only=True):
    """Steps in their order, under the name by which a link asks for them."""

    name: str
    title: str
    steps: tuple[Step, ...]

    def place(self, asked: str) -> int | None:
        """Where the step of an id, or of a number from 1 on, stands."""
        ids = [step.id for step in self.steps]
        if asked in ids:
            return ids.index(asked)
        return int(asked) - 1 if asked.isdecimal() and 1 <= int(asked[:6]) <= len(ids) else None

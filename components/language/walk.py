"""A guided walk: what is asked at each step, and what a session says of an answer."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from components.language.picture import Ruler
from components.language.state import State
from components.language.text import Html


class StepCard(Struct, frozen=True, kw_only=True):
    """The card of a step, before its answer.

    `place` says where in the lecture it is, `given` stands over the question, `options` are the answers of a choice,
    shown in another order unless they are `fixed`, none of them right in a `poll`, `unit` is that of a number; `plot`
    is where a point is marked or a sketch drawn, `axis` the one of the point, `curves` what is drawn, by name, and
    `frame` the axes x and y of a sketch that a class shares. `opens` is the state that the question is asked of,
    `reveals` the one of the answer, where the parameters in `controls` may be moved. The `core` steps make a shorter
    walk. A step with `derive` shows how its answer follows by one more press; a vote on one that `closes` is closed at
    the end of a countdown. `variants` are cards of its question with other numbers, under the seeds from 1 on.
    """

    id: str
    kind: str
    place: str
    scene: str
    given: Html
    question: Html
    minutes: float
    core: bool = False
    derive: bool = False
    closes: bool = False
    opens: State
    reveals: State
    controls: tuple[str, ...]
    options: tuple[Html, ...] = ()
    fixed: bool = False
    poll: bool = False
    unit: str = ""
    plot: str = ""
    axis: Literal["", "x", "y"] = ""
    curves: tuple[str, ...] = ()
    frame: tuple[Ruler, Ruler] | None = None
    variants: tuple[StepCard, ...] = ()


class WalkSheet(Struct, frozen=True, kw_only=True):
    """A walk from its first step to its last, and the sentences on what it has shown."""

    name: str
    title: str
    steps: tuple[StepCard, ...]
    end: tuple[Html, ...] = ()


class Verdict(Struct, frozen=True, kw_only=True):
    """The verdict on one answer of a choice: its sentence, and the state of a case of which that speaks, if any."""

    right: bool
    reply: Html
    where: State | None = None


class Finding(Struct, frozen=True, kw_only=True):
    """A feature that a sketch has or misses: its name, what is said of it, and where in the plot it is, in places of
    its axes."""

    has: bool
    name: Html
    words: Html
    at: tuple[float, float] | None


class Lesson(Struct, frozen=True, kw_only=True):
    """The lesson of a step, told once it has been answered.

    `right` is None where nothing was answered; `reply` is the sentence of the answer given, `where` the state of a case
    of which it speaks; `verdicts` are those of the options, `findings` those of a sketch, `truth` the right number or
    places; `places` has them in the unit of the
    number, or on the axis of the point. `shows` is the state of the answer where that is not the card's `reveals`.
    """

    title: Html
    explain: Html
    follows: tuple[Html, ...]
    next: Html
    right: bool | None = None
    reply: Html = ""
    where: State | None = None
    verdicts: tuple[Verdict, ...] = ()
    findings: tuple[Finding, ...] = ()
    truth: str = ""
    shows: State | None = None
    places: tuple[float, ...] = ()

"""A guided walk: the question of each step, and the server's reply to an answer."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from components.language.picture import Ruler
from components.language.state import State
from components.language.text import Html


class StepCard(Struct, frozen=True, kw_only=True):
    """The card of a step, before its answer.

    `place` is its position in the lecture, `given` a text above the question. `options` are the answers of a choice,
    shown in random order unless `fixed`; in a `poll` none is right. `unit` is the unit of a number, `plot` the plot for
    a point or a sketch, `axis` the axis of the point, `curves` the curves to draw, by name, and `frame` the axes x and
    y of a sketch that a class shares. `opens` is the state for the question, `reveals` the one for the answer, in which
    the parameters in `controls` can be changed. The `core` steps make a shorter walk. A step with `derive` has one more
    press, which shows the derivation. If it `closes`, the end of a countdown closes the vote. `variants` are cards of
    its question with other numbers, for the seeds from 1 on.
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


class WalkTrial(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A scene to try after the last step: its slug, what to do there, and a sentence."""

    scene: str
    title: Html
    text: Html


class WalkSheet(Struct, frozen=True, kw_only=True):
    """A walk from its first step to its last, the sentences of its summary, and the scenes to try after it."""

    name: str
    title: str
    steps: tuple[StepCard, ...]
    end: tuple[Html, ...] = ()
    trials: tuple[WalkTrial, ...] = ()


class Verdict(Struct, frozen=True, kw_only=True):
    """The comment on one option of a choice, and the state of the case that it mentions, if any."""

    right: bool
    reply: Html
    where: State | None = None


class Finding(Struct, frozen=True, kw_only=True):
    """A feature that a sketch has or misses: its name, a comment, and its position in coordinates of the plot's
    axes."""

    has: bool
    name: Html
    words: Html
    at: tuple[float, float] | None


class Lesson(Struct, frozen=True, kw_only=True):
    """The lesson of a step, sent after its answer.

    `right` is None if no answer was given. `reply` is the sentence for the answer, `where` the state of a case that it
    mentions; `verdicts` are the comments on the options, `findings` those on a sketch, `truth` the right number or
    places; `places` has them in the unit of the number, or on the axis of the point. `shows` is the state of the answer
    if it is not the card's `reveals`.
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

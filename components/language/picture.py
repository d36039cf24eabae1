"""The picture of a scene as it is sent: all that a change of parameters changes, but for the columns of numbers."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from components.language.signals import AnySignal
from components.language.text import Html


class Ruler(Struct, frozen=True, kw_only=True):
    """An axis as it is drawn: places are numbers in units of `factor` (SI) times 10**exponent, raised to `power`, or
    their logarithms to base ten."""

    start: float
    end: float
    ticks: tuple[float, ...]
    labels: tuple[str, ...]
    unit: str
    exponent: int
    factor: float
    power: int
    log: bool


class Pace(Struct, frozen=True):
    """Simulated over real seconds: what the speed Auto plays at, and the fastest at which the motion can be seen."""

    auto: float = 1.0
    limit: float | None = None


class Digits(Struct, frozen=True, array_like=True):
    """The digits of a moving number: its decimals, and whether its sign always stands."""

    decimals: int
    signed: bool


class Progress(Struct, frozen=True, kw_only=True):
    """The progress of a measurement: so many of a total, counted in `unit`."""

    state: Literal["idle", "waiting", "running", "done"]
    done: int
    total: int
    unit: str
    text: str


class Drawn(Struct, frozen=True, array_like=True):
    """A column: the name of the axis that it is drawn on, and how many numbers it has."""

    axis: str
    count: int


class Trace(Struct, frozen=True, array_like=True):
    """Signals that are drawn over time, at `count` equally spaced instants from 0 to `end`: they are the column t, and
    columns of these names; `signals` are those that are called otherwise."""

    end: float
    count: int
    names: tuple[str, ...]
    signals: dict[str, str]


class PagePicture(Struct, frozen=True, kw_only=True):
    """A picture as the browser shows it.

    `columns`   the columns by source and name; their numbers follow the message, then those of the runs of `signals`
    `axes`      the axes by name; `time` is the name of the one that the clock runs through, "" where nothing moves
    `signals`   what moves, by name, in the order in which they build on each other
    `traces`    those of them that are drawn over time, by the source whose columns they are
    `scalars`   numbers that shapes and marks use
    `values`    texts of live numbers, by name; `live` is how those that move are shown, by signal
    `forms`     which variant of a formula or sentence stands, by name; "" hides it
    `notes`     what the visitor must know about this picture
    `left_out`  the quantities that are not sent because they are covered; a shape that needs one is not drawn
    """

    columns: dict[str, dict[str, Drawn]]
    axes: dict[str, Ruler]
    time: str
    pace: Pace
    signals: dict[str, AnySignal]
    traces: dict[str, Trace]
    scalars: dict[str, float]
    values: dict[str, str]
    live: dict[str, Digits]
    forms: dict[str, str]
    notes: tuple[str, ...]
    left_out: tuple[str, ...] = ()


class LedgerRow(Struct, frozen=True, kw_only=True):
    """A number of the picture held and of the one that stands, in `unit`, and what became of it; "?" is covered."""

    symbol: Html
    tint: str
    held: str
    now: str
    unit: str
    ratio: str
    same: bool


class Held(Struct, frozen=True, kw_only=True):
    """The picture held beside the one that stands, on its axes, as far as it differs and is drawn.

    Its numbers follow those of the view. `signals` and `scalars` are those of its `traces` and of what a hand can take
    on the stage, `values` the numbers of the sliders that have been moved since, `ledger` what is compared.
    """

    columns: dict[str, dict[str, Drawn]]
    signals: dict[str, AnySignal]
    traces: dict[str, Trace]
    scalars: dict[str, float]
    values: dict[str, float | None]
    ledger: tuple[LedgerRow, ...]

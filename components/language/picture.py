"""The picture of a scene in a message: everything that depends on the parameters, without the columns of numbers."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from components.language.signals import AnySignal
from components.language.text import Html


class Ruler(Struct, frozen=True, kw_only=True):
    """An axis as drawn: coordinates are numbers in units of `factor` (SI) times 10**exponent, raised to `power`, or
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
    """Simulated seconds per real second: at the speed Auto, and the highest at which the motion can still be seen."""

    auto: float = 1.0
    limit: float | None = None


class Digits(Struct, frozen=True, array_like=True):
    """The format of a moving number: its decimals, and if its sign is always shown."""

    decimals: int
    signed: bool


class Progress(Struct, frozen=True, kw_only=True):
    """The progress of a measurement: `done` of `total`, counted in `unit`."""

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
    """Signals that are drawn over time, at `count` equally spaced instants from 0 to `end`. They are the column t and
    columns of these names; `signals` maps a column to a signal with another name."""

    end: float
    count: int
    names: tuple[str, ...]
    signals: dict[str, str]


class Onward(Struct, frozen=True, kw_only=True):
    """A link to another scene: the values that it sets (`given`), and its parameters with those of this scene whose
    values they take (`taken`)."""

    label: str
    scene: str
    given: dict[str, float | str]
    taken: dict[str, str] = {}


class PagePicture(Struct, frozen=True, kw_only=True):
    """A picture for the browser.

    `columns`   the columns by source and name; their numbers are bytes after the message, before samples of `signals`
    `axes`      the axes by name; `time` is the name of the time axis, "" if nothing moves
    `signals`   the moving numbers by name; each may use the ones before it
    `traces`    for each source, the signals that are drawn over time
    `scalars`   numbers that shapes and marks use
    `values`    texts of live numbers, by name; `live` has the format of the moving ones, by signal
    `forms`     the current variant of a formula or sentence, by name; "" hides it
    `notes`     what the visitor must know about this picture
    `onward`    links to scenes that show the same system for these values
    `left_out`  the quantities that are not sent because they are hidden; shapes that need one are not drawn
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
    onward: tuple[Onward, ...] = ()
    left_out: tuple[str, ...] = ()


class LedgerRow(Struct, frozen=True, kw_only=True):
    """A number of the compared picture and of the current one, in `unit`, and the change; "?" means hidden."""

    symbol: Html
    tint: str
    held: str
    now: str
    unit: str
    ratio: str
    same: bool


class Held(Struct, frozen=True, kw_only=True):
    """The compared picture, on the axes of the current one: only its drawn curves, and only where they differ.

    Its numbers follow the numbers of the view. `signals` and `scalars` are for its `traces` and for draggable shapes on
    the stage, `values` the numbers of the sliders that have changed since, `ledger` the compared numbers.
    """

    columns: dict[str, dict[str, Drawn]]
    signals: dict[str, AnySignal]
    traces: dict[str, Trace]
    scalars: dict[str, float]
    values: dict[str, float | None]
    ledger: tuple[LedgerRow, ...]

"""Curves over time: signals that the browser draws, their exact numbers, and bands for fast motions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.language.expressions import Name
from components.language.plots import Curve, Region
from components.layout.plots import BAND as BAND
from components.layout.plots import FLOOR as FLOOR
from components.layout.plots import LATE as LATE
from components.layout.plots import RINGING as RINGING
from components.layout.plots import TIME as TIME
from components.layout.plots import curve
from components.quantities.declared import Signal, by_name
from physics.sampling import SAMPLES_PER_CYCLE, Sinusoid, curve_or_band, drawable

Floats = NDArray[np.float64]
Columns = dict[str, Floats]
FEWEST, MOST, PER_CYCLE = 300, 680, 32
PER_PERIOD, FIRST_PERIODS = 20, 10
"""Least number of rows of a file per period of the fastest motion, and the number of periods in it if the window has
too many."""


def samples(end: float, fastest: float) -> int:
    """Return how many points a plot of [0, end] needs: 32 per cycle of the fastest motion (rad/s), within limits."""
    return int(min(max(PER_CYCLE * end * float(fastest) / (2 * np.pi), FEWEST), MOST)) + 1


def resolved(end: float, fastest: float) -> bool:
    """Return True if the points over [0, end] resolve a motion of the frequency `fastest` (rad/s). If not, a band
    replaces its line."""
    return SAMPLES_PER_CYCLE * end * float(fastest) <= 2 * np.pi * (samples(end, fastest) - 1)


@dataclass(frozen=True, eq=False)
class Traces:
    """Curves that the browser draws from signals, at `count` instants of [0, end] (s), and the same motions in a file.

    `names`     the drawn curves
    `signals`   the signal of each curve, if it has another name
    `exact`     a function that returns the exact numbers at given instants in SI units, called when they are read
    `fastest`   the frequency (rad/s) that a file has to resolve
    `moving`    the columns of a file; None means the drawn ones
    `layers`    the lower and the upper edge of the band that shows a column of a file
    `averaged`  columns that the picture has itself, as means over a period
    `axis`      the axis of motions that a plot shows as colours, for their unit in a file
    """

    end: float
    count: int
    names: tuple[str, ...]
    exact: Callable[[Floats], Columns]
    signals: Mapping[str, str] = field(default_factory=dict)
    fastest: float = 0.0
    moving: tuple[str, ...] | None = None
    layers: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    averaged: frozenset[str] = frozenset()
    axis: str = ""

    @property
    def t(self) -> Floats:
        """The times of the drawn points (count,)."""
        return np.linspace(0.0, self.end, self.count)

    @cached_property
    def columns(self) -> Columns:
        """The times t, and the values of each curve at them."""
        return _frozen(self.t, self._exact_drawn if self.names else {}, self.names)

    @property
    def drawn(self) -> Columns:
        """The values of each curve without t, to be sent in place of its signal."""
        return {name: column for name, column in self.columns.items() if name in self.names}

    @property
    def whole(self) -> bool:
        """True if a file resolves all motions over the whole window."""
        return PER_PERIOD * self.end * self.fastest <= 2 * np.pi * (self.count - 1)

    @cached_property
    def file(self) -> Columns:
        """Return the instants t and the numbers of all motions for a file: at most 1281 rows.

        Each period of the fastest motion has at least 20 rows. If the window is too long for that, the rows are the
        first 10 periods.
        """
        names = self.names if self.moving is None else self.moving
        if not names:
            return {"t": self.t}
        t = self._instants
        return _frozen(t, self._exact_drawn if self.whole else self.exact(t), names)

    @property
    def _instants(self) -> Floats:
        if not self.whole:
            last = FIRST_PERIODS * 2 * np.pi / self.fastest
            return np.linspace(0.0, last, FIRST_PERIODS * PER_PERIOD + 1)
        return self.t

    @cached_property
    def _exact_drawn(self) -> Columns:
        return self.exact(self.t)

    @property
    def needed(self) -> frozenset[str]:
        """The names of the signals of the curves."""
        return frozenset(self.signals.get(name, name) for name in self.names)

    def less(self, names: Iterable[str]) -> Traces:
        """Return the object without these curves, also in a file."""
        gone = frozenset(names)
        moving = self.moving and tuple(name for name in self.moving if not gone.intersection(self.edges(name)))
        return replace(self, names=tuple(name for name in self.names if name not in gone), moving=moving)

    def edges(self, name: str) -> tuple[str, ...]:
        """Return the columns that show a motion: its curve, or the edges of its layer."""
        return self.layers.get(name, (name,))


def _frozen(t: Floats, exact: Columns, names: Iterable[str]) -> Columns:
    columns = {"t": t, **{name: exact[name] for name in names}}
    for column in columns.values():
        column.setflags(write=False)
    return columns


def over_time(
    end: float, fastest: float, signals: Iterable[Name], exact: Callable[[Floats], Mapping[Signal[Any], Floats]],
    source: str = TIME, moving: Iterable[Name] | None = None, layers: Mapping[Any, tuple[Name, Name]] | None = None,
    averaged: Iterable[Name] = (), moves: float | None = None,
) -> dict[str, Traces]:  # fmt: skip
    """Return the curves of a source: these signals over [0, end], dense enough for the `fastest` motion (rad/s).

    `exact` has the exact numbers of each signal. `moving` are the motions of a file, including motions too fast to
    be drawn; `layers` are motions that a plot shows between two edges, `averaged` the means. `moves` is the frequency
    (rad/s) that a file resolves; it defaults to `fastest`.
    """
    between = {one.name: (low.name, high.name) for one, (low, high) in (layers or {}).items()}
    found = Traces(
        end,
        samples(end, fastest),
        names_of(signals),
        lambda t: by_name(exact(t)),
        fastest=fastest if moves is None else moves,
        moving=None if moving is None else names_of(moving),
        layers=between,
        averaged=frozenset(names_of(averaged)),
    )
    return {source: found}


def names_of(signals: Iterable[Name]) -> tuple[str, ...]:
    return tuple(one.name for one in signals)


def trace(
    one: Name, components: Sequence[Sinusoid], t: Floats, base: Floats | None = None, curve: Floats | None = None
) -> tuple[Columns, Columns]:
    """Return columns of the curve of a signal, and of its band (named by `band_columns`): one of the two is empty.

    `curve` is the motion itself, if it is known to more digits than the sum of the components.
    """
    if curve is not None and drawable(max((component.omega for component in components), default=0.0), t):
        return {one.name: curve}, {}
    sum_, low, high = curve_or_band(components, t, base)
    if sum_ is not None:
        return {one.name: sum_}, {}
    return {}, dict(zip(band_columns(one.name), (low, high), strict=True))


def bands_over_time(t: Floats, bands: Columns) -> dict[str, Columns]:
    """Return the source of the bands, empty if there are none."""
    return {BAND: bands and {"t": t, **bands}}


def bands_about_zero(t: Floats, reach: Mapping[Any, Floats | float]) -> dict[str, Columns]:
    """Return the source of the bands of signals between minus and plus these amplitudes."""
    bands = Columns()
    for one, size in by_name(reach).items():
        high = np.full_like(t, size)
        bands |= dict(zip(band_columns(one), (-high, high), strict=True))
    return bands_over_time(t, bands)


def band_columns(name: str) -> tuple[str, str]:
    """Return the columns of the band that replaces the curve `name`."""
    return f"{name}_lo", f"{name}_hi"


def band(one: Name, source: str = BAND, **look: Any) -> Region:
    """Return the band of a signal, for a plot."""
    low, high = band_columns(one.name)
    return Region(source=source, x="", low=low, high=high, alpha=0.4, **look)


def traced(one: Name, **look: Any) -> tuple[Curve, Region]:
    """Return the line of a signal over time and its band, for a plot."""
    line = curve(one, **look)
    return line, band(one, tint=line.tint, group=line.group, of=one.name)

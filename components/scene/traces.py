"""Curves over time: signals that the browser draws, and the physics' numbers of them; bands for what is too fast."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.language.numbers import Name
from components.language.plots import Curve, Region
from components.layout.plots import curve
from components.quantities.declared import Signal, by_name
from physics.sampling import SAMPLES_PER_CYCLE, Sinusoid, curve_or_band, drawable

Floats = NDArray[np.float64]
Columns = dict[str, Floats]
BAND = "band"
"""The source of the bands that stand for curves too fast to be drawn."""
FEWEST, MOST, PER_CYCLE = 300, 680, 32


def samples(end: float, fastest: float) -> int:
    """The times that a plot of [0, end] needs: 32 a cycle of the fastest motion (rad/s), within what a screen shows."""
    return int(min(max(PER_CYCLE * end * float(fastest) / (2 * np.pi), FEWEST), MOST)) + 1


def resolved(end: float, fastest: float) -> bool:
    """Whether these samples show a motion so fast (rad/s) as a line: if not, a band stands for it."""
    return SAMPLES_PER_CYCLE * end * float(fastest) <= 2 * np.pi * (samples(end, fastest) - 1)


@dataclass(frozen=True, eq=False)
class Traces:
    """Curves that the browser draws of signals, at `count` instants of [0, end] (s).

    A curve has the name of its signal, or `signals` says what that is called. `exact` gives the physics' numbers of
    each curve at any instants, in SI units: they are asked for when they are read.
    """

    end: float
    count: int
    names: tuple[str, ...]
    exact: Callable[[Floats], Columns]
    signals: Mapping[str, str] = field(default_factory=dict)

    @property
    def t(self) -> Floats:
        """The instants that are drawn (count,)."""
        return np.linspace(0.0, self.end, self.count)

    @cached_property
    def columns(self) -> Columns:
        """The instants t and the numbers of each curve there."""
        exact = self.exact(self.t)
        columns = {"t": self.t, **{name: exact[name] for name in self.names}}
        for column in columns.values():
            column.setflags(write=False)
        return columns

    @property
    def needed(self) -> frozenset[str]:
        """The signals that the curves are drawn of."""
        return frozenset(self.signals.get(name, name) for name in self.names)

    def less(self, names: Iterable[str]) -> Traces:
        """Without some of the curves."""
        gone = frozenset(names)
        return replace(self, names=tuple(name for name in self.names if name not in gone))


def over_time(
    end: float, fastest: float, signals: Iterable[Name], exact: Callable[[Floats], Mapping[Signal[Any], Floats]],
    source: str = "time",
) -> dict[str, Traces]:  # fmt: skip
    """The curves of a source: these signals over [0, end], dense enough for the `fastest` motion (rad/s).

    `exact` gives the physics' numbers of each signal.
    """
    names = tuple(one.name for one in signals)
    return {source: Traces(end, samples(end, fastest), names, lambda t: by_name(exact(t)))}


def trace(
    one: Name, components: Sequence[Sinusoid], t: Floats, base: Floats | None = None, curve: Floats | None = None
) -> tuple[Columns, Columns]:
    """Columns of the curve of a signal, and of its band, as `band_columns` calls them: one of the two is empty.

    `curve` is the motion itself, where its owner has it to more digits than the sum of the components.
    """
    if curve is not None and drawable(max((component.omega for component in components), default=0.0), t):
        return {one.name: curve}, {}
    sum_, low, high = curve_or_band(components, t, base)
    if sum_ is not None:
        return {one.name: sum_}, {}
    return {}, dict(zip(band_columns(one.name), (low, high), strict=True))


def bands_over_time(t: Floats, bands: Columns) -> dict[str, Columns]:
    """The source of the bands, empty where there are none."""
    return {BAND: bands and {"t": t, **bands}}


def bands_about_zero(t: Floats, reach: Mapping[Any, Floats | float]) -> dict[str, Columns]:
    """The source of the bands of signals that swing so far to both sides of 0."""
    bands = Columns()
    for one, size in by_name(reach).items():
        high = np.full_like(t, size)
        bands |= dict(zip(band_columns(one), (-high, high), strict=True))
    return bands_over_time(t, bands)


def band_columns(name: str) -> tuple[str, str]:
    """The columns of the band that stands for the curve `name`."""
    return f"{name}_lo", f"{name}_hi"


def band(one: Name, source: str = BAND, **look: Any) -> Region:
    """The band of a signal, for a plot."""
    low, high = band_columns(one.name)
    return Region(source=source, x="", low=low, high=high, alpha=0.4, **look)


def traced(one: Name, **look: Any) -> tuple[Curve, Region]:
    """The line of a signal over time and its band, for a plot."""
    line = curve(one, **look)
    return line, band(one, tint=line.tint, group=line.group, of=one.name)

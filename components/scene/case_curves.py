"""The numbers of the plots of a picture: curves over time, bands and means of what is too fast, pairs of columns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple

from components.scene.traces import BAND, FLOOR, LATE, RINGING, TIME, Columns, Floats, Traces, band_columns
from physics.motion import ExactMotion
from physics.sampling import highest_drawn
from physics.valid import in_range


def exact_values(motions: Mapping[str, ExactMotion], t: Floats) -> Columns:
    """Return the numbers of motions at these instants. ValueError if they leave the range of doubles."""
    return {name: in_range(name, one.at(t)) for name, one in motions.items()}


class BandColumns(NamedTuple):
    """The lower and the upper edge of a band (n,) over the instants of a picture.

    `late` (m,) are the values of the motion at the last m of them, if a line shows it there because what is too fast
    has died. All such motions of a picture have the same instants.
    """

    low: Floats
    high: Floats
    late: Floats | None = None


@dataclass(frozen=True, eq=False)
class CaseCurves:
    """The curves of a picture over the instants `t` (n,) in s.

    `drawn` are the curves and the edges of stacks, in the order of their columns. `fast` says how each is drawn if it
    is too fast for a line: as its band, as a band that ends in a line, as its mean, or not at all. `stacks` are edges
    that are averaged together. `motions` are all motions of the picture; `layers` maps motions in a stack to their
    lower and upper edge. `given` are the bands if the case knows them, else they follow from the frequencies. Files
    have the motions that are drawn and `named`.
    """

    t: Floats
    drawn: Mapping[str, ExactMotion]
    fast: Mapping[str, str]
    stacks: list[frozenset[str]]
    motions: Mapping[str, ExactMotion]
    layers: Mapping[str, tuple[str, str]]
    named: frozenset[str]
    given: Mapping[str, BandColumns] | None = None

    @cached_property
    def highest(self) -> float:
        """The highest frequency in rad/s that these instants show as a line."""
        return highest_drawn(self.t)

    @cached_property
    def too_fast(self) -> frozenset[str]:
        """The motions that these instants do not resolve."""
        if self.given is not None:
            return frozenset(self.given.keys() & self.drawn.keys())
        return frozenset(name for name, one in self.drawn.items() if one.omega > self.highest)

    @cached_property
    def averaged(self) -> frozenset[str]:
        """The motions that are drawn as means."""
        fast = frozenset(name for name in self.too_fast if self.fast.get(name) == "mean")
        stacked = (stack for stack in self.stacks if stack & fast)
        return fast.union(*stacked) & self.drawn.keys()

    def traces(self, resolved: float) -> Traces:
        """Return the motions drawn as lines, and the motions of a file with a sampling for this frequency (rad/s)."""
        shown = {name: one for name, one in self.motions.items() if name in self.drawn or name in self.layers}
        return Traces(
            float(self.t[-1]),
            len(self.t),
            tuple(name for name in self.drawn if name not in self.too_fast | self.averaged),
            partial(exact_values, shown),
            fastest=resolved,
            moving=tuple(name for name in shown if name in self.named and name != FLOOR),
            layers=self.layers,
            averaged=self.averaged,
        )

    @property
    def columns(self) -> dict[str, Columns]:
        """The numbers that no signal gives, by source."""
        means = {name: one.mean.at(self.t) for name, one in self.drawn.items() if name in self.averaged}
        return self._bands | ({TIME: means} if means else {})

    @property
    def _bands(self) -> dict[str, Columns]:
        """The bands over the whole window, the bands that end when motions have decayed, and the lines from there."""
        whole, ringing, late = Columns(), Columns(), Columns()
        for name in self.drawn:
            band = self._band(name) if name in self.too_fast and self.fast.get(name) in (BAND, RINGING) else None
            if band is None:
                continue
            columns = {"t": self.t, **dict(zip(band_columns(name), band[:2], strict=True))}
            if band.late is None:
                whole |= columns
            else:
                first = len(self.t) - len(band.late)
                ringing |= {key: column[: first + 1] for key, column in columns.items()}
                late |= {"t": self.t[first:], name: band.late}
        return {BAND: whole} | ({RINGING: ringing, LATE: late} if RINGING in self.fast.values() else {})

    def _band(self, name: str) -> BandColumns | None:
        if self.given is not None:
            return self.given[name]
        edges = self.drawn[name].band(self.highest)
        return BandColumns(*(edge.at(self.t) for edge in edges)) if edges else None

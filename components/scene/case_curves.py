"""The numbers of a picture's plots: curves over time, bands and means of fast motions, pairs of columns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, NamedTuple

from components.scene.traces import BAND, FLOOR, LATE, RINGING, TIME, Columns, Floats, Traces, band_columns
from physics.motion import ExactMotion
from physics.valid import in_range


def exact_values(motions: Mapping[str, ExactMotion], t: Floats) -> Columns:
    """Return the numbers of motions at these instants. Raises ValueError if one leaves the range of doubles."""
    return {name: in_range(name, one.at(t)) for name, one in motions.items()}


class BandColumns(NamedTuple):
    """The lower and the upper edge of a band (n,) at the times of a picture.

    `late` (m,) are the values of the motion at the last m times, if its fast part has decayed by then and it is drawn
    as a line. m is the same for all such motions of a picture.
    """

    low: Floats
    high: Floats
    late: Floats | None = None


@dataclass(frozen=True, eq=False)
class CaseCurves:
    """The curves of a picture over the instants of a case.

    `drawn`    the curves and the edges of stacks, in the order of their columns
    `fast`     how each is drawn if it is too fast for a line: as a band, as a band that ends in a line, as its mean,
               or not at all
    `stacks`   edges that are averaged together
    `motions`  all motions of the picture
    `layers`   the lower and the upper edge of each motion in a stack
    `named`    the motions that a file has, if they are drawn
    """

    case: Any
    drawn: Mapping[str, ExactMotion]
    fast: Mapping[str, str]
    stacks: list[frozenset[str]]
    motions: Mapping[str, ExactMotion]
    layers: Mapping[str, tuple[str, str]]
    named: frozenset[str]

    @property
    def t(self) -> Floats:
        """The times of the drawn points (n,) in s."""
        times: Floats = self.case.times
        return times

    @cached_property
    def given(self) -> Mapping[str, BandColumns] | None:
        """The bands that the case computes itself; None to compute them from the frequencies."""
        bands: Mapping[str, BandColumns] | None = self.case.bands
        return bands

    @cached_property
    def too_fast(self) -> frozenset[str]:
        """The motions that are too fast for these times."""
        if self.given is not None:
            return frozenset(self.given.keys() & self.drawn.keys())
        highest = self.case.highest_line
        return frozenset(name for name, one in self.drawn.items() if one.omega > highest)

    @cached_property
    def averaged(self) -> frozenset[str]:
        """The motions that are drawn as means."""
        fast = frozenset(name for name in self.too_fast if self.fast.get(name) == "mean")
        stacked = (stack for stack in self.stacks if stack & fast)
        return fast.union(*stacked) & self.drawn.keys()

    @property
    def traces(self) -> Traces:
        """The motions that are drawn as lines, and the motions for a file."""
        shown = {name: one for name, one in self.motions.items() if name in self.drawn or name in self.layers}
        columns = self.too_fast | self.averaged
        return Traces(
            float(self.case.end),
            self.case.instants,
            tuple(name for name in self.drawn if name not in columns),
            partial(exact_values, shown),
            fastest=self.case.resolved,
            moving=tuple(name for name in shown if name in self.named and name != FLOOR),
            layers=self.layers,
            averaged=self.averaged,
        )

    @property
    def columns(self) -> dict[str, Columns]:
        """The columns of bands and means, by source. No signal describes them."""
        means = {name: one.mean.at(self.t) for name, one in self.drawn.items() if name in self.averaged}
        return self._bands | ({TIME: means} if means else {})

    @property
    def _bands(self) -> dict[str, Columns]:
        """Columns by source: bands over the whole window, bands that end when the motion has decayed, and the lines
        after them."""
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
        edges = self.drawn[name].band(self.case.highest_line)
        return BandColumns(*(edge.at(self.t) for edge in edges)) if edges else None

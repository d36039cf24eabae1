"""The base class of cases of two coupled masses, with the sizes of their drawing."""

from __future__ import annotations

from abc import abstractmethod
from functools import cached_property

from components.chain.stage import BODY, MAGNIFIED, UNIT, ChainDrawing, Extremes, drawn_larger, scale, sides
from components.chain.stage import HOOK as LONGEST_HOOK
from components.layout.stage import W, wire
from components.paper.deferred import number
from components.paper.plots import Plot
from components.quantities.axes import Axis
from components.quantities.formatting import short
from components.quantities.motion import round_down, scaled
from components.scene.case import Case
from physics.coupled import TwoMassChain


class ChainCase(Case):
    """Two masses and two springs, in SI units. Sizes on the stage are shares of its width."""

    m1: float
    m2: float
    k1: float
    k2: float

    @cached_property
    def chain(self) -> TwoMassChain:
        return TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)

    @property
    @abstractmethod
    def extremes(self) -> Extremes:
        """The smallest and the largest x1, x2 and e2, the elongation of spring 2, in the drawn motion, in m."""

    @cached_property
    def fits(self) -> float:
        return scale(self.extremes, sides(self.m1, self.m2))

    @property
    def magnification(self) -> float:
        """The scale of the displacements on the stage."""
        return self.scale or self.fits

    def to_scale(self) -> str:
        return drawn_larger(self.magnification)

    @property
    def side1(self) -> float:
        return sides(self.m1, self.m2)[0]

    @property
    def side2(self) -> float:
        return sides(self.m1, self.m2)[1]

    @property
    def hook(self) -> float:
        """The height of the springs: at most half the smaller block."""
        return min(LONGEST_HOOK, self.side1 / 2, self.side2 / 2)

    @property
    def wire1(self) -> float:
        return wire(self.k1)

    @property
    def wire2(self) -> float:
        return wire(self.k2)

    @property
    def ticked(self) -> float:
        """The displacement in m that the tick on the floor marks."""
        return round_down(min(1 / self.magnification, MAGNIFIED))

    @property
    def tick(self) -> str:
        return f"{short(self.ticked)} m"

    @property
    def tick_at(self) -> float:
        return UNIT * self.magnification * self.ticked


def drawing(c: ChainCase, on: Plot) -> ChainDrawing:
    """Return the drawing of a chain with the displacements on the vertical axis of a plot."""
    metre = on.in_frame(c, "metre", _metre)
    return ChainDrawing(
        sides=(c.side1 * BODY, c.side2 * BODY),
        hook=number(c.hook),
        wires=(number(c.wire1), number(c.wire2)),
        metre=metre * W,
        tick=f"{c.tick}",
        tick_at=c.tick_at * W,
    )


def _metre(case: ChainCase, across: Axis, up: Axis) -> float:
    return scaled(-up.exponent, UNIT, case.magnification)

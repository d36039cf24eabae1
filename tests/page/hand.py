"""A hand on a page without a browser: what static/input/hand.js makes of a place, on a layout made up here."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from components.language.blocks import PlotBlock, StageBlock
from components.language.picture import Ruler
from components.language.shapes import AnyShape, AnyWay, Box, Grab, Quotient, Root, Share, Stretch, Swung, Turn
from components.layout.sheet import blocks
from components.scene import Scene
from components.state.standing import Standing, with_values
from tests.page.playing import number, played

WIDTH, HEIGHT = 640.0, 240.0
FRAME = (430.0, 170.0)
"""The frame of each plot, in pixels."""
PLAIN = Ruler(start=0, end=1, ticks=(), labels=(), unit="", exponent=0, factor=1.0, power=1, log=False)
Named = dict[str, float]
Point = tuple[float, float]


def grabs(scene: type[Scene]) -> Iterator[tuple[AnyShape, Grab]]:
    """Each shape of a scene's sheet that is grabbed."""
    for block in blocks(scene.sheet()):
        for shape in block.shapes if isinstance(block, (StageBlock, PlotBlock)) else ():
            if shape.grab:
                yield shape, shape.grab


def sets(grab: Grab) -> list[str]:
    return [way.parameter for way in grab.ways if way.parameter]


@dataclass
class Hand:
    """Over a page, whose frame stands while it holds on; a wide one or a phone's."""

    now: Standing
    wide: bool

    @property
    def scene(self) -> Scene:
        return self.now.scene

    def set(self, values: Named) -> None:
        self.now = with_values(self.now, values, holding=True)

    def rulers(self) -> dict[str, Ruler]:
        return {name: axis.ruler for name, axis in self.now.shown.axes.items()}

    def all(self, t: float) -> Named:
        """The named quantities at a time in the unit of its axis."""
        named = {name: float(value) for name, value in played(self.now.shown, t).items()}
        named |= {"W": WIDTH, "H": HEIGHT, "wide": float(self.wide), "narrow": float(not self.wide)}
        named |= {"hall": 0.0, "desk": 1.0, "low": 0.0}
        rulers = self.rulers()
        for i, plot in enumerate(block for block in blocks(self.scene.sheet()) if isinstance(block, PlotBlock)):
            if plot.x in rulers and plot.y in rulers:
                named |= _geometry(plot, rulers[plot.x], rulers[plot.y], 31.0 * i)
        return named

    def grip(self, shape: Any, named: Named) -> Point | None:
        """Where a hand takes hold of a shape; None where it is not drawn."""
        if not all(named.get(name) for name in shape.show):
            return None
        x, y = ("x2", "y2") if hasattr(shape, "x2") else ("x", "y")
        try:
            found = {name: float(number(getattr(shape, name), named)) for name in (x, y)}
            half = float(number(shape.side, named)) / 2 if isinstance(shape, Box) else 0.0
        except KeyError:
            return None
        return found[x], found[y] - half

    def placed(self, way: AnyWay, at: Point, named: Named) -> tuple[float, float]:
        """The value of a place along a way: in SI as it is drawn, and as it is set."""
        ruler = self.rulers()[way.axis] if way.axis else PLAIN
        if isinstance(way, Turn):
            across, down = at[0] - _at(way.x, named), (at[1] - _at(way.y, named)) / way.tall
            angle = (math.atan2(across, down) - way.zero) / way.unit
            return angle, angle / way.size
        y = not isinstance(way, Stretch) or way.across == "y"
        place = (at[y] - _at(way.zero, named)) / _at(way.unit, named)
        if not isinstance(way, Stretch):
            head = _si(ruler, named[way.head])
            high = min(_si(ruler, place), head / 2)
            return high, (math.sqrt(1 - 2 * high / head) - 1) / way.size
        inside = min(
            max(place, -math.inf if way.least is None else way.least), math.inf if way.most is None else way.most
        )
        si = _si(ruler, inside)
        if isinstance(way, Quotient):
            return si, named[way.over] / inside / way.size
        if isinstance(way, Root):
            return si, (inside + 1 / inside) / 2 if way.real or inside > 1 else inside
        if isinstance(way, Share):
            part = _at(way.share, named) * si
            return part, (part + _si(ruler, named[way.rest])) / way.size
        if isinstance(way, Swung):
            counted = _at(way.counted, named) * si
            value = abs(counted) if way.of == "amplitude" else math.copysign(math.pi / 2, counted)
            return _at(way.share, named) * si, value
        return si, si / way.size

    def take(self, grab: Grab, grip: Point, named: Named) -> dict[str, float]:
        """The start of a motion in hand, and what the hand sets at once because nothing else begins it."""
        begun = self.begin(grab, named)
        placed = {way.parameter: self.placed(way, grip, named)[1] for way in grab.ways if way.parameter}
        return begun if placed.keys() <= begun.keys() else placed | begun

    def begin(self, grab: Grab, named: Named) -> dict[str, float]:
        """The start of a motion when it is taken in hand."""
        rulers = self.rulers()
        found = {}
        for begin in grab.start:
            seconds = 10.0 ** rulers[begin.per].exponent if begin.per else 1.0
            seen = _si(rulers.get(begin.axis, PLAIN), named[begin.of]) if begin.of else 0.0
            value = seen / seconds / begin.size
            found[begin.parameter] = math.remainder(value, 2 * math.pi) if begin.angle else value
        return found


def _at(value: Any, named: Named) -> float:
    return float(number(value, named))


def _si(ruler: Ruler, place: float) -> float:
    """The quantity in SI at a place of the axis: static/core/ruler.js."""
    power = ruler.power
    return float(10**place if ruler.log else place ** (1 / power) * 10 ** (ruler.exponent / power)) * ruler.factor


def _geometry(plot: PlotBlock, x: Ruler, y: Ruler, aside: float) -> Named:
    (width, height), left, top = FRAME, 40.0 + aside, 20.0 + aside
    across, up = width / (x.end - x.start), -height / (y.end - y.start)
    found = {"left": left, "right": left + width, "top": top, "bottom": top + height}
    found |= {"x0": left - x.start * across, "x1": across, "y0": top - y.end * up, "y1": up}
    return {f"{plot.name}.{name}": value for name, value in found.items()}

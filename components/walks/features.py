"""Features of a sketch, one class each: its fields in a walk's file, the measurement on a curve, and the sentence.

Positions and values are in the unit of the axis, without its power of ten, or expressions of the scene's numbers in SI,
which `worked_out` evaluates. A sketch is judged by positions and heights within tolerances, never by style; an undrawn
part has no feature. Tolerances suit hand drawings: slopes are taken over 4 % of the frame's width, and turning points
need a prominence of 2 % of its height.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import ClassVar, Literal, NamedTuple, Self, TypeAlias

import msgspec
import numpy as np
from msgspec import field

from components.language.walk import Finding
from components.layout.text import rich
from components.quantities.axes import Axis
from components.quantities.formatting import short
from components.scene.traces import Floats
from components.walks import expressions
from components.walks.sketch import FEWEST, Sketch, crossings, upward
from components.walks.subject import PlotAxes, place_of
from components.walks.types import Above0, Entry

Coordinate: TypeAlias = float | str
"""A position or a height in a walk's file, or an expression whose value it is."""
Extent: TypeAlias = Above0 | str

STRIDE = 0.04  # fraction of the frame's width over which a slope is measured
STEEP = 0.06  # fraction of its height that a slope must rise there
STANDS_OUT = 0.02  # fraction of its height by which a turning point must differ from its surroundings
SURROUNDINGS = 2.5  # tolerances around a turning point
NEAR_TOP = 0.95  # of the frame's height: a curve that is higher leaves it
COARSE, FINE = 2, 3  # digits of numbers of a drawing, and of true numbers
ZERO = 1e-4  # fraction of an axis: a smaller value counts as zero


class Numbers(NamedTuple):
    """The evaluated numbers of a feature; a missing end of a part means the end of the curve."""

    at: float = 0.0
    value: float = 0.0
    tol: float = 0.0
    tol_y: float = 0.0
    start: float = -math.inf
    end: float = math.inf


class Seen(NamedTuple):
    """The result for a curve: if it has a feature, the measured number, and the position in the plot.

    The number is None if nothing was drawn, or if the curve has no such number.
    """

    has: bool
    number: float | None = None
    x: float | None = None
    y: float | None = None


NOTHING = Seen(False)


class BaseFeature(Entry, frozen=True, kw_only=True, tag_field="f"):
    """A feature that a correct sketch has: `says` names it, `on` is the curve if two are drawn.

    Its numbers in `across` belong to the horizontal axis, those in `up` to the vertical one.
    """

    across: ClassVar[tuple[str, ...]] = ()
    up: ClassVar[tuple[str, ...]] = ()
    says: str = ""
    on: str = ""

    @property
    def kind(self) -> str:
        return str(self.__struct_config__.tag)

    @property
    def numbers(self) -> Numbers:
        told = {name: getattr(self, name) for name in (*self.across, *self.up)}
        return Numbers(**{name: float(number) for name, number in told.items() if number is not None})

    def worked_out(self, numbers: Mapping[str, float], axes: PlotAxes) -> Self:
        """Return the feature with numbers for its expressions. Raises ValueError, with a reason, if an expression is
        invalid.
        """
        on_axes = ((name, axis) for names, axis in ((self.across, axes.x), (self.up, axes.y)) for name in names)
        told = {name: (text, axis.factor) for name, axis in on_axes if isinstance(text := getattr(self, name), str)}
        if not told:
            return self
        found = {name: expressions.worked_out(text, numbers) / factor for name, (text, factor) in told.items()}
        return msgspec.convert(msgspec.to_builtins(msgspec.structs.replace(self, **found)), type(self))

    def seen(self, drawn: Sketch) -> Seen:
        """Return the measurement of this feature on a curve."""
        raise NotImplementedError

    def exact(self, true: Sketch) -> Seen:
        """Return the true value of the feature."""
        return self.seen(true)

    def called(self, axes: PlotAxes) -> str:
        """Return its name if the step does not give one."""
        raise NotImplementedError

    def measured(self, found: Seen, axes: PlotAxes, digits: int) -> str:
        """Return the measured number of a curve as text."""
        return _written(found.number or 0.0, axes.y, digits)

    def words(self, yours: Seen, true: Seen, axes: PlotAxes) -> str:
        lead = "" if yours.has else "missed: " if yours.number is not None else "missed: not drawn, "
        drawn = f"yours {self.measured(yours, axes, COARSE)}, " if yours.number is not None else ""
        return f"{lead}{drawn}true {self.measured(true, axes, FINE)}"

    def finding(self, drawn: Sketch, true: Sketch, axes: PlotAxes) -> Finding:
        """Return the finding about a sketch. Its mark is at the drawn feature, or at its right position."""
        yours, exact = self.seen(drawn), self.exact(true)
        mark = yours if yours.has and yours.x is not None else exact
        at = None if mark.x is None or mark.y is None else (place_of(axes.x, mark.x), place_of(axes.y, mark.y))
        name, words = self.says or self.called(axes), self.words(yours, exact, axes)
        return Finding(has=yours.has, name=rich(name), words=rich(words), at=at)


class FeatureAt(BaseFeature, frozen=True, kw_only=True):
    """A feature at a position of a curve; `lead` begins its name."""

    lead: ClassVar[str]
    across: ClassVar[tuple[str, ...]] = ("at",)
    at: Coordinate

    def called(self, axes: PlotAxes) -> str:
        return f"{self.lead} {_written(self.numbers.at, axes.x, FINE)}"


class ValueAt(FeatureAt, frozen=True, kw_only=True, tag="value"):
    """A height `is` at a position."""

    lead, up = "The height at", ("value", "tol")
    value: Coordinate = field(name="is")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        at, value, tol = self.numbers[:3]
        y = drawn.at(at)
        return NOTHING if y is None else Seen(abs(y - value) <= tol, y, at, y)


class Slope(FeatureAt, frozen=True, kw_only=True, tag="slope"):
    """A direction, upwards or downwards, from a position on."""

    lead = "The direction after"
    way: Literal["up", "down"] = field(name="is")

    def seen(self, drawn: Sketch) -> Seen:
        at = self.numbers.at
        here, there = drawn.at(at), drawn.at(at + STRIDE * drawn.frame.width)
        if here is None or there is None:
            return NOTHING
        rise = (there - here) / drawn.frame.height
        return Seen(rise > STEEP if self.way == "up" else rise < -STEEP, None, at, here)

    def words(self, yours: Seen, true: Seen, axes: PlotAxes) -> str:
        return f"yours goes {self.way}wards" if yours.has else f"missed: it goes {self.way}wards"


class Zero(FeatureAt, frozen=True, kw_only=True, tag="zero"):
    """A zero at a position. A curve that only touches zero has none."""

    lead, across = "The zero at", ("at", "tol")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        found = crossings(drawn.x, drawn.y)
        if not len(found):
            return NOTHING
        nearest = float(found[np.argmin(np.abs(found - self.numbers.at))])
        return Seen(abs(nearest - self.numbers.at) <= self.numbers.tol, nearest, nearest, 0.0)

    def measured(self, found: Seen, axes: PlotAxes, digits: int) -> str:
        return f"at {_written(found.number or 0.0, axes.x, digits)}"


class Extreme(FeatureAt, frozen=True, kw_only=True):
    """A turning point with height `is` at a position that is not an edge; `sign` is -1 for a minimum."""

    sign: ClassVar[float]
    across, up = ("at", "tol"), ("value", "tol_y")
    value: Coordinate = field(name="is")
    tol: Extent
    tol_y: Extent

    def seen(self, drawn: Sketch) -> Seen:
        at, value, tol, tol_y, _, _ = self.numbers
        x, y = drawn.between(at - SURROUNDINGS * tol, at + SURROUNDINGS * tol)
        if len(x) < FEWEST:
            return NOTHING
        up = self.sign * y
        i = int(np.argmax(up))
        stands_out = up[i] - max(up[0], up[-1]) > STANDS_OUT * drawn.frame.height
        near = abs(x[i] - at) <= tol and abs(y[i] - value) <= tol_y
        return Seen(bool(near and stands_out), float(y[i]), float(x[i]), float(y[i]))

    def measured(self, found: Seen, axes: PlotAxes, digits: int) -> str:
        return f"{_written(found.number or 0.0, axes.y, digits)} at {_written(found.x or 0.0, axes.x, digits)}"


class Peak(Extreme, frozen=True, kw_only=True, tag="peak"):
    """A maximum that is the highest point around it."""

    lead, sign = "The peak at", 1.0


class Trough(Extreme, frozen=True, kw_only=True, tag="trough"):
    """A minimum that is the lowest point around it."""

    lead, sign = "The trough at", -1.0


class Pole(FeatureAt, frozen=True, kw_only=True, tag="pole"):
    """A pole: the curve leaves the frame at the top near a position, and is inside it on both sides."""

    lead, across = "Leaves the frame at", ("at", "tol")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        at, tol = self.numbers.at, self.numbers.tol
        top = drawn.frame.y[0] + NEAR_TOP * drawn.frame.height
        out = drawn.x[drawn.y >= top]
        if not len(out):
            return NOTHING
        nearest = float(out[np.argmin(np.abs(out - at))])
        _, around = drawn.between(at - 4 * tol, at + 4 * tol)
        returns = bool(len(around)) and float(around.min()) < top
        return Seen(returns and abs(nearest - at) <= tol, nearest, nearest, top)

    def measured(self, found: Seen, axes: PlotAxes, digits: int) -> str:
        return f"at {_written(found.number or 0.0, axes.x, digits)}"


class Within(BaseFeature, frozen=True, kw_only=True):
    """A feature of the part between two positions."""

    across: ClassVar[tuple[str, ...]] = ("start", "end")
    start: Coordinate | None = field(default=None, name="from")
    end: Coordinate | None = field(default=None, name="to")


class Period(Within, frozen=True, kw_only=True, tag="period"):
    """A period `is`, measured between crossings of the middle in the same direction."""

    across = ("start", "end", "value", "tol")
    value: Extent = field(name="is")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        x, y = drawn.between(self.numbers.start, self.numbers.end)
        if len(x) < FEWEST or np.ptp(y) <= STANDS_OUT * drawn.frame.height:
            return NOTHING
        middle = y - (y.max() + y.min()) / 2
        gaps: list[float] = [*np.diff(upward(x, middle)), *np.diff(upward(x, -middle))]
        if not gaps:
            return NOTHING
        mean = float(np.mean(gaps))
        return Seen(abs(mean - self.numbers.value) <= self.numbers.tol, mean)

    def exact(self, true: Sketch) -> Seen:
        """Zero crossings do not give the period of a motion that grows or beats."""
        return self.seen(true)._replace(number=self.numbers.value)

    def called(self, axes: PlotAxes) -> str:
        return "The period"

    def measured(self, found: Seen, axes: PlotAxes, digits: int) -> str:
        return _written(found.number or 0.0, axes.x, digits)


class Farthest(Within, frozen=True, kw_only=True, tag="reach"):
    """The number `is` as the largest distance from zero."""

    up = ("value", "tol")
    value: Coordinate = field(name="is")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        _, value, tol, _, start, end = self.numbers
        low, high = max(start, drawn.frame.x[0]), min(end, drawn.frame.x[1])
        if not drawn.covers(low, high):
            return NOTHING
        x, y = drawn.between(low, high)
        i = int(np.argmax(np.abs(y)))
        far = float(abs(y[i]))
        return Seen(abs(far - value) <= tol, far, float(x[i]), float(y[i]))

    def called(self, axes: PlotAxes) -> str:
        if self.start is None or self.end is None:
            return "How far it goes"
        start, end = (_written(one, axes.x, FINE) for one in self.numbers[-2:])
        return f"How far it goes from {start} to {end}"


class Least(BaseFeature, frozen=True, kw_only=True, tag="least"):
    """The number `is` as the minimum."""

    up = ("value", "tol")
    value: Coordinate = field(name="is")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        if not drawn.covers(*drawn.frame.x):
            return NOTHING
        i = int(np.argmin(drawn.y))
        x, y = float(drawn.x[i]), float(drawn.y[i])
        return Seen(abs(y - self.numbers.value) <= self.numbers.tol, y, x, y)

    def called(self, axes: PlotAxes) -> str:
        return "The lowest point"


class Sum(BaseFeature, frozen=True, kw_only=True, tag="sum"):
    """A sum with the other curve that is `is` everywhere; its position is where it differs most from that."""

    up = ("value", "tol")
    other: str = field(name="with")
    value: Coordinate = field(name="is")
    tol: Extent

    def seen(self, drawn: Sketch) -> Seen:
        if drawn.other is None or not (drawn.covers(*drawn.frame.x) and drawn.other.covers(*drawn.frame.x)):
            return NOTHING
        inside = (drawn.x >= drawn.other.x[0]) & (drawn.x <= drawn.other.x[-1])
        x: Floats = drawn.x[inside]
        total = drawn.y[inside] + np.interp(x, drawn.other.x, drawn.other.y)
        off = np.abs(total - self.numbers.value)
        i = int(np.argmax(off))
        return Seen(bool(off[i] <= self.numbers.tol), float(total[i]), float(x[i]), float(total[i]))

    def called(self, axes: PlotAxes) -> str:
        return "The sum of both"


Feature: TypeAlias = ValueAt | Slope | Zero | Peak | Trough | Pole | Period | Farthest | Least | Sum


def _written(number: float, axis: Axis, digits: int) -> str:
    if abs(number * axis.factor) < ZERO * abs(axis.end - axis.start):
        number = 0.0
    gap = axis.gap if axis.unit else ""
    return f"{short(float(f'{number:.{digits}g}'))}{gap}{axis.unit}"

"""The two-mass chain on the stage: its drawing and its scale."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from msgspec.structs import replace

from components.chain.modes import BOTH
from components.chain.parameters import Pair
from components.chain.signals import Axes
from components.chain.signals import Signals as S
from components.language.expressions import Expression, Name, Number, names_in, var
from components.language.shapes import Grab
from components.layout.stage import LOW, Looks, Shape, W, arrow, box, line, shown_by, spring, text, wall, wire
from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, Family, Scalar, Text, by_name
from components.quantities.formatting import short
from components.quantities.motion import round_down, scaled
from components.scene.traces import Columns, band_columns
from physics.coupled import TwoMassChain

Extremes = dict[str, tuple[float, float]]

EQUILIBRIUM = (0.29, 0.73)
"""The rest positions of the masses, as fractions of the stage's width."""
WALL = 0.02
UNIT = 0.185
"""The length of one metre at scale 1, as a fraction of the stage's width."""
MAGNIFIED = 1e308
"""The largest drawing scale, near the largest double. Only displacements near the smallest double stay invisible."""
STEPS = (1, 2, 3, 5)
"""The first digits of drawing scales. Most steps are at most a factor of 1.5."""
CUP, CUP_AT = 4, 0.27
"""Half the width of a dashpot in pixels, and its height above the floor, relative to the springs' height."""
LARGEST, SMALLEST, MARGIN, HOOK = 0.125, 0.02, 0.03, 0.04
BODY = W * (1 - 0.3 * LOW)
"""The width to which the sides of blocks are relative. It is smaller on a low stage, where arrows are close above the
blocks.
"""


class Places(Declared[float]):
    """The sizes of the chain, the length of a metre, and the position and text of the floor's tick."""

    side, wire = Scalar[Any].each(BOTH), Scalar[Any].each(BOTH)
    hook, metre, tick_at = Scalar[Any].some(3)
    tick = Text[float](lambda metres, a: f"{short(metres)} m")
    x_unit = AxisUnit(Axes.x)


P = Places


class Has(Declared[Pair]):
    """The scalars of the dashpots, which may be absent."""

    dashpot = Family(BOTH, lambda i: Scalar[Pair](lambda c, a: c[i - 1] > 0))


def sides(m1: float, m2: float) -> tuple[float, float]:
    """Sides of the blocks as fractions of the width: the area is proportional to the mass, unless one would be too
    small to see.
    """
    largest = max(m1, m2)
    whole = min(0.08 * largest**0.5, LARGEST)
    one, two = (max(whole * (m / largest) ** 0.5, SMALLEST) for m in (m1, m2))
    return one, two


def sizes(system: TwoMassChain, factor: float = 1.0) -> dict[str, float]:
    """Sides of the blocks on the stage, the height of the springs (at most half the smaller block), and the widths of
    their wires.
    """
    side1, side2 = (factor * side for side in sides(system.m1, system.m2))
    found = {P.side[1]: side1, P.side[2]: side2, P.hook: min(HOOK, side1 / 2, side2 / 2)}
    return by_name(found | {P.wire[1]: wire(system.k1), P.wire[2]: wire(system.k2)})


def extremes(curves: Columns, bands: Columns) -> Extremes:
    """The smallest and largest x1, x2 and elongation of spring 2 within the drawing (for a band: bounds)."""

    x1, x2 = (S.x[i].name for i in BOTH)

    def ends(name: str) -> tuple[float, float]:
        low, high = (curves[name],) * 2 if name in curves else (bands[end] for end in band_columns(name))
        return without_roundings(low.min()), without_roundings(high.max())

    one, two = ends(x1), ends(x2)
    if x1 in curves and x2 in curves:
        stretch = curves[x2] - curves[x1]
        return {"x1": one, "x2": two, "e2": (without_roundings(stretch.min()), without_roundings(stretch.max()))}
    return {"x1": one, "x2": two, "e2": (two[0] - one[1], two[1] - one[0])}


def without_roundings(value: float) -> float:
    """Round to twelve digits. Rounding errors then do not change the extreme of a motion that starts at its extreme."""
    return float(f"{value:.12g}")


def scale(extremes: Extremes, side: tuple[float, float]) -> float:
    """The largest drawing scale 1, 2, 3, 5, ... at which no block meets another or the wall.

    `extremes` holds the least and largest x1, x2 and elongation of spring 2 (e2), in metres. Scale 1 is kept where it
    fits and shows a motion of more than a thirtieth of the stage's width.
    """
    (low1, high1), (low2, high2), (squeeze, _) = (extremes[name] for name in ("x1", "x2", "e2"))
    room = [
        (-low1, EQUILIBRIUM[0] - side[0] / 2 - WALL - MARGIN),
        (-squeeze, EQUILIBRIUM[1] - EQUILIBRIUM[0] - sum(side) / 2 - MARGIN),
        (high2, 0.995 - EQUILIBRIUM[1] - side[1] / 2),
        (high1, 0.995 - EQUILIBRIUM[0] - side[0] / 2),
        (-low2, EQUILIBRIUM[1] - side[1] / 2 - WALL - MARGIN),
    ]
    fits = min((free / UNIT / reach for reach, free in room if reach > 0), default=1.0)
    seen = max(abs(v) for pair in (extremes["x1"], extremes["x2"]) for v in pair) * UNIT > 1 / 30
    return 1.0 if fits >= 1 and (seen or fits == 1.0) else round_down(min(fits, MAGNIFIED), STEPS)


def drawn_larger(factor: float) -> str:
    """The sentence on the scale of the stage, "" if it is 1."""
    return "" if factor == 1 else f"Displacements are drawn {short(factor)} times as large."


@dataclass(frozen=True)
class DrawnChain:
    """The chain drawn to scale: sizes for the stage, the text of the floor's ticks, and a sentence if the scale is not
    1.

    `fits` is the scale that suits the motion, `scale` the one that is used.
    """

    scalars: dict[str, float]
    values: dict[str, str]
    to_scale: str
    scale: float = 1.0
    fits: float = 1.0


def to_scale(system: TwoMassChain, extremes: Extremes, size: Axis, wanted: float | None = None) -> DrawnChain:
    """Sizes on the stage at the scale `wanted`, or the largest that fits; displacements have the unit of the axis
    `size`.
    """
    fits = scale(extremes, sides(system.m1, system.m2))
    factor = wanted or fits
    tick = round_down(min(1 / factor, MAGNIFIED))
    scaling = {P.metre: scaled(-size.exponent, UNIT, factor), P.tick_at: UNIT * factor * tick}
    values = P.texts(tick, by_name({Axes.x: size}))
    return DrawnChain(sizes(system) | by_name(scaling), values, drawn_larger(factor), factor, fits)


@dataclass(frozen=True)
class ChainDrawing:
    """The sizes by which the chain is drawn: numbers of shapes.

    `sides`, of the blocks, and `metre`, the length of one unit of the displacement axis, are in pixels. `hook` is the
    height of the springs, as a share of `BODY`. `wires` are the widths of the springs; one of width 0 is not drawn.
    `tick` is the
    text of the floor's tick, `tick_at` its distance in pixels from the place of mass 1 at rest.
    """

    sides: tuple[Number, Number]
    hook: Number
    wires: tuple[Expression, Expression]
    metre: Number
    tick: str
    tick_at: Number

    def side(self, mass: int) -> Number:
        """The side of the block of mass 1 or 2 in pixels."""
        return self.sides[mass - 1]

    def place(self, mass: int, displacement: Number) -> Number:
        """The position of a displaced mass in pixels."""
        return rest(mass) + self.metre * displacement

    def masses(
        self, foot: Number, x1: Number, x2: Number, *, small: bool = False, corner: bool = False,
        grabs: tuple[Grab | None, Grab | None] = (None, None),
    ) -> list[Shape]:  # fmt: skip
        """The chain on the floor `foot`, with its masses at x1 and x2 (pixels); `small` draws smaller outlines.

        `corner` moves the symbols aside, for content on the mass; `grabs` make the masses draggable.
        """
        size = 0.42 if small else 1.0
        side1, side2 = self.sides[0] * size, self.sides[1] * size
        height = foot - self.hook * BODY * (0.65 if small else 1)
        teeth: Looks = {"height": (1 if small else 2) + self.hook * (125 if small else 275)}
        teeth["style"] = "faint" if small else None
        faces: Looks = {"style": "ghost"} if small else {"corner": True} if corner else {}
        wires = [wire * (0.5 if small else 1) for wire in self.wires]
        springs = (
            spring(WALL * W, height, x1 - side1 / 2, height, wires[0], **teeth),
            spring(x1 + side1 / 2, height, x2 - side2 / 2, height, wires[1], **teeth),
        )
        return [
            *(replace(one, show=tuple(names_in(by))) for one, by in zip(springs, self.wires, strict=True)),
            box(x1, foot, side1, "" if small else "*m*_1", tint="m1", grab=grabs[0], **faces),
            box(x2, foot, side2, "" if small else "*m*_2", tint="m2", grab=grabs[1], **faces),
        ]

    def cups(self, foot: Number, x1: Number, x2: Number) -> list[Shape]:
        """Return the dashpots under the springs, if there are any. Each piston stays in its cup for any
        displacement."""
        height, half1, half2 = foot - self.hook * BODY * CUP_AT, self.sides[0] / 2, self.sides[1] / 2
        one = _cup(WALL * W, x1 - half1, rest(1) - half1 - WALL * W, height)
        two = _cup(x1 + half1, x2 - half2, rest(2) - rest(1) - half1 - half2, height)
        return [*shown_by(Has.dashpot[1], *one), *shown_by(Has.dashpot[2], *two)]

    def ground(self, foot: Number) -> list[Shape]:
        """Return the floor, a tick at the zero of each mass, and the text of the scale at the first tick."""
        shapes = [line(WALL * W, foot, W, foot, tint="ink", style="floor")]
        for mass in BOTH:
            tint = f"m{mass}"
            shapes.append(text(rest(mass), foot + 17, "0", tint=tint, style="t0 halo"))
            shapes.append(line(rest(mass), foot, rest(mass), foot + 5, style="floor"))
        tick = rest(1) + self.tick_at
        return [
            *shapes,
            text(tick, foot + 17, self.tick, tint="m1", style="t0 halo"),
            line(tick, foot, tick, foot + 5, style="floor"),
        ]

    def displacement_arrow(self, mass: int, foot: Number, x: Number, words: str, top: int = 27) -> list[Shape]:
        """The arrow from equilibrium to the mass at x (pixels), and a text over the equilibrium line, which does not
        move.
        """
        tint = f"m{mass}"
        return [
            line(rest(mass), top - 6, rest(mass), foot, tint="mute", style="eq"),
            line(x, top, x, foot - self.side(mass), tint="mute", style="eq revealing"),
            arrow(rest(mass), top, x, top, tint=tint),
            text(rest(mass), top - 12, f"*x*_{mass} = {words}", tint=tint, style="t2 b"),
        ]


def _cup(left: Number, right: Number, long: Number, y: Number) -> list[Shape]:
    """Return the parts of a dashpot between two positions; its length at rest is `long`."""
    near, far, middle = left + 0.14 * long, left + 0.86 * long, left + 0.5 * long + 0.34 * (right - left - long)
    look: Looks = {"tint": "T"}
    return [
        line(left, y, near, y, **look),
        line(near, y - CUP, near, y + CUP, **look),
        line(near, y - CUP, far, y - CUP, **look),
        line(near, y + CUP, far, y + CUP, **look),
        line(middle, y - CUP + 2, middle, y + CUP - 2, style="sum", **look),
        line(middle, y, right, y, **look),
    ]


def rest(mass: int) -> Number:
    """The position of mass 1 or 2 at rest, in pixels."""
    return EQUILIBRIUM[mass - 1] * W


def standing_wall(top: Number, length: Number) -> Shape:
    return wall(WALL * W, top, length, side="left")


DECLARED = ChainDrawing(
    sides=(var(P.side[1]) * BODY, var(P.side[2]) * BODY),
    hook=var(P.hook),
    wires=(var(P.wire[1]), var(P.wire[2])),
    metre=var(P.metre) * W,
    tick=f"{P.tick}",
    tick_at=var(P.tick_at) * W,
)
"""Return the sizes for scenes without a case, from their declared numbers."""
side, masses, cups, ground = DECLARED.side, DECLARED.masses, DECLARED.cups, DECLARED.ground


def place(mass: int, signal: Name | None = None) -> Number:
    """Return the position of a mass in pixels, displaced by `signal` or by its own displacement."""
    return DECLARED.place(mass, var(signal or S.x[mass]))


def displacement_arrow(mass: int, foot: Number) -> list[Shape]:
    return DECLARED.displacement_arrow(mass, foot, place(mass), f"{S.x[mass]} {P.x_unit}")

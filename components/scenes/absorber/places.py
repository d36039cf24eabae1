"""Sizes and positions in the absorber's scene: on its stage and in its plots."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from components.layout.stage import wire
from components.quantities.axes import Axis
from components.quantities.declared import AxesInForce, Declared, DrawnAxis, Family, Scalar, by_name
from components.quantities.formatting import short
from components.quantities.motion import round_down
from components.scenes.absorber.case import AWAY, AbsorberCase
from components.scenes.absorber.curves import ALONE, FromStart, reach_alone
from components.scenes.absorber.curves import Axes as A
from components.scenes.absorber.words import VERDICTS

LARGEST, SMALLEST, HOOK = 0.265, 0.045, 0.058
"""Sides of the masses, and the height of the springs, as fractions of the stage's height."""
DEFLECTION = 0.00767
"""The length of one static deflection as a fraction of the stage's width, if everything fits."""
TINY, LEAD = 1e-200, 0.145
PUSH = 0.1125
"""The length of the largest drive's arrow as a fraction of the stage's width, if the force of spring 2 is at most twice
as large."""
ROOM = (0.22, 0.2, 0.28)
"""Free distances as fractions of the stage's width: mass 1 to the wall, mass 2 to mass 1, mass 2 to the right edge."""

scalar = Scalar[AbsorberCase]
ScalarPair = tuple[Scalar[AbsorberCase], Scalar[AbsorberCase]]


def _sides(case: AbsorberCase) -> list[float]:
    whole = max(case.m1, case.m2)
    return [max(LARGEST * math.sqrt(m / whole), SMALLEST) for m in (case.m1, case.m2)]


def _across(axes: AxesInForce, w: float) -> float:
    """The position of a drive frequency."""
    return A.w(axes).place(min(w, 4 * A.w(axes).end))


def _up(axis: Axis, size: float) -> float:
    """The position of a swing or stroke, limited to the frame."""
    return axis.place(min(size, axis.end))


def _frequency(of: Callable[[AbsorberCase], float]) -> ScalarPair:
    """The position of a drive frequency, and a flag: it is inside the frame."""
    seen = scalar(lambda d, a: A.w(a).start <= of(d) <= A.w(a).end)
    return scalar(lambda d, a: _across(a, of(d))), seen


def _reading(on: DrawnAxis, i: int, unless: str = "") -> ScalarPair:
    """The position of a dot at the running speed, and a flag: the dot is inside the frame, and the verdict is not
    `unless`.
    """
    seen = scalar(lambda d, a: d.swings[i] <= on(a).end and d.verdict != unless)
    return scalar(lambda d, a: _up(on(a), d.swings[i])), seen


class Places(Declared[AbsorberCase]):
    # On the stage, with the scale of `drawn`: the names of x1 are next to the tips of the arrows.
    metre, tick, push, tag_left, tag_right = scalar.some(5)
    lead = scalar.each((ALONE, 1), "lead_x{}")
    side = Family((1, 2), lambda i: scalar(lambda d, a: _sides(d)[i - 1]))
    hook = scalar(lambda d, a: min(HOOK, min(_sides(d)) / 2))
    wire1 = scalar(lambda d, a: wire(d.k1 / 1e4))
    wire2 = scalar(lambda d, a: wire(d.k2 / 1e4))
    # True in the view "From rest"; only there can the masses be dragged.
    from_rest = scalar(lambda d, a: d.from_rest)
    # The motion without the absorber, the verdict with it, and the goals that are met.
    differ = scalar(lambda d, a: d.plays != d.plays_alone)
    alone_shakes = scalar(lambda d, a: d.plays_alone)
    alone_grows = scalar(lambda d, a: d.bare.at_resonance)
    alone_beats = scalar(lambda d, a: not d.bare.split_is_meaningful and not d.bare.at_resonance)
    alone_within = scalar(lambda d, a: d.from_rest and d.bare.split_is_meaningful)
    verdict = Family(
        VERDICTS, lambda name: scalar(lambda d, a: name == ("rest" if d.from_rest and d.solved else d.verdict)), "is_{}"
    )
    met = Family(range(3), lambda i: scalar(lambda d, a: d.met[i]))
    missed = Family(range(3), lambda i: scalar(lambda d, a: not d.met[i]))
    # In the plots: frequencies, limits, readings, and the fixed points.
    slow, slow_seen = _frequency(lambda d: d.natural[0])
    omega, omega_seen = _frequency(lambda d: d.omega)
    fast, fast_seen = _frequency(lambda d: d.natural[1])
    away_low = scalar(lambda d, a: _across(a, (1 - AWAY) * d.omega))
    away_high = scalar(lambda d, a: _across(a, (1 + AWAY) * d.omega))
    limit1 = scalar(lambda d, a: A.X1(a).place(d.limits[0]))
    limit2 = scalar(lambda d, a: A.X2(a).place(d.limits[1]))
    swing, swing_seen = _reading(A.X1, 0)
    stroke, stroke_seen = _reading(A.X2, 1)
    alone, alone_seen = _reading(A.X1, 2, unless="detached")
    # The label is under its dot, where it does not overlap the names of the fixed points, except while the knob is
    # there.
    fixed_seen = scalar(lambda d, a: d.c > 0)
    fixed_x = Family("PQ", lambda name: scalar(lambda d, a: _across(a, d.fixed[name][0]) if d.c else None), "{}_x")
    fixed_y = Family("PQ", lambda name: scalar(lambda d, a: _up(A.X1(a), d.fixed[name][1]) if d.c else None), "{}_y")


def _reach(case: AbsorberCase, moved: FromStart | None, end: float) -> tuple[float, float, float]:
    """The largest displacements of mass 1 (also without the absorber), of mass 2 relative to it, and of mass 2, in
    static deflections.
    """
    swing, stroke, alone = case.swings
    if not case.plays_alone:
        alone = reach_alone(case, end)
    if moved is None:
        ways = max(swing, alone), stroke, abs(complex(case.X[1]))
    else:
        one, two, stretch = np.abs(moved.x).max(axis=1).tolist()
        ways = max(one, alone), stretch, two
    return case.over_deflection(ways[0]), case.over_deflection(ways[1]), case.over_deflection(ways[2])


@dataclass(frozen=True)
class Drawing:
    """Sizes on the stage, the value of the ruler's tick, the current scale, and the scale that fits."""

    scalars: dict[str, float]
    tick: str
    scale: float
    fits: float


def drawn(case: AbsorberCase, moved: FromStart | None, end: float, size: Axis, wanted: float | None) -> Drawing:
    """Choose the scale of displacements: `wanted`, in static deflections per metre, as long as everything fits. A kept
    scale is proportional to the static deflection, so that twice the force gives twice the drawn swing. `moved` is the
    motion that is played if it is not the particular solution.
    """
    reach = _reach(case, moved, end)
    fits, stands = _scales(case, reach, wanted)
    scale = DEFLECTION * (case.deflections(wanted) if wanted else stands)
    metre = scale / size.place(case.deflections(1.0))
    tick = round_down(DEFLECTION * 10 / metre)
    way = scale * (case.over_deflection(case.swings[0]) if case.plays else reach[0])
    strength = case.pull if case.plays else case.k2 * reach[1] / case.k1 * case.F_0
    scalars = by_name({
        Places.metre: metre,
        Places.tick: tick * metre,
        Places.push: PUSH * min(1.0, 2 * case.F_0 / strength) if strength else PUSH,
        Places.lead[ALONE]: min(scale * reach[0], LEAD),
        Places.lead[1]: min(way, LEAD),
        Places.tag_left: max(0.234 - way, 0.19),
        Places.tag_right: min(0.486 + way, 0.535),
    })  # fmt: skip
    return Drawing(scalars, f"{short(tick)} {size.full_unit}", wanted or fits, fits)


def _scales(case: AbsorberCase, reach: tuple[float, float, float], wanted: float | None) -> tuple[float, float]:
    """The scale that fits, the wanted one if it fits, and the one that would be chosen, in static deflections."""
    most = min(room / (DEFLECTION * way) if way > TINY else math.inf for room, way in zip(ROOM, reach, strict=True))
    chosen = 1.0 if most >= 1 else round_down(most)
    fits = chosen * case.over_deflection(1.0)
    return max(fits, wanted) if wanted and case.deflections(wanted) <= most else fits, chosen

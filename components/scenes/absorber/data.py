"""The numbers of the absorber's scene: curves, motions, sizes on the stage."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from components.layout.stage import wire
from components.quantities.axes import Axis
from components.quantities.motion import round_down
from components.quantities.numbers import short
from components.scene.traces import Columns
from components.scenes.absorber.duty import AWAY, Duty
from components.scenes.absorber.moved import FromStart, reach_alone
from components.scenes.absorber.played import pull
from components.scenes.absorber.wording import VERDICTS
from physics.absorber import damped_amplitude, fixed_points
from physics.absorber_curves import machine_curves

LARGEST, SMALLEST, HOOK = 0.265, 0.045, 0.058
"""Sides of the masses, and the height of the springs, as fractions of the stage's height."""
DEFLECTION = 0.00767
"""The width that the static deflection takes where all fits."""
TINY, LEAD = 1e-200, 0.145
PUSH = 0.1125
"""The width that the largest drive takes where the pull of spring 2 is not more than twice as large."""
ROOM = (0.22, 0.2, 0.28)
"""Free ways as fractions of the stage's width: mass 1 to the wall, mass 2 to mass 1, mass 2 to the right."""


def columns(duty: Duty, axes: dict[str, Axis]) -> dict[str, Columns]:
    """The curves at all frequencies that have an amplitude."""
    w = duty.frequencies(axes["w"].start, axes["w"].end)
    curves = [*duty.curves(w), *(machine_curves(duty.chain, 0.0, duty.F_0, w)[:2] if duty.c else ())]
    known = np.isfinite(curves).all(axis=0)
    w, (swing, stroke, alone, *free) = w[known], np.asarray(curves)[:, known]
    sources: dict[str, Columns] = {
        "sweep": {"w": w, "swing": swing, "stroke": stroke, "alone": alone},
        "helped": {},
        "compare": {"w": w, "free": free[0], "free2": free[1]} if free else {},
    }
    if duty.band is not None:
        inside = (w >= duty.band[0]) & (w <= duty.band[1])
        sources["helped"] = {"w": w[inside], "helped_lo": swing[inside], "helped_hi": alone[inside]}
    return sources


def _reach(duty: Duty, moved: FromStart | None, end: float) -> tuple[float, float, float]:
    """The largest ways of mass 1 (alone too), of mass 2 against it, of mass 2, over the static deflection."""
    swing, stroke, alone = duty.swings
    if not duty.plays_alone:
        alone = reach_alone(duty, end)
    if moved is None:
        ways = max(swing, alone), stroke, abs(complex(duty.X[1]))
    else:
        one, two, stretch = np.abs(moved.x).max(axis=1).tolist()
        ways = max(one, alone), stretch, two
    return duty.over_deflection(ways[0]), duty.over_deflection(ways[1]), duty.over_deflection(ways[2])


@dataclass(frozen=True)
class Drawing:
    """Sizes on the stage, what the ruler's tick stands for, the scale that it is drawn to and the one that fits."""

    scalars: dict[str, float]
    tick: str
    scale: float
    fits: float


def drawn(duty: Duty, moved: FromStart | None, end: float, size: Axis, wanted: float | None) -> Drawing:
    """Displacements are drawn at the scale `wanted`, in static deflections a metre, as long as they fit; the ruler
    tells which. It is chosen by the static deflection, and then stands: twice the force is seen as twice the swing.
    What is played has `moved`, or is the particular solution."""
    whole = max(duty.m1, duty.m2)
    reach = _reach(duty, moved, end)
    fits, stands = _scales(duty, reach, wanted)
    scale = DEFLECTION * (duty.deflections(wanted) if wanted else stands)
    metre = scale / size.place(duty.deflections(1.0))
    tick = round_down(DEFLECTION * 10 / metre)
    way = scale * (duty.over_deflection(duty.swings[0]) if duty.plays else reach[0])
    strength = pull(duty) if duty.plays else duty.k2 * reach[1] / duty.k1 * duty.F_0
    sides = [max(LARGEST * math.sqrt(m / whole), SMALLEST) for m in (duty.m1, duty.m2)]
    scalars = {
        "side1": sides[0],
        "side2": sides[1],
        "hook": min(HOOK, min(sides) / 2),
        "wire1": wire(duty.k1 / 1e4),
        "wire2": wire(duty.k2 / 1e4),
        "metre": metre,
        "push": PUSH * min(1.0, 2 * duty.F_0 / strength) if strength else PUSH,
        # Beside the tips of the arrows, wherever the machine swings to.
        "lead_x_alone": min(scale * reach[0], LEAD),
        "lead_x1": min(way, LEAD),
        "tag_left": max(0.234 - way, 0.19),
        "tag_right": min(0.486 + way, 0.535),
        "tick": tick * metre,
        **_seen(duty),
    }
    return Drawing(scalars, f"{short(tick)} {size.full_unit}", wanted or fits, fits)


def _scales(duty: Duty, reach: tuple[float, float, float], wanted: float | None) -> tuple[float, float]:
    """The scale that fits, a wanted one where that does, and the one that would be chosen, over the deflection."""
    most = min(room / (DEFLECTION * way) if way > TINY else math.inf for room, way in zip(ROOM, reach, strict=True))
    chosen = 1.0 if most >= 1 else round_down(most)
    fits = chosen * duty.over_deflection(1.0)
    return max(fits, wanted) if wanted and duty.deflections(wanted) <= most else fits, chosen


def _seen(duty: Duty) -> dict[str, float]:
    """1 for what is drawn and 0 for what is not: the machine alone, the verdict, the limits that are met."""
    alone = duty.bare
    verdict = "rest" if duty.from_rest and duty.solved else duty.verdict
    return {
        "differ": float(duty.plays != duty.plays_alone),
        "alone_shakes": float(duty.plays_alone),
        "alone_grows": float(alone.at_resonance),
        "alone_beats": float(not alone.split_is_meaningful and not alone.at_resonance),
        "alone_within": float(duty.from_rest and alone.split_is_meaningful),
        **{f"is_{name}": float(name == verdict) for name in VERDICTS},
        **{f"met{i}": float(met) for i, met in enumerate(duty.met)},
        **{f"open{i}": float(not met) for i, met in enumerate(duty.met)},
    }


def marks(duty: Duty, axes: dict[str, Axis]) -> dict[str, float]:
    """The places of frequencies, limits and readings in the plots."""
    w, X1, X2 = axes["w"], axes["X1"], axes["X2"]
    slow, fast = duty.driven.free.omega.tolist()
    swing, stroke, alone = duty.swings
    places = {"slow": slow, "omega": duty.omega, "fast": fast}
    places |= {"away_low": (1 - AWAY) * duty.omega, "away_high": (1 + AWAY) * duty.omega}
    scalars = {name: w.place(min(x, 4 * w.end)) for name, x in places.items()}
    scalars |= {f"{name}_seen": float(w.start <= places[name] <= w.end) for name in ("slow", "omega", "fast")}
    scalars |= {"limit1": X1.place(duty.limits[0]), "limit2": X2.place(duty.limits[1])}
    for name, axis, x in (("alone", X1, alone), ("swing", X1, swing), ("stroke", X2, stroke)):
        scalars |= {name: axis.place(min(x, axis.end)), f"{name}_seen": float(x <= axis.end)}
    scalars["alone_seen"] *= float(duty.verdict != "detached")
    scalars["fixed_seen"] = float(duty.c > 0)
    # The number at the point makes room for the names of the fixed points.
    scalars["swing_aside"] = 20.0 if duty.c else -9.0
    if duty.c:
        points = fixed_points(duty.chain)
        heights = damped_amplitude(duty.chain, duty.c, duty.F_0, points)[0]
        for name, point, height in zip("PQ", points, heights, strict=True):
            scalars |= {
                f"{name}_x": w.place(min(point, 4 * w.end)),
                f"{name}_y": X1.place(min(height, X1.end)),
            }
    return scalars


def forms(duty: Duty, *, own: bool, damped: bool) -> dict[str, str]:
    """Which sentence stands, and which groups of the panel."""
    verdict = duty.verdict
    finite = bool(np.all(np.isfinite(duty.X)))
    kind = "damped" if duty.c else "undamped" if finite else "none"
    band = "never" if duty.band is None else "above" if math.isinf(duty.band[1]) else "band"
    return {
        "first": kind,
        "second": "still" if verdict == "still" else kind if kind != "none" else "",
        "why": "damped" if duty.c else verdict,
        "why_rest": "damped" if duty.c else duty.unsolved if not duty.solved else "parts" if duty.k2 else "alone",
        "rest" if duty.from_rest else "formulas": "shown",
        "helped": band,
        "free": "undamped" if duty.c else "",
        "optimum": "shown" if duty.c else "",
        "own" if own else "fixed": "shown",
        **({"damped": "shown"} if damped else {}),
    }

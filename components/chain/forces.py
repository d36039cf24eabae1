"""The forces on the two masses of the chain, as arrows and live numbers: shown if the visitor asks for them.

F_1 = -k1 x1 - k2 (x1 - x2) + F_0 sin(omega t),   F_2 = k2 (x1 - x2)        (D34, slides 1 and 6)

With dashpots -c1 v1 - c2 (v1 - v2) is added to F_1, c2 (v1 - v2) to F_2.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from components.chain.modes import BOTH
from components.chain.parameters import Pair
from components.chain.signals import Signals as S
from components.chain.stage import place, side
from components.language.expressions import Number, var
from components.language.picture import Digits
from components.language.signals import AnySignal
from components.layout.stage import Shape, W, arrow, text
from components.quantities.axes import Axis, nice_axis
from components.quantities.declared import Declared, Scalar, Text, by_name
from components.quantities.motion import derived, scaled
from components.scene.traces import Floats
from physics.coupled import Motion, TwoMassChain
from physics.valid import DOUBLES

LENGTH = 0.13
"""The length of the arrow of the largest force, as a share of the stage's width."""


class Arrows(Declared[Axis]):
    """The lengths of an arrow of 1 N and of the drive's arrow on the stage, and the unit of the axis of forces."""

    forces, newton, push = Scalar[Axis].some(3)
    force_unit = Text[Axis](lambda axis, a: axis.full_unit)


@dataclass(frozen=True, kw_only=True)
class Forces:
    """Return the forces on the masses in a picture, if requested."""

    signals: dict[str, AnySignal] = field(default_factory=dict)
    scalars: dict[str, float] = field(default_factory=lambda: by_name({Arrows.forces: 0.0, Arrows.push: LENGTH}))
    values: dict[str, str] = field(default_factory=lambda: by_name({S.F[1]: "", S.F[2]: "", Arrows.force_unit: ""}))
    live: dict[str, Digits] = field(default_factory=dict)


def on_masses(
    system: TwoMassChain, motion: Motion, F_0: float = 0.0, omega: float = 0.0, c: Pair = (0.0, 0.0)
) -> Floats:
    """F_1, F_2 (2, n) in N from springs, dashpots c1, c2 and the drive. Raise ValueError if one leaves the range of
    doubles.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        one, two = (k * e for k, e in zip((system.k1, system.k2), motion.e, strict=True))
        if any(c):
            one, two = one + c[0] * motion.v[0], two + c[1] * (motion.v[1] - motion.v[0])
        result = np.array([two - one + F_0 * np.sin(omega * motion.t), -two])
    if not np.all(np.isfinite(result)):
        raise ValueError(f"the forces on the masses leave {DOUBLES}")
    return result


def forces(
    system: TwoMassChain,
    motion: Motion,
    size: Axis,
    F_0: float = 0.0,
    omega: float = 0.0,
    c: Pair = (0.0, 0.0),
    speed: Axis | None = None,
) -> Forces:
    """The forces from the signals of displacements (of the axis `size`) and the drive; with dashpots c1, c2 also from
    the velocities, of the axis `speed`.
    """
    largest = max(float(np.abs(on_masses(system, motion, F_0, omega, c)).max()), F_0)
    axis = nice_axis(0.0, largest or 1.0, "N", exact=True)
    k1, k2 = (scaled(axis.exponent - size.exponent, k) for k in (system.k1, system.k2))
    hold, pull = k1 * var(S.x[1]), k2 * (var(S.x[2]) - var(S.x[1]))
    if speed is not None:
        c1, c2 = (scaled(axis.exponent - speed.exponent, one) for one in c)
        hold, pull = hold + c1 * var(S.v[1]), pull + c2 * (var(S.v[2]) - var(S.v[1]))
    push = scaled(axis.exponent, F_0) * var(S.drive) if F_0 else 0.0
    newton = LENGTH / axis.place(axis.end)
    return Forces(
        signals=by_name({S.F[1]: derived(pull - hold + push), S.F[2]: derived(-pull)}),
        scalars=by_name({Arrows.forces: 1.0, Arrows.newton: newton, Arrows.push: newton * axis.place(F_0)}),
        values=Arrows.texts(axis, {}),
        live=by_name(dict.fromkeys((S.F[1], S.F[2]), axis.digits(signed=True))),
    )


def arrows(foot: Number, above: Number = 20) -> list[Shape]:
    """The arrows of F_1 and F_2, from the upper part of each mass. Their names are so many pixels above them."""
    shapes = []
    for i in BOTH:
        x, y = place(i), foot - 0.78 * side(i)
        tip = x + var(Arrows.newton) * W * var(S.F[i])
        shapes.append(arrow(x, y, tip, y, style="thick", head=18, show=Arrows.forces))
        shapes.append(text(tip, y - above, f"*F*_{i}", style="t3 b halo", show=Arrows.forces))
    return shapes

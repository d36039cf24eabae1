"""'About these numbers' of the hanging mass."""

from __future__ import annotations

from decimal import Decimal

from components.quantities.declared import Signal, by_name
from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, drift, few_of, rows
from components.scenes.energy.case import HangingCase
from components.scenes.energy.curves import Signals as S
from physics.exact import exact, precise
from physics.hanging import Datum, HangingMass
from physics.reference import Point
from physics.reference_single import oscillator_points


def energy_about(picture: Picture, system: HangingMass, x_0: float, v_0: float, datum: Datum) -> About:
    columns, x = picture.sources["time"], {S.x: "$x$"}
    true = oscillator_points(system.oscillator, x_0, v_0, few_of(columns["t"]))
    energies = {S.T: "$T$", S.V: "$V$", S.spring: "spring", S.gravity: "gravity"}
    each = [_hanging(system, *state, datum) for state in zip(true["x"], true["v"], strict=True)]
    levels = by_name({one: [point[one] for point in each] for one in energies})
    tables = (
        bounded("$x(t)$", 4, "its amplitude", rows(x, columns, true)),
        bounded("an energy", 12, "its largest value", rows(energies, columns, levels)),
    )
    motion = system.motion(x_0, v_0, columns["t"])
    total = system.energies(motion.x, motion.v).total
    return About(tables, drift(total, system.total_energy(x_0, v_0)), drawn_as_bands(picture.sources, x | energies))


def _hanging(system: HangingMass, x: Point, v: Point, datum: Datum) -> dict[Signal[HangingCase], Point]:
    """The energies at one time; each measured by the largest it reaches."""
    m, k, g = exact(system.m), exact(system.k), exact(system.g)
    with precise():
        deflection = m * g / k
        shift = k * deflection**2 / 2 if datum == "separate" else Decimal(0)
        T, E = m * v.value**2 / 2, k * x.size**2 / 2
        return {
            S.T: Point(T, E),
            S.V: Point(k * x.value**2 / 2 + shift, E + shift),
            S.spring: Point(k * (x.value + deflection) ** 2 / 2, k * (x.size + deflection) ** 2 / 2),
            S.gravity: Point(-m * g * x.value, m * g * x.size),
        }

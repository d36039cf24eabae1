"""'About these numbers' of the hanging mass."""

from __future__ import annotations

from decimal import Decimal

from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, drift, few, rows
from physics.exact import exact, precise
from physics.hanging import Datum, HangingMass
from physics.reference import Point
from physics.reference_single import oscillator_points


def energy_about(picture: Picture, system: HangingMass, x_0: float, v_0: float, datum: Datum) -> About:
    columns = picture.sources["time"]
    at = few(columns["t"])
    true = oscillator_points(system.oscillator, x_0, v_0, columns["t"][at].tolist())
    energies = {"T": "$T$", "V": "$V$", "spring": "spring", "gravity": "gravity"}
    states = zip(true["x"], true["v"], strict=True)
    each = [_hanging(system, x, v, datum) for x, v in states]
    levels = {name: [point[name] for point in each] for name in energies}
    tables = (
        bounded("$x(t)$", 4, "its amplitude", rows({"x": "$x$"}, columns, true, at)),
        bounded("an energy", 12, "its largest value", rows(energies, columns, levels, at)),
    )
    motion = system.motion(x_0, v_0, columns["t"])
    total = system.energies(motion.x, motion.v).total
    return About(
        tables, drift(total, system.total_energy(x_0, v_0)), drawn_as_bands(picture.sources, {"x": "$x$", **energies})
    )


def _hanging(system: HangingMass, x: Point, v: Point, datum: Datum) -> dict[str, Point]:
    """The energies at one time; each measured by the largest it reaches."""
    m, k, g = exact(system.m), exact(system.k), exact(system.g)
    with precise():
        deflection = m * g / k
        shift = k * deflection**2 / 2 if datum == "separate" else Decimal(0)
        T, E = m * v.value**2 / 2, k * x.size**2 / 2
        return {
            "T": Point(T, E),
            "V": Point(k * x.value**2 / 2 + shift, E + shift),
            "spring": Point(k * (x.value + deflection) ** 2 / 2, k * (x.size + deflection) ** 2 / 2),
            "gravity": Point(-m * g * x.value, m * g * x.size),
        }

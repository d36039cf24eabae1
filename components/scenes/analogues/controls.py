"""The parameters of the nine systems as quantities of one scene: shaft_J, shaft_k_t, pendulum_l, ..."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from components.layout.controls import Group
from components.quantities.parameters import Quantity, count, finite, positive
from components.scenes.analogues.numbers import Forms
from components.scenes.analogues.reach import LARGEST, REACHES
from physics.analogue import Analogue, Parameter
from physics.analogues import ANALOGUES

SWINGING = tuple(slug for slug, system in ANALOGUES.items() if system.length_of)
"""The systems that are linear only for small oscillations. They share the start theta_0."""

LINEAR = tuple(slug for slug in ANALOGUES if slug not in SWINGING)

SHORT = {
    "spring": "Spring, mass",
    "shaft": "Shaft, rotor",
    "pendulum": "Pendulum",
    "rocking": "Rocking",
    "floating": "Floating",
    "circuit": "LC circuit",
    "string": "String",
    "wave": "Water wave",
    "pipe": "Air in a pipe",
}

STARTS = {
    "spring": "x_0",
    "shaft": "θ_0",
    "floating": "z_0",
    "circuit": "q_0",
    "string": "q_0",
    "wave": "η_0",
    "pipe": "q_0",
}

_WHAT = {
    "spring_m": "mass",
    "spring_k": "stiffness",
    "shaft_J": "moment of inertia",
    "shaft_k_t": "torsional stiffness",
    "pendulum_l": "length",
    "pendulum_g": "gravity",
    "pendulum_m": "mass",
    "rocking_m": "mass",
    "rocking_d": "distance",
    "rocking_r": "radius of gyration",
    "floating_m": "mass",
    "floating_A": "area",
    "floating_rho": "density",
    "circuit_L": "inductance",
    "circuit_C": "capacitance",
    "string_L": "length",
    "string_T": "tension",
    "string_n": "mode number",
    "wave_wavelength": "wavelength",
    "wave_g": "gravity",
    "wave_rho": "density",
    "pipe_L": "length",
    "pipe_c": "speed of sound",
    "pipe_n": "mode number",
}

_SAYS = {
    "spring_m": "is the mass. A larger one swings more slowly.",
    "spring_k": "is the stiffness of the spring. A stiffer one swings faster.",
    "shaft_J": "is the rotor's moment of inertia. It has the role of the mass.",
    "shaft_k_t": "is the torque for a twist of one radian. It has the role of the stiffness.",
    "pendulum_l": "is the length of the rod. Four times as long swings half as fast.",
    "pendulum_g": "is gravity: 1.62 on the Moon, 9.81 here, 24.8 on Jupiter.",
    "pendulum_m": "is the mass of the bob. It is a factor of m and of k, so it drops out: try it.",
    "rocking_m": "is the mass of the body. It drops out: try it.",
    "rocking_d": "is how far the centre of mass is from the pivot.",
    "rocking_r": "is the radius of gyration about the centre of mass.",
    "floating_m": "is the mass of the body; the water that moves along is left out.",
    "floating_A": "is the area that the waterline cuts.",
    "floating_rho": "is the density of the water.",
    "circuit_L": "is the inductance. It has the role of the mass.",
    "circuit_C": "is the capacitance; 1/C has the role of the stiffness.",
    "string_L": "is the length between the ends.",
    "string_T": "is the tension; the string has 0.4 g per metre.",
    "string_n": "is the number of half waves on the string. Type any whole number from 1 up.",
    "wave_wavelength": "is the wavelength, crest to crest; the water is deeper than half of it.",
    "wave_g": "is gravity, which pulls the crests down.",
    "wave_rho": "is the density of the water. It drops out: try it.",
    "pipe_L": "is the length between the closed ends.",
    "pipe_c": "is the speed of sound: 343 in air, 1007 in helium, both at 20 °C.",
    "pipe_n": "is the number of half waves in the pipe. Type any whole number from 1 up.",
}

_PULLS = {
    "spring_k",
    "shaft_k_t",
    "pendulum_g",
    "floating_A",
    "floating_rho",
    "circuit_C",
    "string_T",
    "wave_g",
    "pipe_c",
}

_LETTERS = {r"\rho": "ρ", r"\lambda": "λ"}


def quantities() -> dict[str, Quantity]:
    """The parameters of all systems by name, without the start of the pendulums."""
    found: dict[str, Quantity] = {}
    for system in ANALOGUES.values():
        found |= {f"{system.slug}_{p.name}": _quantity(f"{system.slug}_{p.name}", p) for p in system.parameters}
        if system.slug in LINEAR:
            found[f"{system.slug}_start"] = _start(system)
    return found


def groups(every: Mapping[str, Quantity], theta_0: Quantity) -> Iterator[Group]:
    """The group of each system, visible while it is chosen."""
    for slug, system in ANALOGUES.items():
        own = tuple(every[f"{slug}_{parameter.name}"] for parameter in system.parameters)
        yield Group("", own, system.name, folded=True, form=Forms.of[slug], idle_when_hidden=True)
    for slug in LINEAR:
        yield Group("", (every[f"{slug}_start"],), form=Forms.of[slug], idle_when_hidden=True)
    yield Group("", (theta_0,), form=Forms.swinging, idle_when_hidden=True)


def _quantity(name: str, parameter: Parameter) -> Quantity:
    low, high, scale = REACHES[name]
    kind = count if parameter.whole else positive
    facts = {} if parameter.whole else {"unit": parameter.unit, "scale": scale}
    return kind(
        parameter.default,
        label=_WHAT[name],
        symbol=_LETTERS.get(parameter.symbol, parameter.symbol),
        softbounds=(low, high),
        tint="k" if name in _PULLS else "m1",
        says=_SAYS[name],
        **facts,
    )


def _start(system: Analogue) -> Quantity:
    return finite(
        system.swing,
        label="start",
        symbol=STARTS[system.slug],
        unit=system.unit,
        softbounds=(0.0, LARGEST * system.swing),
        tint="m1",
        says="is where it starts, at rest. The period does not depend on it: this model is linear.",
    )


def start_angle() -> Quantity:
    """The angle at which a pendulum is released, in degrees."""
    return Quantity(
        60.0,
        label="angle at the start",
        symbol="θ_0",
        unit="°",
        bounds=(-180.0, 180.0),
        inclusive_bounds=(False, False),
        allowed="choose an angle between −180° and 180°, not 180° itself",
        softbounds=(0.0, 179.0),
        tint="m1",
        says="is the angle at the start. The period of a large swing is longer than that of a small one.",
    )

"""Additions to the table of physics.analogues: ranges of sliders, and sentences on each system."""

from typing import Literal, NamedTuple

LARGEST = 1.5
"""The upper end of the sliders for initial displacements, as a multiple of the system's default."""


class Reach(NamedTuple):
    """The ends of a slider, and its scale."""

    low: float
    high: float
    scale: Literal["log", "linear"] = "log"


REACHES = {
    "spring_m": Reach(0.1, 10),
    "spring_k": Reach(1, 1000),
    "shaft_J": Reach(0.001, 100),
    "shaft_k_t": Reach(1, 1e6),
    "pendulum_l": Reach(0.1, 100),
    "pendulum_g": Reach(1.62, 24.8, "linear"),
    "pendulum_m": Reach(0.1, 10),
    "rocking_m": Reach(0.1, 100),
    "rocking_d": Reach(0.01, 10),
    "rocking_r": Reach(0.01, 10),
    "floating_m": Reach(1, 1e8),
    "floating_A": Reach(0.01, 10000),
    "floating_rho": Reach(700, 1300, "linear"),
    "circuit_L": Reach(1e-7, 10),
    "circuit_C": Reach(1e-12, 0.01),
    "string_L": Reach(0.05, 10),
    "string_T": Reach(1, 1000),
    "string_n": Reach(1, 8, "linear"),
    "wave_wavelength": Reach(0.5, 1000),
    "wave_g": Reach(1.62, 24.8, "linear"),
    "wave_rho": Reach(700, 1300, "linear"),
    "pipe_L": Reach(0.05, 20),
    "pipe_c": Reach(250, 1100, "linear"),
    "pipe_n": Reach(1, 8, "linear"),
}
"""The sliders by system and parameter."""

REMARKS = {
    "floating": "The water that moves along (added mass) is left out.",
    "circuit": "The current is the velocity; resistance is left out.",
    "string": "The tension is written T here; the kinetic energy is that of mode n alone.",
    "wave": "A standing wave, η its height where it is largest; energies are averages per unit of surface; "
    "κ = 2π/λ, the water deeper than half a wavelength.",
    "pipe": "Closed at both ends; q is the displacement of the air where it is largest.",
}
"""Sentences about some systems."""

IN_TRUTH = {
    "spring": "while the force of the spring is −k x.",
    "shaft": "while the shaft stays elastic.",
    "floating": "while its walls at the waterline are upright, and neither its bottom nor its top gets there.",
    "circuit": "while L and C do not depend on the current and the charge.",
    "string": "while the slope of the string, π n q/L at most, is small.",
    "wave": "while its height from trough to crest, 2η, is far below λ/7.",
    "pipe": "while q is far below L/n.",
}
"""The range in which the model of a linear system is valid."""

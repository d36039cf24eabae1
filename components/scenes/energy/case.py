"""The case of a hanging mass: its motion, its energies by the datum of V, and everything that the paper shows."""

from __future__ import annotations

import math
from functools import cached_property

from components.language.picture import Pace
from components.layout.stage import wire
from components.paper.deferred import Attributes
from components.quantities.formatting import three
from components.quantities.motion import pace, scaled
from components.scene import Picture
from components.scene.about import About, bands_among, bounded, drift, few_of, points
from components.scene.case import Case
from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from physics.motion import constant
from physics.reference.single import hanging_points
from physics.sampling import periods

PLANETS = {"moon": ("Moon", 1.62), "mars": ("Mars", 3.71), "earth": ("Earth", 9.81), "jupiter": ("Jupiter", 24.8)}
"""Names and gravities in m/s^2."""


class EnergyCase(Case):
    """A motion of a hanging mass; `datum` is the position of V = 0."""

    m: float
    k: float
    g: float
    x_0: float
    v_0: float
    datum: str
    view: str

    @cached_property
    def system(self) -> HangingMass:
        return HangingMass(m=self.m, k=self.k, g=self.g)

    @cached_property
    def free(self) -> FreeOscillation:
        return FreeOscillation(oscillator=self.system.oscillator, x_0=self.x_0, v_0=self.v_0)

    @property
    def omega(self) -> float:
        return self.system.omega_n

    @property
    def lasting(self) -> float:
        return periods(2 * self.omega, 6)

    @property
    def highest(self) -> float:
        """Twice the frequency of x, because energies oscillate twice as fast."""
        return 2 * self.omega

    @property
    def resolved(self) -> float:
        return self.omega

    @property
    def pace(self) -> Pace:
        return pace(self.omega, self.omega)

    @property
    def C(self) -> float:
        return self.free.constants.C

    @property
    def separate(self) -> bool:
        """True if V is the sum of spring and gravity, without the constant of the slide."""
        return self.datum == "separate"

    @property
    def apart(self) -> bool:
        """True if V is drawn term by term."""
        return self.datum in ("separate", "slide")

    @cached_property
    def shift(self) -> float:
        return self.system.datum_shift if self.separate else 0.0

    @cached_property
    def E_total(self) -> float:
        return self.free.E + self.shift

    @property
    def weight(self) -> float:
        """m g C in J, the largest energy of gravity."""
        return scaled(0, self.m, self.g, self.C)

    @property
    def claim(self) -> str:
        """Return the name of the sentence on the largest T and V, which depends on the choice of V = 0."""
        if not self.C:
            return "rest_apart" if self.shift else "rest"
        return "weightless" if self.separate and not self.shift else self.datum

    @property
    def here(self) -> str:
        """The planet with this gravity, or an empty text."""
        return next((slug for slug, (_, g) in PLANETS.items() if g == self.g), "")

    def about(self, shown: Picture) -> About:
        columns, x = shown.sources["time"], {"x": "$x$"}
        energies = {"T": "$T$", "V": "$V$", "spring": "spring", "gravity": "gravity"}
        true = hanging_points(self.system, self.x_0, self.v_0, few_of(columns["t"]), self.separate)
        tables = (
            bounded("$x(t)$", 4, "its amplitude", points(x, columns, true)),
            bounded("an energy", 12, "its largest value", points(energies, columns, true)),
        )
        total = self.free.T + self.free.V
        return About(tables, drift(total.at(columns["t"]), self.free.E), bands_among(shown.sources, x | energies))


value = Attributes(EnergyCase)


class EnergyShown(EnergyCase):
    """Everything that the paper shows. Motions come first, in the order of the columns in a file."""

    x = value(lambda c: c.free.x)
    T = value(lambda c: c.free.T)
    V = value(lambda c: c.free.V + c.shift)
    spring = value.optional(lambda c: c.system.spring_along(c.free.x) if c.apart else None)
    gravity = value.optional(lambda c: -c.system.weight * c.free.x if c.apart else None)
    total = value(lambda c: constant(c.E_total))
    constant = value.optional(lambda c: constant(-c.system.datum_shift) if c.datum == "slide" else None)
    # Numbers in formulas.
    tau = value(lambda c: c.system.oscillator.period, "s", "period")
    delta = value(lambda c: c.system.delta_st, "m", "sag of the spring under the weight")
    delta_st = value(lambda c: f"{three(c.system.delta_st)} m")
    omega_2 = value(lambda c: 2 * c.omega, "rad/s", "frequency of T and V")
    T_max = value(lambda c: c.free.E, "J", "largest kinetic energy")
    v_max = value(lambda c: c.free.amplitude(1), "m/s", "largest speed")
    place = value(lambda c: "said")
    # Numbers of shapes.
    V_share = value(lambda c: (c.free.V + c.shift) / (c.E_total or 1.0))
    side = value(lambda c: min(max(math.sqrt(c.m), 0.5), 1.3))
    wire = value(lambda c: wire(c.k))
    has_energy = value(lambda c: c.E_total > 0)
    swinging = value(lambda c: c.C > 0)

"""The case of an oscillator: its motion, the rotating arrow, and everything that the paper shows."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal

from components.language.picture import Pace
from components.layout.stage import wire
from components.paper.deferred import Attributes
from components.quantities.formatting import plus, signed, three
from components.quantities.motion import pace, scaled
from components.scene import Picture
from components.scene.about import About, bands_among, bounded, drift, few_of, points, reason_of
from components.scene.case import Case
from components.scene.traces import Floats
from physics.free_oscillation import FreeOscillation
from physics.oscillator import Oscillator
from physics.reference.single import oscillator_points
from physics.sampling import periods, time_window
from physics.valid import in_range

MOST_SWINGS = 6
"""Largest window, in periods, in which a quarter period is long enough to be marked."""
LONGEST = 24
"""Largest number of characters of the numbers in the second form of x; a line has no room for more."""
SMALL = 0.15
"""Components of the initial arrow that are shorter than this, in amplitudes, have no name."""
MIDDLE = 2.6
"""Position of the name of the phase, as a fraction of its angle."""


class OscillatorCase(Case):
    """A free motion of mass and spring in the chosen view of the scene; without a spring the mass drifts."""

    m: float
    k: float
    x_0: float
    v_0: float
    view: str

    @cached_property
    def one(self) -> Oscillator:
        return Oscillator(m=self.m, k=self.k)

    @cached_property
    def free(self) -> FreeOscillation:
        return FreeOscillation(oscillator=self.one, x_0=self.x_0, v_0=self.v_0)

    @property
    def omega(self) -> float:
        return self.one.omega_n

    @property
    def lasting(self) -> float:
        return periods(self.omega, 2) if self.omega else time_window(0.0, 0.0)

    @property
    def highest(self) -> float:
        return self.omega

    @property
    def pace(self) -> Pace:
        return pace(self.omega, self.omega)

    @property
    def intervals(self) -> dict[str, tuple[float, int]]:
        """The interval of the paths in the planes (x, v) and (x, a): one period, or the window for a free mass."""
        return {"loop": (self.one.period, 145) if self.omega else (self.end, 2)}

    @property
    def kind(self) -> Literal["turn", "drift"]:
        return "turn" if self.omega else "drift"

    @property
    def spring(self) -> bool:
        return self.k > 0

    @property
    def phase(self) -> float:
        return self.free.constants.phi

    @property
    def turns(self) -> bool:
        """True if there is a rotating arrow: the mass is neither free nor at rest."""
        return self.omega > 0 and self.free.constants.C > 0

    @cached_property
    def why(self) -> Literal["drift", "still", "rest", "wrong", "right", "zero"]:
        """Return the name of the sentence on atan for these initial conditions, or on why there is no arrow."""
        if not self.omega:
            return "drift" if self.v_0 else "still"
        return "rest" if not self.turns else "wrong" if self.v_0 < 0 else "right" if self.v_0 else "zero"

    @property
    def characters(self) -> int:
        """The length of the numbers in the second form of x."""
        return len(three(self.x_0) + plus(self.free.constants.B) + 2 * three(self.omega))

    @property
    def is_drawn(self) -> bool:
        """True if x, v and a are slow enough for lines."""
        return self.is_line(self.omega)

    @cached_property
    def last_peak(self) -> float:
        """The last peak of x in the window, in periods; 0 if the earlier peaks of v and a leave no room for marks."""
        if not (self.turns and self.is_drawn and self.end / self.one.period <= MOST_SWINGS):
            return 0.0
        last = self.free.last_peak(self.end)
        return last if last >= 0.5 else 0.0

    def peak(self, derivative: int) -> float:
        """Return the time in s of that peak of x, or of the peak of v or a before it."""
        return (self.last_peak - derivative / 4) * self.one.period if self.last_peak else 0.0

    @property
    def heading(self) -> Literal["words", "turn", "drift"]:
        """The names of curves over a plot: words, or formulas with numbers."""
        return self.kind if self.view == "formulas" else "words"

    @property
    def greatest(self) -> float:
        """The largest force in N; 0 in a view without it."""
        return scaled(0, self.k, max(self.free.amplitude(0), abs(self.x_0))) if self.view == "force" else 0.0

    def about(self, shown: Picture) -> About:
        columns, names = shown.sources["time"], {"x": "$x$", "v": "$v$", "a": "$a$"}
        found = points(names, columns, oscillator_points(self.one, self.x_0, self.v_0, few_of(columns["t"])))
        tables = (bounded("$x(t)$, $v(t)$ or $a(t)$", 4, "its amplitude", found),)
        return About(tables, self._balance(columns["t"]), bands_among(shown.sources, names))

    def _balance(self, t: Floats) -> str:
        try:
            total = 0.5 * self.m * self.free.v**2 + 0.5 * self.k * self.free.x**2
            return drift(in_range("the energy", total.at(t)), self.free.E)
        except ValueError as reason:
            return f"$T + V$ cannot be computed over the window: {reason_of(reason)}."


value = Attributes(OscillatorCase)


class OscillatorShown(OscillatorCase):
    """Everything that the paper shows. Motions come first, in the order of the columns in a file."""

    x = value(lambda c: c.free.x)
    v = value(lambda c: c.free.v)
    a = value(lambda c: c.free.a)
    F = value.optional(lambda c: -c.k * c.free.x if c.view == "force" else None)
    sine = value.optional(lambda c: c.free.sine if c.omega else None)
    cosine = value.optional(lambda c: c.free.cosine if c.omega else None)
    # Numbers in formulas.
    tau = value.optional(lambda c: c.one.period if c.omega else None, "s", "period")
    C = value.optional(lambda c: c.free.constants.C if c.omega else None, "m", "amplitude")
    phi = value.optional(lambda c: c.free.constants.phi if c.omega else None, "rad", "phase at the start")
    phi_plus = value(lambda c: c.phase)
    atan = value(lambda c: c.phase - math.copysign(math.pi, c.phase))
    A = value(lambda c: signed(c.x_0))
    A_plain = value(lambda c: c.x_0)
    B = value(lambda c: signed(c.free.constants.B))
    B_plus = value(lambda c: c.free.constants.B)
    drift = value(lambda c: c.free.constants.drift, "m/s", "velocity without a spring")
    v_start = value(lambda c: signed(c.v_0))
    ratio = value(lambda c: scaled(0, c.omega, c.omega))
    top_x = value(lambda c: c.free.amplitude(0), "m", "largest displacement")
    top_v = value(lambda c: c.free.amplitude(1), "m/s", "largest speed")
    top_a = value(lambda c: c.free.amplitude(2), "m/s²", "largest acceleration")
    # Numbers of shapes.
    peak_x = value(lambda c: c.peak(0))
    peak_v = value(lambda c: c.peak(1))
    peak_a = value(lambda c: c.peak(2))
    swings = value.optional(lambda c: c.end / c.one.period if c.turns and c.is_drawn else None)
    side = value(lambda c: min(max(math.sqrt(c.m), 0.5), 1.5))
    wire = value(lambda c: wire(c.k))
    start_cosine = value(lambda c: math.cos(c.phase))
    start_sine = value(lambda c: math.sin(c.phase))
    middle_cosine = value(lambda c: math.cos(c.phase / MIDDLE))
    middle_sine = value(lambda c: math.sin(c.phase / MIDDLE))
    under = value(lambda c: math.copysign(1, c.phase))
    outside = value(lambda c: math.copysign(1, math.cos(c.phase)))
    # Which shapes and formulas are shown.
    names_A = value(lambda c: abs(math.sin(c.phase)) > SMALL)
    names_B = value(lambda c: abs(math.cos(c.phase)) > SMALL)
    names_phi = value(lambda c: abs(c.phase) > 0.4)
    is_wrong = value(lambda c: c.why == "wrong")
    forced = value(lambda c: c.view == "force" and c.k > 0)
    parts = value(lambda c: c.heading == "turn" and c.characters <= LONGEST)

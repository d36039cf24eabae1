"""The case of a damped motion: its kind, how it ends, its peaks, and everything that the paper shows."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal

import numpy as np

from components.dashpot import DashpotCase
from components.layout.stage import wire
from components.paper.deferred import Attributes
from components.quantities.formatting import short, signed, three
from components.quantities.motion import scaled
from components.scene import Picture
from components.scene.about import About, bands_among, bounded, drift, few_of, points, reason_of
from components.scene.traces import Floats
from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay, Moment
from physics.motion import constant
from physics.reference.damped import damped_points
from physics.sampling import NOTHING_OSCILLATES, periods
from physics.valid import in_range

DampedKind = Literal["rest", "drift", "glide", "plain", "under", "critical", "over"]
SAME = 1e-6
"""Relative distance from critical damping at which both roots count as one."""
HARDLY = 0.9
"""Damping ratio from which half a cycle leaves less than 0.2 % of the amplitude."""
LASTING = 5.0
"""Length of the window in time constants of the slower rate."""
HOME = 0.01
"""The mass counts as back at equilibrium within this share of x_0."""
ALL_BUT = 0.005
"""Logarithmic decrement below which the share of the amplitude that remains after a cycle would round to 100 %."""
MOST_PEAKS = 5
MEASURED = "measured"
"""The view of a visitor's own measured points."""
FEW = 4.0
"""Exponentials larger than this many times their sum are not drawn."""
TURN = np.linspace(np.pi / 2, 3 * np.pi / 2, 49)
AVERAGED = "The energies and the power change too fast to be drawn in this window: they are averages over a swing."


class DampedCase(DashpotCase):
    """A free damped motion in the chosen view of the scene."""

    view: str

    @cached_property
    def kind(self) -> DampedKind:
        if not self.k:
            return "glide" if self.c else "drift"
        if not self.x_0 and not self.v_0:
            return "rest"
        if not self.c:
            return "plain"
        if self.one.regime == "critical" or abs(self.one.zeta - 1) < SAME:
            return "critical"
        return "under" if self.one.zeta < 1 else "over"

    @property
    def swings(self) -> bool:
        return self.kind in ("plain", "under")

    @cached_property
    def said(self) -> str:
        """Return the name of the sentence on how the motion ends."""
        if self.kind in ("glide", "drift"):
            return self.kind if self.v_0 else "still"
        if self.kind == "under":
            return "swing" if self.one.zeta < HARDLY else "hardly"
        if self.kind not in ("critical", "over"):
            return self.kind
        if not self.x_0:
            return "never"
        if self.v_0 * self.x_0 < 0 and abs(self.v_0) > self.crossing_speed and self.free.first_zero is not None:
            return "crosses"
        if self.v_0 * self.x_0 > 0:
            return "out"
        return "thrice" if self.kind == "critical" and not self.v_0 else "home"

    @cached_property
    def lasting(self) -> float:
        lasting = self._lasting_with_spring if self.k else self._lasting_without_spring
        if not 0 < lasting < math.inf:
            raise ValueError("the decay time of this motion leaves the range of doubles")
        return lasting

    @property
    def _lasting_with_spring(self) -> float:
        slow, tau = self.one.rates[0], periods(self.one.omega_n, 1)
        lasting = LASTING / slow if slow else math.inf
        return max(2 * tau, min(lasting, 4 * tau) if self.one.zeta < 1 else lasting)

    @property
    def _lasting_without_spring(self) -> float:
        rate = self.c / self.m
        return LASTING / rate if rate else NOTHING_OSCILLATES

    @property
    def highest(self) -> float:
        """Twice the frequency of x, because energies oscillate twice as fast."""
        return 2 * self.one.omega_d if self.swings else self.one.rates[1]

    @property
    def resolved(self) -> float:
        return self.one.omega_d

    def notes(self) -> tuple[str, ...]:
        return () if self.is_line(2 * self.one.omega_d) else (AVERAGED,)

    @cached_property
    def peaks(self) -> list[Moment]:
        """The first maxima (or the first minima, if a minimum comes first) in the window; none in the view of measured
        points."""
        found = self.free.peaks(MOST_PEAKS) if self.kind == "under" and self.view != MEASURED else []
        return [peak for peak in found if peak.t <= self.end]

    @property
    def turning(self) -> float:
        """The displacement in m at the first turn, or at the start if there is no turn."""
        return self.free.moments([self.free.first_turn or 0.0])[0].x

    @cached_property
    def reach(self) -> float:
        """The largest |x| in the window in m."""
        return self.free.reach(self.end)

    @cached_property
    def P_max(self) -> float:
        """The largest power in W."""
        return scaled(0, self.c, self.free.fastest.v, self.free.fastest.v)

    @property
    def heading(self) -> Literal["words", "numbers"]:
        """The names of curves over a plot: words, or formulas with numbers."""
        return "numbers" if self.view == "formulas" else "words"

    @cached_property
    def greatest(self) -> float:
        """The largest force of spring or dashpot in N, in the window; 0 in a view without forces."""
        if self.view != "forces":
            return 0.0
        return max(scaled(0, self.k, self.reach), scaled(0, self.c, abs(self.free.fastest.v)))

    @cached_property
    def crossing_speed(self) -> float:
        """The initial speed in m/s towards 0 above which an overdamped mass passes 0."""
        return scaled(0, self.one.rates[1], abs(self.x_0))

    @property
    def root_kind(self) -> Literal["bare", "pair", "real"]:
        """The kind of the roots: without a spring, a complex pair, or both real."""
        return "bare" if not self.k else "pair" if self.one.zeta < 1 else "real"

    @cached_property
    def parted(self) -> bool:
        """True if both exponentials are drawn: near critical damping they are huge and opposite."""
        return self.kind == "over" and max(map(abs, self.free.fadings[0].late)) < FEW * self.reach

    def about(self, shown: Picture) -> About:
        columns, x = shown.sources["time"], {"x": "$x$"}
        true = damped_points(self.one, self.x_0, self.v_0, few_of(columns["t"]))
        energies = {"V": "$V$", "E": "$T + V$", "P": "$P$"} if not shown.columns.get("time") else {}
        tables = (
            bounded("$x(t)$", 4, "both parts of $x$ together", points(x, columns, true)),
            bounded("an energy or the power", 16, "what both parts could make it", points(energies, columns, true)),
        )
        return About(tables, self._balance(columns["t"]), bands_among(shown.sources, x))

    def _balance(self, t: Floats) -> str:
        """Return the sentence on how far T + V plus the heat, each from its own formula, differs from E_0."""
        try:
            energies = 0.5 * self.k * self.free.x**2 + 0.5 * self.m * self.free.v**2
            total = in_range("the energy", energies.at(t))
            return drift(total + self.free.lost(t), self.free.E_0, "$T + V$ + heat")
        except ValueError as reason:
            return f"The balance of the energies cannot be computed over the window: {reason_of(reason)}."


def percent(share: float) -> str:
    return f"{short(100 * share)} %"


def kept(decrement: float, least: float = ALL_BUT) -> str:
    """Return exp(-decrement) in percent, or what is missing to 100 % if that is below `least`."""
    if 0 < decrement < least:
        return f"all but {percent(-math.expm1(-decrement))}"
    return percent(math.exp(-decrement))


def _home_thrice(case: DampedCase) -> float:
    """The time in s until the mass is back at equilibrium, released at rest with three times the damping."""
    heavier = DampedOscillator(m=case.m, c=scaled(0, 3.0, case.c), k=case.k)
    return FreeDecay(oscillator=heavier, x_0=case.x_0, v_0=0.0).settled(HOME) or 0.0


def _where(case: DampedCase) -> str:
    """The word for the place where the dashpot takes the most energy."""
    if not (case.c and case.P_max):
        return ""
    return "at_start" if not case.free.fastest.t else "before" if case.kind == "under" else "fastest"


def _formula(case: DampedCase) -> str:
    """The word for the formula of the roots."""
    return {"critical": "critical", "plain": "wall"}.get(case.kind, case.root_kind)


value = Attributes(DampedCase)


class DampedShown(DampedCase):
    """Everything that the paper shows. Motions come first, in the order of the columns in a file."""

    x = value(lambda c: c.free.x)
    upper = value.optional(lambda c: c.free.envelope if c.kind == "under" else None)
    lower = -upper
    slow_part, fast_part = value.pair(lambda c: c.free.parts if c.parted else None, called=("slow", "fast"))
    V = value(lambda c: 0.5 * c.k * c.free.x**2)
    T = value(lambda c: 0.5 * c.m * c.free.v**2)
    E = V + T
    E_0 = value(lambda c: constant(c.free.E_0))
    heat = (E_0 - E).where(lambda c: c.c > 0)
    P = value.optional(lambda c: c.c * c.free.v**2 if c.c else None)
    pull = value.optional(lambda c: -c.k * c.free.x / c.greatest if c.k and c.greatest else None)
    brake = value.optional(lambda c: -c.c * c.free.v / c.greatest if c.c and c.greatest else None)
    locus = value(lambda c: {"re": c.one.omega_n * np.cos(TURN), "im": c.one.omega_n * np.sin(TURN)} if c.k else {})
    # Numbers in formulas.
    E_total = value(lambda c: c.free.E_0, "J", "energy at the start")
    omega = value(lambda c: c.one.omega_n if c.k else three(0.0), "rad/s", "natural frequency")
    zeta = value(lambda c: c.one.zeta if c.k else "none", "", "damping ratio")
    rate = value(lambda c: three(c.one.rates[1]) if c.k else c.one.rates[1], "1/s", "rate c/m, without a spring")
    omega_d = value(lambda c: c.one.omega_d or three(0.0), "rad/s", "frequency of the damped motion")
    delta = value(lambda c: c.one.log_decrement if c.one.omega_d else "∞", "", "logarithmic decrement")
    square = value(lambda c: c.k / c.m, "1/s²", "square of the natural frequency")
    a = value(lambda c: c.one.rates[0], "1/s", "slower decay rate")
    slow = value(lambda c: -c.one.rates[0], "1/s", "slower root")
    fast = value(lambda c: -c.one.rates[1], "1/s", "faster root")
    C = value.optional(lambda c: c.free.amplitude_and_phase[0] if c.swings else None, "m", "amplitude at the start")
    phi = value.optional(lambda c: c.free.amplitude_and_phase[1] if c.swings else None, "rad", "phase at the start")
    A = value(lambda c: signed(c.free.fadings[0].late[0]) if c.kind == "over" else c.x_0)
    B = value(lambda c: c.free.fadings[0].late[1] if c.kind == "over" else c.free.fadings[0].rate)
    tau_d = value.optional(lambda c: 2 * math.pi / c.one.omega_d if c.one.omega_d else None, "s", "period")
    # Numbers in the sentence.
    keep = value.optional(lambda c: kept(c.one.log_decrement) if c.one.omega_d else None)
    keep_x = value(lambda c: f"× {three(math.exp(-c.one.log_decrement))}")
    keep_energy = value(lambda c: kept(2 * c.one.log_decrement, 2 * ALL_BUT))
    half = value(lambda c: kept(c.one.log_decrement / 2))
    longer = value(lambda c: percent(math.expm1(-math.log1p(-(c.one.zeta**2)) / 2) if c.one.zeta < 1 else 0.0))
    home = value.optional(
        lambda c: c.free.settled(HOME) or 0.0 if c.said in ("home", "thrice") else None,
        "s",
        "time until 1 % of the start",
    )
    home_3 = value.optional(
        lambda c: _home_thrice(c) if c.said == "thrice" else None, "s", "the same with three times the damping"
    )
    farthest = value.optional(lambda c: signed(c.turning) if c.said == "out" else None)
    zero = value.optional(
        lambda c: c.free.first_zero or 0.0 if c.said == "crosses" else None, "s", "time of the only zero"
    )
    crossing = value.optional(
        lambda c: c.crossing_speed if c.said == "crosses" else None, "m/s", "inward speed above which the mass passes 0"
    )
    glide = value.optional(
        lambda c: scaled(0, abs(c.v_0), 1 / c.one.rates[1]) if c.said == "glide" else None,
        "m",
        "distance that the mass glides",
    )
    # Which formulas and words are shown.
    power = value(lambda c: c.c > 0)
    x_form = value(lambda c: "words" if c.heading == "words" else "parts" if c.parted else c.kind)
    envelope_form = value.optional(lambda c: c.heading if c.kind == "under" else None)
    parts_form = value.optional(lambda c: c.heading if c.parted else None)
    roots = value(_formula)
    fastest = value(_where)
    # The stage.
    side = value(lambda c: min(max(c.m**0.15, 0.75), 1.25))
    wire = value(lambda c: wire(c.k))
    over = value.optional(lambda c: math.copysign(1.0, c.peaks[0].x) if c.peaks else None)
    quickest = value.optional(
        lambda c: c.free.fastest if c.P_max and 0 < c.free.fastest.t < c.end and c.view != MEASURED else None
    )
    # The plane of the roots. Draggable values are in units of the natural frequency.
    circle = value(lambda c: c.one.omega_n or c.one.rates[1] or 1.0)
    slow_root = value(lambda c: scaled(0, c.one.rates[0], 1 / c.one.omega_n) if c.root_kind == "real" else 1.0)
    bare_root = value(lambda c: -c.one.rates[1])
    legs = value(lambda c: c.root_kind == "pair" and 0.04 < c.one.zeta < 0.98)
    apart = value(lambda c: c.root_kind == "real" and c.one.zeta > 1.02)

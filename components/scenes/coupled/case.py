"""The case of two coupled masses: a free motion, given by its start or by its modes, and everything that is shown."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np

from components.chain.about import MASSES, free_drift, modal_rows, motion_rows
from components.chain.case import ChainCase
from components.chain.modes import PARTS, directions
from components.chain.stage import Extremes, without_roundings
from components.language.picture import Onward, Pace
from components.paper.deferred import Attributes
from components.quantities.axes import Axis, nice_axis, widest
from components.quantities.formatting import signed, three
from components.quantities.motion import pace
from components.scene import Picture
from components.scene.about import About, CheckedPoint, bands_among, bounded, few_of
from components.scene.traces import Columns
from physics.coupled import FreeModes, free_modes
from physics.free_motions import ChainMotions, FreeMotions
from physics.modal_start import modes_given
from physics.motion import ExactMotion, Harmonic, constant, harmonic_motion
from physics.reference.driven_chain import points_of_modes
from physics.sampling import time_window
from physics.valid import in_range

BEATS = 1e-3
"""If a mode is smaller than this share of the other one, no beats are visible."""
CLOSE = 0.2
"""Two sines are seen to beat if the difference of their frequencies, divided by the sum, is at most this."""
FAST = "The fast motion is too fast for a line and fills the band that is drawn. "


class CoupledCase(ChainCase):
    """A free motion of the chain."""

    x1_0: float
    x2_0: float
    v1_0: float
    v2_0: float
    given_by: str
    X_slow: float
    phi_slow: float
    X_fast: float
    phi_fast: float
    energy: str
    view: str

    @cached_property
    def free(self) -> FreeModes:
        if self.given_by == "values":
            return free_modes(self.chain, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))
        return modes_given(self.chain, (self.X_slow, self.X_fast), (self.phi_slow, self.phi_fast))

    @cached_property
    def motions(self) -> FreeMotions:
        return FreeMotions(self.free)

    @property
    def both(self) -> ChainMotions:
        return self.motions.both

    @property
    def slow(self) -> float:
        """The frequency of the slow mode in rad/s, 0 if it drifts."""
        return float(self.free.omega[0])

    def onward(self) -> tuple[Onward, ...]:
        is_chain = (self.m1, self.k1, self.x2_0, self.v2_0) == (self.m2, self.k2, 0.0, 0.0) and self.k1 > 0
        given = {"m": self.m1, "k": self.k1, "a": 1.8, "h": self.x1_0, "v_0": self.v1_0, "N": 2.0, "p": 1.0}
        two = Onward(label="Open in Chain", scene="chain", given={**given, "ends": "fixed-free", "starts": "mass"})
        return (two,) if is_chain else ()

    @property
    def highest(self) -> float:
        return float(self.free.omega[1])

    @property
    def lasting(self) -> float:
        return time_window(self.slow, self.highest)

    @property
    def pace(self) -> Pace:
        return pace(self.slow or self.highest, self.highest)

    def notes(self) -> tuple[str, ...]:
        if self.is_line(2 * self.highest):
            return super().notes()
        fast = "" if self.is_line(self.highest) else FAST
        return (*super().notes(), f"{fast}Energies are averages over a fast swing.")

    @cached_property
    def extremes(self) -> Extremes:
        found = {name: getattr(self.both, name).extremes(self.times) for name in ("x1", "x2", "e2")}
        return {name: (without_roundings(low), without_roundings(high)) for name, (low, high) in found.items()}

    @cached_property
    def axis_of_both(self) -> Axis:
        """The axis of both masses."""
        return nice_axis(*widest(self.extremes["x1"], self.extremes["x2"]), "m", 3)

    @cached_property
    def beat(self) -> Literal["rest", "drift", "one", "both", "apart"]:
        """The word for beats: both modes move, neither drifts, their frequencies are close. Otherwise the reason."""
        if not (self.free.amplitude.any() or self.free.drift_b.any()):
            return "rest"
        if not self.slow:
            return "drift"
        sizes = [sorted(map(abs, of_mass)) for of_mass in self.free.amplitude.T.tolist()]
        if not any(less > BEATS * more for less, more in sizes):
            return "one"
        return "both" if self.chain.modes().beat <= CLOSE * (self.slow + self.highest) else "apart"

    @property
    def slow_fact(self) -> Literal["sine", "two", "drift", "free"]:
        """The kind of the slow mode: a sine, a drift of both masses or of mass 2 alone, or all there is."""
        return "sine" if self.slow else "two" if not self.highest else "drift" if self.k2 else "free"

    @property
    def slow_omega(self) -> Literal["sine", "two", "drift"]:
        return "drift" if self.slow_fact == "free" else self.slow_fact

    @cached_property
    def strongest(self) -> float:
        """The largest force on a mass in N; 0 in a view without forces."""
        forces = self.pulls or ()
        return max((float(np.abs(in_range("the force on a mass", F.at(self.times))).max()) for F in forces), default=0)

    @cached_property
    def pulls(self) -> tuple[ExactMotion, ExactMotion] | None:
        """The forces of the springs on both masses, in a view that shows them."""
        if self.view != "forces":
            return None
        pull = self.k2 * self.both.e2
        return pull - self.k1 * self.both.e1, -pull

    def level(self, energy: float) -> ExactMotion | None:
        """The energy of a mode, in a view of these."""
        return constant(float(energy)) if self.energy == "modes" else None

    def part(self, energy: ExactMotion) -> ExactMotion | None:
        """The energy of a mass or spring, in a view of these."""
        return energy if self.energy == "parts" else None

    def about(self, shown: Picture) -> About:
        columns = shown.sources["time"]
        modes = {f"x{i}_{mode}": f"$x_{i}$, {mode}" for i, mode in PARTS if f"x{i}" not in columns}
        points = bounded("$x_1(t)$, $x_2(t)$ or a mode", 2, "its amplitudes", self._points(MASSES | modes, columns))
        bands = MASSES | {f"x{i}_{mode}": f"the {mode} mode" for i, mode in PARTS}
        return About((points,), free_drift(self.free, columns["t"]), bands_among(shown.sources, bands))

    def _points(self, names: dict[str, str], columns: Columns) -> list[CheckedPoint]:
        """Return points whose errors are checked: of the displacements, or of the modes if displacements are bands."""
        if self.given_by == "values":
            return motion_rows(names, columns, self.chain, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))
        given = (self.X_slow, self.X_fast), (self.phi_slow, self.phi_fast)
        return modal_rows(names, columns, points_of_modes(self.chain, *given, np.array(few_of(columns["t"]))))


def shape(ratio: float) -> str:
    return "∞" if math.isinf(ratio) else signed(ratio)


class ModeHand(NamedTuple):
    """A drag of a mass in a mode.

    `other` is the displacement of the other mass over its displacement, `amplitude` that of the mode. Both are 0 if the
    mass rests in the mode.
    """

    other: float
    amplitude: float


def _hands(case: CoupledCase, j: int) -> tuple[ModeHand, ModeHand] | None:
    """The drag of each mass in the mode j; None if nothing oscillates."""
    one, two = directions(case.chain)[j]
    if not case.highest:
        return None
    first = ModeHand(two / one, 1.0) if one else ModeHand(0.0, 0.0)
    return first, ModeHand(one / two, one / two if one else 1.0) if two else ModeHand(0.0, 0.0)


def _turn(case: CoupledCase, phase: float, omega: float) -> ExactMotion | None:
    """The argument of the sine of a mode in rad, if the modes determine the motion."""
    if case.given_by == "values":
        return None
    return harmonic_motion("turn", Harmonic((), (phase, omega)), lambda t: phase + omega * t)


value = Attributes(CoupledCase)


class CoupledShown(CoupledCase):
    """Everything that the paper shows. Motions come first, in the order of the columns in a file."""

    x1 = value(lambda c: c.both.x1)
    x1_slow = value(lambda c: c.motions.slow.x1)
    x1_fast = value.optional(lambda c: c.motions.fast and c.motions.fast.x1)
    x2 = value(lambda c: c.both.x2)
    x2_slow = value(lambda c: c.motions.slow.x2)
    x2_fast = value.optional(lambda c: c.motions.fast and c.motions.fast.x2)
    T1 = value.optional(lambda c: c.part(0.5 * c.m1 * c.both.v1**2))
    V1 = value.optional(lambda c: c.part(0.5 * c.k1 * c.both.e1**2))
    V2 = value.optional(lambda c: c.part(0.5 * c.k2 * c.both.e2**2))
    T2 = value.optional(lambda c: c.part(0.5 * c.m2 * c.both.v2**2))
    E_slow = value.optional(lambda c: c.level(c.free.energy[0]))
    E_fast = value.optional(lambda c: c.level(c.free.energy[1]))
    total = value.optional(lambda c: c.level(c.free.energy.sum()), called="E_total")
    F1, F2 = value.pair(lambda c: c.pulls)
    # Values that a drag of a mode sets or keeps.
    slow_hands = value.optional(lambda c: _hands(c, 0))
    fast_hands = value.optional(lambda c: _hands(c, 1))
    v1_slow = value(lambda c: c.motions.slow.v1)
    v1_fast = value.optional(lambda c: c.motions.fast and c.motions.fast.v1)
    v2_slow = value(lambda c: c.motions.slow.v2)
    v2_fast = value.optional(lambda c: c.motions.fast and c.motions.fast.v2)
    turn_slow = value.optional(lambda c: _turn(c, c.phi_slow, c.slow))
    turn_fast = value.optional(lambda c: _turn(c, c.phi_fast, c.highest))
    # Numbers in formulas.
    omega_minus, omega_plus = value.pair(
        lambda c: c.free.omega.tolist(), "rad/s", ("slow natural frequency", "fast natural frequency")
    )
    slow_ratio, fast_ratio = value.pair(
        lambda c: c.chain.modes().ratio.tolist(), "", ("X2/X1 of the slow mode", "X2/X1 of the fast mode")
    )
    ratio_minus, ratio_plus = value.pair(lambda c: [shape(ratio) for ratio in c.chain.modes().ratio.tolist()])
    E_minus, E_plus = value.pair(
        lambda c: c.free.energy.tolist(), "J", ("energy of the slow mode", "energy of the fast mode")
    )
    E_total = value(lambda c: float(c.free.energy.sum()), "J", "total energy")
    X1_minus, X2_minus = value.pair(
        lambda c: c.free.amplitude[0].tolist(),
        "m",
        ("amplitude of mass 1, slow mode", "amplitude of mass 2, slow mode"),
    )
    X1_plus, X2_plus = value.pair(
        lambda c: c.free.amplitude[1].tolist(),
        "m",
        ("amplitude of mass 1, fast mode", "amplitude of mass 2, fast mode"),
    )
    phi_minus, phi_plus = value.pair(
        lambda c: c.free.phase.tolist(), "rad", ("phase of the slow mode", "phase of the fast mode")
    )
    a1, a2 = value.pair(lambda c: c.free.drift_a.tolist())
    b1, b2 = value.pair(lambda c: c.free.drift_b.tolist())
    M_minus, M_plus = value.pair(
        lambda c: [mode.mass for mode, _, _ in c.free.each()], "kg", ("modal mass, slow mode", "modal mass, fast mode")
    )
    q_minus, q_plus = value.pair(lambda c: [signed(coordinate) for _, coordinate, _ in c.free.each()])
    rate_minus, rate_plus = value.pair(lambda c: [signed(rate) for _, _, rate in c.free.each()])
    beat_period = value(lambda c: f"{three(math.tau / c.chain.modes().beat)} s" if c.beat == "both" else "none")
    # Which formulas are shown.
    slow_term = value(lambda c: "words" if c.view != "formulas" else "sine" if c.slow else "drift")
    fast_term = value(lambda c: "" if not c.highest else "words" if c.view != "formulas" else "sine")
    fast_fact = value(lambda c: "sine" if c.highest else "")
    constants = value(lambda c: "shapes" if c.k2 else "loose")

"""A machine on a mounting: its driven motion with an absorber, and the goals for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from components.chain.parameters import Pair
from components.quantities.formatting import three
from components.scene.traces import Floats
from physics.absorber import (
    Band,
    alone,
    damped_amplitude,
    damped_solution,
    fixed_points,
    helped_band,
    swing_and_stroke,
)
from physics.absorber_curves import machine_curves
from physics.coupled import Motion, TwoMassChain
from physics.forced import REST, DrivenModes, antiresonance, driven_modes
from physics.oscillator import Oscillator
from physics.precision.exact import exact, precise, rounded
from physics.transient import DRAWING, DampedModes

SWING, STROKE, AWAY = 0.5, 7.5, 0.2
"""The goals: swing and stroke in static deflections F_0/k1, and the relative distance from the running speed within
which no resonance may be.
"""
EXACT, SAME = 4e-16, 5e-4
"""Relative distances of the absorber's own frequency from the running speed: tuned up to rounding errors, and almost
tuned, equal to three digits.
"""
LEFT = 0.01
"""The share of the machine's swing without absorber that may be left if the absorber is almost tuned."""
SMALL = 10.0
"""Limit in static deflections, or in multiples of the machine's swing in the other mode. If the machine swings less in
the mode near resonance, it hardly takes part in the resonance.
"""
FAR = 100.0
"""The other mode's frequency must be this many times farther from the drive, so that it does not grow too."""
BEND = (1 - np.cos(np.linspace(0, math.pi, 110))) / 2
"""Shares of a distance, dense near both of its ends."""
TOLD = 1e-15
"""A drive that is relatively closer to a resonance counts as resonant: the motions would differ only at times so late
that a double does not resolve their phase.
"""
LARGEST, SMALLEST = 1e200, 1e-300


@dataclass(frozen=True, kw_only=True)
class AbsorberCase:
    """Machine m1, k1 under F_0 sin(omega t), absorber m2, k2 with damping c; SI units. The clock plays the particular
    solution, or with `from_rest` the motion from a start: at rest, or with x_0 and v_0.
    """

    m1: float
    k1: float
    F_0: float
    omega: float
    m2: float
    k2: float
    c: float = 0.0
    from_rest: bool = False
    x_0: Pair = REST
    v_0: Pair = REST

    @property
    def whence(self) -> str:
        """The words for how the motion starts."""
        return "from its start" if any((*self.x_0, *self.v_0)) else "from rest"

    @cached_property
    def chain(self) -> TwoMassChain:
        return TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)

    @cached_property
    def driven(self) -> DrivenModes:
        return driven_modes(self.chain, self.F_0, self.omega, self.x_0, self.v_0)

    @cached_property
    def bare(self) -> DrivenModes:
        """The machine without the absorber, from the same start."""
        return driven_modes(alone(self.chain), self.F_0, self.omega, (self.x_0[0], 0.0), (self.v_0[0], 0.0))

    @cached_property
    def own(self) -> float:
        """The natural frequency of the machine without the absorber."""
        return Oscillator(m=self.m1, k=self.k1).omega_n

    @cached_property
    def natural(self) -> Pair:
        """Both natural frequencies with the absorber."""
        slow, fast = self.driven.free.omega.tolist()
        return slow, fast

    def deflections(self, count: float) -> float:
        """Return a multiple of the static deflection F_0/k1, in m."""
        with precise():
            deflection = rounded("the static deflection F_0/k1", exact(count) * exact(self.F_0) / exact(self.k1))
        if deflection < SMALLEST:
            raise ValueError(
                f"the static deflection F_0/k1 = {deflection:.3g} m cannot be drawn: at least {SMALLEST:g} m is needed"
            )
        return deflection

    def over_deflection(self, way: float) -> float:
        """Return a displacement in static deflections."""
        with precise():
            ratio = exact(way) * exact(self.k1) / exact(self.F_0)
        if ratio > LARGEST:
            raise ValueError(
                f"the motion is too large to be drawn: at most {LARGEST:g} static deflections F_0/k1 are allowed"
            )
        return float(ratio)

    @cached_property
    def X(self) -> NDArray[np.complex128]:
        if self.c:
            return damped_solution(self.chain, self.c, self.F_0, self.omega)
        X = self.driven.particular.astype(complex)
        return np.where(X != 0, np.inf, X) if self.resonates else X

    @cached_property
    def pull(self) -> float:
        """The amplitude of the force of spring and damper, which accelerates mass 2: m2 omega^2 |X2|."""
        X2 = exact(abs(complex(self.X[1])))
        with precise():
            return rounded("the pull of spring 2", exact(self.m2) * exact(self.omega) ** 2 * X2)

    @cached_property
    def swings(self) -> tuple[float, float, float]:
        """The machine's swing, the absorber's stroke, and the machine's swing without the absorber, in x_p, in m; inf
        at a resonance.
        """
        grows = self.resonates and not self.c
        with_it = (math.inf,) * 2 if grows else swing_and_stroke(self.chain, self.c, self.F_0, self.omega)
        by_itself = math.inf if self.bare.at_resonance else abs(float(self.bare.particular[0]))
        return float(with_it[0]), 0.0 if self.loose else float(with_it[1]), by_itself

    @property
    def loose(self) -> bool:
        """True if nothing connects the absorber to the machine. Then the stroke is undefined."""
        return not self.k2 and not self.c

    @cached_property
    def damped(self) -> DampedModes:
        return DampedModes(chain=self.chain, c=self.c, F_0=self.F_0, omega=self.omega, x_0=self.x_0, v_0=self.v_0)

    @property
    def alike(self) -> bool:
        """True if two exponents of the damped motion are treated as equal. Then only their sum is accurate."""
        return self.c > 0 and any(len(amplitudes) > 1 for _, amplitudes in self.damped.transient)

    @property
    def fastest(self) -> float:
        """The largest angular frequency of the motions."""
        return max(self.omega, self.natural[1])

    def from_rest_at(self, t: Floats) -> Motion:
        """Return the motion from its start. Raise ValueError if it takes longer than a picture may."""
        if self.alike:  # use the sum of both, because each alone is huge
            x, v = self.damped.drawn(t)
            return Motion(t, x[:2], v[:2], x[::2])
        return self.damped.motion(t, DRAWING) if self.c else self.driven.motion(t)

    @cached_property
    def bounds(self) -> tuple[float, float]:
        """The bounds of swing and stroke from the start, in m; inf if they grow."""
        if self.c:
            with_it = _damped_bounds(self.damped)
        else:
            with_it = (math.inf, math.inf) if self.resonates else _bounds(self.driven)
        return with_it[0], 0.0 if self.loose else with_it[1]

    @cached_property
    def bound_alone(self) -> float:
        """The bound of the machine's swing without the absorber from the start, in m; inf if it grows."""
        return math.inf if self.bare.at_resonance else _bounds(self.bare)[0]

    @cached_property
    def solved(self) -> bool:
        """True if a particular solution exists and is worth drawing."""
        return self.c > 0 or self.driven.split_is_meaningful

    @property
    def plays(self) -> bool:
        """True if the clock plays the particular solution with the absorber."""
        return self.solved and not self.from_rest

    @property
    def plays_alone(self) -> bool:
        """True if the clock plays the particular solution of the machine without the absorber."""
        return self.bare.split_is_meaningful and not self.from_rest

    @cached_property
    def nearest(self) -> tuple[int, float]:
        """Return the nearest resonance (0 slow, 1 fast), and its relative distance from the speed."""
        with precise():
            shares = [abs(exact(d)) / exact(self.omega) for d in self.driven.detuning.tolist()]
        j = int(shares[1] < shares[0])
        return j, float(min(shares[j], exact(LARGEST)))

    @cached_property
    def fixed(self) -> dict[str, Pair]:
        """Frequency and swing of the points P and Q, which do not depend on damping, if they exist."""
        if not self.c:
            return {}
        points = fixed_points(self.chain)
        swings = damped_amplitude(self.chain, self.c, self.F_0, points)[0]
        return dict(zip("PQ", zip(points.tolist(), swings.tolist(), strict=True), strict=True))

    @cached_property
    def limits(self) -> tuple[float, float]:
        return self.deflections(SWING), self.deflections(STROKE)

    @cached_property
    def met(self) -> tuple[bool, bool, bool]:
        """The three goals: no resonance near, a quiet machine, a short stroke of the absorber."""
        swing, stroke, _ = self.swings
        return self.nearest[1] >= AWAY, swing <= self.limits[0], stroke <= self.limits[1]

    @cached_property
    def aside(self) -> bool:
        """True if the machine hardly takes part in the resonance near the drive. Then only the swing of mass 2
        grows."""
        j = self.nearest[0]
        with precise():
            omega = exact(self.omega)
            detunings = [abs(exact(d)) for d in self.driven.detuning.tolist()]
            ways = zip(detunings, self.natural, strict=True)
            off = [max(detuning, exact(TOLD) * omega) * (omega + exact(own)) for detuning, own in ways]
            part, other = (exact(self.F_0) * exact(self.driven.coupling[i, 0]) / off[i] for i in (j, 1 - j))
            steady = other if detunings[1 - j] > exact(FAR) * detunings[j] else Decimal(0)
            small = part <= exact(SMALL) * max(exact(self.deflections(1.0)), steady)
        return not self.solved and detunings[j] > 0 and small

    @property
    def resonates(self) -> bool:
        """True if the machine's swing grows without limit, as far as doubles resolve that."""
        return self.driven.at_resonance and not self.aside

    @property
    def unsolved(self) -> str:
        """The name of the sentence on the swing from rest at a resonance or very close to it."""
        return "aside" if self.aside else "grow" if self.resonates else "beat"

    @cached_property
    def verdict(self) -> str:
        swing, _, without = self.swings
        if self.loose:
            return "detached"
        if not self.solved:
            return self.unsolved
        tuned = antiresonance(self.chain)
        if not self.c and math.isclose(tuned, self.omega, rel_tol=EXACT):
            return "still"
        if not self.c and math.isclose(tuned, self.omega, rel_tol=SAME) and swing <= LEFT * without:
            return "almost"
        if three(swing) == three(without):
            return "same"
        return "less" if swing < without else self._harm

    @property
    def _harm(self) -> str:
        """The reason for a larger swing of the machine: a resonance is near, or spring 2 pulls with the drive, or too
        strongly against it.
        """
        if self.nearest[1] < AWAY:
            return "more"
        slow, fast = self.driven.detuning.tolist()
        return "adds" if (slow > 0) == (fast > 0) else "over"

    @cached_property
    def band(self) -> Band | None:
        return helped_band(self.chain, self.c)

    def frequencies(self, low: float, high: float) -> Floats:
        """Drive frequencies for curves over [low, high], dense near the poles, including all marked frequencies."""
        poles = {self.own, *self.chain.modes().omega.tolist()}
        if self.c:
            poles.add(Oscillator(m=self.m1 + self.m2, k=self.k1).omega_n)
        ends = [low, *sorted(p for p in poles if low < p < high), high]
        pieces = [a + (b - a) * BEND for a, b in pairwise(ends)]
        marked = [w for w in (self.omega, antiresonance(self.chain), *(self.band or ())) if low < w < high]
        return np.unique(np.concatenate([*pieces, marked]))

    def curves(self, w: Floats) -> tuple[Floats, Floats, Floats]:
        """Swing, stroke and swing without the absorber at drive frequencies w."""
        swing, stroke, by_itself = machine_curves(self.chain, self.c, self.F_0, w)
        return (by_itself, np.zeros_like(w), by_itself) if self.loose else (swing, stroke, by_itself)


def _bounds(driven: DrivenModes) -> tuple[float, float]:
    """The bounds of |x1| and |x2 - x1| from rest: the particular amplitude plus those of both modes."""
    one, two = driven.particular.tolist()
    modes = driven.complementary_modes.amplitude
    return abs(one) + float(np.abs(modes[:, 0]).sum()), abs(two - one) + float(np.abs(modes[:, 1] - modes[:, 0]).sum())


def _damped_bounds(damped: DampedModes) -> tuple[float, float]:
    """The bounds of |x1| and |x2 - x1| with damping: each term t^j exp(-decay t) of the transient at its maximum."""
    reach = np.abs(damped.particular)[[0, 2]]
    for exponent, amplitudes in damped.transient:
        for j, row in enumerate(np.abs(amplitudes)):
            top = (j / (math.e * -exponent.real)) ** j if j and exponent.real < 0 else math.inf if j else 1.0
            reach = reach + row[[0, 2]] * top
    return float(reach[0]), float(reach[1])

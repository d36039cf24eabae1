"""The driven motion without dashpots: its parts, its energies, and near resonance the envelope of the growing beat."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from components.chain import BOTH, MODES, components, free_signals, positions
from components.chain.forces import Forces, forces
from components.chain.parameters import Pair
from components.language.expressions import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.declared import Column, Signal, by_name
from components.quantities.motion import derived, responses, sines, total
from components.scene.traces import Columns, Floats, band_columns, trace
from components.scenes.forced.case import Both, ForcedCase, Found, Growth, Work, of_both
from components.scenes.forced.case import Signals as S
from physics.energy import chain_energy
from physics.forced import DrivenModes, determinant
from physics.sampling import Sinusoid, drawable

APART = 0.98
"""If the envelope ends below this share of the straight line, both are drawn."""
STRAIGHT = 1e-8
"""In rad; if the phase of an envelope changes less in its window, it equals the straight line to the last digit."""


@dataclass(frozen=True, eq=False)
class Undamped(ForcedCase):
    """A driven motion without damping."""

    modes: DrivenModes

    @property
    def split(self) -> bool:
        """True if the parts are drawn."""
        return self.modes.split_is_meaningful

    @property
    def resonant(self) -> bool:
        """True if the drive is so close to a natural frequency that the motion is not shown as two parts."""
        return self.modes.omega > 0 and not self.split

    @property
    def kind(self) -> str:
        """The form of the particular solution."""
        if self.modes.at_resonance:
            return "resonance"
        return "near" if self.resonant else "finite" if self.chain.k2 else "loose"

    @property
    def moves(self) -> bool:
        """True if the initial conditions alone cause a motion."""
        return bool(np.any(self.modes.free.amplitude) or np.any(self.modes.free.drift_b))

    @cached_property
    def swings(self) -> Pair:
        """Xp1 and Xp2; infinite at resonance, except for a mass 2 without a spring."""
        if self.modes.at_resonance:
            return math.inf, math.inf if self.chain.k2 else 0.0
        one, two = self.modes.particular.tolist()
        return one, two

    @property
    def D(self) -> float:
        return 0.0 if self.modes.at_resonance else determinant(self.chain, self.modes.omega)

    @cached_property
    def growth(self) -> Pair:
        """The growth of both amplitudes per second at the nearest natural frequency, from rest, in m/s."""
        one, two = self.modes.F_0 * abs(self.modes.coupling[self._nearest]) / (2 * self.natural[self._nearest])
        return float(one), float(two)

    @property
    def _nearest(self) -> int:
        return int(np.argmin(np.abs(self.modes.detuning)))

    @property
    def _halfway(self) -> float:
        """Half the detuning from the nearest mode, in rad/s."""
        return float(self.modes.detuning[self._nearest] / 2)

    @cached_property
    def limits(self) -> dict[Signal[Any], Growth]:
        """The envelope of the growing part near resonance, up and down; otherwise empty.

        With a detuning of 2 d from the nearest mode it is growth |sin(d t)/d|, at d = 0 growth t. If the window is long
        enough for a visible difference, the straight line is included.
        """
        found = dict[Signal[Any], Growth]()
        if self.resonant:
            d = self._halfway if abs(self._halfway) * self.end >= STRAIGHT else 0.0
            share = np.sinc(d * self.end / np.pi)
            bent = abs(d) * self.end > 1 or share < APART
            for i, growth in zip(BOTH, self.growth, strict=True):
                rate = math.copysign(growth, share)
                found |= {S.beat[i]: Growth(rate, d), S.fall[i]: Growth(-rate, d)}
                if bent:
                    found[S.growth[i]] = Growth(growth, 0.0)
        return found

    def columns(self, t: Floats) -> tuple[Columns, Columns]:
        """The motion and its parts in doubles, for fitting a frame, or bands if they are too fast to draw."""
        return (self._in_doubles(t), {}) if drawable(self.fastest, t) else self._traced(t)

    def exact(self, t: Floats) -> Columns:
        """Return the curves, exact to the last digit."""
        return of_both(*self._parts(t))

    def _in_doubles(self, t: Floats) -> Columns:
        """The motion at times that resolve it. Parts that are huge and opposite are omitted: see `limits`."""
        if not self.split:
            return of_both((S.x, self.modes.motion(t).x))
        particular = np.outer(self.modes.particular, np.sin(self.modes.omega * t))
        complementary = np.array([*positions(self.modes.complementary_modes, t).values()])
        return of_both((S.x, particular + complementary), (S.x_p, particular), (S.x_c, complementary))

    def _traced(self, t: Floats) -> tuple[Columns, Columns]:
        """The motion and its parts if they are too fast to draw, as curves or as bands."""
        drawn, curves, bands = self._parts(t), Columns(), Columns()
        for i in BOTH:
            for part, x in drawn:
                curve, band = self._trace(part, i, t, x[i - 1]) if self.split else ({}, self._band(i, t))
                curves, bands = curves | curve, bands | band
        return curves, bands

    def _parts(self, t: Floats) -> list[tuple[Both, Floats]]:
        """The displacements and their parts to the last digit."""
        motion, *parts = self.modes.apart(t) if self.split else (self.modes.motion(t),)
        return list(zip((S.x, S.x_p, S.x_c), (motion.x, *parts), strict=False))

    def _trace(self, part: Both, i: int, t: Floats, x: Floats) -> tuple[Columns, Columns]:
        """The terms of the displacement of mass i (1, 2), or of one of its parts."""
        rest, at = self.modes.complementary_modes, i - 1
        particular = [Sinusoid(self.modes.particular[at], self.modes.omega, 0.0)] if part is not S.x_c else []
        complementary = components(rest, at) if part is not S.x_p else []
        drift = rest.drift_a[at] + rest.drift_b[at] * t if part is not S.x_p else None
        return trace(part[i], [*particular, *complementary], t, drift, x)

    def _band(self, i: int, t: Floats) -> Columns:
        """The band that the displacement of mass i (1, 2) fills near resonance."""
        beat = np.abs(Growth(self.growth[i - 1], self._halfway).at(t)) if self.resonant else 0.0
        size = beat + self._others(i - 1)
        drift = self.modes.free.drift_a[i - 1] + self.modes.free.drift_b[i - 1] * t
        return dict(zip(band_columns(S.x[i].name), (drift - size, drift + size), strict=True))

    def _others(self, i: int) -> float:
        """The bound of everything except the resonant response: the free motion of the start and the response of the
        other mode.
        """
        modes, other = self.modes, 1 - self._nearest
        reach = float(np.abs(modes.free.amplitude[:, i]).sum())
        if self.natural[other] > 0 and modes.coupling[other, i]:
            reach += abs(modes.F_0 * modes.coupling[other, i] / modes.detuning[other]) / self.natural[other]
        return reach

    def energy(self, t: Floats) -> dict[Column[Any], Floats]:
        """The change of T + V since the start and the work of the drive."""
        gain, zero = self.energy_range(t).values()
        return {Work.gain: gain, Work.work: self.modes.work(t), Work.zero: zero}

    def energy_range(self, t: Floats) -> dict[Column[Any], Floats]:
        """The energies without the work, which is equal to the gain."""
        energy = chain_energy(self.chain, self.modes.motion(t)).total
        return {Work.gain: energy - energy[0], Work.zero: np.zeros_like(t)}

    def signals(self, size: Axis, time: Axis, force: Axis) -> dict[str, AnySignal]:
        """Signals for the clock: the free motion of the start plus the response of each mode, regular at resonance."""
        found = Found()
        F_0, omega, coupling = self.modes.F_0, self.modes.omega, self.modes.coupling.T.tolist()
        for i, shares, swing in zip(BOTH, coupling, self.swings, strict=True):
            terms = [(F_0, c, omega, omega_n) for c, omega_n in zip(shares, self.natural, strict=True) if c]
            found[S.x_driven[i]] = responses(size, time, *terms)
            found[S.x[i]] = total(*(S.x_part[i, mode] for mode in MODES), S.x_driven[i])
            if self.split:
                found[S.x_p[i]] = sines(size, time, (swing, omega, 0.0))
                found[S.x_c[i]] = derived(var(S.x[i]) - var(S.x_p[i]))
        limits = {one: limit.signal(size, time) for one, limit in self.limits.items()}
        return free_signals(self.modes.free, size, time) | by_name(found | self.drive(time, force) | limits)

    def forces(self, t: Floats, size: Axis, time: Axis) -> Forces:
        """The forces on the masses."""
        return forces(self.chain, self.modes.motion(t), size, self.modes.F_0, self.modes.omega)

"""The driven motion with dashpots: the steady state and the transient."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from components.chain import BOTH
from components.chain.forces import Forces, forces
from components.chain.parameters import Pair
from components.language.expressions import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis, nice_axis
from components.quantities.declared import Column, by_name
from components.quantities.motion import QUARTER, derived, sampled, sines, total
from components.scene.traces import Columns, Floats, band_columns
from components.scenes.forced.case import ForcedCase, Found, Work, of_both
from components.scenes.forced.case import Signals as S
from physics.absorber import damped_solution
from physics.coupled import Motion
from physics.energy import chain_energy
from physics.sampling import drawable
from physics.transient import DRAWING, FILE, DampedModes, Decaying
from physics.valid import in_range

HUGE = 1e3
"""Parts this many times as large as their sum are not drawn separately."""
SURE = 1e-9
"""The share of a motion that is too small to be drawn."""
NODES = 801
"""Number of points of a window for Hermite interpolation in the browser. Used if doubles lose too many digits in the
sum of the parts.
"""
TERMS = 2
"""Number of terms (1 and t) by which a signal can multiply an exponential."""
AT_FIRST = np.geomspace(1e-16, 0.8, 60)
"""Additional points within the first step, as shares of it, which show a decay at any rate."""
Terms = tuple[Decaying, ...]
_GAUSS = np.polynomial.legendre.leggauss(5)


@dataclass(frozen=True, eq=False)
class DampedForcedCase(ForcedCase):
    """A driven motion with dashpots."""

    modes: DampedModes
    kind: ClassVar[str] = "braked"

    @property
    def damping(self) -> Pair:
        return self.modes.c1, self.modes.c

    @cached_property
    def X(self) -> tuple[complex, complex]:
        """The steady amplitudes: x_p = Im(X exp(i omega t))."""
        one, two, _ = self.modes.particular.tolist()
        return one, two

    @cached_property
    def swings(self) -> Pair:
        """The sizes of the steady amplitudes; at omega = 0 their limit, infinite if nothing holds the masses."""
        modes = self.modes
        one, two = np.abs(damped_solution(self.chain, modes.c, modes.F_0, modes.omega, modes.c1)).tolist()
        return one, two

    @property
    def stills(self) -> bool:
        return super().stills and not self.modes.c

    @property
    def lags(self) -> Pair:
        """The phases in rad by which they lag the drive."""
        one, two = (-cmath.phase(X) % (2 * math.pi) for X in self.X)
        return one, two

    @property
    def moves(self) -> bool:
        return bool(np.any(self.motion(np.linspace(0.0, self.end, 9)).x))

    @cached_property
    def _reach(self) -> float:
        """The largest displacement."""
        return float(np.abs(self.modes.drawn(np.linspace(0.0, self.end, 257))[0][:2]).max())

    @cached_property
    def split(self) -> bool:
        """True if the parts are drawn."""
        return float(np.abs(self.modes.particular[:2]).max()) <= HUGE * self._reach

    @cached_property
    def in_doubles(self) -> bool:
        """True if the parts, summed in doubles, are right to all digits that are drawn."""
        if any(len(one.amplitudes) > TERMS for one in self.modes.transient):
            return False
        sizes = float(np.abs(self.modes.particular).max())
        for _, rows in self.modes.transient:
            sizes += sum(float(np.abs(row).max()) * self.end**j for j, row in enumerate(rows))
        return 2.0**-52 * (1 + self.fastest * self.end) * sizes <= SURE * self._reach

    def motion(self, t: Floats) -> Motion:
        """Return the motion to the precision of a drawing. Raise ValueError if that takes longer than a picture may."""
        if not self.in_doubles:
            return self.modes.motion(t, DRAWING)
        x, v = self.modes.drawn(t)
        in_range("the displacements", x)
        return Motion(t, x[:2], in_range("the velocities", v[:2]), x[::2])

    def columns(self, t: Floats) -> tuple[Columns, Columns]:
        """x1, x2 and their parts if they are drawn; or the bands that they fill if they are too fast."""
        if not drawable(self.fastest, t):
            return {}, self._bands(t)
        return self._curves(t, self.motion(t).x), {}

    def exact(self, t: Floats) -> Columns:
        """Return the curves, exact to the last digit. Raise ValueError if that takes more work than a file may."""
        return self._curves(t, self.modes.motion(t, FILE).x)

    def _curves(self, t: Floats, x: Floats) -> Columns:
        if not self.split:
            return of_both((S.x, x))
        return of_both((S.x, x), (S.x_p, self.modes.particular_motion(t)), (S.x_c, self.modes.complementary(t)))

    def _bands(self, t: Floats) -> Columns:
        """An upper bound of the displacements: the sum of the magnitudes of all parts."""
        found: Columns = {}
        for i, X in zip(BOTH, self.X, strict=True):
            size = np.full_like(t, abs(X))
            for exponent, rows in self.modes.transient:
                powers = sum(abs(row[i - 1]) * t**j for j, row in enumerate(rows))
                size += powers * np.exp(np.maximum(exponent.real * t, -700.0))
            found |= dict(zip(band_columns(S.x[i].name), (-size, size), strict=True))
        return found

    def energy(self, t: Floats) -> dict[Column[Any], Floats]:
        """The change of T + V since the start, and the work of the drive. Their difference is heat."""
        energy = chain_energy(self.chain, self.motion(t)).total
        work = self._integrated(t, lambda s: self.modes.F_0 * np.sin(self.modes.omega * s) * self._v(s)[0])
        return {Work.gain: energy - energy[0], Work.zero: np.zeros_like(t), Work.work: work}

    def heat(self, t: Floats) -> Floats:
        """The heat of the dashpots since the start, from the velocities."""
        c1, c2 = self.damping
        return self._integrated(t, lambda s: c1 * self._v(s)[0] ** 2 + c2 * np.diff(self._v(s), axis=0)[0] ** 2)

    def _v(self, t: Floats) -> Floats:
        return self.motion(t).v

    def _integrated(self, t: Floats, power: Callable[[Floats], Floats]) -> Floats:
        edges = np.concatenate([[0.0], t[1] * AT_FIRST, t[1:]])
        step, (nodes, weights) = np.diff(edges), _GAUSS
        inner = (edges[:-1, None] + step[:, None] * (1 + nodes) / 2).ravel()
        with np.errstate(over="ignore", invalid="ignore"):
            pieces = power(inner).reshape(-1, nodes.size) @ weights * step / 2
            done = np.concatenate([[0.0], np.cumsum(pieces)[AT_FIRST.size :]])
        return in_range("the energies", done)

    def signals(self, size: Axis, time: Axis, force: Axis) -> dict[str, AnySignal]:
        """Signals for the clock: x1, x2, their parts, the drive."""
        found, omega, terms = self.drive(time, force), self.modes.omega, self.modes.transient
        for i, X in zip(BOTH, self.X, strict=True):
            x, x_p, x_c = S.x[i], S.x_p[i], S.x_c[i]
            steady = sines(size, time, (abs(X), omega, cmath.phase(X)))
            if self.in_doubles:
                transient = sines(size, time, *_waves(terms, i), line=_line(terms, i))
                found |= {x_p: steady, x_c: transient, x: total(x_p, x_c)}
                continue
            motion, last = self._tabled
            found[x] = sampled(time, last, size.places(motion.x[i - 1]), size.places(motion.v[i - 1]))
            if self.split:
                found |= {x_p: steady, x_c: derived(var(x) - var(x_p))}
        return by_name(found)

    @cached_property
    def _tabled(self) -> tuple[Motion, float]:
        last = 1.02 * self.end  # longer than the window, because the browser repeats a table after its period
        return self.motion(np.linspace(0.0, last, NODES)), last

    def forces(self, t: Floats, size: Axis, time: Axis) -> Forces:
        """The forces on the masses, with the signals of both velocities for the dashpots."""
        motion = self.motion(t)
        speed = nice_axis(0.0, float(np.abs(motion.v).max()) or 1.0, "m/s", exact=True)
        found = forces(self.chain, motion, size, self.modes.F_0, self.modes.omega, self.damping, speed)
        return replace(found, signals=self._rates(speed, time) | found.signals)

    def _rates(self, speed: Axis, time: Axis) -> dict[str, AnySignal]:
        found = Found()
        if not self.in_doubles:
            motion, last = self._tabled
            step = last / (NODES - 1)
            for i, v in zip(BOTH, map(speed.places, motion.v), strict=True):
                found[S.v[i]] = sampled(time, last, v, np.gradient(v, step))
            return by_name(found)
        omega, terms = self.modes.omega, tuple(term.rate for term in self.modes.transient)
        for i, X in zip(BOTH, self.X, strict=True):
            steady = (abs(omega * X), omega, cmath.phase(1j * omega * X))
            found[S.v[i]] = sines(speed, time, steady, *_waves(terms, i), line=_line(terms, i))
        return by_name(found)

    @cached_property
    def slowest(self) -> float:
        """The decay rate of the slowest transient in 1/s; 0 if something does not decay."""
        left = [-one.exponent.real for one in self.modes.transient]
        return min(left, default=math.inf)


def _waves(terms: Terms, i: int) -> Iterator[tuple[float, float, float, float, float]]:
    """Return each Re(A exp(s t)) and Re(B t exp(s t)) of mass i (1, 2) as a decaying sine."""
    for exponent, rows in terms:
        for j, A in enumerate(rows[:, i - 1] if exponent else ()):
            if A:
                size, slope = (abs(A), 0.0) if j == 0 else (0.0, abs(A))
                yield size, exponent.imag, cmath.phase(A) + QUARTER, -exponent.real, slope


def _line(terms: Terms, i: int) -> Pair:
    """The constant and the drift of mass i (1, 2), if nothing holds it in place."""
    for exponent, rows in terms:
        if not exponent:
            return float(rows[0, i - 1].real), float(rows[1, i - 1].real) if len(rows) > 1 else 0.0
    return 0.0, 0.0

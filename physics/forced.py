"""Two masses and two springs, driven (lecture D34, slides 6 to 9).

    wall --k1-- [m1] --k2-- [m2]        F_0 sin(omega t) on m1, to the right; no friction

    m1 x1'' = -k1 x1 - k2 (x1 - x2) + F_0 sin(omega t)
    m2 x2'' =  k2 (x1 - x2)

The particular solution x_i = Xp_i sin(omega t) is in physics.particular. Near a natural frequency the
lecture's split, total = complementary + particular, is a difference of two huge motions. So the motion is
formed mode by mode: the free motion of the start plus the response g from rest, which grows like t at
resonance and needs no particular solution; see physics.driven_motion.
"""

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import (
    QUANTITIES,
    FreeModes,
    Mode,
    Motion,
    TwoMassChain,
    Vector,
    as_motion,
    coordinates,
    each_mass,
    started,
)
from physics.driven_motion import NONE, AlsoSummed, driven_values
from physics.particular import (
    antiresonance,
    at_natural_frequency,
    check_drive,
    determinant,
    exact_amplitudes,
    particular_solution,
    rounded_amplitudes,
)
from physics.precision.curves import ScaledCurve, combined, product, response, turning
from physics.precision.exact import PI, Array, exact, precise, rounded, within_an_ulp
from physics.sinusoids import ExactSinusoid, added
from physics.valid import finite_array

__all__ = [
    "DrivenModes",
    "antiresonance",
    "determinant",
    "driven_modes",
    "forced_motion",
    "particular_solution",
    "steady_start",
]

REST = (0.0, 0.0)
_PARTICULAR = ("x1 of x_p", "x2 of x_p")
_CANCELS = Decimal("1e-3")  # of x_c and x_p, what is left of them after a period of the drive


@dataclass(frozen=True, eq=False)
class DrivenModes:
    """The motion under F_0 sin(omega t) on mass 1 from any start, mode by mode (j: slow, fast; i: mass).

    x_i(t) = (free motion of the start)_i + F_0 sum_j coupling[j, i] g(t; omega, omega_j), where
    g'' + omega_j^2 g = sin(omega t) from rest. free are the modes of the start alone.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N.
    omega : float
        The drive frequency in rad/s, 0 or more.
    x_0, v_0 : tuple of Decimal
        Displacements in m and velocities in m/s of masses 1 and 2 at t = 0.
    """

    chain: TwoMassChain
    F_0: float
    omega: float
    x_0: Vector
    v_0: Vector

    @cached_property
    def free(self) -> FreeModes:
        """The free motion from the initial conditions."""
        return started(self.chain, self.x_0, self.v_0)

    @cached_property
    def detuning(self) -> Array:
        """omega - omega_j (2,), rounded once: not the difference of two rounded frequencies."""
        with precise():
            return np.array([float(exact(self.omega) - mode.omega) for mode in self.chain.exact_modes])

    @cached_property
    def coupling(self) -> Array:
        """(2 modes, 2 masses) in 1/kg."""
        rows = []
        for mode in self.chain.exact_modes:
            with precise():
                share = mode.shape[0] / mode.mass
                rows.append([rounded("a coupling", share * part) for part in mode.shape])
        return np.array(rows)

    @cached_property
    def particular(self) -> Array:
        """Xp1, Xp2."""
        return rounded_amplitudes(self.chain, self.omega, self._amplitudes)

    @cached_property
    def at_resonance(self) -> bool:
        """True if the drive is at a natural frequency to the precision of doubles: at most an ulp of omega away.

        Exactly at one no particular solution exists; an ulp away it is some 1e15 times the static deflection.
        """
        pushed = (mode for mode in self.chain.exact_modes if mode.shape[0])
        return not self.split_is_meaningful and any(within_an_ulp(self.omega, mode.omega) for mode in pushed)

    @cached_property
    def split_is_meaningful(self) -> bool:
        """True if x_c and x_p are worth separate curves: at least 1/1000 of them does not cancel.

        From rest the total reaches, within a period of the drive, about |omega - omega_j| times that period
        of what either has. At resonance x_p does not exist.
        """
        if self._amplitudes is None:
            return False
        drive, pushed = exact(self.omega), (mode for mode in self.chain.exact_modes if mode.shape[0] and self.F_0)
        with precise():
            return all(2 * PI * abs(drive - mode.omega) >= _CANCELS * drive for mode in pushed)

    def motion(self, t: ArrayLike) -> Motion:
        """The motion at times t (n,), within 4 u of its envelope at every detuning, phases below 1e15.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        Motion
            x, v and e, each (2, n).

        Raises
        ------
        ValueError
            If a time is not finite, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        if not (self._pushes and t.size):
            return self.free.motion(t)
        return as_motion(t, driven_values(self.free, self.F_0, self.omega, t))

    @cached_property
    def complementary_modes(self) -> FreeModes:
        """The modes of x_c, the free motion that remains without x_p; ValueError at resonance."""
        drive, X = exact(self.omega), self._exact_particular
        with precise():
            v1_0, v2_0 = (v - drive * part for v, part in zip(self.v_0, X, strict=True))
        return FreeModes(self.chain, self.free.coordinate, coordinates(self.chain, (v1_0, v2_0)))

    def complementary(self, t: ArrayLike) -> Array:
        """Return x_c (2, n); ValueError at resonance.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (2, n)
            The complementary motion of masses 1 and 2 in m.

        Raises
        ------
        ValueError
            At resonance, if a time is not finite, or if a result leaves the range of doubles.
        """
        return self.complementary_modes.motion(t).x

    def particular_motion(self, t: ArrayLike) -> Array:
        """Return x_p (2, n) = Xp sin(omega t); ValueError at resonance.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (2, n)
            The particular motion of masses 1 and 2 in m.

        Raises
        ------
        ValueError
            At resonance, if a time is not finite, or if a result leaves the range of doubles.
        """
        return added([self._swing], finite_array("t", t), _PARTICULAR)

    def apart(self, t: ArrayLike) -> tuple[Motion, Array, Array]:
        """The motion, x_p and x_c, as above, from the same sines and cosines; ValueError at resonance.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        tuple of Motion, ndarray and ndarray
            The motion, then x_p and x_c in m, each (2, n).

        Raises
        ------
        ValueError
            At resonance, if a time is not finite, or if a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        if not (self._pushes and t.size):
            return self.motion(t), self.particular_motion(t), self.complementary(t)
        swing, none = self._swing, [NONE] * 2
        with precise():
            parts = [
                ExactSinusoid(mode.omega, *([*none, *(part * start for part in mode.shape)] for start in (q, v)))
                for mode, q, v in self.complementary_modes.each()
            ]
        parts.append(ExactSinusoid(swing.omega, [*swing.cosine, *none], [*swing.sine, *none]))
        beside = AlsoSummed((*_PARTICULAR, *QUANTITIES[:2]), parts)
        values = driven_values(self.free, self.F_0, self.omega, t, beside)
        return as_motion(t, values[:5]), values[5:7], values[7:]

    @property
    def _swing(self) -> ExactSinusoid:
        omega = exact(self.omega)
        with precise():
            return ExactSinusoid(omega, [NONE] * 2, [part * omega for part in self._exact_particular])

    def work(self, t: ArrayLike) -> Array:
        """The work of the drive since t = 0, (n,) in J.

        Mode by mode the integral of sin(omega t) p'(t) is p' g' + omega_n^2 p g for its free part p, and
        (g'^2 + omega_n^2 g^2)/2 for its response; no displacement and no spring enters.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (n,)
            The work in J; 0 without a drive.

        Raises
        ------
        ValueError
            If a time is not finite, or the work leaves the range of doubles.
        """
        t = finite_array("t", t)
        row: list[Decimal] = []
        curves: list[ScaledCurve] = []
        for mode, q, v in self.free.each():
            if self._pushes and mode.shape[0]:
                for factor, curve in self._works(mode, q, v, turning(mode.omega, t), t):
                    row.append(factor)
                    curves.append(curve)
        return combined([row], curves, ("the work of the drive",))[0] if row else np.zeros_like(t)

    @property
    def _pushes(self) -> bool:
        """True if there is a force at all: F_0 sin(0 t) is zero."""
        return bool(self.F_0 and self.omega)

    def _works(
        self, mode: Mode, q: Decimal, v: Decimal, free: tuple[ScaledCurve, ScaledCurve], t: Array
    ) -> list[tuple[Decimal, ScaledCurve]]:
        g, speed = response(exact(self.omega), mode.omega, t)
        cosine, sine = free
        with precise():
            F, square = exact(self.F_0) * mode.shape[0], mode.omega**2
            half = F / mode.mass / 2
            factors = (v, -square * q, square * q, square * v, half, half * square)
            first, second = (cosine, sine, cosine, sine, speed, g), (speed, speed, g, g, speed, g)
            return [(F * c, product(a, b)) for c, a, b in zip(factors, first, second, strict=True)]

    @cached_property
    def _amplitudes(self) -> tuple[Fraction, Fraction] | None:
        return exact_amplitudes(self.chain, self.F_0, self.omega)

    @cached_property
    def _exact_particular(self) -> tuple[Decimal, Decimal]:
        if self._amplitudes is None:
            raise at_natural_frequency(self.omega)
        with precise():
            X1, X2 = (Decimal(part.numerator) / Decimal(part.denominator) for part in self._amplitudes)
            return X1, X2


def driven_modes(
    chain: TwoMassChain, F_0: float, omega: float, x_0: ArrayLike = REST, v_0: ArrayLike = REST
) -> DrivenModes:
    """The modes of the chain under F_0 sin(omega t) on mass 1, F_0 in N, omega >= 0 in rad/s.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N, finite.
    omega : float
        The drive frequency in rad/s, 0 or more.
    x_0, v_0 : array_like, shape (2,)
        Displacements in m and velocities in m/s at t = 0; at rest in equilibrium by default.

    Returns
    -------
    DrivenModes
        The motion, mode by mode.

    Raises
    ------
    ValueError
        If a number is not possible.
    """
    check_drive(F_0, omega)
    return DrivenModes(chain, float(F_0), float(omega), each_mass("x_0", x_0), each_mass("v_0", v_0))


def forced_motion(
    chain: TwoMassChain,
    F_0: float,
    omega: float,
    t: ArrayLike,
    x_0: ArrayLike = REST,
    v_0: ArrayLike = REST,
) -> Motion:
    """Return the motion under the force F_0 sin(omega t) on mass 1.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force in N.
    omega : float
        The drive frequency in rad/s, 0 or more.
    t : array_like, shape (n,)
        Times in s.
    x_0, v_0 : array_like, shape (2,)
        Displacements in m and velocities in m/s at t = 0; at rest in equilibrium by default.

    Returns
    -------
    Motion
        x, v and e, each (2, n), within 1.1 u of the envelope at every detuning.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    return driven_modes(chain, F_0, omega, x_0, v_0).motion(t)


def steady_start(chain: TwoMassChain, F_0: float, omega: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the initial conditions from which the particular solution is the whole motion.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N.
    omega : float
        The drive frequency in rad/s.

    Returns
    -------
    tuple of tuple of float
        x_0 = (0, 0) in m, and v_0 = omega Xp in m/s.

    Raises
    ------
    ValueError
        At resonance, where no particular solution exists.
    """
    modes = driven_modes(chain, F_0, omega)
    with precise():
        v1_0, v2_0 = (
            rounded("the starting velocity omega Xp", exact(modes.omega) * part) for part in modes._exact_particular
        )
    return REST, (v1_0, v2_0)

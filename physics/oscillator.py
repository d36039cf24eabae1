r"""Spring and mass, the linear harmonic oscillator (lecture D31, slides 1 to 3).

    wall --/\/\/ k \/\/\-- [m] --> x        F = -k x,   m x'' + k x = 0,   omega_n = sqrt(k/m)

x is measured from where the spring is at its natural length. The solution, written both ways:

    x = A cos(omega_n t) + B sin(omega_n t),   A = x_0, B = v_0/omega_n
    x = C sin(omega_n t + phi),                C = hypot(A, B), phi = atan2(A, B)

The slide's phi = atan(x_0 omega_n/v_0) is right for v_0 > 0 only. A spring with k = 0 leaves the mass free:
it drifts, x = x_0 + v_0 t, which is the limit of B sin(omega_n t).

The constants are worked out in 80-digit decimals and rounded once; x, v and a err by at most 4 u of their
amplitudes (u = 2^-53) for all m, k, x_0, v_0 and t with omega_n t < 1e60.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from math import atan2, inf, pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.precision.exact import PI, Array, angle, binary, exact, on_circle, precise, rounded
from physics.valid import check_finite, check_not_negative, check_positive, finite_array, keep_doubles, rows_in_range


@dataclass(frozen=True, kw_only=True)
class OscillatorMotion:
    """The motion of one mass.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x, v, a : ndarray, shape (n,)
        Displacements in m, velocities in m/s, accelerations in m/s^2.
    """

    t: Array
    x: Array
    v: Array
    a: Array


@dataclass(frozen=True, kw_only=True)
class OscillatorConstants:
    """The constants of both forms of the free motion.

    x = A cos(omega_n t) + B sin(omega_n t) + drift t = C sin(omega_n t + phi) + drift t.

    Attributes
    ----------
    A, B, C : float
        Amplitudes in m. B is 0 at k = 0.
    phi : float
        The phase in rad, in (-pi, pi].
    drift : float
        v_0 in m/s at k = 0, else 0.
    """

    A: float
    B: float
    C: float
    phi: float
    drift: float


@dataclass(frozen=True, kw_only=True)
class Oscillator:
    """A mass on a spring.

    Parameters
    ----------
    m : float
        The mass in kg, above 0.
    k : float
        The stiffness in N/m, 0 or more; at 0 the mass drifts.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    m: float
    k: float

    def __post_init__(self) -> None:
        keep_doubles(self, "m", "k")
        check_positive("a mass in kg", m=self.m)
        check_not_negative("a stiffness in N/m", k=self.k)

    @cached_property
    def frequency(self) -> Decimal:
        """omega_n to 80 digits."""
        with precise():
            return (exact(self.k) / exact(self.m)).sqrt()

    @cached_property
    def omega_n(self) -> float:
        """Natural frequency in rad/s, rounded once."""
        return float(self.frequency)

    @cached_property
    def period(self) -> float:
        """tau = 2 pi/omega_n in s, rounded once; infinite at k = 0."""
        with precise():
            return float(2 * PI / self.frequency) if self.k else inf

    def constants(self, x_0: float, v_0: float) -> OscillatorConstants:
        """Return the constants of both forms of the solution.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.

        Returns
        -------
        OscillatorConstants
            Amplitudes, phase and drift, each rounded once.

        Raises
        ------
        ValueError
            If a number is not finite, or a constant leaves the range of doubles.
        """
        A, B = self._amplitudes(x_0, v_0)
        with precise():
            C = (A * A + B * B).sqrt()
        return OscillatorConstants(
            A=float(x_0),
            B=rounded("the amplitude B = v_0/omega_n", B),
            C=rounded("the amplitude C", C),
            phi=phase_of(A, B),
            drift=0.0 if self.k else float(v_0),
        )

    def motion(self, x_0: float, v_0: float, t: ArrayLike) -> OscillatorMotion:
        """Return the free motion.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        OscillatorMotion
            x, v and a, each (n,), within 2 u of their amplitudes.

        Raises
        ------
        ValueError
            If a number is not finite, or x, v or a leaves the range of doubles.
        """
        t = finite_array("t", t)
        omega = self.frequency
        A, B = self._amplitudes(x_0, v_0)
        (sine, _), (cosine, _) = on_circle(*angle(omega, t))
        with precise():
            rate, force = exact(v_0), -omega * omega
            of_cosine, of_sine = (A, rate, force * A), (B, -omega * A, -omega * rate)
        rows = _oscillations(of_cosine, cosine, of_sine, sine)
        if not self.k:
            rows[0] = _drift(x_0, v_0, t)
        x, v, a = rows_in_range(("the displacement", "the velocity", "the acceleration"), rows)
        return OscillatorMotion(t=t, x=x, v=v, a=a)

    def _amplitudes(self, x_0: float, v_0: float) -> tuple[Decimal, Decimal]:
        check_finite("a displacement in m", x_0=x_0)
        check_finite("a velocity in m/s", v_0=v_0)
        with precise():
            return exact(x_0), exact(v_0) / self.frequency if self.k else Decimal(0)


def phase_of(A: Decimal, B: Decimal) -> float:
    """Return atan2(A, B) in (-pi, pi], where A and B may be out of the range of doubles; 0 at rest."""
    size = max(abs(A), abs(B))
    if not size:
        return 0.0
    with precise():
        phase = atan2(A / size, B / size)
    return phase if phase > -pi else pi


def _oscillations(of_cosine: Sequence[Decimal], cosine: Array, of_sine: Sequence[Decimal], sine: Array) -> Array:
    """a cosine + b sine (rows, n) for each a and b, of any size; infinite only where the sum is.

    Where a term overflows and yet the sum may not, both are added in units of the larger amplitude.
    """
    (a, a_exponent), (b, b_exponent) = _column(of_cosine), _column(of_sine)
    a, b = a * cosine, b * sine
    with np.errstate(over="ignore", invalid="ignore"):
        total: Array = np.ldexp(a, a_exponent) + np.ldexp(b, b_exponent)
        finite = np.isfinite(total)
        if finite.all():
            return total
        largest = np.maximum(a_exponent, b_exponent)
        scaled = np.ldexp(a, a_exponent - largest) + np.ldexp(b, b_exponent - largest)
        return np.where(finite, total, np.ldexp(scaled, largest))


def _column(values: Sequence[Decimal]) -> tuple[Array, NDArray[np.int_]]:
    """f and e (rows, 1) with values = f 2**e."""
    parts = [binary(value) for value in values]
    return np.array([[hi] for hi, _, _ in parts]), np.array([[exponent] for _, _, exponent in parts])


def _drift(x_0: float, v_0: float, t: Array) -> Array:
    """x_0 + v_0 t, infinite only where the sum is."""
    with np.errstate(over="ignore"):
        return 2 * (x_0 / 2 + v_0 / 2 * t)

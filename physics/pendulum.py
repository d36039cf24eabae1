"""The pendulum at any amplitude (lecture D31, slide 7: "small amplitude", and the error of that for larger ones).

       ////                     m l^2 theta'' = -m g l sin(theta),   omega_0 = sqrt(g/l)
        |\\
        | \\  l                  small amplitudes: theta = theta_0 cos(omega_0 t), T_0 = 2 pi/omega_0
        |  \\                    released at rest from theta_0: k = sin(theta_0/2), k' = cos(theta_0/2),
      theta (m)                 T/T_0 = 1/agm(1, k'),   tan(theta/2) = (k/k') cn(omega_0 t; k)

The Jacobi functions come from descending Landen transformations of the phase psi = Omega t, Omega = 2 pi/T. omega_0
and the agm (Gauss) are 80-digit decimals, psi is compensated, and every term is positive. In the second half of a
quarter period the transformations start from pi/2 - psi, so nothing cancels near theta_0 = pi either, where the bob
spends most of its time next to the top.

Period and excess are rounded once for |theta_0| <= math.pi; theta and theta' are within 4 u of their amplitudes
(6 u for theta''), u = 2^-53.

Source: R. Bulirsch, Numer. Math. 7 (1965) 78.
"""

from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property, lru_cache
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from physics.precision.exact import PI, Array, angle, exact, on_circle, precise, rounded
from physics.valid import check_finite, check_positive, finite_array, keep_doubles

HALF_TURN = pi  # the double, 1.2e-16 below the number: the largest amplitude
CLOSE = Decimal("1e-40")


@dataclass(frozen=True, kw_only=True)
class PendulumMotion:
    """A swing of a pendulum.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    theta, theta_dot, theta_ddot : ndarray, shape (n,)
        Angles in rad, their rates in rad/s and accelerations in rad/s^2.
    """

    t: Array
    theta: Array
    theta_dot: Array
    theta_ddot: Array


@dataclass(frozen=True, kw_only=True)
class Pendulum:
    """A mass on a rod of length l.

    Parameters
    ----------
    l : float
        The length in m, above 0.
    g : float
        Gravity in m/s^2, above 0.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    l: float  # noqa: E741
    g: float

    def __post_init__(self) -> None:
        keep_doubles(self, "l", "g")
        check_positive("a length in m", l=self.l)
        check_positive("gravity in m/s^2", g=self.g)

    @cached_property
    def frequency(self) -> Decimal:
        """omega_0 to 80 digits."""
        with precise():
            return (exact(self.g) / exact(self.l)).sqrt()

    @property
    def omega_0(self) -> float:
        """Frequency of small swings in rad/s."""
        return float(self.frequency)

    def period(self, theta_0: float) -> float:
        """Return the period of a swing of any size, rounded once.

        Parameters
        ----------
        theta_0 : float
            The amplitude in rad, less than pi.

        Returns
        -------
        float
            The period in s.

        Raises
        ------
        ValueError
            If the angle is not possible.
        """
        with precise():
            return rounded("the period", 2 * PI / (self.frequency * _modulus_at(theta_0).mean))

    def motion(self, theta_0: float, t: ArrayLike) -> PendulumMotion:
        """Return the exact swing from rest.

        Parameters
        ----------
        theta_0 : float
            The angle at t = 0 in rad, less than pi to either side.
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        PendulumMotion
            The angle in rad and its derivatives, each (n,).

        Raises
        ------
        ValueError
            If a number is not possible, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        modulus, theta_0 = _modulus_at(theta_0), float(theta_0)
        with precise():
            (sine, _), (cosine, _) = on_circle(*angle(self.frequency * modulus.mean, t))
            fastest = rounded("the rate theta'", 2 * self.frequency * modulus.k)
            strongest = rounded("the acceleration theta''", self.frequency * self.frequency)
        tangent, speed = _swing(modulus, np.abs(sine), np.abs(cosine))
        side = np.copysign(np.sign(theta_0), cosine * theta_0)
        return PendulumMotion(
            t=t,
            theta=side * (2 * np.arctan(tangent)),
            theta_dot=-np.sign(theta_0) * np.sign(sine) * (fastest * speed),
            theta_ddot=-side * strongest * (2 * tangent / (1 + tangent * tangent)),
        )


def excess(theta_0: float) -> float:
    """Return T/T_0 - 1, rounded once, also where it is 1e-300.

    Parameters
    ----------
    theta_0 : float
        The amplitude in rad, less than pi to either side.

    Returns
    -------
    float
        How much longer the period is than that of small swings, over the latter.

    Raises
    ------
    ValueError
        If the angle is not possible.
    """
    with precise():
        return float(_modulus_at(theta_0).excess)


@lru_cache(maxsize=64)
def amplitude_at_excess(wanted: float) -> float:
    """Return the amplitude at which T/T_0 - 1 has the wanted value.

    Newton's method from above: T is convex in theta_0, and theta_0 < 4 sqrt(wanted).

    Parameters
    ----------
    wanted : float
        T/T_0 - 1, from 0 at rest to its value at math.pi.

    Returns
    -------
    float
        The amplitude in rad, rounded once.

    Raises
    ------
    ValueError
        If no amplitude has this value.
    """
    largest = excess(HALF_TURN)
    if not 0 <= wanted <= largest:
        raise ValueError(f"T/T_0 - 1 = {wanted!r} is not possible: choose from 0 at rest to {largest:.4g} next to pi")
    with precise():
        theta_0 = min(4 * exact(wanted).sqrt(), exact(HALF_TURN))
        step = theta_0
        while step > CLOSE * theta_0:
            modulus = _modulus_of(theta_0)
            step = (modulus.excess - exact(wanted)) / modulus.slope
            theta_0 -= step
        return float(theta_0)


@dataclass(frozen=True)
class _Modulus:
    """k = sin(theta_0/2), k' = cos(theta_0/2) and the steps (a_n, b_n, c_n) of agm(1, k')."""

    k: Decimal
    complement: Decimal
    steps: tuple[tuple[Decimal, Decimal, Decimal], ...]

    @property
    def mean(self) -> Decimal:
        """agm(1, k')."""
        return self.steps[-1][0]

    @property
    def excess(self) -> Decimal:
        """1/agm - 1, where 1 - agm = c_1 + c_2 + ... has only positive terms."""
        return sum((c for _, _, c in self.steps[1:]), Decimal(0)) / self.mean

    @property
    def slope(self) -> Decimal:
        """Derivative of the excess by theta_0, from dK/dk = (E - k'^2 K)/(k k'^2)."""
        later = sum((2**n * c * c for n, (_, _, c) in enumerate(self.steps[1:])), Decimal(0))
        return (self.k * self.k / 2 - later) / (2 * self.k * self.complement * self.mean)


def _modulus_at(theta_0: float) -> _Modulus:
    check_finite("an angle in rad", theta_0=theta_0)
    return _modulus(float(theta_0))


@lru_cache(maxsize=64)
def _modulus(theta_0: float) -> _Modulus:
    if not abs(theta_0) <= HALF_TURN:
        raise ValueError(
            f"an angle of {theta_0!r} rad is not possible: a pendulum is released below the top, at less than pi"
        )
    return _modulus_of(exact(abs(theta_0)))


def _modulus_of(theta_0: Decimal) -> _Modulus:
    """The agm in 80 digits; c_{n+1} = c_n^2/(4 a_{n+1}) in place of (a_n - b_n)/2, which cancels."""
    with precise():
        k = _sine(theta_0 / 2)
        complement = ((1 - k) * (1 + k)).sqrt()  # next to pi, too, half of the digits remain
        steps = [(Decimal(1), complement, k)]
        while len(steps) < 2 or steps[-1][2] > CLOSE * steps[1][2]:
            a, b, c = steps[-1]
            mean = (a + b) / 2
            steps.append((mean, (a * b).sqrt(), c * c / (4 * mean)))
        return _Modulus(k, complement, tuple(steps))


def _sine(x: Decimal) -> Decimal:
    """sin(x) for 0 <= x <= pi/2 by its Taylor series."""
    total, term, n = x, x, 1
    while abs(term) > CLOSE * CLOSE * total:
        term *= -x * x / ((n + 1) * (n + 2))
        total += term
        n += 2
    return total


def _swing(modulus: _Modulus, sine: Array, cosine: Array) -> tuple[Array, Array]:
    """tan(theta/2) and |theta'|/(2 omega_0 k) at a phase psi of the first quarter, by its sine and cosine.

    With sn, cn, dn at psi < pi/4: tan(theta/2) = k cn/k', and the speed is k' sn/dn. Beyond, at pi/2 - psi
    instead: tan(theta/2) = k sn/dn, and the speed is cn.
    """
    early = cosine >= sine
    tangent, dn = _landen(modulus, np.where(early, sine, cosine) / np.where(early, cosine, sine))
    cn = 1 / np.sqrt(1 + tangent * tangent)
    sn_by_dn = tangent * cn / dn
    k, complement = float(modulus.k), float(modulus.complement)
    return np.where(early, k * cn / complement, k * sn_by_dn), np.where(early, complement * sn_by_dn, cn)


def _landen(modulus: _Modulus, tangent: Array) -> tuple[Array, Array]:
    """sn/cn and dn from tan(psi) by Landen's transformations down the steps of the agm (Bulirsch)."""
    above = float(modulus.mean)
    tangent, dn = tangent / above, np.ones_like(tangent)
    for a, b, _ in reversed(modulus.steps[:-1]):
        square = above * tangent * tangent
        tangent, dn = tangent / dn, (float(b) * square + 1) / (float(a) * square + 1)
        above = float(a)
    return tangent, dn

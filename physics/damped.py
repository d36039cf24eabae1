r"""One oscillator with a dashpot: what the lecture leaves out of D31, in one expression for every damping.

    wall --/\/\/ k \/\/\--+
                          [m] --> x        m x'' + c x' + k x = 0
    wall ------[ c ]------+

With a = c/2m and omega_n^2 = k/m the exponents are -a +- sqrt(a^2 - omega_n^2). Let sigma be the rate at which the
slower part dies, omega_d = sqrt(omega_n^2 - a^2) or 0, and beta = sqrt(a^2 - omega_n^2) or 0, whichever is real:

    x = exp(-sigma t) (x_0 cos(omega_d t) + (v_0 + sigma x_0) S(t)),

    S = sin(omega_d t)/omega_d   or   (1 - exp(-2 beta t))/(2 beta),   both t at critical damping.

sigma is a up to critical damping and omega_n^2/(a + beta) beyond, where a - beta would cancel. v and a obey the same
equation from (v_0, a_0) and (a_0, a_0').

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 2.6.
"""

from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from itertools import pairwise
from math import inf, pi
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.oscillator import OscillatorMotion, phase_of
from physics.periodic import PeriodicPush
from physics.precision.curves import ScaledCurve, combined, product, turning
from physics.precision.elementary import SMALLEST_EXPONENT, exponential
from physics.precision.exact import Array, angle, exact, pair_sum, precise, rounded, sum_of, two_sum, within_an_ulp
from physics.pushed import PushedMass, PushedMotion
from physics.valid import check_finite, check_not_negative, check_positive, finite_array, keep_doubles

QUANTITIES = ("the displacement", "the velocity", "the acceleration")
NONE = Decimal(0)
_SAME = Decimal("1e-6")  # of a: exponents closer than this make one term in doubles
_SHORT = 2.0**-20  # of 2 beta t: S takes three terms of its series

Start = tuple[Decimal, Decimal]  # a value and its rate at t = 0
Regime = Literal["under", "critical", "over"]


class Decay(NamedTuple):
    """(amplitude + slope t) exp(-rate t) sin(omega t + phase); a plain exponential has omega = 0, phase = pi/2.

    Attributes
    ----------
    amplitude : float
        The amplitude at t = 0, in the unit of the motion.
    slope : float
        Its rise, in that unit per second.
    rate : float
        The rate of decay in 1/s.
    omega : float
        The frequency in rad/s.
    phase : float
        The phase in rad.
    """

    amplitude: float
    slope: float
    rate: float
    omega: float
    phase: float


class Fading(NamedTuple):
    """exp(-slow t) (start C + rate S) for a signal, with C = cos(omega_d t) and S as above.

    Attributes
    ----------
    start : float
        The value at t = 0, in the unit of the motion.
    rate : float
        The factor of S, in that unit per second.
    slow : float
        The rate sigma in 1/s at which the slower part dies.
    apart : float
        2 beta in 1/s: how much faster the other part dies.
    swing : float
        omega_d in rad/s.
    late : tuple of two floats
        The sizes of the slow and of the fast exponential beyond critical damping, in the unit of the motion; else 0.
    """

    start: float
    rate: float
    slow: float
    apart: float
    swing: float
    late: tuple[float, float]

    def at(self, t: Array) -> Array:
        """The motion at the times t in s, in doubles, for drawing.

        Parameters
        ----------
        t : ndarray
            Times in s.

        Returns
        -------
        ndarray, shape of t
            The motion, in the unit of `start`.
        """
        if self.apart:
            parted = self.apart * t > 1
            late = self.late[0] * np.exp(-self.slow * t) + self.late[1] * np.exp(-(self.slow + self.apart) * t)
            soon = np.exp(-self.slow * t) * (self.start - self.rate * np.expm1(-self.apart * t) / self.apart)
            return np.where(parted, late, soon)
        sine = np.sin(self.swing * t) / self.swing if self.swing else t
        return np.asarray(np.exp(-self.slow * t) * (self.start * np.cos(self.swing * t) + self.rate * sine))


@dataclass(frozen=True, kw_only=True)
class DampedOscillator:
    """A mass on a spring and a dashpot.

    Parameters
    ----------
    m : float
        The mass in kg, above 0.
    c : float
        The damping in N s/m, 0 or more.
    k : float
        The stiffness in N/m, 0 or more.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    m: float
    c: float
    k: float

    def __post_init__(self) -> None:
        keep_doubles(self, "m", "c", "k")
        check_positive("a mass in kg", m=self.m)
        check_not_negative("a damping in N s/m", c=self.c)
        check_not_negative("a stiffness in N/m", k=self.k)

    @cached_property
    def omega_n(self) -> float:
        """The natural frequency without damping, in rad/s."""
        with precise():
            return float((exact(self.k) / exact(self.m)).sqrt())

    @cached_property
    def omega_d(self) -> float:
        """The frequency of the damped swing, in rad/s; 0 from critical damping on."""
        return float(self.exact_omega_d)

    @cached_property
    def zeta(self) -> float:
        """c over the critical damping 2 sqrt(k m); 1 is critical."""
        if not self.c:
            return 0.0
        with precise():
            return float(exact(self.c) / (2 * (exact(self.k) * exact(self.m)).sqrt())) if self.k else inf

    @property
    def regime(self) -> Regime:
        """The regime, "under" if it swings: critical is the double nearest to 2 sqrt(k m), and its two neighbours."""
        with precise():
            if self.k and within_an_ulp(self.c, 2 * (exact(self.k) * exact(self.m)).sqrt()):
                return "critical"
        return "under" if self._excess < 0 else "over"

    @cached_property
    def rates(self) -> tuple[float, float]:
        """The rates in 1/s at which the slower and the faster part die; equal where it swings."""
        with precise():
            return float(self.exact_sigma), float(self.exact_sigma + 2 * self.exact_beta)

    @cached_property
    def log_decrement(self) -> float:
        """delta = 2 pi a/omega_d, the logarithm of a peak over the next one; infinite where it does not swing."""
        with precise():
            return float(2 * Decimal(pi) * self._a / self.exact_omega_d) if self.exact_omega_d else inf

    def motion(self, x_0: float, v_0: float, t: ArrayLike) -> OscillatorMotion:
        """Return the free motion.

        Within 2 u of the sum of the sizes of both parts; a part that has died down to 1e-260 counts as nothing.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.
        t : array_like, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        OscillatorMotion
            x, v and a, each (n,).

        Raises
        ------
        ValueError
            If a number is not possible, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        check_not_negative("a time in s", t=float(np.min(t, initial=0.0)))
        starts = self.exact_starts(x_0, v_0)
        result = np.empty((3, t.size))
        with precise():
            late = t > (float(1 / (2 * self.exact_beta)) if self.exact_beta else inf)
        for where, form in ((~late, self._together), (late, self._apart)):
            if np.any(where):
                result[:, where] = combined(*form(starts, t[where]), QUANTITIES)
        x, v, acceleration = result
        return OscillatorMotion(t=t, x=x, v=v, a=acceleration)

    def pushed(self, push: PeriodicPush) -> PushedMass:
        """Return the oscillator under a push.

        Parameters
        ----------
        push : PeriodicPush
            The push on the mass.

        Returns
        -------
        PushedMass
            The same mass, dashpot and spring under this push.
        """
        return PushedMass(self.m, self.c, self.k, push)

    def steady(self, push: PeriodicPush, t: ArrayLike) -> PushedMotion:
        """Return the steady motion under a periodic push, within 4 u of the largest value.

        Parameters
        ----------
        push : PeriodicPush
            The push on the mass.
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        PushedMotion
            x in m and v in m/s, each (n,); the v of an impulse is that just after it.

        Raises
        ------
        ValueError
            If no steady motion exists: at resonance without damping, or without a spring.
        """
        return self.pushed(push).steady(t)

    def decays(self, x_0: float, v_0: float) -> tuple[Decay, ...]:
        """Return x as a sum for a signal, in doubles: one damped swing, or two exponentials.

        If the exponents differ by less than 1e-6, relatively, one exponential with a slope.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.

        Returns
        -------
        tuple of Decay
            One or two parts of x in m; of two exponentials the slow one is first.

        Raises
        ------
        ValueError
            If a number is not possible, or an amplitude or a slope leaves the range of doubles.
        """
        start = self.exact_starts(x_0, v_0)[0]
        with precise():
            x, w = start[0], sum_of(start[1], self.exact_sigma * start[0])
            apart = 2 * self.exact_beta
            swing, sigma = self.exact_omega_d, self.exact_sigma
            if swing > _SAME * self._a:
                sine = w / swing
                return (_decay((x * x + sine * sine).sqrt(), NONE, sigma, swing, phase_of(x, sine)),)
            if apart > _SAME * self._a:
                slow, fast = sum_of(x, w / apart), -w / apart
                return _decay(slow, NONE, sigma), _decay(fast, NONE, sigma + apart)
            return (_decay(x, w, sigma),)

    def fading(self, x_0: float, v_0: float) -> tuple[Fading, Fading, Fading]:
        """Return x, v and a for signals: regular at critical damping.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.

        Returns
        -------
        tuple of three Fading
            x in m, v in m/s and a in m/s^2.

        Raises
        ------
        ValueError
            If a number is not possible, or a number of the result leaves the range of doubles.
        """
        found = []
        for row, (value, rate) in zip(QUANTITIES, self.exact_starts(x_0, v_0), strict=True):
            with precise():
                w, apart = sum_of(rate, self.exact_sigma * value), 2 * self.exact_beta
                late = (sum_of(value, w / apart), -w / apart) if apart else (NONE, NONE)
                start, sizes = (rounded(row, value), rounded(row, w)), (rounded(row, late[0]), rounded(row, late[1]))
            found.append(Fading(*start, self.rates[0], float(apart), self.omega_d, sizes))
        x, v, a = found
        return x, v, a

    @cached_property
    def struck(self) -> tuple[Fading, Fading, Fading]:
        """x, v and a after an impulse of 1 N s at rest, for signals."""
        return self.fading(0.0, 1 / self.m)

    @cached_property
    def _a(self) -> Decimal:
        with precise():
            return exact(self.c) / (2 * exact(self.m))

    @cached_property
    def _excess(self) -> Decimal:
        """a^2 - omega_n^2: below 0 it swings."""
        m, c, k = exact(self.m), exact(self.c), exact(self.k)
        with precise():
            return sum_of(c * c, -4 * m * k) / (4 * m * m)

    @cached_property
    def exact_omega_d(self) -> Decimal:
        """omega_d to 80 digits."""
        with precise():
            return max(-self._excess, NONE).sqrt()

    @cached_property
    def exact_beta(self) -> Decimal:
        """beta to 80 digits."""
        with precise():
            return max(self._excess, NONE).sqrt()

    @cached_property
    def exact_sigma(self) -> Decimal:
        """sigma to 80 digits."""
        with precise():
            return exact(self.k) / exact(self.m) / (self._a + self.exact_beta) if self.exact_beta else self._a

    def exact_starts(self, x_0: float, v_0: float) -> list[Start]:
        """The start of x, v and a, each with its rate.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.

        Returns
        -------
        list of three tuples of two Decimals
            (x_0, v_0), (v_0, a_0) and (a_0, a_0') in SI units; a_0 and a_0' are computed with 80 digits.

        Raises
        ------
        ValueError
            If a number is not possible.
        """
        check_finite("a displacement in m", x_0=x_0)
        check_finite("a velocity in m/s", v_0=v_0)
        m, c, k = exact(self.m), exact(self.c), exact(self.k)
        values = [exact(x_0), exact(v_0)]
        with precise():
            for _ in range(2):
                values.append(sum_of(-k * values[-2], -c * values[-1]) / m)
        return list(pairwise(values))

    def _together(self, starts: list[Start], t: Array) -> tuple[list[Start], list[ScaledCurve]]:
        """Both exponents in one expression, while exp(-2 beta t) has not parted from 1."""
        decay = _dying(self.exact_sigma, t)
        cosine, sine = turning(self.exact_omega_d, t)
        curves = [product(decay, cosine), product(decay, _parting(self.exact_beta, t) if self.exact_beta else sine)]
        return [(x, sum_of(v, self.exact_sigma * x)) for x, v in starts], curves

    def _apart(self, starts: list[Start], t: Array) -> tuple[list[Start], list[ScaledCurve]]:
        """Compute each exponent separately, so that the one with the smaller share keeps its digits."""
        x, v = starts[0]
        with precise():
            apart = 2 * self.exact_beta
            fast = self.exact_sigma + apart
            A, B = sum_of(v, fast * x) / apart, -sum_of(v, self.exact_sigma * x) / apart
            rows = [(A, B), (-self.exact_sigma * A, -fast * B), (self.exact_sigma**2 * A, fast**2 * B)]
        return rows, [_dying(self.exact_sigma, t), _dying(fast, t)]


def _dying(rate: Decimal, t: Array) -> ScaledCurve:
    """exp(-rate t), nothing below 1e-260."""
    with precise():
        gone = t > (float(-Decimal(SMALLEST_EXPONENT) / rate) if rate else inf)
    hi, lo = exponential(angle(-rate, np.where(gone, 0.0, t)))
    return ScaledCurve(np.where(gone, 0.0, hi), np.where(gone, 0.0, lo), Decimal(1))


def _parting(beta: Decimal, t: Array) -> ScaledCurve:
    """(1 - exp(-2 beta t))/(2 beta), up to 2 beta t = 1."""
    with precise():
        y, y_lo = angle(2 * beta, t)
        hi, lo = exponential((-y, -y_lo))
        whole = pair_sum((np.ones_like(t), np.zeros_like(t)), (-hi, -lo))
        first = two_sum(y, y_lo - y * (y / 2) * (1 - y / 3))
        short = y < _SHORT
        hi, lo = np.where(short, first, whole)
        return ScaledCurve(hi, lo, 1 / (2 * beta))


def _decay(amplitude: Decimal, slope: Decimal, rate: Decimal, omega: Decimal = NONE, phase: float = pi / 2) -> Decay:
    sizes = rounded("the amplitude", amplitude), rounded("the slope", slope)
    return Decay(*sizes, float(rate), float(omega), phase)

r"""One oscillator with a dashpot, driven: by a force on the mass, by a shaken base, or by a rotating unbalance.

    wall --/\/\/ k \/\/\--+
                          [m] --> x        m x'' + c x' + k x = Im(F exp(i omega t))
    wall ------[ c ]------+

    F = F_0               a force F_0 sin(omega t) on the mass
    F = (k + i c omega) Y     the wall moves by Y sin(omega t), and x is counted from where it was at rest
    F = mu e omega^2      a mass mu, part of m, turns at the distance e

The steady part is x_p = Im(X exp(i omega t)), X = F/D, D = k - m omega^2 + i c omega, and lags by psi = -arg X. From
rest x = Im(F E)/m, where E is the second divided difference of exp(z t) at i omega and both exponents of the free
motion: regular without damping, at resonance and at critical damping.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.9 to 2.12.
"""

import math
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.damped import DampedOscillator
from physics.laplace import Expansion, expanded
from physics.precision.curves import combined, response, turning
from physics.precision.exact import Array, exact, precise, sum_of, within_an_ulp
from physics.precision.polynomials import Polynomial
from physics.transient import EXACT, Effort, summed
from physics.valid import DOUBLES, check_finite, check_not_negative, finite_array, in_range, keep_doubles

Complexes = NDArray[np.complex128]
Drive = Literal["force", "base", "unbalance"]
QUANTITIES = "the displacement", "the velocity"
_FEWEST, _TERMS = 12, 34
_EARLY = 2.0  # rad; up to here the power series of E is exact to the last digit


class DrivenMotion(NamedTuple):
    """Times, displacements and velocities, each (n,).

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x, v : ndarray, shape (n,)
        Displacements in m, velocities in m/s.
    """

    t: Array
    x: Array
    v: Array


class Push(NamedTuple):
    """The numbers of a motion from rest, for a signal: F/m = re + i im in m/s^2, the drive omega, and the free motion.

    Attributes
    ----------
    re, im : float
        Both parts of F/m in m/s^2.
    omega, omega_n : float
        The frequency of the drive and the natural frequency without damping, in rad/s.
    slow, apart : float
        The rate at which the slower part of the free motion dies, and how much faster the other one does, in 1/s.
    swing, detuning : float
        The frequency omega_d of the free motion, 0 from critical damping on, and the exact omega - omega_d, in rad/s.
    """

    re: float
    im: float
    omega: float
    omega_n: float
    slow: float
    apart: float
    swing: float
    detuning: float


@dataclass(frozen=True, kw_only=True)
class DrivenOscillator:
    """A mass on a spring and a dashpot, driven by a force, by its base or by an unbalanced rotor.

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
        self.free  # noqa: B018 (its limits are those of the parameters)

    @cached_property
    def free(self) -> DampedOscillator:
        """The oscillator, left alone."""
        return DampedOscillator(m=self.m, c=self.c, k=self.k)

    def at_resonance(self, omega: float) -> bool:
        """Return True if no steady part exists: no damping, and the drive at omega_n to the nearest double.

        Parameters
        ----------
        omega : float
            The drive frequency in rad/s.

        Returns
        -------
        bool
            True at a resonance without damping; False with a dashpot.
        """
        with precise():
            return not self.c and within_an_ulp(omega, (exact(self.k) / exact(self.m)).sqrt())

    def response(self, omega: float, size: float = 1.0, kind: Drive = "force") -> complex:
        """Return the complex amplitude X of the steady motion x_p = Im(X exp(i omega t)).

        It is computed from exact numbers; each part is rounded once, so |X| and the lag are within 2 u.

        Parameters
        ----------
        omega : float
            The drive frequency in rad/s, 0 or more.
        size : float
            The amplitude of the drive, 0 or more: F_0 in N, Y in m, or mu e in kg m.
        kind : {"force", "base", "unbalance"}
            The kind of drive.

        Returns
        -------
        complex
            X in m; infinite without damping at the natural frequency exactly.

        Raises
        ------
        ValueError
            If a number is not possible, or the amplitude leaves the range of doubles.
        """
        re, im = self._force(omega, size, kind)
        m, c, k, w = map(Fraction, (self.m, self.c, self.k, float(omega)))
        d, e = k - m * w * w, c * w
        square = d * d + e * e
        if not square:
            return complex(math.inf, 0.0) if re or im else 0j
        try:
            return complex(float((re * d + im * e) / square), float((im * d - re * e) / square))
        except OverflowError:
            raise ValueError(f"the amplitude at omega = {omega:.6g} rad/s leaves {DOUBLES}") from None

    def bode(self, omega: ArrayLike, size: float = 1.0, kind: Drive = "force") -> tuple[Array, Array]:
        """Return the response over many drive frequencies.

        Parameters
        ----------
        omega : array_like, shape (n,)
            Drive frequencies in rad/s, 0 or more.
        size : float
            The amplitude of the drive: F_0 in N, Y in m, or mu e in kg m.
        kind : {"force", "base", "unbalance"}
            The kind of drive.

        Returns
        -------
        tuple of ndarray, each (n,)
            |X| in m, and the lag in rad, as `response` and `lag` have them.

        Raises
        ------
        ValueError
            If a number is not possible.
        """
        each = [self.response(w, size, kind) for w in finite_array("omega", omega).tolist()]
        return np.array(list(map(abs, each))), np.array(list(map(lag, each)))

    def motion(
        self, omega: float, size: float = 1.0, x_0: float = 0.0, v_0: float = 0.0, t: ArrayLike = 0.0,
        kind: Drive = "force", effort: Effort = EXACT,
    ) -> DrivenMotion:  # fmt: skip
        """Return the motion under a drive that begins at t = 0.

        Parameters
        ----------
        omega, size, kind
            The drive, as in `response`.
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.
        t : array_like, shape (n,)
            Times in s, 0 or more.
        effort : Effort
            The digits, and the limit of the work.

        Returns
        -------
        DrivenMotion
            x in m and v in m/s, each (n,): with a dashpot as exact as `effort` says, else within 1 u of their parts.

        Raises
        ------
        ValueError
            If a number is not possible, or the motion takes more work than `effort` allows.
        """
        t = finite_array("t", t)
        check_not_negative("a time in s", t=float(np.min(t, initial=0.0)))
        check_finite("a displacement in m", x_0=x_0)
        check_finite("a velocity in m/s", v_0=v_0)
        re, im = self._force(omega, size, kind)
        omega, x_0, v_0 = float(omega), float(x_0), float(v_0)
        if not self.c or not (re or im) or not omega:
            return self._undamped(omega, re, x_0, v_0, t)
        numbers = (self.m, self.c, self.k, omega, x_0, v_0)
        values = summed(lambda digits: _expansion(numbers, (re, im), digits), t, effort)[[0, 3]]
        values[:, t == 0.0] = [[x_0], [v_0]]
        x, v = (in_range(name, row) for name, row in zip(QUANTITIES, values, strict=True))
        return DrivenMotion(t, x, v)

    def push(self, omega: float, size: float = 1.0, kind: Drive = "force") -> Push:
        """Return the motion from rest as numbers for a signal.

        Parameters
        ----------
        omega, size, kind
            The drive, as in `response`.

        Returns
        -------
        Push
            The numbers that `drawn` takes.

        Raises
        ------
        ValueError
            If a number is not possible, or F/m leaves the range of doubles.
        """
        try:
            re, im = (float(part / Fraction(self.m)) for part in self._force(omega, size, kind))
        except OverflowError:
            raise ValueError(f"the acceleration F/m at omega = {omega:.6g} rad/s leaves {DOUBLES}") from None
        one, (slow, _) = self.free, self.free.rates
        with precise():
            detuning = float(exact(omega) - one.exact_omega_d)
            return Push(re, im, omega, one.omega_n, slow, float(2 * one.exact_beta), one.omega_d, detuning)

    def _force(self, omega: float, size: float, kind: Drive) -> tuple[Fraction, Fraction]:
        """F in N, exactly."""
        check_not_negative("a drive frequency in rad/s", omega=omega)
        check_not_negative("the size of a drive", size=size)
        check_drive_kind(kind)
        of, w = Fraction(float(size)), Fraction(float(omega))
        if kind == "base":
            return Fraction(self.k) * of, Fraction(self.c) * w * of
        return (of if kind == "force" else of * w * w), Fraction(0)

    def _undamped(self, omega: float, force: Fraction, x_0: float, v_0: float, t: Array) -> DrivenMotion:
        """The motion for c = 0, or for no drive."""
        if not force or not omega:
            free = self.free.motion(x_0, v_0, t)
            return DrivenMotion(t, free.x, free.v)
        x, v = exact(x_0), exact(v_0)
        with precise():
            square, push = exact(self.k) / exact(self.m), _decimal(force) / exact(self.m)
            rate, none = square.sqrt(), Decimal(0)
            rows = [(x, v, push, none), (v, -square * x, none, push)]
            curves = (*turning(rate, t), *response(exact(omega), rate, t))
        x_, v_ = combined(rows, curves, QUANTITIES)
        return DrivenMotion(t, x_, v_)


def check_drive_kind(kind: str) -> None:
    """Raise ValueError if there is no drive of this `kind`."""
    if kind not in get_args(Drive):
        raise ValueError(f"kind = {kind!r}: a drive is allowed to be {' or '.join(get_args(Drive))}")


def lag(X: complex) -> float:
    """Return the angle by which x follows the drive.

    Parameters
    ----------
    X : complex
        The complex amplitude of the steady motion, as from `DrivenOscillator.response`.

    Returns
    -------
    float
        The lag in rad, from 0 to pi for a force and an unbalance.
    """
    return math.atan2(0.0 - X.imag, X.real)


def drawn(push: Push, t: ArrayLike) -> tuple[Array, Array]:
    """Return x in m and v in m/s (n,) at the times t (n,) in s, for a `push` from rest, in plain doubles.

    Both are within 5 (1 + omega t) u of the sizes of their parts.
    """
    t = finite_array("t", t)
    E, g = from_rest(push, t), impulse(push, t)
    F = complex(push.re, push.im)
    return np.imag(F * E), np.imag(1j * push.omega * F * E) + push.im * g


def impulse(push: Push, t: Array) -> Array:
    """Return x/v_0 in s of the free motion from x = 0, for the oscillator of a `push`, at the times t (n,) in s."""
    if push.swing:
        return np.asarray(np.exp(-push.slow * t) * np.sin(push.swing * t) / push.swing)
    grown = -np.expm1(-push.apart * t) / push.apart if push.apart else t
    return np.asarray(np.exp(-push.slow * t) * grown)


def from_rest(push: Push, t: Array) -> Complexes:
    """Return E (n,) in s^2 for a `push` at the times t (n,) in s, by that one of three forms that keeps the digits."""
    _, _, omega, omega_n, slow, apart, swing, _ = push
    E = np.empty(t.shape, complex)
    early = max(omega, omega_n, slow + apart) * t <= _EARLY
    near = swing > 0 and slow < omega_n / 2 and omega_n / 2 < omega < 2 * omega_n
    split = ~early & (near | (apart * t > 1))
    rest = ~early & ~split
    for where, form in ((early, _by_powers), (split, _by_parts), (rest, _plainly)):
        if np.any(where):
            E[where] = form(push, t[where])
    return E


def _by_powers(push: Push, t: Array) -> Complexes:
    """The power series of E'' + 2 a E' + omega_n^2 E = exp(i omega t)."""
    damping, square, turn = (2 * push.slow + push.apart) * t, (push.omega_n * t) ** 2, 1j * push.omega * t
    before, last, term = np.zeros(t.shape, complex), np.zeros(t.shape, complex), np.ones(t.shape, complex)
    sums = [np.zeros(t.shape, complex)] * 3
    for k in range(_TERMS):
        before, last = last, (term * t * t - damping * (k + 1) * last - square * before) / ((k + 2) * (k + 1))
        sums = [*sums[1:], sums[-1] + last]
        if k > _FEWEST and (sums[0] == sums[-1]).all():
            break  # the last two terms change nothing, and the next ones are smaller
        term = term * turn / (k + 1)
    return sums[-1]


def _by_parts(push: Push, t: Array) -> Complexes:
    """The difference of two first differences, each of exp(i omega t) and one exponential of the free motion."""
    _, _, omega, _, slow, apart, swing, detuning = push
    one = complex(-slow, swing), complex(slow, detuning if swing else omega)
    two = complex(-slow - apart, -swing), complex(slow + apart, omega + swing)
    turned = np.exp(1j * omega * t)
    D = [_divided(*pair, turned, t) for pair in (one, two)]
    return np.asarray((D[0] - D[1]) / complex(apart, 2 * swing))


def _divided(p: complex, step: complex, turned: Complexes, t: Array) -> Complexes:
    """(turned - exp(p t))/step, turned = exp(i omega t), step = i omega - p."""
    z, decay = step * t, np.exp(p * t)
    small = -p.real * t < 1
    tiny = np.abs(z) < 1
    grown = np.expm1(np.where(tiny | ~small, 1, z)) / np.where(tiny, 1, z)
    over, near = np.ones(np.count_nonzero(tiny), complex), z[tiny]
    for k in range(20, 0, -1):
        over = 1 + near * over / (k + 1)
    grown[tiny] = over
    apart = (turned - decay) / (step or 1)
    return np.asarray(np.where(small, decay * t * grown, apart))


def _plainly(push: Push, t: Array) -> Complexes:
    """The steady part and the free motion from its start, both turned over."""
    _, _, omega, omega_n, slow, apart, swing, _ = push
    X = 1 / complex((omega_n - omega) * (omega_n + omega), (2 * slow + apart) * omega)
    cosine = np.cos(swing * t) * np.exp(-slow * t)
    return np.asarray(X * np.exp(1j * omega * t) - X * cosine - (1j * omega + slow) * X * impulse(push, t))


@lru_cache(maxsize=16)
def _expansion(numbers: tuple[float, ...], force: tuple[Fraction, Fraction], digits: int) -> Expansion:
    """x as a sum of exponentials, in numbers of that many digits."""
    m, c, k, omega, x_0, v_0 = map(Fraction, numbers)
    start: Polynomial = (m * v_0 + c * x_0, m * x_0)
    drive: Polynomial = (force[0] * omega, force[1])
    return expanded((k, c, m), (start,) * 3, (drive,) * 3, float(omega), digits)


def _decimal(value: Fraction) -> Decimal:
    with precise():
        return sum_of(Decimal(value.numerator) / Decimal(value.denominator), Decimal(0))

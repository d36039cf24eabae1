"""The motion of the driven chain in arbitrary precision, to measure others by; independent of physics.precision.exact.

Modes as in D34, slides 3 and 4, with mpmath at 100 digits, more if the parameters differ a lot. Per mode

    q'' + omega_n^2 q = f sin(omega t),   q = q_0 cos(omega_n t) + q_0' sin(omega_n t)/omega_n + f g(t),
    g = (omega_n sin(omega t) - omega sin(omega_n t))/(omega_n (omega_n^2 - omega^2)),

and its limits (sin(omega t) - omega t cos(omega t))/(2 omega^2) at omega = omega_n and
t/omega - sin(omega t)/omega^2 at omega_n = 0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from math import frexp
from typing import Any, NamedTuple

import numpy as np

from physics.coupled import TwoMassChain
from physics.integrators.problem import Problem, Trajectory
from physics.precision.exact import Array
from physics.reference.dashpot import dashpot_rows

DIGITS = 100
EXACT = 20000  # bits for any few sums and products of doubles
Pair = tuple[float, float]
SAME = 1e-70  # relative: closer frequencies are the same in exact arithmetic


class Point(NamedTuple):
    """A true value, and the size that an error in it is measured by.

    Attributes
    ----------
    value, size : Decimal
        Both in the unit of the quantity, to 40 digits.
    """

    value: Decimal
    size: Decimal


@dataclass(frozen=True)
class Reference:
    """The true motion at the output times of a problem.

    Attributes
    ----------
    x, x_rest : ndarray (2, n)
        Displacements x + x_rest in m, rounded to 106 bits.
    v : ndarray (2, n)
        Velocities in m/s.
    energy : ndarray (n,)
        T + V in J.
    """

    x: Array
    x_rest: Array
    v: Array
    energy: Array

    @property
    def size(self) -> float:
        """The largest displacement in m."""
        return float(np.max(np.abs(self.x)))

    @property
    def largest_energy(self) -> float:
        """The largest T + V in J."""
        return float(np.max(self.energy))

    def errors(self, x: Array) -> Array:
        """Return |x - true| (n,), the worse of both masses, over the largest displacement; x is (2, n) in m."""
        difference = np.abs((x - self.x) - self.x_rest)
        return np.asarray(np.max(difference, axis=0) / self.size)

    def velocity_errors(self, v: Array) -> Array:
        """Return |v - true| (n,), the worse of both masses, over the largest velocity; v is (2, n) in m/s."""
        return np.asarray(np.max(np.abs(v - self.v), axis=0) / np.max(np.abs(self.v)))

    def mode_errors(self, chain: TwoMassChain, x: Array) -> tuple[float, float]:
        """Return the largest parts of the error of x (2, n) in the slow and in the fast mode of a `chain` with k2 > 0.

        They are over the largest displacement.
        """
        e1, e2 = (x - self.x) - self.x_rest
        slow, fast = (
            np.max(np.abs(chain.m1 * e1 + chain.m2 * r * e2)) * max(1.0, abs(r)) / (chain.m1 + chain.m2 * r * r)
            for r in chain.modes().ratio.tolist()
        )
        return float(slow / self.size), float(fast / self.size)

    def energy_errors(self, chain: TwoMassChain, result: Trajectory) -> Array:
        """Return |T + V - true| (n,) of the `result` of a method for the `chain`, over the largest energy."""
        T = chain.m1 * result.v[0] ** 2 + chain.m2 * result.v[1] ** 2
        V = chain.k1 * result.x[0] ** 2 + chain.k2 * result.stretch**2
        return np.asarray(np.abs((T + V) / 2 - self.energy) / self.largest_energy)


class _Mode(NamedTuple):
    """Frequency, X2/X1 as a shape (2,), start and start's rate of its coordinate, the drive's share."""

    omega: Any
    shape: tuple[Any, Any]
    q_0: Any
    p_0: Any
    f: Any


def reference(problem: Problem) -> Reference:
    """Return the true motion at the output times of a `problem`."""
    import mpmath

    with mpmath.workdps(DIGITS + _spread(problem.chain)):
        if problem.c:
            rows = [(x, mpmath.mpf(0), v, mpmath.mpf(0), energy) for x, v, energy in dashpot_rows(problem)]
        else:
            modes = _modes(mpmath.mp, problem)
            rows = [_state(mpmath.mp, problem, modes, t) for t in problem.t.tolist()]
        x = np.array([[float(value) for value in row[:2]] for row in rows]).T
        rest = [[float(value - float(value)) for value in row[:2]] for row in rows]
        v = np.array([[float(value) for value in row[2:4]] for row in rows]).T
        return Reference(x=x, x_rest=np.array(rest).T, v=v, energy=np.array([float(row[4]) for row in rows]))


def modal_points(problem: Problem) -> list[list[list[Point]]]:
    """Return x in m by mode (slow, fast), mass and output time of a `problem`; sizes are amplitudes and envelopes."""
    import mpmath

    with mpmath.workdps(DIGITS + _spread(problem.chain)):
        return _points(mpmath.mp, _modes(mpmath.mp, problem), problem.omega, problem.t)


def points_of_modes(chain: TwoMassChain, amplitude: Pair, phase: Pair, t: Array) -> list[list[list[Point]]]:
    """Return the parts of x in a free motion with given amplitudes and phases.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    amplitude, phase : tuple of two floats
        Amplitudes in m and phases in rad of the slow and the fast mode.
    t : ndarray (n,)
        Times in s.

    Returns
    -------
    list of lists of lists of Point
        x in m by mode, mass and time.
    """
    import mpmath

    with mpmath.workdps(DIGITS + _spread(chain)):
        modes = []
        for (omega, shape), size, phi in zip(_shapes(mpmath.mp, chain), amplitude, phase, strict=True):
            A, angle = mpmath.mpf(size), mpmath.mpf(phi)
            q_0, p_0 = A * mpmath.sin(angle), A * omega * mpmath.cos(angle)
            modes.append(_Mode(omega, shape, q_0, p_0, mpmath.mpf(0)))
        return _points(mpmath.mp, modes, 0.0, t)


def _points(mp: Any, modes: list[_Mode], omega: float, t: Array) -> list[list[list[Point]]]:
    drive, times = mp.mpf(omega), [mp.mpf(instant) for instant in t.tolist()]
    points = []
    for mode in modes:
        states = [(_coordinate(mp, mode, drive, at)[0], _reach(mp, mode, drive, at)) for at in times]
        points.append([[point(share * q, abs(share) * size) for q, size in states] for share in mode.shape])
    return points


def modes_of(chain: TwoMassChain) -> list[tuple[Decimal, Decimal | None]]:
    """Return omega in rad/s and X2/X1 of the slow and the fast mode of the `chain`; None if mass 1 is at rest."""
    import mpmath

    with mpmath.workdps(DIGITS + _spread(chain)):
        shapes = _shapes(mpmath.mp, chain)
        return [(decimal(omega), decimal(r / a) if a else None) for omega, (a, r) in shapes]


def determinants(chain: TwoMassChain, omega: Sequence[float]) -> list[Decimal]:
    """Return D = det A (lecture D34, slide 3) in N^2/m^2 of the `chain` at each frequency `omega` in rad/s."""
    import mpmath

    with mpmath.workprec(EXACT):
        m1, m2, k1, k2 = (mpmath.mpf(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
        squares = [mpmath.mpf(w) ** 2 for w in omega]
        return [decimal((m1 * s - k1 - k2) * (m2 * s - k2) - k2**2) for s in squares]


def point(value: Any, size: Any) -> Point:
    """Return a point from `value` and `size`, numbers of mpmath."""
    return Point(decimal(value), decimal(size))


def decimal(value: Any) -> Decimal:
    """Return the `value`, a number of mpmath, to 40 digits."""
    import mpmath

    return Decimal(mpmath.nstr(value, 40))


def _spread(chain: TwoMassChain) -> int:
    """Digits between the largest and the smallest parameter, twice."""
    exponents = [frexp(value)[1] for value in (chain.m1, chain.m2, chain.k1, chain.k2) if value]
    return 2 * round(0.3 * (max(exponents) - min(exponents)))


def _modes(mp: Any, problem: Problem) -> list[_Mode]:
    m1, m2 = mp.mpf(problem.chain.m1), mp.mpf(problem.chain.m2)
    x1, x2, v1, v2 = (mp.mpf(value) for value in problem.start)
    modes = []
    for omega, (a, r) in _shapes(mp, problem.chain):
        M = m1 * a * a + m2 * r * r
        q_0, p_0 = (m1 * a * x1 + m2 * r * x2) / M, (m1 * a * v1 + m2 * r * v2) / M
        modes.append(_Mode(omega, (a, r), q_0, p_0, a * mp.mpf(problem.F_0) / M))
    return modes


def _shapes(mp: Any, chain: TwoMassChain) -> list[tuple[Any, tuple[Any, Any]]]:
    """omega and (X1, X2) of the slow and the fast mode."""
    m1, m2, k1, k2 = (mp.mpf(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
    if not k2:
        return [(mp.mpf(0), (mp.mpf(0), mp.mpf(1))), (mp.sqrt(k1 / m1), (mp.mpf(1), mp.mpf(0)))]
    b = m1 * k2 + m2 * (k1 + k2)
    root = mp.sqrt(b * b - 4 * m1 * m2 * k1 * k2)
    squares = (2 * k1 * k2 / (b + root), (b + root) / (2 * m1 * m2))
    return [(mp.sqrt(square), (mp.mpf(1), (k1 + k2 - m1 * square) / k2)) for square in squares]


def _state(mp: Any, problem: Problem, modes: list[_Mode], t: float) -> tuple[Any, ...]:
    """x1, x2, v1, v2 and the energy."""
    chain, zero = problem.chain, mp.mpf(0)
    x, v = [zero, zero], [zero, zero]
    for mode in modes:
        q, p = _coordinate(mp, mode, mp.mpf(problem.omega), mp.mpf(t))
        for i, share in enumerate(mode.shape):
            x[i] += share * q
            v[i] += share * p
    T = chain.m1 * v[0] ** 2 + chain.m2 * v[1] ** 2
    return *x, *v, (T + chain.k1 * x[0] ** 2 + chain.k2 * (x[1] - x[0]) ** 2) / 2


def _coordinate(mp: Any, mode: _Mode, omega: Any, t: Any) -> tuple[Any, Any]:
    """q and q' of one mode."""
    n = mode.omega
    c, s = mp.cos(n * t), mp.sin(n * t)
    q = mode.q_0 * c + mode.p_0 * (s / n if n else t)
    p = mode.p_0 * c - mode.q_0 * n * s
    if not (mode.f and omega):
        return q, p
    C, S = mp.cos(omega * t), mp.sin(omega * t)
    if not n:
        g, rate = (t - S / omega) / omega, (1 - C) / omega
    elif abs(n - omega) <= SAME * n:
        g, rate = (s - n * t * c) / (2 * n * n), t * s / 2
    else:
        gap = n * n - omega * omega
        g, rate = (S - omega * s / n) / gap, omega * (C - c) / gap
    return q + mode.f * g, p + mode.f * rate


def _reach(mp: Any, mode: _Mode, omega: Any, t: Any) -> Any:
    """A bound of |q| up to the time t: the amplitude, or what a drift has reached, and the envelope of the response."""
    n = mode.omega
    free = mp.hypot(mode.q_0, mode.p_0 / n) if n else abs(mode.q_0) + abs(mode.p_0 * t)
    return free + abs(mode.f) * envelope(omega, n, t)[0] if omega else free


def envelope(omega: Any, omega_n: Any, t: Any) -> tuple[Any, Any]:
    """Return bounds of |g| and |g'| up to a time; all numbers are mpmath's.

    Parameters
    ----------
    omega, omega_n : mpf
        The frequency of the drive and the natural frequency in rad/s.
    t : mpf
        The time in s.

    Returns
    -------
    tuple of two mpf
        The bounds of |g| in s^2 and of |g'| in s.
    """
    if not (omega and t):
        return 0 * t, 0 * t
    s, d = (omega + omega_n) / 2, abs(omega - omega_n) / 2
    over_s, over_d = min(t, 1 / s), min(t, 1 / d) if d else t
    bounds = [omega * t**3 / 6]
    if omega_n:
        bounds.append((over_s + over_d) / (2 * omega_n))
    if d:
        bounds.append(omega * (1 / omega + (min(t, 1 / omega_n) if omega_n else t)) / (4 * s * d))
    return min(bounds), omega * over_s * over_d / 2

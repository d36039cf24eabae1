"""The motion of the driven chain in arbitrary precision, to measure others by; independent of physics.exact.

Modes as in D34, slides 3 and 4, with mpmath at 100 digits, more where the parameters lie far apart. Per mode

    q'' + omega_n^2 q = f sin(omega t),   q = q_0 cos(omega_n t) + q_0' sin(omega_n t)/omega_n + f g(t),
    g = (omega_n sin(omega t) - omega sin(omega_n t))/(omega_n (omega_n^2 - omega^2)),

and its limits (sin(omega t) - omega t cos(omega t))/(2 omega^2) at omega = omega_n and
t/omega - sin(omega t)/omega^2 at omega_n = 0.
"""

from dataclasses import dataclass
from math import frexp
from typing import Any, NamedTuple

import numpy as np

from physics.coupled import TwoMassChain
from physics.exact import Array
from physics.integrators import Problem, Trajectory

DIGITS = 100
SAME = 1e-70  # relative: closer frequencies are the same in exact arithmetic


@dataclass(frozen=True)
class Reference:
    """Displacements x + x_rest (2, n), rounded to 106 bits, and the energy (n,)."""

    x: Array
    x_rest: Array
    energy: Array

    @property
    def size(self) -> float:
        """The largest displacement."""
        return float(np.max(np.abs(self.x)))

    @property
    def largest_energy(self) -> float:
        """The largest T + V."""
        return float(np.max(self.energy))

    def errors(self, x: Array) -> Array:
        """|x - true| (n,), the worse of both masses, in units of the largest displacement."""
        difference = np.abs((x - self.x) - self.x_rest)
        return np.asarray(np.max(difference, axis=0) / self.size)

    def energy_errors(self, chain: TwoMassChain, result: Trajectory) -> Array:
        """|T + V - true| (n,) in units of the largest energy."""
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
    """The true motion at the output times of the problem."""
    import mpmath

    with mpmath.workdps(DIGITS + _spread(problem.chain)):
        modes = _modes(mpmath.mp, problem)
        rows = [_state(mpmath.mp, problem, modes, t) for t in problem.t.tolist()]
        x = np.array([[float(value) for value in row[:2]] for row in rows]).T
        rest = [[float(value - float(value)) for value in row[:2]] for row in rows]
        return Reference(x=x, x_rest=np.array(rest).T, energy=np.array([float(row[2]) for row in rows]))


def _spread(chain: TwoMassChain) -> int:
    """Digits between the largest and the smallest parameter, twice."""
    exponents = [frexp(value)[1] for value in (chain.m1, chain.m2, chain.k1, chain.k2) if value]
    return 2 * round(0.3 * (max(exponents) - min(exponents)))


def _modes(mp: Any, problem: Problem) -> list[_Mode]:
    chain = problem.chain
    m1, m2, k1, k2 = (mp.mpf(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
    x1, x2, v1, v2 = (mp.mpf(value) for value in problem.start)
    if k2:
        b = m1 * k2 + m2 * (k1 + k2)
        root = mp.sqrt(b * b - 4 * m1 * m2 * k1 * k2)
        squares = (2 * k1 * k2 / (b + root), (b + root) / (2 * m1 * m2))
        shapes = [(mp.mpf(1), (k1 + k2 - m1 * square) / k2) for square in squares]
    else:
        squares, shapes = (mp.mpf(0), k1 / m1), [(mp.mpf(0), mp.mpf(1)), (mp.mpf(1), mp.mpf(0))]
    modes = []
    for square, (a, r) in zip(squares, shapes, strict=True):
        M = m1 * a * a + m2 * r * r
        q_0, p_0 = (m1 * a * x1 + m2 * r * x2) / M, (m1 * a * v1 + m2 * r * v2) / M
        modes.append(_Mode(mp.sqrt(square), (a, r), q_0, p_0, a * mp.mpf(problem.F_0) / M))
    return modes


def _state(mp: Any, problem: Problem, modes: list[_Mode], t: float) -> tuple[Any, Any, Any]:
    """x1, x2 and the energy."""
    chain, zero = problem.chain, mp.mpf(0)
    x, v = [zero, zero], [zero, zero]
    for mode in modes:
        q, p = _coordinate(mp, mode, mp.mpf(problem.omega), mp.mpf(t))
        for i, share in enumerate(mode.shape):
            x[i] += share * q
            v[i] += share * p
    T = chain.m1 * v[0] ** 2 + chain.m2 * v[1] ** 2
    return x[0], x[1], (T + chain.k1 * x[0] ** 2 + chain.k2 * (x[1] - x[0]) ** 2) / 2


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

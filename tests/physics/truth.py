"""Families of chains, and their motions in arbitrary precision by the lecture's formulas without rearrangement.

A family takes uniform(low, high) and returns m1, m2, k1, k2, so that hypothesis can draw from it for the property
tests and a plain generator for the accuracy table.

The truth is independent of physics/, but for the size of an envelope: mpmath instead of decimal, the formulas of the
slides instead of the rearranged ones. 6000 bits outlast every cancellation that positive doubles can cause; motions
need far fewer.
"""

import json
import math
import sys
from collections.abc import Callable
from dataclasses import asdict
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
import pytest
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.reference.driven_chain import envelope
from tests.grids import sample

U = 2.0**-53
SETUP_BITS = 6000
WORKING_BITS = 1500  # around a test; what needs more sets it itself
MOTION_BITS = 400
LARGEST = sys.float_info.max


class Truth:
    """mpmath numbers for one chain: omega, ratio, shape, mass of the modes (slow, fast), and its motions."""

    def __init__(self, m1, m2, k1, k2):
        with mp.workprec(SETUP_BITS):
            self.m1, self.m2, self.k1, self.k2 = (mp.mpf(value) for value in (m1, m2, k1, k2))
            b = self.m1 * self.k2 + self.m2 * (self.k1 + self.k2)
            product = self.m1 * self.m2
            root = mp.sqrt(b**2 - 4 * product * self.k1 * self.k2)
            self.omega = [mp.sqrt((b - root) / (2 * product)), mp.sqrt((b + root) / (2 * product))]
            self.beat = self.omega[1] - self.omega[0]
            self.shape = self._shapes()
            self.ratio = [b / a if a else mp.inf for a, b in self.shape]
            self.stretch = [b - a for a, b in self.shape]
            self.antiresonance = mp.sqrt(self.k2 / self.m2)
            self.mass = [self.m1 * a**2 + self.m2 * b**2 for a, b in self.shape]

    def _shapes(self):
        if not self.k2:
            return [(mp.mpf(0), mp.mpf(1)), (mp.mpf(1), mp.mpf(0))]
        return [(mp.mpf(1), (self.k1 + self.k2 - self.m1 * w**2) / self.k2) for w in self.omega]

    def coordinates(self, x_0, v_0):
        """(displacement, velocity) of each mode at t = 0."""
        with mp.workprec(SETUP_BITS):
            return [
                tuple((self.m1 * a * mp.mpf(p[0]) + self.m2 * b * mp.mpf(p[1])) / M for p in (x_0, v_0))
                for (a, b), M in zip(self.shape, self.mass, strict=True)
            ]

    def free(self, x_0, v_0, t):
        """x1, x2, e2, v1, v2 at the time t, and the scale (sum of amplitudes) of each."""
        values, scales = [mp.mpf(0)] * 5, [mp.mpf(0)] * 5
        t = mp.mpf(t)
        for j, (q, v) in enumerate(self.coordinates(x_0, v_0)):
            w = self.omega[j]
            with mp.workprec(MOTION_BITS + (max(0, mp.mag(w * t)) if w * t else 0)):
                c, s = mp.cos(w * t), mp.sin(w * t) / w if w else t
                size = mp.sqrt(q**2 + (v / w) ** 2) if w else abs(q) + abs(v * t)
                speed = w * size if w else abs(v)
                self._add(values, scales, j, q * c + v * s, v * c - q * w**2 * s, size, speed)
        return values, scales

    def driven(self, F_0, omega, t):
        """The motion from rest under F_0 sin(omega t), and the envelope of each coordinate."""
        values, scales = [mp.mpf(0)] * 5, [mp.mpf(0)] * 5
        for j in (0, 1):
            share = self.shape[j][0] * mp.mpf(F_0) / self.mass[j]
            g, speed = response(mp.mpf(omega), self.omega[j], mp.mpf(t))
            size, swiftness = envelope(mp.mpf(omega), self.omega[j], abs(mp.mpf(t)))
            self._add(values, scales, j, share * g, share * speed, abs(share) * size, abs(share) * swiftness)
        return values, scales

    def _add(self, values, scales, j, x, v, size, speed):
        a, b = self.shape[j]
        parts = [(a, x, size), (b, x, size), (self.stretch[j], x, size), (a, v, speed), (b, v, speed)]
        for i, (part, value, scale) in enumerate(parts):
            values[i] += part * value
            scales[i] += abs(part) * scale


def response(omega, omega_n, t):
    """g, g' of g'' + omega_n^2 g = sin(omega t) from rest, by the direct quotient."""
    if not omega or not t:
        return mp.mpf(0), mp.mpf(0)
    lost = 6 * abs(mp.mag(max(omega, omega_n) * t)) + abs(mp.mag(omega) - mp.mag(omega_n or omega)) * 2
    closeness = abs(mp.mag(omega - omega_n) - mp.mag(omega)) if omega != omega_n else 0
    with mp.workprec(min(20000, MOTION_BITS + lost + 2 * closeness)):
        if omega == omega_n:
            g = (mp.sin(omega * t) / omega - t * mp.cos(omega * t)) / (2 * omega)
            return g, t * mp.sin(omega * t) / 2
        over_n = mp.sin(omega_n * t) / omega_n if omega_n else t
        D = omega_n**2 - omega**2
        return (mp.sin(omega * t) - omega * over_n) / D, omega * (mp.cos(omega * t) - mp.cos(omega_n * t)) / D


def ulps(value, truth):
    """The error of a double in units of its last place; one subnormal step is forgiven below 1e-291."""
    if mp.isinf(truth) or np.isinf(value):
        return 0.0 if float(truth) == value else np.inf
    if not truth:
        return 0.0 if value == 0.0 else np.inf
    unit = mp.mpf(2) ** max(mp.mag(truth) - 53, -1074)
    return float(abs(mp.mpf(float(value)) - truth) / unit)


def units(value, truth, scale):
    """The error in units u = 2**-53 of a scale, less one subnormal step where the scale is below 1e-291."""
    error = abs(mp.mpf(float(value)) - truth)
    if scale < mp.mpf("1e-291"):
        error = max(mp.mpf(0), error - mp.mpf(2) ** -1074)
    if not scale:
        return 0.0 if not error else np.inf
    return float(error / (scale * U))


def rows(motion):
    """x1, x2, e2, v1, v2, each (n,): the order of free() and driven()."""
    return [*motion.x, motion.e[1], *motion.v]


def worst(motion, n, values, scales):
    """The largest error at the n-th time, in u of its scale."""
    pairs = zip(rows(motion), values, scales, strict=True)
    return max(units(row[n], value, scale) for row, value, scale in pairs)


def by_exponential(motion, t, c1=0.0, c2=0.0):
    """x1, x2, x2 - x1, v1, v2 of a chain that starts and is driven as `motion` says, from exp(A t).

    The drive is an additional oscillator. `c1` and `c2` are parallel to the springs.
    """
    chain = motion.chain
    given = (chain.m1, chain.m2, chain.k1, chain.k2, c1, c2, motion.F_0, motion.omega)
    m1, m2, k1, k2, c1, c2, F, omega = map(mp.mpf, given)
    A = mp.matrix(6, 6)
    A[0, 2] = A[1, 3] = 1
    for i, m, sign, wall, brake in ((2, m1, 1, k1, c1), (3, m2, -1, 0, 0)):
        A[i, 0], A[i, 1] = (-sign * k2 - wall) / m, sign * k2 / m
        A[i, 2], A[i, 3] = (-sign * c2 - brake) / m, sign * c2 / m
    A[2, 4] = F / m1
    A[4, 5], A[5, 4] = omega, -omega
    x1, x2, v1, v2, _, _ = mp.expm(A * mp.mpf(t)) * mp.matrix([*motion.x_0, *motion.v_0, 0, 1])
    return x1, x2, x2 - x1, v1, v2


def steady(m1, m2, k1, k2, F_0, omega, c1=0, c2=0):
    """X1 and X2 of x_i = Im(X_i exp(i omega t)) from Newton's laws, or None at a resonance."""
    link, square = k2 + (mp.mpc(0, c2 * omega) if c2 else 0), mp.mpf(omega) ** 2
    one, two = k1 + link + (mp.mpc(0, c1 * omega) if c1 else 0) - m1 * square, link - m2 * square
    D = one * two - link**2
    return (two * F_0 / D, link * F_0 / D) if D else None


def decades(uniform, reach):
    return 10.0 ** uniform(-reach, reach)


def any_double(uniform):
    """Positive doubles, including subnormal ones; all exponents are equally likely."""
    return math.ldexp(uniform(0.5, 0.999), round(uniform(-1072.0, 1024.0)))


def tuned_weak_coupling(uniform):
    """m1 k2 = m2 (k1 + k2) within an ulp, k1 up to 1e20 times k2: beats with complete exchange."""
    m2, k2 = decades(uniform, 8), decades(uniform, 8)
    k1 = k2 * 10.0 ** uniform(0.0, 20.0)
    return float(Fraction(m2) * (Fraction(k1) + Fraction(k2)) / Fraction(k2)), m2, k1, k2


def coupled_by(uniform, low, high):
    """A chain whose k2 is so many decades from k1."""
    k1 = decades(uniform, 3)
    return decades(uniform, 3), decades(uniform, 3), k1, k1 * 10.0 ** uniform(low, high)


def mass_ratios(uniform):
    ratio = uniform(-150.0, 150.0)
    return 10.0**ratio, 10.0**-ratio * uniform(1.0, 10.0), uniform(0.1, 10.0), uniform(0.1, 10.0)


FAMILIES: dict[str, Callable[[Callable[[float, float], float]], tuple[float, ...]]] = {
    "moderate": lambda uniform: tuple(uniform(0.1, 10.0) for _ in range(4)),
    "1e+-8": lambda uniform: tuple(decades(uniform, 8) for _ in range(4)),
    "1e+-150": lambda uniform: tuple(decades(uniform, 150) for _ in range(4)),
    "all doubles": lambda uniform: tuple(any_double(uniform) for _ in range(4)),
    "tuned weak coupling": tuned_weak_coupling,
    "k2 to 0": lambda uniform: coupled_by(uniform, -300.0, 0.0),
    "k2 to infinity": lambda uniform: coupled_by(uniform, 0.0, 300.0),
    "k1 = 0": lambda uniform: (decades(uniform, 8), decades(uniform, 8), 0.0, decades(uniform, 8)),
    "k2 = 0": lambda uniform: (*(decades(uniform, 8) for _ in range(3)), 0.0),
    "k1 = k2 = 0": lambda uniform: (decades(uniform, 8), decades(uniform, 8), 0.0, 0.0),
    "mass ratios to 1e+-300": mass_ratios,
    # Many of these have rational frequencies, where resonance and antiresonance are doubles.
    "small integers": lambda uniform: tuple(float(round(uniform(1.0, 6.0))) for _ in range(4)),
}
each_family = pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)


@st.composite
def drawn(draw, family):
    """The strategy of a family."""
    return family(lambda low, high: draw(st.floats(low, high)))


def chain_with(parameters):
    """Return the chain of m1, m2, k1, k2."""
    return TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), parameters, strict=True)))


def log_uniform(low, high):
    """A strategy for doubles between two powers of two; all octaves are equally likely."""
    return st.builds(math.ldexp, st.floats(0.5, 1.0, exclude_max=True), st.integers(low + 1, high))


MAGNITUDES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "1e+-150": log_uniform(-498, 498),
    "all doubles": log_uniform(-1074, 1024),
}
each_magnitude = pytest.mark.parametrize("magnitudes", MAGNITUDES.values(), ids=MAGNITUDES)


@cache
def reference(file, part="cases"):
    """Return the cases of a part of a file: inputs in doubles, results as strings of 25 digits."""
    return json.loads((Path(__file__).parents[1] / f"reference/{file}_cases.json").read_text())[part]


def each(cases):
    """Parametrize a test by `case`: each second one, or all in whole grids."""
    return pytest.mark.parametrize("case", sample(cases), ids=lambda case: str(case["id"]))


CASES = reference("poles")
BRAKED = [case for case in CASES if case["c1"] or case["c2"]]
DIGITS = 120


class Case(NamedTuple):
    """A chain and its dashpots, at least one of which is not 0."""

    chain: TwoMassChain
    c1: float
    c2: float

    @property
    def damped(self) -> DampedChain:
        return DampedChain.of(*self)

    @property
    def values(self) -> dict[str, float]:
        return {**asdict(self.chain), "c1": self.c1, "c2": self.c2}


def case_of(values: dict[str, Any]) -> Case:
    chain = TwoMassChain(**{name: values[name] for name in ("m1", "m2", "k1", "k2")})
    return Case(chain, values["c1"], values["c2"])


def sizes(low: float = -3.0, high: float = 3.0) -> st.SearchStrategy[float]:
    """Numbers with three digits, over several decades."""
    return st.floats(low, high).map(lambda power: float(f"{10**power:.3g}"))


@st.composite
def _any_case(draw: Any) -> Case:
    size = sizes()
    m1, m2, k1, k2, c1, c2 = (draw(one) for one in (size, size, *[size | size | size | st.just(0.0)] * 4))
    return Case(TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), c1, c2 if c1 or c2 else 1.0)


@st.composite
def _proportional(draw: Any) -> Case:
    """c1 k2 = c2 k1; most of these numbers are no doubles."""
    m1, m2 = draw(sizes(-1, 1)), draw(sizes(-1, 1))
    parts, factor, unit = draw(st.tuples(st.integers(1, 9), st.integers(1, 9))), draw(st.integers(1, 400)), 0.1
    k1, k2 = (round(part * unit, 12) for part in parts)
    c1, c2 = (round(part * factor * unit / 100, 12) for part in parts)
    return Case(TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), c1, c2)


@st.composite
def _on_the_ray(draw: Any) -> Case:
    """One dashpot, and an exceptional point at some size of it: k2 m1 = k1 m2 and c2 = 0."""
    m1, k1, share = draw(st.integers(1, 9)), draw(st.integers(1, 9)), draw(st.integers(1, 9))
    chain = TwoMassChain(m1=m1, m2=m1 * share, k1=k1, k2=k1 * share)
    return Case(chain, draw(sizes(-1, 2)), 0.0)


def cases() -> st.SearchStrategy[Case]:
    """Any chain with dashpots, the exceptional ones as often as others."""
    return _any_case() | _proportional() | _on_the_ray() | st.sampled_from([case_of(one) for one in BRAKED])


def matrices(case: Case) -> tuple[mp.matrix, mp.matrix, mp.matrix]:
    """M, C and K."""
    m1, m2, k1, k2 = (mp.mpf(getattr(case.chain, name)) for name in ("m1", "m2", "k1", "k2"))
    c1, c2 = mp.mpf(case.c1), mp.mpf(case.c2)
    stiff, damping = ([[one + two, -two], [-two, two]] for one, two in ((k1, k2), (c1, c2)))
    return mp.matrix([[m1, 0], [0, m2]]), mp.matrix(damping), mp.matrix(stiff)


def eigenvectors(case: Case) -> list[tuple[Any, Any, Any]]:
    """s, X1, X2 of each root that is not 0, from the state (x1, x2, v1, v2); the larger part of a shape is 1."""
    weakest = min(c for c in (case.c1, case.c2) if c)
    with mp.workdps(DIGITS + 2 * max(0, -round(math.log10(weakest)))):  # its effect has as many digits as the others
        M, C, K = matrices(case)
        A = mp.zeros(4)
        for i in range(2):
            A[i, i + 2] = 1
            for j in range(2):
                A[i + 2, j], A[i + 2, j + 2] = -K[i, j] / M[i, i], -C[i, j] / M[i, i]
        values, vectors = mp.eig(A)
        largest, found = max(map(abs, values)), []
        for j, s in enumerate(values):
            one, two = vectors[0, j], vectors[1, j]
            over = one if abs(one) > abs(two) else two
            if abs(s) > mp.mpf(10) ** -40 * largest:
                found.append((s, one / over, two / over))
        return found

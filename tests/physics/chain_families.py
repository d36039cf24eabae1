"""Families of chains, from ordinary values to the limits of doubles, and strategies that draw from them.

Each takes uniform(low, high) and returns m1, m2, k1, k2, so that hypothesis can draw from it for the property
tests and a plain generator for the accuracy table.
"""

import math
from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import strategies as st

from physics.coupled import TwoMassChain

Uniform = Callable[[float, float], float]
Parameters = tuple[float, ...]


def decades(uniform: Uniform, reach: float) -> float:
    return float(10.0 ** uniform(-reach, reach))


def any_double(uniform: Uniform) -> float:
    """Positive doubles, including subnormal ones; all exponents are equally likely."""
    return math.ldexp(uniform(0.5, 0.999), round(uniform(-1072.0, 1024.0)))


def each_within(reach: float) -> Callable[[Uniform], Parameters]:
    """Return the family of four numbers within so many decades of 1."""
    return lambda uniform: tuple(decades(uniform, reach) for _ in range(4))


def tuned_weak_coupling(uniform: Uniform) -> Parameters:
    """m1 k2 = m2 (k1 + k2) within an ulp, k1 up to 1e20 times k2: beats with complete exchange."""
    m2, k2 = decades(uniform, 8), decades(uniform, 8)
    k1 = k2 * 10.0 ** uniform(0.0, 20.0)
    return float(Fraction(m2) * (Fraction(k1) + Fraction(k2)) / Fraction(k2)), m2, k1, k2


def coupled_by(low: float, high: float) -> Callable[[Uniform], Parameters]:
    """Return the family whose k2 is so many decades from k1."""

    def family(uniform: Uniform) -> Parameters:
        k1 = decades(uniform, 3)
        return decades(uniform, 3), decades(uniform, 3), k1, k1 * 10.0 ** uniform(low, high)

    return family


def mass_ratios(uniform: Uniform) -> Parameters:
    ratio = uniform(-150.0, 150.0)
    return 10.0**ratio, 10.0**-ratio * uniform(1.0, 10.0), uniform(0.1, 10.0), uniform(0.1, 10.0)


FAMILIES: dict[str, Callable[[Uniform], Parameters]] = {
    "moderate": lambda uniform: tuple(uniform(0.1, 10.0) for _ in range(4)),
    "1e+-8": each_within(8),
    "1e+-150": each_within(150),
    "all doubles": lambda uniform: tuple(any_double(uniform) for _ in range(4)),
    "tuned weak coupling": tuned_weak_coupling,
    "k2 to 0": coupled_by(-300.0, 0.0),
    "k2 to infinity": coupled_by(0.0, 300.0),
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

"""Families of chains, from ordinary values to the limits of doubles.

Each takes uniform(low, high) and returns m1, m2, k1, k2, so that hypothesis can draw from it for the property
tests and a plain generator for the accuracy table.
"""

import math
from collections.abc import Callable
from fractions import Fraction

from hypothesis import strategies as st

Uniform = Callable[[float, float], float]
Parameters = tuple[float, float, float, float]


def decades(uniform: Uniform, reach: float) -> float:
    return float(10.0 ** uniform(-reach, reach))


def any_double(uniform: Uniform) -> float:
    """Positive doubles, including subnormal ones; all exponents are equally likely."""
    return math.ldexp(uniform(0.5, 0.999), round(uniform(-1072.0, 1024.0)))


def moderate(uniform: Uniform) -> Parameters:
    return uniform(0.1, 10.0), uniform(0.1, 10.0), uniform(0.1, 10.0), uniform(0.1, 10.0)


def eight_decades(uniform: Uniform) -> Parameters:
    return decades(uniform, 8), decades(uniform, 8), decades(uniform, 8), decades(uniform, 8)


def half_the_range(uniform: Uniform) -> Parameters:
    return decades(uniform, 150), decades(uniform, 150), decades(uniform, 150), decades(uniform, 150)


def all_doubles(uniform: Uniform) -> Parameters:
    return any_double(uniform), any_double(uniform), any_double(uniform), any_double(uniform)


def tuned_weak_coupling(uniform: Uniform) -> Parameters:
    """m1 k2 = m2 (k1 + k2) within an ulp, k1 up to 1e20 times k2: beats with complete exchange."""
    m2, k2 = decades(uniform, 8), decades(uniform, 8)
    k1 = k2 * 10.0 ** uniform(0.0, 20.0)
    return float(Fraction(m2) * (Fraction(k1) + Fraction(k2)) / Fraction(k2)), m2, k1, k2


def coupling_to_zero(uniform: Uniform) -> Parameters:
    k1 = decades(uniform, 3)
    return decades(uniform, 3), decades(uniform, 3), k1, k1 * 10.0 ** uniform(-300.0, 0.0)


def coupling_to_infinity(uniform: Uniform) -> Parameters:
    k1 = decades(uniform, 3)
    return decades(uniform, 3), decades(uniform, 3), k1, k1 * 10.0 ** uniform(0.0, 300.0)


def no_wall(uniform: Uniform) -> Parameters:
    return decades(uniform, 8), decades(uniform, 8), 0.0, decades(uniform, 8)


def no_coupling(uniform: Uniform) -> Parameters:
    return decades(uniform, 8), decades(uniform, 8), decades(uniform, 8), 0.0


def no_springs(uniform: Uniform) -> Parameters:
    return decades(uniform, 8), decades(uniform, 8), 0.0, 0.0


def mass_ratios(uniform: Uniform) -> Parameters:
    ratio = uniform(-150.0, 150.0)
    return 10.0**ratio, 10.0**-ratio * uniform(1.0, 10.0), uniform(0.1, 10.0), uniform(0.1, 10.0)


def small_integers(uniform: Uniform) -> Parameters:
    """Many of these have rational frequencies, where resonance and antiresonance are doubles."""
    m1, m2, k1, k2 = (float(round(uniform(1.0, 6.0))) for _ in range(4))
    return m1, m2, k1, k2


FAMILIES = {
    "moderate": moderate,
    "1e+-8": eight_decades,
    "1e+-150": half_the_range,
    "all doubles": all_doubles,
    "tuned weak coupling": tuned_weak_coupling,
    "k2 to 0": coupling_to_zero,
    "k2 to infinity": coupling_to_infinity,
    "k1 = 0": no_wall,
    "k2 = 0": no_coupling,
    "k1 = k2 = 0": no_springs,
    "mass ratios to 1e+-300": mass_ratios,
    "small integers": small_integers,
}


@st.composite
def drawn(draw, family):
    """The strategy of a family."""
    return family(lambda low, high: draw(st.floats(low, high)))

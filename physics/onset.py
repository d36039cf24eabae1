"""The onset of the driven chain's motion from rest, while no phase has passed 9/8 rad (lecture D34, slides 6 to 8).

    m1 x1'' = -k1 x1 - k2 (x1 - x2) + F_0 sin(omega t),   m2 x2'' = k2 (x1 - x2)

Mass 1 starts like t^3 and mass 2, which only the spring drives, like t^5: there the modes all but cancel in it. So the
motion is a power series in t, whose coefficients follow from the equations one after the other. All that is added up
in one of them has one sign, and the series alternates; the first term, with two doubles, is most of it.
"""

import math
from decimal import Decimal

import numpy as np

from physics.coupled import TwoMassChain
from physics.precision.exact import Array, binary, exact, pair_product, precise, shifted, two_product

EARLY = 1.125  # rad
_TERMS = 10  # number of terms; the next one is below 1e-18 of the first
_RATES = np.arange(5.0, 2.0 * _TERMS + 7.0, 2.0)  # powers of t that follow the first


def onset(chain: TwoMassChain, F_0: float, omega: float, t: Array) -> Array:
    """Return the driven motion from rest, each value within 1.5 u.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N, not 0.
    omega : float
        The frequency of the drive in rad/s, above 0.
    t : ndarray (n,)
        Times in s, at which no phase passes EARLY.

    Returns
    -------
    ndarray (5, n)
        x1, x2 and x2 - x1 in m, v1 and v2 in m/s; inf beyond the range of doubles.
    """
    if not t.any():
        return np.zeros((5, t.size))
    exponent = math.frexp(float(np.abs(t).max()))[1]
    with precise():
        first, ratios = _series(chain, F_0, omega, Decimal(2) ** exponent)
    leading, leading_rest, exponents = (np.array(c)[:, np.newaxis] for c in zip(*map(binary, first), strict=True))
    time = np.ldexp(t, -exponent)
    second = two_product(time, time)
    third, fourth = pair_product(second, (time, 0.0)), pair_product(second, second)
    hi, lo = np.array([third, pair_product(fourth, (time, 0.0)), third, second, fourth]).swapaxes(0, 1)
    powers = np.multiply.accumulate(np.full((_TERMS, t.size), second[0]))
    values, rest = pair_product((leading, leading_rest), (hi, lo))
    with np.errstate(over="ignore"):
        return shifted(values + (rest + values * (ratios @ powers)), exponents)


def _series(chain: TwoMassChain, F_0: float, omega: float, unit: Decimal) -> tuple[list[Decimal], Array]:
    """First coefficients of x1, x2, x2 - x1, v1, v2 in that unit of time, and the following ones over them (5, terms).

    x1 = sum_k a_k t^(2k+1) from k = 1, x2 = sum_k b_k t^(2k+1) from k = 2.
    """
    m1, m2, k1, k2 = chain.exact_parameters
    square, drive = unit * unit, exact(omega)
    turn, stiff, link1, link2 = drive * drive * square, (k1 + k2) * square / m1, k2 * square / m1, k2 * square / m2
    push = exact(F_0) * drive * square * unit / m1
    a, b = [push / 6], [Decimal(0)]
    for k in range(1, _TERMS + 2):
        push = -push * turn / (2 * k * (2 * k + 1))
        between = (2 * k + 2) * (2 * k + 3)
        a_next = (push - stiff * a[-1] + link1 * b[-1]) / between
        b.append(link2 * (a[-1] - b[-1]) / between)
        a.append(a_next)
    over_a, over_b = 1 / a[0], 1 / b[1] if b[1] else Decimal(0)
    own = np.array([float(value * over_a) for value in a[1 : _TERMS + 1]])
    driven = np.array([float(value * over_b) for value in b[1 : _TERMS + 2]])
    ratios = np.empty((5, _TERMS))
    ratios[:] = own, driven[1:], own - float(b[1] * over_a) * driven[:-1], own * _RATES[:-1], driven[1:] * _RATES[1:]
    ratios[3:] /= [[3.0], [5.0]]
    return [a[0], b[1], -a[0], 3 * a[0] / unit, 5 * b[1] / unit], ratios

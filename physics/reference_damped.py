"""One damped oscillator, left alone and driven, in arbitrary precision, to measure others by; independent of
physics.exact and of physics.damped.

Sums of the exponentials of the roots of m s^2 + c s + k, with digits to burn. Points are asked for at a few times (s)
or ratios of frequencies.
"""

from collections.abc import Sequence
from typing import Any

from physics.damped import DampedOscillator
from physics.reference import Point, point

BITS = 6000

Points = dict[str, list[Point]]


def damped_points(oscillator: DampedOscillator, x_0: float, v_0: float, t: Sequence[float]) -> Points:
    """x, the energies V and E = T + V, and the power P lost, each with the size that both parts give it."""
    import mpmath as mp

    with mp.workprec(BITS):
        m, c, k, x, v = (mp.mpf(value) for value in (oscillator.m, oscillator.c, oscillator.k, x_0, v_0))
        points: Points = {"x": [], "V": [], "E": [], "P": []}
        for time in map(mp.mpf, t):
            x_now, x_size = free_part(mp, m, c, k, x, v, time)
            v_now, v_size = free_part(mp, m, c, k, v, -(c * v + k * x) / m, time)
            points["x"].append(point(x_now, x_size))
            V, V_size = k * x_now**2 / 2, k * x_size**2 / 2
            points["V"].append(point(V, V_size))
            points["E"].append(point(V + m * v_now**2 / 2, V_size + m * v_size**2 / 2))
            points["P"].append(point(c * v_now**2, c * v_size**2))
        return points


def free_part(mp: Any, m: Any, c: Any, k: Any, start: Any, rate: Any, t: Any) -> tuple[Any, Any]:
    """Anything that obeys m x'' + c x' + k x = 0, and its size: that of both exponentials, or of start and slope where
    they have not parted."""
    root = mp.sqrt(c * c - 4 * m * k)
    p, q = (-c + root) / (2 * m), (-c - root) / (2 * m)
    slope = abs(start) + abs(rate - mp.re(p) * start) * t
    if p == q:
        return mp.exp(p * t) * (start + (rate - p * start) * t), mp.exp(p * t) * slope
    A, B = (rate - q * start) / (p - q), (p * start - rate) / (p - q)
    value = mp.re(A * mp.exp(p * t) + B * mp.exp(q * t))
    apart = abs(A) * mp.exp(mp.re(p) * t) + abs(B) * mp.exp(mp.re(q) * t)
    return value, min(apart, mp.exp(mp.re(p) * t) * slope) if abs(p - q) * t < 1 else apart

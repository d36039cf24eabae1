r"""A chain of equal masses in arbitrary precision, to measure others by; independent of the modes of physics.chain.

On an endless chain with Omega = sqrt(k/m), one mass displaced by 1 moves mass n places away by J_2n(2 Omega t)
(Schroedinger 1914), and a velocity of 1 moves it by the integral of that,

    int_0^t J_2n(2 Omega s) ds = (J_(2n+1) + J_(2n+3) + ...)(2 Omega t)/Omega,

so a chain of N masses is the endless one whose initial state is continued with mirror images: turned over at a wall,
upright at a free end. Bessel functions come from Miller's backward recurrence.
"""

from collections.abc import Callable, Sequence
from math import ceil
from typing import Any

import numpy as np

from physics.chain import UniformChain
from physics.precision.exact import Array
from physics.reference.driven_chain import Point, point

DIGITS = 60
LONGEST = 20_000.0
"""Largest 2 Omega t: the recurrence has that many terms."""


def chain_points(
    chain: UniformChain, x_0: Array, v_0: Array, t: Sequence[float], masses: Sequence[int]
) -> dict[int, list[Point]]:
    """Return the displacements of a few masses; sizes are the amplitudes of the modes and the drift.

    ValueError if a time is so long that too many terms are needed.

    Parameters
    ----------
    chain, x_0, v_0
        The chain, its displacements in m and velocities in m/s at t = 0, each (N,).
    t, masses : sequences of float and of int
        A few times in s, and masses counted from 1.

    Returns
    -------
    dict of lists of Point
        x in m of each mass.
    """
    import mpmath as mp

    modes = chain.drawn_modes(np.asarray(x_0), np.asarray(v_0))
    amplitudes = (modes.amplitude @ abs(chain.shapes)).tolist()
    points: dict[int, list[Point]] = {p: [] for p in masses}
    with mp.workdps(DIGITS):
        Omega = mp.sqrt(mp.mpf(chain.k) / mp.mpf(chain.m))
        x, v = (_continued(chain, values) for values in (x_0, v_0))
        for time in t:
            z = 2 * Omega * mp.mpf(time)
            if z > LONGEST:
                raise ValueError(f"at most t = {float(LONGEST / 2 / Omega):.3g} s is possible")
            bessel = _bessel(mp, z)
            tails = _tails(bessel)
            drift = abs(modes.drift[0]) + abs(mp.mpf(modes.drift[1]) * time)
            for p in masses:
                far = range(-len(tails) + 1, len(tails))
                moved = mp.fdot((x(p + n), bessel[2 * abs(n)]) for n in far)
                moved += mp.fdot((v(p + n), tails[abs(n)]) for n in far) / Omega
                points[p].append(point(moved, amplitudes[p - 1] + drift))
    return points


def chain_frequencies(chain: UniformChain, modes: Sequence[int]) -> list[Point]:
    """Return the frequencies in rad/s of `modes` of a `chain`, counted from 1, by omega^2 = (k/m) (2 - 2 cos theta)."""
    import mpmath as mp

    N, ends = chain.N, chain.ends
    with mp.workdps(DIGITS):
        found = []
        for j in modes:
            parts = {"fixed-fixed": (j, N + 1), "fixed-free": (2 * j - 1, 2 * N + 1), "free-free": (j - 1, N)}[ends]
            curvature = 2 - 2 * mp.cospi(mp.mpf(parts[0]) / parts[1])
            omega = mp.sqrt(mp.mpf(chain.k) / mp.mpf(chain.m) * curvature)
            found.append(point(omega, omega))
    return found


def _continued(chain: UniformChain, values: Array) -> Callable[[int], float]:
    """Return the values at all masses 1 .. N of a chain, continued by images to every whole number."""
    own = values.tolist()
    back = own[::-1]
    if chain.ends == "free-free":
        period = [*own, *back]
    elif chain.ends == "fixed-fixed":
        period = [*own, 0.0, *(-one for one in back), 0.0]
    else:
        period = [*own, *back, 0.0, *(-one for one in own), *(-one for one in back), 0.0]
    return lambda p: period[(p - 1) % len(period)]


def _bessel(mp: Any, z: Any) -> list[Any]:
    """J_0(z), J_1(z), ... as far as they matter, by Miller's recurrence."""
    if not z:
        return [mp.mpf(1), mp.mpf(0), mp.mpf(0)]
    last = 2 * ceil((float(z) + 30 * float(z) ** (1 / 3)) / 2) + 2 * DIGITS
    terms = [mp.mpf(0)] * (last + 2)
    terms[last] = mp.mpf(1)
    for n in range(last, 0, -1):
        terms[n - 1] = 2 * n / z * terms[n] - terms[n + 1]
    total = terms[0] + 2 * mp.fsum(terms[2::2])
    return [one / total for one in terms]


def _tails(bessel: list[Any]) -> list[Any]:
    """J_(2n+1) + J_(2n+3) + ... for n = 0, 1, ..."""
    found, total = [], bessel[0] * 0
    for odd in bessel[len(bessel) - 1 - len(bessel) % 2 :: -2]:
        total += odd
        found.append(total)
    return found[::-1]

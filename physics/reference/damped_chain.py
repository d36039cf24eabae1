"""The driven chain with dashpots in arbitrary precision, independent of physics.transient.

The state (x1, x2, v1, v2) less the particular solution follows y' = A y: its exponential is summed as a power series.
For the equations and their source see physics.damped_chain.
"""

import math
from collections.abc import Sequence
from typing import Any

from physics.coupled import TwoMassChain
from physics.reference.driven_chain import Point, point
from physics.transient import DampedModes

DIGITS = 60
_REAL = 1e-50
"""The remaining imaginary part of a real exponent, over its modulus."""


def braked_points(modes: DampedModes, t: Sequence[float]) -> dict[str, list[Point]]:
    """Return x1 and x2 in m of the motion of `modes` at the times t in s; sizes are the largest parts up to then."""
    import mpmath as mp

    points: dict[str, list[Point]] = {"x1": [], "x2": []}
    with mp.workdps(DIGITS):
        A, X = _matrix(mp, modes), _steady(mp, modes, modes.omega)
        w = mp.mpf(modes.omega)
        start = mp.matrix([*map(mp.mpf, (*modes.x_0, *modes.v_0))])
        rest = start - mp.matrix([*(one.imag for one in X), *(w * one.real for one in X)])
        for time in map(mp.mpf, t):
            now, turn = mp.expm(A * time) * rest, mp.expj(w * time)
            for i, found in enumerate(points.values()):
                found.append(point(now[i] + (X[i] * turn).imag, abs(X[i]) + mp.norm(rest[:2]) + abs(now[i])))
    return points


def braked_swings(modes: DampedModes, omega: Sequence[float]) -> dict[str, list[Point]]:
    """Return |Xp1| and |Xp2| in m, steady amplitudes of the chain of `modes`, at drive frequencies `omega` in rad/s."""
    import mpmath as mp

    with mp.workdps(DIGITS):
        pairs = [_steady(mp, modes, w) for w in omega]
        return {f"Xp{i + 1}": [point(abs(pair[i]), abs(pair[i])) for pair in pairs] for i in (0, 1)}


def braked_lags(modes: DampedModes, omega: Sequence[float]) -> dict[str, list[Point]]:
    """Return the lags of both masses of `modes` behind the force in rad, at drive frequencies `omega` in rad/s.

    That of mass 1 is from 0 to pi, that of mass 2 as much more. Sizes are one radian.
    """
    import mpmath as mp

    with mp.workdps(DIGITS):
        pairs = [_steady(mp, modes, w) for w in omega]
        first = [abs(mp.arg(one)) for one, _ in pairs]
        behind = [abs(mp.arg(two / one)) if one else mp.mpf(0) for one, two in pairs]
        both = [one + more for one, more in zip(first, behind, strict=True)]
        return {"phi1": [point(lag, 1) for lag in first], "phi2": [point(lag, 1) for lag in both]}


def braked_exponents(chain: TwoMassChain, c1: float, c2: float) -> list[tuple[Point, Point]]:
    """Return the exponents of the free motion as eigenvalues.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    c1, c2 : float
        The damping parallel to springs 1 and 2 in N s/m.

    Returns
    -------
    list of tuples of two Points
        Real and imaginary part in 1/s of each exponent with Im >= 0; sizes are its modulus.
    """
    import mpmath as mp

    modes = DampedModes(chain=chain, c=c2, c1=c1, F_0=0.0, omega=0.0)
    sizes = [math.log10(one) for one in (chain.m1, chain.m2, chain.k1, chain.k2, c1, c2) if one]
    digits = 2 * DIGITS + 8 * math.ceil(max(sizes) - min(sizes))  # eigenvalues are relative to the largest
    with mp.workdps(digits):
        found = mp.eig(_matrix(mp, modes), right=False)
        least = mp.mpf(10) ** (DIGITS - digits) * max(map(abs, found))
        found = [mp.mpc(0) if abs(one) < least else one for one in found]
        upper = [one for one in found if mp.im(one) > -_REAL * abs(one) or not one]
        parts = [(mp.re(one), mp.im(one) if mp.im(one) > _REAL * abs(one) else mp.mpf(0), abs(one)) for one in upper]
        return [(point(re, size), point(im, size)) for re, im, size in parts]


def _matrix(mp: Any, modes: DampedModes) -> Any:
    chain = modes.chain
    m1, m2, k1, k2, c1, c2 = map(mp.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, modes.c1, modes.c))
    return mp.matrix(
        [
            [0, 0, 1, 0],
            [0, 0, 0, 1],
            [-(k1 + k2) / m1, k2 / m1, -(c1 + c2) / m1, c2 / m1],
            [k2 / m2, -k2 / m2, c2 / m2, -c2 / m2],
        ]
    )


def _steady(mp: Any, modes: DampedModes, omega: float) -> tuple[Any, Any]:
    """X of x_p = Im(X exp(i omega t)), from Newton's laws as two linear equations; 0 where nothing pushes."""
    chain, w = modes.chain, mp.mpf(omega)
    m1, m2, k1, k2, c1, c2, F = map(mp.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, modes.c1, modes.c, modes.F_0))
    link = mp.mpc(k2, c2 * w)
    first, second = mp.mpc(k1, c1 * w) + link - m1 * w**2, link - m2 * w**2
    below = first * second - link**2
    return (second * F / below, link * F / below) if F and below else (mp.mpc(0), mp.mpc(0))

"""Steady motions under a push that repeats, in numbers of mpmath."""

from __future__ import annotations

from typing import Any

import mpmath as mp

from physics.pushed import PushedMass


def divided(f: Any, nodes: list[Any], hair: Any) -> Any:
    """Return the divided difference of f over nodes; equal nodes are separated slightly."""
    apart: list[Any] = []
    for z in nodes:
        while any(abs(z - other) < hair / 2 for other in apart):
            z += hair
        apart.append(z)
    return mp.fsum(f(z) / mp.fprod(z - other for other in apart if other is not z) for z in apart)


def closed_form(mass: PushedMass, share: Any) -> tuple[Any, Any]:
    """x and v of the steady motion by one divided difference for each kind of push."""
    m, c, k, F = (mp.mpf(one) for one in (mass.m, mass.c, mass.k, mass.push.size))
    T, w = 2 * mp.pi / mp.mpf(mass.push.omega), mp.mpf(mass.push.width)
    root = mp.sqrt(mp.mpc(c * c - 4 * m * k))
    p, hair = [(-c + root) / (2 * m), (-c - root) / (2 * m)], mp.mpf(10) ** (-mp.mp.dps // 5) / T
    zero = mp.mpc(0)

    def exp(z: Any) -> Any:
        return mp.exp(z) if mp.re(z) > -1e4 else zero

    def both(f: Any, zeros: int, factor: Any) -> tuple[Any, Any]:
        x, v = (mp.re(divided(f, [zero] * n + p, hair)) for n in (zeros, zeros - 1))
        return factor * x, factor * v

    t, kind = share * T, mass.push.kind
    if kind in ("square", "triangle"):
        t, sign = (t, 1) if kind == "square" else (t + T / 4, 1)
        while t >= T / 2:
            t, sign = t - T / 2, -sign
        zeros, factor = (1, 2 * F / m) if kind == "square" else (2, 8 * F / (m * T))
        return both(lambda z: exp(z * t) / (1 + exp(z * T / 2)), zeros, sign * factor)
    if kind == "pulses":
        if share < w:
            over = both(lambda z: (exp(z * t) - exp(z * (t + T - w * T))) / (1 - exp(z * T)) if z else 1 - w, 1, F / m)
        else:
            over = both(lambda z: (exp(z * t) - exp(z * (t - w * T))) / (1 - exp(z * T)) if z else -w, 1, F / m)
        return over[0] + F * w / k, over[1]
    at = [mp.re(divided(lambda z, n=n: z**n * exp(z * t) / (1 - exp(z * T)), p, hair)) for n in (0, 1)]
    return F / m * at[0], F / m * at[1]

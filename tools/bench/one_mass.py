"""Worst errors of the physics of one damped mass, family by family, compared with a textbook's formulas in float64.

`python -m tools.bench.accuracy_table` prints it after the chain's: the slower root and |X| in ulp, motions
free and driven in u = 2^-53 of what both parts together could be.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from decimal import Decimal
from random import Random

import mpmath as mp
import numpy as np

from physics.damped import DampedOscillator
from physics.driven import DrivenOscillator
from physics.periodic import PeriodicPush, PushKind
from physics.reference.damped import damped_points, driven_points
from physics.reference.pushed import pushed_points
from physics.steady_motions import SteadyMotion
from tests.physics.truth import U, ulps

Uniform = Callable[[float, float], float]
FAMILIES: dict[str, Callable[[Random], tuple[float, float]]] = {
    "zeta from 0 to 2": lambda random: (random.uniform(0, 2), random.uniform(0.1, 3)),
    "zeta 1 +- 1e-16 to 1e-2": lambda random: (1 + _near(random, 16, 2), random.uniform(0.1, 3)),
    "zeta from 1e-12, at resonance": lambda random: (10 ** random.uniform(-12, -1), 1 + _near(random, 17, 2)),
    "no dashpot, at resonance": lambda random: (0.0, 1 + _near(random, 16, 2)),
    "zeta to 1e12": lambda random: (10 ** random.uniform(0, 12), 10 ** random.uniform(-3, 3)),
}
QUANTITIES = ("slower root, ulp", "size of the swing, ulp", "free motion, u", "driven motion, u")
DIED_OUT = 1e-250
"""Relative to the initial amplitude: a motion below this counts as zero."""
METHODS = ("this project", "textbook, float64")


def _near(random: Random, most: float, least: float) -> float:
    return random.choice([1, -1]) * 10 ** random.uniform(-most, -least)


def table(samples: int, seed: int) -> str:
    """The worst errors as a table in Markdown."""
    lines = ["", f"# Accuracy of one damped mass\n\n{samples} of each family, seed {seed}.", ""]
    lines += ["| family | method | " + " | ".join(QUANTITIES) + " |", "|---" * (len(QUANTITIES) + 2) + "|"]
    for family, draw in FAMILIES.items():
        random = Random(seed)
        worst = {method: dict.fromkeys(QUANTITIES, 0.0) for method in METHODS}
        for _ in range(samples):
            for method, quantity, error in measured(*draw(random), random):
                worst[method][quantity] = max(worst[method][quantity], error)
        for method, found in worst.items():
            lines.append(f"| {family} | {method} | " + " | ".join(map(shown, found.values())) + " |")
    return "\n".join(lines) + "\n"


def push_table(samples: int, seed: int) -> str:
    """Return a table of the worst errors of x under a push, in u of the largest x: steady and from rest."""
    lines = [
        "",
        f"# Accuracy under a push\n\n{samples} of each kind, seed {seed}, u of the largest x.",
        "",
    ]
    lines += ["| push | steady, in a file, u | steady, drawn, u | from rest, in a file, u |", "|---|---|---|---|"]
    kinds: tuple[PushKind, ...] = ("square", "triangle", "pulses", "impulses", "step", "impulse")
    for kind in kinds:
        random = Random(seed)
        errors = np.array([push_errors(kind, random) for _ in range(samples)])
        lines.append(f"| {kind} | " + " | ".join(map(shown, errors.max(axis=0))) + " |")
    return "\n".join(lines) + "\n"


def push_errors(kind: PushKind, random: Random) -> tuple[float, float, float]:
    """The errors of one oscillator, m = k = 1, ten times slower to ten times quicker than its push."""
    push = PeriodicPush(kind=kind, omega=10 ** random.uniform(-1, 1), width=random.uniform(0.05, 0.95))
    one = DampedOscillator(m=1.0, c=2 * 10 ** random.uniform(-6, 0.5), k=1.0)
    t = random.uniform(0, 2 * math.pi / push.omega)
    return *(steady_errors(one, push, t) if not push.once else (0.0, 0.0)), from_rest_error(one, push, 7 * t)


def steady_errors(one: DampedOscillator, push: PeriodicPush, t: float) -> tuple[float, float]:
    motion = SteadyMotion(oscillator=one, push=push)
    found = one.steady(push, [t]).x[0], motion.at(np.array([t]))[0][0]
    with mp.workdps(250):
        true = closed_form(motion.mass, mp.mpf(t) * mp.mpf(push.omega) / (2 * mp.pi))[0]
        in_file, drawn = (float(abs(mp.mpf(float(x)) - true) / U / motion.size) for x in found)
    return in_file, drawn


def from_rest_error(one: DampedOscillator, push: PeriodicPush, t: float) -> float:
    found = one.pushed(push).from_rest(np.linspace(0.0, t, 100)).x
    (true,) = pushed_points(one, push, 0.0, 0.0, float(np.abs(found).max()), [t])["x"]
    return float(abs(Decimal(float(found[-1])) - true.value) / true.size / Decimal(U))


def shown(error: float) -> str:
    """An error with two digits behind the point, a large one by its power of ten."""
    return "no digit" if not error < 2.0**53 else f"{error:.2f}" if error < 100 else f"{error:.0e}"


def measured(zeta: float, r: float, random: Random) -> Iterator[tuple[str, str, float]]:
    """The errors of one oscillator, m = k = 1, with the drive at r."""
    c, x_0, v_0, t = 2 * zeta, random.uniform(-1, 1), random.uniform(-1, 1), 10 ** random.uniform(-3, 3)
    one = DrivenOscillator(m=1.0, c=c, k=1.0)
    free = DampedOscillator(m=1.0, c=c, k=1.0)
    at = damped_points(free, x_0, v_0, [t])["x"][0]
    driven_at = driven_points(one, r, 1.0, "force", x_0, v_0, [t])["x"][0]
    with mp.workdps(60):
        C, w = mp.mpf(c), mp.mpf(r)
        root = mp.re((C - mp.sqrt(C * C - 4)) / 2)
        X = 1 / mp.mpc(1 - w * w, C * w)
        motions = free.motion(x_0, v_0, [t]).x[0], one.motion(r, 1.0, x_0, v_0, [t]).x[0]
        ours = free.rates[0], abs(one.response(r)), *motions
        for method, found in zip(METHODS, (ours, textbook(c, r, x_0, v_0, t)), strict=True):
            yield method, QUANTITIES[0], ulps(found[0], root) if root else 0.0
            yield method, QUANTITIES[1], ulps(found[1], abs(X)) if math.isfinite(found[1]) else math.inf
            for quantity, value, point in zip(QUANTITIES[2:], found[2:], (at, driven_at), strict=True):
                if point.size < DIED_OUT:
                    continue
                size = mp.mpf(str(point.size)) * U
                yield method, quantity, float(abs(mp.mpf(float(value)) - mp.mpf(str(point.value))) / size)


def textbook(c: float, r: float, x_0: float, v_0: float, t: float) -> tuple[float, float, float, float]:
    """Return the slower root, |X|, free and driven motion by the formulas of a textbook, unchanged."""
    try:
        with np.errstate(all="ignore"):
            root = cmath.sqrt(c * c - 4)
            p, q = (-c + root) / 2, (-c - root) / 2
            X = 1 / complex(1 - r * r, c * r)

            def free(x: float, v: float) -> float:
                return float((((v - q * x) * cmath.exp(p * t) - (v - p * x) * cmath.exp(q * t)) / (p - q)).real)

            moved = free(x_0 - X.imag, v_0 - r * X.real) + (X * cmath.exp(1j * r * t)).imag
            return -p.real, abs(X), free(x_0, v_0), moved
    except (ZeroDivisionError, OverflowError):
        return math.inf, math.inf, math.inf, math.inf


def divided(f, nodes, hair):
    """Return the divided difference of f over nodes; equal nodes are separated slightly."""
    apart = []
    for z in nodes:
        while any(abs(z - other) < hair / 2 for other in apart):
            z += hair
        apart.append(z)
    return mp.fsum(f(z) / mp.fprod(z - other for other in apart if other is not z) for z in apart)


def closed_form(mass, share):
    """x and v of the steady motion under a push that repeats, by one divided difference for each kind of push."""
    m, c, k, F = (mp.mpf(one) for one in (mass.m, mass.c, mass.k, mass.push.size))
    T, w = 2 * mp.pi / mp.mpf(mass.push.omega), mp.mpf(mass.push.width)
    root = mp.sqrt(mp.mpc(c * c - 4 * m * k))
    p, hair = [(-c + root) / (2 * m), (-c - root) / (2 * m)], mp.mpf(10) ** (-mp.mp.dps // 5) / T
    zero = mp.mpc(0)

    def exp(z):
        return mp.exp(z) if mp.re(z) > -1e4 else zero

    def both(f, zeros, factor):
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

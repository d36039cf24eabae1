"""Worst errors of the physics of the chain with dashpots, family by family, compared with plain float64.

`python -m tools.bench.accuracy_table` prints it last: |Xp1| in ulp, the driven motion from any start in u = 2^-53 of
what its parts together could be, X of a Bode plot in u of its size, lags in u of a radian, roots in u of their modulus;
plain float64 is eigvals and solve of numpy.linalg, and scipy.linalg.expm.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from random import Random

import mpmath as mp
import numpy as np
from scipy.linalg import expm

from physics.absorber import damped_amplitude
from physics.bode_curves import bode_curves
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.reference.damped_chain import braked_exponents, braked_lags, braked_points, braked_swings
from physics.transient import DampedModes
from tests.physics.truth import U, ulps
from tools.bench.one_mass import shown

QUANTITIES = ("size of the swing, ulp", "driven motion, u", "curves of a Bode plot, u", "lags, u", "roots, u")
METHODS = ("this project", "float64")
BrakedCase = tuple[TwoMassChain, float, float, float]
"""A chain, c1, c2, and the drive."""


def _any(random: Random, least: float, most: float) -> float:
    return 10 ** random.uniform(least, most)


def _chain(random: Random) -> TwoMassChain:
    m1, m2, k1, k2 = (_any(random, -1, 1) for _ in range(4))
    return TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)


def _light(random: Random) -> BrakedCase:
    chain = _chain(random)
    return chain, _any(random, -12, -2), _any(random, -12, -2), float(chain.modes().omega[random.randrange(2)])


def _twin(random: Random) -> BrakedCase:
    near = 1 + _any(random, -16, -4)
    return TwoMassChain(m1=400, m2=225, k1=625, k2=144), 0.0, 216.0 * near, _any(random, -1, 1)


FAMILIES: dict[str, Callable[[Random], BrakedCase]] = {
    "moderate": lambda random: (_chain(random), _any(random, -2, 1), _any(random, -2, 1), _any(random, -1, 1)),
    "from 1e-12, at resonance": _light,
    "from 1e-12 to 1e12": lambda random: (
        _chain(random), _any(random, -12, 12), _any(random, -12, 12), _any(random, -1, 1)
    ),
    "next to two equal pairs of exponents": _twin,
}  # fmt: skip


def table(samples: int, seed: int) -> str:
    """The worst errors as a table in Markdown."""
    lines = ["", f"# Accuracy of the chain with dashpots\n\n{samples} of each family, seed {seed}.", ""]
    lines += ["| family | method | " + " | ".join(QUANTITIES) + " |", "|---" * (len(QUANTITIES) + 2) + "|"]
    for family, draw in FAMILIES.items():
        random = Random(seed)
        worst = {method: dict.fromkeys(QUANTITIES, 0.0) for method in METHODS}
        for _ in range(samples):
            for method, quantity, error in measured(draw(random), random):
                worst[method][quantity] = max(worst[method][quantity], error)
        for method, found in worst.items():
            lines.append(f"| {family} | {method} | " + " | ".join(map(shown, found.values())) + " |")
    return "\n".join(lines) + "\n"


def measured(case: BrakedCase, random: Random) -> Iterator[tuple[str, str, float]]:
    """The errors of one chain from a start."""
    chain, c1, c2, omega = case
    start = tuple(random.uniform(-1, 1) for _ in range(4))
    t = _any(random, -2, 2) / float(chain.modes().omega[1])
    modes = DampedModes(chain=chain, c=c2, c1=c1, F_0=1.0, omega=omega, x_0=start[:2], v_0=start[2:])
    swing = braked_swings(modes, [omega])["Xp1"][0]
    points = [found[0] for found in braked_points(modes, [t]).values()]
    curves = bode_curves(DampedChain.of(chain, c1, c2), [omega])
    lags = [one[0] for one in braked_lags(modes, [omega]).values()]
    with mp.workdps(60):
        roots = [mp.mpc(str(re.value), str(im.value)) for re, im in braked_exponents(chain, c1, c2)]
    exact = float(damped_amplitude(chain, c2, 1.0, omega, c1)[0])
    ours = exact, modes.motion([t]).x[:, 0].tolist(), abs(complex(curves.X[0, 0])), curves.lags[:, 0].tolist()
    poles = DampedChain.of(chain, c1, c2).roots.tolist()
    for method, (X, x, curve, phi, found) in zip(METHODS, ((*ours, poles), plain(modes, t)), strict=True):
        with mp.workdps(60):
            yield method, QUANTITIES[0], ulps(X, mp.mpf(str(swing.value))) if math.isfinite(X) else math.inf
            for value, point in zip(x, points, strict=True):
                off = abs(mp.mpf(value) - mp.mpf(str(point.value))) if math.isfinite(value) else mp.inf
                yield method, QUANTITIES[1], float(off / (mp.mpf(str(point.size)) * U))
            size = mp.mpf(str(swing.value))
            yield method, QUANTITIES[2], float(abs(mp.mpf(curve) - size) / (size * U))
            for value, point in zip(phi, lags, strict=True):
                yield method, QUANTITIES[3], float(abs(mp.mpf(value) - mp.mpf(str(point.value))) / U)
            for s in roots:
                yield method, QUANTITIES[4], float(min(abs(one - s) for one in found) / abs(s) / U)


def plain(modes: DampedModes, t: float) -> tuple[float, list[float], float, list[float], list[complex]]:
    """|Xp1|, x1 and x2 at a time, |Xp1| again, the lags and the roots, by the solvers of NumPy and SciPy."""
    chain, w = modes.chain, modes.omega
    M, K = np.diag([chain.m1, chain.m2]), np.array([[chain.k1 + chain.k2, -chain.k2], [-chain.k2, chain.k2]])
    C = np.array([[modes.c1 + modes.c, -modes.c], [-modes.c, modes.c]])
    X = np.linalg.solve(K + 1j * w * C - w * w * M, [1.0, 0.0])
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    rest = np.array([*modes.x_0, *modes.v_0]) - [*X.imag, *(w * X.real)]
    moved = (expm(A * t) @ rest)[:2] + (X * np.exp(1j * w * t)).imag
    lags = (-np.angle(X) % (2 * math.pi)).tolist()
    return float(abs(X[0])), moved.tolist(), float(abs(X[0])), lags, np.linalg.eigvals(A).tolist()

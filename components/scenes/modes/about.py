"""'About these numbers' of the four ways to find the modes."""

from __future__ import annotations

import math
from dataclasses import replace

from components.chain.about import FREQUENCY, MASSES, free_drift, modes_table, motion_rows
from components.chain.parameters import Pair
from components.quantities.declared import by_name
from components.quantities.formatting import ten
from components.scene import Picture
from components.scene.about import About, CheckedPoint, Place, bounded, few_of, rows
from components.scenes.modes.determinant import Curves as C
from components.scenes.modes.sweep import Sweep
from physics.coupled import TwoMassChain, free_modes
from physics.damped_chain import DampedChain
from physics.modes import determinant_curve
from physics.reference.damped_chain import braked_exponents
from physics.reference.driven_chain import Point, determinants, modes_of


def guess_about(picture: Picture, chain: TwoMassChain) -> About:
    """Errors of the crossings and of the curve of the determinant."""
    columns = picture.sources[C.D.source]
    exponent = determinant_curve(chain, columns["w"])[1]
    D = [value.scaleb(-exponent) for value in determinants(chain, few_of(columns["w"]))]
    name = f"$D$ / {ten(exponent)}" if exponent else "$D$"
    found = rows({C.D: name}, columns, by_name({C.D: [Point(value, abs(value)) for value in D]}), FREQUENCY)
    return About((modes_table(chain), bounded("$D$, next to its zeros too,", 32, "its own value", found)))


def solve_about(chain: TwoMassChain) -> About:
    return About((modes_table(chain),))


def braked_about(chain: TwoMassChain, damping: Pair) -> About:
    """Errors of the exponents of all motions, without exponents that are 0."""
    true = braked_exponents(chain, *damping)
    found: list[CheckedPoint] = []
    for s in (s for one in DampedChain.of(chain, *damping).free_motions.modes for s in one.exponents if s):
        near = min(true, key=lambda pair: math.hypot(float(pair[0].value) - s.real, float(pair[1].value) - s.imag))
        for part, value, point in zip(("Re", "Im"), (s.real, s.imag), near, strict=True):
            found.append(CheckedPoint(f"{part} $s$", f"Root {len(found) // 2 + 1}", value, point))
    return About((bounded("an exponent", 1, "its modulus", found),))


def sweep_about(picture: Picture, chain: TwoMassChain, swept: str) -> About:
    """Errors of the frequencies at three points of the sweep."""
    columns = picture.sources["omega_sweep"]
    chains = [replace(chain, **{swept: value}) for value in few_of(columns["p"])]
    pairs = zip(*([Point(omega, omega) for omega, _ in modes_of(each)] for each in chains), strict=True)
    names = {Sweep.omega["slow"]: r"$\omega_-$", Sweep.omega["fast"]: r"$\omega_+$"}
    place = Place("p", f"${swept[0]}_{swept[1]}$", {"m": "kg", "k": "N/m"}[swept[0]])
    found = rows(names, columns, by_name(dict(zip(names, pairs, strict=True))), place)
    return About((modes_table(chain), bounded("the curves of the frequencies", 8, "their own value", found)))


def hunt_about(picture: Picture, chain: TwoMassChain, x_0: Pair) -> About:
    """Errors of points of the path, and of the modes if the answer is shown."""
    path, rest = picture.sources["path"], (0.0, 0.0)
    points = bounded("the path", 2, "its amplitudes", motion_rows(MASSES, path, chain, x_0, rest))
    tables = (points, modes_table(chain)) if "answer" in picture.sources else (points,)
    return About(tables, free_drift(free_modes(chain, x_0, rest), path["t"]))

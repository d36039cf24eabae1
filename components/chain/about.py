"""'About these numbers' for any two-mass chain: the errors of its motion, its modes and its energy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import fsum

import numpy as np
from numpy.typing import NDArray

from components.chain.modes import BOTH, MODES
from components.chain.parameters import Pair
from components.scene.about import CheckedPoint, Place, Table, drift, few_of, points
from components.scene.traces import Columns
from physics.coupled import FreeModes, TwoMassChain
from physics.energy import chain_energy
from physics.integrators.problem import Problem
from physics.precision.exact import precise
from physics.reference.driven_chain import Point, modal_points, modes_of

MASSES = {f"x{i}": f"$x_{i}$" for i in BOTH}
DRIVE, FREQUENCY = (Place(column, r"$\omega$", "rad/s") for column in ("omega", "w"))
ROUNDED_ONCE = 0.51


def motion_rows(
    names: Mapping[str, str],
    columns: Columns,
    chain: TwoMassChain,
    x_0: Pair,
    v_0: Pair,
    F_0: float = 0.0,
    omega: float = 0.0,
) -> list[CheckedPoint]:
    """Errors of x1 and x2 and of their parts by mode, if these are drawn."""
    t = np.array(few_of(columns["t"]))
    return modal_rows(names, columns, modal_points(Problem(chain=chain, x_0=x_0, v_0=v_0, t=t, F_0=F_0, omega=omega)))


def modal_rows(names: Mapping[str, str], columns: Columns, modal: list[list[list[Point]]]) -> list[CheckedPoint]:
    """The checked points of a motion that is given by its modes, at a few times."""
    true: dict[str, Sequence[Point]] = {}
    for i, both in zip(BOTH, zip(*modal, strict=True), strict=True):
        true[f"x{i}"] = [_sum(parts) for parts in zip(*both, strict=True)]
        true |= {f"x{i}_{mode}": part for mode, part in zip(MODES, both, strict=True)}
    return points(names, columns, true)


def _sum(parts: Iterable[Point]) -> Point:
    values, sizes = zip(*parts, strict=True)
    with precise():
        return Point(sum(values), sum(sizes))


def modes_table(chain: TwoMassChain) -> Table:
    """Errors of both frequencies and both shapes, if they are numbers."""
    modes, found = chain.modes(), []
    for j, ((omega, ratio), sign) in enumerate(zip(modes_of(chain), "-+", strict=True)):
        place = f"The {MODES[j]} mode"
        found.append(CheckedPoint(rf"$\omega_{sign}$", place, float(modes.omega[j]), Point(omega, omega)))
        if ratio is not None and np.isfinite(modes.ratio[j]):
            found.append(CheckedPoint("$X_2/X_1$", place, float(modes.ratio[j]), Point(ratio, abs(ratio))))
    bound = "Frequencies and shapes of the modes are rounded once: their error is at most 0.51 ulp of their own value."
    return Table(bound, ROUNDED_ONCE, tuple(found))


def free_drift(free: FreeModes, t: NDArray[np.float64]) -> str:
    return drift(chain_energy(free.chain, free.motion(t)).total, fsum(free.energy))

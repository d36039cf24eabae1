"""'About these numbers' of the driven chain."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from components.chain import BOTH
from components.chain.about import DRIVE, FREQUENCY, MASSES, motion_rows
from components.chain.parameters import Pair
from components.quantities.declared import by_name
from components.quantities.formatting import short
from components.scene import Picture
from components.scene.about import About, bands_among, bounded, few_of, points, rows
from components.scenes.forced.case import Signals as S
from components.scenes.forced.case import Work
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.response import Swings
from physics.energy import chain_energy
from physics.forced import DrivenModes
from physics.reference.damped_chain import braked_lags, braked_points, braked_swings
from physics.reference.single import steady_points
from physics.sampling import drawable
from physics.transient import DampedModes

BANDS = MASSES | {
    part[i].name: f"the {name} part" for i in BOTH for part, name in ((S.x_p, "particular"), (S.x_c, "complementary"))
}

LAGS = {f"phi{i}": rf"$\psi_{i}$" for i in BOTH}


def forced_about(picture: Picture, driven: DrivenModes, x_0: Pair, v_0: Pair) -> About:
    """Errors of the displacements, and of both amplitudes of the particular solution."""
    columns, sweep = picture.sources["time"], picture.sources[Swings.omega.source]
    motion = motion_rows(MASSES, columns, driven.chain, x_0, v_0, driven.F_0, driven.omega)
    steady = steady_points(driven.chain, 0.0, driven.F_0, few_of(sweep["omega"]))
    swings = {Swings.Xp[i]: rf"$X_{{\mathrm{{p}}{i}}}$" for i in BOTH}
    true = by_name(dict(zip(swings, steady, strict=True)))
    tables = (
        bounded("$x_1(t)$ or $x_2(t)$", 4, "the largest displacement possible by then", motion),
        bounded("the particular solution", 2, "its own value", rows(swings, sweep, true, DRIVE)),
    )
    return About(tables, _work_gap(driven, columns["t"]), bands_among(picture.sources, BANDS))


def damped_about(picture: Picture, modes: DampedModes) -> About:
    """Errors of the displacements with dashpots, and of both amplitudes of the particular solution."""
    columns, sweep = picture.sources["time"], picture.sources[Swings.omega.source]
    true = braked_points(modes, few_of(columns["t"]))
    swings = {Swings.Xp[i]: rf"$|X_{{\mathrm{{p}}{i}}}|$" for i in BOTH}
    steady = braked_swings(modes, few_of(sweep["omega"]))
    lags, driven = picture.sources["lag"], modes.F_0 and modes.omega
    turns = braked_lags(modes, few_of(lags["w"])) if driven else {}
    tables = (
        bounded("$x_1(t)$ or $x_2(t)$", 4, "the largest displacement by then", points(MASSES, columns, true)),
        bounded("the particular solution", 4, "its own value", rows(swings, sweep, steady, DRIVE)),
        bounded("the lags", 8, "one radian", points(LAGS if driven else {}, lags, turns, FREQUENCY)),
    )
    return About(tables, _heat_gap(modes, columns["t"]), bands_among(picture.sources, BANDS))


def _heat_gap(modes: DampedModes, t: NDArray[np.float64]) -> str:
    damped = DampedForcedCase(modes, float(t[-1]))
    if not drawable(2 * damped.fastest, t):
        return "The energies change too fast in this window to be added up."
    energy = damped.energy(t)
    largest = float(np.max(np.abs([energy[Work.gain], energy[Work.work]]))) or 1.0
    gap = float(np.max(np.abs((energy[Work.work] - energy[Work.gain] - damped.heat(t)) / largest)))
    return f"The work of the drive is the gain of $T + V$ and the heat of the dashpots to {short(gap)} of the largest."


def _work_gap(driven: DrivenModes, t: NDArray[np.float64]) -> str:
    total = chain_energy(driven.chain, driven.motion(t)).total
    largest = float(np.max(total))
    if not largest:
        return "Nothing moves, and the drive does no work."
    gap = float(np.max(np.abs((total - total[0] - driven.work(t)) / largest)))
    return f"The gain of $T + V$ and the work of the drive agree to {short(gap)} of the largest $T + V$."

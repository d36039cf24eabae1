"""'About these numbers' of the coupled masses."""

from __future__ import annotations

import numpy as np

from components.chain import PARTS
from components.chain.about import MASSES, free_drift, modal_rows, motion_rows
from components.chain.parameters import Pair
from components.chain.signals import Signals as S
from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, few_of
from physics.coupled import FreeModes
from physics.reference import points_of_modes

ByModes = tuple[Pair, Pair]
BANDS = MASSES | {S.x_part[part]: f"the {part[1]} mode" for part in PARTS}


def coupled_about(picture: Picture, free: FreeModes, x_0: Pair, v_0: Pair, by_modes: ByModes | None = None) -> About:
    """Displacements, or where these are bands the modes that are not; `by_modes` are amplitudes and phases of a motion
    that is given by them."""
    columns = picture.sources["time"]
    names = {S.x_part[i, mode]: f"$x_{i}$, {mode}" for i, mode in PARTS if S.x[i].name not in columns}
    shown = MASSES | names
    if by_modes:
        t = np.array(few_of(columns["t"]))
        motion = modal_rows(shown, columns, points_of_modes(free.chain, *by_modes, t))
    else:
        motion = motion_rows(shown, columns, free.chain, x_0, v_0)
    points = bounded("$x_1(t)$, $x_2(t)$ or a mode", 2, "its amplitudes", motion)
    return About((points,), free_drift(free, columns["t"]), drawn_as_bands(picture.sources, BANDS))

"""'About these numbers' of the coupled masses."""

from __future__ import annotations

from components.about import About, bounded, drawn_as_bands
from components.chain import MODES
from components.chain.about import MASSES, free_drift, motion_rows
from components.chain.parameters import Pair
from components.scene import Picture
from physics.coupled import TwoMassChain

PARTS = {f"x{i}_{mode}": f"$x_{i}$, {mode}" for i in (1, 2) for mode in MODES}
BANDS = MASSES | {f"x{i}_{mode}": f"the {mode} mode" for i in (1, 2) for mode in MODES}


def coupled_about(picture: Picture, chain: TwoMassChain, x_0: Pair, v_0: Pair) -> About:
    """Displacements, or where these are bands the modes that are not."""
    columns = picture.columns["time"]
    names = {key: name for key, name in PARTS.items() if key[:2] not in columns}
    motion = motion_rows(MASSES | names, columns, chain, x_0, v_0)
    points = bounded("$x_1(t)$, $x_2(t)$ or a mode", 2, "its amplitudes", motion)
    return About((points,), free_drift(chain, x_0, v_0, columns["t"]), drawn_as_bands(picture.columns, BANDS))

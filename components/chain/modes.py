"""The two modes of the two-mass chain by name, and how the masses move in each."""

from __future__ import annotations

import math

import numpy as np

from components.figures import Figure
from components.traces import Columns
from physics.coupled import TwoMassChain

MODES = ("slow", "fast")


def directions(system: TwoMassChain) -> list[tuple[float, float]]:
    """How far mass 1 and mass 2 move in each mode, the larger by 1."""
    ratios = system.modes().ratio.tolist()
    return [(0.0, 1.0) if math.isinf(r) else (1 / max(1.0, abs(r)), r / max(1.0, abs(r))) for r in ratios]


def direction_lines(system: TwoMassChain, far: float) -> Columns:
    """Both directions in the plane of x1 and x2, out to `far` both ways: slow1, slow2, fast1, fast2."""
    ends = far * np.array([-1.0, 1.0])
    pairs = zip(MODES, directions(system), strict=True)
    return {f"{mode}{i}": part * ends for mode, parts in pairs for i, part in enumerate(parts, start=1)}


def mode_figures(system: TwoMassChain, *names: str) -> tuple[Figure, ...]:
    """The natural frequencies, whose live numbers have these names, and the shapes."""
    modes = system.modes()
    rows = zip(names, MODES, "−+", modes.omega.tolist(), modes.ratio.tolist(), strict=True)
    return tuple(
        figure
        for name, mode, sign, omega, ratio in rows
        for figure in (
            Figure(name, f"ω_{{{sign}}}", omega, "rad/s", mode),
            Figure(f"ratio of {name}", f"X₂/X₁_{{{sign}}}", ratio, "", mode),
        )
    )

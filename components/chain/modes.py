"""The two modes of the two-mass chain by name, and how the masses move in each."""

from __future__ import annotations

import math

import numpy as np

from components.quantities.readouts import Readout
from components.scene.traces import Columns
from physics.coupled import TwoMassChain

MODES = ("slow", "fast")


def directions(system: TwoMassChain) -> list[tuple[float, float]]:
    """The displacements of mass 1 and mass 2 in each mode, the larger one scaled to 1."""
    ratios = system.modes().ratio.tolist()
    return [(0.0, 1.0) if math.isinf(r) else (1 / max(1.0, abs(r)), r / max(1.0, abs(r))) for r in ratios]


def direction_lines(system: TwoMassChain, far: float) -> Columns:
    """Both directions in the plane of x1 and x2, out to `far` both ways: slow1, slow2, fast1, fast2."""
    ends = far * np.array([-1.0, 1.0])
    pairs = zip(MODES, directions(system), strict=True)
    return {f"{mode}{i}": part * ends for mode, parts in pairs for i, part in enumerate(parts, start=1)}


def mode_readouts(system: TwoMassChain, omega: str, ratio: str) -> tuple[Readout, ...]:
    """The natural frequencies and the shapes. The names of their live numbers, of which a scene may have several, are
    `omega` and `ratio` with {mode} for slow or fast, {sign} for minus or plus."""
    modes = system.modes()
    rows = zip(MODES, ("minus", "plus"), "−+", modes.omega.tolist(), modes.ratio.tolist(), strict=True)
    return tuple(
        Readout(name, symbol, value, unit, mode, also=tuple(also))
        for mode, word, sign, frequency, shape in rows
        for told, symbol, value, unit in (
            (omega, f"ω_{{{sign}}}", frequency, "rad/s"),
            (ratio, f"X₂/X₁_{{{sign}}}", shape, ""),
        )
        for name, *also in [told.format(mode=mode, sign=word).split()]
    )

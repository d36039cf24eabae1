"""The two modes of the two-mass chain by name, its masses, and their displacements in each mode."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from components.quantities.declared import Column, Family, by_name
from components.scene.traces import Columns
from physics.coupled import TwoMassChain

MODES = ("slow", "fast")
BOTH = (1, 2)
"""The masses, from the wall."""
PARTS = tuple((i, mode) for i in BOTH for mode in MODES)
"""All pairs of a mass and a mode."""


def directions(system: TwoMassChain) -> list[tuple[float, float]]:
    """The displacements of mass 1 and mass 2 in each mode, the larger one scaled to 1."""
    ratios = system.modes().ratio.tolist()
    return [(0.0, 1.0) if math.isinf(r) else (1 / max(1.0, abs(r)), r / max(1.0, abs(r))) for r in ratios]


Lines = Family[tuple[str, int], Column[Any]]


def lines_of(source: str) -> Lines:
    """The columns for the lines of both modes in the plane of x1 and x2."""
    return Column[Any].each(((mode, i) for i, mode in PARTS), "{}{}", source=source)


def direction_lines(lines: Lines, system: TwoMassChain, far: float) -> Columns:
    """Return the lines of both modes in the plane, up to `far` on both sides."""
    ends = far * np.array([-1.0, 1.0])
    pairs = zip(MODES, directions(system), strict=True)
    return by_name({lines[mode, i]: part * ends for mode, parts in pairs for i, part in zip(BOTH, parts, strict=True)})

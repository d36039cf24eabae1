"""The free motion of the two-mass chain as the clock plays it and as curves are made of it, mode by mode."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from components.chain.modes import MODES
from components.chain.parameters import Pair
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.motion import rates, sines
from components.scene.traces import Columns, Floats
from physics.coupled import FreeModes
from physics.sampling import Sinusoid


def free_signals(free: FreeModes, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The slow and the fast part of each displacement, as x1_slow, ...: the clock's signals.

    A mode of frequency zero is a drift, counted with the slow part.
    """
    return {f"x{part}": sines(size, time, term, line=line) for part, term, line in _parts(free)}


def free_rates(free: FreeModes, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The slow and the fast part of each velocity, in the unit of `size` per unit of time, as v1_slow, ...."""
    return {f"v{part}": rates(size, time, term, drift=line[1]) for part, term, line in _parts(free)}


def _parts(free: FreeModes) -> Iterator[tuple[str, tuple[float, float, float], Pair]]:
    """Name, amplitude, frequency and phase, and drift of the part of each mass in each mode."""
    modes = list(zip(MODES, free.amplitude.tolist(), free.omega.tolist(), free.phase.tolist(), strict=True))
    for i, drift in enumerate(zip(free.drift_a.tolist(), free.drift_b.tolist(), strict=True)):
        for (mode, amplitude, omega, phase), line in zip(modes, (drift, (0.0, 0.0)), strict=True):
            yield f"{i + 1}_{mode}", (amplitude[i], omega, phase), line


def positions(free: FreeModes, t: Floats) -> Columns:
    """x1 and x2 in doubles, at times t (n,) that resolve both modes: what a frame is fitted to."""
    phases = np.outer(free.omega, t) + free.phase[:, None]
    x = free.amplitude.T @ np.sin(phases) + free.drift_a[:, None] + np.outer(free.drift_b, t)
    return {"x1": x[0], "x2": x[1]}


def components(free: FreeModes, i: int, modes: tuple[int, ...] = (0, 1)) -> list[Sinusoid]:
    """The oscillating terms of x_i (i = 0, 1) in a free motion."""
    return [Sinusoid(free.amplitude[j, i], free.omega[j], free.phase[j]) for j in modes if free.omega[j] > 0]

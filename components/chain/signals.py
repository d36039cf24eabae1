"""The free motion of the two-mass chain as the clock plays it and as curves are made of it, mode by mode."""

from __future__ import annotations

from components.axes import Axis
from components.chain.modes import MODES
from components.chain.parameters import Pair
from components.motion import rates, sines
from components.page.signals import AnySignal
from physics.coupled import FreeModes
from physics.sampling import Sinusoid


def free_signals(free: FreeModes, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The slow and the fast part of each displacement, as x1_slow, ...: the clock's signals.

    A mode of frequency zero is a drift, counted with the slow part.
    """
    return {
        f"x{i + 1}_{mode}": sines(size, time, _term(free, i, j), line=_drift(free, i, j))
        for i in (0, 1)
        for j, mode in enumerate(MODES)
    }


def free_rates(free: FreeModes, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The same of each velocity, in the unit of `size` per unit of time, as v1_slow, ...."""
    return {
        f"v{i + 1}_{mode}": rates(size, time, _term(free, i, j), drift=_drift(free, i, j)[1])
        for i in (0, 1)
        for j, mode in enumerate(MODES)
    }


def _term(free: FreeModes, i: int, j: int) -> tuple[float, float, float]:
    return free.amplitude[j, i], free.omega[j], free.phase[j]


def _drift(free: FreeModes, i: int, j: int) -> Pair:
    return (free.drift_a[i], free.drift_b[i]) if j == 0 else (0.0, 0.0)


def components(free: FreeModes, i: int, modes: tuple[int, ...] = (0, 1)) -> list[Sinusoid]:
    """The oscillating terms of x_i (i = 0, 1) in a free motion."""
    return [Sinusoid(free.amplitude[j, i], free.omega[j], free.phase[j]) for j in modes if free.omega[j] > 0]

"""Signals of the two-mass chain's motion for the clock and for curves; those of a free motion mode by mode."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from components.chain.modes import BOTH, MODES, PARTS
from components.chain.parameters import Pair
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.declared import Declared, DrawnAxis, Family, Signal, by_name
from components.quantities.motion import sines, total
from components.scene.traces import Columns, Floats
from physics.coupled import FreeModes
from physics.sampling import Sinusoid

signal = Signal[Any]


class Axes(Declared[Any]):
    t, x = DrawnAxis.some(2)


class Signals(Declared[Any]):
    """The displacements and velocities of the masses, and the part of each mode in the displacements; the forces on the
    masses, and the drive as a sine of size 1.
    """

    x = signal.each(BOTH, on=Axes.x, signed=True)
    v, F = signal.each(BOTH), signal.each(BOTH)
    x_part = signal.each(PARTS, "x{}_{}")
    drive = signal()


class FreeSignals(Signals):
    """The displacements of a free motion, as sums of their parts in the modes."""

    x = Family(BOTH, lambda i: signal(lambda c, a: both(Signals.x_part, i), Axes.x, signed=True))


def both(parts: Family[tuple[int, str], Signal[Any]], i: int) -> AnySignal:
    """The sum of the parts of mass i in both modes."""
    return total(*(parts[i, mode] for mode in MODES))


def free_signals(free: FreeModes, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The slow and the fast part of each displacement, as signals.

    A mode of frequency zero is a drift, counted with the slow part.
    """
    return {Signals.x_part[part].name: sines(size, time, term, line=line) for part, term, line in _parts(free)}


def _parts(free: FreeModes) -> Iterator[tuple[tuple[int, str], tuple[float, float, float], Pair]]:
    """The part of each mass in each mode: amplitude, frequency and phase, and drift."""
    modes = list(zip(MODES, free.amplitude.tolist(), free.omega.tolist(), free.phase.tolist(), strict=True))
    for i, drift in enumerate(zip(free.drift_a.tolist(), free.drift_b.tolist(), strict=True)):
        for (mode, amplitude, omega, phase), line in zip(modes, (drift, (0.0, 0.0)), strict=True):
            yield (i + 1, mode), (amplitude[i], omega, phase), line


def positions(free: FreeModes, t: Floats) -> Columns:
    """x1 and x2 in doubles at times t (n,) that resolve both modes, for fitting a frame."""
    phases = np.outer(free.omega, t) + free.phase[:, None]
    x = free.amplitude.T @ np.sin(phases) + free.drift_a[:, None] + np.outer(free.drift_b, t)
    return by_name({Signals.x[1]: x[0], Signals.x[2]: x[1]})


def components(free: FreeModes, i: int, modes: tuple[int, ...] = (0, 1)) -> list[Sinusoid]:
    """The oscillating terms of x_i (i = 0, 1) in a free motion."""
    return [Sinusoid(free.amplitude[j, i], free.omega[j], free.phase[j]) for j in modes if free.omega[j] > 0]

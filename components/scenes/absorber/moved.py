"""The motion from its start over a window, as it is drawn: in doubles, unless it is a small difference of its parts."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from components.scene.traces import Floats, samples
from components.scenes.absorber.duty import Duty
from physics.coupled import Motion
from physics.forced import DrivenModes

DRAWN = 1e-11
"""The share of a motion that no drawing shows, nor a table that is taken away."""


class FromStart(NamedTuple):
    """x1, x2 and x2 - x1 (3, n) from the start at times t (n,), and of both parts; `in_doubles` where the terms of x1,
    summed in doubles, are right to all digits that are drawn."""

    t: Floats
    x: Floats
    particular: Floats | None = None
    complementary: Floats | None = None
    in_doubles: bool = True


def moved(duty: Duty, t: Floats) -> FromStart:
    """The motion at times t; its parts too where they are drawn. ValueError as Duty.from_rest_at."""
    if not (duty.from_rest and duty.solved):
        return FromStart(t, _displacements(duty.from_rest_at(t)))
    if duty.c:
        particular, complementary = duty.damped.particular_motion(t), duty.damped.complementary(t)
    else:
        particular, complementary = _parts(duty.driven, t)
    x = particular + complementary
    x[:, 0] = duty.x_0[0], duty.x_0[1], duty.x_0[1] - duty.x_0[0]
    one, stretch = duty.bounds
    doubt = 2.0**-52 * (1 + duty.fastest * t[-1]) * np.array([one, one + stretch, stretch])
    doubtful = doubt > DRAWN * np.abs(x).max(axis=1)
    if duty.alike or np.any(doubtful):
        x = _displacements(duty.from_rest_at(t))
    return FromStart(t, x, particular, complementary, not (duty.alike or doubtful[0]))


def reach_alone(duty: Duty, end: float) -> float:
    """The largest displacement of the machine alone over [0, end], from the same start."""
    t, bare = times(duty, end), duty.bare
    x = np.add(*_parts(bare, t))[0] if bare.split_is_meaningful else bare.motion(t).x[0]
    return float(np.abs(x).max())


def times(duty: Duty, end: float) -> Floats:
    """So many times as the fastest motion needs to be drawn."""
    return np.linspace(0.0, end, samples(end, duty.fastest))


def _parts(driven: DrivenModes, t: Floats) -> tuple[Floats, Floats]:
    """x_p and x_c, (3, n) each, from amplitudes and phases."""
    free = driven.complementary_modes
    X, a, b = (_rows(masses) for masses in (driven.particular, free.drift_a, free.drift_b))
    modes = zip(free.amplitude, free.omega.tolist(), free.phase.tolist(), strict=True)
    swings = [_rows(amplitude) * np.sin(omega * t + phase) for amplitude, omega, phase in modes]
    return X * np.sin(driven.omega * t), a + b * t + sum(swings)


def _rows(masses: Floats) -> Floats:
    """Of x1 and x2 (2,) those and x2 - x1, as a column (3, 1)."""
    one, two = masses.tolist()
    return np.array([[one], [two], [two - one]])


def _displacements(motion: Motion) -> Floats:
    return np.array([*motion.x, motion.e[1]])

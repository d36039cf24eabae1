"""The driven motion of the chain in the form that keeps its digits at each time (lecture D34, slides 6 to 8).

Each mode adds to the free motion of the start share * g, where g'' + omega_n^2 g = sin(omega t) from rest:

    g = (sin(omega t) - omega sin(omega_n t)/omega_n)/(omega_n^2 - omega^2)

which is x_p and a change of the starting velocity, sinusoids all of it. It loses its digits while the phases are
small, and near resonance, until the beat has begun. Other forms of the same function are then used:

    the onset of the whole chain, of one mode    power series, regular at t = 0
    a beat, d t < 1/16                           g = (cos(d t) sin(s t)/s - cos(s t) sin(d t)/d)/(2 omega_n)
    a slow sinusoid, omega t < 1/16              sin(omega t)/omega = t (1 + small)

with s and d half the sum and half the difference of the frequencies. A form that has ended never comes back, so the
times fall into stages, a few at most.
"""

from collections.abc import Sequence
from decimal import Decimal
from math import inf
from typing import NamedTuple

import numpy as np

from physics.coupled import QUANTITIES, FreeModes, Mode
from physics.onset import EARLY, onset
from physics.precision.curves import early
from physics.precision.exact import Array, exact, precise
from physics.sinusoids import SLOW, Beat, ExactSinusoid, Weighted, added, total
from physics.valid import rows_in_range

NONE = Decimal(0)
_ONSET_OF_A_MODE = 0.5  # rad; the closed form of a response has digits to spare from here on


class AlsoSummed(NamedTuple):
    """Other sums of the slow mode, the fast mode and the drive, which the same sines and cosines serve.

    Attributes
    ----------
    quantities : sequence of str
        The name of each in an error message.
    sinusoids : sequence of three ExactSinusoid
        Their coefficients in the slow mode, the fast mode and the drive.
    """

    quantities: Sequence[str]
    sinusoids: Sequence[ExactSinusoid]


NOTHING = AlsoSummed((), [ExactSinusoid(NONE, (), ())] * 3)


def driven_values(free: FreeModes, F_0: float, omega: float, t: Array, beside: AlsoSummed = NOTHING) -> Array:
    """Return the motion under F_0 sin(omega t) on mass 1.

    Parameters
    ----------
    free : FreeModes
        The free motion from the initial conditions.
    F_0 : float
        The amplitude of the force in N, not 0.
    omega : float
        The frequency of the drive in rad/s, above 0.
    t : ndarray (n,)
        Times in s.
    beside : AlsoSummed
        Other sums to return.

    Returns
    -------
    ndarray (5 + others, n)
        x1, x2 and x2 - x1 in m, v1 and v2 in m/s, and a row for each quantity of `beside`.

    Raises
    ------
    ValueError
        If a quantity leaves the range of doubles.
    """
    start, *others = _ends(free, omega)
    ends = [start, *(max(start, end) for end in others)]  # until all have started it is all the same how each does
    begins = [-1.0, *sorted(ends)]
    stages = np.searchsorted(begins[1:], np.abs(t), side="right")
    forms = {stage: [end > begins[stage] for end in ends] for stage in np.flatnonzero(np.bincount(stages)).tolist()}
    values = _at(free, F_0, omega, t, forms.popitem()[1], beside)  # the last form holds for all times
    for stage, form in forms.items():
        where = stages == stage
        values[: len(QUANTITIES), where] = _at(free, F_0, omega, t[where], form)
    return values


def _ends(free: FreeModes, omega: float) -> list[float]:
    """Until when, in s, all starts and the slow mode does; slow, fast mode and drive are slow; slow and fast beat."""
    drive, (slow, fast) = exact(omega), free.chain.exact_modes
    with precise():
        turns = [slow.omega, fast.omega, drive, (drive - slow.omega) / 2, (drive - fast.omega) / 2]
    onsets = _until(EARLY, max(drive, fast.omega)), _until(_ONSET_OF_A_MODE, max(drive, slow.omega))
    return [*onsets, *(_until(SLOW, turn) for turn in turns)]


def _until(phase: float, omega: Decimal) -> float:
    """Return the time at which a phase (rad) is reached."""
    speed = abs(float(omega))
    return phase / speed if speed else inf


def _at(
    free: FreeModes, F_0: float, omega: float, t: Array, forms: Sequence[bool], beside: AlsoSummed = NOTHING
) -> Array:
    """Values at times in one stage; forms are in the order of _ends."""
    all_starts, slow_starts, slow, fast, drive_is_slow, slow_beats, fast_beats = forms
    if all_starts:
        values = _onset(free, F_0, omega, t)
        return np.vstack([values, added(beside.sinusoids, t, beside.quantities)]) if beside.quantities else values
    drive, X = exact(omega), [NONE] * 3
    turning: tuple[list[ExactSinusoid], list[ExactSinusoid]] = [], []  # quick, slow
    beats, curves = [], []
    *others, other = beside.sinusoids
    per_mode = zip(free.each(), (slow, fast), (slow_starts, False), (slow_beats, fast_beats), others, strict=True)
    for (mode, q, v), is_slow, starts, is_beating, same in per_mode:
        with precise():
            share = exact(F_0) * mode.shape[0] / mode.mass
            if share and starts:
                curves += _start(drive, mode, share, t)
            elif share and is_beating:
                beats.append(_beat(drive, mode, share))
            elif share:
                reach = share / ((mode.omega - drive) * (mode.omega + drive))
                X = [x + part * reach for x, part in zip(X, mode.rows, strict=True)]
                v -= reach * drive
        turning[is_slow].append(_joined(mode.sinusoid(q, v), same))
    with precise():
        rates = [x * drive for x in X]
    swing = ExactSinusoid(drive, [*[NONE] * 3, *rates[:2]], [*rates, *[NONE] * 2])
    turning[drive_is_slow].append(_joined(swing, other))
    quick, hardly = ([one for one in ones if any(one.cosine) or any(one.sine)] for ones in turning)
    return total(t, (*QUANTITIES, *beside.quantities), quick, hardly, beats, curves)


def _joined(one: ExactSinusoid, other: ExactSinusoid) -> ExactSinusoid:
    """Return one sinusoid with the quantities of two sinusoids of the same frequency."""
    return ExactSinusoid(one.omega, [*one.cosine, *other.cosine], [*one.sine, *other.sine])


def _onset(free: FreeModes, F_0: float, omega: float, t: Array) -> Array:
    with np.errstate(over="ignore", invalid="ignore"):
        values = onset(free.chain, F_0, omega, t)
        if any((*free.coordinate, *free.velocity)):
            values = values + free.values(t)
    return rows_in_range(QUANTITIES, values)


def _start(drive: Decimal, mode: Mode, share: Decimal, t: Array) -> list[Weighted]:
    """share g and share g' as series."""
    g, speed = early((drive, mode.omega), t, 3), early((drive, mode.omega), t, 2)
    return [
        Weighted(g, [*(part * share for part in mode.rows), NONE, NONE]),
        Weighted(speed, [*[NONE] * 3, *(part * share for part in mode.shape)]),
    ]


def _beat(drive: Decimal, mode: Mode, share: Decimal) -> Beat:
    """share g and share g', where g' = omega sin(s t) sin(d t)/(2 s d)."""
    s, d = (drive + mode.omega) / 2, (drive - mode.omega) / 2
    half = share / (2 * mode.omega)
    return Beat(
        s,
        d,
        sine=[*(part * half / s for part in mode.rows), NONE, NONE],
        growing_cosine=[*(-part * half for part in mode.rows), NONE, NONE],
        growing_sine=[*[NONE] * 3, *(part * share * drive / (2 * s) for part in mode.shape)],
    )

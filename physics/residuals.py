"""Causes of the residuals of a damped sinusoid: forces and motions that the model lacks.

The residuals are compared with products of slow polynomials and the fitted oscillation: in phase with it its amplitude
differs, a quarter of a cycle off its frequency. The curvature of the amplitude's difference shows the kind of friction:
with the drag of air an amplitude falls more slowly than an exponential at the end, with dry friction faster. Residuals
that no product explains come from another mode, or from an unknown cause. The scatter is estimated from third
differences of neighbouring rows, in which a smooth motion vanishes.

For the fit and its sources see physics.fit.
"""

from enum import StrEnum

import numpy as np

from physics.fit import DampedFit
from physics.precision.exact import Array

ORDER = 5
"""Polynomials in the time, from degree 0 on."""
MOST_OF_IT = 0.5
LEAST_CYCLES = 3.0
LEAST_ROWS = 8.0
"""Rows in a cycle."""
REST = 0.2
"""The share of the amplitude at the start below which a motion may have stopped."""


class Cause(StrEnum):
    """The cause of residuals that are not random, by their pattern."""

    AIR = "air"  # the amplitude falls fast at first: drag of air
    DRY = "dry"  # it falls ever faster: dry friction
    SPRING = "spring"  # the frequency changes with the amplitude
    DRIFT = "drift"  # the equilibrium moves
    OTHER = "other"  # another frequency, or nothing known


def cause_of(t: Array, fit: DampedFit) -> tuple[Cause, float]:
    """Return the cause of the residuals of a `fit` of one column, and their strongest frequency in rad/s.

    Both are of use only if the residuals are not random. The times t (n,) in s are those of all rows.
    """
    rows = np.flatnonzero(fit.used)
    order = rows[np.argsort(t[rows], kind="stable")]
    t, r = t[order] - fit.t_first, fit.residual[0, order]
    span, omega = float(t[-1]), float(fit.omega[0])
    strongest = _strongest(t, r)
    cycles = omega * span / (2 * np.pi)
    if cycles < LEAST_CYCLES or t.size < LEAST_ROWS * cycles:
        return Cause.OTHER, strongest
    turned = np.exp(1j * (omega * t - np.arctan2(fit.S[0, 0], fit.C[0, 0])))
    slow = np.polynomial.legendre.legvander(2 * t / span - 1, ORDER - 1)
    groups = [slow * turned.real[:, None], slow * turned.imag[:, None], slow]
    found = np.linalg.lstsq(np.hstack(groups), r, rcond=None)[0]
    sizes = [float(np.sum((group @ one) ** 2)) for group, one in zip(groups, np.split(found, 3), strict=True)]
    noise = float(np.mean(np.diff(r, 3) ** 2)) / 20 * r.size
    excess = max(float(r @ r) - noise, 1e-300)
    in_step, off, drift = (size > MOST_OF_IT * excess for size in sizes)
    if in_step:
        size = float(np.hypot(fit.C[0, 0], fit.S[0, 0])) * np.exp(-fit.decay[0] * t)
        return _friction(size, slow @ found[:ORDER]), strongest
    return Cause.SPRING if off else Cause.DRIFT if drift else Cause.OTHER, strongest


def _friction(fitted: Array, more: Array) -> Cause:
    """The friction whose amplitude is `fitted` and `more`, judged until most of the motion has died."""
    swing = fitted + more
    until = int(np.argmax(swing < REST * swing[0])) or swing.size
    curvature = np.polynomial.legendre.legfit(np.linspace(-1, 1, until), more[:until], 2)[2]
    return Cause.AIR if curvature > 0 else Cause.DRY


def _strongest(t: Array, r: Array) -> float:
    """The frequency of the largest peak of a spectrum, in rad/s."""
    n = 8 * t.size
    place = np.minimum((t / t[-1] * n / 8).astype(int), t.size - 1)
    power = np.abs(np.fft.rfft(np.bincount(place, r, t.size), n)) ** 2
    return float(2 * np.pi * np.argmax(power) * (t.size - 1) / t.size / (8 * t[-1]))

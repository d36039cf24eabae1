"""Damped sinusoids fitted to measured columns by variable projection.

    y = b + sum_j e^(-a_j t) (C_j cos omega_j t + S_j sin omega_j t) + noise,   t counted from the first row

omega_j and a_j are common to all columns; C_j, S_j and b belong to each. physics.variable_projection finds the least
squares. Standard errors come from the full Jacobian and the scatter of the residuals, or from the standard deviations
of the rows where these are given.

Columns whose scatters differ by more than chance are weighted by them. Rows at a limit of the sensor are left out, a
straight drift is fitted too, and errors grow with the power of correlated residuals near omega; `cautions` say so.

Source: see physics.variable_projection.
"""

import math
from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np
from numpy.typing import ArrayLike

from physics.precision.exact import Array
from physics.variable_projection import SIGNIFICANT, Bools, LeastSquares, RowsToFit, damped_basis, fitted

MOST_SHARE = 0.1
"""Largest standard error of a frequency over itself; beyond it the numbers are not to be trusted."""
FEW_ROWS = 30
_WEAK = 25.0  # sum of squares of the motion over 4 sigma^2: below it a wrong peak is taken in 0.3 % or more
_ROUNDS = 8


class Caution(StrEnum):
    """Limits of a fit that its reader has to know."""

    FEW_ROWS = "few_rows"  # fewer than 30
    CLIPPED = "clipped"  # rows at a limit of the sensor were left out
    DRIFT = "drift"  # a straight line was fitted too
    CORRELATED = "correlated"  # residuals are not random: another mode, or friction that is not viscous
    WEAK = "weak"  # the noise may have chosen the frequency


@dataclass(frozen=True, eq=False, kw_only=True)
class DampedFit:
    """A fit of damped sinusoids, the slowest first, to c columns of n rows. `se_` is a standard error.

    Attributes
    ----------
    omega, se_omega, decay, se_decay : ndarray (modes,)
        Frequencies in rad/s and rates of decay in 1/s.
    C, S, se_C, se_S, se_amplitude : ndarray (c, modes)
        Factors of the cosines and the sines at the first row, in the units of the columns.
    se_phase : ndarray (c, modes)
        The standard errors of the phases, in rad.
    offset, se_offset, drift : ndarray (c,)
        The equilibria in the units of the columns, and their rates of change per second.
    t_first : float
        The time of the first row in s.
    used : ndarray of bool (n,)
        The rows that were fitted.
    residual : ndarray (c, n)
        The residuals of all rows; NaN in a hole.
    scatter : ndarray (c,)
        The standard deviation of the residuals; in units of sigma if sigma was given.
    chi_square, freedom : float, int
        The sum of squares and the degrees of freedom: with sigma freedom +- sqrt(2 freedom) is expected.
    aliases : tuple of float
        Frequencies in rad/s that fit evenly spaced rows equally well.
    covariance : ndarray (parameters, parameters)
        For omega and decay of each mode; then for each column C and S of each mode, the offset, and the drift if any.
    cautions : tuple of Caution
        Limits of the fit that its reader has to know.
    """

    omega: Array
    decay: Array
    se_omega: Array
    se_decay: Array
    C: Array
    S: Array
    se_C: Array
    se_S: Array
    se_amplitude: Array
    se_phase: Array
    offset: Array
    se_offset: Array
    drift: Array
    t_first: float
    used: Bools
    residual: Array
    scatter: Array
    chi_square: float
    freedom: int
    aliases: tuple[float, ...]
    covariance: Array
    cautions: tuple[Caution, ...]

    @property
    def amplitude(self) -> Array:
        """The amplitudes (c, modes) at the first row."""
        return np.hypot(self.C, self.S)

    @property
    def phase(self) -> Array:
        """The phases in rad (c, modes) at the first row: y = amplitude e^(-a t) sin(omega t + phase)."""
        return np.arctan2(self.C, self.S)

    @property
    def zeta(self) -> Array:
        """The damping ratios (modes,)."""
        return self.decay / np.hypot(self.omega, self.decay)

    @property
    def se_zeta(self) -> Array:
        """Standard errors, from those of omega and decay, which are almost independent."""
        square = self.omega**2 + self.decay**2
        return np.hypot(self.omega * self.se_decay, self.decay * self.se_omega) * self.omega / square**1.5

    def at(self, t: ArrayLike) -> Array:
        """Return the fitted columns (c, n) at the times t (n,) in s."""
        t = np.asarray(t, dtype=float) - self.t_first
        basis = damped_basis(np.ravel([self.omega, self.decay], "F"), t, 2)
        parts = np.stack([self.C, self.S], axis=2).reshape(len(self.C), -1)
        return np.asarray(np.column_stack([parts, self.offset, self.drift]) @ basis.T)


def fit_damped(t: ArrayLike, columns: ArrayLike, modes: int = 1, sigma: ArrayLike | None = None) -> DampedFit:
    """Fit one or two damped sinusoids and an offset to measured columns.

    Parameters
    ----------
    t : array_like (n,)
        Times in s.
    columns : array_like (n,) or (c, n)
        The measured values. Rows with a hole (NaN) are left out.
    modes : {1, 2}
        The number of frequencies.
    sigma : array_like or None
        The standard deviations of the values in the shape of the columns, if they are known.

    Returns
    -------
    DampedFit
        Frequencies, decays and amplitudes with standard errors.

    Raises
    ------
    ValueError
        If nothing can be fitted: too few rows, nothing that varies, or a frequency known to less than a tenth.
    """
    if modes not in (1, 2):
        raise ValueError(f"modes = {modes!r}: one or two frequencies are allowed")
    try:
        return _careful(RowsToFit.of(t, columns, sigma, modes), modes)
    except np.linalg.LinAlgError:
        raise ValueError(
            "the rows do not tell the frequencies: a longer record, a quieter one or fewer modes are needed"
        ) from None


def _careful(data: RowsToFit, modes: int) -> DampedFit:
    """A fit, and another one where the first shows a limit of the sensor or a drift."""
    found = fitted(data, modes)
    cautions = [Caution.FEW_ROWS] if len(data.t) < FEW_ROWS else []
    limits = data.limits
    if np.isfinite(limits).any():
        data, found = _without_clipped(data, found, limits)
        cautions.append(Caution.CLIPPED)
    if abs(found.trend) > SIGNIFICANT:
        data = replace(data, powers=2)
        found = fitted(data, modes, found.theta)
        cautions.append(Caution.DRIFT)
    if abs(found.correlation) > SIGNIFICANT:
        cautions.append(Caution.CORRELATED)
    if found.strength < _WEAK:
        cautions.append(Caution.WEAK)
    return _told(data, found, tuple(cautions))


def _without_clipped(
    data: RowsToFit, found: LeastSquares, limits: list[tuple[float, float]]
) -> tuple[RowsToFit, LeastSquares]:
    """The rows at which the fitted motion is within the sensor's limits, and the fit of these rows.

    The fitted values decide, because noise takes some measured values across a limit.
    """
    before, rows = data, data.rows
    for _ in range(_ROUNDS):
        kept = _below_limits(before, found, limits)
        if kept.sum() < 4 * len(found.theta):
            raise ValueError(
                "The rows are mostly at a limit of the sensor: a smaller motion or a wider range is needed"
            )
        data = before.only(kept)
        found = fitted(data, len(found.theta) // 2, found.theta)
        if np.array_equal(rows, data.rows):
            break
        rows = data.rows
    return data, found


def _below_limits(data: RowsToFit, found: LeastSquares, limits: list[tuple[float, float]]) -> Bools:
    """The rows at which the fitted columns stay below the limits by twice their scatter."""
    swing = found.coefficients @ damped_basis(found.theta, data.t, data.powers).T
    room = 2 * math.sqrt(found.variance) / found.data.W.mean(axis=1, keepdims=True)
    low, high = np.array(limits).T[..., None]
    return np.asarray(np.all((swing > low + room) & (swing < high - room), axis=0))


def _told(data: RowsToFit, found: LeastSquares, cautions: tuple[Caution, ...]) -> DampedFit:
    """The fit with its standard errors."""
    modes, c = len(found.theta) // 2, len(found.coefficients)
    errors = 1.0 if data.known else found.variance
    covariance = found.covariance * errors
    if Caution.CORRELATED in cautions:
        covariance = covariance * found.inflation**2
    se, few = np.sqrt(np.diag(covariance)), 2 * modes
    if np.any(se[:few:2] > MOST_SHARE * found.theta[::2]):
        raise ValueError("the frequency is known to less than a tenth: a longer or a quieter record is needed")
    each = se[few:].reshape(c, -1)
    C, S = found.coefficients[:, 0:few:2], found.coefficients[:, 1:few:2]
    places = few + np.arange(c)[:, None] * each.shape[1] + 2 * np.arange(modes)
    var_C, var_S, both = covariance[places, places], covariance[places + 1, places + 1], covariance[places, places + 1]
    A = np.hypot(C, S)
    fit = DampedFit(
        omega=found.theta[::2], decay=found.theta[1::2], se_omega=se[:few:2], se_decay=se[1:few:2], C=C, S=S,
        se_C=np.sqrt(var_C), se_S=np.sqrt(var_S),
        se_amplitude=np.sqrt(C**2 * var_C + S**2 * var_S + 2 * C * S * both) / A,
        se_phase=np.sqrt(S**2 * var_C + C**2 * var_S - 2 * C * S * both) / A**2,
        offset=found.coefficients[:, few], se_offset=each[:, few],
        drift=found.coefficients[:, few + 1] if data.powers > 1 else np.zeros(c), t_first=data.t_first,
        used=np.isin(np.arange(data.every.size), data.rows), residual=data.columns, scatter=np.zeros(c),
        chi_square=float(np.sum(found.residual**2)), freedom=found.freedom,
        aliases=tuple((2 * math.pi / data.step - found.theta[::2]).tolist()) if data.step else (),
        covariance=covariance, cautions=cautions,
    )  # fmt: skip
    residual = data.columns - fit.at(data.every)
    free, over = found.freedom / c, data.W if data.known else np.ones_like(data.W)
    scatter = np.sqrt(np.sum((residual[:, data.rows] * over) ** 2, axis=1) / free)
    return replace(fit, residual=residual, scatter=scatter)

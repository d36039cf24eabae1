"""The two-mass chain of a fit with two frequencies: shapes of its modes, and ratios of its masses and stiffnesses.

    m1 x1'' = -k1 x1 - k2 (x1 - x2),   m2 x2'' = k2 (x1 - x2)

A free motion determines ratios only: all masses and stiffnesses times one factor move in the same way. With the shape
r = X2/X1 of a mode, the second equation gives k2/m2 = omega^2 r/(r - 1). The two modes give it twice, and the mean is
weighted with their errors. The product and the sum of the squares of both frequencies give the rest. Omega is the
natural frequency, hypot of the fitted frequency and decay. Errors follow from the covariance of the whole fit.

Source: lecture D34, slides 3 to 5 (the modes).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from physics.fit import DampedFit
from physics.precision.exact import Array


@dataclass(frozen=True, eq=False, kw_only=True)
class ChainFit:
    """A measured chain. Standard errors have the units and shapes of their values.

    Attributes
    ----------
    omega, se_omega : ndarray (2,)
        Natural frequencies in rad/s, the slow mode first.
    ratio, se_ratio : ndarray (2,)
        X2/X1 of each mode.
    parts : ndarray (3,) or None
        k1/m1 and k2/m1 in 1/s^2, and m2/m1; None if no such chain has these shapes.
    se_parts : ndarray (3,)
        Their standard errors; 0 if there are no parts.
    difference : float
        k2/m2 by the slow mode less k2/m2 by the fast one, in standard errors.
    """

    omega: Array
    se_omega: Array
    ratio: Array
    se_ratio: Array
    parts: Array | None
    se_parts: Array
    difference: float


def chain_of_fit(fit: DampedFit) -> ChainFit:
    """Return the chain whose displacements x1, x2 have this `fit`, of two columns with two frequencies."""
    numbers = _numbers(fit)
    omega, se_omega = _with_errors(fit, lambda p: np.hypot(p[0:4:2], p[1:4:2]), numbers)[:2]
    ratio, se_ratio = _with_errors(fit, _ratios, numbers)[:2]
    twice, _, covariance = _with_errors(fit, _own, numbers)
    difference = float(twice[0] - twice[1]) / math.sqrt(covariance[0, 0] + covariance[1, 1] - 2 * covariance[0, 1])
    weights = 1 / np.diag(covariance)
    weights /= weights.sum()
    slow, fast = omega**2
    parts: Array | None = None
    se_parts = np.zeros(3)
    if ratio[0] > 1 and ratio[1] < 0 and slow < weights @ twice < fast:
        parts, se_parts = _with_errors(fit, lambda p: _parts(p, weights), numbers)[:2]
    return ChainFit(
        omega=omega, se_omega=se_omega, ratio=ratio, se_ratio=se_ratio, parts=parts, se_parts=se_parts,
        difference=difference,
    )  # fmt: skip


def _numbers(fit: DampedFit) -> Array:
    """The parameters of a fit in the order of their covariance."""
    columns = zip(fit.C, fit.S, fit.offset, fit.drift, strict=True)
    rest = [[*np.column_stack([C, S]).ravel(), offset, drift] for C, S, offset, drift in columns]
    many = (len(fit.covariance) - 4) // 2
    return np.concatenate([np.column_stack([fit.omega, fit.decay]).ravel(), *(row[:many] for row in rest)])


def _with_errors(fit: DampedFit, of: Callable[[Array], Array], at: Array) -> tuple[Array, Array, Array]:
    """A function of the parameters, its standard errors and its covariance, from differences over a standard error."""
    errors = np.sqrt(np.diag(fit.covariance))
    steps = [(of(at + step) - of(at - step)) / 2 for step in np.diag(1e-3 * errors)]
    slopes = np.column_stack(steps) / (1e-3 * errors)
    covariance = slopes @ fit.covariance @ slopes.T
    return of(at), np.sqrt(np.diag(covariance)), covariance


def _ratios(p: Array) -> Array:
    """X2/X1 of each mode: the real part, since dashpots turn the shapes of a chain a little."""
    one, two = (column[:4].reshape(2, 2) for column in np.split(p[4:], 2))
    return np.asarray(np.sum(one * two, axis=1) / np.sum(one**2, axis=1))


def _own(p: Array) -> Array:
    """k2/m2 from each mode."""
    r = _ratios(p)
    return np.asarray((p[0:4:2] ** 2 + p[1:4:2] ** 2) * r / (r - 1))


def _parts(p: Array, weights: Array) -> Array:
    """k1/m1, k2/m1 and m2/m1."""
    own = float(weights @ _own(p))
    slow, fast = p[0:4:2] ** 2 + p[1:4:2] ** 2
    k2 = (own - slow) * (fast - own) / own
    return np.array([slow * fast / own, k2, k2 / own])

"""Variable projection: the least squares of damped sinusoids in measured rows.

    y = b + sum_j e^(-a_j t) (C_j cos omega_j t + S_j sin omega_j t) + noise,   t counted from the first row

For given omega_j, a_j the rest is linear and solved by QR, so only 2 numbers a mode are sought by the method of
Levenberg and Marquardt, with Kaufman's Jacobian. The search begins at the peak of the spectrum, of two modes also at
the poles of a matrix pencil.

Sources: G. H. Golub, V. Pereyra, SIAM J. Numer. Anal. 10 (1973) 413; L. Kaufman, BIT 15 (1975) 49; Y. Hua,
T. K. Sarkar, IEEE Trans. Acoust. Speech Signal Process. 38 (1990) 814 (matrix pencil).
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.precision.exact import Array
from physics.valid import doubles

Bools = NDArray[np.bool_]

SIGNIFICANT = 4.0
"""Standard deviations: by chance in 1 of 16,000."""
_EVEN = 0.05  # tolerance of a time step, because times in a file are rounded
_MOST_ROWS = 250  # largest number of rows for the matrix pencil, whose cost grows like its cube
_ROUGH, _CLOSE = 1e-6, 1e-10  # relative errors of a search
_MOST_STEPS, _LAST_STEPS = 200, 3


@dataclass(frozen=True, eq=False, kw_only=True)
class RowsToFit:
    """Rows to fit: times from the first one on, columns and weights, and where they come from.

    Attributes
    ----------
    t : ndarray (n,)
        Times in s, from the first row on.
    Y, W : ndarray (c, n)
        The columns, and the weights of their values.
    known : bool
        True if the weights come from standard deviations.
    t_first : float
        The time of the first row in s.
    every, columns : ndarray (m,), (c, m)
        The times in s and the columns of all rows, with those that are left out.
    rows : ndarray of int (n,)
        The places of the rows to fit among all rows.
    powers : {1, 2}
        The powers of t that are fitted too: an offset, or an offset and a drift.
    """

    t: Array
    Y: Array
    W: Array
    known: bool
    t_first: float
    every: Array
    columns: Array
    rows: NDArray[np.int_]
    powers: int = 1

    @classmethod
    def of(cls, t: ArrayLike, columns: ArrayLike, sigma: ArrayLike | None, modes: int) -> "RowsToFit":
        """Choose the rows without holes, in the order of time.

        Parameters
        ----------
        t, columns, sigma
            The measurement, as in `physics.fit.fit_damped`.
        modes : int
            The number of frequencies.

        Returns
        -------
        RowsToFit
            The rows, with weights 1/sigma, or 1.

        Raises
        ------
        ValueError
            If there are too few rows, or a column or the time never changes.
        """
        every, Y = doubles("t", t), np.atleast_2d(doubles("columns", columns))
        W = np.ones_like(Y) if sigma is None else 1 / np.broadcast_to(doubles("sigma", sigma), Y.shape)
        if every.ndim != 1 or Y.shape[1:] != every.shape:
            raise ValueError(
                f"The columns have {Y.shape[-1]} rows, the times {every.size}: a number for each time is needed"
            )
        rows = np.flatnonzero(np.isfinite(every) & np.isfinite(Y).all(axis=0) & np.isfinite(W).all(axis=0))
        rows = rows[np.argsort(every[rows], kind="stable")]
        least = 4 * modes + 4
        if rows.size < least:
            raise ValueError(f"{rows.size} rows have a number in each column: {least} or more are needed")
        times = every[rows]
        if times[0] == times[-1] or np.ptp(Y[:, rows], axis=1).min() == 0:
            raise ValueError("a column, or the time, never changes: columns that change are needed")
        return cls(
            t=times - times[0], Y=Y[:, rows], W=W[:, rows], known=sigma is not None, t_first=float(times[0]),
            every=every, columns=Y, rows=rows,
        )  # fmt: skip

    @property
    def limits(self) -> list[tuple[float, float]]:
        """The limits of the sensor, low and high, of each column; infinite where no rows pile up at one."""
        return [(-_piled(-y), _piled(y)) for y in self.Y]

    @property
    def step(self) -> float | None:
        """The time from row to row in s if it is the same but for its rounding, else None."""
        n, T = self.t.size, float(self.t[-1])
        even = np.abs(self.t - np.linspace(0, T, n)).max() < _EVEN * T / n
        return T / (n - 1) if even else None

    def only(self, kept: Bools) -> "RowsToFit":
        """Return the rows that are `kept` (n,); time is still counted from the first one."""
        return replace(self, t=self.t[kept], Y=self.Y[:, kept], W=self.W[:, kept], rows=self.rows[kept])


@dataclass(frozen=True, eq=False, kw_only=True)
class LeastSquares:
    """The least squares of damped sinusoids.

    Attributes
    ----------
    data : RowsToFit
        The rows, with the weights that were used.
    theta : ndarray (2 modes,)
        omega in rad/s and decay in 1/s of each mode, one after the other.
    coefficients : ndarray (c, 2 modes + powers)
        The factors of the cosine and the sine of each mode, the offset and the drift, if any, of each column.
    residual : ndarray (c, n)
        The residuals times their weights.
    """

    data: RowsToFit
    theta: Array
    coefficients: Array
    residual: Array

    @cached_property
    def covariance(self) -> Array:
        """The covariance of theta and of the coefficients of each column, without the factor s^2."""
        return _covariance(self.data, self.theta, self.coefficients)

    @property
    def freedom(self) -> int:
        """The degrees of freedom."""
        return int(self.residual.size - len(self.theta) - self.coefficients.size)

    @property
    def variance(self) -> float:
        """s^2, the mean square of a residual."""
        return float(np.sum(self.residual**2)) / self.freedom

    @property
    def scatters(self) -> Array:
        """The standard deviation of each column's residuals, over its weights."""
        free = self.freedom / len(self.residual)
        return np.asarray(np.sqrt(np.sum(self.residual**2, axis=1) / free))

    @property
    def trend(self) -> float:
        """The slope of a straight line in the residuals, in standard errors, the largest of the columns."""
        if self.data.powers > 1:
            return 0.0
        scores = []
        for r, one, w in zip(self.residual, self.coefficients, self.data.W, strict=True):
            basis = np.column_stack([damped_basis(self.theta, self.data.t, 1), _slopes(self.theta, self.data.t, one)])
            Q = np.linalg.qr(basis * w[:, None])[0]
            line = self.data.t * w
            line = line - Q @ (Q.T @ line)
            scores.append(float(line @ r) / math.sqrt(float(line @ line) * self.variance))
        return max(scores, key=abs)

    @property
    def correlation(self) -> float:
        """The correlation of residuals from row to row, in standard errors, the largest of the columns."""
        sums = np.sum(self.residual[:, 1:] * self.residual[:, :-1], axis=1) / np.sum(self.residual**2, axis=1)
        return float(max(sums, key=abs)) * math.sqrt(self.residual.shape[1])

    @property
    def strength(self) -> float:
        """The sum of squares of the motion over 4 s^2, of the weaker mode."""
        parts = []
        for j in range(len(self.theta) // 2):
            basis = damped_basis(self.theta[2 * j : 2 * j + 2], self.data.t, 0)
            swing = self.coefficients[:, 2 * j : 2 * j + 2] @ basis.T * self.data.W
            parts.append(float(np.sum(swing**2)) / (4 * self.variance))
        return min(parts)

    @property
    def inflation(self) -> float:
        """The factor of errors of correlated residuals: the root of their power near the frequencies over the mean."""
        step = 2 * math.pi / self.data.t[-1]
        near = np.concatenate([w + step * np.array([-6, -5, -4, -3, 3, 4, 5, 6]) for w in self.theta[::2]])
        turned = np.exp(1j * np.outer(near[near > 0], self.data.t))
        power = np.abs(self.residual @ turned.T) ** 2 / np.sum(self.residual**2, axis=1, keepdims=True)
        return math.sqrt(max(1.0, float(np.mean(power))))


def fitted(data: RowsToFit, modes: int, start: Array | None = None) -> LeastSquares:
    """Return the least squares from the best of all starts.

    Columns are weighted by their scatters if these differ by more than chance and no standard deviations are known.

    Parameters
    ----------
    data : RowsToFit
        The rows.
    modes : int
        The number of frequencies.
    start : ndarray (2 modes,) or None
        The theta from which the search begins; None to find starts in the rows.

    Returns
    -------
    LeastSquares
        The best parameters and the residuals.

    Raises
    ------
    LinAlgError
        If no search ends.
    """
    starts = [start] if start is not None else _starts(data, modes)
    rough = [found for one in starts for found in _attempted(data, one)]
    if not rough:
        raise np.linalg.LinAlgError
    found = _searched(data, min(rough, key=lambda one: float(np.sum(one.residual**2))).theta)
    for _ in range(0 if data.known else 2):
        scatters = found.scatters
        room = SIGNIFICANT / math.sqrt(found.residual.shape[1])
        if not scatters.all() or np.ptp(np.log(scatters)) < room:
            break
        found = _searched(replace(data, W=data.W / scatters[:, None]), found.theta)
        data = found.data
    return found


def _attempted(data: RowsToFit, start: Array) -> list[LeastSquares]:
    """Search roughly; return None if the search diverges."""
    try:
        return [_searched(data, start, _ROUGH)]
    except np.linalg.LinAlgError:
        return []


def _searched(data: RowsToFit, start: Array, error: float = _CLOSE) -> LeastSquares:
    """The minimum near a start, in a time that goes from 0 to 1; last steps by Gauss and Newton, to all its digits."""
    from scipy.optimize import least_squares

    T = float(data.t[-1])
    scaled = replace(data, t=data.t / T)

    @lru_cache(1)
    def parts(buffer: bytes) -> tuple[Array, Array]:
        residuals, slopes, _ = zip(*_projected(scaled, np.frombuffer(buffer)), strict=True)
        return np.concatenate(residuals), np.vstack(slopes)

    with np.errstate(over="ignore", invalid="ignore"):
        theta = least_squares(
            lambda theta: parts(theta.tobytes())[0], start * T, jac=lambda theta: parts(theta.tobytes())[1],
            method="lm", xtol=error, ftol=error, gtol=error, max_nfev=_MOST_STEPS,
        ).x  # fmt: skip
        for _ in range(0 if error > _CLOSE else _LAST_STEPS):
            r, J = parts(theta.tobytes())
            if not np.isfinite(r).all():
                break
            theta = theta - np.linalg.lstsq(J, r, rcond=None)[0]
        if not np.isfinite(np.concatenate([r for r, _, _ in _projected(scaled, theta)])).all():
            raise np.linalg.LinAlgError
    theta = theta / T
    theta[::2] = np.abs(theta[::2])
    theta = theta.reshape(-1, 2)[np.argsort(theta[::2])].ravel()
    found = _projected(data, theta)
    coefficients = np.array([one for _, _, one in found])
    return LeastSquares(data=data, theta=theta, coefficients=coefficients, residual=np.array([r for r, _, _ in found]))


def _projected(data: RowsToFit, theta: Array) -> list[tuple[Array, Array, Array]]:
    """The residuals of each column, Kaufman's Jacobian, and the linear coefficients."""
    basis, parts = damped_basis(theta, data.t, data.powers), []
    if not np.isfinite(basis).all():  # the search has diverged; LAPACK would print an error
        return [(y * math.nan, np.zeros((y.size, len(theta))), np.zeros(basis.shape[1])) for y in data.Y]
    for y, w in zip(data.Y, data.W, strict=True):
        Q, R = np.linalg.qr(basis * w[:, None])
        known = Q.T @ (y * w)
        one = np.linalg.lstsq(R, known, rcond=None)[0]
        D = _slopes(theta, data.t, one) * w[:, None]
        parts.append((y * w - Q @ known, -(D - Q @ (Q.T @ D)), one))
    return parts


def _covariance(data: RowsToFit, theta: Array, coefficients: Array) -> Array:
    """(F^T F)^-1 of the full Jacobian F: theta, then the coefficients of each column."""
    n, few, many = data.t.size, len(theta), coefficients.shape[1]
    F = np.zeros((n * len(coefficients), few + coefficients.size))
    basis = damped_basis(theta, data.t, data.powers)
    for i, (one, w) in enumerate(zip(coefficients, data.W, strict=True)):
        rows = slice(i * n, (i + 1) * n)
        F[rows, :few] = _slopes(theta, data.t, one) * w[:, None]
        F[rows, few + many * i : few + many * (i + 1)] = basis * w[:, None]
    size = np.linalg.norm(F, axis=0)
    if not size.all():
        raise ValueError("a part of the motion is 0 in all rows: fewer modes are needed")
    _, s, V = np.linalg.svd(np.linalg.qr(F / size, mode="r"))
    if s[-1] < 1e-13 * s[0]:
        raise np.linalg.LinAlgError
    return np.asarray((V.T / s**2) @ V / np.outer(size, size))


def damped_basis(theta: Array, t: Array, powers: int) -> Array:
    """Return the functions whose sum is fitted, as columns.

    Parameters
    ----------
    theta : ndarray (2 modes,)
        omega in rad/s and decay in 1/s of each mode, one after the other.
    t : ndarray (n,)
        Times in s.
    powers : int
        The number of powers of t, from 1 on.

    Returns
    -------
    ndarray (n, 2 modes + powers)
        e^(-a t) cos(omega t) and e^(-a t) sin(omega t) of each mode, then the powers.
    """
    columns = []
    for w, a in zip(theta[::2], theta[1::2], strict=True):
        decay = np.exp(-a * t)
        columns += [decay * np.cos(w * t), decay * np.sin(w * t)]
    return np.column_stack([*columns, *(t**i for i in range(powers))])


def _slopes(theta: Array, t: Array, one: Array) -> Array:
    """Rates of change of the fitted column with omega and decay of each mode."""
    basis, columns = damped_basis(theta, t, 0), []
    for j in range(len(theta) // 2):
        cosine, sine = basis[:, 2 * j], basis[:, 2 * j + 1]
        C, S = one[2 * j : 2 * j + 2]
        columns += [t * (S * cosine - C * sine), -t * (C * cosine + S * sine)]
    return np.column_stack(columns)


def _starts(data: RowsToFit, modes: int) -> list[Array]:
    """Starting values of the search."""
    first = _peak_start(data, data.Y)
    if modes == 1:
        return [first]
    starts = [np.concatenate([one.theta, _peak_start(data, one.residual / data.W)]) for one in _attempted(data, first)]
    poles = _pencil(data, 2 * modes + 1)
    upper = sorted((p for p in poles if p.imag > 1e-6 / data.t[-1]), key=lambda p: -p.real)[:modes]
    if len(upper) == modes:
        starts.append(np.array([part for p in upper for part in (p.imag, -p.real)]))
    return starts


def _peak_start(data: RowsToFit, Y: Array) -> Array:
    """The peak of the spectrum of all columns, and the best of a few frequencies and decays around it."""
    t, n, T = data.t, data.t.size, float(data.t[-1])
    Y = (Y - Y.mean(axis=1, keepdims=True)) * (data.W / np.linalg.norm(Y * data.W, axis=1, keepdims=True))
    if data.step:
        power, span = np.abs(np.fft.rfft(Y, 8 * n)) ** 2, 8 * n * data.step
    else:
        place = np.minimum((t / T * 8 * n).astype(int), 8 * n - 1)
        bins = np.array([np.bincount(place, y, 8 * n) for y in Y])
        power, span = np.abs(np.fft.rfft(bins, 32 * n)) ** 2, 4 * T
        power = power[:, : 4 * n]
    w = 2 * math.pi * max(int(np.argmax(power.sum(axis=0))), 1) / span
    tries = [np.array([w * f, d / T]) for f in (0.8, 1, 1.25) for d in (0, 1, 3, 8)]

    def cost(one: Array) -> float:
        Q = np.linalg.qr(damped_basis(one, t, 1))[0]
        return float(np.sum((Y - (Y @ Q) @ Q.T) ** 2))

    return min(tries, key=cost)


def _pencil(data: RowsToFit, order: int) -> NDArray[np.complex128]:
    """Exponents of all columns together by a matrix pencil, from means of blocks of rows; the offset is one, near 0."""
    from scipy.linalg import hankel

    n = min(data.t.size, _MOST_ROWS)
    size = data.t.size // n
    T = float(data.t[-1])
    Y = data.Y if data.step else np.array([np.interp(np.linspace(0, T, data.t.size), data.t, y) for y in data.Y])
    step, n = T / (data.t.size - 1) * size, data.t.size // size
    Y = Y[:, : n * size].reshape(len(Y), n, size).mean(axis=2)
    H = np.hstack([hankel(y[: n // 2 + 1], y[n // 2 :]) for y in Y / Y.std(axis=1, keepdims=True)])
    W = np.linalg.svd(H, full_matrices=False)[0][:, :order]
    eigenvalues = np.linalg.eigvals(np.linalg.lstsq(W[:-1], W[1:], rcond=None)[0]).astype(complex)
    return np.asarray(np.log(eigenvalues[eigenvalues != 0]) / step)


def _piled(y: Array) -> float:
    """The largest value if rows pile up at it as at the limit of a sensor, not as at a turn of a rounded number."""
    values, counts = np.unique(y, return_counts=True)
    top = counts[-1]
    return float(values[-1]) if top >= 4 and top >= 4 * counts[-2] else math.inf

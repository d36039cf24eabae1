"""Damped sinusoids fitted to measured columns by variable projection.

    y = b + sum_j e^(-a_j t) (C_j cos omega_j t + S_j sin omega_j t) + noise,   t counted from the first row

omega_j and a_j are common to all columns; C_j, S_j and b belong to each. For given omega_j, a_j the rest is linear and
solved by QR, so only 2 numbers a mode are sought by the method of Levenberg and Marquardt, with Kaufman's Jacobian. The
search begins at the peak of the spectrum, of two modes also at the poles of a matrix pencil. Standard errors come from
the full Jacobian and the scatter of the residuals, or from the standard deviations of the rows where these are given.

Columns whose scatters differ by more than chance are weighted by them. Rows at a limit of the sensor are left out, a
straight drift is fitted too, and errors grow with the power of correlated residuals near omega; `cautions` say so.

Sources: G. H. Golub, V. Pereyra, SIAM J. Numer. Anal. 10 (1973) 413; L. Kaufman, BIT 15 (1975) 49; Y. Hua,
T. K. Sarkar, IEEE Trans. Acoust. Speech Signal Process. 38 (1990) 814 (matrix pencil).
"""

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.precision.exact import Array
from physics.valid import doubles

MOST_SHARE = 0.1
"""Largest standard error of a frequency over itself; beyond it the numbers are not to be trusted."""
FEW_ROWS = 30
_EVEN = 0.05  # tolerance of a time step, because times in a file are rounded
_MOST_ROWS = 250  # largest number of rows for the matrix pencil, whose cost grows like its cube
_SIGNIFICANT = 4.0  # standard deviations: by chance in 1 of 16,000
_WEAK = 25.0  # sum of squares of the motion over 4 sigma^2: below it a wrong peak is taken in 0.3 % or more
_ROUNDS = 8
_ROUGH, _CLOSE = 1e-6, 1e-10  # relative errors of a search
_MOST_STEPS, _LAST_STEPS = 200, 3


Bools = NDArray[np.bool_]


class Caution(StrEnum):
    """Limits of a fit that its reader has to know."""

    FEW_ROWS = "few_rows"  # fewer than 30
    CLIPPED = "clipped"  # rows at a limit of the sensor were left out
    DRIFT = "drift"  # a straight line was fitted too
    CORRELATED = "correlated"  # residuals are not random: another mode, or friction that is not viscous
    WEAK = "weak"  # the noise may have chosen the frequency


@dataclass(frozen=True, eq=False, kw_only=True)
class DampedFit:
    """A fit of `modes` damped sinusoids, slowest first, to c columns of n rows.

    `omega` in rad/s and `decay` in 1/s are (modes,), C and S (c, modes), `offset` and `drift` (per s) (c,), with
    standard errors; C and S are those at the first row, `t_first`, in the units of the columns. `used` (n,) are the
    rows that were fitted, `residual` (c, n) has every row, NaN in a hole, and `scatter` (c,) its deviation,
    counted in sigma if sigma was given; then `chi_square` is expected to be `freedom` +- sqrt(2 freedom). `aliases`
    are the frequencies that fit evenly spaced rows equally well. `covariance` is that of omega and decay of each mode,
    followed by C and S of each mode, the offset and the drift, if there is one, of each column.
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
        """The fitted columns (c, n) at the times t (n,) in s."""
        t = np.asarray(t, dtype=float) - self.t_first
        basis = _basis(np.ravel([self.omega, self.decay], "F"), t, 2)
        parts = np.stack([self.C, self.S], axis=2).reshape(len(self.C), -1)
        return np.asarray(np.column_stack([parts, self.offset, self.drift]) @ basis.T)


def fit_damped(t: ArrayLike, columns: ArrayLike, modes: int = 1, sigma: ArrayLike | None = None) -> DampedFit:
    """Fit one or two damped sinusoids and an offset to columns (n,) or (c, n) at the times t (n,) in s.

    `sigma` are standard deviations of the rows, in the shape of the columns, if they are known. Rows with holes (NaN)
    are left out. ValueError says why nothing can be fitted: too few rows, nothing that varies, or a frequency known
    to less than a tenth.
    """
    if modes not in (1, 2):
        raise ValueError(f"modes = {modes!r}: one or two frequencies are allowed")
    try:
        return _careful(_Data.of(t, columns, sigma, modes), modes)
    except np.linalg.LinAlgError:
        raise ValueError(
            "the rows do not tell the frequencies: a longer record, a quieter one or fewer modes are needed"
        ) from None


@dataclass(frozen=True, eq=False, kw_only=True)
class _Data:
    """Rows to fit: times t (n,) from the first one on, columns Y and weights W (c, n), and where they come from.

    `every` are the times of all rows and `rows` the places of these among them; `powers` is 2 if a drift is fitted too.
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
    def of(cls, t: ArrayLike, columns: ArrayLike, sigma: ArrayLike | None, modes: int) -> "_Data":
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

    def only(self, kept: Bools) -> "_Data":
        """These rows only; the first one remains where time is counted from."""
        return replace(self, t=self.t[kept], Y=self.Y[:, kept], W=self.W[:, kept], rows=self.rows[kept])


@dataclass(frozen=True, eq=False, kw_only=True)
class _Found:
    """The least squares: theta (omega, decay, omega, ..), linear coefficients (c, 2 modes + powers), residuals (c, n)
    times their weights; `covariance` is of all parameters, without the factor s^2."""

    data: _Data
    theta: Array
    coefficients: Array
    residual: Array

    @cached_property
    def covariance(self) -> Array:
        return _covariance(self.data, self.theta, self.coefficients)

    @property
    def freedom(self) -> int:
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
            basis = np.column_stack([_basis(self.theta, self.data.t, 1), _slopes(self.theta, self.data.t, one)])
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
            basis = _basis(self.theta[2 * j : 2 * j + 2], self.data.t, 0)
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


def _careful(data: _Data, modes: int) -> DampedFit:
    """A fit, and another one where the first shows a limit of the sensor or a drift."""
    found = _fitted(data, modes)
    cautions = [Caution.FEW_ROWS] if len(data.t) < FEW_ROWS else []
    limits = data.limits
    if np.isfinite(limits).any():
        data, found = _without_clipped(data, found, limits)
        cautions.append(Caution.CLIPPED)
    if abs(found.trend) > _SIGNIFICANT:
        data = replace(data, powers=2)
        found = _fitted(data, modes, found.theta)
        cautions.append(Caution.DRIFT)
    if abs(found.correlation) > _SIGNIFICANT:
        cautions.append(Caution.CORRELATED)
    if found.strength < _WEAK:
        cautions.append(Caution.WEAK)
    return _told(data, found, tuple(cautions))


def _fitted(data: _Data, modes: int, start: Array | None = None) -> _Found:
    """The least squares from the best of all starts; columns are weighted by their scatters if these differ."""
    starts = [start] if start is not None else _starts(data, modes)
    rough = [found for one in starts for found in _attempted(data, one)]
    if not rough:
        raise np.linalg.LinAlgError
    found = _searched(data, min(rough, key=lambda one: float(np.sum(one.residual**2))).theta)
    for _ in range(0 if data.known else 2):
        scatters = found.scatters
        room = _SIGNIFICANT / math.sqrt(found.residual.shape[1])
        if not scatters.all() or np.ptp(np.log(scatters)) < room:
            break
        found = _searched(replace(data, W=data.W / scatters[:, None]), found.theta)
        data = found.data
    return found


def _attempted(data: _Data, start: Array) -> list[_Found]:
    """Search roughly; return None if the search diverges."""
    try:
        return [_searched(data, start, _ROUGH)]
    except np.linalg.LinAlgError:
        return []


def _searched(data: _Data, start: Array, error: float = _CLOSE) -> _Found:
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
    return _Found(data=data, theta=theta, coefficients=coefficients, residual=np.array([r for r, _, _ in found]))


def _projected(data: _Data, theta: Array) -> list[tuple[Array, Array, Array]]:
    """The residuals of each column, Kaufman's Jacobian, and the linear coefficients."""
    basis, parts = _basis(theta, data.t, data.powers), []
    if not np.isfinite(basis).all():  # the search has diverged; LAPACK would print an error
        return [(y * math.nan, np.zeros((y.size, len(theta))), np.zeros(basis.shape[1])) for y in data.Y]
    for y, w in zip(data.Y, data.W, strict=True):
        Q, R = np.linalg.qr(basis * w[:, None])
        known = Q.T @ (y * w)
        one = np.linalg.lstsq(R, known, rcond=None)[0]
        D = _slopes(theta, data.t, one) * w[:, None]
        parts.append((y * w - Q @ known, -(D - Q @ (Q.T @ D)), one))
    return parts


def _covariance(data: _Data, theta: Array, coefficients: Array) -> Array:
    """(F^T F)^-1 of the full Jacobian F: theta, then the coefficients of each column."""
    n, few, many = data.t.size, len(theta), coefficients.shape[1]
    F = np.zeros((n * len(coefficients), few + coefficients.size))
    basis = _basis(theta, data.t, data.powers)
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


def _basis(theta: Array, t: Array, powers: int) -> Array:
    """e^(-a t) cos omega t and e^(-a t) sin omega t of each mode, then so many powers of t from 1 on."""
    columns = []
    for w, a in zip(theta[::2], theta[1::2], strict=True):
        decay = np.exp(-a * t)
        columns += [decay * np.cos(w * t), decay * np.sin(w * t)]
    return np.column_stack([*columns, *(t**i for i in range(powers))])


def _slopes(theta: Array, t: Array, one: Array) -> Array:
    """Rates of change of the fitted column with omega and decay of each mode."""
    basis, columns = _basis(theta, t, 0), []
    for j in range(len(theta) // 2):
        cosine, sine = basis[:, 2 * j], basis[:, 2 * j + 1]
        C, S = one[2 * j : 2 * j + 2]
        columns += [t * (S * cosine - C * sine), -t * (C * cosine + S * sine)]
    return np.column_stack(columns)


def _starts(data: _Data, modes: int) -> list[Array]:
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


def _peak_start(data: _Data, Y: Array) -> Array:
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
        Q = np.linalg.qr(_basis(one, t, 1))[0]
        return float(np.sum((Y - (Y @ Q) @ Q.T) ** 2))

    return min(tries, key=cost)


def _pencil(data: _Data, order: int) -> NDArray[np.complex128]:
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


def _without_clipped(data: _Data, found: _Found, limits: list[tuple[float, float]]) -> tuple[_Data, _Found]:
    """The rows whose fit stays within the limits, and their fit: the fit decides, as the noise decides of rows."""
    before, rows = data, data.rows
    for _ in range(_ROUNDS):
        kept = _below_limits(before, found, limits)
        if kept.sum() < 4 * len(found.theta):
            raise ValueError(
                "The rows are mostly at a limit of the sensor: a smaller motion or a wider range is needed"
            )
        data = before.only(kept)
        found = _fitted(data, len(found.theta) // 2, found.theta)
        if np.array_equal(rows, data.rows):
            break
        rows = data.rows
    return data, found


def _below_limits(data: _Data, found: _Found, limits: list[tuple[float, float]]) -> Bools:
    """The rows at which the fitted columns stay below the limits by twice their scatter."""
    swing = found.coefficients @ _basis(found.theta, data.t, data.powers).T
    room = 2 * math.sqrt(found.variance) / found.data.W.mean(axis=1, keepdims=True)
    low, high = np.array(limits).T[..., None]
    return np.asarray(np.all((swing > low + room) & (swing < high - room), axis=0))


def _told(data: _Data, found: _Found, cautions: tuple[Caution, ...]) -> DampedFit:
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

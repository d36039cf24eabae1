"""A visitor's measured record: the pieces that the browser sends, and the fit of a motion to them."""

from __future__ import annotations

import math
from array import array
from itertools import pairwise

import numpy as np
from msgspec import Struct

from components.language.messages import Fitted, FittedColumn, FittedMotion, SendRows
from components.session.fit_texts import on_residuals, one_mass, two_masses
from physics.fit import DampedFit, fit_damped
from physics.means import before_means

UNEQUAL = "A record has as many times as displacements, in the same columns in all pieces."
TIME_GOES_BACK = "The times of a record never decrease."
EXTREME = "No motion can be fitted: numbers near 1, in units that suit the motion, are needed."


class Fitting(Struct, frozen=True, tag=True):
    """The job to fit a motion to columns, with as many frequencies as columns. `derivative` is the order of the
    derivative that was measured; each row is the mean of `size` rows of a file."""

    t: list[float]
    columns: list[list[float]]
    size: int
    derivative: int


class MeasuredRows:
    """The rows of a record that have arrived so far."""

    def __init__(self) -> None:
        self.next = 0
        """The number of the next piece."""
        self._t = array("d")
        self._columns: tuple[array[float], ...] = ()

    def take(self, message: SendRows) -> Fitting | None:
        """Add a piece; return the job with the last one. Raises ValueError for invalid rows. Pieces out of order are
        ignored, except piece 0, which starts again.
        """
        if message.piece == 0:
            self._clear()
        if message.piece != self.next:
            return None
        last = self._t[-1:]
        self._add(message)
        if any(later < earlier for earlier, later in pairwise([*last, *message.t])):
            self._clear()
            raise ValueError(TIME_GOES_BACK)
        if self.next < message.of:
            return None
        job = Fitting(self._t.tolist(), [column.tolist() for column in self._columns], message.size, message.derivative)
        self._clear()
        return job

    def _add(self, message: SendRows) -> None:
        self._columns = self._columns or tuple(array("d") for _ in message.columns)
        if len(message.columns) != len(self._columns) or {len(message.t)} != set(map(len, message.columns)):
            self._clear()
            raise ValueError(UNEQUAL)
        self._t.extend(message.t)
        for column, rows in zip(self._columns, message.columns, strict=True):
            column.extend(rows)
        self.next += 1

    def _clear(self) -> None:
        self.next, self._t, self._columns = 0, array("d"), ()


def fitted(job: Fitting) -> Fitted:
    """Return the fit of a record. Raises ValueError, with a reason, if there is none."""
    modes = len(job.columns)
    try:
        with np.errstate(divide="raise", over="raise", invalid="raise"):
            fit = fit_damped(job.t, job.columns, modes)
            motion = _motion(fit, job)
            described = (one_mass if modes == 1 else two_masses)(fit, motion, job.derivative)
    except ValueError as reason:
        raise ValueError(f"No motion can be fitted: {reason}.") from reason
    except ArithmeticError as error:
        raise ValueError(EXTREME) from error
    numbers, parameters, sentences = described
    sentences = (*on_residuals(job.t, fit), *sentences)
    return Fitted(motion=motion, parameters=parameters, numbers=numbers, sentences=sentences)


def _motion(fit: DampedFit, job: Fitting) -> FittedMotion:
    """Return the motion of the displacements, from a fit to means of rows of a derivative."""
    step = (job.t[-1] - job.t[0]) / (len(job.t) - 1) / job.size
    exponents = (-fit.decay + 1j * fit.omega).tolist()
    columns = []
    for Z, offset, drift, scatter in zip(fit.C - 1j * fit.S, fit.offset, fit.drift, fit.scatter, strict=True):
        parts = [
            before_means(z, p, step, job.size) / p**job.derivative for z, p in zip(Z.tolist(), exponents, strict=True)
        ]
        columns.append(
            FittedColumn(
                C=tuple(part.real for part in parts),
                S=tuple(-part.imag for part in parts),
                offset=float(offset),
                drift=float(drift),
                scatter=float(scatter) * math.sqrt(job.size),
            )
        )
    return FittedMotion(omega=tuple(fit.omega.tolist()), decay=tuple(fit.decay.tolist()), columns=tuple(columns))

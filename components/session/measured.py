"""A visitor's measured record: the pieces that the browser sends, and the fit of a damped motion to them."""

from __future__ import annotations

import math
from array import array
from itertools import pairwise

import numpy as np
from msgspec import Struct

from components.language.messages import Fitted, FittedMotion, FittedNumber, SendRows
from components.quantities.formatting import three, with_error
from physics.fit import Caution, DampedFit, fit_damped
from physics.means import before_means

FEW_IN_A_CYCLE = 4.0
"""Rows in a cycle from which on no other frequency is likely."""
UNEQUAL = "A record has as many times as displacements."
TIME_GOES_BACK = "The times of a record never decrease."
UNITS = ("m", "m/s", "m/s²")
"""The units of a displacement and of its derivatives."""
EXTREME = "No motion can be fitted: numbers near 1, in units that suit the motion, are needed."
RANDOM = "The residuals of the fit are random: the model agrees with your points within their scatter."
SENTENCES = {
    Caution.CORRELATED: "The residuals of the fit are not random: the friction is not viscous, or something else "
    "moves too. The standard errors allow for this.",
    Caution.DRIFT: "The points drift: the fit includes a straight line.",
    Caution.CLIPPED: "Some points are at a limit of the sensor: the fit leaves them out.",
    Caution.FEW_ROWS: "The file has fewer than 30 points: the standard errors are rough.",
    Caution.WEAK: "The scatter is nearly as large as the motion: the frequency may be wrong.",
}


class Fitting(Struct, frozen=True, tag=True):
    """The job to fit a damped motion to rows of a derivative of it, each the mean of `size` rows of a file."""

    t: list[float]
    x: list[float]
    size: int
    derivative: int


class MeasuredRows:
    """The rows of a record that have arrived so far."""

    def __init__(self) -> None:
        self.next = 0
        """The piece that is needed next."""
        self._t, self._x = array("d"), array("d")

    def take(self, message: SendRows) -> Fitting | None:
        """Add a piece; return the job with the last one. Raises ValueError for rows that are no record.

        A piece other than the next one is left out, except for piece 0, which begins again.
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
        job = Fitting(self._t.tolist(), self._x.tolist(), message.size, message.derivative)
        self._clear()
        return job

    def _add(self, message: SendRows) -> None:
        if len(message.t) != len(message.x):
            self._clear()
            raise ValueError(UNEQUAL)
        self._t.extend(message.t)
        self._x.extend(message.x)
        self.next += 1

    def _clear(self) -> None:
        self.next, self._t, self._x = 0, array("d"), array("d")


def fitted(job: Fitting) -> Fitted:
    """Return the fit of a record. Raises ValueError, in words, if there is none."""
    try:
        with np.errstate(divide="raise", over="raise", invalid="raise"):
            fit = fit_damped(job.t, job.x)
    except ValueError as reason:
        raise ValueError(f"No motion can be fitted: {reason}.") from reason
    except ArithmeticError as error:
        raise ValueError(EXTREME) from error
    omega, decay = float(fit.omega[0]), float(fit.decay[0])
    step = (job.t[-1] - job.t[0]) / (len(job.t) - 1) / job.size
    exponent = complex(-decay, omega)
    amplitude = before_means(complex(fit.C[0, 0], -fit.S[0, 0]), exponent, step, job.size) / exponent**job.derivative
    motion = FittedMotion(
        omega=omega,
        decay=decay,
        C=amplitude.real,
        S=-amplitude.imag,
        offset=float(fit.offset[0]),
        drift=float(fit.drift[0]),
        scatter=float(fit.scatter[0]) * math.sqrt(job.size),
    )
    return Fitted(motion=motion, numbers=_numbers(fit, motion, job.derivative), sentences=_sentences(fit))


def _numbers(fit: DampedFit, motion: FittedMotion, derivative: int) -> tuple[FittedNumber, ...]:
    omega, decay, C, unit = motion.omega, motion.decay, math.hypot(motion.C, motion.S), UNITS[derivative]
    natural = math.hypot(omega, decay)
    se_natural = math.hypot(omega * fit.se_omega[0], decay * fit.se_decay[0]) / natural
    se_C = C * math.hypot(fit.se_amplitude[0, 0] / fit.amplitude[0, 0], derivative * se_natural / natural)
    rows = (
        ("<i>ω</i><sub>n</sub>", "natural frequency", natural, se_natural, "rad/s"),
        ("<i>ζ</i>", "damping ratio", fit.zeta[0], fit.se_zeta[0], ""),
        ("<i>C</i>", "amplitude at the start", C, se_C, "m"),
        ("<i>φ</i>", "phase at the start", math.atan2(motion.C, motion.S), fit.se_phase[0, 0], "rad"),
        ("offset", "offset", motion.offset, fit.se_offset[0], unit),
    )
    numbers = [_number(symbol, name, *with_error(float(value), float(se)), si) for symbol, name, value, se, si in rows]
    scatter = _number("<i>σ</i>", "standard deviation of the residuals", three(motion.scatter), "", unit)
    return (*numbers, scatter)


def _number(symbol: str, name: str, value: str, error: str, unit: str) -> FittedNumber:
    return FittedNumber(symbol=symbol, name=name, value=value, error=error, unit=unit)


def _sentences(fit: DampedFit) -> tuple[str, ...]:
    """The sentences on the residuals, the most important one first, and on what else a reader has to know."""
    cautions = [text for caution, text in SENTENCES.items() if caution in fit.cautions]
    found = cautions if Caution.CORRELATED in fit.cautions else [RANDOM, *cautions]
    aliases = [alias for alias in fit.aliases if alias + fit.omega[0] < FEW_IN_A_CYCLE * fit.omega[0]]
    return (*found, *(f"Rows so far apart fit {three(alias)} rad/s equally well." for alias in aliases))

"""Builders of signals: a few coefficients for each, which the browser evaluates sixty times a second.

Times are in the unit of the time axis (10**exponent seconds), from the start of the window; amplitudes are in the unit
of the signal's own axis. The coefficients are therefore of order one for all parameters.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal

import numpy as np
from numpy.typing import NDArray

from components.language.expressions import Expression, Name, Number, Product, as_expression
from components.language.picture import Pace
from components.language.signals import (
    AnySignal,
    CosineOf,
    DampedMass,
    Derived,
    DrivenMass,
    Modal,
    Response,
    Responses,
    Sampled,
    Sine,
    SineOf,
    Sines,
)
from components.quantities.axes import Axis
from physics.chain import DrawnModes, UniformChain
from physics.damped import Decay, Fading
from physics.driven import Push
from physics.motion import Harmonic, SampledCycle
from physics.valid import DOUBLES

QUARTER = math.pi / 2
"""The phase by which a cosine is ahead of a sine."""
LEAST_SHARE = 2.0**-53
"""Fraction of a chain's largest coordinate; smaller coordinates are rounding errors."""


def scaled(exponent: int, *factors: float | Decimal) -> float:
    """Return the product of the factors divided by 10**exponent, even if intermediate products leave the range of
    doubles.
    """
    others = [factor for factor in factors if factor != 1]
    if not exponent and len(others) <= 1:  # a fast path for most pictures
        result = float(*others) if others else 1.0
    else:
        result = float(math.prod(map(Decimal, others), start=Decimal(1).scaleb(-exponent)))
    if math.isinf(result):
        raise ValueError(f"the motion does not fit this time window: its numbers leave {DOUBLES}")
    return result


_Term = tuple[float, float, float] | tuple[float, float, float, float] | tuple[float, float, float, float, float]


def sines(size: Axis, time: Axis, *terms: _Term, line: tuple[float, float] = (0, 0)) -> Sines:
    """a + b t + sum of (A + B t) exp(-decay t) sin(omega t + phi), in SI units: line = (a, b), and each term is (A,
    omega, phi), (A, omega, phi, decay) or (A, omega, phi, decay, B)."""

    def sine(amplitude: float, omega: float, phase: float, decay: float = 0.0, slope: float = 0.0) -> Sine:
        return Sine(
            scaled(size.exponent, amplitude, 1 / size.factor),
            scaled(-time.exponent, omega),
            phase,
            decay and scaled(-time.exponent, decay),
            slope and scaled(size.exponent - time.exponent, slope, 1 / size.factor),
        )

    start, drift = line
    a, b = scaled(size.exponent, start, 1 / size.factor), scaled(size.exponent - time.exponent, drift, 1 / size.factor)
    return Sines(sines=tuple(sine(*term) for term in terms), line=(a, b))


def rates(size: Axis, time: Axis, *terms: tuple[float, float, float], drift: float = 0.0) -> Sines:
    """Return the rate of change of the same undamped motion, in the unit of `size` per unit of time."""
    unit = size.exponent - time.exponent
    found = [
        Sine(scaled(unit, amplitude, omega), scaled(-time.exponent, omega), phase + math.pi / 2)
        for amplitude, omega, phase in terms
    ]
    return Sines(sines=tuple(found), line=(scaled(unit, drift), 0.0))


def responses(size: Axis, time: Axis, *terms: tuple[float, float, float, float]) -> Responses:
    """Motion from rest under a drive: sum of F c g(t), g'' + omega_n^2 g = sin(omega t), from (F, c, omega, omega_n).

    F in N, c in 1/kg. It is regular at resonance and at omega_n = 0.
    """
    found = [
        Response(
            scaled(size.exponent - 2 * time.exponent, F, c),
            scaled(-time.exponent, omega),
            scaled(-time.exponent, omega_n),
        )
        for F, c, omega, omega_n in terms
    ]
    return Responses(responses=tuple(found))


def damped(size: Axis, time: Axis, fading: Fading) -> DampedMass:
    """Return the free motion of a damped mass, or its rate."""
    sized, rated = size.exponent, size.exponent - time.exponent
    return DampedMass(
        start=scaled(sized, fading.start, 1 / size.factor),
        rate=scaled(rated, fading.rate, 1 / size.factor),
        **{name: scaled(-time.exponent, getattr(fading, name)) for name in ("slow", "apart", "swing")},
        late=(scaled(sized, fading.late[0], 1 / size.factor), scaled(sized, fading.late[1], 1 / size.factor)),
    )


def driven(size: Axis, time: Axis, push: Push) -> DrivenMass:
    """Return the motion of a damped mass from rest under a drive."""
    sized, rates = size.exponent - 2 * time.exponent, push._asdict()
    re, im = rates.pop("re"), rates.pop("im")
    return DrivenMass(
        re=scaled(sized, re, 1 / size.factor),
        im=scaled(sized, im, 1 / size.factor),
        **{name: scaled(-time.exponent, rate) for name, rate in rates.items()},
    )


@dataclass(frozen=True, eq=False)
class ModalPlay:
    """The modes of a chain and the names for their signal: see `components.language.signals.Modal`.

    If `by` is not 0, all displacements are proportional to the scalar `of`, whose value is `by` in m.
    """

    modes: DrawnModes
    name: str
    at: str
    of: str
    by: float


def modal(size: Axis, time: Axis, play: ModalPlay) -> Modal:
    """The signal of a chain. Modes so small that they are rounding errors of the largest one are set to 0."""
    modes = play.modes
    sizes = np.where(modes.amplitude > LEAST_SHARE * modes.amplitude.max(), modes.amplitude, 0.0)
    unit = size.factor * 10.0**size.exponent
    return Modal(
        name=play.name, ends=modes.chain.ends, at=play.at, of=play.of, by=play.by / unit,
        omega=tuple((modes.chain.omega * 10.0**time.exponent).tolist()),
        sizes=tuple((sizes / unit).tolist()),
        phases=tuple(np.where(sizes > 0, modes.phase, 0.0).tolist()),
        line=(modes.drift[0] / unit, modes.drift[1] / unit * 10.0**time.exponent),
    )  # fmt: skip


def displacements(signal: Modal, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the displacements (n, N) of all masses of a chain at the times t (n,), without the drift's b t."""
    chain = UniformChain(N=len(signal.omega), m=1.0, k=1.0, ends=signal.ends)  # shapes do not depend on m and k
    coordinates = np.sin(np.outer(t, signal.omega) + signal.phases) * signal.sizes
    return np.asarray(coordinates @ chain.shapes + signal.line[0])


def played(numbers: object, size: Axis, time: Axis) -> AnySignal:
    """Return the signal that plays an elementary motion, from its numbers."""
    match numbers:
        case Harmonic(sinusoids, line):
            return sines(size, time, *sinusoids, line=line)
        case Fading():
            return damped(size, time, numbers)
        case Decay(amplitude, slope, rate, omega, phase):
            return sines(size, time, (amplitude, omega, phase, rate, slope))
        case Push():
            return driven(size, time, numbers)
        case ModalPlay():
            return modal(size, time, numbers)
        case SampledCycle(period, values, rates):
            return sampled(time, period, size.places(values), size.places(rates))
    raise TypeError(f"{type(numbers).__name__} is not played by any signal")


def derived(expression: Number) -> Derived:
    """Return a signal that is a polynomial in earlier signals and in scalars."""
    return Derived(value=as_expression(expression))


def sine_of(angle: Name) -> SineOf:
    """Return the sine of an earlier signal in rad, for rotations."""
    return SineOf(of=angle.name)


def cosine_of(angle: Name) -> CosineOf:
    """Return the cosine of an earlier signal in rad."""
    return CosineOf(of=angle.name)


def total(*signals: Name) -> Derived:
    """Return the sum of earlier signals."""
    return Derived(value=Expression(tuple(Product(1.0, (one.name,)) for one in signals)))


def sampled(
    time: Axis, period: float, columns: NDArray[np.float64], slopes: NDArray[np.float64], drift: float = 0.0
) -> Sampled:
    """A periodic motion from equally spaced samples of one period, with Hermite interpolation. It gains `drift` each
    period.

    `columns` and `drift` are in the signal's unit, `slopes` in that unit per second.
    """
    unit = 10.0**time.exponent
    return Sampled(
        period=period / unit,
        y=tuple(columns.tolist()),
        dy=tuple((slopes * unit).tolist()),
        drift=drift,
    )


FLASHES = 6.0
"""Cycles per second that the eye can follow."""
MOST = 1e308
"""The largest number of seconds that is a double."""


def pace(omega: float, fastest: float) -> Pace:
    """Return the speeds of the clock: at `auto` a period of `omega` takes 4 to 10 s.

    `limit` is the highest speed at which a motion of the frequency `fastest` can be seen. Both frequencies are in
    rad/s; if `omega` is 0, `auto` is real time.
    """
    if not omega:
        return Pace()
    period, limit = (min(count * 2 * math.pi / float(w), MOST) for count, w in ((1, omega), (FLASHES, fastest)))
    return Pace(1.0 if 4 <= period <= 10 else round_down(period / 4), limit)


def round_up(value: float, digits: tuple[int, ...] = (1, 2, 5)) -> float:
    """Return the smallest of these digits (1 among them) times a power of ten that is not below `value`."""
    exponent = math.floor(math.log10(value))
    steps = [float(f"{digit}e{exponent}") for digit in digits] + [float(f"1e{exponent + 1}")]
    return min(step for step in steps if step >= value * (1 - 1e-9))


def round_down(value: float, digits: tuple[int, ...] = (1, 2, 5)) -> float:
    """Return the largest of these digits (1 among them) times a power of ten that is not above `value`."""
    exponent = math.floor(math.log10(value))
    steps = [float(f"{digit}e{exponent}") for digit in digits]
    return max(step for step in steps if step <= value * (1 + 1e-9))

"""Signals: numbers that move, a few scalars each, which the browser evaluates at any instant.

Times count in the unit of the time axis from the start of the window, sizes in the unit of the signal's own axis, so
what is sent is of order one. A signal may speak of the signals before it and of the picture's scalars.
"""

from __future__ import annotations

from typing import TypeAlias

from msgspec import Struct

from components.language.numbers import Expression


class Signal(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """Anything that has a number at every instant."""


class Sine(Struct, frozen=True, array_like=True):
    """(size + slope t) exp(-decay t) sin(omega t + phase); a plain exponential has omega = 0 and phase = pi/2."""

    size: float
    omega: float
    phase: float
    decay: float = 0.0
    slope: float = 0.0


class Sines(Signal, frozen=True, kw_only=True, tag="sines"):
    """a + b t and a sum of sines; line = (a, b)."""

    sines: tuple[Sine, ...]
    line: tuple[float, float] = (0.0, 0.0)


class Response(Struct, frozen=True, array_like=True):
    """size g(t), from rest, with g'' + omega_n^2 g = sin(omega t); regular at resonance and at omega_n = 0."""

    size: float
    omega: float
    omega_n: float


class Responses(Signal, frozen=True, kw_only=True, tag="responses"):
    """A sum of responses to a drive."""

    responses: tuple[Response, ...]


class DampedMass(Signal, frozen=True, kw_only=True, tag="damped"):
    """The free motion of a damped mass, or its rate: exp(-slow t) (start C + rate S).

    C = cos(swing t), S = sin(swing t)/swing where it swings; else C = 1, S = (1 - exp(-apart t))/apart, at critical
    damping t. Once apart t > 1 it is the sum of both exponentials, of the sizes `late`.
    """

    start: float
    rate: float
    slow: float
    apart: float = 0.0
    swing: float = 0.0
    late: tuple[float, float] = (0.0, 0.0)


class DrivenMass(Signal, frozen=True, kw_only=True, tag="driven"):
    """The motion of a damped mass from rest, Im((re + i im) E), E'' + (2 slow + apart) E' + omega_n^2 E = exp(i omega
    t): regular at resonance, at critical damping and without damping.

    `slow`, `apart` and `swing` are those of its free motion, `detuning` is omega - swing.
    """

    re: float
    im: float
    omega: float
    omega_n: float
    slow: float
    apart: float
    swing: float
    detuning: float


class Derived(Signal, frozen=True, kw_only=True, tag="derived"):
    """A polynomial in the signals before it."""

    value: Expression


class SineOf(Signal, frozen=True, kw_only=True, tag="sine"):
    """The sine of an angle in rad, a signal before it."""

    of: str


class CosineOf(Signal, frozen=True, kw_only=True, tag="cosine"):
    """The cosine of an angle in rad, a signal before it."""

    of: str


class Samples(Struct, frozen=True):
    """Numbers that follow their message: how many, the least and the greatest."""

    count: int
    low: float
    high: float


class Sampled(Signal, frozen=True, kw_only=True, tag="sampled"):
    """A periodic motion in equally spaced values and slopes over one period, joined by Hermite pieces; `drift` is
    gained each period."""

    period: float
    y: tuple[float, ...] | Samples
    dy: tuple[float, ...] | Samples
    drift: float = 0.0


AnySignal: TypeAlias = Sines | Responses | DampedMass | DrivenMass | Derived | SineOf | CosineOf | Sampled

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


AnySignal: TypeAlias = Sines | Responses | Derived | SineOf | CosineOf | Sampled

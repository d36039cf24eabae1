"""Signals as the browser plays them, in Python: evaluated from the message, for tests of scenes and of the scripts."""

from __future__ import annotations

import math
from functools import cache, singledispatch

import numpy as np
from numpy.typing import NDArray

from components.language.numbers import Expression, Number
from components.language.signals import (
    AnySignal,
    CosineOf,
    DampedMass,
    Derived,
    DrivenMass,
    Responses,
    Sampled,
    SineOf,
    Sines,
)
from components.scene import Picture

Floats = NDArray[np.float64]
Named = dict[str, Floats]


def played(picture: Picture, t: Floats | float) -> Named:
    """All signals, over the scalars, at times in the unit of the time axis."""
    times = np.asarray(t, dtype=float)
    named: Named = {**{name: np.asarray(value) for name, value in picture.scalars.items()}, "t": times}
    for name, signal in picture.signals.items():
        named[name] = value_of(signal, times, named)
    return named


def number(value: Number, named: Named) -> Floats:
    """A number of a shape."""
    if not isinstance(value, Expression):
        return np.asarray(value)
    return np.asarray(sum(term.factor * math.prod(named[name] for name in term.names) for term in value.terms))


@singledispatch
def value_of(signal: AnySignal, t: Floats, named: Named) -> Floats:
    raise TypeError(type(signal))


@value_of.register
def _(signal: Sines, t: Floats, named: Named) -> Floats:
    a, b = signal.line
    waves = ((s.size + s.slope * t) * np.exp(-s.decay * t) * np.sin(s.omega * t + s.phase) for s in signal.sines)
    return np.asarray(a + b * t + sum(waves))


@value_of.register
def _(signal: Derived, t: Floats, named: Named) -> Floats:
    return number(signal.value, named) + 0 * t


@value_of.register
def _(signal: SineOf, t: Floats, named: Named) -> Floats:
    return np.sin(named[signal.of])


@value_of.register
def _(signal: CosineOf, t: Floats, named: Named) -> Floats:
    return np.cos(named[signal.of])


@value_of.register
def _(signal: Sampled, t: Floats, named: Named) -> Floats:
    return hermite(signal, t)


@value_of.register
def _(signal: DampedMass, t: Floats, named: Named) -> Floats:
    return np.exp(-signal.slow * t) * (signal.start * np.cos(signal.swing * t) + signal.rate * _grown(signal, t))


def _grown(signal: DampedMass | DrivenMass, t: Floats) -> Floats:
    """The free motion from 0 with the velocity 1, without its decay."""
    if signal.swing:
        return np.asarray(np.sin(signal.swing * t) / signal.swing)
    return -np.expm1(-signal.apart * t) / signal.apart if signal.apart else np.asarray(t)


@value_of.register
def _(signal: DrivenMass, t: Floats, named: Named) -> Floats:
    """From rest, by the integral of the drive."""
    times, (nodes, weights) = np.atleast_1d(t), _nodes()
    total = np.zeros_like(times)
    for i, end in enumerate(times):
        s = end * (nodes + 1) / 2
        drive = signal.re * np.sin(signal.omega * s) + signal.im * np.cos(signal.omega * s)
        kernel = np.exp(-signal.slow * (end - s)) * _grown(signal, end - s)
        total[i] = end / 2 * np.sum(weights * drive * kernel)
    return total.reshape(np.shape(t))


@value_of.register
def _(signal: Responses, t: Floats, named: Named) -> Floats:
    """From rest, by the integral of the drive: independent of how the browser does it."""
    times = np.atleast_1d(t)
    total = np.zeros_like(times)
    nodes, weights = _nodes()
    for response in signal.responses:
        for i, end in enumerate(times):
            s = end * (nodes + 1) / 2
            lag = end - s
            kernel = np.sin(response.omega_n * lag) / response.omega_n if response.omega_n else lag
            total[i] += response.size * end / 2 * np.sum(weights * np.sin(response.omega * s) * kernel)
    return total.reshape(np.shape(t))


@cache
def _nodes() -> tuple[Floats, Floats]:
    return np.polynomial.legendre.leggauss(400)


def hermite(signal: Sampled, t: Floats | float) -> Floats:
    """The Hermite pieces of a sampled motion."""
    times = np.asarray(t, dtype=float)
    y, dy = np.array(signal.y), np.array(signal.dy)
    count = len(y) - 1
    turns = np.floor(times / signal.period)
    place = np.minimum((times / signal.period - turns) * count, count - 1e-9)
    i = np.floor(place).astype(int)
    u, h = place - i, signal.period / count
    a, b = (1 + 2 * u) * (1 - u) ** 2, u * (1 - u) ** 2
    c, d = u * u * (3 - 2 * u), u * u * (u - 1)
    return np.asarray(turns * signal.drift + a * y[i] + b * h * dy[i] + c * y[i + 1] + d * h * dy[i + 1])

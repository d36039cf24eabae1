"""The values of all signals at one instant, as static/core/signals.js computes them for each frame."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from components.language.expressions import Expression, Number
from components.language.signals import (
    AnySignal,
    CosineOf,
    DampedMass,
    Derived,
    DrivenMass,
    Modal,
    Responses,
    Sampled,
    SineOf,
    Sines,
)
from components.quantities.motion import displacements
from physics.driven import Push, from_rest


def number(value: Number, named: Mapping[str, float]) -> float:
    """Return a number of a shape or signal. Raises KeyError for a name that is not in `named`."""
    if not isinstance(value, Expression):
        return float(value)
    return math.fsum(one.factor * math.prod(named[name] for name in one.names) for one in value.terms)


def instant(signals: Mapping[str, AnySignal], scalars: Mapping[str, float], t: float = 0.0) -> dict[str, float]:
    """Return all signals at the instant `t`, in the unit of the time axis, and the scalars."""
    named = {**scalars, "t": t}
    for name, signal in signals.items():
        named[name] = _value(signal, named)
    return named


def _value(signal: AnySignal, named: dict[str, float]) -> float:
    """Return one signal. A chain also adds the displacements of all its masses, under their numbered names."""
    t = named["t"]
    match signal:
        case Sines(sines=terms, line=(a, b)):
            swings = ((s.size + s.slope * t) * _sin(s.omega * t + s.phase) * math.exp(-s.decay * t) for s in terms)
            return a + b * t + math.fsum(swings)
        case Responses(responses=terms):
            pushes = (Push(0.0, 0.0, r.omega, r.omega_n, 0.0, 0.0, r.omega_n, r.omega - r.omega_n) for r in terms)
            return math.fsum(r.size * _pushed(push, t).imag for r, push in zip(terms, pushes, strict=True))
        case DampedMass():
            return _damped(signal, t)
        case DrivenMass():
            found = _pushed(Push(*(getattr(signal, name) for name in Push._fields)), t)
            return signal.re * found.imag + signal.im * found.real
        case Modal():
            return _chain(signal, named)
        case Derived(value=value):
            return number(value, named)
        case SineOf(of=angle):
            return _sin(named[angle])
        case CosineOf(of=angle):
            return _sin(named[angle] + math.pi / 2)
        case Sampled():
            return _hermite(signal, t)


def _sin(phase: float) -> float:
    """Return the sine; a phase beyond the doubles counts as 0."""
    return math.sin(phase) if math.isfinite(phase) else 0.0


def _pushed(push: Push, t: float) -> complex:
    """Return the motion from rest under the push exp(i omega t)."""
    return complex(from_rest(push, np.array([t]))[0])


def _damped(signal: DampedMass, t: float) -> float:
    slow, apart, swing = signal.slow, signal.apart, signal.swing
    if apart * t > 1:
        A, B = signal.late
        return A * math.exp(-slow * t) + B * math.exp(-(slow + apart) * t)
    grown = _sin(swing * t) / swing if swing else -math.expm1(-apart * t) / apart if apart else t
    return math.exp(-slow * t) * (signal.start * _sin(swing * t + math.pi / 2) + signal.rate * grown)


def _chain(signal: Modal, named: dict[str, float]) -> float:
    scale = named[signal.of] / signal.by if signal.by else 1.0
    found = displacements(signal, np.array([named["t"]]))[0] + signal.line[1] * named["t"]
    named |= {f"{signal.name}{i}": scale * float(x) for i, x in enumerate(found, start=1)}
    return named.get(f"{signal.name}{round(named[signal.at])}", 0.0)


def _hermite(signal: Sampled, t: float) -> float:
    y, dy = np.asarray(signal.y), np.asarray(signal.dy)
    count = len(y) - 1
    turns = math.floor(t / signal.period)
    place = (t / signal.period - turns) * count
    i = min(math.floor(place), count - 1)
    u, h = place - i, signal.period / count
    start = (1 + 2 * u) * (1 - u) ** 2 * y[i] + u * (1 - u) ** 2 * h * dy[i]
    end = u * u * (3 - 2 * u) * y[i + 1] + u * u * (u - 1) * h * dy[i + 1]
    return float(turns * signal.drift + start + end)

"""Signals: numbers that depend on time, which the browser evaluates at any instant from a few coefficients.

Times are in the unit of the time axis, from the start of the window; amplitudes are in the unit of the signal's own
axis. The coefficients are then of order one. A signal can use earlier signals and the picture's scalars.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

from msgspec import Struct

from components.language.expressions import Expression


class Signal(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """Base of all signals."""


class Sine(Struct, frozen=True, array_like=True):
    """A damped sine, (size + slope t) exp(-decay t) sin(omega t + phase); an exponential has omega = 0 and phase =
    pi/2."""

    size: float
    omega: float
    phase: float
    decay: float = 0.0
    slope: float = 0.0


class Sines(Signal, frozen=True, kw_only=True, tag="sines"):
    """A sum of sines and a + b t; line = (a, b)."""

    sines: tuple[Sine, ...]
    line: tuple[float, float] = (0.0, 0.0)


class Response(Struct, frozen=True, array_like=True):
    """Response from rest, size g(t) with g'' + omega_n^2 g = sin(omega t); regular at resonance and at omega_n = 0."""

    size: float
    omega: float
    omega_n: float


class Responses(Signal, frozen=True, kw_only=True, tag="responses"):
    """A sum of responses to a drive."""

    responses: tuple[Response, ...]


class DampedMass(Signal, frozen=True, kw_only=True, tag="damped"):
    """The free motion of a damped mass, or its rate: exp(-slow t) (start C + rate S).

    C = cos(swing t), S = sin(swing t)/swing if underdamped; else C = 1, S = (1 - exp(-apart t))/apart, and S = t at
    critical damping. For apart t > 1 it is computed as a sum of both exponentials with the amplitudes `late`.
    """

    start: float
    rate: float
    slow: float
    apart: float = 0.0
    swing: float = 0.0
    late: tuple[float, float] = (0.0, 0.0)


class DrivenMass(Signal, frozen=True, kw_only=True, tag="driven"):
    """The motion of a damped mass from rest, Im((re + i im) E), E'' + (2 slow + apart) E' + omega_n^2 E = exp(i omega
    t): regular at resonance, at critical damping and for zero damping.

    `slow`, `apart` and `swing` are the rates of its free motion, `detuning` is omega - swing.
    """

    re: float
    im: float
    omega: float
    omega_n: float
    slow: float
    apart: float
    swing: float
    detuning: float


class Modal(Signal, frozen=True, kw_only=True, tag="modal"):
    """The motion of a chain of equal masses as the sum of its modes; its value is the displacement of the mass `at`, a
    signal before it.

    Mode j has sizes[j] sin(omega[j] t + phases[j]) times its orthonormal shape, which follows from the number of modes
    and the `ends`; `line` = (a, b) adds a + b t to all. Mass p = 1, 2, ... has the displacement called `name` and its
    number, x3. If `by` is not 0, all displacements are proportional to the scalar `of`, whose value here is `by`.
    """

    name: str
    ends: Literal["fixed-fixed", "fixed-free", "free-free"]
    omega: tuple[float, ...]
    sizes: tuple[float, ...]
    phases: tuple[float, ...]
    at: str
    of: str
    by: float
    line: tuple[float, float] = (0.0, 0.0)


class Derived(Signal, frozen=True, kw_only=True, tag="derived"):
    """A polynomial in earlier signals."""

    value: Expression


class SineOf(Signal, frozen=True, kw_only=True, tag="sine"):
    """The sine of an earlier signal, an angle in rad."""

    of: str


class CosineOf(Signal, frozen=True, kw_only=True, tag="cosine"):
    """The cosine of an earlier signal, an angle in rad."""

    of: str


class Samples(Struct, frozen=True):
    """Samples that follow the JSON of their message: their count, minimum and maximum."""

    count: int
    low: float
    high: float


class Sampled(Signal, frozen=True, kw_only=True, tag="sampled"):
    """A periodic motion from equally spaced values and slopes over one period, with Hermite interpolation; `drift` is
    added each period."""

    period: float
    y: tuple[float, ...] | Samples
    dy: tuple[float, ...] | Samples
    drift: float = 0.0


AnySignal: TypeAlias = Sines | Responses | DampedMass | DrivenMass | Modal | Derived | SineOf | CosineOf | Sampled

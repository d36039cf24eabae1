"""Motions as the browser's clock plays them: a few scalars a signal, evaluated sixty times a second without a server.

Times are counted in the unit of the time axis (10**exponent seconds), from the start of the window; sizes in the unit
of the signal's own axis. What is sent is therefore of order one, whatever the parameters.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from decimal import Decimal
from typing import Any

from components.axes import Axis
from components.stage import Number, as_expression


def scaled(exponent: int, *factors: float) -> float:
    """The product of the factors divided by 10**exponent, though intermediate products leave the range of doubles."""
    product = Decimal(1).scaleb(-exponent)
    for factor in factors:
        product *= Decimal(factor)
    result = float(product)
    if math.isinf(result):
        raise ValueError("the motion does not fit this time window: its numbers leave the range of doubles")
    return result


def sines(
    size: Axis, time: Axis, *terms: tuple[float, float, float], line: tuple[float, float] = (0, 0)
) -> dict[str, Any]:
    """a + b t + sum of A sin(omega t + phi), from (A, omega, phi) in SI units and line = (a, b)."""
    return {
        "line": [
            scaled(size.exponent, line[0], 1 / size.factor),
            scaled(size.exponent - time.exponent, line[1], 1 / size.factor),
        ],
        "sines": [
            [scaled(size.exponent, amplitude, 1 / size.factor), scaled(-time.exponent, omega), phase]
            for amplitude, omega, phase in terms
        ],
    }


def rates(size: Axis, time: Axis, *terms: tuple[float, float, float], drift: float = 0.0) -> dict[str, Any]:
    """The rate of change of the same motion, in the size's unit per unit of time."""
    unit = size.exponent - time.exponent
    return {
        "line": [scaled(unit, drift), 0.0],
        "sines": [
            [scaled(unit, amplitude, omega), scaled(-time.exponent, omega), phase + math.pi / 2]
            for amplitude, omega, phase in terms
        ],
    }


def responses(size: Axis, time: Axis, *terms: tuple[float, float, float, float]) -> dict[str, Any]:
    """Motion from rest under a drive: sum of F c g(t), g'' + omega_n^2 g = sin(omega t), from (F, c, omega, omega_n).

    F in N, c in 1/kg. It is regular at resonance and at omega_n = 0.
    """
    return {
        "responses": [
            [
                scaled(size.exponent - 2 * time.exponent, F, c),
                scaled(-time.exponent, omega),
                scaled(-time.exponent, omega_n),
            ]
            for F, c, omega, omega_n in terms
        ]
    }


def derived(expression: Number) -> dict[str, Any]:
    """A signal that is a polynomial in signals named before it and in scalars."""
    return {"polynomial": as_expression(expression).wire()}


def sine_of(name: str) -> dict[str, Any]:
    """The sine of a signal in rad named before it: for what turns."""
    return {"sine": name}


def cosine_of(name: str) -> dict[str, Any]:
    """The cosine of a signal in rad named before it."""
    return {"cosine": name}


def total(*names: str) -> dict[str, Any]:
    """The sum of signals named before it."""
    return {"polynomial": [[1.0, name] for name in names]}


def table(
    time: Axis, period: float, columns: Iterable[float], slopes: Iterable[float], drift: float = 0.0
) -> dict[str, Any]:
    """A sampled periodic motion, equally spaced over one period, joined by Hermite pieces, `drift` gained each period.

    `columns` and `drift` are in the signal's unit, `slopes` in that unit per second.
    """
    unit = 10.0**time.exponent
    return {
        "table": {
            "period": period / unit,
            "y": [float(v) for v in columns],
            "dy": [float(v) * unit for v in slopes],
            "drift": drift,
        }
    }


FLASHES = 6.0
"""Swings a second that the eye can still follow."""


def pace(omega: float, fastest: float) -> dict[str, float]:
    """The scalars of the clock: at the speed `pace` a period of `omega` takes 4 to 10 s, at `limit` `fastest` shows.

    Both in rad/s; where there is none (0) a second lasts a second.
    """
    if not omega:
        return {"pace": 1.0}
    period = 2 * math.pi / omega
    return {"pace": 1.0 if 4 <= period <= 10 else round_down(period / 4), "limit": FLASHES * 2 * math.pi / fastest}


def round_down(value: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above `value`."""
    exponent = math.floor(math.log10(value))
    return max(
        float(f"{digit}e{exponent}") for digit in (1, 2, 5) if float(f"{digit}e{exponent}") <= value * (1 + 1e-9)
    )

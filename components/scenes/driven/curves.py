"""The curves of the driven mass over time: their axes, their signals, and the bands of what is too fast for a line."""

from __future__ import annotations

import math

import numpy as np
from msgspec.structs import replace

from components.language.signals import AnySignal
from components.quantities.axes import ONE, Axis, nice_axis, time_axis
from components.quantities.motion import QUARTER, damped, driven, scaled, sines, total
from components.scene.traces import Columns, band_columns, bands_over_time
from components.scenes.driven.case import DrivenCase
from components.scenes.driven.power import power_columns
from physics.sampling import drawable

ROOM = 1.2
"""The reach of x(t), in its largest value."""


def axes_of(case: DrivenCase) -> dict[str, Axis]:
    reach = max(case.reach, case.size if case.kind == "base" else 0.0) or 1.0
    x = replace(nice_axis(-ROOM * reach, ROOM * reach, "m", 2, exact=True), drawn=(-reach, reach))
    power = power_columns(case)
    ends = [float(column.max(initial=0.0)) for name, column in power.items() if name != "t"]
    least = min((float(column.min(initial=0.0)) for column in power.values()), default=0.0)
    most = max(ends, default=0.0) or 1.0
    P = replace(nice_axis(1.1 * least, 1.15 * most, "W", 1, exact=True), drawn=(least, most))
    unit = {"force": "N", "base": "m", "unbalance": "kg m"}[case.kind]
    return {
        "t": time_axis(case.own_end),
        "x": x,
        "P": P,
        "drive": nice_axis(0.0, 1.25 * (case.size or 1.0), unit, exact=True),
    }


def signals_of(case: DrivenCase, axes: dict[str, Axis]) -> dict[str, AnySignal]:
    """x from rest and from the start, its parts, the drive, and where the unbalance is."""
    size, time, drive = axes["x"], axes["t"], axes["drive"]
    signals: dict[str, AnySignal] = {
        "x_driven": driven(size, time, case.push),
        "x_free": damped(size, time, case.free[0]),
        "x": total("x_driven", "x_free"),
        "F": sines(drive, time, (case.size, case.omega, 0.0)),
        "sine": sines(ONE, time, (1.0, case.omega, 0.0)),
        "cosine": sines(ONE, time, (1.0, case.omega, QUARTER)),
        "y": sines(size, time, (case.size if case.kind == "base" else 0.0, case.omega, 0.0)),
    }
    if case.split:
        phase = math.atan2(case.X.imag, case.X.real)
        signals["x_p"] = sines(size, time, (abs(case.X), case.omega, phase))
        signals["x_c"] = damped(size, time, case.complementary)
    elif case.grows and case.pushed:
        rate = scaled(0, case.growth, case.omega) / (2 * math.pi)
        signals |= {"upper": sines(size, time, line=(0.0, rate)), "lower": sines(size, time, line=(0.0, -rate))}
    return signals


def drawn_names(case: DrivenCase) -> tuple[str, ...]:
    """The signals that are drawn as curves over time."""
    if not drawable(case.fastest, case.t):
        return ()
    base = ("y",) if case.kind == "base" and case.pushed else ()
    if case.split:
        return ("x", "x_c", *(base or ("x_p",)))
    return ("x", *base, *(("upper", "lower") if case.grows and case.pushed else ()))


def bands_of(case: DrivenCase) -> dict[str, Columns]:
    """The band that x stays within, where it is too fast for a line: the steady part and what is left of the start."""
    low, high = band_columns("x")
    if drawable(case.fastest, case.t):
        return bands_over_time(case.t, {})
    reach = np.full_like(case.t, case.reach)
    if case.split:
        one = case.complementary
        fading = math.hypot(one.start, one.rate / one.swing) if one.swing else abs(one.start) + sum(map(abs, one.late))
        reach = abs(case.X) + fading * np.exp(-one.slow * case.t)
    return bands_over_time(case.t, {low: -reach, high: reach})

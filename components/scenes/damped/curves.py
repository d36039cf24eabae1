"""The curves of the damped mass: their axes, their signals, and what is drawn where a swing is too fast for a line."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace

from components.language.numbers import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis, nice_axis, time_axis, whole_axis
from components.quantities.motion import QUARTER, damped, decays, derived, scaled, total
from components.scene.traces import Columns, Floats, band_columns, bands_over_time, samples
from components.scenes.damped.case import DampedCase
from physics.sampling import drawable

ROOM = 1.25
"""The reach of x(t), in its largest value."""
LEFT, RIGHT, UP = 1.55, 0.88, 1.28
"""The reach of the plane of the roots, in natural frequencies."""
FEW = 4.0
"""Parts more than this many times as large as their sum are not drawn."""
ENERGIES = ("none", "V", "E", "E_0")


def instants(case: DampedCase) -> Floats:
    return np.linspace(0.0, case.end, samples(case.end, case.fastest))


def axes_of(case: DampedCase) -> dict[str, Axis]:
    one, reach = case.oscillator, case.reach or abs(case.x_0) or 1.0
    x = replace(nice_axis(-ROOM * reach, ROOM * reach, "m", 2, exact=True), drawn=(-reach, reach))
    speed, power = abs(case.top.v), case.P_max
    E = whole_axis(case.E_0 or 1.0, "J")
    circle = one.omega_n or one.rates[1] or 1.0
    return {
        "t": time_axis(case.own_end),
        "x": x,
        "v": nice_axis(0.0, speed or 1.0, "m/s", exact=True),
        "E": replace(E, end=1.08 * E.end, drawn=(0.0, E.end)),
        "P": replace(nice_axis(0.0, 1.15 * (power or 1.0), "W", 2, exact=True), drawn=(0.0, power or 1.0)),
        "re": Axis(-LEFT * circle, RIGHT * circle, "1/s", drawn=(-circle, 0.0)),
        "im": Axis(-UP * circle, UP * circle, "1/s", drawn=(-circle, circle)),
    }


def signals_of(case: DampedCase, axes: dict[str, Axis]) -> dict[str, AnySignal]:
    """x and v, the parts and the envelope of x, the energies and their stack, and the power of the dashpot."""
    one, (size, time, speed, E, P) = case.oscillator, (axes[name] for name in ("x", "t", "v", "E", "P"))
    x, v, _ = one.fading(case.x_0, case.v_0)
    parts = {"upper": (case.envelope, 0), "lower": (-case.envelope, 0), "slow": (x.late[0], 0), "fast": (x.late[1], 1)}
    return {
        "x": damped(size, time, x),
        "v": damped(speed, time, v),
        **{name: decays(size, time, (C, 0.0, one.rates[i], 0.0, QUARTER)) for name, (C, i) in parts.items()},
        "none": derived(0.0),
        "T": derived(scaled(E.exponent - 2 * speed.exponent, 0.5, one.m) * var("v") * var("v")),
        "V": derived(scaled(E.exponent - 2 * size.exponent, 0.5, one.k) * var("x") * var("x")),
        "E": total("V", "T"),
        "E_0": derived(E.place(case.E_0)),
        "heat": derived(var("E_0") - var("E")),
        "P": derived(scaled(P.exponent - 2 * speed.exponent, one.c) * var("v") * var("v")),
    }


def drawn_names(case: DampedCase, t: Floats) -> tuple[str, ...]:
    """The signals that are drawn as curves over time."""
    names = ["x"] if drawable(case.oscillator.omega_d, t) else []
    if case.kind == "under":
        names += ["upper", "lower"]
    if parts_shown(case):
        names += ["slow", "fast"]
    energies = (*ENERGIES, *(("P",) if case.oscillator.c else ())) if drawable(2 * case.oscillator.omega_d, t) else ()
    return (*names, *energies)


def parts_shown(case: DampedCase) -> bool:
    """Whether the two exponentials are drawn: near critical damping they are huge and opposite."""
    late = case.oscillator.fading(case.x_0, case.v_0)[0].late
    return case.kind == "over" and max(map(abs, late)) < FEW * case.reach


def locus(case: DampedCase) -> Columns:
    """The roots for other dampings of the same mass and spring: half a circle."""
    turn = np.linspace(np.pi / 2, 3 * np.pi / 2, 49) if case.omega else np.empty(0)
    return {"re": case.omega * np.cos(turn), "im": case.omega * np.sin(turn)}


def columns_of(case: DampedCase, t: Floats) -> dict[str, Columns]:
    """Where a swing is too fast for a line: the band of x, and energies and power averaged over it."""
    one = case.oscillator
    decay = np.exp(-one.rates[0] * t)
    low, high = band_columns("x")
    bands = {} if drawable(one.omega_d, t) else {low: -case.envelope * decay, high: case.envelope * decay}
    if drawable(2 * one.omega_d, t):
        return {"locus": locus(case), **bands_over_time(t, bands)}
    E = case.E_0 * decay * decay
    levels = {"none": np.zeros_like(t), "V": E / 2, "E": E, "E_0": np.full_like(t, case.E_0)}
    power = {"P": E * 2 * one.rates[0]} if one.c else {}
    return {"locus": locus(case), "time": {**levels, **power}, **bands_over_time(t, bands)}

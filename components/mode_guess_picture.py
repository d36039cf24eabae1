"""The numbers of the view Guess: curves, forces, and what the matrix says at the trial frequency."""

from __future__ import annotations

import math
from dataclasses import replace
from decimal import Decimal

import numpy as np

from components.motion import pace, sines
from components.numbers import signed, ten, three
from components.plots import Axis, nice_axis, squared_axis, time_axis
from components.scene import Columns, Picture
from physics.coupled import Modes, TwoMassChain
from physics.modes import Forces, Trial, determinant_curve, forces, quadratic, row_curves, trial
from physics.sampling import time_window

MODES = ("slow", "fast")
ROWS = ("need", "give", "add")
REACH = 0.17
"""The longest force arrow, as a fraction of the stage's width."""
NEAR, SAME = 1e-3, 4e-16
"""How near a natural frequency two rows are nearly the same equation, and as near as doubles come."""
ROUNDING = Decimal("1e-12")
"""A typed ratio is rounded, so at a mode a force of this size, compared with the others, is left: it is shown as 0."""


def picture(system: TwoMassChain, omega: float, ratio: float, moving: bool, window: float | None) -> Picture:
    """All of the view for one chain and one guess; ValueError where a curve leaves the range of doubles."""
    modes, asked, push = system.modes(), trial(system, omega), forces(system, omega, ratio)
    if system.k2 and not np.all(np.isfinite(modes.ratio)):
        raise ValueError("a mode ratio X2/X1 leaves the range of doubles")
    end = math.sqrt(1.375) * float(modes.omega[1]) or 2 * omega or 1.0
    half = 2 * max((abs(float(r)) for r in modes.ratio if r and math.isfinite(r)), default=2.0)
    frequency, shape = squared_axis(end, "(rad/s)²"), nice_axis(-half, half, "", 4, exact=True)
    shape = replace(shape, ticks=shape.ticks[1:-1])
    columns, D, exponent = _columns(system, end, 3 * half)
    clock = {"t": time_axis(window or time_window(omega, omega))} if moving else {}
    metres = Axis(-1.0, 1.0, "m")
    rate = omega if moving else 0.0
    time = clock.get("t", Axis(0.0, 1.0))
    X = [float(value) for value in push.amplitude]
    return Picture(
        columns=columns,
        axes={"w": frequency, "r": shape, "D": D, **clock},
        signals={
            "swing": sines(metres, time, (1.0, rate, math.pi / 2)),
            **{f"x{i}": sines(metres, time, (X[i - 1], rate, math.pi / 2)) for i in (1, 2)},
        },
        scalars={
            **_force_scalars(push),
            **_plot_scalars(system, modes, asked, omega, ratio, (frequency, shape, D), exponent),
            **(pace(omega, omega) if moving else {}),
        },
        values=_values(system, modes, asked, push, omega, ratio, exponent),
        forms={**_forms(system, modes, asked, omega)},
    )


def _columns(system: TwoMassChain, end: float, largest: float) -> tuple[dict[str, Columns], Axis, int]:
    first, second = row_curves(system, end, largest)
    columns: dict[str, Columns] = {"row1": {"w": first.omega[0], "row1": first.ratio[0]}}
    for name, w, r in zip(("row2_below", "row2_above"), second.omega, second.ratio, strict=False):
        columns[name] = {"w": w, name: r}
    w = end * np.sqrt(np.linspace(0.0, 1.0, 201))
    curve, exponent = determinant_curve(system, w)
    columns["det"] = {"w": w, "D": curve}
    low, at_zero = float(np.min(curve)), float(curve[0])
    unit = f"{ten(exponent)} N²/m²" if exponent else "N²/m²"
    size = max(1.2 * at_zero, -2.1 * low, 0.0) or 1.0
    return columns, nice_axis(min(1.33 * low, -0.1 * size), size, unit, 2, exact=True), exponent


def _force_scalars(push: Forces) -> dict[str, float]:
    """Lengths of the arrows as fractions of the width, and on which side of each stands its number."""
    size = max((abs(value) for pair in push[1:] for value in pair), default=Decimal(0))
    scalars: dict[str, float] = {}
    for i in (1, 2):
        need, give = (REACH * float(pair[i - 1] / size) if size else 0.0 for pair in (push.needed, push.springs))
        spans = {"need": (0.0, need), "give": (0.0, give), "add": (give, need)}
        for name, span in spans.items():
            low, high = min(span), max(span)
            right = low < 0 and (high <= 0.0 or i == 1)
            scalars[f"{name}{i}_at"] = max(high, 0.0) if right else min(low, 0.0)
            scalars[f"{name}{i}_right"], scalars[f"{name}{i}_left"] = float(right), float(not right)
        scalars |= {f"need{i}": need, f"give{i}": give}
    return scalars


def _plot_scalars(
    system: TwoMassChain,
    modes: Modes,
    asked: Trial,
    omega: float,
    ratio: float,
    axes: tuple[Axis, Axis, Axis],
    exponent: int,
) -> dict[str, float]:
    """Where the points of the two plots stand, in the units of their axes, and which of them are inside the frame."""
    frequency, shape, D = axes

    def inside(axis: Axis, value: float) -> float:
        return float(axis.start <= value <= axis.end)

    def scaled_D(value: Decimal) -> float:
        return float(value.scaleb(-exponent))

    equation = quadratic(system)
    held = math.sqrt(system.k2) / math.sqrt(system.m2)
    w_in, now = inside(frequency, omega), scaled_D(asked.determinant)
    least = scaled_D(-(Decimal(system.k2) ** 2))
    scalars = {
        "w": frequency.place(min(omega, 2 * frequency.end)),
        "w_in": w_in,
        "r": shape.place(max(min(ratio, 2 * shape.end), 2 * shape.start)),
        "guess_in": w_in * inside(shape, ratio),
        "zero": 0.0,
        "D": D.place(now if abs(now) < 1e30 else 1e30),
        "D_in": w_in * inside(D, now),
        "w0": 0.0,
        "D0": D.place(scaled_D(equation.constant)),
        "D0_in": float(system.k1 > 0 < system.k2),
        "w_held": frequency.place(held),
        "D_held": D.place(least),
        "held_in": float(system.k2 > 0) * inside(D, least),
    }
    for mode, w, r in zip(MODES, modes.omega, modes.ratio, strict=True):
        r_in = math.isfinite(r) and bool(inside(shape, float(r)))
        scalars |= {f"w_{mode}": frequency.place(float(w)), f"w_{mode}_si": float(w)}
        scalars |= {f"{mode}_in": float(r_in), f"r_{mode}": shape.place(float(r)) if r_in else 0.0}
    wanted = []
    for i, value in enumerate(asked.rows, start=1):
        known = value is not None and value.is_finite() and shape.start <= value <= shape.end
        scalars |= {
            f"row{i}_in": w_in * known,
            f"row{i}": shape.place(float(value)) if known and value is not None else 0.0,
        }
        wanted.append(
            0.0 if value is None else shape.place(float(max(min(value, Decimal(shape.end)), Decimal(shape.start))))
        )
    return scalars | {"gap": w_in * (None not in asked.rows), "gap_low": wanted[0], "gap_high": wanted[1]}


def _values(
    system: TwoMassChain, modes: Modes, asked: Trial, push: Forces, omega: float, ratio: float, exponent: int
) -> dict[str, str]:
    (a11, a12), (_, a22) = asked.matrix
    values = {"a11": three(a11), "a12": three(a12), "a22": three(a22), "D": three(asked.determinant)}
    values |= {"square": three(Decimal(omega) ** 2), "apart": "" if asked.apart is None else three(asked.apart)}
    values |= {
        f"{mode}_long": f"{w:.5g}" if 0.1 <= w < 1e4 else three(float(w))
        for mode, w in zip(MODES, modes.omega, strict=True)
    }
    equation = quadratic(system)
    values |= {"k1k2": three(equation.constant), "k2k2": three(-(Decimal(system.k2) ** 2))}
    largest = max(abs(value) for pair in push[1:] for value in pair)
    for i in (1, 2):
        row_ = asked.rows[i - 1]
        values[f"row{i}"] = "" if row_ is None else signed(row_)
        values[f"X{i}"] = signed(push.amplitude[i - 1])
        for name, pair in zip(ROWS, push[1:], strict=True):
            value = pair[i - 1] if abs(pair[i - 1]) > ROUNDING * largest else Decimal(0)
            values[f"{name}{i}_N"] = f"{signed(value)} N"
    for mode, w, r in zip(MODES, modes.omega, modes.ratio, strict=True):
        values |= {f"omega_{mode}": three(float(w)), f"r_{mode}": signed(float(r))}
    balanced = all(abs(value) <= Decimal("0.005") * largest for value in push.missing)
    return values | {"you_add": "nothing: this is a mode" if balanced and largest else "what you must add"}


def _forms(system: TwoMassChain, modes: Modes, asked: Trial, omega: float) -> dict[str, str]:
    forms: dict[str, str] = {}
    for i, value in enumerate(asked.rows, start=1):
        forms[f"row{i}"] = "any" if value is None else "number" if value.is_finite() else "pole"
    forms["agree"] = "pole" if asked.apart is None else "apart"
    for mode, w in zip(MODES, modes.omega, strict=True):
        for word, tolerance in (("near", NEAR), ("same", SAME)):
            if abs(omega - w) <= tolerance * w and (asked.apart is not None or word == "same"):
                forms["agree"] = f"{word}_{mode}"
    forms["D"] = "value" if asked.apart is None else "product"
    forms["roots"] = "loose" if not system.k2 else "two" if system.k1 else "wall"
    return forms

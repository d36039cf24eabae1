"""The response curve: how far each mass swings at each drive frequency (D34, points 7 and 8)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.axes import Axis, log_axis, nice_axis
from components.equations import rich
from components.numbers import three
from components.plots import Curve, plot
from components.scene import Columns
from components.sheet import Block
from physics.coupled import TwoMassChain
from physics.forced import antiresonance, particular_solution

Floats = NDArray[np.float64]

BRANCHES = 3
"""Between, before and behind two poles: each is a line of its own, and none runs across a pole."""
POINTS = 70
CLOSEST = 1e-5
"""The first point of a branch stands this far from its pole, as a fraction of the branch."""
BESIDE = 1e-6
"""How near, relatively, a log axis comes to the frequency at which mass 1 stands still."""
REACH = 1.55
"""The axis ends at this multiple of the larger natural frequency, unless the drive is beyond it."""
TALL = 5.0
"""The frame is this many times as high as the swing under a steady force."""


@dataclass(frozen=True)
class Response:
    """What the response plot shows: its sources, axes, marks and their texts."""

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    scalars: dict[str, float]
    values: dict[str, str]


def response(system: TwoMassChain, F_0: float, omega: float, shown: str, lecture: bool) -> Response:
    """The curves `size`, `signed` or `log`, with the drive at `omega`; in the lecture's units where asked for."""
    frequencies = system.modes().omega
    poles = _poles(system, frequencies)
    unit, base = _units(system, F_0, frequencies, omega)
    end = max(2.5 * unit, REACH * frequencies[1]) if lecture else max(REACH * (frequencies[1] or unit), 1.05 * omega)
    start = min(w for w in (*poles, unit, omega or unit) if w > 0) / 30 if shown == "log" else 0.0
    # Down to 0; on a log axis far below the frame, where a number is left to draw.
    still = antiresonance(system) * (1 + BESIDE if shown == "log" else 1)
    parts = _branches(poles, still, start, end)
    curves = [particular_solution(system, F_0, part) for part in parts]
    columns: dict[str, Columns] = {f"branch{i}": {} for i in range(BRANCHES)}
    for i, (w, X) in enumerate(zip(parts, curves, strict=True)):
        one, two = X if shown == "signed" else np.abs(X)
        columns[f"branch{i}"] = {"omega": w, "Xp1": one, "Xp2": two}
    columns["response"] = _whole(parts, curves)
    across = _axis(start, end, "√(k₁/m₁)" if lecture else "rad/s", shown, unit if lecture else 1.0)
    up = _height(base, shown, base if lecture else 1.0, lecture)
    scalars, values = _marks(system, F_0, omega, frequencies, across, up, shown)
    return Response(columns, {"omega": across, "X": up}, scalars, values)


def _poles(system: TwoMassChain, frequencies: Floats) -> list[float]:
    """Frequencies without a steady amplitude: the natural ones, but not the 0 of a mass 2 that is not coupled."""
    return [w for w in dict.fromkeys(frequencies.tolist()) if w > 0 or (system.k1 == 0 and w == 0)]


def _units(system: TwoMassChain, F_0: float, frequencies: Floats, omega: float) -> tuple[float, float]:
    """sqrt(k1/m1) and F0/k1; without a spring to the wall, what stands in their place for the size of the frame."""
    if system.k1:
        return math.sqrt(system.k1) / math.sqrt(system.m1), F_0 / system.k1
    unit = float(frequencies[1]) or omega or 1.0
    return unit, F_0 / (system.m1 + system.m2) / unit / unit


def _branches(poles: list[float], still: float, start: float, end: float) -> list[Floats]:
    """Frequencies of each branch, closer and closer together towards a pole, the one where mass 1 stands still too."""
    edges = [start, *(p for p in poles if start < p < end), end]
    near, even = np.geomspace(CLOSEST, 0.5, POINTS), np.linspace(0.0, 0.5, POINTS)
    parts = []
    for low, high in pairwise(edges):
        from_low, from_high = (near if edge in poles else even for edge in (low, high))
        zero = [still] if low < still < high else []
        part = np.unique(np.concatenate([low + (high - low) * from_low, high - (high - low) * from_high, zero]))
        parts.append(part[~np.isin(part, poles)])
    return [part for part in parts if part.size][:BRANCHES]


def _whole(parts: list[Floats], curves: list[Floats]) -> Columns:
    X = np.concatenate(curves, axis=1) if curves else np.empty((2, 0))
    return {"omega": np.concatenate(parts) if parts else np.empty(0), "Xp1": X[0], "Xp2": X[1]}


def _axis(start: float, end: float, unit: str, shown: str, factor: float) -> Axis:
    if shown == "log":
        return log_axis(start, end, unit)
    return nice_axis(start, end, unit, 5, exact=True, factor=factor)


def _height(base: float, shown: str, factor: float, lecture: bool) -> Axis:
    unit, base = ("F₀/k₁", base) if lecture else ("m", base or 1.0)
    if shown == "log":
        return log_axis(base * 1e-3, base * 1e2, unit)
    return nice_axis(-TALL * base if shown == "signed" else 0.0, TALL * base, unit, 5, exact=True, factor=factor or 1.0)


def _marks(
    system: TwoMassChain,
    F_0: float,
    omega: float,
    frequencies: Floats,
    across: Axis,
    up: Axis,
    shown: str,
) -> tuple[dict[str, float], dict[str, str]]:
    """The flags at both natural frequencies and the antiresonance, and the dots at the drive frequency."""
    marks = {"minus": frequencies[0], "plus": frequencies[1], "still": antiresonance(system)}
    if not system.k2:
        del marks["still"], marks["minus"]
    scalars = {}
    for name, w in marks.items():
        if w > 0 or shown != "log":
            scalars |= {f"mark_{name}": across.place(w), f"mark_{name}_si": float(w)}
    values = {f"mark_{name}": three(w) for name, w in marks.items()}
    X = particular_solution(system, F_0, omega)
    if np.all(np.isfinite(X)) and (omega > 0 or shown != "log"):
        X = X if shown == "signed" else np.abs(X)
        scalars |= {"drive_at": across.place(omega), "Xp1_at": up.place(X[0]), "Xp2_at": up.place(X[1])}
    return scalars, values


FLAGS = (
    ("mark_minus", "slow", r"$\omega_-$", "Drive at the slow natural frequency", None),
    ("mark_still", "m1", r"$X_{\mathrm{p}1} = 0$", "Drive where mass 1 stands still", "dashed"),
    ("mark_plus", "fast", r"$\omega_+$", "Drive at the fast natural frequency", None),
)


def response_plot(**place: Any) -> Block:
    """The plot, its flags 'go there', and the pill that sets the drive frequency."""
    marks = tuple(
        {
            "at": at,
            "tint": tint,
            "html": f"{rich(symbol)}<br>{rich('{' + at + '}')}",
            "label": label,
            "style": style,
            "set": "omega",
        }
        for at, tint, symbol, label, style in FLAGS
    )
    curves = tuple(
        Curve(
            name=f"Xp{i}",
            source=f"branch{b}",
            x="omega",
            tint=f"m{i}",
            width="sum",
            group=f"Xp{i}",
            label=f"*X*_{{p{i}}}" if b == BRANCHES - 1 else "",
            signal=f"drive_at,Xp{i}_at" if b == 0 else "",
        )
        for i in (1, 2)
        for b in range(BRANCHES)
    )
    return plot(
        "response",
        x="omega",
        y="X",
        title="Amplitude of each mass against the drive frequency, with its two resonances and the antiresonance",
        curves=curves,
        source="branch0",
        x_column="omega",
        marks=marks,
        handles=(
            {
                "parameter": "omega",
                "symbol": "ω",
                "label": "Drive frequency",
                "tint": "F",
                "axis": "x",
                "covering": "rad/s",
            },
        ),
        top=48,
        **place,
    )

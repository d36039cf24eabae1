"""The response curve: how far each mass swings at each drive frequency (D34, points 7 and 8)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np
from msgspec.structs import replace

from components.language.blocks import PlotBlock
from components.language.numbers import var
from components.language.plots import Curve, Handle, Mark
from components.language.state import Frame
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import phrase
from components.layout.stage import Shape, arrow, circle, on_x, on_y, text
from components.layout.text import rich
from components.quantities.axes import Axis, log_axis, nice_axis
from components.quantities.numbers import three
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats
from components.scenes.forced.dying import Dying
from physics.absorber import damped_amplitude
from physics.coupled import TwoMassChain
from physics.forced import DrivenModes, antiresonance, particular_solution

BRANCHES = ("", "12", "2", "1")
"""The masses that swing against the push: below both poles, up to where mass 1 stands still, up to the upper pole, and
above. Each branch is a line of its own, none runs across a pole, and what is against the push is dashed."""
POINTS = 70
CLOSEST = 1e-5
"""The first point of a branch stands this far from its pole, as a fraction of the branch."""
NEAR, EVEN = np.geomspace(CLOSEST, 0.5, POINTS), np.linspace(0.0, 0.5, POINTS)
"""Half a branch, as fractions of it: closer and closer together towards a pole, or equally far apart."""
WIDTHS = np.array([0.0, *np.geomspace(0.05, 40.0, 20)])
"""The distances from a peak at which its curve is drawn, in widths of the peak."""
BESIDE = 1e-6
"""The relative distance that a log axis keeps from the frequency at which mass 1 stands still."""
REACH = 1.55
"""The axis ends at this multiple of the larger natural frequency, unless the drive is beyond it."""
ENOUGH, BROAD = 0.12, 0.04
"""A name has room where the other curve is this share of the frame away, and the curve flat over twice that one."""
TALL = 5.0
"""The frame is this many times as high as the swing under a steady force."""


@dataclass(frozen=True)
class DrawnResponse:
    """The response plot: its sources, axes, marks and their texts."""

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    scalars: dict[str, float]
    values: dict[str, str]


def response_curves(driven: DrivenModes, shown: str, lecture: bool, frame: Frame = FITTED) -> DrawnResponse:
    """The curves `size`, `signed` or `log`, with the drive marked; in the lecture's units where asked for."""
    system, F_0, omega = driven.chain, driven.F_0, driven.omega
    frequencies = system.modes().omega
    poles = _poles(system, frequencies)
    unit, base = _units(system, F_0, frequencies, omega)
    end = max(2.5 * unit, REACH * frequencies[1]) if lecture else max(REACH * (frequencies[1] or unit), 1.05 * omega)
    start = min(w for w in (*poles, unit, omega or unit) if w > 0) / 30 if shown == "log" else 0.0
    across = _axis(start, end, "√(k₁/m₁)" if lecture else "rad/s", shown, unit if lecture else 1.0)
    across = replace(across, drawn=(across.start, min(end, max(poles[-1] if poles else unit, omega))))
    up = _height(base, shown, base if lecture else 1.0, lecture)
    up = replace(up, drawn=(up.start / 2 if up.start < 0 else up.start, up.end / 2))
    axes = framed(frame, {"omega": across, "X": up})
    across, up = axes["omega"], axes["X"]
    start, end = across.start, across.end
    # Down to 0; on a log axis far below the frame, where a number is left to draw.
    still = BESIDE if shown == "log" else 0.0
    w, branches = _branches(_cuts(system, frequencies), still, start, end)
    swings = particular_solution(system, F_0, w)
    drawn = swings if shown == "signed" else np.abs(swings)
    columns: dict[str, Columns] = {f"branch{i}": {} for i in range(len(BRANCHES))}
    columns |= {f"branch{i}": _column(w[part], drawn[:, part]) for i, part in branches.items()}
    columns["response"] = _column(w, swings)
    scalars, values = _marks(driven, frequencies, across, up, shown)
    scalars |= _names(w, drawn, list(branches.values()), across, up)
    return DrawnResponse(columns, axes, scalars, values)


def dying_response(dying: Dying, shown: str, lecture: bool, frame: Frame = FITTED) -> DrawnResponse:
    """The curves with dashpots, finite everywhere, as `size` or `log`: neither with nor against the push."""
    system, modes = dying.chain, dying.modes
    frequencies = system.modes().omega
    unit, base = _units(system, modes.F_0, frequencies, modes.omega)
    end = max(2.5 * unit, REACH * frequencies[1]) if lecture else max(REACH * frequencies[1], 1.05 * modes.omega)
    start = min(w for w in (*frequencies, unit, modes.omega or unit) if w > 0) / 30 if shown == "log" else 0.0
    across = _axis(start, end, "√(k₁/m₁)" if lecture else "rad/s", shown, unit if lecture else 1.0)
    up = _height(base, "log" if shown == "log" else "size", base if lecture else 1.0, lecture)
    axes = framed(frame, {"omega": replace(across, drawn=(across.start, end)), "X": up})
    across, up = axes["omega"], axes["X"]
    w = _grid(dying, across, shown == "log")
    swings = damped_amplitude(system, modes.c, modes.F_0, w, modes.c1)
    inside = np.isfinite(swings).all(axis=0)
    w, swings = w[inside], swings[:, inside]
    columns: dict[str, Columns] = {f"branch{i}": {} for i in range(len(BRANCHES))}
    columns |= {"branch0": _column(w, swings), "response": _column(w, swings)}
    marks = {"minus": frequencies[0], "plus": frequencies[1]}
    if not modes.c and system.k2:
        marks["still"] = antiresonance(system)
    scalars, values = _flags({name: w for name, w in marks.items() if w > 0}, across)
    if modes.omega > 0 or shown != "log":
        one, two = np.abs(dying.X).tolist()
        scalars |= {"drive_at": across.place(modes.omega), "Xp1_at": up.place(one), "Xp2_at": up.place(two)}
        scalars |= _outside(scalars, up)
    return DrawnResponse(columns, axes, scalars | _names(w, swings, [slice(0, w.size)], across, up), values)


def _grid(dying: Dying, across: Axis, log: bool) -> Floats:
    """Frequencies over the axis, and more about each peak, as it is wide."""
    low, high = across.start, across.end
    grid = np.geomspace(low, high, 4 * POINTS) if log else np.linspace(low, high, 4 * POINTS)
    peaks = [
        exponent.imag + side * max(-exponent.real, CLOSEST * exponent.imag) * WIDTHS
        for exponent, _ in dying.modes.transient
        for side in (-1, 1)
        if exponent.imag
    ]
    found = np.unique(np.concatenate([grid, *peaks, dying.chain.modes().omega]))
    return found[(found >= low) & (found <= high)]


def _flags(marks: dict[str, float], across: Axis) -> tuple[dict[str, float], dict[str, str]]:
    scalars: dict[str, float] = {}
    for name, w in marks.items():
        scalars |= {f"mark_{name}": across.place(w), f"mark_{name}_si": float(w)}
    return scalars, {f"mark_{name}": three(w) for name, w in marks.items()}


def _poles(system: TwoMassChain, frequencies: Floats) -> list[float]:
    """Frequencies without a steady amplitude: the natural ones, but not the 0 of a mass 2 that is not coupled."""
    return [w for w in dict.fromkeys(frequencies.tolist()) if w > 0 or (system.k1 == 0 and w == 0)]


def _units(system: TwoMassChain, F_0: float, frequencies: Floats, omega: float) -> tuple[float, float]:
    """sqrt(k1/m1) and F0/k1; without a spring to the wall, what stands in their place for the size of the frame."""
    if system.k1:
        return math.sqrt(system.k1) / math.sqrt(system.m1), F_0 / system.k1
    unit = float(frequencies[1]) or omega or 1.0
    return unit, F_0 / (system.m1 + system.m2) / unit / unit


def _cuts(system: TwoMassChain, frequencies: Floats) -> list[tuple[float, int, bool]]:
    """Where a branch begins: the frequency, which branch, and whether it is a pole; a free mass 2 has no part in it."""
    slow, fast = frequencies.tolist()
    if not system.k2:
        return [(fast, 3, True)]
    return [(slow, 1, True), (antiresonance(system), 2, False), (fast, 3, True)]


def _branches(
    cuts: list[tuple[float, int, bool]], beside: float, start: float, end: float
) -> tuple[Floats, dict[int, slice]]:
    """Frequencies, closer and closer together towards a pole, and which of them each branch has.

    Branches meet where mass 1 stands still; on a log axis that is left out by the share `beside` on both sides.
    """
    poles = [w for w, _, pole in cuts if pole]
    before = [i for w, i, _ in cuts if w <= start]
    inside = [(w, i) for w, i, _ in cuts if start < w < end]
    edges = [(start, before[-1] if before else 0), *inside, (end, -1)]
    lows, highs = zip(*((low, high) for (low, _), (high, _) in pairwise(edges)), strict=True)
    first, last = (
        np.array([[w if w in poles else w * share] for w in ends])
        for ends, share in ((lows, 1 + beside), (highs, 1 - beside))
    )
    from_low, from_high = (np.array([NEAR if w in poles else EVEN for w in ends]) for ends in (lows, highs))
    rows = np.concatenate([first + (last - first) * from_low, last - (last - first) * from_high], axis=1)
    rows.sort(axis=1)
    kept = np.ones(rows.shape, dtype=bool)
    kept[:, 1:] = rows[:, 1:] > rows[:, :-1]
    for pole in poles:
        kept &= rows != pole
    ends = list(accumulate(kept.sum(axis=1).tolist()))
    parts = {i: slice(begin, end) for (_, i), begin, end in zip(edges, [0, *ends], ends, strict=False) if end > begin}
    return rows[kept], parts


def _column(w: Floats, X: Floats) -> Columns:
    return {"omega": w, "Xp1": X[0], "Xp2": X[1]}


def _axis(start: float, end: float, unit: str, shown: str, factor: float) -> Axis:
    if shown == "log":
        return log_axis(start, end, unit)
    return nice_axis(start, end, unit, 3, exact=True, factor=factor)


def _height(base: float, shown: str, factor: float, lecture: bool) -> Axis:
    unit, base = ("F₀/k₁", base) if lecture else ("m", base or 1.0)
    if shown == "log":
        return log_axis(base * 1e-3, base * 1e2, unit)
    return nice_axis(-TALL * base if shown == "signed" else 0.0, TALL * base, unit, 3, exact=True, factor=factor or 1.0)


def _marks(
    driven: DrivenModes,
    frequencies: Floats,
    across: Axis,
    up: Axis,
    shown: str,
) -> tuple[dict[str, float], dict[str, str]]:
    """The flags at both natural frequencies and the antiresonance, and the dots at the drive frequency."""
    marks = {"minus": frequencies[0], "plus": frequencies[1], "still": antiresonance(driven.chain)}
    if not driven.chain.k2:
        del marks["still"], marks["minus"]
    scalars, _ = _flags({name: w for name, w in marks.items() if w > 0 or shown != "log"}, across)
    values = {f"mark_{name}": three(w) for name, w in marks.items()}
    if not driven.at_resonance and (driven.omega > 0 or shown != "log"):
        X = driven.particular if shown == "signed" else np.abs(driven.particular)
        scalars |= {"drive_at": across.place(driven.omega), "Xp1_at": up.place(X[0]), "Xp2_at": up.place(X[1])}
        scalars |= _outside(scalars, up)
    return scalars, values


def _outside(scalars: dict[str, float], up: Axis) -> dict[str, float]:
    """Whether a dot has left the frame, at the top or at the bottom, and how far it goes to be held."""
    low, high = up.place(up.start), up.place(up.end)
    dots = {name: scalars[f"{name}_at"] for name in ("Xp1", "Xp2")}
    over = {f"{name}_over": float(at > high) for name, at in dots.items()}
    under = {f"{name}_under": float(at < low) for name, at in dots.items()}
    return over | under | {f"{name}_held": min(max(at, low), high) for name, at in dots.items()} | {"driven": 1.0}


def _names(w: Floats, X: Floats, branches: list[slice], across: Axis, up: Axis) -> dict[str, float]:
    """Where the curves' names stand: beside the curve, where it is flat and away from the other one."""
    low, high, first, last = (axis.place(end) for axis in (up, across) for end in (axis.start, axis.end))
    x = (across.places(w) - first) / (last - first)
    y = np.clip((up.places(X) - low) / (high - low), -1.0, 2.0)
    counts = [part.stop - part.start for part in branches]
    starts, ends = [part.start for part in branches], [part.stop - 1 for part in branches]
    left, right = (np.repeat(x[at], counts) for at in (starts, ends))
    beside = np.array([np.maximum(x - BROAD, left), np.minimum(x + BROAD, right)])
    scalars: dict[str, float] = {}
    for i in (0, 1):
        best = int(np.argmax(_room(x, beside, y[i], y[1 - i])))
        at = first + x[best] * (last - first), low + y[i, best] * (high - low)
        scalars |= dict(zip((f"Xp{i + 1}_name_x", f"Xp{i + 1}_name_y"), at, strict=True))
    return scalars


def _room(x: Floats, beside: Floats, y: Floats, other: Floats) -> Floats:
    """The room for a name at each place of a curve, from the curves `beside` it, (2, n), in shares of the frame."""
    inside = (x > 0.08) & (x < 0.9) & (y > 0.02) & (y < 0.8)
    before, after = np.interp(beside, x, y)
    return np.where(inside, np.minimum(np.abs(other - y), ENOUGH) - np.abs(after - before), -np.inf)


FLAGS = (
    ("mark_minus", "slow", r"$\omega_-$", "Drive at the slow natural frequency", ""),
    ("mark_still", "m1", r"$X_{\mathrm{p}1} = 0$", "Drive where mass 1 stands still", "dashed"),
    ("mark_plus", "fast", r"$\omega_+$", "Drive at the fast natural frequency", ""),
)


def response_plot() -> PlotBlock:
    """The plot, its flags 'go there', and the pill that sets the drive frequency."""
    marks = tuple(
        Mark(
            at=at,
            tint=tint,
            html=f"{rich(symbol)}<br>{rich('{' + at + '}')}",
            label=label,
            style=style,
            set="omega",
            exactly=f"{at}_si",
        )
        for at, tint, symbol, label, style in FLAGS
    )
    return plot(
        "response",
        x="omega",
        y="X",
        title="Amplitude of each mass against the drive frequency, with its two resonances and the antiresonance",
        curves=tuple(_branch(i, b) for i in (1, 2) for b in range(len(BRANCHES))),
        x_column="omega",
        heading=(
            phrase("", "sum", "ink", form="rows", sign="with the push", braked=""),
            phrase("", "dash", "ink", form="rows", sign="against it", braked=""),
        ),
        marks=marks,
        handles=(Handle(parameter="omega", symbol="ω", label="Drive frequency", tint="F", axis="x", covering="rad/s"),),
        shapes=(*_named(), *_gone(), *_drive()),
        room=Room(40, 12, top=48),
        phone=10,
        height=300,
    )


def _branch(i: int, b: int) -> Curve:
    """One branch of the curve of mass i; the first of them carries the dot at the drive frequency."""
    return curve(
        f"Xp{i}",
        source=f"branch{b}",
        x="omega",
        tint=f"m{i}",
        width="dash" if str(i) in BRANCHES[b] else "sum",
        group=f"Xp{i}",
        read=f"*X*_{{p{i}}}",
        signal=f"Xp{i}_at" if b == 0 else "",
        signal_x="drive_at" if b == 0 else "",
    )


def _named() -> list[Shape]:
    """The name of each curve beside it."""
    return [
        text(
            on_x("response", var(f"Xp{i}_name_x")) + 10,
            on_y("response", var(f"Xp{i}_name_y")) - 8,
            f"*X*_{{p{i}}}",
            "start",
            tint=f"m{i}",
            style="t2 b halo",
        )
        for i in (1, 2)
    ]


def _gone() -> list[Shape]:
    """Arrows at the edge of the frame where a dot has left it."""
    shapes = []
    for i, aside in ((1, -5), (2, 5)):
        x, look = on_x("response", var("drive_at")) + aside, {"tint": f"m{i}", "head": 12}
        top, floor = var("response.top"), var("response.bottom")
        shapes.append(arrow(x, top + 20, x, top + 1, show=f"Xp{i}_over", **look))
        shapes.append(arrow(x, floor - 20, x, floor - 1, show=f"Xp{i}_under", **look))
    return shapes


def _drive() -> list[Shape]:
    """Where the drive stands on each curve: unseen, over the dots; it is taken along the axis, past a pole too."""
    x = on_x("response", var("drive_at"))
    way = on_plot("response", "x", "omega", "drive_at", "omega", least=0.0)
    held = [grab(f"Drive frequency, on the curve of mass {i}", way, inside="response") for i in (1, 2)]
    return [circle(x, on_y("response", var(f"Xp{i}_held")), 0, show="driven", grab=held[i - 1]) for i in (1, 2)]

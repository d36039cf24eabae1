"""The response curve: the amplitude of each mass at each drive frequency (D34, points 7 and 8)."""

from __future__ import annotations

import math
from itertools import accumulate, pairwise
from typing import Any

import numpy as np
from msgspec.structs import replace

from components.chain import BOTH
from components.language.blocks import PlotBlock
from components.language.expressions import var
from components.language.plots import Curve, Handle
from components.language.state import Frame
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import phrase
from components.layout.stage import PlotFrame, Shape, arrow, circle
from components.layout.text import rich
from components.quantities.axes import Axis, log_axis, nice_axis
from components.quantities.declared import Column, Declared, Scalar, by_name
from components.scene.file_table import FileTable
from components.scene.frames import framed
from components.scene.traces import Columns, Floats
from components.scenes.forced.bode import LAG, DrawnResponse, bode, extremes, lags
from components.scenes.forced.case import MARKS, Axes
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.driven import Undamped
from components.scenes.forced.numbers import AnyCase
from components.scenes.forced.numbers import Numbers as N
from components.scenes.forced.words import Forms as F
from physics.absorber import damped_amplitude, damped_solution
from physics.forced import particular_solution

BRANCHES = ("", "12", "2", "1")
"""Branches of the curve, by the masses that move against the drive: below both poles, up to the frequency at which mass
1 does not move, up to the upper pole, and above. Each branch has its own line, so none crosses a pole. A mass that
moves against the drive is dashed.
"""
POINTS = 70
CLOSEST = 1e-5
"""Distance of the first point of a branch from its pole, as a fraction of the branch."""
NEAR, EVEN = np.geomspace(CLOSEST, 0.5, POINTS), np.linspace(0.0, 0.5, POINTS)
"""Points of half a branch, as fractions of it: increasingly dense towards a pole, or equally spaced."""
WIDTHS = np.array([0.0, *np.geomspace(0.05, 40.0, 20)])
"""The distances from a peak at which its curve has points, in widths of the peak."""
BESIDE = 1e-6
"""The relative distance on a log axis from the frequency at which mass 1 does not move."""
REACH = 1.55
"""The axis ends at this multiple of the larger natural frequency, unless the drive is beyond it."""
TALL = 5.0
"""The frame is this many times as high as the amplitude under a steady force."""
POLES = "nan: at a natural frequency there is no steady amplitude."
"""Sentence about the table of amplitudes without dashpots."""

RESPONSE = PlotFrame("response")
scalar, column = Scalar[AnyCase], Column[AnyCase]


class Swings(Declared[AnyCase]):
    """The amplitudes at drive frequencies. Each branch has its own source."""

    omega = column("response")
    Xp = column.each(BOTH, source="response")


class Places(Declared[AnyCase]):
    """Positions of flags and the frequencies that they set; at the drive frequency, the dots: their heights, whether
    they are above or below the frame, and where they can be dragged.
    """

    mark, exactly = scalar.each(MARKS, "mark_{}"), scalar.each(MARKS, "mark_{}_si")
    drive_at, driven = scalar.some(2)
    at, over, under, held = (scalar.each(BOTH, f"Xp{{}}_{name}") for name in ("at", "over", "under", "held"))


P = Places


def response(case: AnyCase, shown: str, lecture: bool, frame: Frame, names: frozenset[str]) -> DrawnResponse:
    """The curves `size`, `signed` or `log`, with the drive marked, in the lecture's units if asked for.

    With dashpots there is no sign, because a motion is neither with nor against the drive. Plots that are not among
    `names` have only their axes.
    """
    log, omega, fast = shown == "log", case.modes.omega, case.natural[1]
    signed = shown == "signed" and isinstance(case, Undamped)
    unit, base = _units(case)
    end = max(2.5 * unit, REACH * fast) if lecture else max(REACH * (fast or unit), 1.05 * omega)
    start = min(w for w in (*case.natural, unit, omega or unit) if w > 0) / 30 if log else 0.0
    across = _axis(start, end, "√(k₁/m₁)" if lecture else "rad/s", shown, unit if lecture else 1.0)
    across = replace(across, drawn=(across.start, min(end, max(fast or unit, omega))))
    up = _height(base, log, signed, base if lecture else 1.0, lecture)
    up = replace(up, drawn=(up.start / 2 if up.start < 0 else up.start, up.end / 2))
    axes = framed(frame, by_name({Axes.omega: across, Axes.X: up}))
    across, up = Axes.omega(axes), Axes.X(axes)
    also = bode(case, across, up, TALL * (base or 1.0), frame, names)
    axes, scalars = axes | also.axes, _marks(case, across, up, log, signed) | also.scalars
    if names.isdisjoint((RESPONSE.part, LAG.part)):
        return DrawnResponse(also.columns, axes, scalars, also.tables)
    w, swings, branches = _curves(case, across, log) if isinstance(case, Undamped) else _curve(case, across, log)
    drawn = swings if signed else np.abs(swings)
    columns: dict[str, Columns] = {f"branch{i}": {} for i in range(len(BRANCHES))}
    columns |= {f"branch{i}": _column(w[part], drawn[:, part]) for i, part in branches.items()}
    columns[Swings.omega.source] = _column(w, swings)
    if LAG.part in names:
        columns |= lags(case, w)
    tables = {"response": _table(case, w, swings)} | also.tables
    return DrawnResponse(columns | also.columns, axes, scalars, tables)


def _curves(case: Undamped, across: Axis, log: bool) -> tuple[Floats, Floats, dict[int, slice]]:
    """Frequencies, the amplitudes there, and the slice of each branch."""
    # Start at 0; on a log axis far below the frame, but above 0.
    w, branches = _branches(_cuts(case), BESIDE if log else 0.0, *sorted((across.start, across.end)))
    return w, particular_solution(case.chain, case.modes.F_0, w), branches


def _curve(case: DampedForcedCase, across: Axis, log: bool) -> tuple[Floats, Floats, dict[int, slice]]:
    """Columns of one branch with finite amplitudes: points over the axis, and more near each peak."""
    low, high = sorted((across.start, across.end))
    grid = np.geomspace(low, high, 4 * POINTS) if log else np.linspace(low, high, 4 * POINTS)
    peaks = [
        exponent.imag + side * max(-exponent.real, CLOSEST * exponent.imag) * WIDTHS
        for exponent, _ in case.modes.transient
        for side in (-1, 1)
        if exponent.imag
    ]
    w = np.unique(np.concatenate([grid, *peaks, case.natural]))
    w = w[(w >= low) & (w <= high)]
    swings = damped_amplitude(case.chain, case.modes.c, case.modes.F_0, w, case.modes.c1)
    inside = np.isfinite(swings).all(axis=0)
    return w[inside], swings[:, inside], {0: slice(0, int(inside.sum()))}


def _units(case: AnyCase) -> tuple[float, float]:
    """sqrt(k1/m1) and F0/k1; without a spring to the wall, replacements that set the size of the frame."""
    system, F_0 = case.chain, case.modes.F_0
    if system.k1:
        return math.sqrt(system.k1) / math.sqrt(system.m1), F_0 / system.k1
    unit = case.natural[1] or case.modes.omega or 1.0
    return unit, F_0 / (system.m1 + system.m2) / unit / unit


def _cuts(case: Undamped) -> list[tuple[float, int, bool]]:
    """Return the frequency where each branch begins, the branch, and True for a pole. A free mass 2 does not count."""
    branches = {"minus": 1, "still": 2, "plus": 3}
    return [(case.marks[name], i, name != "still") for name, i in branches.items() if name in case.marks]


def _branches(
    cuts: list[tuple[float, int, bool]], beside: float, start: float, end: float
) -> tuple[Floats, dict[int, slice]]:
    """Frequencies, increasingly dense towards a pole, and the slice of each branch.

    Branches meet where mass 1 does not move. On a log axis they end at a relative distance `beside` from there.
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


def _table(case: AnyCase, w: Floats, swings: Floats) -> FileTable:
    """The amplitudes for a file, one row per frequency: with signs, or with dashpots their sizes and the lags."""
    sources = *(f"branch{i}" for i in range(len(BRANCHES))), "lag"
    units = {"omega": "rad/s", "Xp1": "m", "Xp2": "m"}
    if isinstance(case, Undamped):
        return FileTable(sources, lambda: _with_poles(case, *_sorted(w, swings)), units, {}, POLES)
    of = {"phi1": ("Xp1", "phi1"), "phi2": ("Xp2", "phi2")}
    lags = dict.fromkeys(of, "rad")
    return FileTable(sources, lambda: _with_lags(case, *_sorted(w, swings)), units | lags, of)


def _sorted(w: Floats, swings: Floats) -> tuple[Floats, Floats]:
    """Return each frequency once, with the amplitudes there."""
    w, first = np.unique(w, return_index=True)
    return w, swings[:, first]


def _with_poles(case: Undamped, w: Floats, swings: Floats) -> Columns:
    poles = [case.marks[name] for name in ("minus", "plus") if name in case.marks] if case.modes.F_0 else []
    inside = [pole for pole in poles if w.size and w[0] < pole < w[-1]]
    places = np.searchsorted(w, inside)
    X = np.insert(swings, places, np.nan, axis=1)
    return _column(np.insert(w, places, inside), X if case.chain.k2 else np.array([X[0], np.zeros_like(X[0])]))


def _with_lags(case: DampedForcedCase, w: Floats, swings: Floats) -> Columns:
    modes = case.modes
    each = [damped_solution(case.chain, modes.c, modes.F_0, omega, modes.c1) for omega in w.tolist()]
    phi1, phi2 = -np.angle(np.array(each).reshape(-1, 2).T) % (2 * math.pi)
    return _column(w, swings) | {"phi1": phi1, "phi2": phi2}


def _column(w: Floats, X: Floats) -> Columns:
    return by_name({Swings.omega: w, Swings.Xp[1]: X[0], Swings.Xp[2]: X[1]})


def _axis(start: float, end: float, unit: str, shown: str, factor: float) -> Axis:
    if shown == "log":
        return log_axis(start, end, unit)
    return nice_axis(start, end, unit, 3, exact=True, factor=factor)


def _height(base: float, log: bool, signed: bool, factor: float, lecture: bool) -> Axis:
    unit, base = ("F₀/k₁", base) if lecture else ("m", base or 1.0)
    if log:
        return log_axis(base * 1e-3, base * 1e2, unit)
    return nice_axis(-TALL * base if signed else 0.0, TALL * base, unit, 3, exact=True, factor=factor or 1.0)


def _marks(case: AnyCase, across: Axis, up: Axis, log: bool, signed: bool) -> dict[str, float]:
    """The flags at both natural frequencies and the antiresonance, and the dots at the drive frequency."""
    found, omega = dict[Scalar[AnyCase], float](), case.modes.omega
    for name, w in case.marks.items():
        if w > 0 or not log:
            found |= {P.mark[name]: across.place(w), P.exactly[name]: w}
    X = case.swings if signed else np.abs(case.swings).tolist()
    if np.all(np.isfinite(X)) and (omega > 0 or not log):
        found |= {P.drive_at: across.place(omega), P.driven: 1.0}
        low, high = up.place(up.start), up.place(up.end)
        for i, at in zip(BOTH, map(up.place, X), strict=True):
            found |= {P.at[i]: at, P.over[i]: float(at > high), P.under[i]: float(at < low)}
            found[P.held[i]] = min(max(at, low), high)
    return by_name(found)


FLAGS = (
    ("minus", "slow", r"slow $\omega_-$", "Drive at the slow natural frequency", ""),
    ("still", "m1", r"$X_{\mathrm{p}1} = 0$", "Drive where mass 1 stands still", "dashed"),
    ("plus", "fast", r"fast $\omega_+$", "Drive at the fast natural frequency", ""),
)


def response_plot() -> PlotBlock:
    """The plot, its buttons at the flags, and the handle that sets the drive frequency."""
    marks = tuple(
        mark(
            P.mark[name], tint=tint, html=f"{rich(symbol)}<br>{rich(str(N.mark[name]))}", label=label, style=style,
            set="omega", exactly=P.exactly[name],
        )
        for name, tint, symbol, label, style in FLAGS
    )  # fmt: skip
    return plot(
        RESPONSE,
        x=Axes.omega,
        y=Axes.X,
        title="Amplitude of each mass against the drive frequency",
        curves=tuple(_branch(i, b) for i in BOTH for b in range(len(BRANCHES))),
        x_column=Swings.omega,
        heading=(
            *(phrase(Swings.Xp[i], "sum", f"m{i}", formula=rf"amplitude $X_{{\mathrm{{p}}{i}}}$") for i in BOTH),
            phrase("", "dash", "ink", form=F.rows, sign="against the push", braked=""),
            phrase("", "none", "mute", formula="over drive *ω*"),
        ),
        marks=marks,
        handles=(Handle(parameter="omega", symbol="ω", label="Drive frequency", tint="F", axis="x", covering="rad/s"),),
        shapes=(*_gone(), *extremes(RESPONSE), *_drive()),
        room=Room(40, 12, top=48),
        phone=10,
        height=262,
    )


def _branch(i: int, b: int) -> Curve:
    """One branch of the curve of mass i. The first branch has the dot at the drive frequency."""
    dot: dict[str, Any] = {"signal": P.at[i], "signal_x": P.drive_at} if b == 0 else {}
    width = "dash" if str(i) in BRANCHES[b] else "sum"
    read = f"*X*_{{p{i}}}"
    return curve(Swings.Xp[i], source=f"branch{b}", x=Swings.omega, tint=f"m{i}", width=width, read=read, **dot)


def _gone() -> list[Shape]:
    """Arrows at the edge of the frame where a dot is outside."""
    shapes = []
    for i, aside in zip(BOTH, (-5, 5), strict=True):
        x, look = RESPONSE.x(var(P.drive_at)) + aside, {"tint": f"m{i}", "head": 12}
        top, floor = RESPONSE.top, RESPONSE.bottom
        shapes.append(arrow(x, top + 20, x, top + 1, show=P.over[i], **look))
        shapes.append(arrow(x, floor - 20, x, floor - 1, show=P.under[i], **look))
    return shapes


def _drive() -> list[Shape]:
    """Invisible shapes over the dots. They are dragged along the axis, also past a pole."""
    x, way = RESPONSE.x(var(P.drive_at)), on_plot(RESPONSE, "x", "omega", P.drive_at, Axes.omega, least=0.0)
    held = {i: grab(f"Drive frequency, on the curve of mass {i}", way, inside=RESPONSE) for i in BOTH}
    return [circle(x, RESPONSE.y(var(P.held[i])), 0, show=P.driven, grab=held[i]) for i in BOTH]

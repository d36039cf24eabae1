"""Bode and Nyquist plots of the driven chain: the lags of both masses, and the steady motion in the complex plane."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from components.chain import BOTH
from components.language.blocks import Block
from components.language.expressions import var
from components.language.shapes import Grab, Locus
from components.language.state import Frame
from components.layout.bode_marks import lag_axes, peak, upright
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import phrase, term
from components.layout.stage import Looks, PlotFrame, Shape, arrow, circle, line, shown_by, text
from components.quantities.axes import Axis, square_axes
from components.quantities.declared import AxesInForce, Column, Declared, Scalar, by_name
from components.scene.file_table import FileTable
from components.scene.frames import framed
from components.scene.traces import Columns, Floats
from components.scenes.forced.case import MARKS, Axes
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.numbers import AnyCase
from components.scenes.forced.numbers import Numbers as N
from physics.bode_curves import bode_curves, locus_frequencies, transfer

LAG, PLANE = PlotFrame("lag"), PlotFrame("nyquist")
PEAKS = tuple((i, n) for i in BOTH for n in (0, 1))
"""The peaks of each mass."""
NAMED = {"minus": ("slow", "*ω*_{−}"), "still": ("mute", "√(*k*_2/*m*_2)"), "plus": ("fast", "*ω*_{+}")}
KEYS: dict[int, Literal["sum", "line"]] = {1: "sum", 2: "line"}
LAGS = {f"mass {i}": N.phase[i].aloud for i in BOTH}
"""The lags that screen readers announce, by mass."""
QUARTERS = (0.0, 90.0, 180.0, 270.0, 360.0)
TURN = 2 * math.pi
scalar, column = Scalar[AnyCase], Column[AnyCase]


class Lags(Declared[AnyCase]):
    """The lags of both masses at drive frequencies."""

    w = column("lag")
    phi = column.each(BOTH, source="lag")


class Plane(Declared[AnyCase]):
    """X1 and X2 in the complex plane."""

    re, im = column.each(BOTH, source="nyquist"), column.each(BOTH, source="nyquist")


class BodePlaces(Declared[AnyCase]):
    """Positions of the drive on the lags and in the plane, of the natural frequencies, and of the peaks and dips."""

    now, turns, unit, turn = scalar.some(4)
    phi, re, im = (scalar.each(BOTH, f"{name}{{}}_at") for name in ("phi", "re", "im"))
    line, re_mark, im_mark, is_line, is_mark = (
        scalar.each(MARKS, f"{name}_{{}}") for name in ("line", "re_mark", "im_mark", "is_line", "is_mark")
    )
    peak, up, low, high, half, is_peak, is_wide = (
        scalar.each(PEAKS, f"{name}{{}}_{{}}") for name in ("peak", "up", "low", "high", "half", "is_peak", "is_wide")
    )
    above = scalar.each(tuple((i, n) for i in BOTH for n in range(3)), "above{}_{}")
    pole_re, pole_im = (scalar.each(range(4), f"pole_{part}{{}}") for part in ("re", "im"))
    dip, down, is_dip = (scalar.each(BOTH, f"{name}{{}}") for name in ("dip", "down", "is_dip"))


B = BodePlaces


@dataclass(frozen=True)
class DrawnResponse:
    """Plots of the response, the lags or the complex plane: their sources, axes, marks and files."""

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    scalars: dict[str, float]
    tables: dict[str, FileTable]


def bode(case: AnyCase, across: Axis, up: Axis, unit: float, frame: Frame, names: frozenset[str]) -> DrawnResponse:
    """The axes of the lags and of the plane, the plane around its curves, and the marks; `unit` is an amplitude in m.

    If neither plot is among `names`, only the axes and the extremes of the response are returned.
    """
    is_drawn = LAG.part in names or PLANE.part in names
    far, X = _loops(case) if is_drawn or isinstance(case, DampedForcedCase) else (np.empty(0), np.empty((2, 0)))
    ends = [(-unit, unit), (-unit, unit)]
    if isinstance(case, DampedForcedCase) and X.any():
        ends = [(float(part.min(initial=0.0)), float(part.max(initial=0.0))) for part in (X.real, X.imag)]
    re, im = square_axes(ends[0], ends[1], "m")
    labels = tuple(f"{one:.0f}°" if one == QUARTERS[-1] else f"{one:.0f}" for one in QUARTERS)
    lag = Axis(0.0, 1.04 * TURN, "°", ticks=QUARTERS, labels=labels, factor=TURN / 360, drawn=(0.0, TURN))
    axes = framed(frame, by_name({Axes.lag: lag, Axes.re: re, Axes.im: im}))
    tops = _extremes(case, across, up)
    if not is_drawn:
        return DrawnResponse({}, axes, by_name(tops), {})
    rows = (of[i] for of in (Plane.re, Plane.im) for i in BOTH)
    plane = {"omega": far} | by_name(dict(zip(rows, (*X.real, *X.imag), strict=True)))
    table = FileTable(("nyquist",), lambda: plane, dict.fromkeys(plane, "m") | {"omega": "rad/s"}, {})
    return DrawnResponse({"nyquist": plane}, axes, by_name(_places(case, across, axes) | tops), {"nyquist": table})


def lags(case: AnyCase, w: Floats) -> dict[str, Columns]:
    """The lags at the frequencies w of an axis."""
    w = w[w > 0]
    one, two = bode_curves(case.damped, w).lags
    return {"lag": by_name({Lags.w: w, Lags.phi[1]: one, Lags.phi[2]: two})}


def _loops(case: AnyCase) -> tuple[Floats, NDArray[np.complex128]]:
    """The frequencies of the curves in the plane, and X1 and X2 at them."""
    roots = [one for one, _ in case.modes.transient] if isinstance(case, DampedForcedCase) else []
    far = locus_frequencies(roots, case.natural[1] or case.modes.omega or 1.0)
    X = bode_curves(case.damped, far, case.modes.F_0).X
    inside = np.isfinite(X).all(axis=0)
    return far[inside], X[:, inside]


def _places(case: AnyCase, across: Axis, axes: AxesInForce) -> dict[Scalar[AnyCase], float]:
    """Positions of the drive and of the natural frequencies."""
    found, omega, F_0 = dict[Scalar[AnyCase], float](), case.modes.omega, case.modes.F_0
    lag, re, im = Axes.lag(axes), Axes.re(axes), Axes.im(axes)
    for name, w in case.marked.items():
        (X,), _ = bode_curves(case.damped, w, F_0).X.tolist()
        found |= {B.line[name]: across.place(w), B.is_line[name]: 1.0}
        if isinstance(case, DampedForcedCase) and cmath.isfinite(X):
            found |= {B.re_mark[name]: re.place(X.real), B.im_mark[name]: im.place(X.imag), B.is_mark[name]: 1.0}
    if isinstance(case, DampedForcedCase) and (moved := transfer(case.damped, F_0)):
        found |= {B.above[i, n]: re.place(moved.above[i - 1][n]) for i in BOTH for n in range(3)}
        for n, pole in enumerate(moved.poles):
            found |= {B.pole_re[n]: pole.real, B.pole_im[n]: pole.imag}
        found |= {B.unit: moved.unit, B.turn: omega / moved.unit}
    steady = case.damped.response(omega, F_0).tolist()
    if not omega or not all(map(cmath.isfinite, steady)):
        return found
    found |= {B.now: across.place(omega), B.turns: 1.0}
    for i, X, phi in zip(BOTH, steady, case.damped.lags(omega).tolist(), strict=True):
        found |= {B.re[i]: re.place(X.real), B.im[i]: im.place(X.imag)}
        found |= {B.phi[i]: lag.place(phi)} if X else {}
    return found


def _extremes(case: AnyCase, across: Axis, up: Axis) -> dict[Scalar[AnyCase], float]:
    """The peaks and dips of the response; each peak with the two frequencies at half its power."""
    found, F_0 = dict[Scalar[AnyCase], float](), case.modes.F_0
    for i, one in zip(BOTH, case.extremes if F_0 else (), strict=False):
        for n, top in enumerate(one.peaks[:2]):
            low, high = top.half_power
            found |= {B.peak[i, n]: across.place(top.omega), B.up[i, n]: up.place(F_0 * top.height)}
            found[B.is_peak[i, n]] = 1.0
            if low and high:
                found |= {B.low[i, n]: across.place(low), B.high[i, n]: across.place(high), B.is_wide[i, n]: 1.0}
                found[B.half[i, n]] = up.place(F_0 * top.height / math.sqrt(2))
        for dip in one.dips[:1]:
            found |= {B.dip[i]: across.place(dip.omega), B.down[i]: up.place(F_0 * dip.height), B.is_dip[i]: 1.0}
    return found


def extremes(on: PlotFrame) -> list[Shape]:
    """Peaks, the widths at half their power, and dips, on the curves of the response."""
    looks = {i: Looks(tint=f"m{i}", inside=on) for i in BOTH}
    dips = ((on.x(var(B.dip[i])), on.y(var(B.down[i])), Looks(show=B.is_dip[i], **looks[i])) for i in BOTH)
    shapes = [circle(x, y, 4.5, style="ghost", **look) for x, y, look in dips]
    for key in PEAKS:
        x, low, high = (on.x(var(of[key])) for of in (B.peak, B.low, B.high))
        top, width = peak(x, on.y(var(B.up[key])), low, high, on.y(var(B.half[key])), **looks[key[0]])
        shapes += [*shown_by(B.is_wide[key], width), *shown_by(B.is_peak[key], top)]
    return shapes


def lag_plot() -> Block:
    still = LAG.x(var(B.line["still"])) + 5
    curves = (
        curve(Lags.phi[i], source="lag", tint=f"m{i}", width="sum", read=f"lag {i}", signal=B.phi[i], signal_x=B.now)
        for i in BOTH
    )
    shapes = (
        *(upright(LAG, LAG.x(var(B.line[name])), tint, show=B.is_line[name]) for name, (tint, _) in NAMED.items()),
        upright(LAG, LAG.x(var(B.now)), "F", show=B.turns),
        *shown_by(B.is_line["still"], text(still, LAG.top + 14, NAMED["still"][1], "start", tint="mute", style="halo")),
        text(LAG.left + 8, LAG.top + 14, "lag behind the push", "start", tint="mute", style="halo"),
    )
    return plot(
        LAG, x=Axes.omega, y=Axes.lag, x_column=Lags.w, curves=curves, shapes=shapes,
        title="Lag of each mass behind the push against the drive frequency", says=LAGS,
        room=Room(40, 12, top=6), style="lag", grow=0.4, phone=12, height=96,
    )  # fmt: skip


def _hold(i: int) -> Grab:
    """A shape on the curve of a mass. Dragging it sets the drive frequency."""
    way = Locus(
        parameter="omega", moves=B.turn.name, unit=var(B.unit), now=var(B.turn),
        above=tuple(var(B.above[i, n]) for n in range(3)),
        poles=tuple((var(B.pole_re[n]), var(B.pole_im[n])) for n in range(4)),
        x=PLANE.x(0), y=PLANE.y(0), right=PLANE.per_x, down=PLANE.per_y,
    )  # fmt: skip
    along = on_plot(PLANE, "x", "", B.re[i], Axes.re), on_plot(PLANE, "y", "", B.im[i], Axes.im)
    return grab(f"Drive frequency, on the loops of mass {i}", way, *along, inside=PLANE)


def plane_plot() -> Block:
    tip, level = (PLANE.x(var(B.re[1])), PLANE.y(var(B.im[1]))), PLANE.y(0)
    shapes = [
        *lag_axes(PLANE),
        arrow(PLANE.x(0), level, *tip, tint="m1", show=B.turns, inside=PLANE),
        line(tip[0], level, *tip, tint="F", style="dotted", show=B.turns, inside=PLANE),
        *(circle(PLANE.x(var(B.re[i])), PLANE.y(var(B.im[i])), 0, show=(B.turns, B.unit), grab=_hold(i)) for i in BOTH),
    ]
    for name, (tint, label) in NAMED.items():
        x, y = PLANE.x(var(B.re_mark[name])), PLANE.y(var(B.im_mark[name]))
        shapes += shown_by(B.is_mark[name], circle(x, y, 4, tint=tint), text(x, y, label, "beside", tint=tint))
    named = (term(Plane.im[i], KEYS[i], f"m{i}", formula=rf"X_{i}") for i in BOTH)
    curves = (
        curve(
            Plane.im[i], source="nyquist", x=Plane.re[i], tint=f"m{i}", width=KEYS[i], read=f"*X*_{i}",
            signal=B.im[i], signal_x=B.re[i],
        )
        for i in (2, 1)
    )  # fmt: skip
    return plot(
        PLANE, x=Axes.re, y=Axes.im, x_column=Plane.re[1], curves=curves, shapes=tuple(shapes), square=True,
        title="Steady motion of each mass in the complex plane, for all drive frequencies",
        says={**LAGS, "work of a cycle": N.work.aloud},
        heading=(*named, phrase("", "none", "mute", formula="as arrows, for every *ω*")),
        room=Room(48, 14, top=6), phone=10, height=300,
    )  # fmt: skip

"""The response and the phase over one axis of r: the curves, those of other dampings faint behind, and what is held."""

from __future__ import annotations

import math

import numpy as np
from msgspec.structs import replace

from components.language.blocks import PlotBlock
from components.language.numbers import var
from components.language.plots import Handle
from components.language.shapes import Quotient
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import phrase, term
from components.layout.stage import Looks, Shape, circle, line, on_x, on_y, path, shown_by, text
from components.quantities.axes import Axis, nice_axis
from components.scene.traces import Columns, Floats
from components.scenes.driven.case import DrivenCase
from components.scenes.driven.numbers import Numbers as N
from physics.driven import Drive, half_power, highest, lag, magnification

END = 2.5
"""The axis of r ends here, or a little beyond the drive."""
LEAST, USUAL, TALLEST = 1.4, 2.75, 8.8
"""The height of the response: at least; without a peak to show; at most."""
FAINT = (0.0, 0.5, 1.0)
"""The damping ratios of the curves behind."""
KINDS: tuple[Drive, ...] = ("force", "base", "unbalance")
LEFT = Room(40, 14, top=10)
EVEN = np.linspace(0.0, 1.0, 91)
NEAR = np.geomspace(1e-4, 0.6, 24)


def grid(case: DrivenCase, end: float) -> Floats:
    """Values of r, closer together about 1, where a light damping has its peak."""
    near = [
        1 - NEAR,
        1 + NEAR,
        *([1 - case.zeta * NEAR * 10, 1 + case.zeta * NEAR * 10] if 0 < case.zeta < 0.1 else []),
    ]
    r = np.unique(np.concatenate([end * EVEN, *near, [1.0]]))
    return r[(r >= 0) & (r <= end)]


def columns_of(case: DrivenCase, axes: dict[str, Axis]) -> dict[str, Columns]:
    """The response below and above an undamped resonance, and the phase; r is counted in omega."""
    r = grid(case, axes["r"].end / case.omega_n)
    X = magnification(r, case.zeta, case.kind)
    lags = np.array([lag(complex(one)) if np.isfinite(one) else math.pi / 2 for one in X])
    found = {"omega": r * case.omega_n, "M": np.abs(X), "lag": lags}
    if case.zeta:
        return {"below": found, "above": {}}
    return {
        "below": {name: column[r < 1] for name, column in found.items()},
        "above": {name: column[r > 1] for name, column in found.items()},
    }


def axes_of(case: DrivenCase) -> dict[str, Axis]:
    end = max(END, float(f"{1.1 * case.r:.2g}"))
    r = nice_axis(0.0, end * case.omega_n, "", 5, exact=True, factor=case.omega_n)
    peak = highest(case.zeta, case.kind)
    top = USUAL if peak and math.isinf(peak[1]) else min(max(1.1 * (peak[1] if peak else 1.0), LEAST), TALLEST)
    ticks = (0.0, math.pi / 2, math.pi)
    return {
        "r": replace(r, drawn=(0.0, max(1.2, case.r) * case.omega_n)),
        "M": replace(nice_axis(0.0, top, "", 3, exact=True), drawn=(0.0, top / 1.1)),
        "lag": Axis(0.0, 1.08 * math.pi, "rad", ticks=ticks, labels=("0", "π/2", "π"), drawn=(0.0, math.pi)),
    }


def scalars_of(case: DrivenCase, axes: dict[str, Axis]) -> dict[str, float]:
    r, M, phase = axes["r"], axes["M"], axes["lag"]
    scalars = {case.kind: 1.0, "r_at": r.place(case.omega), "per_top": 1 / M.place(M.end), "half": 0.5, "Q": 0.0}
    if case.kind == "base":
        scalars |= {"root2": r.place(math.sqrt(2.0) * case.omega_n)}
    if case.kind == "unbalance" and case.zeta:
        scalars |= {"one": 1.0}
    if case.steady:
        inside = min(case.M, M.end)
        scalars |= {"M_at": M.place(case.M), "lag_at": phase.place(case.lag), "M_held": M.place(inside), "steady": 1.0}
        scalars |= {"beyond": float(M.end < case.M)}
    if case.kind == "force" and 0.02 < case.zeta < 0.6:
        low, high = half_power(case.zeta)
        heights = np.abs(magnification([low, high], case.zeta))
        scalars |= {"low_at": r.place(low * case.omega_n), "high_at": r.place(high * case.omega_n), "width": 1.0}
        scalars |= {"M_low": M.place(float(heights[0])), "M_high": M.place(float(heights[1]))}
        scalars |= {"Q": M.place(0.5 / case.zeta), "one_at": r.place(case.omega_n)}
    return scalars


def outline(kind: Drive, zeta: float, of_phase: bool) -> str:
    """The path of a curve behind, in r to the right and |X| or the lag upwards (negative)."""
    r = np.concatenate([np.linspace(0, 0.9, 30), np.linspace(0.905, 1.1, 40), np.linspace(1.11, 2.5, 40)])
    X = magnification(r[r != 1], zeta, kind)
    up = np.array([lag(complex(one)) for one in X]) if of_phase else np.minimum(np.abs(X), 12.0)
    points = [f"{a:.3f} {-b:.3f}" for a, b in zip(r[r != 1], up, strict=True)]
    return "M" + "L".join(points)


def _behind(plot_: str, of_phase: bool) -> list[Shape]:
    """Outlines are drawn once for all visitors, and scaled to the axes."""
    place: Looks = {"x": on_x(plot_, 0), "y": on_y(plot_, 0), "sx": var(f"{plot_}.x1"), "sy": -1 * var(f"{plot_}.y1")}
    look: Looks = {"style": "scaled behind", "tint": "m1", "inside": plot_}
    return [path(outline(kind, zeta, of_phase), **place, **look, show=kind) for kind in KINDS for zeta in FAINT]


def response_plot() -> PlotBlock:
    held = grab(
        "Drive frequency, on the curve", on_plot("response", "x", "omega", "r_at", "r", least=0.0), inside="response"
    )
    x, y = on_x("response", var("r_at")), on_y("response", var("M_held"))
    return plot(
        "response",
        x="r",
        y="M",
        title="Size of the steady swing against r, the drive frequency over the natural one",
        curves=tuple(
            curve("M", source=source, x="omega", tint="m1", width="sum", group="response", **dot)
            for source, dot in (("below", {"signal": "M_at", "signal_x": "r_at"}), ("above", {}))
        ),
        x_column="omega",
        heading=(
            term("response", "sum", "m1", form="kind", force=r"k |X| / F_0", base="|X| / Y", unbalance="m |X| / m_0 e"),
            phrase("", "none", "mute", formula="faint: *ζ* = 0, 0.5, 1"),
        ),
        x_labels=False,
        room=LEFT,
        shapes=(
            *_behind("response", False),
            *_width(),
            line(on_x("response", var("root2")), var("response.top"), on_x("response", var("root2")),
                 var("response.bottom"), style="eq", tint="mute", show="base"),
            line(var("response.left"), on_y("response", 1), var("response.right"), on_y("response", 1),
                 style="eq", tint="mute", show="base"),
            text(on_x("response", var("root2")) + 8, var("response.top") + 16, "every *ζ* passes 1 at √2", "start",
                 style="halo", tint="mute", show="base"),
            line(x, var("response.top"), x, var("response.bottom"), style="thin", tint="F"),
            circle(x, y, 0, show="steady", grab=held),
            text(x - 9, y - 8, f"{N.M}", "end", tint="m1", style="t2 b halo", show="steady"),
        ),
        grow=190,
        phone=10,
        height=230,
    )  # fmt: skip


def _width() -> list[Shape]:
    """The width at half the power on a bracket, and the height at r = 1, which is Q: its line sets the damping."""
    low, high, Q = (on_x("response", var(name)) for name in ("low_at", "high_at", "one_at"))
    y, height = on_y("response", var("M_high")), on_y("response", var("Q"))
    held = grab(
        "Height at r = 1, Q",
        Quotient(across="y", zero=var("response.y0"), unit=var("response.y1"), parameter="zeta", moves="Q", over="half",
                 least=0.2),
        inside="response",
    )  # fmt: skip
    return shown_by(
        "width",
        line(low, on_y("response", var("M_low")), low, y, style="level", tint="ink"),
        line(low, y, high, y, style="thin", tint="ink"),
        circle(low, on_y("response", var("M_low")), 3.5, tint="m1"),
        circle(high, y, 3.5, tint="m1"),
        text(high + 10, y + 5, f"Δ*ω* = {N.width} rad/s at half the power", "start", style="halo", show="wide"),
        text(high + 10, y + 5, f"Δ*ω* = {N.width} rad/s", "start", style="halo", show="narrow"),
        text(high + 10, y + 20, "at half the power", "start", style="halo", show="narrow"),
        line(Q, height, Q + 60, height, style="level", tint="ink", inside="response"),
        circle(Q + 60, height, 5, style="ghost", tint="T", grab=held),
        text(Q + 70, height + 5, f"*Q* = {N.Q}", "start", style="b halo"),
    )


def phase_plot() -> PlotBlock:
    x = on_x("phase", var("r_at"))
    handle = Handle(parameter="omega", symbol="r", label="Drive frequency", tint="F", axis="x", text="r", covering="")
    return plot(
        "phase",
        x="r",
        y="lag",
        title="Lag of the swing behind the drive against r: from 0 to half a turn",
        curves=tuple(
            curve("lag", source=source, x="omega", tint="m1", width="sum", group="phase", **dot)
            for source, dot in (("below", {"signal": "lag_at", "signal_x": "r_at"}), ("above", {}))
        ),
        x_column="omega",
        handles=(handle,),
        room=LEFT,
        shapes=(
            *_behind("phase", True),
            line(x, var("phase.top"), x, var("phase.bottom"), style="thin", tint="F"),
            text(var("phase.left") + 8, var("phase.top") + 18, "*φ*: how far *x* lags", "start", tint="mute",
                 style="halo"),
        ),
        grow=46,
        phone=11,
        height=100,
    )  # fmt: skip

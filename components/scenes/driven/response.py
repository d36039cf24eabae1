"""The response and the phase over one axis of r: the curves, those of other dampings faint behind, and what is held."""

from __future__ import annotations

import numpy as np

from components.language.blocks import PlotBlock
from components.language.numbers import var
from components.language.plots import Curve, Handle
from components.language.shapes import Quotient
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import phrase, term
from components.layout.stage import ON_NARROW, ON_WIDE, Looks, PlotFrame, Shape, circle, line, path, shown_by, text
from components.quantities.declared import Column, Scalar
from components.scenes.driven.case import KINDS, DrivenCase
from components.scenes.driven.curves import PHASE, RESPONSE, Axes
from components.scenes.driven.curves import Resonance as R
from components.scenes.driven.numbers import Numbers as N
from components.scenes.driven.words import Forms as F
from physics.driven import Drive, lag, magnification

FAINT = (0.0, 0.5, 1.0)
"""The damping ratios of the curves behind."""
BEHIND = "faint: *ζ* = 0, 0.5, 1"
LEFT = Room(40, 14, top=10)


def outline(kind: Drive, zeta: float, of_phase: bool) -> str:
    """The path of a curve behind, in r to the right and |X| or the lag upwards (negative)."""
    r = np.concatenate([np.linspace(0, 0.9, 30), np.linspace(0.905, 1.1, 40), np.linspace(1.11, 2.5, 40)])
    X = magnification(r[r != 1], zeta, kind)
    up = np.array([lag(complex(one)) for one in X]) if of_phase else np.minimum(np.abs(X), 12.0)
    points = [f"{a:.3f} {-b:.3f}" for a, b in zip(r[r != 1], up, strict=True)]
    return "M" + "L".join(points)


def _behind(frame: PlotFrame) -> list[Shape]:
    """Outlines are drawn once for all visitors, and scaled to the axes."""
    place: Looks = {"x": frame.x(0), "y": frame.y(0), "sx": frame.per_x, "sy": -1 * frame.per_y}
    look: Looks = {"style": "scaled behind", "tint": "m1", "inside": frame}
    outlines = ((kind, outline(kind, zeta, frame is PHASE)) for kind in KINDS for zeta in FAINT)
    return [path(d, **place, **look, show=R.driven[kind]) for kind, d in outlines]


def _lines(of: Column[DrivenCase], at: Scalar[DrivenCase], group: str) -> tuple[Curve, ...]:
    """The curve below an undamped resonance, with its dot, and the one above."""
    look: Looks = {"tint": "m1", "width": "sum", "group": group}
    return curve(of, signal=at, signal_x=R.r_at, **look), curve(of, source="above", **look)


def response_plot() -> PlotBlock:
    way = on_plot(RESPONSE, "x", "omega", R.r_at, Axes.r, least=0.0)
    held = grab("Drive frequency, on the curve", way, inside=RESPONSE)
    x, y, root2 = RESPONSE.x(var(R.r_at)), RESPONSE.y(var(R.M_held)), RESPONSE.x(var(R.root2))
    base = {"tint": "mute", "show": R.driven["base"]}
    return plot(
        RESPONSE,
        x=Axes.r,
        y=Axes.M,
        title="Size of the steady swing against r, the drive frequency over the natural one",
        curves=(*_lines(R.M, R.M_at, "response"), curve(R.power, source="below", tint="T", width="line")),
        x_column=R.omega,
        heading=(
            term("response", "sum", "m1", form=F.kind, force=r"k |X| / F_0", base="|X| / Y", unbalance="m |X| / m_0 e"),
            phrase(R.power, "line", "T", form=F.peaks, shown="power lost, peak at *Q*"),
            phrase("", "none", "mute", form=F.flat, shown=BEHIND),
        ),
        x_labels=False,
        room=LEFT,
        shapes=(
            *_behind(RESPONSE),
            *_width(),
            line(root2, RESPONSE.top, root2, RESPONSE.bottom, style="eq", **base),
            line(RESPONSE.left, RESPONSE.y(1), RESPONSE.right, RESPONSE.y(1), style="eq", **base),
            text(root2 + 8, RESPONSE.top + 16, "every *ζ* passes 1 at √2", "start", style="halo", **base),
            line(x, RESPONSE.top, x, RESPONSE.bottom, style="thin", tint="F"),
            circle(x, y, 0, show=R.steady, grab=held),
            text(x - 9, y - 8, f"{N.M}", "end", tint="m1", style="t2 b halo", show=R.steady),
        ),
        grow=190,
        phone=10,
        height=230,
    )


def _width() -> list[Shape]:
    """The width of the power at half its peak, and the height at r = 1, which is Q: its line sets the damping."""
    low, high, one, past = (RESPONSE.x(var(at)) for at in (R.half_r[0], R.half_r[1], R.one_at, R.past_half))
    y, height = (RESPONSE.y(var(at)) for at in (R.half_Q, R.Q))
    aside = RESPONSE.top + 0.19 * (RESPONSE.bottom - RESPONSE.top)
    held = grab(
        "Height at r = 1, Q",
        Quotient(across="y", zero=RESPONSE.at("y0"), unit=RESPONSE.per_y, parameter="zeta", moves=R.Q.name,
                 over=R.half.name, least=0.2),
    )  # fmt: skip
    return shown_by(
        R.width,
        line(low, y, high, y, style="thin", tint="ink"),
        circle(low, y, 3.5, tint="T"),
        circle(high, y, 3.5, tint="T"),
        text(past + 10, y + 5, f"Δ*ω* = {N.width} rad/s at half the power", "start", style="halo", show=ON_WIDE),
        text(past + 10, y + 5, f"Δ*ω* = {N.width} rad/s", "start", style="halo", show=ON_NARROW),
        text(past + 10, y + 20, "at half the power", "start", style="halo", show=ON_NARROW),
        line(one, height, one + 60, height, style="level", tint="ink", inside=RESPONSE),
        circle(one + 60, height, 5, style="ghost", tint="T", grab=held),
        text(one + 70, height + 5, f"*Q* = {N.Q}", "start", style="b halo"),
        text(RESPONSE.right - 4, aside, BEHIND, "end", tint="mute", style="halo"),
    )


def phase_plot() -> PlotBlock:
    x = PHASE.x(var(R.r_at))
    handle = Handle(parameter="omega", symbol="r", label="Drive frequency", tint="F", text=N.r.name)
    return plot(
        PHASE,
        x=Axes.r,
        y=Axes.lag,
        title="Lag of the swing behind the drive against r: from 0 to half a turn",
        curves=_lines(R.lag, R.lag_at, "phase"),
        x_column=R.omega,
        handles=(handle,),
        room=LEFT,
        shapes=(
            *_behind(PHASE),
            line(x, PHASE.top, x, PHASE.bottom, style="thin", tint="F"),
            text(PHASE.left + 8, PHASE.top + 18, "*φ*: how far *x* lags", "start", tint="mute", style="halo"),
        ),
        grow=46,
        phone=11,
        height=100,
    )

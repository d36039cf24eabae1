"""The plot of harmonics: bars for the harmonics of the push, dots for the amplitudes that they cause, and the response
curve."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace

from components.language.blocks import Block
from components.language.expressions import Number
from components.layout.grabs import grab
from components.layout.stage import circle, line, text
from components.layout.views import in_views
from components.paper.plots import Plot, PlotItem, PlotValue, along, curve, either, note, on_axis, words
from components.quantities.axes import Axis
from components.scene.traces import Columns
from components.scenes.driven.case import DrivenCase
from components.scenes.driven.grips import grips
from components.scenes.driven.plots import DRIVE, HARMONICS, LEFT, OMEGA, PUSHED, SIDES, c

OTHERS = "The push is not a sine. This view is about a sine of the same frequency; the view Harmonics shows the others."
NO_PERIOD = "The push does not repeat, so it has no mean power of a period."
ONCE = "The push does not repeat. This view is about a sine; the view Convolution is about every push."


def _bars(case: DrivenCase, r: Axis, M: Axis) -> Columns | None:
    """Return a path for the bars of the harmonics, relative to F_0, from the lower end of the axis."""
    if not case.harmonics:
        return None
    lines = case.harmonics.drawn(r.end)
    up = np.full((len(lines.n), 3), M.start)
    up[:, 1] = np.maximum(lines.f / case.mean_size, M.start)
    return {"bar_omega": np.repeat(lines.n * case.omega, 3), "bar": up.ravel()}


def _dots(case: DrivenCase, r: Axis, M: Axis) -> Columns | None:
    """Return the amplitude that each harmonic causes, relative to F_0/k, limited to the axis."""
    if not case.harmonics:
        return None
    lines = case.harmonics.drawn(r.end)
    sizes = lines.X * (case.k / case.mean_size)
    seen = sizes >= M.start
    return {"dot_omega": lines.n[seen] * case.omega, "dot": np.minimum(sizes[seen], M.end)}


def _strongest(case: DrivenCase, r: Axis, M: Axis) -> float | None:
    """Return the height of the highest dot."""
    return min(case.harmonics.strongest[1] * (case.k / case.mean_size), M.end) if case.harmonics else None


def _jolts(case: DrivenCase, t: Axis, x: Axis) -> Columns | None:
    """Return a path for the bars of impulses. The height is the amplitude that one impulse causes without a dashpot."""
    if not case.is_impulsive or not case.pushed_by:
        return None
    at = case.jolts
    up = np.zeros((len(at), 3))
    up[:, 1] = case.J / (case.m * case.one.omega_n)
    return {"jolt_t": np.repeat(at, 3), "jolt": up.ravel()}


def in_harmonics(response: list[PlotItem]) -> list[Block]:
    """Return the blocks of the view Harmonics, and the sentence of the view Power on pushes that are not sines."""
    power = words(either(c.no_powers, once=NO_PERIOD), phone=12, name="powers")
    blocks = harmonics(HARMONICS, *response), pushed(), strongest()
    return [in_views(power, "power"), *(in_views(one, "harmonics") for one in blocks)]


def harmonics(plot: Plot, *response: PlotItem) -> Block:
    """Return the plot, over the curve of the response."""
    bars, dots = (plot.in_frame(c, of.__name__.strip("_"), of, optional=True) for of in (_bars, _dots))
    hand = grab(
        "Drive frequency, first harmonic", along("x", plot.x, plot.across, omega=c.omega_at, least=0.0), inside=plot
    )
    x, top = plot.x(c.omega_at), plot.in_frame(c, "strongest_up", _strongest, optional=True)
    return plot.block(
        curve(dots, "none", "m1", "disc", columns=("dot_omega", "dot"), words="● swing", read="swing of a harmonic"),
        curve(bars, "line", "F", columns=("bar_omega", "bar"), words="push", read="harmonics of the push"),
        *response,
        note("of each harmonic, against *nω*/*ω*_n", "mute"),
        title="Harmonics of the push over its size, the response, and the swing of each harmonic over F_0/k",
        handles=(replace(OMEGA, symbol="ratio r"),),  # short, because its axis is long
        over=[
            line(x, plot.top, x, plot.bottom, style="thin", tint="F"),
            circle(x, plot.y(c.first_line), 0, grab=hand),
            text(
                plot.x(c.strongest_at), plot.y(top), f"*n* = {c.n_strongest}", "beside", tint="m1",
                style="t2 b halo",
            ),
        ],
        room=LEFT, grow=330, phone=10, height=212,
    )  # fmt: skip


def pushed() -> Block:
    """Return the plot of the motion and of its push, drawn as the displacement of a spring without a mass."""

    def up(force: PlotValue) -> Number:
        return PUSHED.y(0) - PUSHED.up_pixels(c.stretch) * on_axis(DRIVE, force)

    return PUSHED.block(
        curve(c.x, "sum", "m1", label="*x*", words="displacement *x*", fast="ringing", dot=True),
        curve(c.F_over_k, "line", "mute", words="push *F*/*k*", read="push over k", fast="band"),
        curve(
            PUSHED.in_frame(c, "jolts", _jolts, optional=True), "line", "F", columns=("jolt_t", "jolt"),
            words=either(c.is_impulsive, shown="impulses *J*/(*mω*_n)"), read="impulses",
        ),
        title="Displacement and push against time", over=grips(PUSHED, up, DRIVE),
        room=SIDES, grow=220, phone=15, height=150,
    )  # fmt: skip


def strongest() -> Block:
    """Return the sentence on which harmonic is at the peak of the response."""
    most = either(
        c.meets,
        hit=f"**Harmonic {c.n_peak} is at the peak, and moves the mass most: by {c.X_strongest} m.**",
        beaten=f"**Harmonic {c.n_peak} is at the peak, but harmonic {c.n_strongest} moves the mass most: "
        f"by {c.X_strongest} m.**",
        missing=f"**Harmonic {c.n_peak} would be at the peak, but this push has none. "
        f"Harmonic {c.n_strongest} moves the mass most: by {c.X_strongest} m.**",
        between=f"**No harmonic is at the peak. Harmonic {c.n_strongest} moves the mass most: by {c.X_strongest} m.**",
        wide=f"**The peak is wide or missing. Harmonic {c.n_strongest} moves the mass most: by {c.X_strongest} m.**",
        grows=f"**Harmonic {c.n_peak} has exactly the natural frequency, and there is no dashpot: "
        f"its swing grows by {c.harmonic_growth} m each second.**",
        once="**This push does not repeat, so it has no harmonics. The view Convolution shows what it leaves.**",
        sine="**A sine has one harmonic only. Choose another push.**",
        idle="**No push: the motion is that of the start alone.**",
    )
    return words(most, phone=16, name="harmonics")

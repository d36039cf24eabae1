"""Error against run time, its growth, and the picked run, as plots.

A method has no hue: solid chooses its steps, dashed has fixed steps. Dots are measured here; lines alone, recorded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from components.language.blocks import Block
from components.language.numbers import var
from components.language.plots import Curve, Handle, Mark
from components.language.shapes import AnyShape
from components.layout.plots import Room, curve, plot
from components.layout.sheet import phrase
from components.layout.stage import circle, on_x, on_y, text
from components.quantities.axes import Axis
from components.scene.traces import Columns
from components.scenes.accuracy.data import ALONE, BEHIND, MORE
from components.scenes.accuracy.measuring import LIVE
from physics.solvers import METHODS

LOOK: dict[str, dict[str, str]] = {
    "closed": {"tint": "ink", "width": "none", "marker": "disc"},
    "exact": {"tint": "mute", "width": "none", "marker": "ring"},
    "fixed": {"tint": "mute", "width": "dash", "marker": "ring"},
    "adaptive": {"tint": "ink", "width": "line", "marker": "disc"},
}
KEYS = (
    phrase("adaptive", "line", "ink", formula="chosen"),
    phrase("fixed", "dash", "mute", formula="fixed"),
    phrase("closed", "none", "ink", formula="● none"),
    phrase(MORE, "line", "mute", formula=f"{len(METHODS) - len(LIVE)} more"),
)


def work_plot() -> Block:
    """Error against run time; the pill on the error axis is the error that is good enough."""
    return plot(
        "work",
        x="time",
        y="error",
        title="Error of the motion against run time, one line a method",
        curves=(*_recorded(), *_front()),
        x_column="time",
        heading=(phrase("", "none", "ink", formula="**Error against run time**, steps"), *KEYS),
        handles=(Handle(parameter="wanted", label="Accepted error", tint="mute", axis="y"),),
        marks=(
            Mark(at="wanted_at", label="accepted error", axis="y"),
            Mark(at="rounding_at", tint="mute", label="one rounding", axis="y", style="dashed"),
            Mark(at="limit_at", tint="mute", label="time limit", style="dashed"),
        ),
        shapes=(*_meanings(), *_names(), _ring()),
        pick="picked",
        room=Room(54, 12),
        phone=10,
        height=420,
    )


def _front() -> Iterable[Curve]:
    return (
        curve("error", source=slug, x="time", group=METHODS[slug].family, **LOOK[METHODS[slug].family]) for slug in LIVE
    )


def _recorded() -> Iterable[Curve]:
    """Of the methods that can be measured here as strong as these, until they are."""
    for slug, method in METHODS.items():
        look, group = LOOK[method.family], method.family if slug in LIVE else MORE
        thin = "none" if look["width"] == "none" else "thin"
        strong = look["width"] if slug in LIVE else thin
        for source, width, tint in ((BEHIND + slug, thin, "mute"), (ALONE + slug, strong, look["tint"])):
            marker = "ring" if width == "none" else ""
            yield curve("error", source=source, x="time", group=group, tint=tint, width=width, marker=marker)


def _names() -> Iterable[AnyShape]:
    return (
        text(
            on_x("work", var(f"{slug}_at")),
            on_y("work", var(f"{slug}_error")),
            method.mark,
            anchor="beside",
            tint=LOOK[method.family]["tint"],
            style="halo",
            show=f"{slug}_named",
        )
        for slug, method in METHODS.items()
    )


def line_ends(curves: dict[str, Columns], time: Axis, error: Axis) -> dict[str, float]:
    """The last point of the line of each method, beside which its name stands."""
    scalars: dict[str, float] = {}
    for slug, line in curves.items():
        at, reached = time.place(float(line["time"][-1])), error.place(float(line["error"][-1]))
        scalars |= {f"{slug}_named": 1.0, f"{slug}_at": at, f"{slug}_error": reached}
    return scalars


def _meanings() -> Iterable[AnyShape]:
    """Texts at the two dashed lines, and on what to do where nothing has been measured."""
    limit, rounding = on_x("work", var("limit_at")), on_y("work", var("rounding_at"))
    told: dict[str, Any] = {"tint": "mute", "style": "t1 halo"}
    methods = f"{len(LIVE)} methods"
    x, y = (var("work.left") + var("work.right")) / 2, (var("work.top") + var("work.bottom")) / 2
    stiff = on_x("work", var("stiff_at")), on_y("work", var("stiff_error"))
    return (
        text(limit - 6, rounding - 6, "one rounding of a double, 1.1·10⁻¹⁶", anchor="end", **told),
        text(limit, var("work.top"), "runs here stop at {limit}", anchor="beside", **told),
        text(*stiff, "most steps by BDF", anchor="beside", show="stiff", **told),
        text(x, y, f"Press Run: {methods} on this motion, within a minute.", style="halo", show="empty wide"),
        text(x, y - 9, f"Press Run: {methods}", style="halo", show="empty narrow"),
        text(x, y + 9, "on this motion, within a minute.", style="halo", show="empty narrow"),
    )


def _ring() -> AnyShape:
    x, y = on_x("work", var("picked_at")), on_y("work", var("picked_error"))
    return circle(x, y, 9, tint="ink", style="pick", show="picked")


def growth_plot(of: str, title: str, form: str) -> Block:
    """The worst error so far against simulated time, one run of each method."""
    curves = tuple(
        curve(
            of,
            source=f"{of}_{slug}",
            x="period",
            group=method.family if slug in LIVE else MORE,
            label=method.mark,
            tint=LOOK[method.family]["tint"],
            width="dash" if method.family == "fixed" else "line" if slug in LIVE else "thin",
        )
        for slug, method in METHODS.items()
    )
    return plot(
        of,
        x="period",
        y=of,
        title=title,
        curves=curves,
        x_column="period",
        heading=(phrase("", "none", "ink", formula=f"**{title}**, steps"), *KEYS)
        if of == "error_growth"
        else (phrase("", "none", "ink", formula=f"**{title}**"),),
        room=Room(54, 140),
        phone=10,
        height=300,
        form=form,
    )


def picked_plot() -> Block:
    """Energy kept, phase lost: both errors of the picked run on one axis."""
    return plot(
        "kept",
        x="period",
        y="percent",
        title="Error of the motion and of the energy of the picked run, in percent, against simulated time",
        curves=(
            curve("motion", source="kept", x="period", tint="m1", width="sum", label="motion"),
            curve("energy", source="kept", x="period", tint="ink", width="dash", label="energy"),
        ),
        x_column="period",
        room=Room(44, 60),
        phone=13,
        height=150,
        form="kept",
    )

"""Error against run time, its growth, and the picked run, as plots.

A method has no hue: solid chooses its steps, dashed has fixed steps. Dots are measured here; lines alone, recorded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

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
        shapes=(*_names(), *_meanings(), _ring()),
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
            on_x("work", var(f"{slug}_at")) + aside,
            on_y("work", var(f"{slug}_error")) + var(f"{slug}_shift"),
            method.mark,
            anchor=anchor,
            tint=LOOK[method.family]["tint"],
            style="halo",
            show=f"{slug}_{anchor}",
        )
        for slug, method in METHODS.items()
        for anchor, aside in (("start", 9), ("end", -9))
    )


def _meanings() -> Iterable[AnyShape]:
    """Texts at the two dashed lines, and on what to do where nothing has been measured."""
    limit, rounding = on_x("work", var("limit_at")) - 6, on_y("work", var("rounding_at"))
    told: dict[str, Any] = {"anchor": "end", "tint": "mute", "style": "t1 halo"}
    methods = f"{len(LIVE)} methods"
    x, y = (var("work.left") + var("work.right")) / 2, (var("work.top") + var("work.bottom")) / 2
    return (
        text(limit, rounding - 6, "one rounding of a double, 1.1·10⁻¹⁶", **told),
        text(limit, var("work.top") + 14, "runs here stop at {limit}", show="limit_left", **told),
        text(
            limit + 12,
            var("work.top") + 14,
            "runs here stop at {limit}",
            show="limit_right",
            **{**told, "anchor": "start"},
        ),
        text(
            on_x("work", var("bdf_at")) - 9,
            on_y("work", var("bdf_error")) - 7,
            "most steps by BDF",
            anchor="end",
            tint="mute",
            style="t1 halo",
            show="bdf",
        ),
        text(x, y, f"Press Run: {methods} on this motion, within a minute.", style="halo", show="empty wide"),
        text(x, y - 9, f"Press Run: {methods}", style="halo", show="empty narrow"),
        text(x, y + 9, "on this motion, within a minute.", style="halo", show="empty narrow"),
    )


def _ring() -> AnyShape:
    x, y = on_x("work", var("picked_at")), on_y("work", var("picked_error"))
    return circle(x, y, 9, tint="ink", style="pick", show="picked")


FRAME = (490.0, 475.0)
"""About how many pixels the frame of the plot is wide and high."""
LETTER, LINE, WORDS = 7.5, 15.0, 230.0
PLACES = tuple((side, 5.0 + LINE * step) for step in (0, 1, -1, 2, -2, 3) for side in ("start", "end"))
"""Where a name may stand beside the end of its line: on which side, and how far down; the first is the best."""
STARTS, DOWN = np.array([side == "start" for side, _ in PLACES]), np.array([down for _, down in PLACES])
OUTSIDE = 10_000
"""Worse than any number of overlaps."""
Rectangles = NDArray[np.float64]
"""Left, top, right and bottom (4, ...) in pixels."""


def name_places(curves: dict[str, Columns], time: Axis, error: Axis, limit: float) -> dict[str, float]:
    """The places of the methods' names: at the end of the line, off points, words and other names if possible."""
    if not curves:
        return {}
    left, right, top, bottom = (axis.place(end) for axis in (time, error) for end in (axis.start, axis.end))
    across, down = FRAME[0] / (right - left), FRAME[1] / (bottom - top)
    times, errors = (np.concatenate([line[column] for line in curves.values()]) for column in ("time", "error"))
    x, y = time.places(times) * across, -error.places(errors) * down
    end, line = time.place(limit) * across, -error.place(2.0**-53) * down
    ends = np.cumsum([len(line["time"]) for line in curves.values()]) - 1
    x_end, y_end = x[ends], y[ends]
    boxes = _boxes(x_end[:, np.newaxis], y_end[:, np.newaxis], [len(METHODS[slug].mark) for slug in curves])
    crowds = _meet(boxes[..., np.newaxis], np.array([x - 4, y - 4, x + 4, y + 4])).sum(axis=-1)
    crowds += _meet(boxes, np.array([end - WORDS, line - 18, end, line + 2]))
    crowds += OUTSIDE * ((boxes[0] <= left * across) | (boxes[2] >= right * across))
    scalars: dict[str, float] = {}
    for i, slug in enumerate(curves):
        place = int(np.argmin(crowds[i]))
        crowds += _meet(boxes, boxes[:, i, place])
        side, shift = PLACES[place]
        at = {"at": float(x_end[i]) / across, "error": -float(y_end[i]) / down, side: 1.0, "shift": shift}
        scalars |= {f"{slug}_{name}": value for name, value in at.items()}
    return scalars


def _boxes(x: NDArray[np.float64], y: NDArray[np.float64], letters: list[int]) -> Rectangles:
    """The rectangles of the name at each point (n, 1) in each place: (4, n, places)."""
    wide = LETTER * np.array(letters)[:, np.newaxis]
    start, base = np.where(STARTS, x + 9, x - 9 - wide), y + DOWN
    return np.array([start, base - 12, start + wide, base + 3])


def _meet(one: Rectangles, other: Rectangles) -> NDArray[np.bool_]:
    """Whether each of the one rectangles overlaps each of the others."""
    (left, top, right, bottom), (left2, top2, right2, bottom2) = one, other
    meet: NDArray[np.bool_] = (left < right2) & (left2 < right) & (top < bottom2) & (top2 < bottom)
    return meet


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

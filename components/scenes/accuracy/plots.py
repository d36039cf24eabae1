"""The plots and lists of the accuracy scene. A method has no hue: solid chooses its steps, dashed has fixed steps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from components.axes import Axis
from components.plots import Curve, plot
from components.scene import Columns
from components.scenes.accuracy.data import REACH, TOP, stability
from components.sheet import Block, phrase, table
from components.stage import circle, on_x, on_y, text, var
from physics.integrators import FIXED_STEP
from physics.solvers import METHODS

ROWS, STOPPED = len(METHODS), 8
LOOK: dict[str, dict[str, str]] = {
    "closed": {"tint": "ink", "width": "none", "marker": "disc"},
    "fixed": {"tint": "mute", "width": "dash", "marker": "ring"},
    "adaptive": {"tint": "ink", "width": "line", "marker": "disc"},
}
KEYS = (
    phrase("adaptive", "line", "ink", formula="chooses its steps"),
    phrase("fixed", "dash", "mute", formula="fixed steps"),
    phrase("closed", "none", "ink", formula="● no steps"),
)


def work_plot() -> Block:
    """Error against run time; the pill on the error axis is the error that is good enough."""
    curves = tuple(
        Curve(name="error", source=slug, x="time", group=method.family, **LOOK[method.family])
        for slug, method in METHODS.items()
    )
    names = tuple(
        text(
            on_x("work", var(f"{slug}_at")) + aside,
            on_y("work", var(f"{slug}_error")) + var(f"{slug}_shift"),
            method.name,
            anchor=anchor,
            tint=LOOK[method.family]["tint"],
            style="halo",
            show=f"{slug}_{anchor}",
        )
        for slug, method in METHODS.items()
        for anchor, aside in (("start", 9), ("end", -9))
    )
    ring = circle(
        on_x("work", var("picked_at")), on_y("work", var("picked_error")), 9, tint="ink", style="pick", show="picked"
    )
    return plot(
        "work",
        x="time",
        y="error",
        title="Error of the motion against run time, one line a method",
        curves=curves,
        source=next(iter(METHODS)),
        x_column="time",
        heading=(phrase("", "none", "ink", formula="**Error of the motion, against run time**"), *KEYS),
        handles=(
            {"parameter": "wanted", "symbol": "", "label": "Error that is good enough", "tint": "mute", "axis": "y"},
        ),
        marks=(
            {"at": "wanted_at", "tint": "ink", "html": "", "label": "good enough", "axis": "y"},
            {"at": "rounding_at", "tint": "mute", "html": "", "label": "one rounding", "axis": "y", "style": "dashed"},
            {"at": "limit_at", "tint": "mute", "html": "", "label": "time limit", "style": "dashed"},
        ),
        shapes=(*names, ring),
        pick="picked",
        margin=(54, 12),
        phone=10,
        height=420,
    )


DECADE = (105.0, 27.0)
"""About how many pixels a power of ten takes on the time axis and on the error axis."""
LETTER, LINE = 7.5, 15.0
PLACES = tuple((side, 5.0 + LINE * step) for step in (0, 1, -1, 2, -2, 3) for side in ("start", "end"))
Box = tuple[float, float, float, float]


def name_places(curves: dict[str, Columns], time: Axis, error: Axis) -> dict[str, float]:
    """Where the name of each method stands: at the end of its line, off all points and off the other names."""
    ends = {
        slug: [
            (time.place(t) * DECADE[0], -error.place(e) * DECADE[1]) for t, e in zip(c["time"], c["error"], strict=True)
        ]
        for slug, c in curves.items()
    }
    taken: list[Box] = [(x - 4, y - 4, x + 4, y + 4) for points in ends.values() for x, y in points]
    left, right = time.place(time.start) * DECADE[0], time.place(time.end) * DECADE[0]
    scalars: dict[str, float] = {}
    for slug, points in ends.items():
        if not points:
            continue
        x, y = points[-1]
        boxes = {(side, dy): _box(x, y, side, dy, METHODS[slug].name) for side, dy in PLACES}
        free = (
            place
            for place, box in boxes.items()
            if left < box[0] and box[2] < right and not any(map(box_meets(box), taken))
        )
        side, dy = next(free, PLACES[0])
        taken.append(boxes[side, dy])
        scalars |= {
            f"{slug}_at": x / DECADE[0],
            f"{slug}_error": -y / DECADE[1],
            f"{slug}_{side}": 1.0,
            f"{slug}_shift": dy,
        }
    return scalars


def _box(x: float, y: float, side: str, dy: float, name: str) -> Box:
    start = x + 9 if side == "start" else x - 9 - LETTER * len(name)
    return start, y + dy - 12, start + LETTER * len(name), y + dy + 3


def box_meets(one: Box) -> Callable[[Box], bool]:
    """Whether a box overlaps `one`."""
    return lambda other: one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def growth_plot(of: str, title: str, form: str) -> Block:
    """The worst error so far against simulated time, the finest run of each method."""
    curves = tuple(
        Curve(
            name=of,
            source=f"{of}_{slug}",
            x="period",
            group=method.family,
            label=method.name,
            tint=LOOK[method.family]["tint"],
            width="dash" if method.family == "fixed" else "line",
        )
        for slug, method in METHODS.items()
    )
    return plot(
        of,
        x="period",
        y=of,
        title=title,
        curves=curves,
        source=f"{of}_{next(iter(METHODS))}",
        x_column="period",
        heading=(phrase("", "none", "ink", formula=f"**{title}**"), *KEYS),
        margin=(54, 130),
        phone=10,
        height=420,
        show=form,
    )


def picked_plot() -> Block:
    """Energy kept, phase lost: both errors of the picked run on one axis."""
    return plot(
        "kept",
        x="period",
        y="percent",
        title="Error of the motion and of the energy of the picked run, in percent, against simulated time",
        curves=(
            Curve(name="motion", source="kept", x="period", tint="m1", width="sum", label="motion"),
            Curve(name="energy", source="kept", x="period", tint="ink", width="dash", label="energy"),
        ),
        source="kept",
        x_column="period",
        margin=(44, 60),
        phone=13,
        height=150,
    )


STABILITY_TINT = {slug: "ink" if slug == "verlet" else "mute" for slug in FIXED_STEP}


def leaves(slug: str) -> float:
    """Where the amplification of a method leaves the frame for good."""
    columns = stability()
    return float(columns["h_omega"][columns[slug] <= TOP].max())


def stability_plot() -> Block:
    """Amplification a step against h omega; the present step of the picked run is marked."""
    # A line that leaves the frame at its top has its name where it leaves.
    names = tuple(
        text(
            on_x("stability", leaves(slug)) + 8,
            var("stability.top") + 13,
            METHODS[slug].name,
            anchor="start",
            tint=STABILITY_TINT[slug],
            style="t1 halo",
        )
        for slug in FIXED_STEP
        if leaves(slug) < REACH
    )
    return plot(
        "stability",
        x="h_omega",
        y="growth",
        title="Growth of an oscillation in one step, against step times angular frequency",
        curves=tuple(
            Curve(
                name=slug,
                source="stability",
                x="h_omega",
                tint=STABILITY_TINT[slug],
                width="sum" if slug == "verlet" else "dash" if slug == "midpoint" else "line",
                label="" if leaves(slug) < REACH else METHODS[slug].name,
            )
            for slug in FIXED_STEP
        ),
        source="stability",
        x_column="h_omega",
        heading=(phrase("", "none", "ink", formula="**Growth a step**, against $h\\,\\omega_+$: above 1 it explodes"),),
        marks=({"at": "step_at", "tint": "ink", "html": "picked", "label": "Step of the picked run", "lift": 32},),
        shapes=names,
        margin=(44, 130),
        top=36,
        phone=10,
        height=260,
    )


def steps_plot() -> Block:
    """How many steps stability asks of an explicit method as spring 2 stiffens."""
    explicit = [slug for slug in FIXED_STEP if slug != "midpoint"]
    return plot(
        "explosion",
        x="ratio",
        y="steps",
        title="Steps in a slow period that stability asks for, against k2/k1",
        curves=tuple(
            Curve(
                name=f"steps_{slug}", source="explosion", x="ratio", tint="ink", width="line", label=METHODS[slug].name
            )
            for slug in explicit
        ),
        source="explosion",
        x_column="ratio",
        heading=(
            phrase("", "none", "ink", formula="**Steps in a slow period** that stability asks for, against $k_2/k_1$"),
        ),
        margin=(54, 130),
        phone=11,
        height=220,
    )


def price_rows(**place: Any) -> Block:
    """The methods in the order of what the wanted error costs with each."""
    return _rows("price", ("name", "time", "ratio"), ROWS, **place)


def stopped_rows(**place: Any) -> Block:
    """Methods without a result, each with its reason."""
    return _rows("stopped", ("name", "why"), STOPPED, **place)


def _rows(form: str, cells: tuple[str, ...], count: int, **place: Any) -> Block:
    rows: list[list[str | dict[str, str]]] = [
        [{"form": f"{form}{i}", "shown": f"{{{form}{i}_{cell}}}"} for cell in cells] for i in range(count)
    ]
    return table(*rows, style="tight", **place)

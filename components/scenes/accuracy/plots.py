"""Error against run time, its growth, and the picked run, as plots.

A method has no hue: solid chooses its steps, dashed has fixed steps. Dots are measured here; lines alone, recorded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from components.language.blocks import Block
from components.language.expressions import var
from components.language.plots import Curve, Handle
from components.language.shapes import AnyShape
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import phrase
from components.layout.stage import ON_NARROW, ON_WIDE, Looks, PlotFrame, circle, shown_by, text
from components.quantities.declared import AxesInForce, Declared, DrawnAxis, Family, Scalar
from components.scenes.accuracy.axes import Axes
from components.scenes.accuracy.case import NAMED, AccuracyCase
from components.scenes.accuracy.data import ADAPTIVE, ALONE, ASKED, BEHIND, MORE, Kept
from components.scenes.accuracy.measuring import LIVE
from components.scenes.accuracy.words import Forms
from components.scenes.accuracy.words import Numbers as N
from physics.integrators.accuracy import Run
from physics.integrators.price import LEAST
from physics.integrators.solvers import METHODS

WORK = PlotFrame("work")
LOOK: dict[str, Looks] = {
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


scalar = Scalar[AccuracyCase]


def _time(run: Run | None, axes: AxesInForce) -> float | None:
    return None if run is None else Axes.time(axes).place(run.time or 0.0)


def _error(run: Run | None, axes: AxesInForce) -> float | None:
    return None if run is None else Axes.error(axes).place(max(run.error or 0.0, LEAST))


def _step(case: AccuracyCase) -> float | None:
    """The step of the picked run times the fast angular frequency, where it has fixed steps."""
    if case.run is None or case.run.family != "fixed":
        return None
    problem = case.system.problem()
    return min(problem.spacing * problem.rates[1] / case.run.setting, 1e30)


class Places(Declared[AccuracyCase]):
    wanted_at = scalar(lambda c, a: Axes.error(a).place(c.wanted))
    rounding_at = scalar(lambda c, a: Axes.error(a).place(2.0**-53))
    limit_at = scalar(lambda c, a: Axes.time(a).place(c.limit))
    empty = scalar(lambda c, a: not c.known.here.every and not c.known.before.every)
    # The ends of the lines, beside which the names of the methods stand.
    named = Family(NAMED, lambda slug: scalar(lambda c, a: slug in c.named), "{}_named")
    at = Family(NAMED, lambda slug: scalar(lambda c, a: _time(c.named.get(slug), a)), "{}_at")
    error = Family(NAMED, lambda slug: scalar(lambda c, a: _error(c.named.get(slug), a)), "{}_error")
    picked = scalar(lambda c, a: c.run is not None)
    picked_named = scalar(lambda c, a: c.run is not None and c.run.method not in c.named)
    picked_at = scalar(lambda c, a: _time(c.run, a))
    picked_error = scalar(lambda c, a: _error(c.run, a))
    step_at = scalar(lambda c, a: _step(c))


def work_plot() -> Block:
    """Error against run time; the pill on the error axis is the error that is good enough."""
    return plot(
        WORK,
        x=Axes.time,
        y=Axes.error,
        title="Error of the motion against run time, one line a method",
        curves=(*_recorded(), *_front(), *_tolerances()),
        x_column=Axes.time,
        heading=(phrase("", "none", "ink", formula="**Error against run time**, steps"), *KEYS),
        handles=(Handle(parameter="wanted", label="Accepted error", tint="mute", axis="y"),),
        marks=(
            mark(Places.wanted_at, label="accepted error", axis="y"),
            mark(Places.rounding_at, tint="mute", label="one rounding", axis="y", style="dashed"),
            mark(Places.limit_at, tint="mute", label="time limit", style="dashed"),
        ),
        shapes=(*_meanings(), *_names(), *_ring()),
        pick="picked",
        room=Room(54, 84),
        phone=10,
        height=420,
    )


def _front() -> Iterable[Curve]:
    return (curve(Axes.error, source=slug, group=METHODS[slug].family, **LOOK[METHODS[slug].family]) for slug in LIVE)


def _recorded() -> Iterable[Curve]:
    """Of the methods that can be measured here as strong as these, until they are."""
    for slug, method in METHODS.items():
        look, group = LOOK[method.family], method.family if slug in LIVE else MORE
        thin = "none" if look["width"] == "none" else "thin"
        strong = look["width"] if slug in LIVE else thin
        for source, width, tint in ((BEHIND + slug, thin, "mute"), (ALONE + slug, strong, look["tint"])):
            marker = "ring" if width == "none" else ""
            yield curve(Axes.error, source=source, group=group, tint=tint, width=width, marker=marker)


def _tolerances() -> Iterable[Curve]:
    for slug in ADAPTIVE:
        group = "adaptive" if slug in LIVE else MORE
        yield curve(Axes.error, source=ASKED + slug, group=group, tint="ink", width="none", marker="ring")


def _names() -> Iterable[AnyShape]:
    """The names at the ends of the lines; that of the closed form over the line of one rounding."""
    for slug in NAMED:
        x, y = WORK.x(var(Places.at[slug])), WORK.y(var(Places.error[slug])) - (14 if slug == "closed" else 0)
        look = {"anchor": "beside", "tint": LOOK[METHODS[slug].family]["tint"], "style": "halo"}
        yield text(x, y, METHODS[slug].mark, show=Places.named[slug], **look)


def _meanings() -> Iterable[AnyShape]:
    """Texts at the two dashed lines, and on what to do where nothing has been measured."""
    limit, rounding = WORK.x(var(Places.limit_at)), WORK.y(var(Places.rounding_at))
    told: dict[str, Any] = {"tint": "mute", "style": "t1 halo"}
    methods = f"{len(LIVE)} methods"
    x, y = (WORK.left + WORK.right) / 2, (WORK.top + WORK.bottom) / 2
    return (
        text(limit - 6, rounding + 14, "one rounding", anchor="end", **told),
        text(limit, WORK.top, f"runs here stop at {N.limit}", anchor="beside", **told),
        *shown_by(
            Places.empty,
            text(x, y, f"Press Run: {methods} on this motion, within a minute.", style="halo", show=ON_WIDE),
            text(x, y - 9, f"Press Run: {methods}", style="halo", show=ON_NARROW),
            text(x, y + 9, "on this motion, within a minute.", style="halo", show=ON_NARROW),
        ),
    )


def _ring() -> Iterable[AnyShape]:
    """A ring around the selected run, with the name of its method if the plot does not show that name already."""
    x, y = WORK.x(var(Places.picked_at)), WORK.y(var(Places.picked_error))
    yield circle(x, y, 9, tint="ink", style="pick", show=Places.picked)
    yield text(x, y - 14, f"{N.picked_method}", style="halo", show=Places.picked_named)


def growth_plot(of: DrawnAxis, title: str, *, phone: int) -> Block:
    """The worst error so far against simulated time, one run of each method."""
    curves = tuple(
        curve(
            of,
            source=f"{of.name}_{slug}",
            group=method.family if slug in LIVE else MORE,
            label=method.mark,
            tint=LOOK[method.family]["tint"],
            width="dash" if method.family == "fixed" else "line" if slug in LIVE else "thin",
        )
        for slug, method in METHODS.items()
    )
    keys = KEYS if of is Axes.error_growth else ()
    return plot(
        PlotFrame(of.name),
        x=Axes.period,
        y=of,
        title=title,
        curves=curves,
        x_column=Axes.period,
        heading=(phrase("", "none", "ink", formula=f"**{title}**{', steps' if keys else ''}"), *keys),
        room=Room(54, 140),
        style="many",
        phone=phone,
        height=300,
    )


def picked_plot() -> Block:
    """Energy kept, phase lost: both errors of the picked run on one axis."""
    return plot(
        PlotFrame("kept"),
        x=Axes.period,
        y=Axes.percent,
        title="Error of the motion and of the energy of the picked run, in percent, against simulated time",
        curves=(
            curve(Kept.motion, tint="m1", width="sum", label="motion"),
            curve(Kept.energy, tint="ink", width="dash", label="energy"),
        ),
        x_column=Kept.period,
        room=Room(44, 60),
        style="few",
        phone=17,
        height=150,
        form=Forms.kept,
    )

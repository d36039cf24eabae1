"""The first view: one motion by three methods, and how each of them leaves the exact one."""

from __future__ import annotations

import math

import numpy as np

from components.language.blocks import Block
from components.layout.plots import Room, curve, plot
from components.layout.sheet import column, phrase, words
from components.layout.stage import PlotFrame
from components.quantities.declared import by_name
from components.scene.traces import Columns
from components.scenes.accuracy.axes import Axes
from components.scenes.accuracy.case import AccuracyCase
from components.scenes.accuracy.words import Numbers as N
from physics.integrators.drift import PERIODS, Drift
from physics.integrators.solvers import METHODS

LOOKS = {"euler": ("T", "dash"), "verlet": ("m1", "line"), "rk4": ("V", "dash")}
"""Tint and line of each method."""
MOST = 200
"""Points of a line; of a finer motion every so many steps are drawn."""


def drift_view() -> Block:
    names = (phrase(f"drift_{slug}", width, tint, formula=METHODS[slug].mark) for slug, (tint, width) in LOOKS.items())
    return column(
        plot(
            PlotFrame("drift"),
            x=Axes.drift_t,
            y=Axes.drift_x,
            title="Displacement of mass 1 against time: exact, and by three methods in steps",
            curves=(
                curve(Axes.drift_x, source="drift_exact", group="drift_exact", tint="mute", width="sum", read="exact"),
                *(
                    curve(
                        Axes.drift_x,
                        source=f"drift_{slug}",
                        group=f"drift_{slug}",
                        tint=tint,
                        width=width,
                        read=METHODS[slug].mark,
                    )
                    for slug, (tint, width) in LOOKS.items()
                ),
            ),
            x_column=Axes.drift_t,
            heading=(phrase("drift_exact", "sum", "mute", formula="exact"), *names),
            room=Room(54, 24),
            phone=10,
            height=290,
        ),
        words(
            "Each step is a little wrong, and the errors add up. Percentages are of the largest displacement.",
            f"{N.drifted}",
            name="drift",
            phone=16,
        ),
    )


def drift_columns(case: AccuracyCase) -> dict[str, Columns]:
    """The exact motion of mass 1 and that by each method, in m against periods."""
    motions, period = {"exact": case.exact} | case.drifts, case.exact.t[-1] / PERIODS
    return {f"drift_{slug}": _drawn(motions[slug], period) if slug in motions else {} for slug in ("exact", *LOOKS)}


def _drawn(motion: Drift, period: float) -> Columns:
    """Columns of few points, with the last one."""
    every = math.ceil(motion.t.size / MOST)
    t, x = (np.append(of[:-1:every], of[-1]) for of in (motion.t / period, motion.x))
    return by_name({Axes.drift_t: t, Axes.drift_x: x})

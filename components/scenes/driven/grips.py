"""Draggable rings on a plot against time, which set the height of a push, its period, and the width of its pulses."""

from __future__ import annotations

from collections.abc import Callable

from components.language.expressions import Number
from components.language.shapes import Along, Quotient
from components.layout.grabs import grab
from components.layout.stage import Looks, Shape, circle
from components.paper.deferred import number
from components.paper.plot_axes import PlotAxis
from components.paper.plots import Plot, PlotValue, along, number_name
from components.scenes.driven.plots import c

RING: Looks = {"style": "ghost", "tint": "F"}


def grips(plot: Plot, up: Callable[[PlotValue], Number], axis: PlotAxis) -> list[Shape]:
    """Return the rings. `up` returns the pixel of a force, given in the unit of an axis."""
    left, window = plot.x(0), plot.across_pixels(c.end)
    period = window * number(c.period_share)
    sets_period = Quotient(
        across="x", zero=left, unit=window, parameter="omega", moves=number_name(c.period_share),
        over=number_name(c.full_turn), least=0.02,
    )  # fmt: skip
    sets_width = Along(
        across="x", zero=left, unit=period, parameter="width", moves=number_name(c.pulse_width), least=0.01, most=0.99
    )
    top, half = left + window * number(c.crest), left + period * number(c.pulse_width)
    sets_force, sets_impulse = (
        along("y", up, axis, F_0=c.F_high, least=0.0),
        along("y", up, axis, J=c.J_high, least=0.0),
    )
    return [
        circle(top, up(c.F_high), 5, **RING, grab=grab("Height of the push", sets_force)),
        circle(top, up(c.J_high), 5, **RING, grab=grab("Size of the impulses", sets_impulse)),
        circle(half, up(c.half_F), 5, **RING, grab=grab("Width of the pulses", sets_width)),
        circle(left + period, up(0), 5, **RING, grab=grab("Period of the push", sets_period)),
    ]

"""The plots of the driven mass, with their axes."""

from __future__ import annotations

import math

from components.language.plots import Room
from components.paper.deferred import deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, form_of, handle
from components.quantities.axes import Axis
from components.scenes.driven.shown import DrivenShown

c = deferred(DrivenShown)
ROOM = 1.2
"""The end of the axis of x, relative to the largest drawn value."""
SIDES, LEFT = Room(48, 26), Room(40, 14, top=10)
LAGS = Axis(
    0.0, 1.08 * math.pi, "rad", ticks=(0.0, math.pi / 2, math.pi), labels=("0", "π/2", "π"), drawn=(0.0, math.pi)
)
R, DRIVE = axis("", lambda c: c.ratio_axis, "r"), axis("", lambda c: c.drive_axis, "drive")
X = Plot("x", TIME, axis("m", lambda c: (-c.tallest, c.tallest), room=ROOM, count=2))
POWER = Plot("power", TIME, axis("W", lambda c: c.power_ends, "P", count=1, seen=lambda c: c.power_range))
RESPONSE = Plot("response", R, axis("", lambda c: c.response_axis, "M"))
PHASE = Plot("phase", R, axis("", lambda c: LAGS, "lag"))
HARMONICS, PUSHED = Plot("harmonics", R, RESPONSE.up), Plot("pushed", TIME, X.up)
SUM = Plot("sum", TIME, axis("m", lambda c: (-c.sum_reach, c.sum_reach), room=ROOM, count=2, like=X.up))
FORCE = Plot("force", TIME, axis("N", lambda c: c.slice_axis))
REPEATS = form_of(c.repeats)
OMEGA = handle(c.r, parameter="omega", symbol="frequency ratio r", label="Drive frequency", tint="F", form=REPEATS.name)
"""The handle of the drive frequency on the axis of r."""

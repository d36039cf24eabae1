"""Grabs of the chain's masses: dragging a mass sets the initial conditions."""

from __future__ import annotations

from components.chain.modes import BOTH
from components.chain.signals import Axes
from components.chain.signals import Signals as S
from components.chain.stage import Places, rest
from components.language.expressions import var
from components.language.shapes import Along, Grab
from components.layout.grabs import at_rest, begin, begins
from components.layout.stage import W

PLACES = tuple(begins(f"x{i}_0", S.x[i], Axes.x) for i in BOTH)
VELOCITIES = at_rest("v1_0", "v2_0")


def mass_grab(mass: int, *, flicked: bool = True) -> Grab:
    """Return the grab of mass 1 or 2; if the scene has no velocities, the motion begins at rest."""
    rate, unit = f"v{mass}_0" if flicked else "", var(Places.metre) * W
    way = Along(
        across="x",
        zero=rest(mass),
        unit=unit,
        parameter=f"x{mass}_0",
        moves=S.x[mass].name,
        axis=Axes.x.name,
        rate=rate,
    )
    return begin(f"Mass {mass}, start", way, start=PLACES + (VELOCITIES if flicked else ()))

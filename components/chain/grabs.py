"""How the masses of the chain are taken in hand: where they are held is the start."""

from __future__ import annotations

from components.chain.stage import rest
from components.grabs import at_rest, begin, on_plot
from components.page.numbers import var
from components.page.shapes import Along, Begin, Grab
from components.stage import W

PLACES = (Begin("x1_0", "x1", "x"), Begin("x2_0", "x2", "x"))
VELOCITIES = at_rest("v1_0", "v2_0")


def mass_grab(mass: int, *, flicked: bool = True) -> Grab:
    """Of mass 1 or 2; where the scene has no velocities it is let go from rest."""
    way = Along(
        parameter=f"x{mass}_0",
        moves=f"x{mass}",
        axis="x",
        rate=f"v{mass}_0" if flicked else "",
        across="x",
        zero=rest(mass),
        unit=var("metre") * W,
    )
    return begin(f"Mass {mass}, start", way, start=PLACES + (VELOCITIES if flicked else ()))


def plane_grab(plot: str) -> Grab:
    """Of the point in the plane (x1, x2)."""
    ways = (on_plot(plot, "x", "x1_0", "x1", "x"), on_plot(plot, "y", "x2_0", "x2", "x"))
    return begin("Both masses, start", *ways, start=PLACES + VELOCITIES)

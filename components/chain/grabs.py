"""Grabs of the chain's masses: the place where a hand lets go of one is the start of a motion."""

from __future__ import annotations

from typing import Literal

from components.chain.modes import MODES, directions
from components.chain.stage import rest
from components.language.numbers import Number, var
from components.language.shapes import Along, Begin, Grab, Share, Swung
from components.layout.grabs import at_rest, begin, on_plot
from components.layout.stage import W
from components.quantities.axes import TIME_AXIS
from physics.coupled import TwoMassChain

PLACES = (Begin("x1_0", "x1", "x"), Begin("x2_0", "x2", "x"))
VELOCITIES = at_rest("v1_0", "v2_0")


def mass_grab(mass: int, *, flicked: bool = True) -> Grab:
    """The grab of mass 1 or 2; where the scene has no velocities it is let go from rest."""
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
    """The grab of the point in the plane (x1, x2)."""
    ways = (on_plot(plot, "x", "x1_0", "x1", "x"), on_plot(plot, "y", "x2_0", "x2", "x"))
    return begin("Both masses, start", *ways, start=PLACES + VELOCITIES)


def mode_grab(mode: str, mass: int) -> Grab:
    """The grab of mass 1 or 2 in one mode alone: its part of the start; the other mode goes on as it was."""
    other = _other(mode)
    places = tuple(Begin(f"x{i}_0", f"x{i}", "x", exactly=True) for i in (1, 2))
    going = tuple(Begin(f"v{i}_0", f"v{i}_{other}", "x", per=TIME_AXIS, exactly=True) for i in (1, 2))
    ways = (
        Share(
            parameter=f"x{i}_0",
            moves=f"x{i}_{mode}",
            axis="x",
            rate=f"v{i}_0",
            across="x",
            zero=rest(mass),
            unit=var("metre") * W,
            share=_share(mode, i, mass),
            rest=f"x{i}_{other}",
        )
        for i in (1, 2)
    )
    return begin(_label(mode, mass), *ways, start=places + going)


def swing_grab(mode: str, mass: int) -> Grab:
    """The grab of a mass in one mode where modes give the motion: it sets the mode's amplitude and phase."""
    other = _other(mode)
    of: tuple[tuple[Literal["amplitude", "phase"], str], ...] = (("amplitude", "X"), ("phase", "phi"))
    ways = (
        Swung(
            parameter=f"{symbol}_{mode}",
            of=name,
            moves=f"x{i}_{mode}",
            axis="x",
            across="x",
            zero=rest(mass),
            unit=var("metre") * W,
            counted=var(f"{mode}_by_{mass}"),
            share=_share(mode, i, mass),
            turn=f"turn_{mode}",
        )
        for i, (name, symbol) in enumerate(of, start=1)
    )
    going = Begin(f"phi_{other}", f"turn_{other}", exactly=True, angle=True)
    return begin(_label(mode, mass), *ways, start=(going,))


def _other(mode: str) -> str:
    return MODES[1 - MODES.index(mode)]


def _share(mode: str, i: int, mass: int) -> Number:
    return 1.0 if i == mass else var(f"{mode}_{i}_by_{mass}")


def _label(mode: str, mass: int) -> str:
    return f"{mode.capitalize()} mode, start, by mass {mass}"


def shares(system: TwoMassChain) -> dict[str, float]:
    """The ratios of the masses' displacements in each mode, and, by mass, the factor from its displacement to the
    mode's amplitude: 0 for one that rests, and so cannot be taken."""
    found: dict[str, float] = {}
    for mode, (one, two) in zip(MODES, directions(system), strict=True):
        found |= {f"{mode}_2_by_1": two / one if one else 0.0, f"{mode}_1_by_2": one / two if two else 0.0}
        found |= {f"{mode}_by_1": float(one != 0), f"{mode}_by_2": (one / two if one else 1.0) if two else 0.0}
    return found

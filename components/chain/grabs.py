"""Grabs of the chain's masses: the place where a hand lets go of one is the start of a motion."""

from __future__ import annotations

from typing import Any, Literal

from components.chain.modes import BOTH, MODES, PARTS, directions
from components.chain.signals import Axes
from components.chain.signals import Signals as S
from components.chain.stage import Places, rest
from components.language.numbers import Number, var
from components.language.shapes import Along, Grab, Share, Swung
from components.layout.grabs import at_rest, begin, begins, on_plot
from components.layout.stage import PlotFrame, W
from components.quantities.declared import Declared, Scalar, by_name
from physics.coupled import TwoMassChain

scalar = Scalar[TwoMassChain]


class Shares(Declared[TwoMassChain]):
    """The displacement of a mass over that of the other one in each mode, and the amplitude of the mode over that of a
    mass: 0 of one that rests, and so cannot be taken."""

    share = scalar.each(((mode, i, 3 - i) for i, mode in PARTS), "{}_{}_by_{}")
    by = scalar.each(((mode, i) for i, mode in PARTS), "{}_by_{}")


PLACES = tuple(begins(f"x{i}_0", S.x[i], Axes.x) for i in BOTH)
VELOCITIES = at_rest("v1_0", "v2_0")


def mass_grab(mass: int, *, flicked: bool = True) -> Grab:
    """The grab of mass 1 or 2; where the scene has no velocities it is let go from rest."""
    rate = f"v{mass}_0" if flicked else ""
    way = Along(parameter=f"x{mass}_0", moves=S.x[mass].name, rate=rate, **_across(mass))
    return begin(f"Mass {mass}, start", way, start=PLACES + (VELOCITIES if flicked else ()))


def plane_grab(plot: PlotFrame) -> Grab:
    """The grab of the point in the plane (x1, x2)."""
    ways = (on_plot(plot, "x", "x1_0", S.x[1], Axes.x), on_plot(plot, "y", "x2_0", S.x[2], Axes.x))
    return begin("Both masses, start", *ways, start=PLACES + VELOCITIES)


def mode_grab(mode: str, mass: int) -> Grab:
    """The grab of mass 1 or 2 in one mode alone: its part of the start; the other mode goes on as it was."""
    other = _other(mode)
    places = tuple(begins(f"x{i}_0", S.x[i], Axes.x, exactly=True) for i in BOTH)
    going = tuple(begins(f"v{i}_0", S.v_part[i, other], Axes.x, per=Axes.t, exactly=True) for i in BOTH)
    ways = (
        Share(
            parameter=f"x{i}_0",
            moves=S.x_part[i, mode].name,
            rate=f"v{i}_0",
            share=_share(mode, i, mass),
            rest=S.x_part[i, other].name,
            **_across(mass),
        )
        for i in BOTH
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
            moves=S.x_part[i, mode].name,
            counted=var(Shares.by[mode, mass]),
            share=_share(mode, i, mass),
            turn=S.turn[mode].name,
            **_across(mass),
        )
        for i, (name, symbol) in enumerate(of, start=1)
    )
    going = begins(f"phi_{other}", S.turn[other], exactly=True, angle=True)
    return begin(_label(mode, mass), *ways, start=(going,))


def _other(mode: str) -> str:
    return MODES[1 - MODES.index(mode)]


def _across(mass: int) -> dict[str, Any]:
    """The way of a hand that takes a mass along the floor."""
    return {"axis": Axes.x.name, "across": "x", "zero": rest(mass), "unit": var(Places.metre) * W}


def _share(mode: str, i: int, mass: int) -> Number:
    return 1.0 if i == mass else var(Shares.share[mode, i, mass])


def _label(mode: str, mass: int) -> str:
    return f"{mode.capitalize()} mode, start, by mass {mass}"


def shares(system: TwoMassChain) -> dict[str, float]:
    """The scalars by which a hand takes a mode."""
    found, share, by = dict[Scalar[TwoMassChain], float](), Shares.share, Shares.by
    for mode, (one, two) in zip(MODES, directions(system), strict=True):
        found |= {share[mode, 2, 1]: two / one if one else 0.0, share[mode, 1, 2]: one / two if two else 0.0}
        found |= {by[mode, 1]: float(one != 0), by[mode, 2]: (one / two if one else 1.0) if two else 0.0}
    return by_name(found)

"""'About these numbers' of the flight."""

from __future__ import annotations

import numpy as np

from components.quantities.formatting import short, three
from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, few_of, rows
from components.scenes.phugoid.curves import Signals as S
from components.scenes.phugoid.swing import Swing
from physics.phugoid import flight, invariant
from physics.reference.single import flight_points

FLIGHT, EACH_SWING = 32, 32
"""In ulp: the error of the first period of a flight, and the phase error that each later one adds."""


def flight_about(picture: Picture, swing: Swing) -> About:
    columns = picture.sources["time"]
    t = columns["t"]
    true = flight_points(swing.v_0, swing.g, swing.excess, few_of(t))
    names = {S.h: "$h'$", S.v: "$v'$"}
    later = max(0.0, float(t[-1]) / swing.period - 1)
    bound = bounded(
        "the flight",
        float(np.ceil(FLIGHT + EACH_SWING * later)),
        r"$v_0^2/g$ for $h'$, of $v_0$ for $v'$",
        rows(names, columns, true),
    )
    motion = flight(swing.v_0, swing.g, swing.excess, t)
    V, u = motion.V / swing.v_0, motion.u / swing.v_0
    C = invariant(swing.excess)
    strays = float(np.max(np.abs(u - V**3 / 3 - C)))
    kept = f"The flight's invariant $C = u - V^3/3$ = {three(C)}, within {short(strays)} over the window."
    return About((bound,), kept, drawn_as_bands(picture.sources, names))

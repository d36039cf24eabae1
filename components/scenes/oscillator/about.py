"""'About these numbers' of the oscillator."""

from __future__ import annotations

import numpy as np

from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, drift, few_of, reason_of, rows
from components.scenes.oscillator.curves import Signals as S
from physics.energy import half_square
from physics.hanging import HangingMass
from physics.oscillator import Oscillator
from physics.reference_single import oscillator_points


def oscillator_about(picture: Picture, oscillator: Oscillator, x_0: float, v_0: float) -> About:
    columns = picture.sources["time"]
    names = {S.x: "$x$", S.v: "$v$", S.a: "$a$"}
    found = rows(names, columns, oscillator_points(oscillator, x_0, v_0, few_of(columns["t"])))
    return About(
        (bounded("$x(t)$, $v(t)$ or $a(t)$", 4, "its amplitude", found),),
        _oscillator_drift(oscillator, x_0, v_0, columns["t"]),
        drawn_as_bands(picture.sources, names),
    )


def _oscillator_drift(oscillator: Oscillator, x_0: float, v_0: float, t: np.ndarray) -> str:
    motion = oscillator.motion(x_0, v_0, t)
    try:
        total = half_square("T", oscillator.m, motion.v) + half_square("V", oscillator.k, motion.x)
        if not oscillator.k:
            return drift(total, float(total[0]))
        return drift(total, HangingMass(m=oscillator.m, k=oscillator.k, g=0.0).total_energy(x_0, v_0))
    except ValueError as reason:
        return f"$T + V$ cannot be computed over the window: {reason_of(reason)}."

"""'About these numbers' of the machine and its absorber."""

from __future__ import annotations

import numpy as np

from components.chain.about import FREQUENCY
from components.scene import Picture
from components.scene.about import NO_BAND, About, bounded, few, rows
from components.scenes.absorber.duty import Duty
from physics.reference import Point
from physics.reference_single import steady_points, stroke_points


def absorber_about(picture: Picture, duty: Duty) -> About:
    """Swing and stroke, with and without the absorber."""
    columns = picture.sources["sweep"]
    caps = {"swing": picture.axes["X1"].end, "stroke": picture.axes["X2"].end, "alone": picture.axes["X1"].end}
    inside = np.flatnonzero(np.all([columns[name] < cap for name, cap in caps.items()], axis=0))
    at = inside[few(inside)].tolist()
    w = columns["w"][at].tolist()
    swing = steady_points(duty.chain, duty.c, duty.F_0, w)[0] if at else []
    stroke = stroke_points(duty.chain, duty.c, duty.F_0, w)
    alone = steady_points(duty.bare.chain, 0.0, duty.F_0, w)[0] if at else []
    true = {"swing": swing, "stroke": stroke, "alone": alone}
    sizes = {name: [Point(abs(point.value), point.size) for point in points] for name, points in true.items()}
    names = {"swing": "$|X_1|$", "stroke": "$|X_2 - X_1|$", "alone": "$|X_1|$ alone"}
    if duty.loose:
        del names["stroke"]
    found = rows(names, columns, sizes, at, FREQUENCY)
    bound = bounded("$|X_1|$, with the absorber or alone, or of $|X_2 - X_1|$", 6, "its own value", found)
    return About((bound,), envelope=f"{NO_BAND} Where a resonance is infinite no point is drawn.")

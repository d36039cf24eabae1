"""'About these numbers' of the machine and its absorber."""

from __future__ import annotations

import numpy as np

from components.chain.about import FREQUENCY
from components.quantities.declared import by_name
from components.scene import Picture
from components.scene.about import NO_BAND, About, bounded, few, rows
from components.scenes.absorber.case import AbsorberCase
from components.scenes.absorber.curves import Axes
from components.scenes.absorber.curves import Sweep as S
from physics.reference.driven_chain import Point
from physics.reference.single import steady_points, stroke_points


def absorber_about(picture: Picture, case: AbsorberCase) -> About:
    """Errors of swing and stroke, with and without the absorber."""
    columns, swings, strokes = picture.sources[S.w.source], Axes.X1(picture.axes).end, Axes.X2(picture.axes).end
    caps = by_name({S.swing: swings, S.stroke: strokes, S.alone: swings})
    inside = np.flatnonzero(np.all([columns[name] < cap for name, cap in caps.items()], axis=0))
    at = inside[few(inside)].tolist()
    w = columns["w"][at].tolist()
    swing = steady_points(case.chain, case.c, case.F_0, w)[0] if at else []
    stroke = stroke_points(case.chain, case.c, case.F_0, w)
    alone = steady_points(case.bare.chain, 0.0, case.F_0, w)[0] if at else []
    true = by_name({S.swing: swing, S.stroke: stroke, S.alone: alone})
    sizes = {name: [Point(abs(point.value), point.size) for point in points] for name, points in true.items()}
    names = {S.swing: "$|X_1|$", S.stroke: "$|X_2 - X_1|$", S.alone: "$|X_1|$ alone"}
    if case.loose:
        del names[S.stroke]
    found = rows(names, columns, sizes, FREQUENCY, at)
    bound = bounded("$|X_1|$, with the absorber or alone, or of $|X_2 - X_1|$", 6, "its own value", found)
    return About((bound,), envelope=f"{NO_BAND} Where a resonance is infinite no point is drawn.")

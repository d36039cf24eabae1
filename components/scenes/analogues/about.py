"""'About these numbers' of the nine systems."""

from __future__ import annotations

import numpy as np

from components.quantities.declared import by_name
from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, drift, few_of, rows
from components.scenes.analogues.case import AnalogueCase
from components.scenes.analogues.curves import Signals as S
from physics.reference.single import oscillator_points, pendulum_points


def analogue_about(picture: Picture, case: AnalogueCase) -> About:
    """Errors of the coordinate, and of the displacement of the equivalent spring."""
    columns = picture.sources["time"]
    t = few_of(columns["t"])
    spring = oscillator_points(case.spring, case.q_0, 0.0, t)["x"]
    true = by_name({S.q: pendulum_points(case.pendulum, case.q_0, t) if case.pendulum else spring, S.x: spring})
    symbol = f"${case.system.coordinate}$"
    names = {S.q: symbol, S.x: "spring"} if case.pendulum else {S.q: symbol}
    found = rows(names, columns, true)
    return About(
        (bounded(f"{symbol} over $t$", 4, "its amplitude, with the roles of $m$ and $k$ rounded to doubles", found),),
        _analogue_drift(case, columns["t"]),
        drawn_as_bands(picture.sources, names),
    )


def _analogue_drift(case: AnalogueCase, t: np.ndarray) -> str:
    """T + V relative to its initial value, so that no energy leaves the range of doubles."""
    if not case.q_0:
        return drift(np.zeros_like(t), 0.0)
    if case.pendulum:
        motion, size = case.swing(t)
        top = np.sin(size / 2)
        rate, place = motion.theta_dot / (2 * case.pendulum.omega_0), np.sin(motion.theta / 2)
        share = (rate / top) ** 2 + (place / top) ** 2
    else:
        swing = case.spring.motion(case.q_0, 0.0, t)
        share = (swing.v / case.omega / case.q_0) ** 2 + (swing.x / case.q_0) ** 2
    level = case.exact_energy
    return drift(level * share, level, unit="J/m²" if case.system.slug == "wave" else "J")

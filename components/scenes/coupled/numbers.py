"""The live numbers of the coupled masses."""

from __future__ import annotations

import math

import numpy as np

from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.numbers import plus, signed, three
from components.scenes.coupled.curves import Axes
from physics.coupled import FreeModes

BEATS = 1e-3
"""A mode smaller than this share of the other leaves no beat that is seen."""
CLOSE = 0.2
"""The difference of the frequencies over their sum up to which two sines are seen to beat."""

number = LiveNumber[FreeModes]


def beating(free: FreeModes) -> str:
    """Whether the motion beats: both modes move, none is a drift, their frequencies are close; or why it does not."""
    if not (np.any(free.amplitude) or np.any(free.drift_b)):
        return "rest"
    slow, fast = free.omega.tolist()
    if not slow:
        return "drift"
    sizes = [sorted(map(abs, of_mass)) for of_mass in free.amplitude.T.tolist()]
    if not any(less > BEATS * more for less, more in sizes):
        return "one"
    return "both" if free.chain.modes().beat <= CLOSE * (slow + fast) else "apart"


def shape(ratio: float) -> str:
    return "∞" if math.isinf(ratio) else signed(ratio)


class Numbers(Declared[FreeModes]):
    E_unit = AxisUnit(Axes.E)
    omega_minus = number(lambda c: float(c.omega[0]), "ω_{−}", "rad/s", "slow")
    ratio_minus = number(lambda c: float(c.chain.modes().ratio[0]), "X₂/X₁_{−}", tint="slow", form=shape)
    omega_plus = number(lambda c: float(c.omega[1]), "ω_{+}", "rad/s", "fast")
    ratio_plus = number(lambda c: float(c.chain.modes().ratio[1]), "X₂/X₁_{+}", tint="fast", form=shape)
    E_minus = number(lambda c: float(c.energy[0]), "E_{−}", "J", "slow", axis=E_unit)
    E_plus = number(lambda c: float(c.energy[1]), "E_{+}", "J", "fast", axis=E_unit)
    E_total = number(lambda c: float(c.energy.sum()), axis=E_unit)
    X_slow = X1_minus, X2_minus = number.both(lambda c: c.amplitude[0])
    X_fast = X1_plus, X2_plus = number.both(lambda c: c.amplitude[1], plus)
    phi_minus, phi_plus = number.both(lambda c: c.phase, plus)
    a = a1, a2 = number.both(lambda c: c.drift_a)
    b = b1, b2 = number.both(lambda c: c.drift_b, plus)
    M = M_minus, M_plus = number.both(lambda c: [mode.mass for mode, _, _ in c.each()])
    q = q_minus, q_plus = number.both(lambda c: [coordinate for _, coordinate, _ in c.each()], signed)
    rate = rate_minus, rate_plus = number.both(lambda c: [rate for _, _, rate in c.each()], signed)
    beat_period = number(lambda c: f"{three(math.tau / c.chain.modes().beat)} s" if beating(c) == "both" else "none")

"""The live numbers of the driven mass."""

from __future__ import annotations

import math

from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.numbers import plus
from components.scenes.driven.case import DrivenCase
from components.scenes.driven.curves import Axes
from components.scenes.driven.power import Power, powers_of

number = LiveNumber[DrivenCase]


class Numbers(Declared[DrivenCase]):
    x_unit = AxisUnit(Axes.x)
    r = number(lambda c: c.r, "r", tint="F")
    zeta = number(lambda c: c.zeta, "ζ", tint="T")
    X = number(lambda c: (math.inf if c.resonant else abs(c.X)) if c.pushed else None, "X", "m", "m1")
    phi = number(lambda c: c.lag if c.pushed else None, "φ", "rad", "m1", angle=True)
    phi_minus = number(lambda c: -c.lag, form=plus)
    M = number(lambda c: c.M)
    Q = number(lambda c: 0.5 / c.zeta if c.zeta else math.inf)
    width = number(lambda c: 2 * c.zeta * c.omega_n)
    W = number(lambda c: c.work if c.pushed and c.steady else None)
    rate = number(lambda c: c.rate if c.pushed else None)
    growth = number(lambda c: c.growth if c.pushed else None)
    omega = number(lambda c: c.omega)
    Y = number(lambda c: c.size)
    decay = number(lambda c: c.oscillator.free.rates[0])
    P_in = number(lambda c: float(powers_of(c)[Power.P_in][-1]) if powers_of(c) else None)
    P_lost = number(lambda c: float(powers_of(c)[Power.P_lost][-1]) if powers_of(c) else None)

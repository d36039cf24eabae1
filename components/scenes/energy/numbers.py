"""The live numbers of the hanging mass."""

from __future__ import annotations

from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.motion import scaled
from components.scenes.energy.case import HangingCase

number = LiveNumber[HangingCase]


class Numbers(Declared[HangingCase]):
    x_unit, E_unit = AxisUnit("x"), AxisUnit("E")
    omega = number(lambda c: c.omega, "ω_n", "rad/s")
    tau = number(lambda c: c.system.oscillator.period, "τ", "s")
    E_total = number(lambda c: c.total, "E", "J", axis=E_unit)
    delta_st = number(lambda c: c.system.delta_st, "δ_{st}", "m", whole=True)
    delta = number(lambda c: c.system.delta_st)
    omega_2 = number(lambda c: 2 * c.omega)
    T_max = number(lambda c: c.E, axis=E_unit)
    V_max = number(lambda c: c.total, axis=E_unit)
    v_max = number(lambda c: scaled(0, c.omega, c.constants.C))
    shift = number(lambda c: c.shift, axis=E_unit, whole=True)

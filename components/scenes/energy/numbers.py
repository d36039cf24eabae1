"""The live numbers of the hanging mass, and which sentence stands."""

from __future__ import annotations

from components.quantities.declared import AxisUnit, Declared, Form, LiveNumber
from components.quantities.motion import scaled
from components.scenes.energy.case import Axes, HangingCase

number = LiveNumber[HangingCase]


class Numbers(Declared[HangingCase]):
    x_unit, E_unit = AxisUnit(Axes.x), AxisUnit(Axes.E)
    omega = number(lambda c: c.omega, "ω_n", "rad/s")
    tau = number(lambda c: c.system.oscillator.period, "τ", "s")
    E_total = number(lambda c: c.total, "E", "J", axis=E_unit)
    delta_st = number(lambda c: c.system.delta_st, "δ_{st}", "m", whole=True)
    delta = number(lambda c: c.system.delta_st)
    omega_2 = number(lambda c: 2 * c.omega)
    T_max = number(lambda c: c.E, axis=E_unit)
    v_max = number(lambda c: scaled(0, c.omega, c.constants.C))
    shift = number(lambda c: c.shift, axis=E_unit, whole=True)


def _claim(case: HangingCase) -> str:
    """Which sentence on the largest T and V holds: none swings at rest, and without weight both ways of counting V
    are one."""
    if not case.constants.C:
        return "rest_apart" if case.shift else "rest"
    return "weightless" if case.separate and not case.shift else case.datum


class Forms(Declared[HangingCase]):
    datum = Form[HangingCase](lambda c: c.datum)
    claim = Form[HangingCase](_claim)
    place = Form[HangingCase](lambda c: "said")

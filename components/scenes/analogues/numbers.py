"""The live numbers of the analogues, and the conditions of sentences and formulas."""

from __future__ import annotations

import math

from msgspec.structs import replace

from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, Family, Form, LiveNumber, Text
from components.quantities.formatting import short
from components.scenes.analogues.case import AnalogueCase
from components.scenes.analogues.curves import Axes
from components.scenes.analogues.reach import REMARKS
from physics.analogues import ANALOGUES

GAP = "\N{NO-BREAK SPACE}"


def following(axis: Axis) -> str:
    """Return the unit as it follows a number: ·10⁻⁶ m, or a space and m."""
    return (axis.suffix or axis.gap).replace(" ", GAP) + axis.unit


def degrees(angle: float) -> str:
    return f"{short(math.degrees(angle))}°"


number, form = LiveNumber[AnalogueCase], Form[AnalogueCase]


class Numbers(Declared[AnalogueCase]):
    omega = number(lambda c: c.omega, "ω_n", "rad/s", meaning="natural frequency of small swings")
    period = number(lambda c: c.period, "τ", "s", meaning="period")
    frequency = number(lambda c: 1 / c.period, unit="Hz", meaning="cycles per second")
    small_period = number(lambda c: c.spring.period, unit="s", meaning="period of small swings")
    late = number(
        lambda c: 3 * (c.spring.period * c.excess), unit="s", meaning="time behind the spring after three small swings"
    )
    late_percent = number(lambda c: 100 * c.excess)
    end_right = number(lambda c: abs(c.q_0), form=degrees)
    end_left = number(lambda c: -abs(c.q_0), form=degrees)
    level_unit = AxisUnit(Axes.q, following)
    system_name = number(lambda c: c.system.name)
    m = number(lambda c: c.spring.m)
    m_unit = number(lambda c: GAP + c.system.inertia_unit)
    k = number(lambda c: c.spring.k)
    k_unit = number(lambda c: GAP + c.system.stiffness_unit)
    x_unit = AxisUnit(Axes.table, lambda axis: following(replace(axis, unit="m")))
    q_unit = AxisUnit(Axes.table, following)
    J_unit = AxisUnit(Axes.energy, following)
    E_unit = Text[AnalogueCase](lambda c, a: following(Axes.energy(a)) + ("/m²" if c.system.slug == "wave" else ""))


class Forms(Declared[AnalogueCase]):
    system = form(lambda c: c.system.slug)
    of = Family(ANALOGUES, lambda slug: form(lambda c: c.system.slug == slug), "{}")
    swinging = form(lambda c: bool(c.pendulum))
    linear = form(lambda c: not c.pendulum)
    reach = form(lambda c: c.system.slug if c.q_0 else "rest")
    note = form(lambda c: c.system.slug if c.system.slug in REMARKS else "")

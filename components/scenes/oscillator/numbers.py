"""The live numbers of the oscillator, and which sentences and formulas stand."""

from __future__ import annotations

import math

from components.quantities.declared import AxisUnit, Declared, Form, LiveNumber, Text
from components.quantities.motion import scaled
from components.quantities.numbers import plus, signed
from components.scenes.oscillator.case import Oscillation
from components.scenes.oscillator.curves import Axes

LONGEST = 24
"""Characters of numbers in the second form of x; where they are more the line has no room for it."""

number, form = LiveNumber[Oscillation], Form[Oscillation]


def amplitude(i: int) -> LiveNumber[Oscillation]:
    return number(lambda c: c.amplitudes[i])


class Numbers(Declared[Oscillation]):
    x_unit = AxisUnit(Axes.x)
    F_unit = Text[Oscillation](lambda c, a: Axes.F(a).full_unit if c.view == "force" else "")
    omega = number(lambda c: c.omega, "ω_n", "rad/s")
    tau = number(lambda c: c.oscillator.period if c.omega else None, "τ", "s")
    C = number(lambda c: c.constants.C if c.omega else None, "C", "m", "m1")
    phi = number(lambda c: c.constants.phi if c.omega else None, "φ", "rad", angle=True)
    phi_plus = number(lambda c: c.constants.phi, form=plus)
    atan = number(lambda c: c.constants.phi - math.copysign(math.pi, c.constants.phi))
    A = number(lambda c: c.constants.A, form=signed)
    A_plain = number(lambda c: c.constants.A)
    B = number(lambda c: c.constants.B, form=signed)
    B_plus = number(lambda c: c.constants.B, form=plus)
    drift = number(lambda c: c.constants.drift, form=plus)
    v_0 = number(lambda c: c.v_0, form=signed)
    ratio = number(lambda c: scaled(0, c.omega, c.omega))
    top_x, top_v, top_a = map(amplitude, range(3))


def _why(case: Oscillation) -> str:
    """The sentence on atan at this start, or on why there is no arrow."""
    if not case.omega:
        return "drift" if case.v_0 else "still"
    return "rest" if not case.turns else "wrong" if case.v_0 < 0 else "right" if case.v_0 else "zero"


class Forms(Declared[Oscillation]):
    kind = form(lambda c: "turn" if c.omega else "drift")
    why = form(_why)
    B = form(lambda c: "turn" if c.omega else "drift")
    C = form(lambda c: "turn" if c.omega else "")
    phi = form(lambda c: "turn" if c.turns else "")
    parts = form(lambda c: "")
    force = form(lambda c: c.view == "force")
    idea = form(lambda c: c.view == "swing")
    formulas = form(lambda c: c.view != "swing")


def parts_of(case: Oscillation, values: dict[str, str]) -> str:
    """Whether x is written as a sum too: where its numbers have room in the line."""
    length = sum(len(values[one.name]) for one in (Numbers.A_plain, Numbers.B_plus, Numbers.omega, Numbers.omega))
    return "shown" if case.omega and length <= LONGEST else "left_out"

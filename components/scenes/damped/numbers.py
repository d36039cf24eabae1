"""The live numbers of the damped mass."""

from __future__ import annotations

import math

from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.motion import scaled
from components.quantities.numbers import plus, short, signed, three
from components.scenes.damped.case import DampedCase
from components.scenes.damped.curves import Axes
from physics.damped import DampedOscillator, FreeDecay

HOME = 0.01
"""The share of x_0 within which the mass counts as home."""
ALL_BUT = 0.005
"""Of a logarithmic decrement: of less what is kept has not enough digits left to tell it from all."""

number = LiveNumber[DampedCase]


def percent(share: float) -> str:
    return f"{short(100 * share)} %"


def kept(decrement: float, least: float = ALL_BUT) -> str:
    """exp(-decrement) in percent; where nearly all of it is kept, by what is not."""
    if 0 < decrement < least:
        return f"all but {percent(-math.expm1(-decrement))}"
    return percent(math.exp(-decrement))


def home_thrice(case: DampedCase) -> float:
    """When it is home with three times the damping, let go at rest."""
    one = case.oscillator
    heavier = DampedOscillator(m=one.m, c=scaled(0, 3.0, one.c), k=one.k)
    return FreeDecay(oscillator=heavier, x_0=case.x_0, v_0=0.0).settled(HOME) or 0.0


class Numbers(Declared[DampedCase]):
    x_unit, E_unit, P_unit = AxisUnit(Axes.x), AxisUnit(Axes.E), AxisUnit(Axes.P)
    E_total = number(lambda c: c.E_0, axis=E_unit)
    omega = number(lambda c: c.omega if c.oscillator.k else three(0.0), "ω_n", "rad/s")
    zeta = number(lambda c: c.oscillator.zeta if c.oscillator.k else "none", "ζ", tint="T")
    rate = number(
        lambda c: three(c.oscillator.rates[1]) if c.oscillator.k else c.oscillator.rates[1], "c/m", "1/s", "T"
    )
    omega_d = number(lambda c: c.oscillator.omega_d or three(0.0), "ω_d", "rad/s", "m1")
    delta = number(lambda c: c.oscillator.log_decrement if c.oscillator.omega_d else "∞", "δ")
    square = number(lambda c: c.oscillator.k / c.oscillator.m)
    a = number(lambda c: c.oscillator.rates[0])
    slow = number(lambda c: -c.oscillator.rates[0])
    fast = number(lambda c: -c.oscillator.rates[1])
    C = number(lambda c: c.envelope)
    phi = number(lambda c: c.oscillator.decays(c.x_0, c.v_0)[0].phase if c.swings else 0.0, form=plus)
    A = number(lambda c: signed(c.fading.late[0]) if c.kind == "over" else c.x_0)
    B = number(lambda c: c.fading.late[1] if c.kind == "over" else c.fading.rate, form=plus)
    x_0 = number(lambda c: c.x_0)
    v_0 = number(lambda c: c.v_0, form=plus)
    keep = number(lambda c: c.oscillator.log_decrement if c.oscillator.omega_d else None, form=kept)
    keep_x = number(lambda c: math.exp(-c.oscillator.log_decrement), form=lambda share: f"× {three(share)}")
    keep_energy = number(lambda c: 2 * c.oscillator.log_decrement, form=lambda both: kept(both, 2 * ALL_BUT))
    half = number(lambda c: c.oscillator.log_decrement / 2, form=kept)
    longer = number(
        lambda c: math.expm1(-math.log1p(-(c.oscillator.zeta**2)) / 2) if c.oscillator.zeta < 1 else 0.0, form=percent
    )
    tau_d = number(lambda c: 2 * math.pi / c.oscillator.omega_d if c.oscillator.omega_d else None)
    home = number(lambda c: c.motion.settled(HOME) or 0.0 if c.said in ("home", "thrice") else None)
    home_3 = number(lambda c: home_thrice(c) if c.said == "thrice" else None)
    farthest = number(lambda c: signed(c.turning) if c.said == "out" else None)
    zero = number(lambda c: c.motion.first_zero or 0.0 if c.said == "crosses" else None)
    crossing = number(lambda c: c.crossing_speed if c.said == "crosses" else None)
    glide = number(lambda c: scaled(0, abs(c.v_0), 1 / c.oscillator.rates[1]) if c.said == "glide" else None)

"""A motion of the oscillator over its window, and its live numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.motion import QUARTER, scaled
from components.quantities.numbers import plus, signed
from components.scene.frames import Windowed
from components.scene.traces import Columns, Floats
from physics.oscillator import Oscillator, OscillatorConstants
from physics.sampling import periods, time_window

LEADS = {"x": 0.0, "v": QUARTER, "a": math.pi}
"""The phase by which each row leads x."""


@dataclass(frozen=True, kw_only=True)
class Oscillation(Windowed):
    """A motion over its window."""

    oscillator: Oscillator
    x_0: float
    v_0: float

    @cached_property
    def omega(self) -> float:
        return self.oscillator.omega_n

    @cached_property
    def constants(self) -> OscillatorConstants:
        return self.oscillator.constants(self.x_0, self.v_0)

    @cached_property
    def lasting(self) -> float:
        return periods(self.omega, 2) if self.omega else time_window(0.0, 0.0)

    @property
    def turns(self) -> bool:
        """Whether there is an arrow to turn: neither a free mass nor one at rest."""
        return self.omega > 0 and self.constants.C > 0

    @cached_property
    def amplitudes(self) -> dict[str, float]:
        """C, omega C and omega^2 C; of a free mass, its constant speed."""
        if not self.omega:
            return {"x": abs(self.x_0), "v": abs(self.v_0), "a": 0.0}
        return {row: scaled(0, self.constants.C, *[self.omega] * i) for i, row in enumerate(LEADS)}

    @property
    def loop(self) -> tuple[float, int]:
        """The time for which the planes (x, v) and (x, a) are drawn, and the points: one turn; of a free mass, all."""
        return (self.oscillator.period, 145) if self.omega else (self.end, 2)

    def exact(self, t: Floats) -> Columns:
        """x, v and a."""
        motion = self.oscillator.motion(self.x_0, self.v_0, t)
        return {name: getattr(motion, name) for name in LEADS}


number = LiveNumber[Oscillation]


def amplitude(row: str) -> LiveNumber[Oscillation]:
    return number(lambda c: c.amplitudes[row])


class Numbers(Declared[Oscillation]):
    x_unit = AxisUnit("x")
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
    top_x, top_v, top_a = map(amplitude, LEADS)

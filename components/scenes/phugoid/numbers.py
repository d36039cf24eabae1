"""The live numbers of the flight."""

from __future__ import annotations

from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.formatting import MINUS, signed, three
from components.scenes.phugoid.axes import Axes
from components.scenes.phugoid.swing import AIRCRAFT, Swing, verdict
from physics.phugoid import linear_phugoid

number = LiveNumber[Swing]


def size(axis: Axis, value: float) -> str:
    """A number in the unit of an axis, without its power of ten."""
    return three(value / axis.factor)


def example(name: str) -> LiveNumber[Swing]:
    """The period of an aircraft."""
    return number(lambda s: linear_phugoid(AIRCRAFT[name][1], s.g).tau, unit="s", whole=True)


class Numbers(Declared[Swing]):
    h_unit, v_unit = AxisUnit(Axes.h, write=size), AxisUnit(Axes.v, write=size)
    h_size = number(lambda s: -s.climb, axis=h_unit)
    v_size = number(lambda s: s.gain, axis=v_unit)
    gain = number(lambda s: s.gain, axis=AxisUnit(Axes.v, write=lambda axis, gain: signed(axis.place(gain))))
    omega = number(lambda s: s.linear.omega)
    tau = number(lambda s: s.linear.tau, "τ", "s")
    late = number(lambda s: f"{three(100 * abs(s.late))} % {'longer' if s.late >= 0 else 'shorter'}")
    tau_exact = number(lambda s: s.period, "τ_{exact}", "s", also=(late,))
    C = number(lambda s: f"{s.lap.C:.3f}".replace("-0.000", "0.000").replace("-", MINUS))
    verdict = number(verdict)
    examples = tau_model, tau_glider, tau_light, tau_airliner = [example(name) for name in AIRCRAFT]

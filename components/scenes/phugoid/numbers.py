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
    """Format a number in the unit of an axis, without its power of ten."""
    return three(value / axis.factor)


def example(name: str) -> LiveNumber[Swing]:
    """The period of an aircraft."""
    return number(lambda s: linear_phugoid(AIRCRAFT[name][1], s.g).tau, unit="s", whole=True)


def longer(share: float) -> str:
    """Return by how many percent a period is longer."""
    return f"{three(100 * abs(share))} % {'longer' if share >= 0 else 'shorter'}"


def constant(C: float) -> str:
    return f"{C:.3f}".replace("-0.000", "0.000").replace("-", MINUS)


class Numbers(Declared[Swing]):
    h_unit, v_unit = AxisUnit(Axes.h, write=size), AxisUnit(Axes.v, write=size)
    h_size = number(lambda s: -s.climb, axis=h_unit)
    v_size = number(lambda s: s.gain, axis=v_unit)
    gain = number(
        lambda s: s.gain, unit="m/s", axis=AxisUnit(Axes.v, write=lambda axis, gain: signed(axis.place(gain))),
        meaning="extra speed at the start",
    )  # fmt: skip
    omega = number(lambda s: s.linear.omega, unit="rad/s", meaning="frequency by the linear theory")
    tau = number(lambda s: s.linear.tau, "τ", "s", meaning="period by the linear theory")
    late = number(
        lambda s: s.late, form=longer, meaning="exact period minus the period by the linear theory, over the latter"
    )
    tau_exact = number(lambda s: s.period, "τ_{exact}", "s", also=(late,), meaning="exact period")
    C = number(lambda s: s.lap.C, form=constant, meaning="Lanchester's constant of the flight")
    verdict = number(verdict)
    examples = tau_model, tau_glider, tau_light, tau_airliner = [example(name) for name in AIRCRAFT]

"""The live numbers of the driven masses."""

from __future__ import annotations

import math
from collections.abc import Mapping

from components.chain import BOTH
from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, Family, LiveNumber
from components.quantities.formatting import MINUS, plus, three
from components.scenes.forced.case import MARKS, Axes
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.driven import Undamped

AnyCase = Undamped | DampedForcedCase
number = LiveNumber[AnyCase]


class Amplitude(LiveNumber[AnyCase]):
    """Format an amplitude with its sign; with dashpots only its size."""

    def text(self, case: AnyCase, axes: Mapping[str, Axis]) -> str:
        size = super().text(case, axes)
        return size if isinstance(case, DampedForcedCase) or size.startswith(MINUS) else f"+{size}"


SHOWN = {"still": "drive frequency at which mass 1 stands still"}
"""The marks that are listed as numbers of the scene. The natural frequencies are listed separately."""
ALONG = "amplitude of mass {} in the particular solution, below 0 if it moves against the drive"


def _way(case: AnyCase, i: int) -> str:
    if not case.swings[i]:
        return "at rest"
    if isinstance(case, DampedForcedCase):
        return f"lags F by {three(case.lags[i])} rad"
    return f"{'with' if case.swings[i] > 0 else 'against'} F"


def _phase(case: AnyCase, i: int) -> str:
    if not case.swings[i] or not case.modes.omega:
        return "is still: no lag"
    return f"lags {three(math.degrees(case.damped.lags(case.modes.omega)[i]))}°"


def _peaks(case: AnyCase, i: int) -> str:
    """The peaks of a mass, with the widths at half their power."""
    found = [(one.omega, *one.half_power) for one in case.extremes[i].peaks] if case.extremes else []
    peaks = [three(at) + (f" (width {three(high - low)})" if low and high else "") for at, low, high in found]
    return f"peaks at {' and '.join(peaks)} rad/s" if peaks else "has no peak"


class Numbers(Declared[AnyCase]):
    F_unit = AxisUnit(Axes.F)
    Xp = Family(
        BOTH, lambda i: Amplitude(lambda c: c.swings[i - 1], f"X_{{p{i}}}", "m", f"m{i}", meaning=ALONG.format(i))
    )
    mark = Family(MARKS, lambda name: number(lambda c: c.marks.get(name), unit="rad/s", meaning=SHOWN.get(name, "")))
    omega_minus = number(
        lambda c: c.natural[0], "ω_{−}", "rad/s", "slow", also=(mark["minus"],), meaning="slow natural frequency"
    )
    ratio_minus = number(lambda c: c.chain.modes().ratio[0], "X₂/X₁_{−}", tint="slow", meaning="X2/X1 of the slow mode")
    omega_plus = number(
        lambda c: c.natural[1], "ω_{+}", "rad/s", "fast", also=(mark["plus"],), meaning="fast natural frequency"
    )
    ratio_plus = number(lambda c: c.chain.modes().ratio[1], "X₂/X₁_{+}", tint="fast", meaning="X2/X1 of the fast mode")
    omega = number(lambda c: c.modes.omega)
    X = Family(BOTH, lambda i: Amplitude(lambda c: c.swings[i - 1]))
    D = number(
        lambda c: c.D if isinstance(c, Undamped) else None, unit="N²/m²",
        meaning="determinant of the equations of motion at the drive frequency",
    )  # fmt: skip
    way = Family(BOTH, lambda i: number(lambda c: _way(c, i - 1)))
    growth = Family(
        BOTH,
        lambda i: number(
            lambda c: c.growth[i - 1] if isinstance(c, Undamped) and c.resonant else None,
            unit="m/s", meaning=f"growth of the amplitude of mass {i} per second, from rest",
        ),
    )  # fmt: skip
    lag = Family(
        BOTH,
        lambda i: number(
            lambda c: -c.lags[i - 1] if isinstance(c, DampedForcedCase) else None,
            form=plus, unit="rad", meaning=f"phase of mass {i} relative to the drive",
        ),
    )  # fmt: skip
    phase = Family(BOTH, lambda i: number(lambda c: _phase(c, i - 1)))
    peaks = Family(BOTH, lambda i: number(lambda c: _peaks(c, i - 1)))
    works = Family(
        BOTH,
        lambda i: number(lambda c: c.works[i - 1], unit="J", meaning=f"heat of dashpot {i} per cycle of the drive"),
    )
    work = number(lambda c: sum(c.works), unit="J", meaning="work of the drive per cycle")
    dies = number(
        lambda c: math.log(100) / c.slowest if isinstance(c, DampedForcedCase) and 0 < c.slowest < math.inf else None,
        unit="s",
        whole=True,
        meaning="time until 1 % of the transient is left",
    )

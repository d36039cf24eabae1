"""The live numbers of the driven masses."""

from __future__ import annotations

import math
from collections.abc import Mapping

from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.numbers import MINUS, plus, three
from components.scenes.forced.driven import Undamped
from components.scenes.forced.dying import Dying

AnyCase = Undamped | Dying
number = LiveNumber[AnyCase]


class Amplitude(LiveNumber[AnyCase]):
    """An amplitude with its sign, or a size where dashpots leave none."""

    def text(self, case: AnyCase, axes: Mapping[str, Axis]) -> str:
        size = super().text(case, axes)
        return size if isinstance(case, Dying) or size.startswith(MINUS) else f"+{size}"


def way(case: AnyCase, i: int) -> str:
    if not case.swings[i]:
        return "at rest"
    if isinstance(case, Dying):
        return f"lags F by {three(case.lags[i])} rad"
    return f"{'with' if case.swings[i] > 0 else 'against'} F"


class Numbers(Declared[AnyCase]):
    F_unit = AxisUnit("F")
    Xp1 = Amplitude(lambda c: c.swings[0], "X_{p1}", "m", "m1")
    Xp2 = Amplitude(lambda c: c.swings[1], "X_{p2}", "m", "m2")
    omega_minus = number(lambda c: c.natural[0], "ω_{−}", "rad/s", "slow", also=("mark_minus",))
    ratio_minus = number(lambda c: c.chain.modes().ratio[0], "X₂/X₁_{−}", tint="slow")
    omega_plus = number(lambda c: c.natural[1], "ω_{+}", "rad/s", "fast", also=("mark_plus",))
    ratio_plus = number(lambda c: c.chain.modes().ratio[1], "X₂/X₁_{+}", tint="fast")
    mark_minus = number(lambda c: c.marks.get("minus"))
    mark_still = number(lambda c: c.marks.get("still"))
    mark_plus = number(lambda c: c.marks.get("plus"))
    omega = number(lambda c: c.modes.omega)
    X1, X2 = Amplitude.both(lambda c: c.swings)
    D = number(lambda c: c.D if isinstance(c, Undamped) else None)
    way1, way2 = number.both(lambda c: (way(c, 0), way(c, 1)))
    growth1, growth2 = number.both(lambda c: c.growth if isinstance(c, Undamped) and c.resonant else ("", ""))
    lag1, lag2 = number.both(lambda c: [plus(-lag) for lag in c.lags] if isinstance(c, Dying) else ("", ""))
    dies = number(
        lambda c: math.log(100) / c.slowest if isinstance(c, Dying) and 0 < c.slowest < math.inf else None,
        unit="s",
        whole=True,
    )

"""The view Solve of the scene modes with dashpots: arrows that wind inward, in line or not, and the roots of D."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction

from components import chain
from components.chain.parameters import Pair
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, either
from components.quantities.axes import Axis, time_axis
from components.quantities.motion import QUARTER, decays, pace
from components.quantities.numbers import plus, signed, three
from components.quantities.readouts import Readout
from components.scene import Picture
from components.scene.frames import FITTED, framed
from physics.braked_modes import BrakedMode, braked_modes, in_line
from physics.coupled import TwoMassChain
from physics.laplace import Driven, transform
from physics.sampling import time_window

BRAKED: list[Paragraph] = [
    either(
        "braked",
        shown=r"**With dashpots** $D$ has odd powers. With $s = i \omega$ it is zero where "
        r"$\val{p4}\, s^4\, \val{p3}\, s^3\, \val{p2}\, s^2\, \val{p1}\, s\, \val{p0} = 0$:",
    ),
    *(
        either(
            f"{mode}_root",
            pair=rf"[{mode}|$s = \val{{{mode}_rate}} \pm \val{{{mode}_turn}}\, i$ 1/s: it swings and dies]",
            real=rf"[{mode}|$s = \val{{{mode}_rate}},\ \val{{{mode}_other}}$ 1/s: it does not swing]",
        )
        for mode in chain.MODES
    ),
]
"""The equation for the exponents, and its roots."""

ARROWS = {
    "line": r"**The arrows** stay in line, as $c_1 k_2 = c_2 k_1$ $= \val{cross}$: the shapes are those without "
    "dashpots, and each mode dies by itself.",
    "apart": r"**The arrows** leave the line, by {slow_angle}° and {fast_angle}°, as $c_1 k_2 = \val{cross}$ is not "
    r"$c_2 k_1 = \val{other_cross}$: in neither mode are both masses at 0 together.",
    "creeps": "**The arrows** of a mode that does not swing do not turn: it creeps home, or stays where it is.",
}
"""The sentences on how the arrows stand to each other."""


def braked_picture(system: TwoMassChain, damping: Pair, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain with dashpots."""
    slow, fast = system.modes().omega.tolist()
    axes, metres = framed(frame, {"t": time_axis(window or time_window(slow, fast))}), Axis(-1.0, 1.0, "m")
    signals: dict[str, AnySignal] = {}
    scalars = {f"dashpot{i}": 1.0 for i, c in enumerate(damping, start=1) if c}
    both = braked_modes(system, *damping)
    for mode, one in zip(chain.MODES, both, strict=True):
        for i, X in enumerate(one.shape, start=1):
            s, phase = one.exponents[0], cmath.phase(X)
            for name, ahead in (("x", QUARTER), ("y", 0.0)):
                term = (abs(X), 0.0, -s.real, s.imag, phase + ahead)
                signals[f"{name}{i}_{mode}"] = decays(metres, axes["t"], term)
            scalars |= {f"X{i}_{mode}": X.real, f"R{i}_{mode}": abs(X)}
    return Picture(
        columns={},
        axes=axes,
        signals=signals,
        scalars=scalars,
        pace=pace(slow or fast, fast),
        values=_values(system, damping, both),
        forms=_forms(system, damping, both),
    )


def _values(system: TwoMassChain, damping: Pair, both: tuple[BrakedMode, BrakedMode]) -> dict[str, str]:
    c1, c2 = damping
    P = transform(Driven(system, c2, 0.0, 0.0, (1.0, 0.0), (0.0, 1.0), c1)).P
    P = (*(Fraction(0),) * (5 - len(P)), *P)
    values = {f"p{i}": plus(float(a)) if i < 4 else three(float(a)) for i, a in enumerate(P)}
    values |= {"cross": three(c1 * system.k2), "other_cross": three(c2 * system.k1)}
    for mode, one in zip(chain.MODES, both, strict=True):
        s, other = one.exponents[0], one.exponents[-1]
        values |= {f"{mode}_rate": three(s.real), f"{mode}_turn": three(s.imag), f"{mode}_other": three(other.real)}
        values |= {f"{mode}_omega": three(s.imag), f"{mode}_ratio": _ratio(one), f"{mode}_angle": three(_off(one))}
    return values


def _ratio(one: BrakedMode) -> str:
    X1, X2 = one.shape
    if not X1:
        return signed(math.inf)
    ratio = X2 / X1
    return f"{three(abs(ratio))} at {three(math.degrees(cmath.phase(ratio)))}°" if _off(one) else signed(ratio.real)


def _off(one: BrakedMode) -> float:
    """The angle in degrees by which the arrows are out of line."""
    X1, X2 = one.shape
    if not X1 or not X2:
        return 0.0
    ratio = X2 / X1
    return math.degrees(math.atan2(abs(ratio.imag), abs(ratio.real)))


def _forms(system: TwoMassChain, damping: Pair, both: tuple[BrakedMode, BrakedMode]) -> dict[str, str]:
    roots = {f"{mode}_root": "pair" if one.swings else "real" for mode, one in zip(chain.MODES, both, strict=True)}
    arrows = "creeps" if not all(one.swings for one in both) else "line" if in_line(system, *damping) else "apart"
    without = ("positive", "below", "ratios", "gamma", "product", "slow_shape", "fast_shape")
    return {**dict.fromkeys(without, ""), **roots, "braked": "shown", "arrows": arrows}


def braked_readouts(system: TwoMassChain, damping: Pair) -> tuple[Readout, ...]:
    """The frequencies at which the modes swing while they die, and their rates."""
    rows = zip(chain.MODES, "−+", braked_modes(system, *damping), strict=True)
    return tuple(
        Readout(name, symbol, value, unit, mode)
        for mode, sign, one in rows
        for name, symbol, value, unit in (
            (f"{mode}_omega", f"ω_{{{sign}}}", one.exponents[0].imag, "rad/s"),
            (f"{mode}_rate", f"Re s_{{{sign}}}", one.exponents[0].real, "1/s"),
        )
    )

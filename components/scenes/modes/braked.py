"""The view Solve of the scene modes with dashpots: arrows that wind inward, in line or not, and the roots of D."""

from __future__ import annotations

import cmath

from components import chain
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, either
from components.quantities.axes import Axis, time_axis
from components.quantities.motion import QUARTER, decays, pace
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.numbers import BrakedChain
from components.scenes.modes.numbers import BrakedNumbers as N
from physics.braked_modes import in_line
from physics.sampling import time_window

BRAKED: list[Paragraph] = [
    either(
        "braked",
        shown=r"**With dashpots** $D$ has odd powers. With $s = i \omega$ it is zero where "
        rf"${N.p4}\, s^4\, {N.p3}\, s^3\, {N.p2}\, s^2\, {N.p1}\, s\, {N.p0} = 0$:",
    ),
    *(
        either(
            f"{mode}_root",
            pair=rf"[{mode}|$s = {rate} \pm {turn}\, i$ 1/s: it swings and dies]",
            real=rf"[{mode}|$s = {rate},\ {other}$ 1/s: it does not swing]",
        )
        for mode, rate, turn, other in zip(chain.MODES, N.rate, N.turn, N.other, strict=True)
    ),
]
"""The equation for the exponents, and its roots."""

ARROWS = {
    "line": rf"**The arrows** stay in line, as $c_1 k_2 = c_2 k_1$ $= {N.cross}$: the shapes are those without "
    "dashpots, and each mode dies by itself.",
    "apart": rf"**The arrows** leave the line, by {N.slow_angle}° and {N.fast_angle}°, as $c_1 k_2 = {N.cross}$ is not "
    rf"$c_2 k_1 = {N.other_cross}$: in neither mode are both masses at 0 together.",
    "creeps": "**The arrows** of a mode that does not swing do not turn: it creeps home, or stays where it is.",
}
"""The sentences on how the arrows stand to each other."""


def braked_picture(braked: BrakedChain, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain with dashpots."""
    slow, fast = braked.system.modes().omega.tolist()
    axes, metres = framed(frame, {"t": time_axis(window or time_window(slow, fast))}), Axis(-1.0, 1.0, "m")
    signals: dict[str, AnySignal] = {}
    scalars = {f"dashpot{i}": 1.0 for i, c in enumerate(braked.damping, start=1) if c}
    for mode, one in zip(chain.MODES, braked.modes, strict=True):
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
        values=N.texts(braked, axes),
        forms=_forms(braked),
    )


def _forms(braked: BrakedChain) -> dict[str, str]:
    modes, aligned = braked.modes, in_line(braked.system, *braked.damping)
    roots = {f"{mode}_root": "pair" if one.swings else "real" for mode, one in zip(chain.MODES, modes, strict=True)}
    arrows = "creeps" if not all(one.swings for one in modes) else "line" if aligned else "apart"
    without = ("positive", "below", "ratios", "gamma", "product", "slow_shape", "fast_shape")
    return {**dict.fromkeys(without, ""), **roots, "braked": "shown", "arrows": arrows}

"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import math

from components import chain
from components.chain.parameters import Pair
from components.language.blocks import Block
from components.language.numbers import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, either, row, stage, words
from components.layout.stage import H, Shape, W, arrow, box, circle, line, text
from components.quantities.axes import Axis, time_axis
from components.quantities.motion import pace, sines
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.braked import ARROWS, BRAKED, braked_picture
from components.scenes.modes.numbers import BrakedChain
from components.scenes.modes.numbers import EquationNumbers as E
from components.scenes.modes.numbers import SolvedNumbers as N
from physics.coupled import TwoMassChain
from physics.modes import quadratic
from physics.sampling import time_window

METRE = 0.105
"""The share of the stage's width that an amplitude of 1 m takes."""
LOOKS = (("−", 0.0), ("+", 0.5))
"""The sign of each mode, and where its part of the stage begins, as a fraction of the height."""


def sheet() -> Block:
    picture_ = stage(
        *_shapes(),
        label="Both modes, each moving at its own frequency, and under each mass its complex amplitude as a rotating "
        "arrow",
        grow=480,
        phone=4,
        height=420,
        style="still",
    )
    return row(
        picture_,
        words(*_formulas(), style="facts", grow=408, phone=20),
    )


def _always(text_: str) -> Paragraph:
    """A text that stands without dashpots."""
    return either("ratios", both=text_, loose=text_)


def _formulas() -> list[Paragraph]:
    return [
        _always(r"**Where is** $D = m_1 m_2 \omega^4 - b\,\omega^2 + k_1 k_2$ **zero?**"),
        _always(rf"${E.m1m2}\,\omega^4 - {E.b}\,\omega^2 + {E.k1k2_}$$= 0$ with $b = m_1 k_2 + m_2 (k_1 + k_2)$"),
        _always(
            r"$\omega_\pm^2 = (b \pm \sqrt{\Delta})/(2 m_1 m_2)$ with $\Delta = b^2 - 4 m_1 m_2 k_1 k_2$"
            f"$= {E.Delta}$"
        ),
        either(
            "positive",
            sum=r"**$\Delta > 0$:** it is "
            r"$(m_1 k_2 - m_2 (k_1 + k_2))^2$ $+\; 4 m_1 m_2 k_2^2$"
            rf"$= ({E.difference})^2$ $+\; {E.coupling}$, squares that never vanish together. "
            r"So both $\omega^2$ are real.",
            loose=r"**$\Delta$ is a square:** $(m_2 k_1)^2$, as nothing couples the masses. "
            r"Both $\omega^2$ are real.",
            free=r"**$\Delta = 0$:** there is no spring at all, and both frequencies are 0.",
        ),
        either(
            "below",
            wall=rf"**$\sqrt{{\Delta}} < b$:** ${E.root}$ is less than $b$ by ${E.gap}$, as "
            rf"$4 m_1 m_2 k_1 k_2 = {E.fourfold} > 0$ is subtracted from $b^2$. "
            r"So both $\omega^2$ are positive and $\omega$ is real.",
            zero=rf"**$\sqrt{{\Delta}} = b$** $= {E.b}$, as $4 m_1 m_2 k_1 k_2 = 0$. So $\omega_-$ = 0: a drift.",
        ),
        _always(rf"[slow|$\omega_-^2 = {N.slow_square}$, $\omega_- = {N.slow_omega}$ rad/s]"),
        _always(rf"[fast|$\omega_+^2 = {N.fast_square}$, $\omega_+ = {N.fast_omega}$ rad/s]"),
        *BRAKED,
        *_ratios(),
    ]


def _ratios() -> list[Paragraph]:
    return [
        either(
            "ratios",
            both=r"**The shapes:** $-X_2/X_1 = (m_1 \omega_\pm^2 - k_1 - k_2)/k_2 = \gamma \pm \delta$",
            loose="**The shapes:** without $k_2$ each mass moves alone.",
        ),
        either("gamma", shown=rf"$\gamma = m_1/(2 m_2) - (k_1 + k_2)/(2 k_2)$$= {N.gamma}$"),
        either("gamma", shown=rf"$\delta = \sqrt{{\gamma^2 + m_1/m_2}}$$= {N.delta}$, more than $|\gamma|$"),
        either(
            "slow_shape",
            ratio=rf"[slow|$(X_2/X_1)_- = -\gamma + \delta = {N.slow_ratio} > 0$: in phase]",
            loose="[slow|$X_1 = 0$: mass 2 alone]",
        ),
        either(
            "fast_shape",
            ratio=rf"[fast|$(X_2/X_1)_+ = -\gamma - \delta = {N.fast_ratio} < 0$: opposite]",
            loose="[fast|$X_2 = 0$: mass 1 alone]",
        ),
        either("product", shown=rf"Their product is $-m_1/m_2 = {N.product}$, whatever the springs."),
        either(
            "arrows",
            shown=r"**The arrows** are the $X_j e^{i \omega t}$ of the notes of D34, each mass above the tip of its "
            r"own. A real ratio $X_2/X_1$ means that they point the same way or opposite ways.",
            **ARROWS,
        ),
    ]


def _shapes() -> list[Shape]:
    """Each mode as a chain in motion with its full swing as a ghost, and a rotating arrow under each mass."""
    shapes: list[Shape] = []
    for mode, (sign, top), omega, ratio in zip(chain.MODES, LOOKS, N.omega, N.ratio, strict=True):
        foot, axle = (top + 0.185) * H, (top + 0.345) * H
        shapes += [
            chain.standing_wall((top + 0.07) * H, 0.115 * H),
            line(chain.WALL * W, foot, W, foot, style="floor"),
            *_title(mode, f"*ω*_{{{sign}}} = {omega} rad/s", f"*X*_2/*X*_1 = {ratio}", top),
        ]
        places = [chain.rest(i) + METRE * W * var(f"x{i}_{mode}") for i in (1, 2)]
        for i in (1, 2):
            full = chain.rest(i) + METRE * W * var(f"X{i}_{mode}")
            shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full"))
        shapes += [*chain.cups(foot, *places), *chain.masses(foot, *places)]
        for i, place in zip((1, 2), places, strict=True):
            rest, tip = chain.rest(i), axle - METRE * W * var(f"y{i}_{mode}")
            shapes += [
                line(rest, (top + 0.055) * H, rest, axle, tint="mute", style="eq told"),
                line(place, (top + 0.062) * H, place, foot - chain.side(i), tint="mute", style="eq told"),
                arrow(rest, (top + 0.062) * H, place, (top + 0.062) * H, tint=mode),
                circle(rest, axle, METRE * W * var(f"R{i}_{mode}"), tint=f"m{i}", style="orbit told"),
                line(place, foot, place, tip, tint="mute", style="eq told"),
                arrow(rest, axle, place, tip, tint=f"m{i}"),
            ]
    return shapes


def _title(mode: str, frequency: str, shape: str, top: float) -> list[Shape]:
    """The title of a mode over its chain; on a phone its shape stands under the arrows."""
    title = f"{mode} mode, {frequency}"
    lines = (f"{title}, {shape}", 0.03, "wide"), (title, 0.03, "narrow"), (shape, 0.475, "narrow")
    return [
        text(chain.WALL * W, (top + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, damping: Pair, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain, with its dashpots."""
    if any(damping):
        return braked_picture(BrakedChain(system, damping), window, frame)
    modes = system.modes()
    slow, fast = (float(w) for w in modes.omega)
    axes, metres = framed(frame, {"t": time_axis(window or time_window(slow, fast))}), Axis(-1.0, 1.0, "m")
    time = axes["t"]
    signals: dict[str, AnySignal] = {}
    scalars: dict[str, float] = {}
    for mode, omega, way in zip(chain.MODES, modes.omega, chain.directions(system), strict=True):
        for i, X in enumerate(way, start=1):
            signals[f"x{i}_{mode}"] = sines(metres, time, (X, float(omega), math.pi / 2))
            signals[f"y{i}_{mode}"] = sines(metres, time, (X, float(omega), 0.0))
            scalars |= {f"X{i}_{mode}": X, f"R{i}_{mode}": abs(X)}
    return Picture(
        columns={},
        axes=axes,
        signals=signals,
        scalars=scalars,
        pace=pace(slow or fast, fast),
        values=E.texts(quadratic(system), axes) | N.texts(system, axes),
        forms=_forms(system),
    )


def _forms(system: TwoMassChain) -> dict[str, str]:
    coupled = bool(system.k2)
    return {
        "positive": "sum" if coupled else "loose" if system.k1 else "free",
        "below": "wall" if coupled and system.k1 else "zero",
        "ratios": "both" if coupled else "loose",
        "gamma": "shown" if coupled else "",
        "product": "shown" if coupled else "",
        "slow_shape": "ratio" if coupled else "loose",
        "fast_shape": "ratio" if coupled else "loose",
        "arrows": "shown",
    }

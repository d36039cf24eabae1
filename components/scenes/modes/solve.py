"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import math
from decimal import Decimal

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
from components.quantities.numbers import signed, three
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.braked import ARROWS, BRAKED, braked_picture
from physics.coupled import TwoMassChain
from physics.exact import precise
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
        _always(r"$\val{m1m2}\,\omega^4 - \val{b}\,\omega^2 + \val{k1k2_}$$= 0$ with $b = m_1 k_2 + m_2 (k_1 + k_2)$"),
        _always(
            r"$\omega_\pm^2 = (b \pm \sqrt{\Delta})/(2 m_1 m_2)$ with $\Delta = b^2 - 4 m_1 m_2 k_1 k_2$$= \val{Delta}$"
        ),
        either(
            "positive",
            sum=r"**$\Delta > 0$:** it is "
            r"$(m_1 k_2 - m_2 (k_1 + k_2))^2$ $+\; 4 m_1 m_2 k_2^2$"
            r"$= (\val{difference})^2$ $+\; \val{coupling}$, squares that never vanish together. "
            r"So both $\omega^2$ are real.",
            loose=r"**$\Delta$ is a square:** $(m_2 k_1)^2$, as nothing couples the masses. "
            r"Both $\omega^2$ are real.",
            free=r"**$\Delta = 0$:** there is no spring at all, and both frequencies are 0.",
        ),
        either(
            "below",
            wall=r"**$\sqrt{\Delta} < b$:** $\val{root}$ is less than $b$ by $\val{gap}$, as "
            r"$4 m_1 m_2 k_1 k_2 = \val{fourfold} > 0$ is subtracted from $b^2$. "
            r"So both $\omega^2$ are positive and $\omega$ is real.",
            zero=r"**$\sqrt{\Delta} = b$** $= \val{b}$, as $4 m_1 m_2 k_1 k_2 = 0$. So $\omega_-$ = 0: a drift.",
        ),
        _always(r"[slow|$\omega_-^2 = \val{slow_square}$, $\omega_- = \val{slow_omega}$ rad/s]"),
        _always(r"[fast|$\omega_+^2 = \val{fast_square}$, $\omega_+ = \val{fast_omega}$ rad/s]"),
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
        either("gamma", shown=r"$\gamma = m_1/(2 m_2) - (k_1 + k_2)/(2 k_2)$$= \val{gamma}$"),
        either("gamma", shown=r"$\delta = \sqrt{\gamma^2 + m_1/m_2}$$= \val{delta}$, more than $|\gamma|$"),
        either(
            "slow_shape",
            ratio=r"[slow|$(X_2/X_1)_- = -\gamma + \delta = \val{slow_ratio} > 0$: in phase]",
            loose="[slow|$X_1 = 0$: mass 2 alone]",
        ),
        either(
            "fast_shape",
            ratio=r"[fast|$(X_2/X_1)_+ = -\gamma - \delta = \val{fast_ratio} < 0$: opposite]",
            loose="[fast|$X_2 = 0$: mass 1 alone]",
        ),
        either("product", shown=r"Their product is $-m_1/m_2 = \val{product}$, whatever the springs."),
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
    for mode, (sign, top) in zip(chain.MODES, LOOKS, strict=True):
        foot, axle = (top + 0.185) * H, (top + 0.345) * H
        shapes += [
            chain.standing_wall((top + 0.07) * H, 0.115 * H),
            line(chain.WALL * W, foot, W, foot, style="floor"),
            *_title(mode, sign, top),
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


def _title(mode: str, sign: str, top: float) -> list[Shape]:
    """The title of a mode over its chain; on a phone its shape stands under the arrows."""
    frequency, shape = f"{mode} mode, *ω*_{{{sign}}} = {{{mode}_omega}} rad/s", f"*X*_2/*X*_1 = {{{mode}_ratio}}"
    lines = (f"{frequency}, {shape}", 0.03, "wide"), (frequency, 0.03, "narrow"), (shape, 0.475, "narrow")
    return [
        text(chain.WALL * W, (top + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, damping: Pair, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain, with its dashpots."""
    if any(damping):
        return braked_picture(system, damping, window, frame)
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
        values=_equation_values(system) | _mode_values(system),
        forms=_forms(system),
    )


def _equation_values(system: TwoMassChain) -> dict[str, str]:
    """The terms of the quadratic for omega^2, and of its discriminant as a sum of squares."""
    equation = quadratic(system)
    with precise():
        gap = equation.fourfold / (equation.b + equation.root) if equation.b else Decimal(0)
    return {
        "m1m2": three(equation.leading),
        "b": three(equation.b),
        "k1k2_": three(equation.constant),
        "Delta": three(equation.Delta),
        "difference": three(equation.difference),
        "coupling": three(equation.coupling),
        "root": three(equation.root),
        "gap": three(gap),
        "fourfold": three(equation.fourfold),
    }


def _mode_values(system: TwoMassChain) -> dict[str, str]:
    modes = system.modes()
    with precise():
        product = -Decimal(system.m1) / Decimal(system.m2)
        squares = [mode.omega**2 for mode in system.exact_modes]
    values = {"gamma": three(modes.gamma), "delta": three(modes.delta), "product": three(product)}
    for mode, omega, ratio, square in zip(chain.MODES, modes.omega, modes.ratio, squares, strict=True):
        values |= {
            f"{mode}_omega": three(float(omega)),
            f"{mode}_square": three(square),
            f"{mode}_ratio": signed(float(ratio)),
        }
    return values


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

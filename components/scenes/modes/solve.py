"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import math
from decimal import Decimal

from components import chain
from components.axes import Axis, time_axis
from components.motion import pace, sines
from components.numbers import signed, three
from components.scene import Picture
from components.sheet import Block, row, stage, words
from components.stage import H, Shape, W, arrow, block, circle, line, text, var
from physics.coupled import TwoMassChain
from physics.exact import precise
from physics.modes import quadratic
from physics.sampling import time_window

METRE = 0.105
"""What an amplitude of 1 m takes of the stage's width."""
MODES = (("slow", "−", 0.0), ("fast", "+", 0.5))


def sheet() -> Block:
    picture_ = stage(
        *_shapes(),
        label="Both modes, each moving at its own frequency, and under each mass its complex amplitude as a rotating "
        "arrow",
        grow=480,
        phone=4,
        height=420,
    )
    return row(
        {**picture_, "style": "still"},
        words(*_formulas(), style="facts", grow=408, phone=20),
    )


def _formulas() -> list[str | dict[str, str]]:
    return [
        r"**Where is** $D = m_1 m_2 \omega^4 - b\,\omega^2 + k_1 k_2$ **zero?**",
        r"$\val{m1m2}\,\omega^4 - \val{b}\,\omega^2 + \val{k1k2_}$$= 0$ with $b = m_1 k_2 + m_2 (k_1 + k_2)$",
        r"$\omega_\pm^2 = (b \pm \sqrt{\Delta})/(2 m_1 m_2)$ with $\Delta = b^2 - 4 m_1 m_2 k_1 k_2$$= \val{Delta}$",
        {
            "form": "positive",
            "sum": r"**$\Delta > 0$:** it is "
            r"$(m_1 k_2 - m_2 (k_1 + k_2))^2$ $+\; 4 m_1 m_2 k_2^2$"
            r"$= (\val{difference})^2$ $+\; \val{coupling}$, squares that never vanish together. "
            r"So both $\omega^2$ are real.",
            "loose": r"**$\Delta$ is a square:** $(m_2 k_1)^2$, as nothing couples the masses. "
            r"Both $\omega^2$ are real.",
            "free": r"**$\Delta = 0$:** there is no spring at all, and both frequencies are 0.",
        },
        {
            "form": "below",
            "wall": r"**$\sqrt{\Delta} < b$:** $\val{root} < \val{b}$, as $4 m_1 m_2 k_1 k_2 = \val{fourfold} > 0$ was "
            r"taken off $b^2$. So both $\omega^2$ are positive and $\omega$ is real.",
            "zero": r"**$\sqrt{\Delta} = b$** $= \val{b}$, as $4 m_1 m_2 k_1 k_2 = 0$. So $\omega_-$ = 0: a drift.",
        },
        r"[slow|$\omega_-^2 = \val{slow_square}$, $\omega_- = \val{slow_omega}$ rad/s]",
        r"[fast|$\omega_+^2 = \val{fast_square}$, $\omega_+ = \val{fast_omega}$ rad/s]",
        *_ratios(),
    ]


def _ratios() -> list[str | dict[str, str]]:
    return [
        {
            "form": "ratios",
            "both": r"**The shapes:** $-X_2/X_1 = (m_1 \omega_\pm^2 - k_1 - k_2)/k_2 = \gamma \pm \delta$",
            "loose": "**The shapes:** without $k_2$ each mass moves alone.",
        },
        {"form": "gamma", "shown": r"$\gamma = m_1/(2 m_2) - (k_1 + k_2)/(2 k_2)$$= \val{gamma}$"},
        {"form": "gamma", "shown": r"$\delta = \sqrt{\gamma^2 + m_1/m_2}$$= \val{delta}$, more than $|\gamma|$"},
        {
            "form": "slow_shape",
            "ratio": r"[slow|$(X_2/X_1)_- = -\gamma + \delta = \val{slow_ratio} > 0$: in phase]",
            "loose": "[slow|$X_1 = 0$: mass 2 alone]",
        },
        {
            "form": "fast_shape",
            "ratio": r"[fast|$(X_2/X_1)_+ = -\gamma - \delta = \val{fast_ratio} < 0$: opposite]",
            "loose": "[fast|$X_2 = 0$: mass 1 alone]",
        },
        {"form": "product", "shown": r"Their product is $-m_1/m_2 = \val{product}$, whatever the springs."},
        {
            "form": "arrows",
            "shown": r"**The arrows** are the notes' $X_j e^{i \omega t}$, each mass above the tip of its own. A real "
            r"ratio $X_2/X_1$ means that they point the same way or opposite ways.",
        },
    ]


def _shapes() -> list[Shape]:
    """Each mode as a chain in motion with its full swing as a ghost, and a rotating arrow under each mass."""
    shapes: list[Shape] = []
    for mode, sign, top in MODES:
        foot, axle = (top + 0.185) * H, (top + 0.345) * H
        shapes += [
            chain.standing_wall((top + 0.07) * H, 0.115 * H),
            line(chain.WALL * W, foot, W, foot, style="floor"),
            *_title(mode, sign, top),
        ]
        places = [chain.rest(i) + METRE * W * var(f"x{i}_{mode}") for i in (1, 2)]
        for i in (1, 2):
            full = chain.rest(i) + METRE * W * var(f"X{i}_{mode}")
            shapes.append(block(full, foot, var(f"side{i}") * W, "", tint=f"m{i}", style="ghost full"))
        shapes += chain.masses(foot, *places)
        for i, place in zip((1, 2), places, strict=True):
            rest, tip = chain.rest(i), axle - METRE * W * var(f"y{i}_{mode}")
            shapes += [
                line(rest, (top + 0.055) * H, rest, axle, tint="mute", style="eq"),
                line(place, (top + 0.062) * H, place, foot - var(f"side{i}") * W, tint="mute", style="eq"),
                arrow(rest, (top + 0.062) * H, place, (top + 0.062) * H, tint=mode),
                circle(rest, axle, METRE * W * var(f"R{i}_{mode}"), tint=f"m{i}", style="orbit"),
                line(place, foot, place, tip, tint="mute", style="eq"),
                arrow(rest, axle, place, tip, tint=f"m{i}"),
            ]
    return shapes


def _title(mode: str, sign: str, top: float) -> list[Shape]:
    """What a mode is, over its chain; on a phone its shape stands under the arrows."""
    frequency, shape = f"{mode} mode, *ω*_{{{sign}}} = {{{mode}_omega}} rad/s", f"*X*_2/*X*_1 = {{{mode}_ratio}}"
    lines = (f"{frequency}, {shape}", 0.03, "wide"), (frequency, 0.03, "narrow"), (shape, 0.475, "narrow")
    return [
        text(chain.WALL * W, (top + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, window: float | None) -> Picture:
    """All of the view for one chain."""
    modes, equation = system.modes(), quadratic(system)
    slow, fast = (float(w) for w in modes.omega)
    time, metres = time_axis(window or time_window(slow, fast)), Axis(-1.0, 1.0, "m")
    signals, scalars = {}, {}
    values = {"m1m2": three(equation.leading), "b": three(equation.b), "k1k2_": three(equation.constant)}
    values |= {
        "Delta": three(equation.Delta),
        "difference": three(equation.difference),
        "coupling": three(equation.coupling),
    }
    values |= {
        "root": three(equation.root),
        "fourfold": three(equation.fourfold),
        "gamma": three(modes.gamma),
        "delta": three(modes.delta),
    }
    with precise():
        values["product"] = three(-Decimal(system.m1) / Decimal(system.m2))
        squares = [mode.omega**2 for mode in system.exact_modes]
    for (mode, _, _), omega, ratio, square in zip(MODES, modes.omega, modes.ratio, squares, strict=True):
        X1, X2 = (0.0, 1.0) if math.isinf(ratio) else (1 / max(1.0, abs(ratio)), float(ratio) / max(1.0, abs(ratio)))
        for i, X in ((1, X1), (2, X2)):
            signals[f"x{i}_{mode}"] = sines(metres, time, (X, float(omega), math.pi / 2))
            signals[f"y{i}_{mode}"] = sines(metres, time, (X, float(omega), 0.0))
            scalars |= {f"X{i}_{mode}": X, f"R{i}_{mode}": abs(X)}
        values |= {
            f"{mode}_omega": three(float(omega)),
            f"{mode}_square": three(square),
            f"{mode}_ratio": signed(float(ratio)),
        }
    return Picture(
        columns={},
        axes={"t": time},
        signals=signals,
        scalars={**scalars, **pace(slow or fast, fast)},
        values=values,
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

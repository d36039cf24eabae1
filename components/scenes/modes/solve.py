"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import cmath

from components import chain
from components.chain.parameters import Pair
from components.chain.signals import Axes
from components.language.blocks import Block
from components.language.numbers import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, either, row, stage, words
from components.layout.stage import ON_NARROW, ON_WIDE, H, Shape, W, arrow, box, circle, line, text
from components.quantities.axes import Axis, time_axis
from components.quantities.declared import AxesInForce, Declared, Family, Form, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, pace, sines
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.numbers import BrakedChain
from components.scenes.modes.numbers import BrakedNumbers as B
from components.scenes.modes.numbers import EquationNumbers as E
from components.scenes.modes.numbers import SolvedNumbers as N
from physics.coupled import TwoMassChain
from physics.modes import quadratic
from physics.sampling import time_window

METRE = 0.105
"""The share of the stage's width that an amplitude of 1 m takes."""
LOOKS = (("−", 0.0), ("+", 0.5))
"""The sign of each mode, and where its part of the stage begins, as a fraction of the height."""
METRES = Axis(-1.0, 1.0, "m")

signal, form = Signal[BrakedChain], Form[BrakedChain]


def _turned(case: BrakedChain, axes: AxesInForce, i: int, mode: str, ahead: float) -> AnySignal:
    """A complex amplitude as it turns: its real part, or the imaginary one, a quarter turn behind."""
    X, time = case.amplitudes[i, mode], Axes.t(axes)
    s = case.exponents[mode]
    if case.brakes:
        return sines(METRES, time, (abs(X), s.imag, cmath.phase(X) + ahead, -s.real))
    return sines(METRES, time, (X.real, s.imag, ahead))


class Solve(Declared[BrakedChain]):
    """Both modes in motion: places and heights of the arrows' tips, full swings, circles; what stands of the words."""

    x = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, QUARTER)), "x{}_{}")
    y = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, 0.0)), "y{}_{}")
    X = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: c.amplitudes[part].real), "X{}_{}")
    R = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: abs(c.amplitudes[part])), "R{}_{}")
    positive = form(lambda c: c.plainly("sum", "loose" if c.system.k1 else "free"))
    below = form(lambda c: c.plainly("wall" if c.system.k1 else "zero", "zero"))
    ratios = form(lambda c: c.plainly("both", "loose"))
    gamma, product = form.some(2, lambda c: c.plainly("shown", ""))
    slow_shape, fast_shape = form.some(2, lambda c: c.plainly("ratio", "loose"))
    arrows = form(lambda c: c.arrows if c.brakes else "shown")
    braked = form(lambda c: c.brakes)
    root = Family(chain.MODES, lambda mode: form(lambda c: c.root(mode)), "{}_root")


BRAKED: list[Paragraph] = [
    either(
        Solve.braked,
        shown=r"**With dashpots** $D$ has odd powers. With $s = i \omega$ it is zero where "
        rf"${B.p4}\, s^4\, {B.p3}\, s^3\, {B.p2}\, s^2\, {B.p1}\, s\, {B.p0} = 0$:",
    ),
    *(
        either(
            Solve.root[mode],
            pair=rf"[{mode}|$s = {rate} \pm {turn}\, i$ 1/s: it swings and dies]",
            real=rf"[{mode}|$s = {rate},\ {other}$ 1/s: it does not swing]",
        )
        for mode, rate, turn, other in zip(chain.MODES, B.rate, B.turn, B.other, strict=True)
    ),
]
"""The equation for the exponents, and its roots."""

ARROWS = {
    "line": rf"**The arrows** stay in line, as $c_1 k_2 = c_2 k_1$ $= {B.cross}$: the shapes are those without "
    "dashpots, and each mode dies by itself.",
    "apart": rf"**The arrows** leave the line, by {B.slow_angle}° and {B.fast_angle}°, as $c_1 k_2 = {B.cross}$ is not "
    rf"$c_2 k_1 = {B.other_cross}$: in neither mode are both masses at 0 together.",
    "creeps": "**The arrows** of a mode that does not swing do not turn: it creeps home, or stays where it is.",
}
"""The sentences on how the arrows stand to each other."""


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
    return either(Solve.ratios, both=text_, loose=text_)


def _formulas() -> list[Paragraph]:
    return [
        _always(r"**Where is** $D = m_1 m_2 \omega^4 - b\,\omega^2 + k_1 k_2$ **zero?**"),
        _always(rf"${E.m1m2}\,\omega^4 - {E.b}\,\omega^2 + {E.k1k2_}$$= 0$ with $b = m_1 k_2 + m_2 (k_1 + k_2)$"),
        _always(
            r"$\omega_\pm^2 = (b \pm \sqrt{\Delta})/(2 m_1 m_2)$ with $\Delta = b^2 - 4 m_1 m_2 k_1 k_2$"
            f"$= {E.Delta}$"
        ),
        either(
            Solve.positive,
            sum=r"**$\Delta > 0$:** it is "
            r"$(m_1 k_2 - m_2 (k_1 + k_2))^2$ $+\; 4 m_1 m_2 k_2^2$"
            rf"$= ({E.difference})^2$ $+\; {E.coupling}$, squares that never vanish together. "
            r"So both $\omega^2$ are real.",
            loose=r"**$\Delta$ is a square:** $(m_2 k_1)^2$, as nothing couples the masses. "
            r"Both $\omega^2$ are real.",
            free=r"**$\Delta = 0$:** there is no spring at all, and both frequencies are 0.",
        ),
        either(
            Solve.below,
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
            Solve.ratios,
            both=r"**The shapes:** $-X_2/X_1 = (m_1 \omega_\pm^2 - k_1 - k_2)/k_2 = \gamma \pm \delta$",
            loose="**The shapes:** without $k_2$ each mass moves alone.",
        ),
        either(Solve.gamma, shown=rf"$\gamma = m_1/(2 m_2) - (k_1 + k_2)/(2 k_2)$$= {N.gamma}$"),
        either(Solve.gamma, shown=rf"$\delta = \sqrt{{\gamma^2 + m_1/m_2}}$$= {N.delta}$, more than $|\gamma|$"),
        either(
            Solve.slow_shape,
            ratio=rf"[slow|$(X_2/X_1)_- = -\gamma + \delta = {N.slow_ratio} > 0$: in phase]",
            loose="[slow|$X_1 = 0$: mass 2 alone]",
        ),
        either(
            Solve.fast_shape,
            ratio=rf"[fast|$(X_2/X_1)_+ = -\gamma - \delta = {N.fast_ratio} < 0$: opposite]",
            loose="[fast|$X_2 = 0$: mass 1 alone]",
        ),
        either(Solve.product, shown=rf"Their product is $-m_1/m_2 = {N.product}$, whatever the springs."),
        either(
            Solve.arrows,
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
        places = [chain.rest(i) + METRE * W * var(Solve.x[i, mode]) for i in chain.BOTH]
        for i in chain.BOTH:
            full = chain.rest(i) + METRE * W * var(Solve.X[i, mode])
            shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full"))
        shapes += [*chain.cups(foot, *places), *chain.masses(foot, *places)]
        for i, place in zip(chain.BOTH, places, strict=True):
            rest, tip = chain.rest(i), axle - METRE * W * var(Solve.y[i, mode])
            shapes += [
                line(rest, (top + 0.055) * H, rest, axle, tint="mute", style="eq told"),
                line(place, (top + 0.062) * H, place, foot - chain.side(i), tint="mute", style="eq told"),
                arrow(rest, (top + 0.062) * H, place, (top + 0.062) * H, tint=mode),
                circle(rest, axle, METRE * W * var(Solve.R[i, mode]), tint=f"m{i}", style="orbit told"),
                line(place, foot, place, tip, tint="mute", style="eq told"),
                arrow(rest, axle, place, tip, tint=f"m{i}"),
            ]
    return shapes


def _title(mode: str, frequency: str, shape: str, top: float) -> list[Shape]:
    """The title of a mode over its chain; on a phone its shape stands under the arrows."""
    title = f"{mode} mode, {frequency}"
    lines = (f"{title}, {shape}", 0.03, ON_WIDE), (title, 0.03, ON_NARROW), (shape, 0.475, ON_NARROW)
    return [
        text(chain.WALL * W, (top + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, damping: Pair, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain, with its dashpots."""
    case = BrakedChain(system, damping)
    slow, fast = system.modes().omega.tolist()
    axes = framed(frame, by_name({Axes.t: time_axis(window or time_window(slow, fast))}))
    plain = {} if case.brakes else E.texts(quadratic(system), axes) | N.texts(system, axes)
    return Picture(
        columns={},
        axes=axes,
        signals=Solve.signals(case, axes),
        scalars=Solve.scalars(case, axes) | chain.Has.scalars(damping, axes),
        pace=pace(slow or fast, fast),
        values=plain or B.texts(case, axes),
        forms=Solve.forms(case),
    )

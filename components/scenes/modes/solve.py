"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import cmath
from collections.abc import Callable

from components import chain
from components.chain.signals import Axes
from components.language.blocks import Block
from components.language.expressions import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, column, either, row, stage, when, words
from components.layout.stage import ON_NARROW, ON_WIDE, H, Shape, W, arrow, box, circle, line, text
from components.quantities.axes import Axis, time_axis
from components.quantities.declared import AxesInForce, Declared, Family, Form, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, pace, sines
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.determinant import DeterminantPart, determinant_plot, determinant_words
from components.scenes.modes.numbers import BrakedChain
from components.scenes.modes.numbers import EquationNumbers as E
from components.scenes.modes.numbers import SolvedNumbers as N
from physics.coupled import TwoMassChain
from physics.modes import quadratic
from physics.sampling import time_window

METRE = 0.105
"""The fraction of the stage's width that an amplitude of 1 m takes."""
SIGNS, TOPS = "−+", {"slow": 0.0, "fast": 0.5}
"""The sign of each mode, and the top of its part of the stage as a fraction of the height."""
METRES = Axis(-1.0, 1.0, "m")

signal, form = Signal[BrakedChain], Form[TwoMassChain]


def _turned(case: BrakedChain, axes: AxesInForce, i: int, mode: str, ahead: float) -> AnySignal:
    """A rotating complex amplitude: its real part, or its imaginary part, a quarter turn behind."""
    X, time = case.amplitudes.get((i, mode), 0j), Axes.t(axes)
    s = case.exponents.get(mode, 0j)
    if case.brakes:
        return sines(METRES, time, (abs(X), s.imag, cmath.phase(X) + ahead, -s.real))
    return sines(METRES, time, (X.real, s.imag, ahead))


class Turning(Declared[BrakedChain]):
    """Two motions: positions and heights of the arrows' tips, amplitudes, circles."""

    x = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, QUARTER)), "x{}_{}")
    y = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, 0.0)), "y{}_{}")
    X = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: c.amplitudes.get(part, 0j).real), "X{}_{}")
    R = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: abs(c.amplitudes.get(part, 0j))), "R{}_{}")


class Solve(Declared[TwoMassChain]):
    """Flags for the visible texts, with or without spring 2."""

    positive = form(lambda c: "sum" if c.k2 else "loose" if c.k1 else "free")
    below = form(lambda c: "wall" if c.k1 and c.k2 else "zero")
    ratios = form(lambda c: "both" if c.k2 else "loose")
    gamma, product = form.some(2, lambda c: c.k2 > 0)
    slow_shape, fast_shape = form.some(2, lambda c: "ratio" if c.k2 else "loose")
    arrows = form(lambda c: True)


def sheet() -> Block:
    return row(
        column(
            when(
                Solve.arrows,
                turning_stage("solve", "Both modes, each moving at its own frequency", _mode_title, grow=375, phone=4),
            ),
            determinant_plot(),
            grow=480,
        ),
        column(
            words(*determinant_words(), style="facts way", grow=0, phone=20, name="determinant"),
            words(*_equation(), style="facts way", grow=0, phone=20, name="equation"),
            words(*_roots(), style="facts way", grow=0, phone=20, name="roots"),
            words(*_modes(), style="facts", grow=1, phone=20, name="modes"),
            grow=408,
        ),
    )


def turning_stage(name: str, what: str, title: Callable[[str], list[Shape]], *, grow: float, phone: int) -> Block:
    """The stage of two motions, one above the other."""
    label = f"{what}, and under each mass its complex amplitude as a rotating arrow"
    shapes = (shape for mode in chain.MODES for shape in (*title(mode), *_moving(mode)))
    return stage(*shapes, name=name, label=label, grow=grow, phone=phone, height=370, style="still turning")


def _always(text_: str) -> Paragraph:
    """One text with both variants of the shapes, so that a cover hides both."""
    return either(Solve.ratios, both=text_, loose=text_)


def _equation() -> list[Paragraph]:
    return [
        _always(r"**Where is** $D = m_1 m_2 \omega^4 - b\,\omega^2 + k_1 k_2$ **zero?**"),
        _always(rf"${E.m1m2}\,\omega^4 - {E.b}\,\omega^2 + {E.k1k2_}$$= 0$ with $b = m_1 k_2 + m_2 (k_1 + k_2)$"),
    ]


def _roots() -> list[Paragraph]:
    return [
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
    ]


def _modes() -> list[Paragraph]:
    return [
        _always(rf"[slow|$\omega_-^2 = {N.slow_square}$, $\omega_- = {N.slow_omega}$ rad/s]"),
        _always(rf"[fast|$\omega_+^2 = {N.fast_square}$, $\omega_+ = {N.fast_omega}$ rad/s]"),
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
        ),
    ]


def _moving(mode: str) -> list[Shape]:
    """A motion as a chain with its largest displacement in outline, and a rotating arrow under each mass."""
    top = TOPS[mode]
    foot, axle = (top + 0.225) * H, (top + 0.345) * H
    places = [chain.rest(i) + METRE * W * var(Turning.x[i, mode]) for i in chain.BOTH]
    shapes = [chain.standing_wall((top + 0.07) * H, 0.155 * H), line(chain.WALL * W, foot, W, foot, style="floor")]
    for i in chain.BOTH:
        full = chain.rest(i) + METRE * W * var(Turning.X[i, mode])
        shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full revealing"))
    shapes += [*chain.cups(foot, *places), *chain.masses(foot, *places)]
    for i, place in zip(chain.BOTH, places, strict=True):
        rest, tip = chain.rest(i), axle - METRE * W * var(Turning.y[i, mode])
        shapes += [
            line(rest, (top + 0.055) * H, rest, axle, tint="mute", style="eq revealing"),
            line(place, (top + 0.062) * H, place, foot - chain.side(i), tint="mute", style="eq revealing"),
            arrow(rest, (top + 0.062) * H, place, (top + 0.062) * H, tint=mode),
            circle(rest, axle, METRE * W * var(Turning.R[i, mode]), tint=f"m{i}", style="orbit revealing"),
            line(place, foot, place, tip, tint="mute", style="eq revealing"),
            arrow(rest, axle, place, tip, tint=f"m{i}"),
        ]
    return shapes


def _mode_title(mode: str) -> list[Shape]:
    """The title of a mode over its chain, with its shape. On a phone the shape is under the arrows."""
    j = chain.MODES.index(mode)
    title, shape = f"{mode} mode, *ω*_{{{SIGNS[j]}}} = {N.omega[j]} rad/s", f"*X*_2/*X*_1 = {N.ratio[j]}"
    lines = (f"{title}, {shape}", 0.03, ON_WIDE), (title, 0.03, ON_NARROW), (shape, 0.465, ON_NARROW)
    return [
        text(chain.WALL * W, (TOPS[mode] + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, omega: float, window: float | None, frame: Frame = FITTED) -> Picture:
    """Return everything that the view shows for one chain and one trial frequency."""
    case, det = BrakedChain(system, (0.0, 0.0)), DeterminantPart.of(system, omega, frame)
    slow, fast = system.modes().omega.tolist()
    axes = det.axes | framed(frame, by_name({Axes.t: time_axis(window or time_window(slow, fast))}))
    return Picture(
        columns=det.columns,
        axes=axes,
        signals=Turning.signals(case, axes),
        scalars=Turning.scalars(case, axes) | chain.Has.scalars((0.0, 0.0), axes) | det.scalars,
        pace=pace(slow or fast, fast),
        values=det.texts | E.texts(quadratic(system), axes) | N.texts(system, axes),
        forms=Solve.forms(system) | det.forms,
    )

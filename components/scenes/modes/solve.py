"""The view Solve of the scene modes: the quadratic for omega^2, and both modes as motions and as rotating arrows."""

from __future__ import annotations

import cmath
from collections.abc import Callable

from components import chain
from components.chain.parameters import Pair
from components.chain.signals import Axes
from components.language.blocks import Block
from components.language.numbers import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import Paragraph, column, either, row, stage, when, words
from components.layout.stage import ON_NARROW, ON_WIDE, H, Shape, W, arrow, box, circle, line, shown_by, text
from components.quantities.axes import Axis, time_axis
from components.quantities.declared import AxesInForce, Declared, Family, Form, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, pace, sines
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scenes.modes.determinant import DeterminantPart, determinant_plot, determinant_words
from components.scenes.modes.numbers import MOTIONS, BrakedChain, RootReadouts
from components.scenes.modes.numbers import BrakedNumbers as B
from components.scenes.modes.numbers import EquationNumbers as E
from components.scenes.modes.numbers import SolvedNumbers as N
from physics.coupled import TwoMassChain
from physics.damped_chain import Kind
from physics.modes import quadratic
from physics.sampling import time_window

METRE = 0.105
"""The share of the stage's width that an amplitude of 1 m takes."""
SIGNS, TOPS = "−+", {"slow": 0.0, "fast": 0.5}
"""The sign of each mode, and where its part of the stage begins, as a fraction of the height."""
METRES = Axis(-1.0, 1.0, "m")

signal, form = Signal[BrakedChain], Form[BrakedChain]


def _turned(case: BrakedChain, axes: AxesInForce, i: int, mode: str, ahead: float) -> AnySignal:
    """A complex amplitude as it turns: its real part, or the imaginary one, a quarter turn behind."""
    X, time = case.amplitudes.get((i, mode), 0j), Axes.t(axes)
    s = case.exponents.get(mode, 0j)
    if case.brakes:
        return sines(METRES, time, (abs(X), s.imag, cmath.phase(X) + ahead, -s.real))
    return sines(METRES, time, (X.real, s.imag, ahead))


class Solve(Declared[BrakedChain]):
    """Both modes in motion: places and heights of the arrows' tips, full swings, circles; what stands of the words."""

    x = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, QUARTER)), "x{}_{}")
    y = Family(chain.PARTS, lambda part: signal(lambda c, a: _turned(c, a, *part, 0.0)), "y{}_{}")
    X = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: c.amplitudes.get(part, 0j).real), "X{}_{}")
    R = Family(chain.PARTS, lambda part: Scalar[BrakedChain](lambda c, a: abs(c.amplitudes.get(part, 0j))), "R{}_{}")
    positive = form(lambda c: c.plainly("sum", "loose" if c.system.k1 else "free"))
    below = form(lambda c: c.plainly("wall" if c.system.k1 else "zero", "zero"))
    ratios = form(lambda c: c.plainly("both", "loose"))
    gamma, product = form.some(2, lambda c: c.plainly("shown", ""))
    slow_shape, fast_shape = form.some(2, lambda c: c.plainly("ratio", "loose"))
    arrows = form(lambda c: c.statement if c.brakes else "shown")
    braked = form(lambda c: c.brakes)
    many = form(lambda c: c.brakes and len(c.motions) > len(chain.MODES))
    root = Family(MOTIONS, lambda place: form(lambda c: c.root(place)), "{}_root")
    undamped = form(lambda c: not c.brakes)
    drawn = Family(chain.MODES, lambda mode: Scalar[BrakedChain](lambda c, a: mode in c.exponents), "{}_drawn")
    missing = Family(chain.MODES, lambda mode: Scalar[BrakedChain](lambda c, a: mode not in c.exponents), "{}_missing")


def _root(place: str) -> Paragraph:
    """The line on the roots of a motion, by what they are. The first two motions may be modes, or swing."""
    name, rate = f"{B.name[place]}: $X_2/X_1 = {B.ratio[place]}$,", f"$s = {B.rate[place]}$"
    lines = {
        "single": f"{name} {rate} 1/s. It does not swing.",
        "again": f"{name} {rate} 1/s, {B.repeats[place]}. It does not swing.",
        "rest": f"{name} $s = 0$: a rest.",
    }
    if place not in chain.MODES:
        return either(Solve.root[place], **lines)
    pair, both = rf"$s = {B.rate[place]} \pm {B.turn[place]}\, i$ 1/s", f"{rate} and ${B.other[place]}$ 1/s"
    swings = rf"It swings and dies, $\zeta = {B.zeta[place]}$."
    lines |= {
        "pair": f"{name} {pair}. {swings}",
        "met": f"{name} {pair}, each twice. {swings}",
        "real": f"{name} {both}. It does not swing.",
        "critical": rf"{name} {rate} 1/s twice. It is critical: $(A + B t)\, e^{{s t}}$.",
        "settles": f"{name} {both}. It does not swing; what is left is a displacement.",
        "drift": f"{name} $s = 0$ twice: $a + b t$.",
    }
    return either(Solve.root[place], **{form: f"[{place}|{line}]" for form, line in lines.items()})


BRAKED: list[Paragraph] = [
    either(
        Solve.braked,
        shown=r"**With dashpots** $D$ has odd powers. With $s = i \omega$ it is zero where "
        rf"${B.p4}\, s^4\, {B.p3}\, s^3\, {B.p2}\, s^2\, {B.p1}\, s\, {B.p0} = 0$:",
    ),
    *map(_root, MOTIONS),
    either(Solve.many, shown="The picture shows motions 1 and 2."),
]
"""The equation for the exponents, and its roots."""

IN_LINE = (
    rf"**The arrows** stay in line, as $c_1 k_2 = c_2 k_1$ $= {B.cross}$: the shapes are those without dashpots, and "
    "each mode dies by itself."
)
OFF_LINE = (
    rf"**The arrows** leave the line, by {B.angle['slow']}° and {B.angle['fast']}°, as $c_1 k_2 - c_2 k_1 = {B.gap}$ "
    "is not 0: in neither motion are both masses at 0 together."
)
DRIFTS = "with $a + b t$. Nothing brakes the drift."
BOTH_REST = r"$x_1(0) + (m_1 v_1(0) + m_2 v_2(0))/c_1$"
MEET = "Roots have met. A root that occurs more than once has one shape"
STATEMENTS: dict[str, str] = {
    Kind.DRIFT_BOTH: f"**Nothing ties the masses to a place:** both drift {DRIFTS}",
    Kind.DRIFT_TWO: f"**Nothing ties mass 2 to a place:** it drifts {DRIFTS}",
    Kind.REST_EACH: "**$s = 0$:** no spring brings a mass back. What is left at the end is a displacement: "
    rf"$x_1$ = {BOTH_REST}, and $x_2 - x_1$ = $x_2(0) - x_1(0) + m_2 v_2(0)/c_2$.",
    Kind.REST_BOTH: "**$s = 0$:** no spring brings both masses back. What is left at the end is a displacement: "
    f"both rest at {BOTH_REST}.",
    Kind.REST_TWO: "**$s = 0$:** no spring brings mass 2 back. What is left at the end is a displacement: "
    "mass 1 is at 0 again, mass 2 rests at $x_2(0) - x_1(0) + m_2 v_2(0)/c_2$.",
    Kind.PROPORTIONAL: IN_LINE,
    f"{Kind.PROPORTIONAL}_late": f"{IN_LINE} Neither swings, and the fast mode now outlasts the slow one.",
    Kind.EXCEPTIONAL: "**Both modes have become one:** one pair of roots, one shape. Its motions are $e^{s t}$ and "
    r"$t\, e^{s t}$.",
    Kind.PARTED: rf"**Two pairs with the same $|s|$.** The modes met at $c_1 = {B.c1_met}$, $c_2 = {B.c2_met}$ and "
    "parted: neither is the slow or the fast one.",
    f"{Kind.TWO_PAIRS}_lags": f"{OFF_LINE} In both, mass 2 lags behind mass 1.",
    f"{Kind.TWO_PAIRS}_leads": f"{OFF_LINE} In both, mass 2 leads mass 1.",
    Kind.ONE_PAIR: "**One motion swings, two do not.** Each has its own shape.",
    f"{Kind.ONE_PAIR}_met": rf"**One pair of roots swings, one does not.** {MEET}: its motions are $e^{{s t}}$ and "
    r"$t\, e^{s t}$.",
    Kind.CREEPING: "**Nothing swings.** Each motion has its own shape: 1 and 2 creep, 3 and 4 die quickly.",
    Kind.FOUR_REAL: "**Nothing swings.** Four motions, each with its own shape.",
    f"{Kind.FOUR_REAL}_met": rf"**Nothing swings.** {MEET}: its motions are $e^{{s t}}$, $t\, e^{{s t}}$ and so on.",
}
"""The sentence on what the free motions with dashpots are."""


def sheet() -> Block:
    return row(
        column(
            when(Solve.undamped, _stage("solve", "Both modes, each moving at its own frequency", _mode_title)),
            when(
                Solve.braked,
                _stage("braked", "Free motions of the chain with dashpots, one above the other", _motion_title),
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


def _stage(name: str, what: str, title: Callable[[str], list[Shape]]) -> Block:
    label = f"{what}, and under each mass its complex amplitude as a rotating arrow"
    shapes = (shape for mode in chain.MODES for shape in (*title(mode), *_moving(mode)))
    return stage(*shapes, name=name, label=label, grow=375, phone=4, height=370, style="still")


def _always(text_: str) -> Paragraph:
    """A text that stands without dashpots."""
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
        *BRAKED,
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
            **STATEMENTS,
        ),
    ]


def _moving(mode: str) -> list[Shape]:
    """A motion as a chain with its full swing as a ghost, and a rotating arrow under each mass."""
    top = TOPS[mode]
    foot, axle = (top + 0.185) * H, (top + 0.345) * H
    places = [chain.rest(i) + METRE * W * var(Solve.x[i, mode]) for i in chain.BOTH]
    shapes = [chain.standing_wall((top + 0.07) * H, 0.115 * H), line(chain.WALL * W, foot, W, foot, style="floor")]
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


def _mode_title(mode: str) -> list[Shape]:
    """The title of a mode over its chain; on a phone its shape stands under the arrows."""
    j = chain.MODES.index(mode)
    title = f"{mode} mode, *ω*_{{{SIGNS[j]}}} = {N.omega[j]} rad/s"
    return _titled(mode, title, title, f"*X*_2/*X*_1 = {N.ratio[j]}")


def _motion_title(mode: str) -> list[Shape]:
    """The title of a motion with dashpots; on a phone its roots are in the words alone."""
    name = str(B.name[mode])
    title = _titled(mode, f"{name}, *s* = {B.s[mode]} 1/s", name, f"*X*_2/*X*_1 = {B.ratio[mode]}")
    missing = text(chain.WALL * W, (TOPS[mode] + 0.03) * H, "no second shape", "start", tint=mode, style="t2 b")
    return [*shown_by(Solve.drawn[mode], *title), *shown_by(Solve.missing[mode], missing)]


def _titled(mode: str, title: str, narrow: str, shape: str) -> list[Shape]:
    """The title of a motion over its chain, and the one of a narrow stage, with the shape under the arrows."""
    lines = (f"{title}, {shape}", 0.03, ON_WIDE), (narrow, 0.03, ON_NARROW), (shape, 0.475, ON_NARROW)
    return [
        text(chain.WALL * W, (TOPS[mode] + share) * H, words_, "start", tint=mode, style="t2 b", show=show)
        for words_, share, show in lines
    ]


def picture(system: TwoMassChain, damping: Pair, omega: float, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain, with its dashpots, and a trial frequency."""
    case = BrakedChain(system, damping)
    slow, fast = system.modes().omega.tolist()
    axes = framed(frame, by_name({Axes.t: time_axis(window or time_window(slow, fast))}))
    det = None if case.brakes else DeterminantPart.of(system, omega, frame)
    plain = det and det.texts | E.texts(quadratic(system), axes) | N.texts(system, axes)
    return Picture(
        columns=det.columns if det else {},
        axes=axes | (det.axes if det else {}),
        signals=Solve.signals(case, axes),
        scalars=Solve.scalars(case, axes) | chain.Has.scalars(damping, axes) | (det.scalars if det else {}),
        pace=pace(slow or fast, fast),
        values=plain or B.texts(case, axes) | RootReadouts.texts(case, axes),
        forms=Solve.forms(case) | (det.forms if det else {}),
    )

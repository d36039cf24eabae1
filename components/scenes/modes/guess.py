"""The view Guess of the scene modes: the guess is a point that you drag, each equation is a curve, a mode is a
crossing.
"""

from __future__ import annotations

import math

import numpy as np
from msgspec.structs import replace

from components import chain
from components.chain import BOTH, MODES
from components.language.blocks import Block
from components.language.expressions import Number, var
from components.language.plots import Handle
from components.language.shapes import Along, Quotient
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import Paragraph, column, either, phrase, row, stage, term, words
from components.layout.stage import (
    AT_DESK,
    HALL,
    IN_HALL,
    LOW,
    NARROW,
    ON_NARROW,
    ON_WIDE,
    H,
    PlotFrame,
    Shape,
    ShownBy,
    W,
    arrow,
    box,
    circle,
    line,
    shown_by,
    text,
)
from components.quantities.axes import Axis, nice_axis, time_axis
from components.quantities.declared import (
    AxesInForce,
    Column,
    Declared,
    DrawnAxis,
    Family,
    Form,
    LiveNumber,
    Scalar,
    Signal,
    by_name,
)
from components.quantities.formatting import signed, three
from components.quantities.motion import QUARTER, pace, sines
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from components.scenes.modes.determinant import Axes as DetAxes
from components.scenes.modes.determinant import DeterminantPart, TriedPlaces, flags, frequency_handle, label, point
from components.scenes.modes.guess_case import REACH, Guess, added, agreement, inside, kind_of
from physics.coupled import Modes, TwoMassChain
from physics.modes import row_curves
from physics.sampling import NOTHING_OSCILLATES, periods
from physics.valid import DOUBLES

number, scalar, form = LiveNumber[Guess], Scalar[Guess], Form[Guess]
METRES = Axis(-1.0, 1.0, "m")


ROWS = "X2/X1 by equation 1 at the trial frequency", "X2/X1 by equation 2 at the trial frequency"
HAND = "extra force on mass 1 at full swing", "extra force on mass 2 at full swing"


class Numbers(Declared[Guess]):
    a11, a12 = number.both(lambda g: g.asked.matrix[0])
    a22 = number(lambda g: g.asked.matrix[1][1])
    distance = number(lambda g: None if g.asked.apart is None else abs(g.asked.apart))
    row = row1, row2 = number.both(lambda g: g.asked.rows, signed, ROWS)
    r = r_slow, r_fast = number.both(lambda g: g.system.modes().ratio, signed)
    slow_long, fast_long = number.both(
        lambda g: [f"{w:.5g}" if 0.1 <= w < 1e4 else three(w) for w in g.system.modes().omega]
    )
    X = X1, X2 = number.both(lambda g: g.push.amplitude, signed)
    need = need1_N, need2_N = number.both(lambda g: g.push.needed, signed, unit="N", whole=True)
    give = give1_N, give2_N = number.both(lambda g: g.push.springs, signed, unit="N", whole=True)
    add = add1_N, add2_N = number.both(lambda g: g.left, signed, HAND, unit="N", whole=True)
    you_add = number(added)


class Axes(Declared[Guess]):
    t, r = DrawnAxis.some(2)


class Curves(Declared[Guess]):
    """The shape that each equation requires; the second one on both sides of its pole."""

    w = Column[Guess]("")
    row1 = Column[Guess]("row1")
    row2_below, row2_above = Column[Guess]("row2_below"), Column[Guess]("row2_above")


def _swung(guess: Guess, axes: AxesInForce, size: float) -> AnySignal:
    """The motion with the guessed shape and frequency. It starts at its largest displacement; at omega = 0 it stays
    there."""
    return sines(METRES, Axes.t(axes), (size, guess.omega, QUARTER))


class Places(Declared[Guess]):
    """Motions and forces; over the plot, the modes, the guess, and the shapes that both equations require, in the units
    of the axes. Names that end with `_in` say whether a point is inside the frame.
    """

    swing = Signal[Guess](lambda g, a: _swung(g, a, 1.0))
    x = Family(BOTH, lambda i: Signal[Guess](lambda g, a: _swung(g, a, g.swings[i - 1])))
    # At the largest displacement: both amplitudes, which of them is smaller, and the lengths of the arrows.
    X = Family(BOTH, lambda i: scalar(lambda g, a: g.swings[i - 1]))
    less = Family(BOTH, lambda i: scalar(lambda g, a: abs(g.swings[i - 1]) <= abs(g.swings[2 - i])))
    need = Family(BOTH, lambda i: scalar(lambda g, a: g.arrow(g.push.needed[i - 1])), "need{}_N")
    give = Family(BOTH, lambda i: scalar(lambda g, a: g.arrow(g.push.springs[i - 1])), "give{}_N")
    # The shapes of the modes and of the guess, and the shapes that both equations require.
    r_of = Family(MODES, lambda mode: scalar(lambda g, a: g.seen(mode) and g.shape.place(g.modes[mode][1])), "r_{}")
    seen = Family(MODES, lambda mode: scalar(lambda g, a: g.seen(mode)), "{}_in")
    r = scalar(lambda g, a: g.shape.place(max(min(g.ratio, 2 * g.shape.end), 2 * g.shape.start)))
    guess_in = scalar(lambda g, a: g.w_in and inside(g.shape, g.ratio))
    row = Family(BOTH, lambda i: scalar(lambda g, a: g.reading(i)))
    row_in = Family(BOTH, lambda i: scalar(lambda g, a: g.reads(i)), "row{}_in")
    gap = scalar(lambda g, a: g.w_in and None not in g.asked.rows)


class Forms(Declared[Guess]):
    says = Family(BOTH, lambda i: form(lambda g: kind_of(g.asked.rows[i - 1])), "row{}_says")
    agree = form(agreement)
    matrix = form(lambda g: True)


A, C, D, F, N, P, T = Axes, Curves, DetAxes, Forms, Numbers, Places, TriedPlaces

SHAPE = PlotFrame("shape")

UNIT = 0.112 * W
"""Length of an amplitude of 1 m on the stage."""
LEAST = 0.02
"""The smallest amplitude in m to which a mass can be dragged; the amplitude of the other mass is 1 m."""
ARROWS = W - 0.36 * W * NARROW - 0.3 * W * HALL
"""The unit of length for force arrows. On a narrow stage it leaves room for numbers."""
SWING = ARROWS * var(P.swing)
AT_FULL, SHORT = "Force needed at full swing: −*m* *ω*² *X*", "needed: −*m* *ω*² *X*"
Lengths = Family[int, Scalar[Guess]]
FORCES: tuple[tuple[list[LiveNumber[Guess]], Lengths | None, str, dict[ShownBy, str], str], ...] = (
    (N.need, P.need, "ink", {(ON_WIDE, AT_DESK): AT_FULL, (ON_WIDE, IN_HALL): SHORT}, "needed"),
    (N.give, P.give, "k", {ON_WIDE: "= force of the springs"}, "springs"),
    (N.add, None, "F", {ON_WIDE: f"+ {N.you_add}"}, "missing"),
)
"""For each row of forces: the lengths of its arrows, its tint, and the words next to it, which depend on the available
width.
"""


def sheet() -> Block:
    return column(
        row(
            stage(
                *_shapes(), name="guess", grow=590, height=230,
                label="The guess at full swing; under it, on each mass, the force that the motion needs, the springs' "
                "force and that of your hand",
            ),
            words(
                "$A = " + _matrix((r"m_1 \omega^2 - k_1 - k_2", "k_2"), ("k_2", r"m_2 \omega^2 - k_2")) + "$",
                either(
                    F.matrix,
                    shown=f"${_matrix((N.a11, N.a12), (N.a12, N.a22))}"
                    r" \begin{pmatrix} X_1 \\ X_2 \end{pmatrix} = \begin{pmatrix} 0 \\ 0 \end{pmatrix}$",
                ),
                style="system", grow=296, phone=20,
            ),
            grow=222,
        ),
        row(
            _shape_plot(),
            words(*_readings(), style="facts", grow=296, phone=21),
            grow=268,
        ),
    )  # fmt: skip


def _matrix(*rows: tuple[object, object]) -> str:
    """A matrix in LaTeX; each row has the colour of its mass."""
    cells = (" & ".join(rf"{{\tint{{m{i}}}{{{cell}}}}}" for cell in row_) for i, row_ in enumerate(rows, start=1))
    return r"\begin{pmatrix} " + r" \\ ".join(cells) + r" \end{pmatrix}"


def _readings() -> list[Paragraph]:
    lines: list[Paragraph] = []
    for i, asked in enumerate(N.row, start=1):
        lines.append(
            either(
                F.says[i],
                number=rf"[m{i}|Equation {i} requires $X_2/X_1$ = **{asked}**]",
                pole=rf"[m{i}|Equation {i} requires $X_1$ = **0**]",
                any=rf"[m{i}|Equation {i} is 0 = 0: any shape]",
            )
        )
    return [
        *lines,
        either(
            F.agree,
            apart=f"They differ by **{N.distance}**. Only rest satisfies both, except where the curves cross.",
            pole=r"Only rest satisfies both equations, except at $\omega_-$ and $\omega_+$.",
            alone_1="[fast|**Mass 1 alone** satisfies both equations: the fast mode.]",
            alone_2="[slow|**Mass 2 alone** satisfies both equations: it is free, and the slow mode is its drift.]",
            every="**Every shape** satisfies both equations: nothing holds the masses.",
            near_slow=rf"Almost equal: they differ by **{N.distance}**. $\omega_-$ is {N.slow_long} rad/s.",
            near_fast=rf"Almost equal: they differ by **{N.distance}**. $\omega_+$ is {N.fast_long} rad/s.",
            same_slow="[slow|**Both equations agree:** the slow mode.]",
            same_fast="[fast|**Both equations agree:** the fast mode.]",
        ),
    ]


def _shape_plot() -> Block:
    return plot(
        SHAPE, x=D.w, y=A.r, x_column=C.w,
        title="The shape X2/X1 that each equation fixes, against omega squared",
        curves=(
            curve(C.row1, tint="m1", width="sum"),
            curve(C.row2_below, tint="m2", width="sum", group="row2"),
            curve(C.row2_above, tint="m2", width="sum", group="row2"),
        ),
        heading=(
            term("", "none", "ink", formula="X_2/X_1"),
            phrase(C.row1, "sum", "m1", formula=r"equation 1 $(k_1 + k_2 - m_1 \omega^2)/k_2$"),
            phrase("row2", "sum", "m2", formula=r"equation 2 $k_2/(k_2 - m_2 \omega^2)$"),
        ),
        room=Room(60, 12, top=28),
        handles=(
            Handle(parameter="ratio", symbol="", label="Trial shape X2/X1", tint="F", axis="y"), frequency_handle(),
        ),
        marks=flags(4), shapes=_over_shapes(), grow=590, phone=10, height=270,
    )  # fmt: skip


def _shapes() -> list[Shape]:
    foot, gap, lift = 0.505 * H, 0.144 * H, 0.122 * H + 8 * LOW
    last = foot + 3 * gap
    shapes = [chain.standing_wall(0.09 * H, 0.415 * H), line(chain.WALL * W, foot, W, foot, style="floor")]
    places = [chain.rest(i) + UNIT * var(P.x[i]) for i in BOTH]
    for i, place, amplitude in zip(BOTH, places, N.X, strict=True):
        rest = chain.rest(i)
        shapes += [
            line(rest, lift - 6, rest, last + 8, tint="mute", style="eq revealing"),
            line(place, lift, place, foot - chain.side(i), tint="mute", style="eq revealing"),
            arrow(rest, lift, place, lift, tint=f"m{i}"),
            text(rest, lift - 12, f"*X*_{i} = {amplitude} m", tint=f"m{i}", style="t2 b halo"),
        ]
    shapes += [*_full_swing(foot), *chain.masses(foot, *places)]
    for n, (numbers, lengths, tint, _, _) in enumerate(FORCES, start=1):
        for i, number in enumerate(numbers, start=1):
            shapes += _force(i, number, lengths, tint, foot + n * gap - 4)
    for i in BOTH:
        for length, start in ((P.give[i], 2), (P.need[i], 1)):
            tip = chain.rest(i) + SWING * var(length)
            shapes.append(line(tip, foot + start * gap, tip, last + 4, tint="mute", style="eq revealing"))
    for n, (_, _, tint, wide, narrow) in enumerate(FORCES, start=1):
        y = foot + n * gap
        shapes += [
            text(W + 20, y + 2, said, "start", tint=tint, style="t3 b", show=show) for show, said in wide.items()
        ]
        shapes.append(text(W, y + 1, narrow, "end", tint=tint, style="t0 halo", show=ON_NARROW))
    return shapes


def _full_swing(foot: Number) -> list[Shape]:
    """Both masses at their largest displacement, in outline. The one with the smaller amplitude can be dragged; the
    other one stays at 1 m.
    """
    one, two = chain.rest(1), chain.rest(2)
    X1, X2 = P.X[1].name, P.X[2].name
    first = Quotient(parameter="ratio", moves=X1, across="x", zero=one, unit=UNIT, over=X2, least=LEAST, most=1.0)
    second = Along(parameter="ratio", moves=X2, across="x", zero=two, unit=UNIT, least=-1.0, most=1.0)
    shapes: list[Shape] = []
    for i, way in ((1, first), (2, second)):
        full = chain.rest(i) + UNIT * var(P.X[i])
        held = grab(f"Shape: where mass {i} turns", way)
        shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full"))
        shapes += shown_by(P.less[i], circle(full, foot - 0.5 * chain.side(i), 0, grab=held))
    return shapes


def _force(i: int, number: LiveNumber[Guess], lengths: Lengths | None, tint: str, y: Number) -> list[Shape]:
    """One force arrow with its number. It starts at equilibrium; the arrow of the missing force starts at the tip of
    the springs' force.
    """
    start, tip = (0, var(lengths[i])) if lengths else (var(P.give[i]), var(P.need[i]))
    tint = f"m{i}" if lengths is P.need else tint
    rest, said, look = chain.rest(i), str(number), {"tint": tint, "style": "t1 b halo"}
    # Labels never overlap the arrows, at any displacement. With the large type of hall mode there is no room for a
    # number
    # between them.
    before, beyond = (
        text(rest + REACH * ARROWS * s + 8 * s, y + 5, said, anchor, show=show, **look)
        for s, anchor, show in ((-1, "end", ON_WIDE if i == 1 else AT_DESK), (1, "start", IN_HALL))
    )
    other = text(0, y + 5, said, "start", show=ON_NARROW, **look) if i == 1 else beyond
    tail, head = rest + SWING * start, rest + SWING * tip
    return [arrow(tail, y, head, y, tint=tint, style="thick", head=14, show=lengths and lengths[i]), before, other]


def _over_shapes() -> tuple[Shape, ...]:
    """Shapes over the plane of omega^2 and X2/X1: the trial frequency, both required shapes and the gap between them,
    the guess, the modes.
    """
    w, r = SHAPE.x(var(T.w)), SHAPE.y(var(P.r))
    shapes = [
        line(w, SHAPE.top, w, SHAPE.bottom, tint="F", show=T.w_in),
        line(w, SHAPE.y(var(P.row[1])), w, SHAPE.y(var(P.row[2])), tint="F", style="thick", show=P.gap),
        line(SHAPE.left, r, w, r, tint="F", style="dots", show=P.guess_in),
    ]
    for mode, ratio in zip(MODES, N.r, strict=True):
        at, name = (SHAPE, var(T.w_of[mode]), var(P.r_of[mode])), f"{mode} mode {ratio}"
        shapes += [
            point(*at, 7, mode, show=P.seen[mode], style="ring"),
            label(*at, mode, (0, 0), name, "beside", show=P.seen[mode]),
        ]
    shapes += [point(SHAPE, var(T.w), var(P.row[i]), 6, f"m{i}", show=P.row_in[i]) for i in BOTH]
    return (*shapes, _guess_point(w, r))


def _guess_point(x: Number, y: Number) -> Shape:
    """The point in the plane of omega^2 and X2/X1."""
    ways = on_plot(SHAPE, "x", "omega", T.w, D.w, least=0.0), on_plot(SHAPE, "y", "ratio", P.r, A.r)
    held = grab("Guess: frequency and shape", *ways, inside=SHAPE)
    return circle(x, y, 8, tint="F", show=P.guess_in, grab=held, held=True)


def picture(system: TwoMassChain, omega: float, ratio: float, window: float | None, frame: Frame = FITTED) -> Picture:
    """Return everything that the view shows for one chain and one guess. Raise ValueError if a curve leaves the range
    of doubles.
    """
    modes = system.modes()
    if system.k2 and not np.all(np.isfinite(modes.ratio)):
        raise ValueError(f"a mode ratio X2/X1 leaves {DOUBLES}")
    reach, shape = _shape_axis(modes)
    time = time_axis(window or (periods(omega, 4) if omega else NOTHING_OSCILLATES))
    det = DeterminantPart.of(system, omega, frame)
    axes = det.axes | framed(frame, by_name({A.r: shape, A.t: time}))
    guess = Guess(system, omega, D.w(axes), ratio=ratio, shape=A.r(axes))
    return Picture(
        columns=_columns(system, D.w(axes).end, reach) | det.columns,
        axes=axes,
        signals=Places.signals(guess, axes),
        scalars=det.scalars | Places.scalars(guess, axes),
        pace=pace(omega, omega),
        values=det.texts | Numbers.texts(guess, axes),
        forms=det.forms | Forms.forms(guess),
    )


def _shape_axis(modes: Modes) -> tuple[float, Axis]:
    """Return the range of the curves of X2/X1, and an axis that contains both modes."""
    half = 2 * max((abs(float(r)) for r in modes.ratio if r and math.isfinite(r)), default=2.0)
    reach = 3 * half
    if math.isinf(reach):
        raise ValueError(f"three times the larger mode ratio X2/X1, as far as it is drawn, leaves {DOUBLES}")
    axis = nice_axis(-half, half, "", 4, exact=True)
    return reach, replace(axis, ticks=axis.ticks[1:-1], drawn=(-half / 2, half / 2))


def _columns(system: TwoMassChain, end: float, largest: float) -> dict[str, Columns]:
    first, second = row_curves(system, end, largest)
    columns = {C.row1.source: by_name({C.w: first.omega[0], C.row1: first.ratio[0]})}
    for one, w, r in zip((C.row2_below, C.row2_above), second.omega, second.ratio, strict=False):
        columns[one.source] = by_name({C.w: w, one: r})
    return columns

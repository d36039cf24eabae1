"""The view Guess of the scene modes: a guess is a point that a hand takes, each equation a curve, a mode a crossing."""

from __future__ import annotations

from components import chain
from components.language.blocks import Block
from components.language.numbers import Number, var
from components.language.plots import Handle
from components.language.shapes import Along, Quotient
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import Paragraph, column, either, phrase, row, stage, term, words
from components.layout.stage import (
    AT_DESK,
    HALL,
    IN_HALL,
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
from components.layout.text import rich
from components.quantities.declared import Family, LiveNumber, Scalar
from components.scenes.modes.guess_picture import REACH, Guess
from components.scenes.modes.guess_picture import GuessAxes as A
from components.scenes.modes.guess_picture import GuessCurves as C
from components.scenes.modes.guess_picture import GuessForms as F
from components.scenes.modes.guess_picture import GuessNumbers as N
from components.scenes.modes.guess_picture import GuessPlaces as P

SHAPE, DET = PlotFrame("shape"), PlotFrame("det")

UNIT = 0.112 * W
"""An amplitude of 1 m on the stage."""
LEAST = 0.02
"""m; as small as a hand makes an amplitude: the other one is 1 m."""
ARROWS = W - 0.36 * W * NARROW - 0.3 * W * HALL
"""The length of which force arrows are a fraction: beside short ones there is room for numbers on a narrow stage."""
SWING = ARROWS * var(P.swing)
AT_FULL, SHORT = "Force needed at full swing: −*m* *ω*² *X*", "needed: −*m* *ω*² *X*"
Lengths = Family[int, Scalar[Guess]]
FORCES: tuple[tuple[list[LiveNumber[Guess]], Lengths | None, str, dict[ShownBy, str], str], ...] = (
    (N.need, P.need, "ink", {(ON_WIDE, AT_DESK): AT_FULL, (ON_WIDE, IN_HALL): SHORT}, "needed"),
    (N.give, P.give, "k", {ON_WIDE: "= force of the springs"}, "springs"),
    (N.add, None, "F", {ON_WIDE: f"+ {N.you_add}"}, "hand"),
)
"""Each row of forces, the lengths of its arrows, its tint, and the words beside it, by the room that there is."""


def sheet() -> Block:
    return column(
        row(
            stage(
                *_shapes(), grow=590, height=230,
                label="The guess at full swing; under it, on each mass, the force that the motion needs, the springs' "
                "force and that of your hand",
            ),
            words(
                "$A = " + _matrix((r"m_1 \omega^2 - k_1 - k_2", "k_2"), ("k_2", r"m_2 \omega^2 - k_2")) + "$",
                f"${_matrix((N.a11, N.a12), (N.a12, N.a22))}"
                r" \begin{pmatrix} X_1 \\ X_2 \end{pmatrix} = \begin{pmatrix} 0 \\ 0 \end{pmatrix}$",
                style="system", grow=296, phone=20,
            ),
            grow=222,
        ),
        row(
            column(_shape_plot(), _determinant_plot(), grow=590),
            column(
                words(*_readings(), style="facts", grow=195, phone=21),
                words(*_determinant_words(), style="facts", grow=116, phone=22),
                grow=296,
            ),
            grow=350,
        ),
    )  # fmt: skip


def _matrix(*rows: tuple[object, object]) -> str:
    """A matrix of which each row has the tint of its mass."""
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


def _determinant_words() -> list[Paragraph]:
    return [
        either(
            F.D,
            product=rf"$D = k_2 (k_2 - m_2 \omega^2) \cdot ({N.apart})$$= {N.D}$",
            value=f"$D = {N.D}$",
        ),
        either(
            F.roots,
            two=r"$D = \text{det } A$ is + at 0, − at $k_2/m_2$, + far out: two zeros, whatever the chain.",
            wall=r"No wall: $D$ is 0 at 0, − at $k_2/m_2$, + far out: one zero is at 0.",
            loose=r"No coupling: $D = m_2 \omega^2 (m_1 \omega^2 - k_1)$, each equation holds one mass only.",
        ),
    ]


def _shape_plot() -> Block:
    return plot(
        SHAPE, x=A.w, y=A.r, x_column=C.w,
        title="The shape X2/X1 that each equation fixes, against omega squared",
        curves=(
            curve(C.row1, tint="m1", width="sum"),
            curve(C.row2_below, tint="m2", width="sum", group="row2"),
            curve(C.row2_above, tint="m2", width="sum", group="row2"),
        ),
        heading=(
            term("", "none", "ink", formula="X_2/X_1"),
            phrase(C.row1, "sum", "m1", formula=r"equation 1 requires $(k_1 + k_2 - m_1 \omega^2)/k_2$"),
            phrase("row2", "sum", "m2", formula=r"equation 2 requires $k_2/(k_2 - m_2 \omega^2)$"),
        ),
        x_labels=False, room=Room(60, 12),
        handles=(
            Handle(parameter="ratio", symbol="", label="Trial shape X2/X1", tint="F", axis="y"),
            Handle(parameter="omega", symbol="", label="Trial frequency", tint="F", axis="x", bare=True),
        ),
        marks=tuple(mark(P.w_of[mode], tint=mode) for mode in chain.MODES),
        shapes=_over_shapes(), grow=195, phone=10, height=220,
    )  # fmt: skip


def _determinant_plot() -> Block:
    return plot(
        DET, x=A.w, y=A.D, x_column=C.w,
        title="The determinant D of A against omega squared",
        curves=(curve(C.D, tint="ink", width="sum"),),
        heading=(term("", "none", "ink", formula="D"),),
        room=Room(60, 12, top=6),
        handles=(
            Handle(
                parameter="omega", symbol="ω²", label="Trial frequency, squared", tint="F", axis="x",
                text=N.square.name, covering="(rad/s)²",
            ),
        ),
        marks=tuple(
            mark(
                P.w_of[mode], tint=mode, set="omega", exactly=P.w_si[mode], lift=23, label=f"Go to the {mode} mode",
                html=rich(rf"$\omega_{sign}$ {omega}"), flag="one",
            )
            for mode, sign, omega in zip(chain.MODES, "-+", N.omega, strict=True)
        ),
        shapes=_over_determinant(), grow=100, phone=11, height=150,
    )  # fmt: skip


def _shapes() -> list[Shape]:
    foot, gap, lift = 0.505 * H, 0.144 * H, 0.122 * H
    last = foot + 3 * gap
    shapes = [chain.standing_wall(0.09 * H, 0.415 * H), line(chain.WALL * W, foot, W, foot, style="floor")]
    places = [chain.rest(i) + UNIT * var(P.x[i]) for i in chain.BOTH]
    for i, place, amplitude in zip(chain.BOTH, places, N.X, strict=True):
        rest = chain.rest(i)
        shapes += [
            line(rest, lift - 6, rest, last + 8, tint="mute", style="eq told"),
            line(place, lift, place, foot - chain.side(i), tint="mute", style="eq told"),
            arrow(rest, lift, place, lift, tint=f"m{i}"),
            text(rest, lift - 12, f"*X*_{i} = {amplitude} m", tint=f"m{i}", style="t2 b halo"),
        ]
    shapes += [*_full_swing(foot), *chain.masses(foot, *places)]
    for n, (numbers, lengths, tint, _, _) in enumerate(FORCES, start=1):
        for i, number in enumerate(numbers, start=1):
            shapes += _force(i, number, lengths, tint, foot + n * gap - 4)
    for i in chain.BOTH:
        for length, start in ((P.give[i], 2), (P.need[i], 1)):
            tip = chain.rest(i) + SWING * var(length)
            shapes.append(line(tip, foot + start * gap, tip, last + 4, tint="mute", style="eq told"))
    for n, (_, _, tint, wide, narrow) in enumerate(FORCES, start=1):
        y = foot + n * gap
        shapes += [
            text(W + 20, y + 2, said, "start", tint=tint, style="t3 b", show=show) for show, said in wide.items()
        ]
        shapes.append(text(W, y + 1, narrow, "end", tint=tint, style="t0 halo", show=ON_NARROW))
    return shapes


def _full_swing(foot: Number) -> list[Shape]:
    """Both masses where they turn, in outline: the one that swings less is taken in hand, the other keeps its 1 m."""
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
    """One force arrow, from equilibrium (what is missing: from the springs' to the needed one), and its number."""
    start, tip = (0, var(lengths[i])) if lengths else (var(P.give[i]), var(P.need[i]))
    tint = f"m{i}" if lengths is P.need else tint
    rest, said, look = chain.rest(i), str(number), {"tint": tint, "style": "t1 b halo"}
    # Clear of the arrows, wherever they swing to; with a hall's type there is no room for a number between them.
    before, beyond = (
        text(rest + REACH * ARROWS * s + 8 * s, y + 5, said, anchor, show=show, **look)
        for s, anchor, show in ((-1, "end", ON_WIDE if i == 1 else AT_DESK), (1, "start", IN_HALL))
    )
    other = text(0, y + 5, said, "start", show=ON_NARROW, **look) if i == 1 else beyond
    tail, head = rest + SWING * start, rest + SWING * tip
    return [arrow(tail, y, head, y, tint=tint, style="thick", head=14, show=lengths and lengths[i]), before, other]


def _over_shapes() -> tuple[Shape, ...]:
    """Over the plane of omega^2 and X2/X1: the trial frequency, both readings and their gap, the guess, the modes."""
    w, r = SHAPE.x(var(P.w)), SHAPE.y(var(P.r))
    shapes = [
        line(w, SHAPE.top, w, DET.bottom, tint="F", show=P.w_in),
        line(w, SHAPE.y(var(P.row[1])), w, SHAPE.y(var(P.row[2])), tint="F", style="thick", show=P.gap),
        line(SHAPE.left, r, w, r, tint="F", style="dots", show=P.guess_in),
    ]
    for mode, shift, ratio in zip(chain.MODES, ((14, -8), (11, -14)), N.r, strict=True):
        at, name = (SHAPE, var(P.w_of[mode]), var(P.r_of[mode])), f"{mode} mode {ratio}"
        shapes += _point(*at, 7, mode, show=P.seen[mode], style="ring")
        shapes += _label(*at, mode, shift, name, show=(P.seen[mode], ON_WIDE))
        shapes += _label(*at, mode, (6, -14), name, "middle", show=(P.seen[mode], ON_NARROW))
    for i in chain.BOTH:
        shapes += _point(SHAPE, var(P.w), var(P.row[i]), 6, f"m{i}", show=P.row_in[i])
    return (*shapes, _guess_point(w, r))


def _guess_point(x: Number, y: Number) -> Shape:
    """The point in the plane of omega^2 and X2/X1."""
    ways = on_plot(SHAPE, "x", "omega", P.w, A.w, least=0.0), on_plot(SHAPE, "y", "ratio", P.r, A.r)
    held = grab("Guess: frequency and shape", *ways, inside=SHAPE)
    return circle(x, y, 8, tint="F", show=P.guess_in, grab=held, held=True)


def _over_determinant() -> tuple[Shape, ...]:
    """Over D: its value at the trial frequency, its zeros, and the two values that alone prove them."""
    here, rest, held = (DET, var(P.w), var(P.D)), (DET, 0.0, var(P.D0)), (DET, var(P.w_held), var(P.D_held))
    shapes = [
        *_label(*here, "ink", (10, -9), f"*D* = {N.D}", show=P.D_in),
        *_point(*rest, 4, "ink", show=P.D0_in),
        *_label(*rest, "ink", (0, 0), f"*k*_1*k*_2 = {N.k1k2}", "beside", P.D0_in, "t0"),
        *_point(*held, 4, "ink", show=P.held_in),
        *_label(*held, "ink", (0, 0), f"−*k*_2² = {N.k2k2}", "beside", P.held_in, "t0"),
    ]
    for mode in chain.MODES:
        shapes += _point(DET, var(P.w_of[mode]), 0.0, 5, mode, style="ring")
    return (*shapes, *_point(*here, 6, "ink", show=P.D_in))


def _point(
    frame: PlotFrame,
    x: Number,
    y: Number,
    radius: float,
    tint: str,
    show: ShownBy | None = None,
    style: str | None = None,
) -> list[Shape]:
    return [circle(frame.x(x), frame.y(y), radius, tint=tint, style=style, show=show)]


def _label(
    frame: PlotFrame, x: Number, y: Number, tint: str, shift: tuple[int, int], words_: str, anchor: str = "start",
    show: ShownBy | None = None, weight: str = "t1 b",
) -> list[Shape]:  # fmt: skip
    place = frame.x(x) + shift[0], frame.y(y) + shift[1]
    return [text(*place, words_, anchor, tint=tint, style=f"{weight} halo", show=show)]

"""The view Guess of the scene modes: a guess is a point that a hand takes, each equation a curve, a mode a crossing."""

from __future__ import annotations

from components import chain
from components.language.blocks import Block
from components.language.numbers import Number, var
from components.language.plots import Handle, Mark
from components.language.shapes import Along, Quotient
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import Paragraph, column, either, phrase, row, stage, term, words
from components.layout.stage import H, Shape, W, arrow, box, circle, line, on_x, on_y, shown_by, text
from components.layout.text import rich
from components.quantities.declared import LiveNumber
from components.scenes.modes.guess_picture import REACH, Guess
from components.scenes.modes.guess_picture import GuessNumbers as N

UNIT = 0.112 * W
"""An amplitude of 1 m on the stage."""
LEAST = 0.02
"""m; as small as a hand makes an amplitude: the other one is 1 m."""
ARROWS = W - 0.36 * W * var("narrow") - 0.3 * W * var("hall")
"""The length of which force arrows are a fraction: beside short ones there is room for numbers on a narrow stage."""
SWING = ARROWS * var("swing")
FORCES = (
    (
        N.need,
        "ink",
        {"wide desk": "Force needed at full swing: −*m* *ω*² *X*", "wide hall": "needed: −*m* *ω*² *X*"},
        "needed",
    ),
    (N.give, "k", {"wide": "= force of the springs"}, "springs"),
    (N.add, "F", {"wide": f"+ {N.you_add}"}, "hand"),
)
"""Each row of forces, its tint, and the words beside it, by the room that there is."""


def sheet() -> Block:
    return column(
        row(
            stage(
                *_shapes(),
                label="The guess at full swing; under it, on each mass, the force that the motion needs, the springs' "
                "force and that of your hand",
                grow=590,
                height=230,
            ),
            words(
                "$A = " + _matrix((r"m_1 \omega^2 - k_1 - k_2", "k_2"), ("k_2", r"m_2 \omega^2 - k_2")) + "$",
                f"${_matrix((N.a11, N.a12), (N.a12, N.a22))}"
                r" \begin{pmatrix} X_1 \\ X_2 \end{pmatrix} = \begin{pmatrix} 0 \\ 0 \end{pmatrix}$",
                style="system",
                grow=296,
                phone=20,
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
    )


def _matrix(*rows: tuple[object, object]) -> str:
    """A matrix of which each row has the tint of its mass."""
    cells = (" & ".join(rf"{{\tint{{m{i}}}{{{cell}}}}}" for cell in row_) for i, row_ in enumerate(rows, start=1))
    return r"\begin{pmatrix} " + r" \\ ".join(cells) + r" \end{pmatrix}"


def _readings() -> list[Paragraph]:
    lines: list[Paragraph] = []
    for i, asked in enumerate(N.row, start=1):
        lines.append(
            either(
                f"row{i}_says",
                number=rf"[m{i}|Equation {i} requires $X_2/X_1$ = **{asked}**]",
                pole=rf"[m{i}|Equation {i} requires $X_1$ = **0**]",
                any=rf"[m{i}|Equation {i} is 0 = 0: any shape]",
            )
        )
    return [
        *lines,
        either(
            "agree",
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
            "D",
            product=rf"$D = k_2 (k_2 - m_2 \omega^2) \cdot ({N.apart})$$= {N.D}$",
            value=f"$D = {N.D}$",
        ),
        either(
            "roots",
            two=r"$D = \text{det } A$ is + at 0, − at $k_2/m_2$, + far out: two zeros, whatever the chain.",
            wall=r"No wall: $D$ is 0 at 0, − at $k_2/m_2$, + far out: one zero is at 0.",
            loose=r"No coupling: $D = m_2 \omega^2 (m_1 \omega^2 - k_1)$, each equation holds one mass only.",
        ),
    ]


def _shape_plot() -> Block:
    return plot(
        "shape",
        x="w",
        y="r",
        title="The shape X2/X1 that each equation fixes, against omega squared",
        x_column="w",
        curves=(
            curve("row1", source="row1", tint="m1", width="sum", label=""),
            curve("row2_below", source="row2_below", tint="m2", width="sum", group="row2"),
            curve("row2_above", source="row2_above", tint="m2", width="sum", group="row2"),
        ),
        heading=(
            term("", "none", "ink", formula="X_2/X_1"),
            phrase("row1", "sum", "m1", formula=r"equation 1 requires $(k_1 + k_2 - m_1 \omega^2)/k_2$"),
            phrase("row2", "sum", "m2", formula=r"equation 2 requires $k_2/(k_2 - m_2 \omega^2)$"),
        ),
        x_labels=False,
        room=Room(60, 12),
        handles=(
            Handle(parameter="ratio", symbol="", label="Trial shape X2/X1", tint="F", axis="y"),
            Handle(parameter="omega", symbol="", label="Trial frequency", tint="F", axis="x", bare=True),
        ),
        marks=tuple(Mark(at=f"w_{mode}", tint=mode) for mode in chain.MODES),
        shapes=_over_shapes(),
        grow=195,
        phone=10,
        height=220,
    )


def _determinant_plot() -> Block:
    return plot(
        "det",
        x="w",
        y="D",
        title="The determinant D of A against omega squared",
        x_column="w",
        curves=(curve("D", source="det", tint="ink", width="sum"),),
        heading=(term("", "none", "ink", formula="D"),),
        room=Room(60, 12, top=6),
        handles=(
            Handle(
                parameter="omega",
                symbol="ω²",
                label="Trial frequency, squared",
                tint="F",
                axis="x",
                text=N.square.name,
                covering="(rad/s)²",
            ),
        ),
        marks=tuple(
            Mark(
                at=f"w_{mode}",
                tint=mode,
                set="omega",
                exactly=f"w_{mode}_si",
                lift=23,
                label=f"Go to the {mode} mode",
                html=rich(rf"$\omega_{sign}$ {omega}"),
                flag="one",
            )
            for mode, sign, omega in zip(chain.MODES, "-+", N.omega, strict=True)
        ),
        shapes=_over_determinant(),
        grow=100,
        phone=11,
        height=150,
    )


def _shapes() -> list[Shape]:
    foot, gap, lift = 0.505 * H, 0.144 * H, 0.122 * H
    last = foot + 3 * gap
    shapes = [chain.standing_wall(0.09 * H, 0.415 * H), line(chain.WALL * W, foot, W, foot, style="floor")]
    places = [chain.rest(i) + UNIT * var(f"x{i}") for i in (1, 2)]
    for i, place, amplitude in zip((1, 2), places, N.X, strict=True):
        rest = chain.rest(i)
        shapes += [
            line(rest, lift - 6, rest, last + 8, tint="mute", style="eq told"),
            line(place, lift, place, foot - chain.side(i), tint="mute", style="eq told"),
            arrow(rest, lift, place, lift, tint=f"m{i}"),
            text(rest, lift - 12, f"*X*_{i} = {amplitude} m", tint=f"m{i}", style="t2 b halo"),
        ]
    shapes += [*_full_swing(foot), *chain.masses(foot, *places)]
    for n, (forces, tint, _, _) in enumerate(FORCES, start=1):
        for i, force in enumerate(forces, start=1):
            shapes += _force(i, force, tint, foot + n * gap - 4)
    for i in (1, 2):
        for forces, start in ((N.give, 2), (N.need, 1)):
            tip = chain.rest(i) + SWING * var(forces[i - 1].name)
            shapes.append(line(tip, foot + start * gap, tip, last + 4, tint="mute", style="eq told"))
    for n, (_, tint, wide, narrow) in enumerate(FORCES, start=1):
        y = foot + n * gap
        shapes += [
            text(W + 20, y + 2, said, "start", tint=tint, style="t3 b", show=show) for show, said in wide.items()
        ]
        shapes.append(text(W, y + 1, narrow, "end", tint=tint, style="t0 halo", show="narrow"))
    return shapes


def _full_swing(foot: Number) -> list[Shape]:
    """Both masses where they turn, in outline: the one that swings less is taken in hand, the other keeps its 1 m."""
    one, two = chain.rest(1), chain.rest(2)
    first = Quotient(parameter="ratio", moves="X1", across="x", zero=one, unit=UNIT, over="X2", least=LEAST, most=1.0)
    second = Along(parameter="ratio", moves="X2", across="x", zero=two, unit=UNIT, least=-1.0, most=1.0)
    shapes: list[Shape] = []
    for i, way in ((1, first), (2, second)):
        full = chain.rest(i) + UNIT * var(f"X{i}")
        held = grab(f"Shape: where mass {i} turns", way)
        shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full"))
        shapes += shown_by(f"less{i}", circle(full, foot - 0.5 * chain.side(i), 0, grab=held))
    return shapes


def _force(i: int, force: LiveNumber[Guess], tint: str, y: Number) -> list[Shape]:
    """One force arrow, from equilibrium (what is missing: from the springs' to the needed one), and its number."""
    need, give = var(N.need[i - 1].name), var(N.give[i - 1].name)
    start, tip = (give, need) if force in N.add else (0, var(force.name))
    tint = f"m{i}" if force in N.need else tint
    rest, said, look = chain.rest(i), str(force), {"tint": tint, "style": "t1 b halo"}
    # Clear of the arrows, wherever they swing to; with a hall's type there is no room for a number between them.
    before, beyond = (
        text(rest + REACH * ARROWS * s + 8 * s, y + 5, said, anchor, show=show, **look)
        for s, anchor, show in ((-1, "end", "wide" if i == 1 else "desk"), (1, "start", "hall"))
    )
    other = text(0, y + 5, said, "start", show="narrow", **look) if i == 1 else beyond
    tail, head = rest + SWING * start, rest + SWING * tip
    return [arrow(tail, y, head, y, tint=tint, style="thick", head=14, show=force.name), before, other]


def _over_shapes() -> tuple[Shape, ...]:
    """Over the plane of omega^2 and X2/X1: the trial frequency, both readings and their gap, the guess, the modes."""
    w, r = on_x("shape", var("w")), on_y("shape", var("r"))
    shapes = [
        line(w, var("shape.top"), w, var("det.bottom"), tint="F", show="w_in"),
        line(w, on_y("shape", var("gap_low")), w, on_y("shape", var("gap_high")), tint="F", style="thick", show="gap"),
        line(var("shape.left"), r, w, r, tint="F", style="dots", show="guess_in"),
    ]
    for mode, shift, ratio in zip(chain.MODES, ((14, -8), (11, -14)), N.r, strict=True):
        w_mode, r_mode, name = var(f"w_{mode}"), var(ratio.name), f"{mode} mode {ratio}"
        shapes += _point("shape", w_mode, r_mode, 7, mode, show=f"{mode}_in", style="ring")
        shapes += _label("shape", w_mode, r_mode, mode, shift, name, show=f"{mode}_in wide")
        shapes += _label("shape", w_mode, r_mode, mode, (6, -14), name, "middle", show=f"{mode}_in narrow")
    for i in (1, 2):
        at = var(f"row{i}")
        shapes += _point("shape", var("w"), at, 6, f"m{i}", show=f"row{i}_in")
    return (*shapes, _guess_point(w, r))


def _guess_point(x: Number, y: Number) -> Shape:
    """The point in the plane of omega^2 and X2/X1."""
    ways = on_plot("shape", "x", "omega", "w", "w", least=0.0), on_plot("shape", "y", "ratio", "r", "r")
    held = grab("Guess: frequency and shape", *ways, inside="shape")
    return circle(x, y, 8, tint="F", show="guess_in", grab=held, held=True)


def _over_determinant() -> tuple[Shape, ...]:
    """Over D: its value at the trial frequency, its zeros, and the two values that alone prove them."""
    shapes = [
        *_label("det", var("w"), var("D"), "ink", (10, -9), f"*D* = {N.D}", show="D_in"),
        *_point("det", var("w0"), var("D0"), 4, "ink", show="D0_in"),
        *_label("det", var("w0"), var("D0"), "ink", (0, 0), f"*k*_1*k*_2 = {N.k1k2}", "beside", "D0_in", "t0"),
        *_point("det", var("w_held"), var("D_held"), 4, "ink", show="held_in"),
        *_label("det", var("w_held"), var("D_held"), "ink", (0, 0), f"−*k*_2² = {N.k2k2}", "beside", "held_in", "t0"),
    ]
    for mode in chain.MODES:
        shapes += _point("det", var(f"w_{mode}"), var("zero"), 5, mode, style="ring")
    return (*shapes, *_point("det", var("w"), var("D"), 6, "ink", show="D_in"))


def _point(
    plot_: str, x: Number, y: Number, radius: float, tint: str, show: str | None = None, style: str | None = None
) -> list[Shape]:
    return [circle(on_x(plot_, x), on_y(plot_, y), radius, tint=tint, style=style, show=show)]


def _label(
    plot_: str,
    x: Number,
    y: Number,
    tint: str,
    shift: tuple[int, int],
    words_: str,
    anchor: str = "start",
    show: str | None = None,
    weight: str = "t1 b",
) -> list[Shape]:
    place = on_x(plot_, x) + shift[0], on_y(plot_, y) + shift[1]
    return [text(*place, words_, anchor, tint=tint, style=f"{weight} halo", show=show)]

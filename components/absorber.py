"""How the absorber is drawn: one instant twice on the stage, two response curves, and goals at the end of their limits."""

from __future__ import annotations

from components.equations import rich
from components.plots import Axis, Band, Curve, nice_axis, nice_ticks, plot
from components.sheet import Block, phrase, stage
from components.stage import H, Number, Shape, W, arrow, block, circle, line, on_x, on_y, path, spring, text, var, wall

WALL, REST = 0.024, (0.36, 0.687)
"""Where the wall and the masses at rest stand, as fractions of the stage's width."""
FLOORS = (0.377 * H, 0.86 * H)
GOALS = 3
TICK, CROSS = "M-3.5 .5l2.6 2.6 5-5.600", "M-2.800 -2.800l5.600 5.600M2.800 -2.800l-5.600 5.600"


def size_axis(top: float) -> Axis:
    """An axis of amplitudes from 0 to `top` metres, in millimetres where that is what people say."""
    if not 1e-4 <= top < 1:
        return nice_axis(0.0, top, "m", exact=True)
    return Axis(0.0, top, "mm", -3, ticks=nice_ticks(0.0, 1e3 * top, 3))


def side(mass: int) -> Number:
    return var(f"side{mass}") * H


def picture() -> Block:
    """The same instant twice: above, as an outline, the machine alone; below, with the absorber."""
    shapes = [wall(WALL * W, 0.02 * H, FLOORS[1] - 0.02 * H + 1), *_rests(), *_alone(), *_both(), *_forces(), *_verdicts()]
    return stage(
        *shapes, label="The machine alone and with the absorber at the same instant, with the forces on it", height=245
    )


def _rests() -> list[Shape]:
    """Floors, equilibrium lines and a ruler from each mass's own zero."""
    foot = FLOORS[1]
    shapes = [line(WALL * W, FLOORS[0], 0.56 * W, FLOORS[0], tint="rule", style="hair"), line(WALL * W, foot, W, foot, style="floor")]
    for i, top in ((1, FLOORS[0] - side(1) - 20), (2, foot - side(1) - 20)):
        zero, tint = REST[i - 1] * W, f"m{i}"
        shapes.append(line(zero, top, zero, foot, tint="mute", style="eq"))
        for x, label in ((zero, "0"), (zero + var("tick") * W, "{tick}")):
            shapes += [line(x, foot, x, foot + 5, style="floor"), text(x + (0 if x is zero else 12 * var("narrow")), foot + 18, label, tint=tint, style="t0")]
    return shapes


def _place(i: int, signal: str) -> Number:
    return REST[i - 1] * W + var("metre") * W * var(signal)


def _hook(floor: Number) -> Number:
    return floor - 0.058 * H


def _alone() -> list[Shape]:
    x, floor = _place(1, "x_alone"), FLOORS[0]
    top, middle = floor - side(1), floor - 0.5 * side(1)
    return [
        spring(WALL * W, _hook(floor), x - 0.5 * side(1), _hook(floor), 1.75, height=11, style="faint"),
        block(x, floor, side(1), tint="m1", style="ghost"),
        arrow(x, middle, x + var("push") * W * var("drive"), middle, tint="F", style="thick", head=16),
        circle(x, middle, 5, tint="F"),
        *_displacement(1, "x_alone", top - 13, top),
    ]


def _displacement(i: int, signal: str, lift: Number, top: Number) -> list[Shape]:
    """The arrow from equilibrium to the mass, and its number beside the equilibrium line, where nothing moves."""
    zero, x, tint = REST[i - 1] * W, _place(i, signal), f"m{i}"
    aside = {"anchor": "end"} if i == 1 else {"anchor": "start"}
    words = f"*x*_{i} = {{{signal}}} {{x_unit}}"
    return [
        line(x, top, x, lift, tint="mute", style="eq"),
        arrow(zero, lift, x, lift, tint=tint),
        text(zero + (-8 if i == 1 else 8), lift - 10 if i == 2 else lift + 5, words, tint=tint, style="t2 b halo", **aside),
    ]


def _both() -> list[Shape]:
    foot, x1, x2 = FLOORS[1], _place(1, "x1"), _place(2, "x2")
    lift = foot - side(1) - 13
    return [
        spring(WALL * W, _hook(foot), x1 - 0.5 * side(1), _hook(foot), var("wire1"), height=11),
        spring(x1 + 0.5 * side(1), _hook(foot), x2 - 0.5 * side(2), _hook(foot), var("wire2"), height=11, show="wire2"),
        block(x1, foot, side(1), "m_1", tint="m1", corner=1),
        block(x2, foot, side(2), "m_2", tint="m2"),
        *_displacement(1, "x1", lift, foot - side(1)),
        *_displacement(2, "x2", lift, foot - side(2)),
    ]


def _forces() -> list[Shape]:
    """The drive and the pull of spring 2 start at one point of the machine: equally long, they are the explanation."""
    x, y = _place(1, "x1"), FLOORS[1] - 0.5 * side(1) - 4
    return [
        arrow(x, y, x + var("push") * W * var("drive"), y, tint="F", style="thick", head=16),
        arrow(x, y, x + var("push") * W * var("pull"), y, tint="k", style="thick", head=16),
        circle(x, y, 5),
        text(var("tag_left") * W, y + 5, "{link}: {pull_now} {F_unit}", "end", tint="k", style="t1 b halo", show="wide"),
        text(var("tag_right") * W, y + 5, "*F* = {drive_now} {F_unit}", "start", tint="F", style="t1 b halo", show="wide"),
    ]


def sentences() -> list[str | dict[str, str]]:
    undamped = r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D} = \val{Xp1}}$ [m1|{x_unit}]"
    return [
        {
            "form": "first",
            "undamped": undamped,
            "damped": r"$\tint{m1}{|X_1| = \dfrac{|\kappa - m_2 \omega^2| F_0}{|D|} = \val{swing}}$ [m1|{x_unit}]",
            "none": r"$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$",
        },
        {
            "form": "second",
            "still": r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = -\dfrac{F_0}{k_2} = \val{Xp2}}$ [m2|{x_unit}]",
            "undamped": r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = \val{Xp2}}$ [m2|{x_unit}]",
            "damped": r"$\tint{m2}{|X_2| = \dfrac{|\kappa| F_0}{|D|} = \val{stroke}}$ [m2|{x_unit}]",
        },
        {
            "form": "why",
            "still": r"$k_2 = m_2 \omega^2$: then spring 2 pulls exactly as hard as the drive pushes, and nothing is left to move the machine.",
            "less": r"$k_2 \ne m_2 \omega^2$: spring 2 pulls with {pull} {F_unit} at the most, the drive pushes with {push}. What is left moves the machine.",
            "more": r"Here the absorber does harm: alone the machine swings {alone} {x_unit}, with it {swing} {x_unit}. A resonance is too near.",
            "grow": "The drive meets a natural frequency: no steady swing exists. From rest the motion grows like the time.",
            "detached": "Nothing pulls back: the machine takes the whole drive.",
            "damped": r"$\kappa = k_2 + i c \omega$ takes the place of $k_2$: both peaks fall, the valley fills. $P$ and $Q$ are the same for every $c$; at Den Hartog's optimum they are the peaks, {height} {x_unit} high.",
        },
    ]


VERDICTS = {
    "still": "Tuned, it stands still",
    "less": "With it, it shakes less",
    "more": "With it, it shakes more",
    "grow": "At a resonance, it grows",
    "detached": "Detached, it shakes",
}


def _verdicts() -> list[Shape]:
    above, below = FLOORS[0] - 0.5 * side(1) + 6, FLOORS[1] - 0.5 * side(1) + 1
    # On a phone there is no room beside the masses: over the upper one, and under the floor.
    above, below = above - var("narrow") * (0.5 * side(1) + 13), below + var("narrow") * (0.5 * side(1) + 38)
    shapes = [
        text(W, above, "Alone, the machine shakes", "end", style="verdict b halo", show="alone_steady"),
        text(W, above, "Alone, it shakes without end", "end", style="verdict b halo", show="alone_grows"),
    ]
    return shapes + [
        text(W, below, words, "end", style="verdict b halo", show=f"is_{name}") for name, words in VERDICTS.items()
    ]


MARKS = (("slow", r"$\omega_-$ {slow}"), ("F", r"$\omega$ {omega}"), ("fast", r"$\omega_+$ {fast}"))


def swing_plot() -> Block:
    """The machine's swing with the absorber and alone; grey is the swing saved where it helps."""
    return plot(
        "swing",
        x="w",
        y="X1",
        title="Swing of the machine against drive frequency, with the absorber and alone",
        source="sweep",
        x_column="w",
        bands=(Band(low="helped_lo", high="helped_hi", source="helped", tint="k2fill", group="helped"),),
        curves=(
            Curve(name="alone", source="sweep", tint="m1", width="dash"),
            Curve(name="free", source="compare", tint="m1", width="dots"),
            Curve(name="swing", source="sweep", tint="m1", width="sum"),
        ),
        heading=(
            phrase("swing", "sum", "m1", words="machine, with the absorber"),
            phrase("alone", "dash", "m1", words="alone"),
            phrase("free", "dots", "m1", undamped="undamped"),
            phrase("helped", "band", "k2fill", band="helped from {help_low} to {help_high}", above="helped above {help_low}", never="helped nowhere"),
        ),
        x_labels=False,
        margin=(52, 8),
        top=42,
        marks=tuple({"at": at, "tint": tint, "html": html, "lift": 35} for at, tint, html in _mark_facts()),
        grow=160,
        phone=10,
        height=200,
    )


def stroke_plot() -> Block:
    """The absorber's stroke, and the knob that drags the valley under the machine's speed."""
    return plot(
        "stroke",
        x="w",
        y="X2",
        title="Stroke of the absorber against drive frequency",
        source="sweep",
        x_column="w",
        curves=(
            Curve(name="stroke", source="sweep", tint="m2", width="sum"),
            Curve(name="free2", source="compare", tint="m2", width="dots", group="free"),
        ),
        heading=(phrase("stroke", "sum", "m2", words="stroke of the absorber"),),
        margin=(52, 8),
        marks=tuple({"at": at, "tint": tint} for at, tint, _ in _mark_facts()),
        handles=(
            {
                "parameter": "_valley",
                "symbol": "√(k₂/m₂)",
                "label": "Frequency to which the absorber is tuned",
                "tint": "m2",
            },
        ),
        grow=92,
        phone=11,
        height=150,
    )


def _mark_facts() -> list[tuple[str, str, str]]:
    return [(tint if tint != "F" else "omega", tint, rich(words)) for tint, words in MARKS]


def goals() -> Block:
    """Three goals, each at the end of its own limit: a dotted line runs from the plot to its mark and its sentence."""
    shapes = [*_bracket(), *_readings(), *_joints()]
    for i, desk in enumerate(_limits()):
        y = var("wide") * desk + var("narrow") * (18 + 46 * i)
        begin = on_x("swing", var("away_high")) + 6 if i == 0 else var("swing.left")
        shapes.append(line(begin, desk, -6, desk, style="dotted", show="wide"))
        shapes += [circle(9, y, 8, show=f"met{i}"), path(TICK, 9, y, style="counter", show=f"met{i}")]
        shapes += [circle(9, y, 8, style="hollow", show=f"open{i}"), path(CROSS, 9, y, show=f"open{i}")]
        shapes.append(text(26, y + 5, f"{{goal{i}}}", "start", style="t2 b"))
        shapes.append(text(26, y + 23, f"{{found{i}}}", "start", tint="mute", style="t0"))
    return {**stage(*shapes, label="The goals, met or not", grow=0, basis=286, phone=12, height=150), "style": "still"}


def _limits() -> tuple[Number, Number, Number]:
    return var("swing.top") - 6, on_y("swing", var("limit1")), on_y("stroke", var("limit2"))


def _bracket() -> list[Shape]:
    """Where no resonance should be: around the machine's speed."""
    y = _limits()[0]
    low, high = on_x("swing", var("away_low")), on_x("swing", var("away_high"))
    return [line(low, y, high, y), *(line(x, y - 5, x, y + 5) for x in (low, high))]


def _readings() -> list[Shape]:
    """The numbers at the machine's speed, and the names of the fixed points."""
    here, own, aside = (on_x("swing", var(name)) for name in ("omega", "own", "aside"))
    alone, swing, stroke = on_y("swing", var("alone")), on_y("swing", var("swing")), on_y("stroke", var("stroke"))
    return [
        circle(here, alone, 6, tint="m1", style="hollow", show="alone_seen"),
        circle(here, swing, 7, tint="m1", show="swing_seen"),
        circle(here, stroke, 7, tint="m2", show="stroke_seen"),
        text(own + 46, var("swing.top") + 15, "alone", tint="m1", style="t1 b halo", show="own_seen"),
        text(aside, on_y("swing", var("aside1")) - 14, "|*X*_{p1}|", tint="m1", style="t2 b"),
        text(aside, on_y("stroke", var("aside2")) - 14, "|*X*_{p2}|", tint="m2", style="t2 b"),
        text(here - 11, alone + 5, "{alone}", "end", tint="m1", style="t1 b halo", show="alone_seen"),
        text(here + 11, swing - 9, "{swing}", "start", tint="m1", style="t1 b halo", show="swing_seen"),
        text(here + 11, stroke - 8, "{stroke}", "start", tint="m2", style="t1 b halo", show="stroke_seen"),
        text(on_x("swing", var("help_x")), on_y("swing", var("help_y")) + 5, "helped", style="t0", show="help_seen"),
        *(circle(on_x("swing", var(f"{name}_x")), on_y("swing", var(f"{name}_y")), 4, show="fixed_seen") for name in ("P", "Q")),
        *(
            text(on_x("swing", var(f"{name}_x")), on_y("swing", var(f"{name}_y")) - 11, f"*{name}*", style="t1 b halo", show="fixed_seen")
            for name in ("P", "Q")
        ),
    ]


def _joints() -> list[Shape]:
    """The lines of the frequencies go on between the two plots."""
    shapes = []
    for at, tint, _ in _mark_facts():
        x = on_x("swing", var(at))
        shapes.append(line(x, var("swing.bottom"), x, var("stroke.top"), tint=tint, show=f"{at}_seen"))
    return shapes


"""The absorber's stage and plots: one instant twice, two response curves, goals at the end of their limits."""

from __future__ import annotations

from msgspec.structs import replace

from components.chain.grabs import VELOCITIES
from components.language.blocks import Block
from components.language.numbers import Number, var
from components.language.plots import Handle, Mark
from components.language.shapes import Begin, Grab
from components.layout.grabs import begin, grab, linear, on_plot
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import phrase, stage
from components.layout.stage import H, Shape, W, arrow, box, circle, line, on_x, on_y, spring, text, wall
from components.quantities.axes import Axis, nice_axis, nice_ticks
from components.scenes.absorber.goals import frequencies
from components.scenes.absorber.numbers import Numbers as N
from components.scenes.absorber.wording import HELPED, VERDICTS

WALL, REST = 0.024, (0.36, 0.687)
"""Where the wall and the masses at rest stand, as fractions of the stage's width."""
FLOORS = (0.377 * H, 0.86 * H)
TEETH = 190 * var("hook")
"""The height of a spring's teeth in pixels: they stay above the floor."""


def size_axes(swing: float, stroke: float) -> tuple[Axis, Axis]:
    """Axes of amplitudes from 0 to so many metres, both in one unit: millimetres where that is what people say."""
    if 1e-4 <= swing < 1:
        one = Axis(0.0, swing, "mm", -3, ticks=nice_ticks(0.0, 1e3 * swing, 2))
    else:
        one = nice_axis(0.0, swing, "m", exact=True)
    two = replace(one, end=stroke, ticks=nice_ticks(0.0, one.place(stroke), 2))
    return replace(one, drawn=(0.0, swing / 2)), replace(two, drawn=(0.0, stroke / 2))


def side(mass: int) -> Number:
    return var(f"side{mass}") * H


def picture() -> Block:
    """The stage, one instant drawn twice: above, as an outline, the machine alone; below, with the absorber."""
    shapes = [
        wall(WALL * W, 0.02 * H, FLOORS[1] - 0.02 * H + 1),
        *_rests(),
        *_alone(),
        *_both(),
        *_forces(),
        *_verdicts(),
    ]
    label = "The machine alone and with the absorber at the same instant, with the forces on it"
    return stage(*shapes, label=label, height=275)


def _rests() -> list[Shape]:
    """Floors, equilibrium lines and a ruler from each mass's own zero."""
    foot = FLOORS[1]
    shapes = [
        line(WALL * W, FLOORS[0], 0.56 * W, FLOORS[0], tint="rule", style="hair"),
        line(WALL * W, foot, W, foot, style="floor"),
    ]
    for i, top in ((1, FLOORS[0] - side(1) - 20), (2, foot - side(1) - 20)):
        zero, tint = REST[i - 1] * W, f"m{i}"
        shapes.append(line(zero, top, zero, foot, tint="mute", style="eq"))
        # The number of a tick close to 0 is long: its first digit stands under the tick.
        tick = zero + var("tick") * W
        shapes += [line(x, foot, x, foot + 5, style="floor") for x in (zero, tick)]
        shapes += [
            text(zero, foot + 18, "0", tint=tint, style="t0"),
            text(tick - 4, foot + 18, "{tick}", "start", tint=tint, style="t0"),
        ]
    return shapes


def _place(i: int, signal: str) -> Number:
    return REST[i - 1] * W + var("metre") * W * var(signal)


def _hook(floor: Number) -> Number:
    """The height at which the springs are fastened: half the smaller mass at most."""
    return floor - var("hook") * H


def _alone() -> list[Shape]:
    x, floor = _place(1, "x_alone"), FLOORS[0]
    top, middle = floor - side(1), floor - 0.5 * side(1)
    return [
        spring(WALL * W, _hook(floor), x - 0.5 * side(1), _hook(floor), 1.75, height=TEETH, style="faint"),
        box(x, floor, side(1), tint="m1", style="ghost"),
        arrow(x, middle, x + var("push") * W * var("drive"), middle, tint="F", style="thick", head=16),
        circle(x, middle, 5, tint="F"),
        *_displacement(1, "x_alone", top - 13, top),
    ]


def _displacement(i: int, signal: str, lift: Number, top: Number) -> list[Shape]:
    """The arrow from equilibrium to the mass; its number stands where nothing moves."""
    zero, x, tint = REST[i - 1] * W, _place(i, signal), f"m{i}"
    look = {"words": f"*x*_{i} = {{{signal}}} {N.x_unit}", "tint": tint, "style": "t2 b halo"}
    if i == 1:
        names = [text(zero - var("wide") * var(f"lead_{signal}") * W - 8, lift + 5, anchor="end", **look)]
    else:  # the verdict stands on its right where there is room for it
        names = [
            text(zero - 8, lift - 10, anchor="end", show="wide", **look),
            text(zero + 8, lift - 10, anchor="start", show="narrow", **look),
        ]
    return [line(x, top, x, lift, tint="mute", style="eq told"), arrow(zero, lift, x, lift, tint=tint), *names]


def _both() -> list[Shape]:
    foot, x1, x2 = FLOORS[1], _place(1, "x1"), _place(2, "x2")
    lift = foot - side(1) - 13
    return [
        spring(WALL * W, _hook(foot), x1 - 0.5 * side(1), _hook(foot), var("wire1"), height=TEETH),
        spring(
            x1 + 0.5 * side(1),
            _hook(foot),
            x2 - 0.5 * side(2),
            _hook(foot),
            var("wire2"),
            height=TEETH,
            show="wire2",
        ),
        box(x1, foot, side(1), "*m*_1", tint="m1", corner=True, grab=_held(1, "Machine")),
        box(x2, foot, side(2), "*m*_2", tint="m2", grab=_held(2, "Absorber")),
        *_displacement(1, "x1", lift, foot - side(1)),
        *_displacement(2, "x2", lift, foot - side(2)),
    ]


def _held(i: int, name: str) -> Grab:
    """A mass in the hand: from there the motion starts, with its complementary part."""
    return begin(
        f"{name}, start",
        linear(
            lambda x: REST[i - 1] * W + var("metre") * W * x, "x", f"x{i}_0", moves=f"x{i}", axis="X1", rate=f"v{i}_0"
        ),
        start=(Begin("x1_0", "x1", "X1"), Begin("x2_0", "x2", "X1"), *VELOCITIES),
    )


def _driven(plot_: str, readings: dict[str, str]) -> tuple[Shape, ...]:
    """The machine's speed, taken by its points on the curves of a plot."""
    way = on_plot(plot_, "x", "omega", "omega", "w")
    x = on_x(plot_, var("omega"))
    return tuple(
        circle(x, on_y(plot_, var(name)), 0, show="omega_seen", grab=grab(f"Running speed, {of}", way, inside=plot_))
        for name, of in readings.items()
    )


def _forces() -> list[Shape]:
    """The drive and the pull of spring 2 start at one point: equally long, they are the explanation."""
    x, y = _place(1, "x1"), FLOORS[1] - 0.5 * side(1) - 4
    pulls, look = f"{N.link}: {{pull_now}} {N.F_unit}", "t1 b halo"
    drives = f"*F* = {{drive_now}} {N.F_unit}"
    return [
        arrow(x, y, x + var("push") * W * var("drive"), y, tint="F", style="thick", head=16),
        arrow(x, y, x + var("push") * W * var("pull"), y, tint="k", style="thick", head=16),
        circle(x, y, 5),
        text(var("tag_left") * W, y + 5, pulls, "end", tint="k", style=look, show="wide"),
        text(var("tag_right") * W, y + 5, drives, "start", tint="F", style=look, show="wide"),
    ]


def _verdicts() -> list[Shape]:
    # Over whatever mass 2 does; on a phone there is no room: over the upper machine, and beside its floor.
    above, below = FLOORS[0] - 0.5 * side(1) + 6, FLOORS[1] - side(1) - 23
    above = above - var("narrow") * (0.5 * side(1) + 13)
    below = var("wide") * below + var("narrow") * (FLOORS[0] + 4)
    told = "verdict b halo told"
    shapes = [
        text(W, above, "Alone, the machine shakes", "end", style=told, show="alone_shakes"),
        text(W, above, "Alone, it grows without limit", "end", style=told, show="alone_grows"),
        text(W, above, "Alone, it beats, slowly", "end", style=told, show="alone_beats"),
        text(W, above, f"Alone, within {N.rest_alone} {N.x_unit}", "end", style=told, show="alone_within"),
        text(W, above - 19, f"{N.judged_alone}", "end", tint="mute", style="t0 halo", show="wide"),
        text(W, below - 19, f"{N.judged}", "end", tint="mute", style="t0 halo", show="wide differ"),
    ]
    return shapes + [text(W, below, words, "end", style=told, show=f"is_{name}") for name, words in VERDICTS.items()]


KNOB = Handle(
    parameter="_valley",
    symbol="√(k₂/m₂)",
    label="Frequency to which the absorber is tuned",
    tint="m2",
    covering="rad/s",
)


def swing_plot() -> Block:
    """The machine's swing with the absorber and alone; grey is the swing saved where it helps."""
    return plot(
        "swing",
        x="w",
        y="X1",
        title="Swing of the machine against drive frequency, with the absorber and alone",
        x_column="w",
        bands=(region(low="helped_lo", high="helped_hi", source="helped", tint="k2fill", group="helped"),),
        curves=(
            curve("alone", source="sweep", tint="m1", width="dash", read="alone"),
            curve("free", source="compare", tint="m1", width="dots"),
            curve("swing", source="sweep", tint="m1", width="sum", read="with absorber"),
        ),
        heading=(
            phrase("swing", "sum", "m1", words=r"$|X_{\mathrm{p}1}|$ with the absorber"),
            phrase("alone", "dash", "m1", words="alone"),
            phrase("free", "dots", "m1", undamped="undamped"),
            phrase("helped", "band", "k2fill", **HELPED),
        ),
        x_labels=False,
        room=Room(52, 8, top=42),
        handles=(replace(KNOB, bare=True),),
        marks=tuple(Mark(at=at, tint=tint, html=html, lift=35, flag="one") for at, tint, html in frequencies()),
        shapes=_driven("swing", {"swing": "with the absorber", "alone": "alone"}),
        grow=160,
        phone=10,
        height=200,
    )


def stroke_plot() -> Block:
    """The absorber's stroke |X2 - X1|, and the knob that drags the valley under the machine's speed."""
    return plot(
        "stroke",
        x="w",
        y="X2",
        title="Stroke of the absorber against drive frequency",
        x_column="w",
        curves=(
            curve("stroke", source="sweep", tint="m2", width="sum", read="stroke"),
            curve("free2", source="compare", tint="m2", width="dots", group="free"),
        ),
        heading=(phrase("stroke", "sum", "m2", words=r"stroke $|X_{\mathrm{p}2} - X_{\mathrm{p}1}|$"),),
        room=Room(52, 8),
        marks=tuple(Mark(at=at, tint=tint) for at, tint, _ in frequencies()),
        handles=(KNOB,),
        shapes=_driven("stroke", {"stroke": "by the stroke"}),
        grow=92,
        phone=11,
        height=150,
    )

"""The paper of two coupled masses: the chain three times, both displacements, their energies, and the plane."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Literal

import numpy as np
from msgspec.structs import asdict, replace

from components import chain
from components.chain.case import drawing
from components.chain.forces import LENGTH
from components.language.blocks import Block
from components.language.expressions import Number
from components.language.plots import Room
from components.language.shapes import Along, AnyShape, Begin, Grab, Label, Share, Swung
from components.layout.grabs import begin
from components.layout.sheet import choice, column, measured, residuals, row, stage, table
from components.layout.stage import AT_DESK, ON_NARROW, H, W, arrow, circle, line, text
from components.layout.views import in_views
from components.paper.deferred import Axes, computed, deferred, number, recorded
from components.paper.plot_axes import TIME, PlotAxis, axis
from components.paper.plots import (
    EitherText,
    Plot,
    PlotValue,
    along,
    counted,
    curve,
    drag,
    either,
    form_of,
    layer,
    note,
    on_axis,
    path,
    shown_by,
    stack,
    when,
    words,
)
from components.quantities.axes import Axis, nice_axis, whole_axis
from components.quantities.parameters import one_of
from components.scene.frames import USED
from components.scene.traces import Columns
from components.scenes.coupled.case import CoupledShown
from physics.motion import ExactMotion

FEET = (0.56, 0.815, 0.99)
"""Heights of the motion, its slow part and its fast part, as fractions of the stage's height."""
NAMED = 0.8
"""Position of the names in the plane, as a fraction of the distance to its edge."""
ENERGY = one_of("parts", {"parts": "Masses, springs", "modes": "Modes"}, "Energy of")

MODEL = ("motion", "energy", "plane", "forces", "formulas")

c = deferred(CoupledShown)
GIVEN_BY_MODES = form_of(c.given_by == "modes")
X = axis("m", lambda c: c.axis_of_both, "x")
X_1 = axis("m", lambda c: own_axis(c), "x1", like=X)
"""The axis of both masses, unless mass 1 would use less than a quarter of it."""
LEVEL = axis("J", lambda c: whole_axis(c.E_total, "J"), "E")
FORCE = axis("N", lambda c: nice_axis(0.0, c.strongest or 1.0, "N", exact=True), "force")
X1, X2, PLANE = Plot("x1", TIME, X_1), Plot("x2", TIME, X), Plot("plane", X, X)
PARTS, MODES = Plot("energy", TIME, LEVEL), Plot("mode_energy", TIME, LEVEL)
DRAWN = drawing(c, X1)
WHOLE = c.x1, c.x2
SLOW, FAST = (c.x1_slow, c.x2_slow), (c.x1_fast, c.x2_fast)
PARTED = {"slow": SLOW, "fast": FAST}
RATES = {"slow": (c.v1_slow, c.v2_slow), "fast": (c.v1_fast, c.v2_fast)}
TURNS = {"slow": c.turn_slow, "fast": c.turn_fast}
HANDS = {"slow": c.slow_hands, "fast": c.fast_hands}


def paper() -> Block:
    beat = either(
        c.beat,
        both=f"Beat period {c.beat_period}",
        apart="No beat: the two frequencies are too far apart",
        one="No beat: only one mode is seen to move",
        rest="Nothing moves",
        drift="No beat: the slow mode is a drift",
    )
    label = "Two masses and two springs in motion; below, its two modes"
    top = row(
        stage(*shapes(), label=label, height=192),
        in_views(modes(), "motion", "energy", "plane"),
        in_views(forces(), "forces"),
        in_views(constants(), "formulas"),
        grow=226, gap=18,
    )  # fmt: skip
    plots = column(
        *(in_views(plot, "motion", "forces", "formulas", "measured") for plot in displacements()),
        *(in_views(residuals(f"x{i}", f"Mass {i}", 0.6, 12 + i, 110), "measured") for i in chain.BOTH),
        grow=450,
    )
    file = column(measured("file", 6, ["two carts"]), measured("fit", 15), grow=250)
    return column(
        in_views(top, *MODEL),
        column(
            row(plots, in_views(file, "measured"), gap=6, grow=1),
            in_views(when(c.energy == "parts", energies()), "energy"),
            in_views(when(c.energy == "modes", mode_energies()), "energy"),
            in_views(plane(), "plane"),
            in_views(words(beat, style="numbers", phone=15, name="beat"), "motion", "plane"),
            in_views(choice(ENERGY, phone=14), "energy"),
            grow=346,
        ),
    )  # fmt: skip


def modes() -> Block:
    """Return the captions to the right of the stage, one at the height of each row."""
    top, slow, fast = FEET[0], FEET[1] - FEET[0], FEET[2] - FEET[1]
    return column(
        words("**The motion**", style="caption", grow=top, phone=16),
        words(*slow_mode(), style="caption", grow=slow, phone=16),
        words(*fast_mode(), style="caption", grow=fast, phone=16),
        grow=0, basis=254,
    )  # fmt: skip


def slow_mode() -> tuple[EitherText, EitherText]:
    return (
        either(
            c.slow_fact,
            sine="[slow|= slow mode]",
            drift="[slow|= drift, off the wall]",
            free="[slow|= drift of mass 2]",
            two="[slow|= drift: no springs]",
        ),
        either(
            c.slow_omega,
            sine=rf"$\omega_{{-}} = {c.omega_minus}$ rad/s, $X_2 / X_1 = {c.ratio_minus}$",
            drift=rf"$\omega_{{-}} = 0$: $x = a + b\,t$, $X_2 / X_1 = {c.ratio_minus}$",
            two=r"$\omega_- = \omega_+ = 0$: $x = a + b\,t$, each mass on its own",
        ),
    )


def fast_mode() -> tuple[EitherText, EitherText]:
    omega = rf"$\omega_{{+}} = {c.omega_plus}$ rad/s, $X_2 / X_1 = {c.ratio_plus}$"
    return either(c.fast_fact, sine="[fast|+ fast mode]"), either(c.fast_fact, sine=omega)


def constants() -> Block:
    """Conversion of the initial displacements and velocities to the amplitudes and phases of both modes."""
    paragraphs = (
        "**Four constants, four starting values**",
        either(
            c.constants,
            shapes=r"$X_{1j} \sin \phi_j = \dfrac{m_1 x_1 + m_2 r_j x_2}{M_j}$",
            loose="Without spring 2 each mass has two of its own.",
        ),
        either(c.constants, shapes=r"$\omega_j X_{1j} \cos \phi_j = \dfrac{m_1 v_1 + m_2 r_j v_2}{M_j}$"),
        either(c.constants, shapes=r"$r_j = (X_2/X_1)_j, \quad M_j = m_1 + m_2 r_j^2$"),
        either(c.slow_fact, drift=r"In the drift they are $a_1$ and $b_1$: no $X$, no $\phi$."),
    )
    rows = (
        ["$M$", f"{c.M_minus}", f"{c.M_plus}", "kg"],
        [r"$X_1 \sin \phi$", f"{c.q_minus}", f"{c.q_plus}", "m"],
        [r"$\omega X_1 \cos \phi$", f"{c.rate_minus}", f"{c.rate_plus}", "m/s"],
    )
    return column(
        words(*paragraphs, style="constants", phone=16, name="formulas"),
        table(*rows, head=["", "[slow|slow]", "[fast|fast]", ""], style="tight", phone=17),
        grow=0, basis=254,
    )  # fmt: skip


def forces() -> Block:
    return words(
        "**Forces on both masses**",
        r"$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)}$",
        f"$F_1 =$ {counted(c.F1, FORCE):+} {FORCE.unit_text}",
        r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
        f"$F_2 =$ {counted(c.F2, FORCE):+} {FORCE.unit_text}",
        "[small|That $T + V$ stays constant is one equation: two masses need two.]",
        style="facts", grow=0, basis=254, phone=15, name="forces",
    )  # fmt: skip


def own_axis(case: CoupledShown) -> Axis:
    """The axis of both masses, or of mass 1 alone if it would use less than a quarter of the other axis."""
    own, both = nice_axis(*case.extremes["x1"], "m", 3), case.axis_of_both
    return own if own.end - own.start < USED * (both.end - both.start) else both


def place(mass: int, x: PlotValue) -> Number:
    """The pixel of a displaced mass."""
    return DRAWN.place(mass, on_axis(X, x))


def shapes() -> list[AnyShape]:
    """The motion, and under it the same chain twice more: its slow part and its fast part alone."""
    foot, slow_foot, fast_foot = (at * H for at in FEET)
    found = [chain.standing_wall(0.17 * H, 0.83 * H)]
    for i in chain.BOTH:
        found.append(line(chain.rest(i), foot, chain.rest(i), fast_foot, tint="mute", style="eq"))
        words_ = f"{WHOLE[i - 1]:+} {X.unit_text}"
        found += DRAWN.displacement_arrow(i, foot, place(i, WHOLE[i - 1]), words_)
    for mode, base, parts in (("slow", slow_foot, SLOW), ("fast", fast_foot, FAST)):
        found.append(line(chain.WALL * W, base, W, base, tint="rule", style="hair"))
        places = [place(i, part) for i, part in zip(chain.BOTH, parts, strict=True)]
        found += DRAWN.masses(base, *places, small=True)
        above = base - 0.056 * chain.BODY  # a mass can pass under it
        found.append(text(W, above, f"{mode} part", "end", tint=mode, style="t0 halo", show=ON_NARROW))
        for i, at in zip(chain.BOTH, places, strict=True):
            low = base - 0.026 * chain.BODY
            found += [arrow(chain.rest(i), low, at, low, tint=mode), *mode_hands(mode, i, at, base)]
    # Put the numbers of a row above it, because the row below may come close. With the large type of hall mode there is
    # no room between rows, so they are shown only at a desk.
    found += [replace(one, show=(AT_DESK.name,)) if isinstance(one, Label) else one for one in DRAWN.ground(foot)]
    grabs = hand("Mass 1, start", 1), hand("Mass 2, start", 2)
    found += DRAWN.masses(foot, place(1, c.x1), place(2, c.x2), grabs=grabs)
    return found + arrows(foot)


def arrows(foot: Number) -> list[AnyShape]:
    """The forces on both masses in ink, from the upper part of each."""
    found: list[AnyShape] = []
    for i, F in zip(chain.BOTH, (c.F1, c.F2), strict=True):
        x, y = place(i, WHOLE[i - 1]), foot - 0.78 * DRAWN.side(i)
        tip = x + computed(c, "newton", _newton) * W * on_axis(FORCE, F)
        found += [arrow(x, y, tip, y, style="thick", head=18), text(tip, y - 20, f"*F*_{i}", style="t3 b halo")]
    return found


def _newton(case: CoupledShown, axes: Axes) -> float:
    """The length of one unit of the force axis, as a share of the stage's width."""
    return LENGTH / axes[FORCE.name].place(axes[FORCE.name].end)


def hand(label: str, *masses: int) -> Grab:
    """Return the grab that moves these masses along the floor. Both masses start at their current positions, at
    rest."""
    ways = (
        along_floor(1, "x1_0", c.x1, "v1_0"),
        along_floor(2, "x2_0", c.x2, "v2_0"),
    )
    return replace(drag(label, *ways), ways=tuple(ways[i - 1] for i in masses))


def along_floor(mass: int, parameter: str, x: ExactMotion, rate: str = "") -> Along:
    """Return the rule for dragging a mass along the floor."""
    sets: dict[str, Any] = {parameter: x}
    return along("x", partial(place, mass), X, rate=rate, **sets)


def plane_hand() -> Grab:
    ways = along("x", PLANE.x, X, x1_0=c.x1), along("y", PLANE.y, X, x2_0=c.x2)
    return replace(hand("Both masses, start"), ways=ways)


def mode_hands(mode: str, mass: int, at: Number, base: Number) -> list[AnyShape]:
    """The grabs of a mass in one mode only: by its initial conditions, or by the mode's amplitude and phase."""
    held, y = HANDS[mode][mass - 1], base - 0.21 * DRAWN.side(mass)
    by_values, by_modes = (circle(at, y, 0, grab=grab(mode, mass)) for grab in (mode_hand, swing_hand))
    shown = shown_by(c.given_by == "values", by_values), shown_by(c.given_by == "modes", by_modes)
    return [one for shapes in shown for one in shown_by(held.amplitude, *shapes)]


def mode_hand(mode: str, mass: int) -> Grab:
    """Return the grab that sets the part of a mode in the initial conditions; the other mode continues unchanged."""
    ways, start = list[Share](), list[Begin]()
    rests = zip(PARTED[other(mode)], RATES[other(mode)], strict=True)
    for i, x, part, (rest, rate) in zip(chain.BOTH, WHOLE, PARTED[mode], rests, strict=True):
        way = along_floor(mass, f"x{i}_0", part, rate=f"v{i}_0")
        ways.append(Share(**asdict(way), share=portion(mode, mass, i), rest=called(rest, X)))
        start += [Begin(way.parameter, called(x, X), X.name, exactly=True), Begin(way.rate, called(rate), exactly=True)]
    return begin(hand_label(mode, mass), *ways, start=tuple(start))


def swing_hand(mode: str, mass: int) -> Grab:
    """Return the grab that sets the amplitude and the phase of a mode."""
    ways = list[Swung]()
    of: tuple[tuple[Literal["amplitude", "phase"], str], ...] = (("amplitude", f"X_{mode}"), ("phase", f"phi_{mode}"))
    for i, (kind, parameter) in enumerate(of, start=1):
        way = along_floor(mass, parameter, PARTED[mode][i - 1])
        counted_by, turn = number(HANDS[mode][mass - 1].amplitude), called(TURNS[mode])
        ways.append(Swung(**asdict(way), of=kind, counted=counted_by, share=portion(mode, mass, i), turn=turn))
    going = Begin(f"phi_{other(mode)}", called(TURNS[other(mode)]), exactly=True, angle=True)
    return begin(hand_label(mode, mass), *ways, start=(going,))


def portion(mode: str, mass: int, i: int) -> Number:
    """The displacement of mass i, relative to the dragged mass's."""
    return 1.0 if i == mass else number(HANDS[mode][mass - 1].other)


def called(of: object, on: PlotAxis | None = None) -> str:
    """Return the name of a number on an axis."""
    own = recorded(of)
    return own.book.number(own, on)


def other(mode: str) -> str:
    return "fast" if mode == "slow" else "slow"


def hand_label(mode: str, mass: int) -> str:
    return f"{mode.capitalize()} mode, start, by mass {mass}"


def displacements() -> Iterator[Block]:
    """x_1(t) and x_2(t), each with its slow and its fast part, under the formula that is their legend and switch."""
    sizes = (c.X1_minus, c.X1_plus, c.a1, c.b1), (c.X2_minus, c.X2_plus, c.a2, c.b2)
    every = zip(chain.BOTH, (X1, X2), SLOW, FAST, sizes, strict=True)
    for i, plot, slow_part, fast_part, (X_minus, X_plus, a, b) in every:
        slow = rf"{X_minus}\,\sin({c.omega_minus}\,t\; {c.phi_minus:+})"
        fast = rf"{X_plus:+}\,\sin({c.omega_plus}\,t\; {c.phi_plus:+})"
        slow_legend = either(c.slow_term, words=r"\text{slow part}", sine=slow, drift=rf"{a}\; {b:+}\,t")
        fast_legend = either(c.fast_term, words=r"+\; \text{fast part}", sine=fast)
        yield plot.block(
            curve(WHOLE[i - 1], "sum", f"m{i}", words=f"mass {i}: $x_{i} =$", label=f"*x*_{i}", fast="band", dot=True),
            curve(slow_part, tint="slow", legend=slow_legend, read="slow", fast="band", dot=True),
            curve(fast_part, "dash", "fast", legend=fast_legend, read="fast", fast="band", dot=True),
            title=f"Displacement of mass {i} against time, with its slow and its fast part",
            x_labels=i == 2, phone=10 + i, height=112 if i == 1 else 142,
        )  # fmt: skip


def energies() -> Block:
    """T and V of each mass and spring, stacked. The sum is constant; T1 is the lowest layer, T2 the highest."""
    return PARTS.block(
        note(rf"$T + V = {PARTS.text(c.E_total)} =$"),
        *stack(
            layer(c.T1, "m1", legend=f"T_1 = {c.T1} +", read="*T*_1", switch=False),
            layer(c.V1, "k1fill", legend=f"V_1 = {c.V1} +", read="*V*_1", switch=False),
            layer(c.V2, "k2fill", legend=f"V_2 = {c.V2} +", read="*V*_2", switch=False),
            layer(c.T2, "m2", legend=f"T_2 = {c.T2}", read="*T*_2", switch=False),
        ),
        note(f"${PARTS.unit}$"),
        title="Kinetic and potential energy of each mass and spring, stacked to their constant sum",
        phone=10, height=240,
    )  # fmt: skip


def mode_energies() -> Block:
    """The energies of the two modes: two flat lines."""
    return MODES.block(
        note(rf"$T + V = {PARTS.text(c.E_total)} =$"),
        curve(c.total, "sum", "ink", label="*E*"),
        curve(c.E_slow, tint="slow", label="slow", legend=PARTS.text(c.E_minus)),
        curve(c.E_fast, "dash", "fast", label="fast", legend=rf"+\; {PARTS.text(c.E_plus)}"),
        note(rf"${PARTS.unit}\text{{: each mode keeps its own}}$"),
        title="Energy of the slow mode and of the fast mode: both constant",
        phone=10, height=240,
    )  # fmt: skip


def plane() -> Block:
    """The motion in the (x1, x2) plane: along the direction of the slow mode, then along the fast mode's."""
    zero, lines = (PLANE.x(0), PLANE.y(0)), PLANE.in_frame(c, "modes", _lines)
    slow, here = (PLANE.x(c.x1_slow), PLANE.y(c.x2_slow)), (PLANE.x(c.x1), PLANE.y(c.x2))
    return PLANE.block(
        path(c.x2, against=c.x1),
        curve(lines, "dash", "fast", columns=("fast1", "fast2")),
        curve(lines, tint="slow", columns=("slow1", "slow2")),
        title="Displacement of mass 2 against that of mass 1, with the directions of the two modes",
        over=(
            arrow(*zero, *slow, tint="slow"),
            arrow(*slow, *here, tint="fast"),
            circle(*here, 5, grab=plane_hand()),
            *(direction(j, mode) for j, mode in enumerate(chain.MODES)),
            text(PLANE.right - 4, zero[1] - 8, "*x*_1", anchor="end", tint="m1", style="t2 b"),
            text(zero[0] - 8, PLANE.top + 12, "*x*_2", anchor="end", tint="m2", style="t2 b"),
        ),
        room=Room(8, 8), square=True, plain=True, phone=10, height=300,
    )  # fmt: skip


def direction(j: int, mode: str) -> AnyShape:
    """The name of a mode next to its direction: of the slow one at its upper end, of the fast one at its lower end."""

    def at(i: int) -> Callable[[CoupledShown, Axis, Axis], float]:
        return lambda c, x, y: NAMED * min(-x.start, x.end) * chain.directions(c.chain)[j][i]

    x, y = PLANE.in_frame(c, f"{mode}_name1", at(0)), PLANE.in_frame(c, f"{mode}_name2", at(1))
    return text(PLANE.x(x) - 8, PLANE.y(y) + 4, mode, "end", tint=mode, style="t1 b halo")


def _lines(case: CoupledShown, x: Axis, y: Axis) -> Columns:
    """The directions of both modes, far beyond the frame."""
    ends = 4 * max(abs(x.start), abs(x.end)) * np.array([-1.0, 1.0])
    ways = zip(chain.MODES, chain.directions(case.chain), strict=True)
    return {f"{mode}{i}": part * ends for mode, way in ways for i, part in zip(chain.BOTH, way, strict=True)}

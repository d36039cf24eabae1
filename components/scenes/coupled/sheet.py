"""The paper of the coupled masses: the chain three times, both displacements, their energies, and the plane."""

from __future__ import annotations

from components import chain
from components.chain.forces import arrows
from components.chain.grabs import mass_grab, mode_grab, plane_grab, swing_grab
from components.language.blocks import Block
from components.language.numbers import var
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import choice, column, desk, either, row, stage, table, term, when, words
from components.layout.stage import H, PlotFrame, Shape, W, arrow, circle, line, on_x, on_y, shown_by, text
from components.scene.traces import traced
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.words import CONSTANTS, CONSTANTS_TABLE, FORCES, TASK, captions

FEET = (0.56, 0.815, 0.99)
"""Where the motion, its slow part and its fast part stand, as fractions of the stage's height."""
PLANE = PlotFrame("plane")
BEAT = either(
    "beat",
    both=f"Beat period {N.beat_period}",
    apart="No beat: the two frequencies are too far apart",
    one="No beat: only one mode is seen to move",
    rest="Nothing moves",
    drift="No beat: the slow mode is a drift",
)


def coupled_sheet() -> Block:
    """The paper of the scene."""
    return column(
        desk(words(TASK, style="task", phone=0)),
        row(
            stage(*_shapes(), label="Two masses and two springs in motion; below, its two modes", height=215),
            _facts(),
            grow=230,
            gap=18,
        ),
        row(
            column(_displacements(1), _displacements(2), _part_energies(), _mode_energies()),
            column(
                words("**Mass 2 against mass 1**", style="plain", phone=15),
                _plane(),
                words(BEAT, style="numbers", phone=17),
                desk(choice("energy", {"parts": "Masses, springs", "modes": "Modes"}, "Energy of", phone=14)),
                basis=254,
                grow=0,
            ),
            grow=346,
            gap=18,
        ),
    )


def _facts() -> Block:
    """Right of the stage: a caption at the height of each of its rows, or the constants, or the forces."""
    heights = zip(chain.MODES, (FEET[1] - FEET[0], FEET[2] - FEET[1]), strict=True)
    rows = [words(*captions(mode), style="caption", grow=grow, phone=4) for mode, grow in heights]
    return column(
        when("view_modes", column(words("**The motion**", style="caption", grow=FEET[0], phone=4), *rows)),
        when(
            "view_constants",
            column(
                words(*CONSTANTS, style="constants", phone=4),
                table(*CONSTANTS_TABLE, head=["", "[slow|slow]", "[fast|fast]", ""], style="tight", phone=4),
            ),
        ),
        when("view_forces", words(*FORCES, style="facts", grow=1, phone=4)),
        grow=0,
        basis=254,
    )


def _shapes() -> list[Shape]:
    """The motion, and under it the same chain twice more: its slow part and its fast part alone."""
    foot, slow_foot, fast_foot = (share * H for share in FEET)
    shapes = [chain.standing_wall(0.17 * H, 0.83 * H)]
    for mass_ in (1, 2):
        shapes.append(line(chain.rest(mass_), foot, chain.rest(mass_), fast_foot, tint="mute", style="eq"))
        shapes += chain.displacement_arrow(mass_, foot)
    for mode, base in (("slow", slow_foot), ("fast", fast_foot)):
        shapes.append(line(chain.WALL * W, base, W, base, tint="rule", style="hair"))
        places = [chain.place(i, f"x{i}_{mode}") for i in (1, 2)]
        shapes += chain.masses(base, *places, small=True)
        for i, place in zip((1, 2), places, strict=True):
            shapes.append(arrow(chain.rest(i), base - 0.026 * chain.BODY, place, base - 0.026 * chain.BODY, tint=mode))
            for given_by, grab in (("values", mode_grab(mode, i)), ("modes", swing_grab(mode, i))):
                held = circle(place, base - 0.21 * chain.side(i), 0, grab=grab)
                shapes += shown_by(f"{mode}_by_{i} by_{given_by}", held)
    shapes += chain.ground(foot)  # its numbers over the parts, which may pass close below
    shapes += chain.masses(foot, chain.place(1, "x1"), chain.place(2, "x2"), grabs=(mass_grab(1), mass_grab(2)))
    return shapes + arrows(foot)


def _displacements(i: int) -> Block:
    """x_i(t), its slow part and its fast part, under the formula that is their legend and switch."""
    traces = (
        traced(f"x{i}_slow", tint="slow", read="slow", signal=f"x{i}_slow"),
        traced(f"x{i}_fast", tint="fast", width="dash", read="fast", signal=f"x{i}_fast"),
        traced(f"x{i}", tint=f"m{i}", width="sum", label=f"*x*_{i}", signal=f"x{i}"),
    )
    return plot(
        f"x{i}",
        x="t",
        y="x",
        title=f"Displacement of mass {i} against time, with its slow and its fast part",
        curves=tuple(curve for curve, _ in traces),
        bands=tuple(band for _, band in traces),
        heading=(
            term(f"x{i}", "sum", f"m{i}", formula=f"x_{i} ="),
            term(
                f"x{i}_slow",
                "line",
                "slow",
                sine=rf"{N.X_slow[i - 1]}\,\sin({N.omega_minus}\,t\; {N.phi_minus})",
                drift=rf"{N.a[i - 1]}\; {N.b[i - 1]}\,t",
            ),
            term(f"x{i}_fast", "dash", "fast", sine=rf"{N.X_fast[i - 1]}\,\sin({N.omega_plus}\,t\; {N.phi_plus})"),
        ),
        x_labels=False,
        cursor="time",
        phone=10 + i,
        height=118,
    )


STACK = (
    ("e0", "e1", "T1", "m1", "*T*_1"),
    ("e1", "e2", "V1", "k1fill", "*V*_1"),
    ("e2", "e3", "V2", "k2fill", "*V*_2"),
    ("e3", "e4", "T2", "m2", "*T*_2"),
)


def _part_energies() -> Block:
    """T and V of each mass and spring, stacked to a flat top: T1 from the floor, T2 from the ceiling."""
    return plot(
        "energy",
        x="t",
        y="E",
        title="Kinetic and potential energy of each mass and spring, stacked to their constant sum",
        bands=tuple(region(low=low, high=high, tint=tint, read=label) for low, high, _, tint, label in STACK),
        heading=(
            term("", "none", "ink", formula=f"T + V = {N.E_total} ="),
            *(
                term("", "band", tint, formula=rf"{name[0]}_{name[1]} = \val{{{name}}}{' +' if name != 'T2' else ''}")
                for _, _, name, tint, _ in STACK
            ),
            term("", "none", "ink", formula=str(N.E_unit)),
        ),
        cursor="time",
        phone=13,
        height=130,
        form="parts",
    )


def _mode_energies() -> Block:
    """The energies of the two modes: two flat lines."""
    return plot(
        "mode_energy",
        x="t",
        y="E",
        title="Energy of the slow mode and of the fast mode: both constant",
        curves=(
            curve("E_slow", tint="slow", label="slow"),
            curve("E_fast", tint="fast", width="dash", label="fast"),
            curve("E_total", tint="ink", width="sum", label="*E*"),
        ),
        heading=(
            term("", "none", "ink", formula=f"T + V = {N.E_total} ="),
            term("E_slow", "line", "slow", formula=str(N.E_minus)),
            term("E_fast", "dash", "fast", formula=rf"+\; {N.E_plus}"),
            term("", "none", "ink", formula=rf"{N.E_unit}\text{{: each mode keeps its own}}"),
        ),
        cursor="time",
        phone=13,
        height=130,
        form="modes",
    )


def _plane() -> Block:
    """The motion in the (x1, x2) plane: along the direction of the slow mode, then along that of the fast one."""
    zero = on_x("plane", 0), on_y("plane", 0)
    slow = on_x("plane", var("x1_slow")), on_y("plane", var("x2_slow"))
    here = on_x("plane", var("x1")), on_y("plane", var("x2"))
    return plot(
        "plane",
        x="x",
        y="x",
        title="Displacement of mass 2 against that of mass 1, with the directions of the two modes",
        x_column="x1",
        curves=(
            curve("slow2", source="modes", x="slow1", tint="slow"),
            curve("fast2", source="modes", x="fast1", tint="fast", width="dash"),
            curve("x2", x="x1", tint="ink", signal_x="x1", signal="x2"),
        ),
        shapes=(
            arrow(*zero, *slow, tint="slow"),
            arrow(*slow, *here, tint="fast"),
            circle(*here, 5, grab=plane_grab(PLANE)),
            *(_direction(mode) for mode in chain.MODES),
            text(var("plane.right") - 4, zero[1] - 8, "*x*_1", anchor="end", tint="m1", style="t2 b"),
            text(zero[0] - 8, var("plane.top") + 12, "*x*_2", anchor="end", tint="m2", style="t2 b"),
        ),
        room=Room(8, 8),
        square=True,
        plain=True,
        grow=1,
        phone=16,
        height=300,
    )


def _direction(mode: str) -> Shape:
    """The name of a mode beside its direction."""
    x, y = on_x("plane", var(f"{mode}_name1")), on_y("plane", var(f"{mode}_name2"))
    return text(x - 8, y + 4, mode, "end", tint=mode, style="t1 b halo", show=f"{mode}_name2")

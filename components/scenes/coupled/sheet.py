"""The paper of the coupled masses: the chain three times, both displacements, their energies, and the plane."""

from __future__ import annotations

from functools import cache

from components import chain
from components.chain.forces import arrows
from components.chain.grabs import Shares, mass_grab, mode_grab, plane_grab, swing_grab
from components.language.blocks import Block
from components.language.numbers import var
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import choice, column, desk, either, row, stage, table, term, when, words
from components.layout.stage import H, PlotFrame, Shape, W, arrow, circle, line, shown_by, text
from components.quantities.parameters import one_of
from components.scene.traces import traced
from components.scenes.coupled.curves import BETWEEN, LAYERS, Axes, Places
from components.scenes.coupled.curves import Signals as S
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.starting import GIVEN
from components.scenes.coupled.words import CONSTANTS, CONSTANTS_TABLE, FORCES, TASK, Forms, captions

FEET = (0.56, 0.815, 0.99)
"""Where the motion, its slow part and its fast part stand, as fractions of the stage's height."""
PLANE = PlotFrame("plane")
ENERGY = one_of("parts", {"parts": "Masses, springs", "modes": "Modes"}, "Energy of")
BEAT = either(
    Forms.beat,
    both=f"Beat period {N.beat_period}",
    apart="No beat: the two frequencies are too far apart",
    one="No beat: only one mode is seen to move",
    rest="Nothing moves",
    drift="No beat: the slow mode is a drift",
)


@cache
def coupled_sheet() -> Block:
    """The paper of the scene."""
    return column(
        desk(words(TASK, style="task", phone=0)),
        row(
            stage(*_shapes(), label="Two masses and two springs in motion; below, its two modes", height=215),
            _facts(), grow=230, gap=18,
        ),
        row(
            column(_displacements(1), _displacements(2), _part_energies(), _mode_energies()),
            column(
                words("**Mass 2 against mass 1**", style="plain", phone=15),
                _plane(),
                words(BEAT, style="numbers", phone=17),
                desk(choice(ENERGY, phone=14)),
                basis=254, grow=0,
            ),
            grow=346, gap=18,
        ),
    )  # fmt: skip


def _facts() -> Block:
    """Right of the stage: a caption at the height of each of its rows, or the constants, or the forces."""
    heights = zip(chain.MODES, (FEET[1] - FEET[0], FEET[2] - FEET[1]), strict=True)
    rows = [words(*captions(mode), style="caption", grow=grow, phone=4) for mode, grow in heights]
    numbers = table(*CONSTANTS_TABLE, head=["", "[slow|slow]", "[fast|fast]", ""], style="tight", phone=4)
    return column(
        when(Forms.view["modes"], column(words("**The motion**", style="caption", grow=FEET[0], phone=4), *rows)),
        when(Forms.view["constants"], column(words(*CONSTANTS, style="constants", phone=4), numbers)),
        when(Forms.view["forces"], words(*FORCES, style="facts", grow=1, phone=4)),
        grow=0,
        basis=254,
    )


def _shapes() -> list[Shape]:
    """The motion, and under it the same chain twice more: its slow part and its fast part alone."""
    foot, slow_foot, fast_foot = (share * H for share in FEET)
    shapes = [chain.standing_wall(0.17 * H, 0.83 * H)]
    for i in chain.BOTH:
        shapes.append(line(chain.rest(i), foot, chain.rest(i), fast_foot, tint="mute", style="eq"))
        shapes += chain.displacement_arrow(i, foot)
    for mode, base in zip(chain.MODES, (slow_foot, fast_foot), strict=True):
        shapes.append(line(chain.WALL * W, base, W, base, tint="rule", style="hair"))
        places = [chain.place(i, S.x_part[i, mode]) for i in chain.BOTH]
        shapes += chain.masses(base, *places, small=True)
        for i, place in zip(chain.BOTH, places, strict=True):
            shapes.append(arrow(chain.rest(i), base - 0.026 * chain.BODY, place, base - 0.026 * chain.BODY, tint=mode))
            for given_by, grab in zip(GIVEN, (mode_grab(mode, i), swing_grab(mode, i)), strict=True):
                held = circle(place, base - 0.21 * chain.side(i), 0, grab=grab)
                shapes += shown_by((Shares.by[mode, i], Places.by[given_by]), held)
    shapes += chain.ground(foot)  # its numbers over the parts, which may pass close below
    shapes += chain.masses(foot, chain.place(1), chain.place(2), grabs=(mass_grab(1), mass_grab(2)))
    return shapes + arrows(foot)


def _displacements(i: int) -> Block:
    """x_i(t), its slow part and its fast part, under the formula that is their legend and switch."""
    whole, slow, fast = S.x[i], S.x_part[i, "slow"], S.x_part[i, "fast"]
    traces = (
        traced(slow, tint="slow", read="slow", signal=slow),
        traced(fast, tint="fast", width="dash", read="fast", signal=fast),
        traced(whole, tint=f"m{i}", width="sum", label=f"*x*_{i}", signal=whole),
    )
    return plot(
        PlotFrame(f"x{i}"), x=Axes.t, y=Axes.x,
        title=f"Displacement of mass {i} against time, with its slow and its fast part",
        curves=tuple(curve for curve, _ in traces),
        bands=tuple(band for _, band in traces),
        heading=(
            term(whole, "sum", f"m{i}", formula=f"x_{i} ="),
            term(
                slow, "line", "slow", sine=rf"{N.X_slow[i - 1]}\,\sin({N.omega_minus}\,t\; {N.phi_minus})",
                drift=rf"{N.a[i - 1]}\; {N.b[i - 1]}\,t",
            ),
            term(fast, "dash", "fast", sine=rf"{N.X_fast[i - 1]}\,\sin({N.omega_plus}\,t\; {N.phi_plus})"),
        ),
        x_labels=False, cursor="time", phone=10 + i, height=118,
    )  # fmt: skip


STACK = tuple((*BETWEEN[one], one, tint) for one, tint in zip(LAYERS, ("m1", "k1fill", "k2fill", "m2"), strict=True))
"""The edges of each energy, and its tint."""


def _part_energies() -> Block:
    """T and V of each mass and spring, stacked to a flat top: T1 from the floor, T2 from the ceiling."""
    return plot(
        PlotFrame("energy"), x=Axes.t, y=Axes.E,
        title="Kinetic and potential energy of each mass and spring, stacked to their constant sum",
        bands=tuple(region(low, high, tint=tint, read="*{}*_{}".format(*one.name)) for low, high, one, tint in STACK),
        heading=(
            term("", "none", "ink", formula=f"T + V = {N.E_total} ="),
            *(
                term("", "band", tint, formula=f"{one.name[0]}_{one.name[1]} = {one}{'' if one is S.T2 else ' +'}")
                for _, _, one, tint in STACK
            ),
            term("", "none", "ink", formula=str(N.E_unit)),
        ),
        cursor="time", phone=13, height=130, form=Forms.parts,
    )  # fmt: skip


def _mode_energies() -> Block:
    """The energies of the two modes: two flat lines."""
    return plot(
        PlotFrame("mode_energy"), x=Axes.t, y=Axes.E,
        title="Energy of the slow mode and of the fast mode: both constant",
        curves=(
            curve(S.E["slow"], tint="slow", label="slow"),
            curve(S.E["fast"], tint="fast", width="dash", label="fast"),
            curve(S.E["total"], tint="ink", width="sum", label="*E*"),
        ),
        heading=(
            term("", "none", "ink", formula=f"T + V = {N.E_total} ="),
            term(S.E["slow"], "line", "slow", formula=str(N.E_minus)),
            term(S.E["fast"], "dash", "fast", formula=rf"+\; {N.E_plus}"),
            term("", "none", "ink", formula=rf"{N.E_unit}\text{{: each mode keeps its own}}"),
        ),
        cursor="time", phone=13, height=130, form=Forms.modes,
    )  # fmt: skip


def _plane() -> Block:
    """The motion in the (x1, x2) plane: along the direction of the slow mode, then along that of the fast one."""
    zero = PLANE.x(0), PLANE.y(0)
    slow = PLANE.x(var(S.x_part[1, "slow"])), PLANE.y(var(S.x_part[2, "slow"]))
    here = PLANE.x(var(S.x[1])), PLANE.y(var(S.x[2]))
    return plot(
        PLANE, x=Axes.x, y=Axes.x,
        title="Displacement of mass 2 against that of mass 1, with the directions of the two modes",
        x_column=S.x[1],
        curves=(
            curve(Places.line["slow", 2], x=Places.line["slow", 1], tint="slow"),
            curve(Places.line["fast", 2], x=Places.line["fast", 1], tint="fast", width="dash"),
            curve(S.x[2], x=S.x[1], tint="ink", signal_x=S.x[1], signal=S.x[2]),
        ),
        shapes=(
            arrow(*zero, *slow, tint="slow"),
            arrow(*slow, *here, tint="fast"),
            circle(*here, 5, grab=plane_grab(PLANE)),
            *(_direction(mode) for mode in chain.MODES),
            text(PLANE.right - 4, zero[1] - 8, "*x*_1", anchor="end", tint="m1", style="t2 b"),
            text(zero[0] - 8, PLANE.top + 12, "*x*_2", anchor="end", tint="m2", style="t2 b"),
        ),
        room=Room(8, 8), square=True, plain=True, grow=1, phone=16, height=300,
    )  # fmt: skip


def _direction(mode: str) -> Shape:
    """The name of a mode beside its direction."""
    x, y = PLANE.x(var(Places.name[mode, 1])), PLANE.y(var(Places.name[mode, 2]))
    return text(x - 8, y + 4, mode, "end", tint=mode, style="t1 b halo", show=Places.name[mode, 2])

"""The paper of the coupled masses: the chain three times, both displacements, their energies, and the plane."""

from __future__ import annotations

from components import chain
from components.plots import Band, Curve, plot
from components.sheet import Block, choice, column, row, stage, term, words
from components.stage import H, Shape, W, arrow, line, on_x, on_y, text, var
from components.traces import traced

MODES = ("slow", "fast")
SIGN = {"slow": "minus", "fast": "plus"}


def coupled_sheet() -> Block:
    """The paper of the scene."""
    return column(
        row(
            stage(*_shapes(), label="Two masses and two springs in motion; below, its two modes", height=215),
            words(*_facts(), style="sum", basis=212, phone=4),
            grow=230,
            gap=18,
        ),
        row(
            column(_displacements(1), _displacements(2), _part_energies(), _mode_energies()),
            column(
                words("**Mass 2 against mass 1**", style="plain", phone=15),
                _plane(),
                words(
                    "[slow|Slow period] {slow_period}",
                    "[fast|Fast period] {fast_period}",
                    "Beat period {beat_period}",
                    style="numbers",
                    phone=17,
                ),
                choice("energy", {"parts": "Masses, springs", "modes": "Modes"}, "Energy of", phone=14),
                basis=212,
                grow=0,
            ),
            grow=346,
            gap=18,
        ),
    )


def _shapes() -> list[Shape]:
    """The motion, and under it the same chain twice more: its slow part and its fast part alone."""
    foot, slow_foot, fast_foot = 0.56 * H, 0.815 * H, 1.0 * H
    shapes = [chain.standing_wall(0.17 * H, 0.83 * H), *chain.ground(foot)]
    for mass_ in (1, 2):
        shapes.append(line(chain.rest(mass_), foot, chain.rest(mass_), fast_foot, tint="mute", style="eq"))
        shapes += chain.displacement(mass_, foot)
    shapes += chain.masses(foot, chain.place(1, "x1"), chain.place(2, "x2"))
    for mode, base in (("slow", slow_foot), ("fast", fast_foot)):
        shapes.append(line(chain.WALL * W, base, W, base, tint="rule", style="hair"))
        places = [chain.place(i, f"x{i}_{mode}") for i in (1, 2)]
        shapes += chain.masses(base, *places, small=True)
        shapes += [arrow(chain.rest(i), base - 0.026 * W, places[i - 1], base - 0.026 * W, tint=mode) for i in (1, 2)]
    return shapes


def _facts() -> list[str | dict[str, str]]:
    facts: list[str | dict[str, str]] = ["**The motion**"]
    for mode, sign in (("slow", "="), ("fast", "+")):
        name, index = SIGN[mode], {"slow": "-", "fast": "+"}[mode]
        facts.append(
            {
                "form": f"{mode}_fact",
                "sine": f"[{mode}|{sign} {mode} mode]",
                "drift": f"[{mode}|{sign} drift, off the wall]",
                "free": f"[{mode}|{sign} drift of mass 2]",
                "two": f"[{mode}|{sign} drift: no springs]",
            }
        )
        facts.append(
            {
                "form": f"{mode}_omega",
                "sine": rf"$\omega_{{{index}}} = \val{{omega_{name}}}$ rad/s, $X_2 / X_1 = \val{{ratio_{name}}}$",
                "drift": rf"$\omega_{{{index}}} = 0$: $x = a + b\,t$, $X_2 / X_1 = \val{{ratio_{name}}}$",
                "two": r"$\omega_- = \omega_+ = 0$: $x = a + b\,t$, each mass on its own",
            }
        )
    return facts


def _displacements(i: int) -> Block:
    """x_i(t), its slow part and its fast part, under the formula that is their legend and switch."""
    traces = (
        traced(f"x{i}_slow", tint="slow", label="slow", signal=f"x{i}_slow"),
        traced(f"x{i}_fast", tint="fast", width="dash", label="fast", signal=f"x{i}_fast"),
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
                sine=rf"\val{{X{i}m}}\,\sin(\val{{omega_minus}}\,t\; \val{{phi_minus}})",
                drift=rf"\val{{a{i}}}\; \val{{b{i}}}\,t",
            ),
            term(
                f"x{i}_fast",
                "dash",
                "fast",
                sine=rf"\val{{X{i}p}}\,\sin(\val{{omega_plus}}\,t\; \val{{phi_plus}})",
            ),
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
        bands=tuple(Band(low=low, high=high, tint=tint, label=label) for low, high, _, tint, label in STACK),
        heading=(
            term("", "none", "ink", formula=r"T + V = \val{E_total} ="),
            *(
                term("", "band", tint, formula=rf"{name[0]}_{name[1]} = \val{{{name}}}{' +' if name != 'T2' else ''}")
                for _, _, name, tint, _ in STACK
            ),
            term("", "none", "ink", formula=r"\val{E_unit}"),
        ),
        cursor="time",
        phone=13,
        height=130,
        show="parts",
    )


def _mode_energies() -> Block:
    """The energies of the two modes: two flat lines."""
    return plot(
        "mode_energy",
        x="t",
        y="E",
        title="Energy of the slow mode and of the fast mode: both constant",
        curves=(
            Curve(name="E_slow", source="flat", tint="slow", label="slow"),
            Curve(name="E_fast", source="flat", tint="fast", width="dash", label="fast"),
            Curve(name="E_total", source="flat", tint="ink", width="sum", label="*E*"),
        ),
        heading=(
            term("", "none", "ink", formula=r"T + V = \val{E_total} ="),
            term("E_slow", "line", "slow", formula=r"\val{E_minus}"),
            term("E_fast", "dash", "fast", formula=r"+\; \val{E_plus}"),
            term("", "none", "ink", formula=r"\val{E_unit}\text{: each mode keeps its own}"),
        ),
        source="flat",
        cursor="time",
        phone=13,
        height=130,
        show="modes",
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
        source="time",
        x_column="x1",
        curves=(
            Curve(name="slow2", source="modes", x="slow1", tint="slow"),
            Curve(name="fast2", source="modes", x="fast1", tint="fast", width="dash"),
            Curve(name="x2", x="x1", tint="ink", signal="x1,x2"),
        ),
        shapes=(
            arrow(*zero, *slow, tint="slow"),
            arrow(*slow, *here, tint="fast"),
            text(var("plane.right") - 4, zero[1] - 8, "*x*_1", anchor="end", tint="m1", style="t2 b"),
            text(zero[0] + 8, var("plane.top") + 12, "*x*_2", anchor="start", tint="m2", style="t2 b"),
        ),
        margin=(8, 8),
        square=True,
        plain=True,
        grow=1,
        phone=16,
        height=300,
    )

"""The sheet of the accuracy scene: its arrangement and its sentences."""

from __future__ import annotations

from components.language.blocks import Block
from components.layout.sheet import Paragraph, column, desk, either, row, table, words
from components.layout.views import in_views
from components.scenes.accuracy.axes import Axes
from components.scenes.accuracy.drift import drift_view
from components.scenes.accuracy.plots import growth_plot, picked_plot, work_plot
from components.scenes.accuracy.studies import digits_view, length_view, stability_view
from components.scenes.accuracy.words import CELLS, ROWS, Cells
from components.scenes.accuracy.words import Forms as F
from components.scenes.accuracy.words import Numbers as N


def paper() -> Block:
    """Return the paper with its six views."""
    growth = (
        growth_plot(Axes.error_growth, "Error of the motion, worst so far", phone=10),
        growth_plot(Axes.energy_growth, "Error of the energy, worst so far", phone=17),
        words(
            "Errors grow with time. A small error of the energy does not prove the phase right.",
            f"{N.compared} [mute|{N.missing}]",
            name="growth",
            style="plain",
            phone=16,
        ),
    )
    return column(
        in_views(drift_view(), "drift"),
        in_views(row(column(work_plot(), _system_words()), _price_column()), "time"),
        in_views(column(*growth), "growth"),
        in_views(length_view(), "length"),
        in_views(digits_view(), "digits"),
        in_views(stability_view(), "stability"),
    )


def _system_words() -> Block:
    """The motion in numbers, and which curves were measured where."""
    return words(
        f"{N.system} {N.kind}",
        either(
            F.origin,
            before=f"All recorded {N.origin}, {N.recorded_limit}.",
            both=f"**Dots: measured here, in Python.** Thin: recorded {N.origin}, {N.recorded_limit}.",
            here="**Dots: measured here, in Python:** nothing is compiled for a motion of your own. Thin, for scale: "
            f"Benign, recorded {N.origin}.",
            none="Run measures in Python: nothing is compiled for a motion of your own. Thin, for scale: Benign, "
            f"recorded {N.origin}.",
        ),
        either(
            F.compiled,
            shown="Compared with the closed form in doubles, compiled too. °: the solver is Python, only its "
            "right-hand side is compiled. (Python): not compiled, so there is no ratio.",
        ),
        either(F.costs, shown="○ on a line of a solver: rtol 10⁻³, 10⁻⁶ and 10⁻⁹."),
        either(F.switched, shown=f"LSODA takes most of its steps by BDF at rtol {N.switched}: a kink of its line."),
        either(F.costs, shown="Implicit methods with fixed steps have their linear systems solved in advance."),
        name="origin",
        style="plain",
        phone=18,
    )


def _price_column() -> Block:
    return column(
        words("A method in steps takes longer for every digit; a formula does not.", style="plain", phone=15),
        words(either(F.costs, shown=f"**An error of {N.wanted} costs**"), style="plain", phone=15),
        _price_rows(),
        words(
            either(F.unreached, shown=f"{N.unreached}"),
            either(F.unsteady, shown="[mute|± does not repeat within 20 %]"),
            style="plain",
            phone=16,
        ),
        desk(
            words(
                either(
                    F.kept,
                    shown=f"**Energy kept, phase lost?** {N.picked}. Drawn: worst so far. Click a line to pick a run.",
                ),
                style="plain",
                phone=17,
            )
        ),
        desk(picked_plot()),
        basis=370,
        grow=0,
    )


def _price_rows() -> Block:
    """The methods in the order of what the wanted error costs with each."""
    head = [either(F.costs, shown=f"[mute|{name}]") for name in ("method", "evaluations", "ms", "× closed form")]
    return table(head, *([_cell(i, cell) for cell in CELLS] for i in range(ROWS)), style="tight", phone=15)


def _cell(row: int, name: str) -> Paragraph:
    cell = Cells.price[row, name]
    return either(F.price[row], here=f"{cell}", before=f"[mute|{cell}]")

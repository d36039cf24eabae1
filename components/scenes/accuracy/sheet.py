"""The sheet of the accuracy scene: its arrangement and its sentences."""

from __future__ import annotations

from components.language.blocks import Block
from components.layout.sheet import Paragraph, choice, column, desk, either, row, table, when, words
from components.quantities.parameters import one_of
from components.scenes.accuracy.axes import Axes
from components.scenes.accuracy.plots import growth_plot, picked_plot, work_plot
from components.scenes.accuracy.studies import digits_view, length_view, stability_view
from components.scenes.accuracy.words import CELLS, ROWS, VIEWS, Cells
from components.scenes.accuracy.words import Forms as F
from components.scenes.accuracy.words import Numbers as N

VIEW = one_of("time", VIEWS, "View")


def paper() -> Block:
    """The five views, of which one stands."""
    return column(
        choice(VIEW, basis=0, style="views"),
        when(F.view["time"], row(column(desk(_system_words()), work_plot()), _price_column())),
        when(F.view["growth"], words(f"{N.compared} [mute|{N.missing}]", style="plain", phone=9)),
        growth_plot(Axes.error_growth, "Error of the motion, worst so far"),
        growth_plot(
            Axes.energy_growth, "Error of the energy, worst so far: a small one does not prove the phase right"
        ),
        length_view(),
        digits_view(),
        stability_view(),
    )


def _system_words() -> Block:
    """The motion in numbers, and which curves were measured where."""
    return words(
        f"{N.system}",
        either(
            F.origin,
            before=f"All recorded, {N.origin}, each run for {N.recorded_limit} at the most.",
            both=f"**Dots: measured here, in Python.** Thin: recorded {N.origin}, each run at most {N.recorded_limit}.",
            here="**Dots: measured here, in Python:** nothing is compiled for a motion of your own. Thin, for scale: "
            f"Benign, recorded {N.origin}.",
            none="Run measures in Python: nothing is compiled for a motion of your own. Thin, for scale: Benign, "
            f"recorded {N.origin}.",
        ),
        either(F.compiled, shown="Only fixed steps are compiled; what takes no steps is shown in Python."),
        style="plain",
        phone=9,
    )


def _price_column() -> Block:
    return column(
        words(
            either(
                F.costs,
                shown=f"**An error of {N.wanted} costs** "
                "[mute|evaluations; ms and × closed form, in Python and compiled]",
            ),
            style="plain",
            phone=11,
        ),
        _price_rows(),
        desk(
            words(
                either(
                    F.costs, shown="[mute|Newmark, midpoint and Gauss 4 have their linear systems solved in advance.]"
                ),
                style="plain",
                phone=12,
            )
        ),
        words(either(F.unsteady, shown="[mute|± does not repeat within 20 %]"), style="plain", phone=12),
        desk(
            words(
                either(
                    F.kept,
                    shown=f"**Energy kept, phase lost?** {N.picked}. Drawn: worst so far. Click a line to pick a run.",
                ),
                style="plain",
                phone=13,
            )
        ),
        desk(picked_plot()),
        basis=400,
        grow=0,
    )


def _price_rows() -> Block:
    """The methods in the order of what the wanted error costs with each."""
    head = [either(F.costs, shown=f"[mute|{name}]") for name in ("method", "eval.", "Python", "×", "compiled", "×")]
    return table(head, *([_cell(i, cell) for cell in CELLS] for i in range(ROWS)), style="tight", phone=11)


def _cell(row: int, name: str) -> Paragraph:
    cell = Cells.price[row, name]
    return either(F.price[row], here=f"{cell}", before=f"[mute|{cell}]")

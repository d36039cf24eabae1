"""The sheet of the accuracy scene: its arrangement and its sentences."""

from __future__ import annotations

from components.language.blocks import Block
from components.layout.sheet import choice, column, desk, either, row, when, words
from components.quantities.numbers import short, three
from components.scenes.accuracy.plots import growth_plot, picked_plot, work_plot
from components.scenes.accuracy.prices import power, price_rows, time_text
from components.scenes.accuracy.studies import digits_view, length_view, stability_view
from physics.accuracy import System

VIEWS = {"time": "Run time", "growth": "Growth", "length": "Length", "digits": "Digits", "stability": "Stability"}


def paper() -> Block:
    """The five views, of which one stands."""
    return column(
        choice("view", VIEWS, "View", basis=0, style="views"),
        when("time", row(column(desk(_system_words()), work_plot()), _price_column())),
        when("growth", words("{compared} [mute|{missing}]", style="plain", phone=9)),
        growth_plot("error_growth", "Error of the motion, worst so far", "growth"),
        growth_plot(
            "energy_growth", "Error of the energy, worst so far: a small one does not prove the phase right", "growth"
        ),
        length_view(),
        digits_view(),
        stability_view(),
    )


def _system_words() -> Block:
    """The motion in numbers, and which curves were measured where."""
    return words(
        "{system}",
        either(
            "origin",
            before="All recorded, {origin}, each run for {recorded_limit} at the most.",
            both="**Dots: measured here, in Python.** Thin: recorded {origin}, each run at most {recorded_limit}.",
            here="**Dots: measured here, in Python:** nothing is compiled for a motion of your own. Thin, for scale: "
            "Benign, recorded {origin}.",
            none="Run measures in Python: nothing is compiled for a motion of your own. Thin, for scale: Benign, "
            "recorded {origin}.",
        ),
        either("compiled", shown="Only fixed steps are compiled; what takes no steps is shown in Python."),
        style="plain",
        phone=9,
    )


def _price_column() -> Block:
    return column(
        words(
            either(
                "costs",
                shown="**An error of {wanted} costs** [mute|evaluations; ms and × closed form, in Python and compiled]",
            ),
            style="plain",
            phone=11,
        ),
        price_rows(phone=11),
        desk(
            words(
                either(
                    "costs", shown="[mute|Newmark, midpoint and Gauss 4 have their linear systems solved in advance.]"
                ),
                style="plain",
                phone=12,
            )
        ),
        words(either("unsteady", shown="[mute|± does not repeat within 20 %]"), style="plain", phone=12),
        desk(
            words(
                either(
                    "kept",
                    shown="**Energy kept, phase lost?** {picked}. Drawn: worst so far. Click a line to pick a run.",
                ),
                style="plain",
                phone=13,
            )
        ),
        desk(picked_plot()),
        basis=400,
        grow=0,
    )


def system_texts(system: System) -> dict[str, str]:
    """The motion in a line."""
    chain, (slow, fast) = system.chain, system.rates
    if system.c:
        text = f"m = {power(chain.m1)}, k = {power(chain.k1)}, c = {power(system.c)}{_drive_text(system)}"
        text += f". Rates of decay 1 to {power(fast / slow)}"
    else:
        names = ("m1", "m2", "k1", "k2")
        text = ", ".join(f"{name} = {short(getattr(chain, name))}" for name in names)
        text += f"{_drive_text(system)}. Fast over slow frequency {three(fast / slow) if slow else '∞'}"
    return {"system": f"{text}. 50 {system.unit}, 1000 outputs."}


def _drive_text(system: System) -> str:
    """The drive: force and frequency, near the slow one by how far it is from it."""
    if not system.F_0:
        return ""
    slow = system.rates[0]
    off = system.omega / slow - 1 if slow and not system.c else 1.0
    at = f"{short(system.omega)} rad/s" if abs(off) > 1e-3 else f"ω₋ · (1 + {power(off)})" if off else "ω₋"
    return f", driven by {power(system.F_0)} N at {at}"


def compared_text(equal: str, wanted: float, cost: float) -> str:
    """Which runs the growth compares."""
    if equal == "error":
        return f"At equal error: of each method the first run with an error of {power(wanted)} at the most."
    return f"At equal cost: of each method the finest run within {time_text(cost)}."

"""Known runs as the accuracy scene shows them: curves by method, growth of the error, the picked run."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from components.numbers import ten
from components.scenes.accuracy.measuring import LIVE
from components.traces import Columns
from physics.accuracy import MARKS, Run
from physics.price import LEAST, at_cost, at_error
from physics.solvers import METHODS

MORE = "more"
"""The group of the methods that are recorded only; switched off until asked for."""
ALONE, BEHIND = "rec_", "old_"
"""Sources of recorded runs begin with these: where nothing was measured here, and behind what was."""
WRONG = 3.0
"""Larger errors are not drawn: nothing of the motion is right."""


@dataclass(frozen=True)
class Known:
    """The runs made here and those recorded before; for a motion without records those of another, for scale."""

    here: tuple[Run, ...]
    before: tuple[Run, ...]
    scale: tuple[Run, ...] = ()

    def of(self, method: str) -> list[Run]:
        """The runs of a method, made here if there are any, coarse to fine; those without a result too."""
        mine = [run for run in self.here if run.method == method]
        return mine or [run for run in self.before if run.method == method]

    def is_here(self, method: str) -> bool:
        return any(run.method == method for run in self.here)

    def front(self, methods: Iterable[str]) -> tuple[Run, ...]:
        """Of these methods all runs that count."""
        return tuple(run for method in methods for run in self.of(method))


def shown_methods(hidden: Sequence[str]) -> tuple[str, ...]:
    """The methods that are to be seen."""
    return LIVE if MORE in hidden else tuple(METHODS)


def done(runs: Iterable[Run]) -> list[Run]:
    """The runs that can be drawn."""
    return [run for run in runs if run.error is not None and run.time is not None and run.error <= WRONG]


def work(measured: Known) -> dict[str, Columns]:
    """The columns time (s) and error (of the largest displacement) of each method: measured here, and recorded."""
    columns = {}
    made, recorded, scale = (_by_method(runs) for runs in (measured.here, measured.before, measured.scale))
    for slug in METHODS:
        here, before = made.get(slug, ()), recorded.get(slug, ())
        columns[slug] = _points(here)
        columns[ALONE + slug] = _points(() if here else before)
        columns[BEHIND + slug] = _points((before if here else ()) or scale.get(slug, ()))
    return columns


def _by_method(runs: Iterable[Run]) -> dict[str, list[Run]]:
    found: dict[str, list[Run]] = {}
    for run in runs:
        found.setdefault(run.method, []).append(run)
    return found


def _points(runs: Iterable[Run]) -> Columns:
    good = done(runs)
    return {
        "time": np.array([run.time for run in good], dtype=float),
        "error": np.array([max(run.error or 0.0, LEAST) for run in good], dtype=float),
    }


def chosen(measured: Known, methods: Iterable[str], equal: str, wanted: float, cost: float) -> dict[str, Run]:
    """Of each method the run that is compared: the first that is good enough, or the finest that is cheap enough."""
    found = {slug: measured.of(slug) for slug in methods}
    runs = {slug: at_error(many, wanted) if equal == "error" else at_cost(many, cost) for slug, many in found.items()}
    return {slug: run for slug, run in runs.items() if run is not None}


def growth(runs: dict[str, Run], of: str) -> dict[str, Columns]:
    """Per method the worst error (or energy error) so far against simulated time."""
    curves: dict[str, Columns] = {}
    for slug in METHODS:
        levels = [max(error, LEAST) for error in getattr(runs[slug], of)[1:]] if slug in runs else []
        curves[f"{of}_{slug}"] = {
            "period": np.array(MARKS[1:][: len(levels)], dtype=float),
            of: np.array(levels, dtype=float),
        }
    return curves


def setting_text(run: Run) -> str:
    """A run by its name and setting: RK45, rtol 10⁻⁶; Verlet, 16 steps an output."""
    name = METHODS[run.method].mark
    if run.family == "adaptive":
        exponent = math.floor(math.log10(run.setting) + 1e-9)
        head = run.setting / 10.0**exponent
        return f"{name}, rtol {'' if head < 1.05 else f'{head:.1f}·'}{ten(exponent)}"
    if run.family == "fixed":
        return f"{name}, {run.setting:.0f} step{'s' if run.setting != 1 else ''} an output"
    return name


def picked_run(measured: Known, picked: Sequence[str]) -> Run | None:
    """The run that the visitor has picked, by source and place among its points."""
    if len(picked) != 2 or not picked[1].isdigit():
        return None
    source, place = picked[0], int(picked[1])
    runs = measured.before if source.startswith((ALONE, BEHIND)) else measured.here
    good = done(run for run in runs if run.method == source.removeprefix(ALONE).removeprefix(BEHIND))
    return good[place] if place < len(good) else None


def kept(run: Run | None) -> Columns:
    """The picked run: errors of its motion and of its energy in percent, the worst so far."""
    if run is None or not run.error_growth:
        return {}
    motion, energy = (100 * np.array(levels) for levels in (run.error_growth, run.energy_growth))
    return {"period": np.array(MARKS, dtype=float), "motion": motion, "energy": energy}

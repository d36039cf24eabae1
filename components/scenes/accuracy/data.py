"""Known runs as the accuracy scene shows them: curves by method, growth of the error, the picked run."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from components.quantities.declared import Column, Declared, DrawnAxis, by_name
from components.quantities.formatting import short, ten
from components.scene.traces import Columns
from components.scenes.accuracy.axes import Axes
from physics.integrators.accuracy import MARKS, Run
from physics.integrators.price import LEAST, grouped
from physics.integrators.solvers import ATOL, METHODS

MORE = "more"
"""The group of the methods that are recorded only; switched off until asked for."""
ALONE, BEHIND, ASKED = "rec_", "old_", "tol_"
"""Sources of recorded runs begin with these: where nothing was measured here, and behind what was; and at last sources
of the runs of solvers with the tolerances that are marked."""
MARKED = (1e-3, 1e-6, 1e-9)
"""The relative tolerances that are marked along the line of each solver."""
ADAPTIVE = tuple(slug for slug, method in METHODS.items() if method.family == "adaptive")
WRONG = 3.0
"""Larger errors are not drawn: nothing of the motion is right."""


@dataclass(frozen=True)
class Series:
    """Series of one system, coarse to fine in each method."""

    every: tuple[Run, ...] = ()

    @cached_property
    def by_method(self) -> Mapping[str, Sequence[Run]]:
        """The runs of each method, also those without a result."""
        return grouped(self.every)

    @cached_property
    def good(self) -> Mapping[str, Sequence[Run]]:
        """The runs of each method that can be drawn."""
        found = {slug: [run for run in runs if _is_good(run)] for slug, runs in self.by_method.items()}
        return {slug: runs for slug, runs in found.items() if runs}

    @cached_property
    def points(self) -> Mapping[str, Columns]:
        """Their columns time (s) and error (of the largest displacement)."""
        return {slug: _points(runs) for slug, runs in self.good.items()}


@dataclass(frozen=True)
class Known:
    """The runs made here and those recorded before, in Python and compiled; for a motion without records those of
    another, for scale.
    """

    here: Series
    before: Series
    scale: Series = Series()
    compiled: Series = Series()

    def of(self, method: str) -> Sequence[Run]:
        """The runs of a method, made here if there are any."""
        return self.here.by_method.get(method) or self.before.by_method.get(method, ())

    def good(self, method: str) -> Sequence[Run]:
        """The runs of a method that can be drawn."""
        return (self.here if self.is_here(method) else self.before).good.get(method, ())

    def marked(self, method: str) -> Sequence[Run]:
        """The runs of a solver that are marked on its line."""
        return [run for run in self.good(method) if run.setting in MARKED]

    def is_here(self, method: str) -> bool:
        return method in self.here.by_method


def _is_good(run: Run) -> bool:
    return run.error is not None and run.time is not None and run.error <= WRONG


def compiled_only(measured: Known) -> Known:
    """Return the runs of compiled methods, and those of methods without fixed steps that were not compiled."""
    without = [slug for slug in METHODS if METHODS[slug].family != "fixed" and slug not in measured.compiled.by_method]
    here, before, scale = (
        Series(tuple(run for run in series.every if run.method in without))
        for series in (measured.here, measured.before, measured.scale)
    )
    return Known(here, Series((*before.every, *measured.compiled.every)), scale)


def work(measured: Known) -> dict[str, Columns]:
    """The points of each method: measured here, recorded, and recorded behind what was measured here."""
    here, before, scale = measured.here.points, measured.before.points, measured.scale.points
    columns: dict[str, Columns] = {}
    for slug in METHODS:
        alone, behind = ({}, before or scale) if measured.is_here(slug) else (before, scale)
        for source, points in ((slug, here), (ALONE + slug, alone), (BEHIND + slug, behind)):
            columns[source] = points.get(slug, {})
    return columns | {ASKED + slug: _points(measured.marked(slug)) for slug in ADAPTIVE}


def _points(runs: Sequence[Run]) -> Columns:
    times, errors = [run.time for run in runs], [max(run.error or 0.0, LEAST) for run in runs]
    return by_name({Axes.time: np.array(times, dtype=float), Axes.error: np.array(errors, dtype=float)})


def growth(runs: Mapping[str, Run]) -> dict[str, Columns]:
    """Per method the worst error, and the worst energy error, so far against simulated time."""
    both = product((Axes.error_growth, Axes.energy_growth), METHODS)
    return {f"{of.name}_{slug}": _growth(runs[slug], of) for of, slug in both if slug in runs}


def _growth(run: Run, of: DrawnAxis) -> Columns:
    levels = [max(error, LEAST) for error in getattr(run, of.name)[1:]]
    return by_name({Axes.period: np.array(MARKS[1:][: len(levels)], dtype=float), of: np.array(levels, dtype=float)})


def reached_text(run: Run) -> str:
    """A run, and the error that it reached: at all outputs, at the last alone, and mode by mode."""
    if run.error is None or run.final_error is None:
        return setting_text(run)
    text = f"{setting_text(run)}: error {_digit(run.error)}, at the end {_digit(run.final_error)}"
    return text + (", slow mode {}, fast mode {}".format(*map(_digit, run.mode_errors)) if run.mode_errors else "")


def _digit(error: float) -> str:
    return short(float(f"{error:.0e}"))


def setting_text(run: Run) -> str:
    """A run by its name and setting: RK45, rtol 10⁻⁶; Verlet, 16 steps an output."""
    name = METHODS[run.method].mark
    if run.family == "adaptive":
        rtol, atol = _tolerance(run.setting), _tolerance(ATOL * run.setting)
        return f"{name}, rtol {rtol}, atol {atol} of the largest displacement"
    if run.family == "fixed":
        return f"{name}, {run.setting:.0f} step{'s' if run.setting != 1 else ''} an output"
    return name


def _tolerance(size: float) -> str:
    exponent = math.floor(math.log10(size) + 1e-9)
    head = size / 10.0**exponent
    return f"{'' if head < 1.05 else f'{head:.1f}·'}{ten(exponent)}"


def picked_run(measured: Known, picked: Sequence[str]) -> Run | None:
    """The run that the visitor has picked, by source and place among its points."""
    if len(picked) != 2 or not picked[1].isdigit():
        return None
    source, place = picked[0], int(picked[1])
    if source.startswith(ASKED):
        marked = measured.marked(source.removeprefix(ASKED))
        return marked[place] if place < len(marked) else None
    runs = measured.before if source.startswith((ALONE, BEHIND)) else measured.here
    good = runs.good.get(source.removeprefix(ALONE).removeprefix(BEHIND), ())
    return good[place] if place < len(good) else None


class Kept(Declared[Run]):
    """Errors of the motion and of the energy of a run in percent, the worst so far."""

    period = Column[Run]("kept", lambda run: np.array(MARKS, dtype=float))
    motion = Column[Run]("kept", lambda run: 100 * np.array(run.error_growth))
    energy = Column[Run]("kept", lambda run: 100 * np.array(run.energy_growth))

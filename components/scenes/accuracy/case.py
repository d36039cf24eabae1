"""A comparison as the scene sees it: the runs that are known, and what is chosen to be seen of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from components.scenes.accuracy.data import MORE, Known, compiled_only, picked_run
from components.scenes.accuracy.measuring import LIVE
from components.scenes.accuracy.prices import PriceRow, power, price_list, unreached
from physics.integrators.accuracy import Run, System, entered
from physics.integrators.drift import Drift, drifts, exact
from physics.integrators.price import at_cost, at_error
from physics.integrators.solvers import METHODS

DRIFTING = ("euler", "verlet", "rk4")
"""The methods whose motion is drawn."""
NAMED = (
    "closed", "verlet", "rk4", "gauss4", "nystrom6", "dop853", "radau", "eigh", "lsoda", "bdf", "newmark", "expm",
)  # fmt: skip
"""Methods in the order in which the plot names them: it has room for the first MOST_NAMES that have a result."""
MOST_NAMES = 8


@dataclass(frozen=True, kw_only=True)
class AccuracyCase:
    """A system, its runs, and the values of the scene's parameters."""

    system: System
    known: Known
    wanted: float
    limit: float
    steps: float
    view: str
    cost: float
    equal: str
    clock: str
    unit: str
    picked: Sequence[str]
    hidden: Sequence[str]

    @cached_property
    def drawn(self) -> Known:
        return compiled_only(self.known) if self.clock == "compiled" else self.known

    @cached_property
    def longest(self) -> float:
        """The time limit of a run, or the longest run that is known, in s."""
        known = (run for series in (self.known.here, self.known.before, self.known.compiled) for run in series.every)
        return max([self.limit, *(run.time for run in known if run.time)])

    @cached_property
    def methods(self) -> tuple[str, ...]:
        """The methods that are to be seen."""
        return LIVE if MORE in self.hidden else tuple(METHODS)

    @cached_property
    def run(self) -> Run | None:
        """The run that is picked."""
        return picked_run(self.drawn, self.picked)

    @cached_property
    def ends(self) -> dict[str, Run]:
        """The run at the end of the line of each method, beside which its name stands."""
        return {slug: good[-1] for slug in self.methods if (good := self.drawn.good(slug))}

    @cached_property
    def named(self) -> dict[str, Run]:
        """The last runs of the lines that have a name in the plot."""
        return {slug: self.ends[slug] for slug in [one for one in NAMED if one in self.ends][:MOST_NAMES]}

    @property
    def exact(self) -> Drift:
        """The exact motion, for the first view."""
        return exact(self.system)

    @property
    def size(self) -> float:
        """The largest exact displacement in m."""
        return float(np.max(np.abs(self.exact.x))) or 1.0

    @property
    def drifts(self) -> dict[str, Drift]:
        """The motion by each method, in the chosen number of steps."""
        return drifts(self.system, int(self.steps), DRIFTING)

    @cached_property
    def rows(self) -> list[PriceRow]:
        compiled = self.clock == "compiled"
        unit = "doubles" if compiled else self.unit  # like with like
        return price_list(self.drawn, self.methods, self.wanted, unit, compiled)

    @cached_property
    def unreached(self) -> str:
        """The sentence on the methods that do not reach the wanted error, or ""."""
        return unreached(self.drawn, self.methods, self.wanted)

    @cached_property
    def switched(self) -> str:
        """The tolerances at which LSODA takes most of its steps by formulas for stiff equations, or ""."""
        runs = self.drawn.good("lsoda") if "lsoda" in self.methods else ()
        return ", ".join(power(run.setting) for run in runs if run.stiff_share > 0.5)

    @cached_property
    def racing(self) -> tuple[str, ...]:
        return entered(self.system, self.methods)

    @cached_property
    def compared(self) -> dict[str, Run]:
        """The run of each method that is compared: the first good enough, or the finest that is cheap enough."""
        first = self.equal == "error"
        runs = ((slug, self.known.of(slug)) for slug in self.racing)
        best = {slug: at_error(many, self.wanted) if first else at_cost(many, self.cost) for slug, many in runs}
        return {slug: run for slug, run in best.items() if run is not None}

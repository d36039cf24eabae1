"""Measured runs as the accuracy scene shows them: curves by method, prices of an error, reasons for what is missing."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from components.measuring import decoded_run
from components.numbers import short, ten, three
from components.scene import Columns
from physics.accuracy import Run
from physics.coupled import TwoMassChain
from physics.integrators import FIXED_STEP, amplification, stability_limit, stable_steps
from physics.solvers import METHODS

FLOOR = 1e-17
"""Errors below this are drawn here: a double has no more digits."""


@dataclass(frozen=True)
class Price:
    """What an error costs with one method: a time in s, or None and the best error it reached."""

    name: str
    time: float | None
    best: float


@dataclass(frozen=True)
class Recorded:
    """Measurements made beforehand, so that the scene is not empty: runs by system, and where and when."""

    about: dict[str, str]
    seconds: float
    runs: dict[str, tuple[Run, ...]]


@cache
def recorded() -> Recorded:
    """What `make bench ARGS=--record` has written."""
    data = json.loads(Path(__file__).with_name("recorded_runs.json").read_text(encoding="utf-8"))
    runs = {slug: tuple(decoded_run(row) for row in rows) for slug, rows in data["runs"].items()}
    return Recorded(data["about"], data["seconds"], runs)


def done(runs: Iterable[Run], method: str) -> list[Run]:
    """The runs of a method that have a result, coarse to fine."""
    return [run for run in runs if run.method == method and run.error is not None and run.time is not None]


def work(runs: Iterable[Run]) -> dict[str, Columns]:
    """Per method the columns time (s) and error (of the largest displacement)."""
    runs = list(runs)
    return {
        slug: {
            "time": np.array([run.time for run in done(runs, slug)], dtype=float),
            "error": np.array([max(run.error or 0.0, FLOOR) for run in done(runs, slug)], dtype=float),
        }
        for slug in METHODS
    }


def growth(runs: Iterable[Run], of: str) -> dict[str, Columns]:
    """Per method its finest run: the worst error (or energy error) so far after each slow period."""
    runs = list(runs)
    curves: dict[str, Columns] = {}
    for slug in METHODS:
        finest = done(runs, slug)[-1:]
        levels = [max(e, FLOOR) for run in finest for e in getattr(run, of)[1:]]
        curves[f"{of}_{slug}"] = {"period": np.arange(1.0, len(levels) + 1), of: np.array(levels, dtype=float)}
    return curves


def prices(runs: Iterable[Run], wanted: float) -> list[Price]:
    """What `wanted` costs with each method, cheapest first; between two runs it is read off the line between."""
    runs = list(runs)
    found = [_price(METHODS[slug].name, done(runs, slug), wanted) for slug in METHODS if done(runs, slug)]
    return sorted(found, key=lambda price: (price.time is None, price.time or 0.0, price.best))


def _price(name: str, runs: list[Run], wanted: float) -> Price:
    points = [(float(run.time or 0.0), max(run.error or 0.0, FLOOR)) for run in runs]
    best = min(error for _, error in points)
    before: tuple[float, float] | None = None
    for time, error in points:
        if error <= wanted:
            if before is None or before[1] <= error:
                return Price(name, time, best)
            share = math.log(before[1] / wanted) / math.log(before[1] / error)
            return Price(name, math.exp(math.log(before[0]) + share * math.log(time / before[0])), best)
        before = (time, error)
    return Price(name, None, best)


def stopped(runs: Iterable[Run]) -> list[tuple[str, str]]:
    """Of each method the first run without a result: its setting, and the reason with how far it came."""
    rows: dict[str, tuple[str, str]] = {}
    for run in runs:
        if run.failure:
            # A step that is unstable is so from the first one.
            tells = 0 < run.reached < 1 and (run.reached >= 0.005 or not run.failure.startswith("unstable"))
            how_far = f", at {100 * run.reached:.0f} %" if tells else ""
            rows.setdefault(
                run.method, (setting_text(run).removesuffix(" an output"), _readable(f"{run.failure}{how_far}"))
            )
    return list(rows.values())


def _readable(reason: str) -> str:
    """Numbers like 7.1e+04 and symbols as they are written by hand."""
    reason = reason.replace("omega_+", "ω₊").replace("omega", "ω")
    return re.sub(r"\d(\.\d+)?e[+-]\d+", lambda match: short(float(match[0])), reason)


def setting_text(run: Run) -> str:
    """A run by its name and setting: RK45, rtol 10⁻⁶; Verlet, 16 steps an output."""
    if run.family == "adaptive":
        return f"{run.name}, rtol {ten(round(math.log10(run.setting)))}"
    if run.family == "fixed":
        return f"{run.name}, {run.setting:.0f} step{'s' if run.setting != 1 else ''} an output"
    return run.name


def picked_run(runs: Iterable[Run], picked: list[str]) -> Run | None:
    """The run that the visitor has picked, by method and place among its results."""
    if len(picked) != 2 or not picked[1].isdigit():
        return None
    of_method = done(list(runs), picked[0])
    return of_method[int(picked[1])] if int(picked[1]) < len(of_method) else None


def kept(run: Run | None) -> Columns:
    """The picked run: errors of its motion and of its energy in percent, the worst so far after each period."""
    if run is None or not run.error_growth:
        return {}
    motion, energy = (100 * np.array(levels) for levels in (run.error_growth, run.energy_growth))
    return {"period": np.arange(len(motion), dtype=float), "motion": motion, "energy": energy}


REACH, TOP = 3.0, 3.0
"""How far the plot of the amplification goes, in h omega and upward."""


def stability() -> Columns:
    """Amplification a step against h omega, for each method with fixed steps."""
    z = np.linspace(0.005, REACH, 240)
    return {"h_omega": z, **{slug: np.maximum(np.abs(amplification(slug, z)), 1e-3) for slug in FIXED_STEP}}


def step_explosion(chain: TwoMassChain) -> Columns:
    """Steps in a slow period that an explicit method needs to stay stable, as k2/k1 grows with all else kept."""
    ratios = np.geomspace(1.0, 1e12, 25)
    k1 = chain.k1 or 1.0
    chains = [TwoMassChain(m1=chain.m1, m2=chain.m2, k1=k1, k2=k1 * ratio) for ratio in ratios]
    explicit = [slug for slug in FIXED_STEP if math.isfinite(stability_limit(slug))]
    return {
        "ratio": ratios,
        **{f"steps_{slug}": np.array([stable_steps(slug, each) for each in chains]) for slug in explicit},
    }


def time_text(seconds: float) -> str:
    """A run time as a person says it."""
    return f"{three(seconds * 1e3)} ms" if seconds < 1 else f"{three(seconds)} s"


def price_texts(found: list[Price], unit: float | None) -> list[tuple[str, str, str]]:
    """Rows of the price list: name, price, and its ratio to the closed form; or the best error instead."""
    rows = []
    for price in found:
        if price.time is None:
            rows.append((price.name, "not reached", f"best {short(price.best)}"))
        else:
            rows.append((price.name, time_text(price.time), f"× {short(price.time / unit)}" if unit else ""))
    return rows

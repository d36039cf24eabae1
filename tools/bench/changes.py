"""Changes of a recorded benchmark: further methods, second times, longer runs, spreads of counts."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from itertools import groupby
from statistics import median
from typing import Any

from physics.integrators.accuracy import SYSTEMS, Run
from physics.integrators.solvers import METHODS, TOLERANCES
from tools.bench.counting import counted
from tools.bench.estimates import RunsBySystem
from tools.bench.record import Report
from tools.bench.studies import both_ways

BESIDE = {
    ("closed", False), ("eigh", False), ("rk4", False), ("gauss4", False), ("lsoda", False),
    ("eigh", True), ("rk4", True), ("gauss4", True),
}  # fmt: skip
"""Methods, in Python or compiled, that are measured again together with others, to scale their times."""
TIMES = ("time", "time_low", "time_high")
MethodKind = tuple[str, bool]
"""A method, in Python or compiled."""
Key = tuple[str, str, bool, float]


def kind(run: Run) -> MethodKind:
    return run.method, run.compiled


def key(run: Run) -> Key:
    return run.system, run.method, run.compiled, run.setting


def in_order(runs: Iterable[Run]) -> list[Run]:
    """Python before compiled, by method, coarse to fine."""
    places = {slug: place for place, slug in enumerate(METHODS)}
    finer = {"adaptive": -1.0}
    return sorted(runs, key=lambda run: (run.compiled, places[run.method], finer.get(run.family, 1.0) * run.setting))


def recorded_kinds(report: Report) -> set[MethodKind]:
    """The methods that the record has."""
    return {kind(run) for many in report.runs.values() for run in many}


def once_only(report: Report) -> set[MethodKind]:
    """The methods without any second time; none if the record is so new that it has no second times at all."""
    again = {kind(run) for many in report.runs.values() for run in many if run.again is not None}
    return recorded_kinds(report) - again if again else set()


def with_added(report: Report, first: RunsBySystem, second: RunsBySystem) -> Report:
    """Return the report with the runs of missing methods on each system, and their second times."""
    known = {(run.system, *kind(run)) for many in report.runs.values() for run in many}
    runs, new = dict(report.runs), list[Run]()
    for slug, many in report.runs.items():
        told = [run for run in first.get(slug, ()) if (slug, *kind(run)) not in known]
        scaled = _scaled(told, factor(many, first.get(slug, ())))
        again = {key(run): run for run in _scaled(second.get(slug, ()), factor(many, second.get(slug, ()), "again"))}
        new += scaled
        runs[slug] = in_order([*many, *(_with_second(run, again) for run in scaled)])
    return replace(
        report, runs=runs, about=_told(report, "added", "added", new), both_ways=report.both_ways or both_ways()
    )


def with_systems(report: Report, found: RunsBySystem) -> Report:
    """The report with these systems recorded again, in place of all runs on them."""
    dates = dict.fromkeys(found, _when())
    return replace(report, runs={**report.runs, **found}, later={**report.later, **dates})


def with_second(report: Report, second: RunsBySystem, asked: set[MethodKind]) -> Report:
    """The report with second times of the methods that are asked for, or of all of them if none is named."""
    runs, new = dict(report.runs), list[Run]()
    for slug, many in report.runs.items():
        scale = factor(many, second.get(slug, ()), "again") if asked else 1.0
        again = {key(run): run for run in _scaled(second.get(slug, ()), scale) if not asked or kind(run) in asked}
        new += again.values()
        runs[slug] = [_with_second(run, again) if key(run) in again else run for run in many]
    name, text = ("again_added", "second times of") if asked else ("again", "second times")
    return replace(report, runs=runs, about=_told(report, name, text, new if asked else ()))


def with_long(report: Report, found: RunsBySystem, limit: float) -> Report:
    """Return the report with long runs of solvers in place of those that were stopped before.

    If a run existed already, its time becomes the second one.
    """
    runs, new = dict(report.runs), list[Run]()
    for slug, many in found.items():
        before = {key(run): run for run in report.runs[slug]}
        long = [run for run in many if run.family == "adaptive"]
        beside = [run for run in many if run.family != "adaptive"]
        told = {key(run): run for run in _scaled(long, factor(report.runs[slug], beside))}
        told = {
            place: replace(run, again=before[place].time if place in before else None) for place, run in told.items()
        }
        kinds = set(map(kind, told.values()))
        kept = {place: run for place, run in before.items() if not (run.failure and kind(run) in kinds)}
        runs[slug] = _ended(in_order((kept | told).values()), kinds)
        new += told.values()
    names = (f"{_names(many)} on {SYSTEMS[slug].name}" for slug, many in groupby(new, lambda run: run.system))
    text = f"long runs {_when()}, up to {limit:g} s each: {'; '.join(names)}"
    return replace(report, runs=runs, about={**report.about, "long": text})


def recounted(report: Report) -> Report:
    """The report with how far evaluations differ with rounding."""
    return replace(counted(report), about={**report.about, "counted": f"spread of counts {now()}, without timing"})


def factor(known: Iterable[Run], measured: Iterable[Run], name: str = "time") -> float:
    """Return the median ratio of recorded times to current ones, over the runs that have both."""
    times = {key(run): getattr(run, name) for run in known}
    pairs = [(times.get(key(run)), run.time) for run in measured]
    return median([old / new for old, new in pairs if old and new] or [1.0])


def _scaled(runs: Iterable[Run], by: float) -> list[Run]:
    def times(run: Run) -> dict[str, Any]:
        return {name: time * by for name in TIMES if (time := getattr(run, name)) is not None}

    return [replace(run, **times(run)) for run in runs]


def _with_second(run: Run, again: Mapping[Key, Run]) -> Run:
    return replace(run, again=again[key(run)].time if key(run) in again else None)


def _ended(runs: list[Run], kinds: set[MethodKind]) -> list[Run]:
    """The runs, with the reason why each of these solvers was not refined further than its last one."""
    last = {kind(run): key(run) for run in runs}

    def end(run: Run) -> str:
        if run.failure:
            return run.end
        return "" if key(run) != last[kind(run)] else "finest" if run.setting == TOLERANCES[-1] else "time limit"

    return [replace(run, end=end(run)) if kind(run) in kinds else run for run in runs]


def _told(report: Report, name: str, text: str, new: Iterable[Run]) -> dict[str, str]:
    names = _names(new)
    return {**report.about, name: f"{text} {_when()}" if not names else f"{text} {_when()}: {names}"}


def _names(runs: Iterable[Run]) -> str:
    """The names of the methods of some runs."""
    return ", ".join(dict.fromkeys(f"{METHODS[run.method].mark}{' compiled' if run.compiled else ''}" for run in runs))


def now() -> str:
    return datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")


def _when() -> str:
    """The date, and how many processes ran at once in the last quarter of an hour."""
    load = (
        f", {os.getloadavg()[2]:.1f} processes at work on {os.cpu_count()} cores" if hasattr(os, "getloadavg") else ""
    )
    return f"{now()}{load}"

"""Records of the benchmark, to a few digits: what the accuracy scene shows before anything is measured there, and what
the document is written of."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from components.scenes.accuracy.measuring import decoded_run
from physics.integrators.accuracy import SYSTEMS, Run
from tools.bench.studies import StudyCurves

GROWTH = ("error_growth", "energy_growth")
FULL = ("error", "final_error", "mode_errors")
"""Errors keep four digits more than the rest: 1.0004e-3 misses what 1e-3 reaches."""


class Spread(NamedTuple):
    """The evaluations of a solver on a system, from starts that differ by one unit in the last place."""

    method: str
    system: str
    setting: float
    counts: tuple[int, ...]

    @property
    def share(self) -> float:
        """The largest count over the least, less 1."""
        return max(self.counts) / min(self.counts) - 1


@dataclass(frozen=True)
class Report:
    """All that a benchmark has found."""

    about: dict[str, str]
    seconds: float
    runs: dict[str, list[Run]]
    length: list[Run]
    digits: dict[str, StudyCurves]
    costs: list[dict[str, Any]]
    rounding: list[Spread] = field(default_factory=list)
    """The widest spread of each solver."""
    both_ways: list[dict[str, Any]] = field(default_factory=list)
    """Times of a step by the right-hand side and as one matrix."""
    later: dict[str, str] = field(default_factory=dict)
    """The date of each system that was recorded again."""


def record(folder: Path, report: Report) -> None:
    """One file a system, and one a study; each says where and when."""
    folder.mkdir(parents=True, exist_ok=True)
    told = {"about": report.about, "seconds": report.seconds}
    for slug, many in report.runs.items():
        about = {**report.about, "date": report.later.get(slug, report.about.get("date", ""))}
        _write(folder / f"{slug}.json", {**told, "about": about, "runs": [slim(run) for run in many]})
    _write(folder / "length.json", {**told, "runs": [slim(run) for run in report.length]})
    others = {"costs": report.costs, "rounding": report.rounding, "both_ways": report.both_ways}
    _write(folder / "digits.json", {**told, **report.digits, **others})


def recalled(folder: Path) -> Report:
    """The report that was recorded."""
    systems = {slug: _read(path) for slug in SYSTEMS if (path := folder / f"{slug}.json").exists()}
    digits = _read(folder / "digits.json")
    names = ("about", "seconds", "costs", "rounding", "both_ways")
    about, seconds, costs, rounding, both_ways = (digits.pop(name, []) for name in names)
    runs = {slug: [decoded_run(row) for row in data["runs"]] for slug, data in systems.items()}
    length = [decoded_run(row) for row in _read(folder / "length.json")["runs"]]
    spreads = [Spread(method, system, setting, tuple(many)) for method, system, setting, many in rounding]
    dates = {slug: data["about"]["date"] for slug, data in systems.items()}
    later = {slug: date for slug, date in dates.items() if date != about["date"]}
    return Report(about, seconds, runs, length, digits, costs, spreads, both_ways, later)


def slim(run: Run) -> dict[str, Any]:
    """A run as JSON, without what is at its default, its numbers to four digits, errors to eight, growth to two."""
    defaults = {name: each.default for name, each in Run.__dataclass_fields__.items()}
    facts = {name: value for name, value in run.to_dict().items() if value != defaults[name]}
    return {name: _rounded(value, _digits(name)) for name, value in facts.items()}


def _digits(name: str) -> int:
    return 17 if name == "setting" else 8 if name in FULL else 2 if name in GROWTH else 4


def _rounded(value: Any, digits: int) -> Any:
    if isinstance(value, tuple):
        return [_rounded(each, digits) for each in value]
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value


def _read(path: Path) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return data


def _write(path: Path, data: dict[str, Any]) -> None:
    path.write_text(json.dumps(data, allow_nan=False, separators=(",", ":")) + "\n", encoding="utf-8")

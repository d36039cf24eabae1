"""Records of the benchmark, to a few digits, for the accuracy scene before anything is measured there."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from physics.accuracy import Limits, Run

if TYPE_CHECKING:
    from tests.bench.error_vs_time import Report

GROWTH = ("error_growth", "energy_growth")


def record(folder: Path, about: dict[str, str], limits: Limits, report: Report) -> None:
    """One file a system, and one a study; each says where and when."""
    folder.mkdir(parents=True, exist_ok=True)
    told = {"about": about, "seconds": limits.seconds}
    for slug, many in report.runs.items():
        _write(folder / f"{slug}.json", {**told, "runs": [slim(run) for run in many]})
    _write(folder / "length.json", {**told, "runs": [slim(run) for run in report.length]})
    _write(folder / "digits.json", {**told, **report.digits, "costs": [vars(each) for each in report.costs]})


def slim(run: Run) -> dict[str, Any]:
    """A run as JSON, without what is at its default, its numbers to four digits and its growth to two."""
    defaults = {name: each.default for name, each in Run.__dataclass_fields__.items()}
    facts = {name: value for name, value in run.to_dict().items() if value != defaults[name]}
    short = {name: [float(f"{value:.1e}") for value in facts.get(name, ())] for name in GROWTH if name in facts}
    return {name: _rounded(name, value) for name, value in facts.items() if name not in GROWTH} | short


def _rounded(name: str, value: Any) -> Any:
    return float(f"{value:.4g}") if isinstance(value, float) and name != "setting" else value


def _write(path: Path, data: dict[str, Any]) -> None:
    path.write_text(json.dumps(data, allow_nan=False, separators=(",", ":")) + "\n", encoding="utf-8")

"""Error against run time, outside the browser: physics.race as tables, data and figures.

    make bench                              every system and method, 1 s a run, half an hour
    make bench ARGS=--quick                 two systems, eight methods, 0.3 s a run, about a minute
    make bench ARGS=--record                the same as the first, into docs/bench and the accuracy scene

Writes error_vs_time.md, runs.csv, length.csv, digits.csv and figures into build/bench.
"""

import argparse
import os
import platform
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from components.scenes.accuracy.measuring import LIVE
from physics.accuracy import SYSTEMS, Limits, Run
from physics.race import measure
from physics.solvers import METHODS
from tests.bench.record import record
from tests.bench.studies import Costs, Curves, costs, digits, lengths
from tests.bench.tables import setting_text, time_text, write_tables

ROOT = Path(__file__).parents[2]
QUICK = ("benign", "dashpot")


@dataclass(frozen=True)
class Report:
    """All that a benchmark has found."""

    about: dict[str, str]
    runs: dict[str, list[Run]]
    length: list[Run]
    digits: dict[str, Curves]
    costs: list[Costs]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two systems, eight methods, 0.3 s a run")
    parser.add_argument("--systems", nargs="+", choices=list(SYSTEMS), help="default: all of them")
    parser.add_argument("--seconds", type=float, help="time limit of a run; default 1, quick 0.3")
    parser.add_argument("--output", type=Path, help="default build/bench")
    parser.add_argument("--record", action="store_true", help="into docs/bench and the accuracy scene")
    options = parser.parse_args(arguments)
    slugs = options.systems or (QUICK if options.quick else tuple(SYSTEMS))
    limits = Limits(seconds=options.seconds or (0.3 if options.quick else Limits().seconds))
    report = measured(slugs, LIVE if options.quick else tuple(METHODS), limits)
    output = options.output or (ROOT / "docs/bench" if options.record else Path("build/bench"))
    output.mkdir(parents=True, exist_ok=True)
    write(output, report)
    if options.record:
        record(ROOT / "components/scenes/accuracy/recorded", report.about, limits, report)
    print(f"Tables and figures are in {output}")


def measured(slugs: Sequence[str], methods: Sequence[str], limits: Limits) -> Report:
    """The race, and the studies of what it does not show."""
    found: dict[str, dict[tuple[str, float], Run]] = {slug: {} for slug in slugs}
    for run in measure([SYSTEMS[slug] for slug in slugs], methods, limits):
        found[run.system][run.method, run.setting] = run
        outcome = run.failure or f"error {run.error:.1e} in {time_text(run.time)}"
        print(f"{SYSTEMS[run.system].name}: {run.name} {setting_text(run)}: {outcome}", file=sys.stderr)
    runs = {slug: sorted(rows.values(), key=_place) for slug, rows in found.items()}
    return Report(machine(limits), runs, lengths(limits), digits(), costs())


def _place(run: Run) -> tuple[int, int]:
    return list(METHODS).index(run.method), METHODS[run.method].settings().index(run.setting)


def machine(limits: Limits) -> dict[str, str]:
    """Where and when this was measured."""
    packages = ("numpy", "scipy", "mpmath")
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        "versions": ", ".join([f"Python {platform.python_version()}", *(f"{p} {version(p)}" for p in packages)]),
        "limits": f"{limits.seconds:g} s of processor time a run, medians of up to {limits.rounds} rounds",
    }


def write(folder: Path, report: Report) -> None:
    """All files; figures last, they need matplotlib."""
    from tests.bench.figures import draw_digits, draw_length, draw_stability, draw_system

    write_tables(folder, report)
    caption = f"{report.about['date']}, {report.about['machine']}"
    for slug, many in report.runs.items():
        draw_system(folder / slug, SYSTEMS[slug], many, caption)
    draw_stability(folder / "stability")
    draw_length(folder / "length", report.length, caption)
    draw_digits(folder / "digits", report.digits, caption)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    names = [line for line in info.read_text().splitlines() if "model name" in line] if info.exists() else []
    return names[0].split(":", 1)[1].strip() if names else platform.processor() or "unknown processor"


if __name__ == "__main__":
    main()

"""Error against run time, outside the browser: physics.integrators.race as tables, data and figures.

    make bench                              every system and method, up to 1 s a run, about ten minutes
    make bench ARGS=--quick                 two systems, few methods, 0.3 s a run, about a minute
    make bench ARGS=--record                the same as the first, into docs/bench and the accuracy scene
    make bench ARGS=--again                 all of it once more: the second times beside those recorded
    make bench ARGS=--count                 count Jacobians, factorisations and solves of the recorded runs, and how
                                            far evaluations differ with rounding; also on a busy machine
    make bench ARGS=--rewrite               docs/bench anew from the record, without measuring

Writes error_vs_time.md, runs.csv, length.csv, digits.csv and figures into build/bench. With fixed steps each method is
measured as Python runs it and compiled, side by side.
"""

import argparse
import os
import platform
import sys
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS, Limits, Run
from physics.integrators.race import measure
from physics.integrators.solvers import METHODS, Method
from tests.bench.counting import counted
from tests.bench.record import Report, recalled, record
from tests.bench.studies import costs, digits, lengths
from tests.bench.tables import setting_text, time_text, write_tables

ROOT = Path(__file__).parents[2]
RECORDED = ROOT / "components/scenes/accuracy/recorded"
QUICK = ("benign", "dashpot")
Key = tuple[str, str, bool, float]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two systems, few methods, 0.3 s a run")
    parser.add_argument("--systems", nargs="+", choices=list(SYSTEMS), help="default: all of them")
    parser.add_argument("--seconds", type=float, help="time limit of a run; default 1, quick 0.3")
    parser.add_argument("--output", type=Path, help="default build/bench")
    parser.add_argument("--record", action="store_true", help="into docs/bench and the accuracy scene")
    parser.add_argument("--again", action="store_true", help="measure once more and record the second times")
    parser.add_argument("--count", action="store_true", help="count Jacobians, factorisations and solves of the record")
    parser.add_argument("--rewrite", action="store_true", help="write docs/bench anew from the record")
    options = parser.parse_args(arguments)
    kept = options.record or options.again or options.count or options.rewrite
    output = options.output or (ROOT / "docs/bench" if kept else Path("build/bench"))
    if options.rewrite or options.count:
        report = recounted(recalled(RECORDED)) if options.count else recalled(RECORDED)
    else:
        slugs = options.systems or (QUICK if options.quick else tuple(SYSTEMS))
        limits = Limits(seconds=options.seconds or (0.3 if options.quick else 1.0), budget=0.1, least=1)
        methods = [METHODS[slug] for slug in LIVE] if options.quick else list(METHODS.values())
        runs = measured(slugs, methods, limits)
        report = twice(recalled(RECORDED), runs) if options.again else whole(runs, limits)
    if options.record or options.again or options.count:
        record(RECORDED, report)
        report = recalled(RECORDED)  # so that --rewrite writes the same
    output.mkdir(parents=True, exist_ok=True)
    write(output, report)
    print(f"Tables and figures are in {output}")


def whole(runs: dict[str, list[Run]], limits: Limits) -> Report:
    """A report of the race, with the studies of what it does not show."""
    return Report(machine(limits), limits.seconds, runs, lengths(limits), digits(), costs())


def measured(slugs: Sequence[str], methods: Sequence[Method], limits: Limits) -> dict[str, list[Run]]:
    """The race on each system, those with fixed steps also compiled."""
    from tests.bench.compiled import compiled_methods

    systems, known = [SYSTEMS[slug] for slug in slugs], {method.slug for method in methods}
    compiled = [method for method in compiled_methods(systems) if method.slug in known]
    found: dict[Key, Run] = {}
    for run in measure(systems, sorted([*methods, *compiled], key=lambda method: _place(method.slug)), limits):
        found[_key(run)] = run
        outcome = run.failure or f"error {run.error:.1e} in {time_text(run.time)}"
        kind = " compiled" if run.compiled else ""
        print(f"{SYSTEMS[run.system].name}: {run.name}{kind} {setting_text(run)}: {outcome}", file=sys.stderr)
    rows = sorted(found.values(), key=lambda run: (run.compiled, _place(run.method)))
    return {slug: [run for run in rows if run.system == slug] for slug in slugs}


def twice(first: Report, second: dict[str, list[Run]]) -> Report:
    """The first report, with the times of a second one beside its own."""
    times = {_key(run): run.time for many in second.values() for run in many}
    runs = {slug: [replace(run, again=times.get(_key(run))) for run in many] for slug, many in first.runs.items()}
    return replace(first, runs=runs, about={**first.about, "again": f"second times {_now()}"})


def recounted(report: Report) -> Report:
    """The report with what is counted without timing."""
    return replace(counted(report), about={**report.about, "counted": f"counts {_now()}, without timing"})


def _key(run: Run) -> Key:
    return run.system, run.method, run.compiled, run.setting


def _place(slug: str) -> int:
    return list(METHODS).index(slug)


def machine(limits: Limits) -> dict[str, str]:
    """Where and when this was measured."""
    packages = ("numpy", "scipy", "mpmath", "numba")
    return {
        "date": _now(),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        "versions": ", ".join([f"Python {platform.python_version()}", *(f"{p} {version(p)}" for p in packages)]),
        "limits": f"{limits.seconds:g} s of processor time a run, medians of up to {limits.rounds} rounds",
    }


def _now() -> str:
    return datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")


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

"""Error against run time, outside the browser: physics.integrators.race as tables, data and figures.

    make bench                              every system and method, up to 1 s a run, about ten minutes
    make bench ARGS=--quick                 two systems, few methods, 0.3 s a run, about a minute
    make bench ARGS=--record                the same as the first, into docs/bench and the accuracy scene
    make bench ARGS=--again                 all of it once more: the second times beside those recorded
    make bench ARGS=--add                   twice, the methods that the record has not, beside four that it has: times
                                            are scaled by those
    make bench ARGS=--long                  the solvers that choose their steps on the highly oscillatory motions, at
                                            two tolerances, up to 60 s a run, about an hour
    make bench ARGS=--count                 how far evaluations differ with rounding; also on a busy machine
    make bench ARGS=--rewrite               docs/bench anew from the record, without measuring

Writes error_vs_time.md, runs.csv, length.csv, digits.csv and figures into build/bench. With fixed steps each method is
measured as Python runs it and compiled, side by side.
"""

import argparse
import os
import platform
import sys
from collections.abc import Container, Iterable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from statistics import median
from typing import Any

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS, Limits, Run
from physics.integrators.race import measure
from physics.integrators.solvers import METHODS, Method
from tests.bench.counting import counted
from tests.bench.record import Report, recalled, record
from tests.bench.studies import both_ways, costs, digits, lengths
from tests.bench.tables import setting_text, time_text, write_tables

ROOT = Path(__file__).parents[2]
RECORDED = ROOT / "components/scenes/accuracy/recorded"
QUICK = ("benign", "dashpot")
BESIDE = {("closed", False), ("rk4", False), ("rk4", True), ("lsoda", False)}
"""Methods, in Python or compiled, that are measured again beside new ones."""
LONG, PATIENCE, ASKED = ("wide", "light"), 60.0, (1e-6, 1e-9)
"""The highly oscillatory motions, and seconds a run and tolerances of solvers there."""
TIMES = ("time", "time_low", "time_high")
Key = tuple[str, str, bool, float]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two systems, few methods, 0.3 s a run")
    parser.add_argument("--systems", nargs="+", choices=list(SYSTEMS), help="default: all of them")
    parser.add_argument("--seconds", type=float, help="time limit of a run; default 1, quick 0.3")
    parser.add_argument("--output", type=Path, help="default build/bench")
    parser.add_argument("--record", action="store_true", help="into docs/bench and the accuracy scene")
    parser.add_argument("--again", action="store_true", help="measure once more and record the second times")
    parser.add_argument("--add", action="store_true", help="measure what the record has not, and add it")
    parser.add_argument("--long", action="store_true", help="solvers on highly oscillatory motions, up to 60 s a run")
    parser.add_argument("--count", action="store_true", help="count how far evaluations differ with rounding")
    parser.add_argument("--rewrite", action="store_true", help="write docs/bench anew from the record")
    options = parser.parse_args(arguments)
    changes = {
        "again": lambda report: twice(report, _raced(options)),
        "add": added,
        "long": lengthened,
        "count": recounted,
        "rewrite": lambda report: report,
    }
    change = next((made for name, made in changes.items() if getattr(options, name)), None)
    output = options.output or (ROOT / "docs/bench" if change or options.record else Path("build/bench"))
    report = change(recalled(RECORDED)) if change else whole(_raced(options), _limits(options))
    if change or options.record:
        record(RECORDED, report)
        report = recalled(RECORDED)  # so that --rewrite writes the same
    output.mkdir(parents=True, exist_ok=True)
    write(output, report)
    print(f"Tables and figures are in {output}")


def _limits(options: argparse.Namespace) -> Limits:
    return Limits(seconds=options.seconds or (0.3 if options.quick else 1.0), budget=0.1, least=1)


def _raced(options: argparse.Namespace) -> dict[str, list[Run]]:
    slugs = options.systems or (QUICK if options.quick else tuple(SYSTEMS))
    methods = [METHODS[slug] for slug in LIVE] if options.quick else list(METHODS.values())
    return measured(slugs, [*methods, *_compiled(slugs, {method.slug for method in methods})], _limits(options))


def whole(runs: dict[str, list[Run]], limits: Limits) -> Report:
    """A report of the race, with the studies of what it does not show."""
    return Report(machine(limits), limits.seconds, runs, lengths(limits), digits(), costs(), both_ways=both_ways())


def _compiled(slugs: Sequence[str], known: Container[str]) -> list[Method]:
    from tests.bench.compiled import compiled_methods

    return [method for method in compiled_methods([SYSTEMS[slug] for slug in slugs]) if method.slug in known]


def measured(slugs: Sequence[str], methods: Sequence[Method], limits: Limits) -> dict[str, list[Run]]:
    """The race on each system."""
    systems, found = [SYSTEMS[slug] for slug in slugs], dict[Key, Run]()
    for run in measure(systems, sorted(methods, key=lambda method: _place(method.slug)), limits):
        found[_key(run)] = run
        outcome = run.failure or f"error {run.error:.1e} in {time_text(run.time)}"
        kind = " compiled" if run.compiled else ""
        print(f"{SYSTEMS[run.system].name}: {run.name}{kind} {setting_text(run)}: {outcome}", file=sys.stderr)
    return {slug: _in_order(run for run in found.values() if run.system == slug) for slug in slugs}


def _in_order(runs: Iterable[Run]) -> list[Run]:
    """Python before compiled, by method, coarse to fine."""
    finer = {"adaptive": -1.0}
    return sorted(runs, key=lambda run: (run.compiled, _place(run.method), finer.get(run.family, 1.0) * run.setting))


def added(report: Report) -> Report:
    """The report with the methods that it has not, measured twice."""
    known = {(run.method, run.compiled) for many in report.runs.values() for run in many}
    every = [*METHODS.values(), *_compiled(tuple(SYSTEMS), METHODS)]
    new = [method for method in every if (method.slug, method.compiled) not in known]
    if not new:
        return report
    beside = [method for method in every if (method.slug, method.compiled) in BESIDE]
    limits = Limits(seconds=report.seconds, budget=0.1, least=1)
    first, second = (measured(tuple(SYSTEMS), [*beside, *new], limits) for _ in range(2))
    return with_added(report, first, second)


def with_added(report: Report, first: dict[str, list[Run]], second: dict[str, list[Run]]) -> Report:
    """The report with the runs of methods that it has not, and their second times."""
    known = {(run.method, run.compiled) for many in report.runs.values() for run in many}
    runs = {slug: scaled(many, first[slug], second[slug]) for slug, many in report.runs.items()}
    new = [run for many in runs.values() for run in many if (run.method, run.compiled) not in known]
    names = ", ".join(dict.fromkeys(f"{METHODS[run.method].mark}{' compiled' if run.compiled else ''}" for run in new))
    told = {**report.about, "added": f"added {_now()}, on a busy machine: {names}"}
    return replace(report, runs=runs, about=told, both_ways=both_ways())


def scaled(known: list[Run], first: list[Run], second: list[Run]) -> list[Run]:
    """The known runs, and the new ones in units of their machine: the median ratio of the times of those in both."""
    times = {_key(run): (run.time, run.again) for run in known}
    factors = []
    for many, kind in ((first, 0), (second, 1)):
        told = [(times[_key(run)][kind], run.time) for run in many if _key(run) in times]
        factors.append(median([old / new for old, new in told if old and new] or [1.0]))
    again = {_key(run): run.time for run in second}
    new = []
    for run in first:
        if _key(run) not in times:
            then = again.get(_key(run))
            facts: dict[str, Any] = {name: _times(getattr(run, name), factors[0]) for name in TIMES}
            new.append(replace(run, again=_times(then, factors[1]), **facts))
    return _in_order([*known, *new])


def _times(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor


def lengthened(report: Report) -> Report:
    """The report with solvers at two tolerances where 1 s was too short for them: highly oscillatory motions."""
    methods = [replace(method, tolerances=ASKED) for method in METHODS.values() if method.family == "adaptive"]
    return with_long(report, measured(LONG, methods, Limits(seconds=PATIENCE, rounds=1, visit=0.0)))


def with_long(report: Report, found: dict[str, list[Run]]) -> Report:
    """The report with these runs in place of those that were stopped after 1 s."""
    runs = dict(report.runs)
    for slug, many in found.items():
        keys = {_key(run) for run in many}
        tried = {run.method for run in many}
        stopped = (run for run in runs[slug] if run.failure and run.method in tried and not run.compiled)
        gone = keys | {_key(run) for run in stopped}
        runs[slug] = _in_order([*(run for run in runs[slug] if _key(run) not in gone), *many])
    names = "; ".join(f"{_marks(many)} on {SYSTEMS[slug].name}" for slug, many in found.items() if many)
    told = f"{_now()}, up to {PATIENCE:g} s a run, once, on a busy machine: {names}"
    return replace(report, runs=runs, about={**report.about, "long": told})


def _marks(runs: Iterable[Run]) -> str:
    """The names of the methods of some runs."""
    return ", ".join(dict.fromkeys(METHODS[run.method].mark for run in runs))


def twice(first: Report, second: dict[str, list[Run]]) -> Report:
    """The first report, with the times of a second one beside its own."""
    times = {_key(run): run.time for many in second.values() for run in many}
    runs = {slug: [replace(run, again=times.get(_key(run))) for run in many] for slug, many in first.runs.items()}
    return replace(first, runs=runs, about={**first.about, "again": f"second times {_now()}"})


def recounted(report: Report) -> Report:
    """The report with how far evaluations differ with rounding."""
    return replace(counted(report), about={**report.about, "counted": f"spread of counts {_now()}, without timing"})


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

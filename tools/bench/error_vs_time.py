"""Error against run time, outside the browser: physics.integrators.race as tables, data and figures.

    make bench                              every system and method, up to 1 s a run, about half an hour
    make bench ARGS=--quick                 two systems, few methods, 0.3 s a run, about a minute
    make bench ARGS=--record                the same as the first, into docs/bench and the accuracy scene
    make bench ARGS="--record --systems wide"  one system again, in place of all that the record has of it
    make bench ARGS=--again                 second times of all methods that were timed only once
    make bench ARGS=--add                   twice, the methods that the record has not
    make bench ARGS=--long                  the solvers that choose their steps on the highly oscillatory motions, at
                                            a few tolerances each, up to half an hour a run, about two hours
    make bench ARGS=--count                 how far evaluations differ with rounding; also on a busy machine
    make bench ARGS=--rewrite               docs/bench again from the record, without measuring

Writes error_vs_time.md, runs.csv, length.csv, digits.csv and figures into build/bench. With fixed steps each method is
measured as Python runs it and compiled, side by side. What is measured later is timed beside a few recorded methods,
and its times are scaled by theirs.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
from collections.abc import Collection, Container, Mapping, Sequence
from dataclasses import replace
from importlib.metadata import version
from math import inf
from pathlib import Path

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS, Limits, Run, entered
from physics.integrators.race import measure
from physics.integrators.solvers import METHODS, Method
from tools.bench import changes
from tools.bench.changes import BESIDE, Key, MethodKind, in_order, key, now
from tools.bench.price_table import setting_text, time_text
from tools.bench.record import Report, recalled, record
from tools.bench.studies import both_ways, costs, digits, lengths
from tools.bench.tables import write_tables

ROOT = Path(__file__).parents[2]
RECORDED = ROOT / "components/scenes/accuracy/recorded"
QUICK = ("benign", "dashpot")
PATIENCE = 1800.0
"""Seconds that a long run may take."""
_LONG = {
    "dop853": (1e-6, 1e-11),
    "lsoda": (1e-6, 1e-9, 1e-11),
    "fortran": (1e-6, 1e-9, 1e-12),
    "adams": (1e-6, 1e-9, 1e-12, 1e-13),
}
LONG: Mapping[str, Mapping[str, Sequence[float]]] = {"wide": _LONG, "light": {**_LONG, "rk45": (1e-8, 1e-11)}}
"""The highly oscillatory motions, and the tolerances of the solvers that reach an error of 1e-6 there in time."""


def main(arguments: Sequence[str] | None = None) -> None:
    options = options_of(arguments)
    made = options.change(options)
    if options.keeps:
        record(options.recorded, made)
        made = recalled(options.recorded)  # so that --rewrite writes the same
    options.output.mkdir(parents=True, exist_ok=True)
    write(options.output, made)
    print(f"Tables and figures are in {options.output}")


def options_of(arguments: Sequence[str] | None) -> argparse.Namespace:
    """The options, with the function `change` that makes the report, and whether the record `keeps` it."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two systems, few methods, 0.3 s a run")
    parser.add_argument("--systems", nargs="+", choices=list(SYSTEMS), help="what is measured; default: all of them")
    parser.add_argument("--seconds", type=_seconds, help="time limit of a run; default 1, quick 0.3, long 1800")
    parser.add_argument("--output", type=Path, help="default build/bench, or docs/bench with a record")
    parser.add_argument("--recorded", type=Path, default=RECORDED, help="folder of the record; default the scene's")
    kinds = parser.add_mutually_exclusive_group()
    for name, (_, told) in CHANGES.items():
        kinds.add_argument(f"--{name}", action="store_true", help=told)
    options = parser.parse_args(arguments)
    chosen = next((name for name in CHANGES if getattr(options, name)), "")
    if wrong := _wrong(options, chosen):
        parser.error(wrong)
    options.change, options.keeps = CHANGES[chosen][0] if chosen else whole, bool(chosen)
    options.output = options.output or (ROOT / "docs/bench" if chosen else Path("build/bench"))
    return options


def _wrong(options: argparse.Namespace, chosen: str) -> str:
    """A sentence on options that do not fit together, or ""."""
    if options.output and options.output.exists() and not options.output.is_dir():
        return f"--output needs a folder, and {options.output} is a file"
    if options.quick and chosen:
        return f"--quick measures too little for a record: leave out --quick or --{chosen}"
    if chosen in ("count", "rewrite") and (options.systems or options.seconds):
        return f"--{chosen} measures no times: leave out --systems and --seconds"
    if chosen == "long" and not set(options.systems or LONG) <= set(LONG):
        return f"--long is for the highly oscillatory motions: choose of --systems {' '.join(LONG)}"
    if chosen not in ("", "record") and not _has_record(options.recorded):
        return f"--{chosen} changes a record, and {options.recorded} has none: make one with --record"
    return ""


def _has_record(folder: Path) -> bool:
    return (folder / "digits.json").exists()


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < inf:
        raise argparse.ArgumentTypeError(f"a time limit is a number of seconds above 0, and {text!r} is not")
    return seconds


def _limits(options: argparse.Namespace) -> Limits:
    return Limits(seconds=options.seconds or (0.3 if options.quick else 1.0), budget=0.1, least=1)


def _systems(options: argparse.Namespace, default: Collection[str] = tuple(SYSTEMS)) -> tuple[str, ...]:
    return tuple(options.systems or default)


def whole(options: argparse.Namespace) -> Report:
    """Return a report of the race and its studies, or the record with some systems measured again."""
    slugs, limits = _systems(options, QUICK if options.quick else tuple(SYSTEMS)), _limits(options)
    methods = [METHODS[slug] for slug in LIVE] if options.quick else list(METHODS.values())
    runs = measured(slugs, [*methods, *_compiled(slugs, {method.slug for method in methods})], limits)
    if options.record and options.systems and _has_record(options.recorded):
        return changes.with_systems(recalled(options.recorded), runs)
    return Report(machine(limits), limits.seconds, runs, lengths(limits), digits(), costs(), both_ways=both_ways())


def added(options: argparse.Namespace) -> Report:
    """The record with the methods that it has not, measured twice."""
    report, slugs = recalled(options.recorded), _systems(options)
    first, second = dict[str, list[Run]](), dict[str, list[Run]]()
    for slug in slugs:
        known = {changes.kind(run) for run in report.runs.get(slug, ())}
        missing = [method for method in _every([slug]) if (method.slug, method.compiled) not in known]
        if missing := [method for method in missing if entered(SYSTEMS[slug], [method.slug])]:
            for found in (first, second):
                found |= measured([slug], [*_beside(missing, [slug]), *missing], _limits(options))
    if not first:
        print("The record has all methods.", file=sys.stderr)
        return report
    return changes.with_added(report, first, second)


def again(options: argparse.Namespace) -> Report:
    """Return the record with second times of runs that were timed once."""
    report, slugs = recalled(options.recorded), _systems(options)
    asked = changes.once_only(report)
    methods = [method for method in _every(slugs) if not asked or (method.slug, method.compiled) in asked]
    beside = _beside(methods, slugs) if asked else []
    return changes.with_second(report, measured(slugs, [*beside, *methods], _limits(options)), asked)


def lengthened(options: argparse.Namespace) -> Report:
    """The record with solvers at a few tolerances where 1 s was too short for them: highly oscillatory motions."""
    report, found = recalled(options.recorded), dict[str, list[Run]]()
    limits = Limits(seconds=options.seconds or PATIENCE, rounds=1)
    for slug in _systems(options, LONG):
        solvers = [
            replace(method, tolerances=tuple(LONG[slug][method.slug]))
            for method in _every([slug])
            if method.slug in LONG[slug]
        ]
        # The methods measured with them must have no steps, because others would run until this long limit.
        beside = [method for method in METHODS.values() if method.family in ("closed", "exact")]
        found |= measured([slug], [*beside, *solvers], limits)
    return changes.with_long(report, found, limits.seconds)


CHANGES = {
    "record": (whole, "into docs/bench and the accuracy scene"),
    "again": (again, "record second times of what was timed once"),
    "add": (added, "measure what the record has not, and add it"),
    "long": (lengthened, "solvers on highly oscillatory motions, up to half an hour a run"),
    "count": (
        lambda options: changes.recounted(recalled(options.recorded)),
        "count how far evaluations differ with rounding",
    ),
    "rewrite": (lambda options: recalled(options.recorded), "write docs/bench again from the record"),
}
"""Options that change the record, each with the function that makes the report, and a description."""


def _every(slugs: Sequence[str]) -> list[Method]:
    """All methods, in Python and compiled."""
    return [*METHODS.values(), *_compiled(slugs, METHODS)]


def _beside(methods: Sequence[Method], slugs: Sequence[str]) -> list[Method]:
    """Return the methods that are measured again together with others."""
    new: set[MethodKind] = {(method.slug, method.compiled) for method in methods}
    return [each for each in _every(slugs) if (each.slug, each.compiled) in BESIDE - new]


def _compiled(slugs: Sequence[str], known: Container[str]) -> list[Method]:
    from tools.bench.compiled import compiled_methods

    return [method for method in compiled_methods([SYSTEMS[slug] for slug in slugs]) if method.slug in known]


def measured(slugs: Sequence[str], methods: Sequence[Method], limits: Limits) -> dict[str, list[Run]]:
    """The race on each system."""
    systems, found, places = [SYSTEMS[slug] for slug in slugs], dict[Key, Run](), list(METHODS)
    for run in measure(systems, sorted(methods, key=lambda method: places.index(method.slug)), limits):
        found[key(run)] = run
        outcome = run.failure or f"error {run.error:.1e} in {time_text(run.time)}"
        compiled = " compiled" if run.compiled else ""
        print(f"{SYSTEMS[run.system].name}: {run.name}{compiled} {setting_text(run)}: {outcome}", file=sys.stderr)
    return {slug: in_order(run for run in found.values() if run.system == slug) for slug in slugs}


def machine(limits: Limits) -> dict[str, str]:
    """Return where and when this was measured."""
    packages = ("numpy", "scipy", "mpmath", "numba")
    return {
        "date": now(),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        "versions": ", ".join([f"Python {platform.python_version()}", *(f"{p} {version(p)}" for p in packages)]),
        "limits": f"{limits.seconds:g} s of processor time a run, medians of up to {limits.rounds} rounds",
    }


def write(folder: Path, report: Report) -> None:
    """All files; figures last, they need matplotlib."""
    from tools.bench.figures import draw_digits, draw_length, draw_stability, draw_system

    write_tables(folder, report)
    date, computer = report.about["date"], report.about["machine"]
    for slug, many in report.runs.items():
        day, _, _ = report.later.get(slug, date).partition(",")
        draw_system(folder / slug, SYSTEMS[slug], many, f"{day}, {computer}")
    caption = f"{date}, {computer}"
    draw_stability(folder / "stability")
    draw_length(folder / "length", report.length, caption)
    draw_digits(folder / "digits", report.digits, caption)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    names = [line for line in info.read_text().splitlines() if "model name" in line] if info.exists() else []
    return names[0].split(":", 1)[1].strip() if names else platform.processor() or "unknown processor"


if __name__ == "__main__":
    main()

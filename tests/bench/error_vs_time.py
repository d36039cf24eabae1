"""Error against run time, outside the browser: the measurement of physics.accuracy as tables and figures.

    make bench                         every system, 8 s a run
    make bench ARGS=--quick            two systems, 1 s a run, about a minute

    make bench ARGS="--seconds 4 --record"    also what the accuracy scene shows before anything is run

Writes error_vs_time.md, .csv and .json and one figure a system (PNG and SVG) into build/bench.
"""

import argparse
import csv
import json
import os
import platform
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from physics.accuracy import SYSTEMS, Limits, Run, System, measure, plan

RECORDED = Path(__file__).parents[2] / "components/scenes/accuracy/recorded_runs.json"
QUICK = ("benign", "stiff")
GOOD_ENOUGH = 1e-6
SETTINGS = {"closed": "", "fixed": "{:g} steps an output", "adaptive": "rtol {:g}"}


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two systems, 1 s a run")
    parser.add_argument("--systems", nargs="+", choices=list(SYSTEMS), help="default: all of them")
    parser.add_argument("--seconds", type=float, help="time limit of a run; default 8, quick 1")
    parser.add_argument("--output", type=Path, default=Path("build/bench"))
    parser.add_argument("--record", action="store_true", help="keep the runs for the accuracy scene")
    options = parser.parse_args(arguments)
    slugs = options.systems or (QUICK if options.quick else tuple(SYSTEMS))
    limits = Limits(seconds=options.seconds or (1.0 if options.quick else 8.0))
    runs = {slug: _measured(SYSTEMS[slug], limits) for slug in slugs}
    options.output.mkdir(parents=True, exist_ok=True)
    write(options.output, machine(limits), runs)
    if options.record:
        record(RECORDED, machine(limits), limits, runs)
    print(f"Tables and figures are in {options.output}")


def machine(limits: Limits) -> dict[str, str]:
    """Where and when this was measured."""
    packages = ("numpy", "scipy", "mpmath")
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        "versions": ", ".join([f"Python {platform.python_version()}", *(f"{p} {version(p)}" for p in packages)]),
        "limits": f"{limits.seconds:g} s a run, medians of up to {limits.repeats} runs",
    }


def write(folder: Path, about: dict[str, str], runs: dict[str, list[Run]]) -> None:
    """All files; figures last, they need matplotlib."""
    from tests.bench.figures import draw_stability, draw_system

    (folder / "error_vs_time.md").write_text(markdown(about, runs), encoding="utf-8")
    rows = {slug: [run.to_dict() for run in many] for slug, many in runs.items()}
    report = json.dumps({"about": about, "runs": rows}, indent=1, allow_nan=False)
    (folder / "error_vs_time.json").write_text(report, encoding="utf-8")
    with (folder / "error_vs_time.csv").open("w", newline="", encoding="utf-8") as file:
        fields = [name for name in Run.__dataclass_fields__ if not name.endswith("_growth")]
        table = csv.DictWriter(file, fields, extrasaction="ignore")
        table.writeheader()
        table.writerows(row for many in rows.values() for row in many)
    for slug, many in runs.items():
        draw_system(folder / slug, SYSTEMS[slug], many, f"{about['date']}, {about['machine']}")
    draw_stability(folder / "stability")


def record(path: Path, about: dict[str, str], limits: Limits, runs: dict[str, list[Run]]) -> None:
    """What the accuracy scene shows before anything is run: the runs, their growth to three digits."""
    rows = {slug: [_slim(run) for run in many] for slug, many in runs.items()}
    text = json.dumps({"about": about, "seconds": limits.seconds, "runs": rows}, allow_nan=False)
    path.write_text(text + "\n", encoding="utf-8")


def _slim(run: Run) -> dict[str, object]:
    growth = ("error_growth", "energy_growth")
    return run.to_dict() | {name: [float(f"{value:.2e}") for value in getattr(run, name)] for name in growth}


def markdown(about: dict[str, str], runs: dict[str, list[Run]]) -> str:
    """One table of runs a system, and what an error of 1e-6 costs there."""
    lines = ["# Error against run time", ""]
    lines += [f"- {value}" for value in about.values()]
    for slug, many in runs.items():
        lines += ["", f"## {SYSTEMS[slug].name}", "", _described(SYSTEMS[slug]), ""]
        lines += ["| method | setting | error | energy error | median | lowest to highest | evaluations | steps |"]
        lines += ["|---|---|---|---|---|---|---|---|", *(_row(run) for run in many)]
        lines += ["", f"An error of {GOOD_ENOUGH:g} costs: {_prices(many)}."]
    return "\n".join(lines) + "\n"


def _measured(system: System, limits: Limits) -> list[Run]:
    total, runs = len(plan(system)), []
    for run in measure(system, limits=limits):
        runs.append(run)
        outcome = run.failure or f"error {run.error:.1e} in {_ms(run.time)}"
        print(f"{system.name} {len(runs)}/{total}: {run.name} {_setting(run)}: {outcome}", file=sys.stderr)
    return runs


def _setting(run: Run) -> str:
    return SETTINGS[run.family].format(run.setting)


def _ms(seconds: float | None) -> str:
    return f"{1e3 * (seconds or 0):.3g} ms" if (seconds or 0) < 1 else f"{seconds:.3g} s"


def _row(run: Run) -> str:
    cells = [run.name, _setting(run)]
    if run.error is None or run.time is None:
        cells += [f"{run.failure}, at {100 * run.reached:.3g} % of the motion", "", "", ""]
    else:
        spread = f"{_ms(run.time_low)} to {_ms(run.time_high)}"
        cells += [f"{run.error:.1e}", f"{run.energy_error:.1e}", _ms(run.time), spread]
    return "| " + " | ".join([*cells, str(run.evaluations), str(run.steps)]) + " |"


def _prices(runs: list[Run]) -> str:
    """The quickest measured run of each method that is good enough, quickest first."""
    best: dict[str, float] = {}
    for run in runs:
        if run.error is not None and run.time is not None and run.error <= GOOD_ENOUGH:
            best[run.name] = min(run.time, best.get(run.name, run.time))
    reached = [f"{name} {_ms(time)}" for name, time in sorted(best.items(), key=lambda item: item[1])]
    missed = list(dict.fromkeys(run.name for run in runs if run.name not in best))
    return "; ".join([*reached, *(f"{name} does not get there" for name in missed)])


def _described(system: System) -> str:
    chain = system.chain
    text = f"m1 = {chain.m1:g} kg, m2 = {chain.m2:g} kg, k1 = {chain.k1:g} N/m, k2 = {chain.k2:g} N/m; "
    text += f"x(0) = {system.x_0} m, v(0) = {system.v_0} m/s"
    return text + (f"; {system.F_0:g} N sin({system.omega!r} t)" if system.F_0 else "")


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    names = [line for line in info.read_text().splitlines() if "model name" in line] if info.exists() else []
    return names[0].split(":", 1)[1].strip() if names else platform.processor() or "unknown processor"


if __name__ == "__main__":
    main()

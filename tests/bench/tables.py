"""The benchmark in words and numbers: Markdown for people, CSV for machines."""

from __future__ import annotations

import csv
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING

from physics.accuracy import SYSTEMS, Run, System
from physics.price import Price, grouped, prices
from physics.solvers import METHODS

if TYPE_CHECKING:
    from tests.bench.error_vs_time import Report

WANTED = (1e-3, 1e-6, 1e-9)
SETTINGS = {"closed": "", "exact": "", "fixed": "{:g} steps an output", "adaptive": "rtol {:g}"}
NOT_REACHED = {"time limit": "not within the time limit", **dict.fromkeys(("floor", "finest", "spacing"), "never")}
RULES = """
How to read it. Each method was refined until its error stood at its floor, it had no finer setting, or a run passed the
time limit; all methods on all systems side by side, and then timed again in further rounds. Run times are processor
time of one thread, relative to a fixed piece of work timed just before and after. The price of an error is the least
run time at which the straight lines from run to run, both axes logarithmic, are good enough, as in the accuracy scene.
† marks a run time that did not repeat within 20 %; "never" is said of a method that stands at its floor or has no finer
setting. Evaluations of the right-hand side, read off the same way, are what no machine changes.

Newmark with the average acceleration and the implicit midpoint are one method where nothing drives the chain. "Wide
apart" chains are not stiff: nothing damps the fast mode, so every method must follow it. "Stiff" is the dashpot.
Fixed steps and SciPy's solvers are Python, but for LSODA, which is compiled.
"""


def write_tables(folder: Path, report: Report) -> None:
    (folder / "error_vs_time.md").write_text(markdown(report), encoding="utf-8")
    skipped = ("error_growth", "energy_growth")
    fields = [name for name in Run.__dataclass_fields__ if name not in skipped]
    _write_csv(folder / "runs.csv", fields, [run.to_dict() for many in report.runs.values() for run in many])
    _write_csv(folder / "length.csv", fields, [run.to_dict() for run in report.length])
    columns = {f"{sweep}.{name}": values for sweep, curves in report.digits.items() for name, values in curves.items()}
    rows = [dict(zip(columns, row, strict=True)) for row in zip_longest(*columns.values())]
    _write_csv(folder / "digits.csv", list(columns), rows)


def _write_csv(path: Path, fields: list[str], rows: list[dict[str, object]]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, fields, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def markdown(report: Report) -> str:
    """Tables of the price of errors on each system, against the length of the run, and of the digits."""
    lines = ["# Error against run time", "", *(f"- {value}" for value in report.about.values()), RULES]
    for slug, many in report.runs.items():
        lines += [f"## {SYSTEMS[slug].name}", "", described(SYSTEMS[slug]), "", f"![]({slug}.png)", ""]
        lines += _price_table(many)
    lines += ["## Length of the run", "", *_length_table(report.length), ""]
    lines += ["## Where 80 digits matter, and what they cost", "", *_digits_table(report), ""]
    return "\n".join(lines)


def _price_table(runs: list[Run]) -> list[str]:
    many = grouped(runs)
    columns = {wanted: {each.method: each for each in prices(many.values(), wanted)} for wanted in WANTED}
    head = ["method", "best error", *(f"{wanted:g}: time, × closed form, evaluations" for wanted in WANTED)]
    lines = [_line(head), _line(["---"] * len(head))]
    for slug, own in many.items():
        found = [columns[wanted].get(slug) for wanted in WANTED]
        units = [columns[wanted]["closed"].time if "closed" in columns[wanted] else None for wanted in WANTED]
        best = f"{found[0].best:.1e}" if found[0] else _failure(own)
        lines.append(_line([METHODS[slug].name, best, *(price_text(p, u) for p, u in zip(found, units, strict=True))]))
    return [*lines, ""]


def _failure(runs: list[Run]) -> str:
    return f"none: {runs[-1].failure}"


def price_text(price: Price | None, unit: float | None) -> str:
    """The price of an error, or why it has none."""
    if price is None:
        return ""
    if price.time is None:
        return NOT_REACHED.get(price.end, "not refined so far")
    mark = " †" if price.repeats is False else ""
    ratio = f", × {price.time / unit:.3g}" if unit else ""
    return f"{time_text(price.time)}{mark}{ratio}, {price.evaluations:.3g}"


def _length_table(runs: list[Run]) -> list[str]:
    spans = sorted({run.setting for run in runs})
    shown = [span for span in spans if span in (5, 50, 500, 5000)]
    lines = [_line(["method", *(f"{span:g} periods" for span in shown)]), _line(["---"] * (len(shown) + 1))]
    for slug in dict.fromkeys(run.method for run in runs):
        by_span = {run.setting: run for run in runs if run.method == slug}
        cells = [by_span[span] for span in shown]
        texts = [
            f"{time_text(run.time)}, error {run.error:.1e}" if run.error is not None else run.failure for run in cells
        ]
        lines.append(_line([METHODS[slug].name, *(text or "" for text in texts)]))
    return lines


def _outcome(run: Run) -> str:
    return run.failure or f"{time_text(run.time)}, error {run.error:.1e}"


def _digits_table(report: Report) -> list[str]:
    lines = [_line(["motion", "80 digits alone", "closed form", "eigh"]), _line(["---"] * 4)]
    lines += [_line([c.motion, f"{c.digits:.3g} ms", f"{c.closed:.3g} ms", f"{c.eigh:.3g} ms"]) for c in report.costs]
    for sweep, curves in report.digits.items():
        names = [name for name in curves if name != "x"]
        lines += ["", _line([sweep, *(METHODS[name].name for name in names)]), _line(["---"] * (len(names) + 1))]
        for row in zip(*curves.values(), strict=True):
            lines.append(_line([f"{row[0]:.0e}", *("none" if e is None else f"{e:.0e}" for e in row[1:])]))
    return lines


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def setting_text(run: Run) -> str:
    return SETTINGS[run.family].format(run.setting)


def time_text(seconds: float | None) -> str:
    return f"{1e3 * (seconds or 0):.3g} ms" if (seconds or 0) < 1 else f"{seconds:.3g} s"


def described(system: System) -> str:
    """The system in numbers."""
    chain = system.chain
    text = f"m1 = {chain.m1:g} kg, m2 = {chain.m2:g} kg, k1 = {chain.k1:g} N/m, k2 = {chain.k2:g} N/m; "
    text += f"x(0) = {system.x_0} m, v(0) = {system.v_0} m/s"
    text += f"; {system.F_0:g} N sin({system.omega!r} t)" if system.F_0 else ""
    return text + (f"; a dashpot of {system.c:.7g} N s/m beside spring 1" if system.c else "")

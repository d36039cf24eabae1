"""The benchmark in words and numbers: Markdown for people, CSV for machines."""

from __future__ import annotations

import csv
from dataclasses import replace
from itertools import zip_longest
from math import pi
from pathlib import Path

from physics.integrators.accuracy import SYSTEMS, Run, System
from physics.integrators.price import Price, at_error, grouped, in_doubles, prices
from physics.integrators.solvers import ATOL, IN_PYTHON, METHODS
from physics.integrators.stiffness import stiffness
from tests.bench.findings import findings
from tests.bench.methods import methods_table
from tests.bench.record import Report

WANTED = (1e-3, 1e-6, 1e-9)
ASKED = (1e-3, 1e-6, 1e-9)
APART = 1.3  # ratios of two benchmarks that differ by more are marked
SETTINGS = {"closed": "", "exact": "", "fixed": "{:g} steps an output", "adaptive": "rtol {:g}, atol {:g}"}
NOT_REACHED = {"time limit": "not in time", **dict.fromkeys(("floor", "finest", "spacing"), "never")}
RULES = """
## How to read it

Each method was refined until its error stood at its floor, it had no finer setting, or a run passed the time limit;
all methods on all systems side by side, and then the quick ones timed again in further rounds. Each method ran twice:
as Python runs it, and compiled by numba. With fixed steps the very same stepping functions are compiled, and the closed
form in doubles from its constants to its last output. Of solvers that choose their steps the right-hand side is
compiled: SciPy's LSODA, VODE-Adams and the second DOP853 are compiled themselves, RK23, RK45, DOP853, Radau and BDF are
Python, and so they stay: ° marks them. What compiling takes is not counted. The closed form in 80 digits, the naive
modes and expm were not compiled. An empty cell was not measured: on Beats, Wide apart 1e6 and Light mass 2 no solver
has run with a compiled right-hand side.

Run times are processor time of one thread, relative to a fixed piece of work timed just before and after, and are
given with their ratio to the closed form: × app is against the closed form as the app runs it, in 80 digits where it
needs them; × doubles is against the closed form in plain doubles, by the modes of eigh, for the dashpot by the formulas
as they stand. Python is divided by Python, and compiled by compiled. The price of an error is the least run time at
which the straight lines from run to run, both axes logarithmic, are good enough, as in the accuracy scene. "not in
time" says that time ran out; "never" that a method stands at its floor or has no finer setting. Then the last column
has the best error that it reached. † marks a time that did not repeat within 20 % in its rounds; ‡ a ratio that did not
repeat within 30 % when the whole benchmark was run again: the second one stands in brackets.

Methods that were added later were timed on a busy machine, beside four methods of the first benchmark; their times are
scaled by the median ratio of the times of those. Counts and errors do not depend on that.

Evaluations of the right-hand side, read off the same way, do not depend on the speed of a machine; of solvers that
choose their steps they differ with its rounding, which is told below. Methods without steps have none: theirs
are the outputs. Implicit methods with fixed steps use constant matrices and have their linear
systems solved in advance, once for all steps; Radau, BDF and LSODA are given the constant Jacobian, but factorise
their systems anew whenever their step changes. Newmark with the average acceleration and the implicit midpoint are
one method where nothing drives the chain. The second DOP853 has no dense output: it is restarted at each of the 1,000
outputs. Where that makes its coarsest run better than asked, further digits cost it nothing.

Errors are the largest at 1,000 outputs and in units of the largest displacement, with the dashpot also of the largest
velocity. What runs reach beside that, under each system: the error at the last output alone, where no interpolation
is left; a phase error may happen to be small there; and the parts of the error in the slow and in the fast mode.
Asked stands the tolerance, which a solver keeps in each step, not at the end: rtol, and atol in units of the largest
displacement, for velocities of that times the slow rate. Jacobians, LU factorisations and linear solves stand beside
the evaluations. Radau solves a real and a complex system in each iteration.
LSODA factorises once a Jacobian and does not report its solves.

On this linear problem a step of any method is one constant 4 x 4 matrix, and so are many steps at once. Then all
methods cost the same a step, and nothing of it carries over to another problem. So explicit methods evaluate the
right-hand side as they would anywhere; implicit ones with fixed steps use the constant matrix, as codes for linear
structures do, and the tables say so. "A step as one matrix" below measures both ways.

A motion is stiff if stability, not accuracy, limits the step of an explicit method (Hairer and Wanner, Solving Ordinary
Differential Equations II, IV.1). It is highly oscillatory if accuracy limits the step because a fast oscillation, which
nothing damps, carries part of the motion: only a method that solves it exactly can step over it. The measure is |λ| h,
the fast rate times the step: at the limit of accuracy that at which Gauss 4, which is stable at every step, has an
error of 1e-3; at the limit of stability that of RK4, of the same order. Where accuracy allows more than stability, the
motion is stiff. It stands under each system. "Stiff: a dashpot" starts off the slow motion, at rest: its velocity jumps
at once.

Not in the race: TR-BDF2, extrapolation methods, Taylor series, Gauss 6, Tsit5, Vern9; and solvers that are compiled
with their right-hand side, such as numbalsoda, which has had no release since 2022.
"""
HEAD = ["method", "evaluations", "Python", "× app", "× doubles", "compiled", "× doubles", "best error"]


def write_tables(folder: Path, report: Report) -> None:
    (folder / "error_vs_time.md").write_text(markdown(report), encoding="utf-8")
    skipped = ("error_growth", "energy_growth", "mode_errors")
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
    """Findings; tables of the price of errors on each system, of the length of the run, and of the digits."""
    lines = ["# Error against run time", "", *(f"- {value}" for value in report.about.values()), ""]
    lines += ["## Found", "", *(f"- {each}" for each in findings(report.runs)), RULES]
    lines += [*_rounding(report), *methods_table()]
    for slug, many in report.runs.items():
        lines += [
            f"## {SYSTEMS[slug].name}",
            "",
            described(SYSTEMS[slug]),
            "",
            limits(SYSTEMS[slug], many),
            "",
            f"![]({slug}.png)",
            "",
        ]
        for wanted in WANTED:
            lines += [f"An error of {wanted:g} costs:", "", *_price_table(many, wanted)]
        lines += ["What runs reach:", "", *_reached_table(many)]
    lines += ["## Length of the run", "", "In Python, 2,800 evaluations a slow period or rtol 1e-6, 100 outputs.", ""]
    lines += [*_length_table(report.length), ""]
    if report.both_ways:
        lines += ["## A step as one matrix", "", MATRIX, "", *_both_ways_table(report.both_ways), ""]
    lines += ["## Where 80 digits matter, and what they cost", "", *_digits_table(report), ""]
    return "\n".join(lines)


def _rounding(report: Report) -> list[str]:
    """Return the sentence on how far evaluations differ with rounding, as `make bench ARGS=--count` counts them."""
    if not report.rounding:
        return []
    spreads = sorted(report.rounding, key=lambda spread: spread.share)
    told = [
        f"{METHODS[one.method].mark} {100 * one.share:.2g} %"
        + (f" ({SYSTEMS[one.system].name}, rtol {one.setting:g})" if one.share else "")
        for one in spreads
    ]
    text = "How far evaluations differ with rounding: from three starts next to each other in the last place, at rtol "
    text += f"1e-3, 1e-6 and 1e-9 in all runs that ended, at most by {', '.join(told)} (make bench ARGS=--count)."
    return [text, ""]


def _once_more(runs: list[Run]) -> list[Run]:
    """The runs with the times that they took when the benchmark was run again, and without those not timed then."""
    return [replace(run, time=run.again) for run in runs if run.again or run.failure]


def _price_table(runs: list[Run], wanted: float) -> list[str]:
    first, second = _quotes(runs, wanted), _quotes(_once_more(runs), wanted)
    lines = [_line(HEAD), _line(["---"] * len(HEAD))]
    for slug, own in grouped(run for run in runs if not run.compiled).items():
        python, compiled = first.get((slug, False)), first.get((slug, True))
        told = [price for price in (python, compiled) if price and price.evaluations is not None]
        cells = [doc_name(slug), evaluations_text(slug, told[0].evaluations if told else None)]
        for kind, price in ((False, python), (True, compiled)):
            failed = next((run for run in reversed(own) if run.failure), None) if not kind else None
            cells += _price_cells(price, kind, first, second.get((slug, kind)), second, failed)
        lines.append(_line([*cells, _best(python, compiled)]))
    return [*lines, ""]


def _best(python: Price | None, compiled: Price | None) -> str:
    """The best error of a method where it is not good enough, in Python and compiled."""
    late = ((" compiled" if price is compiled else "", price) for price in (python, compiled) if price)
    return ", ".join(f"{price.best:.1e}{kind}" for kind, price in late if price.time is None)


Quotes = dict[tuple[str, bool], Price]
"""Prices by method and by whether it was compiled."""


def _quotes(runs: list[Run], wanted: float) -> Quotes:
    found: Quotes = {}
    for kind in (False, True):
        many = grouped(run for run in runs if run.compiled == kind).values()
        found |= {(price.method, kind): price for price in prices(many, wanted)}
    return found


def _price_cells(
    price: Price | None, compiled: bool, first: Quotes, second: Price | None, others: Quotes, failed: Run | None
) -> list[str]:
    """Time and ratios, or why there is none."""
    none = [""] * (1 if compiled else 2)
    if price is None:
        return [f"none: {failed.failure}" if failed else "", *none]
    if price.time is None:
        return [NOT_REACHED.get(price.end, "not refined so far"), *none]
    marks = " °" * (compiled and price.method in IN_PYTHON) + " †" * (price.repeats is False)
    units = zip(_units(first, compiled), _units(others, compiled), strict=True)
    return [time_text(price.time) + marks, *(_ratio(price, second, one, two) for one, two in units)]


def _units(quotes: Quotes, compiled: bool) -> list[float | None]:
    """Run times of the closed form: in Python as the app runs it, and in doubles in the same language."""
    same = {slug: price for (slug, kind), price in quotes.items() if kind == compiled}
    found = [in_doubles(same)] if compiled else [same.get("closed"), in_doubles(same)]
    return [price.time if price else None for price in found]


def _ratio(price: Price, second: Price | None, unit: float | None, other: float | None) -> str:
    """The ratio, and that of the second benchmark in brackets."""
    if not unit or price.time is None:
        return ""
    ratio = price.time / unit
    if second is None or second.time is None or not other:
        return f"{ratio:.3g}"
    again = second.time / other
    mark = "" if max(ratio, again) <= APART * min(ratio, again) else " ‡"
    return f"{ratio:.3g} ({again:.3g}){mark}"


def doc_name(slug: str) -> str:
    """A method, and whether its equations are solved in advance."""
    method = METHODS[slug]
    return f"{method.name}{', systems solved in advance' if method.solved else ''}"


def evaluations_text(slug: str, evaluations: float | None) -> str:
    """Evaluations, or outputs of a method that has none."""
    if evaluations is None:
        return ""
    return f"{evaluations:.3g}{' outputs' if METHODS[slug].family in ('closed', 'exact') else ''}"


def _reached_table(runs: list[Run]) -> list[str]:
    """Solvers at three tolerances; fixed steps at the first run with an error of 1e-6, or their finest."""
    modes = any(run.mode_errors for run in runs)
    head = ["method", "asked", "evaluations", "Jacobians", "LU", "solves", "largest error", "at the end"]
    head += ["slow mode", "fast mode"] if modes else []
    lines = [_line(head), _line(["---"] * len(head))]
    for slug, own in grouped(run for run in runs if run.error is not None).items():
        for run in _telling(own):
            told = [error for error in (run.error, run.final_error, *run.mode_errors) if error is not None]
            bdf = f", {100 * run.stiff_share:.0f} % of steps by BDF" if slug == "lsoda" else ""
            costs = [evaluations_text(slug, run.evaluations), *_costs(run)]
            cells = [METHODS[slug].name, setting_text(run) + bdf, *costs, *(f"{error:.1e}" for error in told)]
            lines.append(_line(cells))
    return [*lines, ""]


def _costs(run: Run) -> list[str]:
    """Jacobians, factorisations and solves, each where there are any."""
    return [f"{count:.3g}" if count else "" for count in (run.jacobians, run.factorisations, run.solves)]


def _telling(runs: list[Run]) -> list[Run]:
    if runs[0].family == "adaptive":
        return [run for run in runs if run.setting in ASKED]
    return [at_error(runs, 1e-6) or min(runs, key=lambda run: run.error or 0.0)]


def _length_table(runs: list[Run]) -> list[str]:
    spans = sorted({run.setting for run in runs})
    shown = [span for span in spans if span in (5, 50, 500)]
    lines = [_line(["method", *(f"{span:g} periods" for span in shown)]), _line(["---"] * (len(shown) + 1))]
    for slug in dict.fromkeys(run.method for run in runs):
        by_span = {run.setting: run for run in runs if run.method == slug}
        texts = [_outcome(by_span[span]) for span in shown]
        lines.append(_line([METHODS[slug].name, *texts]))
    return lines


def _outcome(run: Run) -> str:
    return run.failure or f"{time_text(run.time)}, {run.evaluations} evaluations, error {run.error:.1e}"


MATRIX = (
    "Nanoseconds a step on the benign chain, the least of eight: by the right-hand side, and as one constant matrix of "
    "16 numbers, which is the same for every method."
)


def _both_ways_table(rows: list[dict[str, object]]) -> list[str]:
    names = [name for name in rows[0] if name != "method"]
    lines = [_line(["method", *names]), _line(["---"] * (len(names) + 1))]
    return lines + [_line([METHODS[str(row["method"])].name, *(f"{row[name]}" for name in names)]) for row in rows]


def _digits_table(report: Report) -> list[str]:
    lines = [_line(["motion", "80 digits alone", "closed form", "eigh"]), _line(["---"] * 4)]
    for each in report.costs:
        lines.append(_line([each["motion"], *(f"{each[name]:.3g} ms" for name in ("digits", "closed", "eigh"))]))
    for sweep, curves in report.digits.items():
        names = [name for name in curves if name != "x"]
        lines += ["", _line([sweep, *(METHODS[name].name for name in names)]), _line(["---"] * (len(names) + 1))]
        for row in zip(*curves.values(), strict=True):
            lines.append(_line([f"{row[0]:.0e}", *("none" if e is None else f"{e:.0e}" for e in row[1:])]))
    return lines


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def setting_text(run: Run) -> str:
    return SETTINGS[run.family].format(run.setting, ATOL * run.setting)


def time_text(seconds: float | None) -> str:
    return f"{1e3 * (seconds or 0):.3g} ms" if (seconds or 0) < 1 else f"{seconds:.3g} s"


def limits(system: System, runs: list[Run]) -> str:
    """The name of a motion, with |lambda| h at the limits of accuracy and of stability."""
    found = stiffness(system, runs)
    if found is None:
        return ""
    name = "Neither stiff nor highly oscillatory" if found.kind == "neither" else found.kind.capitalize()
    return f"{name}: accuracy allows |λ| h = {found.accurate:.2g}, stability {found.stable:.3g}."


def described(system: System) -> str:
    """The system in numbers."""
    chain, (slow, fast) = system.chain, system.rates
    text = f"m1 = {chain.m1:g} kg, m2 = {chain.m2:g} kg, k1 = {chain.k1:g} N/m, k2 = {chain.k2:g} N/m; "
    text += f"x(0) = {system.x_0} m, v(0) = {system.v_0} m/s"
    text += f"; {system.F_0:g} N sin({system.omega!r} t)" if system.F_0 else ""
    if system.c:
        return f"{text}; a dashpot of {system.c:.7g} N s/m beside spring 1; rates of decay {slow:g} and {fast:g} 1/s"
    return f"{text}; periods {2 * pi / slow:.3g} s and {2 * pi / fast:.3g} s"

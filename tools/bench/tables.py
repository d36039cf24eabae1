"""The benchmark in words and numbers: Markdown for people, CSV for machines."""

from __future__ import annotations

import csv
from itertools import zip_longest
from math import pi
from pathlib import Path

from physics.integrators.accuracy import SYSTEMS, Run, System, entered
from physics.integrators.price import at_error, grouped
from physics.integrators.solvers import METHODS
from physics.integrators.stiffness import stiffness
from tools.bench.estimates import checked
from tools.bench.findings import findings
from tools.bench.methods import methods_table
from tools.bench.price_table import evaluations_text, line, price_table, setting_text, time_text
from tools.bench.record import Report

WANTED = (1e-3, 1e-6, 1e-9)
ASKED = (1e-3, 1e-6, 1e-9)
FEW = 4
INTRODUCTION = """Many methods compute the same motions of two masses on springs. The tables show the cost of a digit.
For each method the tables have the error and the time that it takes. A method that goes in steps takes longer for every
further digit; the closed form does not. The scene `accuracy` shows the same record."""
RULES = """
## How to read it

**Runs.** Each method is refined until its error no longer falls, it has no finer setting, or a run passes the time
limit. All methods on all systems are refined side by side; then the quick runs are timed again in further rounds. Each
method runs twice: as Python runs it, and compiled by numba (the time of compiling is not counted). With fixed steps,
and for the closed form in doubles, the same functions are compiled as a whole. Of a solver that chooses its steps, only
the right-hand side is compiled. LSODA, VODE-Adams and the second DOP853 are compiled code in SciPy; RK23, RK45, DOP853,
Radau and BDF are Python and stay Python, which ° marks. The closed form in 80 digits, the naive modes and expm were not
compiled. {unmeasured}

**Times** are processor time of one thread, so that other programs on the machine disturb them little. They are relative
to a fixed piece of work that is timed just before and after. The columns × are ratios to the closed form: × app to the
closed form as the app runs it, in 80 digits where it needs them; × doubles to the closed form in plain doubles, which
is the modes by eigh, and for the dashpot the formulas as they are. Python is divided by Python, compiled by compiled.
† marks a time that did not repeat within 20 % in its rounds. The number in brackets is the same ratio in a second
recording; ‡ marks a ratio that differs from it by more than 30 %. What was recorded later was timed beside some methods
of the first recording, and its times are scaled by theirs.

**The price of an error** is the least run time at which the straight lines from run to run, both axes logarithmic,
have that error, as in the accuracy scene. "never" means that more steps do not help: the error of the method no longer
falls, it has no finer setting, or its steps would be shorter than the spacing of doubles. The last column then has the
best error.

**"about" and "at least"** mark prices that were not measured, because a run would have taken longer than the time
limit. They are estimates from the record: along the line of the method, by its order; or from the Benign chain, with as
many evaluations in each fast oscillation; or, where stability limits the step, from the share of the motion that a run
had done when it was stopped. {checked} The time is that of so many evaluations.

**Evaluations** of the right-hand side do not depend on the speed of a machine. With solvers that choose their steps
they differ with its rounding, as the last paragraph here says. Methods without steps have outputs instead. Radau, BDF
and LSODA get the constant Jacobian, but factorise their systems again whenever the step changes. Implicit methods with
fixed steps use one constant matrix; the tables count one factorisation for the whole run, and one linear solve a step
for all stages of the step. The inverse is computed in advance. Newmark with the average acceleration and the implicit
midpoint are one method where nothing drives the chain. The second DOP853 has no interpolation between its steps, so it
is restarted at each of the 1,000 outputs. Where that makes its coarsest run better than asked, further digits cost it
nothing.

**Errors** are the largest over the 1,000 outputs, in units of the largest displacement; with the dashpot also of the
velocity, in units of the largest velocity. "What runs reach" has further errors: at the last output alone, where no
interpolation is involved (an error of the phase may happen to be small there), and in the slow and in the fast mode.
"Asked" is the tolerance, which a solver keeps in each step, not at the end: rtol, and atol in units of the largest
displacement (for velocities, of that times the slow rate). With fixed steps it has the first run with an error of 1e-6,
or else the one with the least error. Radau solves a real and a complex system in each iteration. LSODA factorises once
for each Jacobian and does not report its solves. The outputs see every phase of the fast oscillations: if they saw only
one, an error of the phase would hide. So Wide apart, 1e6 and Light mass 2 last a little longer than 50 periods.

**One matrix.** On this linear problem a step of any method is one constant 4 x 4 matrix, and so are many steps at once.
Then all methods cost the same a step, but nothing of that is true of another problem. So explicit methods evaluate the
right-hand side as they would anywhere; implicit ones with fixed steps use the constant matrix, as codes for linear
structures do, and the tables say so. "A step as one matrix" below measures both ways.

**Stiff or highly oscillatory.** A motion is stiff if stability, not accuracy, limits the step of an explicit method
(Hairer and Wanner, Solving Ordinary Differential Equations II, IV.1). It is highly oscillatory if accuracy limits the
step because a fast oscillation, which nothing damps, carries part of the motion: only a method that solves it exactly
can step over it. The measure is |λ| h, the fast rate times the step. The limit of accuracy is the step at which
Gauss 4, which is stable at every step, has an error of 1e-3. The limit of stability is that of RK4, which has the same
order. If accuracy allows more than stability, the motion is stiff. Each system below has both limits. "Stiff: a
dashpot" starts at rest, off the slow motion: its velocity jumps at once.

**Not measured:** TR-BDF2, extrapolation methods, Taylor series, Gauss 6, Tsit5, Vern9; and solvers that are compiled
with their right-hand side, such as numbalsoda, which has had no release since 2022.
"""


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
    lines = ["# Error against run time", "", INTRODUCTION, ""]
    lines += [f"- {'recorded ' if name == 'date' else ''}{value}" for name, value in report.about.items()]
    lines += [*(f"- {SYSTEMS[slug].name}: recorded again {date}" for slug, date in report.later.items()), ""]
    lines += ["## Found", "", *(f"- {each}" for each in findings(report.runs)), _rules(report)]
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
            lines += [f"An error of {wanted:g} costs:", "", *price_table(many, wanted, report.runs)]
        lines += ["What runs reach:", "", *reached_table(many)]
    lines += ["## Length of the run", "", "In Python, 2,800 evaluations a slow period or rtol 1e-6, 100 outputs.", ""]
    lines += [*_length_table(report.length), ""]
    if report.both_ways:
        lines += ["## A step as one matrix", "", MATRIX, "", *_both_ways_table(report.both_ways), ""]
    lines += ["## Where 80 digits matter, and what they cost", "", *_digits_table(report), ""]
    return "\n".join(lines)


def _rules(report: Report) -> str:
    """The rules of the tables, with what the record says of them."""
    ratios, told = checked(report.runs, WANTED), ""
    if ratios:
        told = (
            f"{len(ratios)} such prices on the highly oscillatory motions were measured too: there the estimates from "
        )
        told += f"Benign are {min(ratios):.2g} to {max(ratios):.2g} times what was measured."
    return RULES.format(unmeasured=_unmeasured(report), checked=told)


def _unmeasured(report: Report) -> str:
    """Return a sentence on empty cells, which belong to methods that were compiled for some systems only."""
    compiled = {run.method for many in report.runs.values() for run in many if run.compiled}
    missing: dict[tuple[str, ...], list[str]] = {}
    for slug, many in report.runs.items():
        asked = [name for name in entered(SYSTEMS[slug]) if name in compiled]
        if lacks := tuple(name for name in asked if name not in {run.method for run in many if run.compiled}):
            missing.setdefault(lacks, []).append(SYSTEMS[slug].name)
    told = [
        f"{', '.join(METHODS[name].mark for name in lacks)} on {' and '.join(systems)}"
        for lacks, systems in missing.items()
    ]
    return f"Not compiled, so that their times are estimates: {'; '.join(told)}." if told else ""


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


def reached_table(runs: list[Run]) -> list[str]:
    """Solvers at three tolerances; fixed steps at the first run with an error of 1e-6, or their finest."""
    modes = any(run.mode_errors for run in runs)
    head = ["method", "asked", "evaluations", "Jacobians", "LU", "solves", "largest error", "at the end"]
    head += ["slow mode", "fast mode"] if modes else []
    lines = [line(head), line(["---"] * len(head))]
    for slug, own in grouped(run for run in runs if run.error is not None).items():
        for run in _telling(own):
            told = [error for error in (run.error, run.final_error, *run.mode_errors) if error is not None]
            bdf = f", {100 * run.stiff_share:.0f} % of steps by BDF" if slug == "lsoda" else ""
            costs = [evaluations_text(slug, run.evaluations), *_costs(run)]
            cells = [METHODS[slug].name, setting_text(run) + bdf, *costs, *(f"{error:.1e}" for error in told)]
            lines.append(line(cells))
    return [*lines, ""]


def _costs(run: Run) -> list[str]:
    """Jacobians, factorisations and solves, each where there are any."""
    return [f"{count:.3g}" if count else "" for count in (run.jacobians, run.factorisations, run.solves)]


def _telling(runs: list[Run]) -> list[Run]:
    """The runs of one method that the table has: of a solver one for each tolerance, all of them if there are few."""
    if runs[0].family != "adaptive":
        return [at_error(runs, 1e-6) or min(runs, key=lambda run: run.error or 0.0)]
    first = {run.setting: run for run in reversed(runs)}
    return [first[setting] for setting in sorted(first, reverse=True) if setting in ASKED or len(first) <= FEW]


def _length_table(runs: list[Run]) -> list[str]:
    spans = sorted({run.setting for run in runs})
    shown = [span for span in spans if span in (5, 50, 500)]
    lines = [line(["method", *(f"{span:g} periods" for span in shown)]), line(["---"] * (len(shown) + 1))]
    for slug in dict.fromkeys(run.method for run in runs):
        by_span = {run.setting: run for run in runs if run.method == slug}
        texts = [_outcome(by_span[span]) for span in shown]
        lines.append(line([METHODS[slug].name, *texts]))
    return lines


def _outcome(run: Run) -> str:
    return run.failure or f"{time_text(run.time)}, {run.evaluations} evaluations, error {run.error:.1e}"


MATRIX = (
    "Nanoseconds a step on the benign chain, the least of eight: by the right-hand side, and as one constant matrix of "
    "16 numbers, which is the same for every method."
)


def _both_ways_table(rows: list[dict[str, object]]) -> list[str]:
    names = [name for name in rows[0] if name != "method"]
    lines = [line(["method", *names]), line(["---"] * (len(names) + 1))]
    return lines + [line([METHODS[str(row["method"])].name, *(f"{row[name]}" for name in names)]) for row in rows]


def _digits_table(report: Report) -> list[str]:
    lines = [line(["motion", "80 digits alone", "closed form", "eigh"]), line(["---"] * 4)]
    for each in report.costs:
        lines.append(line([each["motion"], *(f"{each[name]:.3g} ms" for name in ("digits", "closed", "eigh"))]))
    for sweep, curves in report.digits.items():
        names = [name for name in curves if name != "x"]
        lines += ["", line([sweep, *(METHODS[name].name for name in names)]), line(["---"] * (len(names) + 1))]
        for row in zip(*curves.values(), strict=True):
            lines.append(line([f"{row[0]:.0e}", *("none" if e is None else f"{e:.0e}" for e in row[1:])]))
    return lines


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

"""Findings of the benchmark, in sentences whose names and numbers are read off the runs."""

from __future__ import annotations

from collections.abc import Iterator

from physics.integrators.accuracy import SYSTEMS
from physics.integrators.exponential_steps import EXPONENTIAL
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.price import Price, grouped, in_doubles, prices
from physics.integrators.solvers import METHODS
from physics.integrators.stiffness import stiffness
from tools.bench.estimates import RunsBySystem, estimate

SWINGING = tuple(slug for slug, method in METHODS.items() if method.family in ("fixed", "adaptive"))
WANTED = (1e-3, 1e-6, 1e-9)
EXPLICIT = (
    *(slug for slug, step in STEPPING.items() if not step.solved and not step.splits),
    "rk23",
    "rk45",
    "dop853",
    "fortran",
    "adams",
)
"""VODE-Adams iterates to a fixed point: it is bound as explicit methods are."""
IMPLICIT = (*(slug for slug, step in STEPPING.items() if step.solved), "radau", "bdf", "lsoda")


def findings(runs: RunsBySystem) -> list[str]:
    """Sentences on the systems that were measured."""
    found = [*_pays(runs), _closed(runs), _compiling(runs), *_stability(runs)]
    found += [*_oscillatory(runs), *_ringing(runs), *_switching(runs)]
    return [each for each in found if each]


def quoted(runs: RunsBySystem, slug: str, wanted: float, compiled: bool) -> dict[str, Price]:
    """Return the costs of a system by method, without those that were not reached."""
    many = grouped(run for run in runs[slug] if run.compiled == compiled).values()
    return {price.method: price for price in prices(many, wanted) if price.time is not None}


def _stepping(runs: RunsBySystem, slug: str, wanted: float, compiled: bool) -> dict[str, Price]:
    """Return the costs of the stepping methods."""
    priced = quoted(runs, slug, wanted, compiled)
    return {name: price for name, price in priced.items() if METHODS[name].family in ("fixed", "adaptive")}


def _pays(runs: RunsBySystem) -> Iterator[str]:
    """The cheapest stepping on the benign chain."""
    if "benign" not in runs:
        return
    for compiled, kind in ((False, "in Python"), (True, "compiled")):
        for wanted in WANTED:
            if stepping := _stepping(runs, "benign", wanted, compiled):
                best = min(stepping.values(), key=lambda price: price.time or 0.0)
                yield f"Benign, an error of {wanted:g}, {kind}: {_named(runs, 'benign', best, wanted)}."


def _named(runs: RunsBySystem, slug: str, best: Price, wanted: float) -> str:
    """The cheapest method, its time, and its ratios to the closed form in the same language."""
    units = _units(runs, slug, wanted, best.compiled)
    text = f"{best.name} is the cheapest method with steps: {1e3 * (best.time or 0.0):.3g} ms"
    told = (f"{(best.time or 0.0) / (unit.time or 1.0):.2g} times the closed form {how}" for how, unit in units.items())
    return ", ".join([text, " and ".join(told)])


def _units(runs: RunsBySystem, slug: str, wanted: float, compiled: bool) -> dict[str, Price]:
    """The closed form: as the app runs it, in Python only, and in doubles."""
    priced = quoted(runs, slug, wanted, compiled)
    units = {"as the app runs it": priced.get("closed"), "in doubles": in_doubles(priced)}
    return {f"{how}{', compiled' if compiled else ''}": unit for how, unit in units.items() if unit}


def _closed(runs: RunsBySystem) -> str:
    """Return where stepping is cheaper than the closed form in the same language."""
    kinds = ((False, "as the app runs it"), (False, "in doubles"), (True, "in doubles, compiled"))
    cheaper: dict[str, dict[str, list[str]]] = {how: {} for _, how in kinds}
    for slug in runs:
        for wanted in WANTED:
            for compiled, how in kinds:
                times = [price.time or 0.0 for price in _stepping(runs, slug, wanted, compiled).values()]
                unit = _units(runs, slug, wanted, compiled).get(how)
                if unit and times and min(times) < (unit.time or 0.0):
                    cheaper[how].setdefault(SYSTEMS[slug].name, []).append(f"{wanted:g}")
    return " ".join(_cheaper_text(how, where) for how, where in cheaper.items())


def _cheaper_text(how: str, where: dict[str, list[str]]) -> str:
    language = "Compiled" if "compiled" in how else "In Python"
    unit = f"the closed form {how.removesuffix(', compiled')}"
    if not where:
        return f"{language}, no method with steps is cheaper than {unit}."
    systems = "; ".join(f"{name} at {' and '.join(errors)}" for name, errors in where.items())
    return f"{language}, a method with steps is cheaper than {unit} on {systems}."


def _compiling(runs: RunsBySystem) -> str:
    """Ratios of the times in Python and compiled."""
    ratios = []
    for slug in runs:
        for wanted in WANTED:
            python, compiled = (quoted(runs, slug, wanted, kind) for kind in (False, True))
            ratios += [
                (python[name].time or 0.0) / (compiled[name].time or 1.0)
                for name in python.keys() & compiled
                if name in STEPPING
            ]
    if not ratios:
        return ""
    return f"The same fixed steps take {min(ratios):.0f} to {max(ratios):.0f} times as long in Python as compiled."


def _stability(runs: RunsBySystem) -> Iterator[str]:
    """The evaluations of explicit methods where the fast part is at rest or dies at once, next to all implicit ones.

    Each method counts as it needs fewest, in Python or compiled.
    """
    for slug in runs:
        found = stiffness(SYSTEMS[slug], runs[slug])
        if not found or found.kind != "stiff":
            continue
        for wanted in WANTED:
            least = _least_evaluations(runs, slug, wanted)
            explicit, implicit = (
                sorted((count, name) for name, count in least.items() if (name in kind))
                for kind in (EXPLICIT, IMPLICIT)
            )
            if explicit and implicit:
                (one, first), (other, best) = explicit[0], implicit[0]
                yield (
                    f"{SYSTEMS[slug].name}, an error of {wanted:g}: the best explicit method, {METHODS[first].name}, "
                    f"needs {one:.2e} evaluations, {one / other:.1g} times as many as the best implicit method, "
                    f"{METHODS[best].name} ({other:.2e})."
                )
            elif implicit:
                yield f"{SYSTEMS[slug].name}, an error of {wanted:g}: no explicit method has it within the time limit."


def _oscillatory(runs: RunsBySystem) -> Iterator[str]:
    """The evaluations of exponential integrators where a fast swing carries part of the motion, next to all others."""
    for slug in runs:
        found = stiffness(SYSTEMS[slug], runs[slug])
        if not found or found.kind != "highly oscillatory":
            continue
        for wanted in WANTED:
            least = {name: count for name, count in _least_evaluations(runs, slug, wanted).items() if name in SWINGING}
            told = f"{SYSTEMS[slug].name}, an error of {wanted:g}: "
            exact = sorted((count, name) for name, count in least.items() if name in EXPONENTIAL)
            guesses = ((estimate(runs, slug, name, wanted), name) for name in EXPONENTIAL)
            guessed = sorted((guess.evaluations, name) for guess, name in guesses if guess)
            others = sorted((count, name) for name, count in least.items() if name not in EXPONENTIAL)
            if others and (exact or guessed):
                (one, first), (other, best) = (exact or guessed)[0], others[0]
                yield (
                    f"{told}{METHODS[first].name}, which solves the stiff spring exactly, needs "
                    f"{'' if exact else 'about '}{one:.2e} evaluations. The best of the others, {METHODS[best].name}, "
                    f"needs {other:.2e}."
                )


def _least_evaluations(runs: RunsBySystem, slug: str, wanted: float) -> dict[str, float]:
    """Return the evaluations that each method needs for an error: the smaller number of Python and compiled."""
    found: dict[str, float] = {}
    for compiled in (False, True):
        for name, price in quoted(runs, slug, wanted, compiled).items():
            count = price.evaluations or 0.0
            found[name] = min(found.get(name, count), count)
    return found


def _ringing(runs: RunsBySystem) -> Iterator[str]:
    """Errors where the fast part should be gone at once: with one step an output, and with the first tolerances."""
    for slug in (one for one in IMPLICIT if one != "lsoda"):
        good = [run for run in runs.get("dashpot", ()) if run.method == slug and not run.compiled and not run.failure]
        if good:
            run = good[0]
            how = f" at rtol {run.setting:g}" if run.family == "adaptive" else ""
            yield (
                f"Stiff: a dashpot, the longest steps: {run.name} takes {run.steps} steps{how}. Its largest error is "
                f"{run.error:.2g}, its error at the end {run.final_error:.2g}."
            )


def _switching(runs: RunsBySystem) -> Iterator[str]:
    """Return where LSODA switches to the formulas for stiff equations although nothing decays."""
    for slug, many in runs.items():
        stiff = [run for run in many if run.method == "lsoda" and run.stiff_share > 0.5 and not run.compiled]
        if stiff and not SYSTEMS[slug].c:
            shares = ", ".join(f"rtol {run.setting:g}" for run in stiff)
            yield f"{SYSTEMS[slug].name}: at {shares} LSODA takes most of its steps by BDF: a kink in its line."

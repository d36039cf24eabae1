"""The words of the accuracy scene: live numbers, and which sentences and views stand."""

from __future__ import annotations

import math
from functools import cache
from itertools import product

from components.quantities.declared import Declared, Family, Form, LiveNumber, by_name
from components.quantities.formatting import short, three
from components.scenes.accuracy.case import DRIFTING, AccuracyCase
from components.scenes.accuracy.data import reached_text
from components.scenes.accuracy.measurement import SCALE
from components.scenes.accuracy.prices import power, time_text
from components.scenes.accuracy.recorded import Recorded, recorded, records
from physics.integrators.accuracy import SYSTEMS, System
from physics.integrators.solvers import METHODS
from physics.integrators.stability import stable_count
from physics.integrators.stiffness import Stiffness, stiffness

CONTROLLED = ("drift", "time", "growth")
"""The views with their own controls."""
RACING = ("time", "growth", "digits")
"""The views that use the accepted error."""
ROWS = len(METHODS)
CELLS = ("name", "evaluations", "time", "ratio")

number, form = LiveNumber[AccuracyCase], Form[AccuracyCase]


def _system_text(system: System) -> str:
    """The motion in a line."""
    chain, (slow, fast) = system.chain, system.rates
    if system.c:
        text = f"m = {power(chain.m1)}, k = {power(chain.k1)}, c = {power(system.c)}{_drive_text(system)}"
        text += f". Rates of decay 1 to {power(fast / slow)}"
    else:
        names = ("m1", "m2", "k1", "k2")
        text = ", ".join(f"{name} = {short(getattr(chain, name))}" for name in names)
        text += f"{_drive_text(system)}. Fast over slow frequency {three(fast / slow) if slow else '∞'}"
    return f"{text}. {short(system.periods)} {system.unit}, 1000 outputs."


def _kind_text(case: AccuracyCase) -> str:
    """The sentence on what limits the step of a system that is on record."""
    found = _measure(case.system.slug)
    if found is None:
        return ""
    name = "Neither stiff nor highly oscillatory" if found.kind == "neither" else found.kind.capitalize()
    accurate, stable = short(found.accurate), short(found.stable)
    return f"{name}: step times fast rate may be {accurate} for accuracy, {stable} for stability."


@cache
def _measure(slug: str) -> Stiffness | None:
    record = records(slug)
    return stiffness(SYSTEMS[slug], (*record.runs.every, *record.compiled.every)) if record else None


def _drive_text(system: System) -> str:
    """The drive: force and frequency, near the slow one by how far it is from it."""
    if not system.F_0:
        return ""
    slow = system.rates[0]
    off = system.omega / slow - 1 if slow and not system.c else 1.0
    at = f"{short(system.omega)} rad/s" if abs(off) > 1e-3 else f"ω₋ · (1 + {power(off)})" if off else "ω₋"
    return f", driven by {power(system.F_0)} N at {at}"


def _compared_text(case: AccuracyCase) -> str:
    """Which runs the growth compares."""
    if case.equal == "error":
        return f"At equal error: of each method the first run with an error of {power(case.wanted)} at the most."
    return f"At equal cost: of each method the finest run within {time_text(case.cost)}."


def _missing(case: AccuracyCase) -> str:
    missing = [METHODS[slug].mark for slug in case.racing if slug not in case.compared]
    return f"Without such a run: {', '.join(missing)}." if missing else ""


def _drift_text(case: AccuracyCase) -> str:
    """A sentence on how far each method strays, and on the least steps of those that need more."""
    told = [f"{METHODS[slug].mark} {_strayed(drift.error)}" for slug, drift in case.drifts.items()]
    period = case.system.problem(1, 1)
    least = {slug: count for slug in case.drifts if (count := stable_count(slug, period)) > case.steps}
    needs = [f"{METHODS[slug].mark} {short(count)}" for slug, count in least.items()]
    more = f" To stay stable, more steps a period are needed: {', '.join(needs)}." if needs else ""
    return f"With {case.steps:.0f} steps a period, at worst: {', '.join(told)}.{more}"


def _strayed(error: float) -> str:
    if math.isinf(error):
        return "explodes"
    return f"is {short(float(f'{100 * error:.1g}'))} % off"


def _record(case: AccuracyCase) -> Recorded:
    return records(case.system.slug) or recorded(SCALE)


class Numbers(Declared[AccuracyCase]):
    drifted = number(_drift_text)
    wanted = number(lambda c: power(c.wanted))
    limit = number(lambda c: time_text(c.limit))
    system = number(lambda c: _system_text(c.system))
    kind = number(_kind_text)
    origin = number(lambda c: _record(c).origin)
    recorded_limit = number(lambda c: _record(c).limit)
    length_origin = number(lambda c: recorded("length").origin)
    compared = number(_compared_text)
    missing = number(_missing)
    unreached = number(lambda c: c.unreached)
    switched = number(lambda c: c.switched)
    picked = number(lambda c: reached_text(c.run) if c.run else "")
    picked_method = number(lambda c: METHODS[c.run.method].mark if c.run else "")


class Facts(Declared[AccuracyCase]):
    """The numbers of the scene; the page shows them in sentences and plots."""

    slow = number(lambda c: c.system.rates[0], unit="1/s", meaning="slow natural frequency, or slow rate of decay")
    fast = number(lambda c: c.system.rates[1], unit="1/s", meaning="fast natural frequency, or fast rate of decay")
    drift = Family(
        DRIFTING,
        lambda method: number(
            lambda c: c.drifts[method].error if method in c.drifts else None,
            meaning=f"largest error of {METHODS[method].name} in four slow periods, over the largest displacement",
        ),
    )
    picked_error = number(lambda c: c.run.error if c.run else None, meaning="error of the chosen run")
    picked_time = number(lambda c: c.run.time if c.run else None, unit="s", meaning="run time of the chosen run")
    picked_evaluations = number(lambda c: c.run.evaluations if c.run else None, meaning="evaluations of the chosen run")


class Cells(Declared[AccuracyCase]):
    """The cells of the list of prices, by row and name."""

    price = Family(product(range(ROWS), CELLS), lambda cell: number(lambda c: None), "price{}_{}")


def cell_texts(case: AccuracyCase) -> dict[str, str]:
    """The cells of the rows that there are."""
    cells = enumerate(cells for _, cells in case.rows)
    return by_name({Cells.price[i, cell]: text for i, row in cells for cell, text in zip(CELLS, row, strict=True)})


def _read(case: AccuracyCase, row: int) -> str:
    """Where a row of the prices is from: read from records it is quiet where others were measured here."""
    if row >= len(case.rows):
        return ""
    return "before" if case.known.here.every and not case.known.is_here(case.rows[row][0]) else "here"


_ORIGINS = {(True, True): "both", (True, False): "here", (False, True): "before", (False, False): "none"}


class Forms(Declared[AccuracyCase]):
    view = Family(CONTROLLED, lambda one: form(lambda c: c.view == one), "{}")
    cost = form(lambda c: (c.view, c.equal) == ("growth", "cost"))
    compiled = form(lambda c: c.clock == "compiled")
    in_units = form(lambda c: (c.view, c.clock) == ("time", "python"))
    switched = form(lambda c: bool(c.switched))
    races = form(lambda c: c.view in RACING)
    unreached = form(lambda c: bool(c.unreached))
    costs = form(lambda c: bool(c.rows))
    unsteady = form(lambda c: any("±" in cell for _, cells in c.rows for cell in cells))
    kept = form(lambda c: c.clock == "python" and c.run is not None and bool(c.run.error_growth))
    origin = form(lambda c: _ORIGINS[bool(c.known.here.every), bool(c.known.before.every)])
    price = Family(range(ROWS), lambda row: form(lambda c: _read(c, row)))

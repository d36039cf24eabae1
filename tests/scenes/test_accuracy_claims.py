"""Claims of the accuracy scene on methods, against the recorded runs: in Python and compiled."""

from __future__ import annotations

import pytest

from components.scenes.accuracy.measuring import LIVE
from components.scenes.accuracy.recorded import recorded
from physics.integrators.accuracy import PERIODS, SYSTEMS, Run
from physics.integrators.exponential_steps import EXPONENTIAL
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.price import Price, prices
from physics.integrators.solvers import METHODS
from physics.integrators.stability import stable_count

WANTED = (1e-3, 1e-6, 1e-9)
both = pytest.mark.parametrize("compiled", [False, True], ids=["python", "compiled"])
IMPLICIT = ("midpoint", "newmark", "gauss4")
SOLVING = [slug for slug, step in STEPPING.items() if step.solved or step.splits]
"""Methods that solve equations, or the coupling spring, exactly: no step of theirs is too long for stability."""


def quoted(slug: str, wanted: float, compiled: bool) -> dict[str, Price]:
    known = recorded(slug)
    found = prices((known.compiled if compiled else known.runs).by_method.values(), wanted)
    return {price.method: price for price in found if price.time is not None}


def stepping(slug: str, wanted: float, compiled: bool) -> dict[str, float]:
    """Evaluations of the adaptive methods, without one that 1,000 restarts make more accurate than asked."""
    found = {name: price for name, price in quoted(slug, wanted, compiled).items() if name != "fortran"}
    return {name: p.evaluations or 0.0 for name, p in found.items() if METHODS[name].family in ("fixed", "adaptive")}


@both
@pytest.mark.parametrize("slug", SYSTEMS)
def test_stepping_pays_for_digits(slug: str, compiled: bool) -> None:
    """But where the fewest stable steps are good enough as they are."""
    coarse, fine = (stepping(slug, wanted, compiled) for wanted in (1e-3, 1e-9))
    for method in coarse.keys() & fine.keys():
        known = recorded(slug)
        runs = (known.compiled if compiled else known.runs).by_method[method]
        first = next(run for run in runs if run.error is not None)
        assert fine[method] > 1.2 * coarse[method] or (first.error or 0.0) < 1e-9, method
    assert {quoted(slug, wanted, False)["closed"].evaluations for wanted in WANTED} == {1001}


@both
def test_frequencies_close_to_each_other_are_no_harder(compiled: bool) -> None:
    beats, benign = (stepping(slug, 1e-6, compiled) for slug in ("beats", "benign"))
    assert all(beats[method] < benign[method] for method in beats.keys() & benign.keys())


@both
def test_where_both_modes_swing_all_swings_are_stepped_through(compiled: bool) -> None:
    for slug, ratio in (("wide", 2000), ("light", 1000)):
        found = stepping(slug, 1e-3, compiled)
        stepped = {name: count for name, count in found.items() if name not in EXPONENTIAL}
        assert all(evaluations > PERIODS * ratio for evaluations in stepped.values())
        exact = [found[name] for name in EXPONENTIAL if name in found]
        assert all(4 * count < min(stepped.values()) for count in exact), "the stiff spring is solved exactly"
        assert exact or not compiled
        for run in (recorded(slug).compiled if compiled else recorded(slug).runs).every:
            if run.method in EXPONENTIAL:
                continue
            if run.error is not None and run.error < 0.5 and METHODS[run.method].family == "fixed":
                assert run.mode_errors[0] < run.mode_errors[1], "the fast mode is lost first"


def test_an_explicit_method_follows_a_mode_at_rest() -> None:
    """The steps that stability alone asks for, and every price that was found, against Gauss 4."""
    gauss = stepping("wider", 1e-6, False)["gauss4"]
    problem = SYSTEMS["wider"].problem()
    for slug, step in STEPPING.items():
        if not step.solved and not step.splits and slug != "euler":
            assert stable_count(slug, problem) * 1000 * step.evaluations > 1000 * gauss, slug
    for compiled in (False, True):
        found = stepping("wider", 1e-6, compiled)
        assert all(found[slug] > 1000 * gauss for slug in found if slug in STEPPING and slug not in SOLVING)


def coarsest(method: str, compiled: bool = False) -> Run:
    known = recorded("dashpot")
    return next(run for run in (known.compiled if compiled else known.runs).by_method[method] if run.error is not None)


def test_long_steps_of_newmark_ring_to_the_end_and_of_radau_and_bdf_not() -> None:
    for compiled in (False, True):
        for method in IMPLICIT:
            run = coarsest(method, compiled)
            assert run.setting == 1 and run.final_error is not None and run.final_error > 0.3
    for method in ("radau", "bdf"):
        run = coarsest(method)
        assert run.steps < 1000 and run.final_error is not None and run.final_error < 0.01


@both
@pytest.mark.parametrize("slug", SYSTEMS)
def test_what_is_seen_at_first_has_the_best_of_each_kind(slug: str, compiled: bool) -> None:
    """By evaluations, within a quarter: what no machine changes. Explicit and implicit are two kinds; what costs ten
    times the best of all wins nowhere, and one step of three evaluations an output is as good as any."""
    for wanted in WANTED:
        found = stepping(slug, wanted, compiled)
        found = {name: cost for name, cost in found.items() if cost < 10 * min(found.values())}
        for family, implicit in (("fixed", False), ("fixed", True), ("adaptive", False)):
            kind = {
                name: cost for name, cost in found.items()
                if METHODS[name].family == family and METHODS[name].solved == implicit
            }  # fmt: skip
            seen = [cost for name, cost in kind.items() if name in LIVE]
            assert not kind or (seen and min(seen) <= max(3000, 1.25 * min(kind.values()))), (wanted, kind)

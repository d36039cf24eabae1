"""The one rule by which prices are read off measured runs."""

from math import sqrt

import pytest

from physics.integrators.accuracy import Run
from physics.integrators.price import at_cost, at_error, grouped, price, prices


def run(method, time, error, evaluations=1000, **more):
    facts = {"time_low": time, "time_high": time, "rounds": 3} | more
    return Run(system="benign", method=method, setting=1, time=time, error=error, evaluations=evaluations, **facts)


COARSE, FINE = run("verlet", 1e-2, 1e-2, 1000), run("verlet", 1e-1, 1e-4, 16000)
LATE = Run(system="benign", method="verlet", setting=9, failure="time limit 1 s", end="time limit")


def test_a_price_between_two_runs_is_read_off_their_line():
    found = price([COARSE, FINE], 1e-3)
    assert found.time == pytest.approx(sqrt(1e-2 * 1e-1))
    assert found.evaluations == pytest.approx(sqrt(1000 * 16000))
    assert found.repeats
    assert (price([COARSE, FINE], 1e-2).time, price([COARSE, FINE], 1e-4).time) == (1e-2, pytest.approx(1e-1))


def test_where_the_first_run_is_good_enough_it_is_the_price():
    assert price([COARSE, FINE], 0.5).time == 1e-2
    assert price([run("closed", 1e-3, 0.0)], 1e-6).time == 1e-3


def test_a_method_that_turns_back_has_its_cheapest_price():
    """LSODA with a finer tolerance may find the stiff formulas that it missed with a coarser one."""
    slow, quick = run("lsoda", 0.5, 1e-7), run("lsoda", 0.05, 1e-8)
    assert price([run("lsoda", 0.02, 1e-5), slow, quick], 1e-6).time == pytest.approx(0.05)
    assert price([run("lsoda", 0.02, 1e-7), run("lsoda", 0.5, 1e-5)], 1e-6).time == 0.02


def test_what_was_not_reached_says_how_near_and_why():
    found = price([COARSE, FINE, LATE], 1e-6)
    assert (found.time, found.evaluations, found.best, found.end) == (None, None, 1e-4, "time limit")


def test_a_price_off_a_time_that_does_not_repeat_is_marked():
    unsteady = run("verlet", 1e-1, 1e-4, time_high=2e-1)
    assert price([COARSE, unsteady], 1e-3).repeats is False
    assert price([COARSE, unsteady], 1e-2).repeats
    assert price([COARSE, run("verlet", 1e-1, 1e-4, rounds=1)], 1e-3).repeats is None


def test_prices_come_cheapest_first_and_without_methods_that_have_no_result():
    failed = Run(system="benign", method="rk4", setting=1, failure="unstable step", end="finest")
    runs = [COARSE, FINE, LATE, failed, run("closed", 1e-3, 0.0), run("radau", 0.3, 1e-5)]
    found = prices(grouped(runs).values(), 1e-3)
    assert [each.method for each in found] == ["closed", "verlet", "radau"]


def test_runs_at_equal_error_and_at_equal_cost():
    runs = [COARSE, FINE, LATE]
    assert (at_error(runs, 1e-2), at_error(runs, 1e-3), at_error(runs, 1e-5)) == (COARSE, FINE, None)
    assert (at_cost(runs, 1.0), at_cost(runs, 0.05), at_cost(runs, 1e-3)) == (FINE, COARSE, None)

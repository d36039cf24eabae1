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


SLOW, QUICK = run("lsoda", 0.5, 1e-7), run("lsoda", 0.05, 1e-8)
UNSTEADY, ONCE = run("verlet", 1e-1, 1e-4, time_high=2e-1), run("verlet", 1e-1, 1e-4, rounds=1)


@pytest.mark.parametrize(
    ("runs", "error", "time", "repeats"),
    [
        ([COARSE, FINE], 1e-3, sqrt(1e-2 * 1e-1), True),
        ([COARSE, FINE], 1e-2, 1e-2, True),
        ([COARSE, FINE], 1e-4, 1e-1, True),
        ([COARSE, FINE], 0.5, 1e-2, True),
        ([run("closed", 1e-3, 0.0)], 1e-6, 1e-3, True),
        ([run("lsoda", 0.02, 1e-5), SLOW, QUICK], 1e-6, 0.05, True),
        ([run("lsoda", 0.02, 1e-7), run("lsoda", 0.5, 1e-5)], 1e-6, 0.02, True),
        ([COARSE, UNSTEADY], 1e-3, sqrt(1e-2 * 1e-1), False),
        ([COARSE, UNSTEADY], 1e-2, 1e-2, True),
        ([COARSE, ONCE], 1e-3, sqrt(1e-2 * 1e-1), None),
    ],
)
def test_a_price_is_the_cheapest_on_the_line_between_runs(runs, error, time, repeats):
    """LSODA with a finer tolerance may find the stiff formulas that it missed with a coarser one."""
    found = price(runs, error)
    assert (found.time, found.repeats) == (pytest.approx(time), repeats)


def test_an_error_that_was_not_reached_says_how_near_and_why():
    assert price([COARSE, FINE], 1e-3).evaluations == pytest.approx(sqrt(1000 * 16000))
    found = price([COARSE, FINE, LATE], 1e-6)
    assert (found.time, found.evaluations, found.best, found.end) == (None, None, 1e-4, "time limit")


def test_prices_come_cheapest_first_and_without_methods_that_have_no_result():
    failed = Run(system="benign", method="rk4", setting=1, failure="unstable step", end="finest")
    runs = [COARSE, FINE, LATE, failed, run("closed", 1e-3, 0.0), run("radau", 0.3, 1e-5)]
    found = prices(grouped(runs).values(), 1e-3)
    assert [each.method for each in found] == ["closed", "verlet", "radau"]


def test_runs_at_equal_error_and_at_equal_cost():
    runs = [COARSE, FINE, LATE]
    assert (at_error(runs, 1e-2), at_error(runs, 1e-3), at_error(runs, 1e-5)) == (COARSE, FINE, None)
    assert (at_cost(runs, 1.0), at_cost(runs, 0.05), at_cost(runs, 1e-3)) == (FINE, COARSE, None)

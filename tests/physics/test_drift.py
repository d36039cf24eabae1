"""Motions in steps over a few periods."""

from dataclasses import replace
from itertools import pairwise
from math import inf, isinf

import numpy as np
import pytest

from physics.integrators.accuracy import SYSTEMS
from physics.integrators.drift import PERIODS, drifts, exact
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.solvers import METHODS, Method
from physics.integrators.stability import stable_count

THREE = ("euler", "verlet", "rk4")


@pytest.mark.parametrize("method", THREE)
def test_an_error_shrinks_as_the_order_of_the_method_says(method: str) -> None:
    coarse, fine = (drifts(SYSTEMS["near"], steps, THREE)[method].error for steps in (200, 400))
    assert np.log2(coarse / fine) == pytest.approx(STEPPING[method].order, abs=0.3)


@pytest.mark.parametrize("slug", ["benign", "wide", "light", "dashpot"])
def test_a_method_explodes_below_its_least_steps_and_ends_there(slug: str) -> None:
    system, period = SYSTEMS[slug], SYSTEMS[slug].problem(1, 1)
    size = float(np.max(np.abs(exact(system).x)))
    for steps in (6, 60):
        for method, drift in drifts(system, steps, THREE).items():
            least = stable_count(method, period)
            if method != "euler" or least > 1:
                assert isinf(drift.error) == (steps < least), (method, steps)
            assert (drift.t.size == PERIODS * steps + 1) or drift.error == inf
            assert np.max(np.abs(drift.x)) <= 100 * size and drift.x.size == drift.t.size


def test_a_drive_whose_phase_no_double_can_hold_is_refused_in_words() -> None:
    beyond = replace(SYSTEMS["near"], F_0=1.0, omega=1e308)
    with pytest.raises(ValueError, match="omega t leaves the range of doubles"):
        beyond.problem()
    assert replace(beyond, F_0=0.0).problem().omega == 1e308


@pytest.mark.parametrize("method", [one for one in METHODS.values() if one.family == "fixed"], ids=lambda one: one.name)
def test_each_setting_has_one_step_more_or_a_tenth_of_the_error(method: Method) -> None:
    steps = method.settings()
    for few, more in pairwise(steps):
        assert few < more <= max(few + 1, 1.25 * 10 ** (1 / method.order) * few)

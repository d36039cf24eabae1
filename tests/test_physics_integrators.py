"""Steps: orders by measured slope, stability by running into it, and one face for every method."""

import math
from dataclasses import replace

import numpy as np
import pytest

from physics.coupled import TwoMassChain
from physics.integrators import (
    FIXED_STEP,
    WEIGHTS,
    Problem,
    StoppedError,
    Watch,
    amplification,
    run_fixed,
    stability_limit,
    stable_steps,
)
from physics.reference import reference
from physics.solvers import METHODS

CHAIN = TwoMassChain(m1=1.0, m2=1.5, k1=2.0, k2=3.0)
FREE = Problem(chain=CHAIN, x_0=(1.0, -0.5), v_0=(0.2, 0.3), t=0.25 * np.arange(61.0))
DRIVEN = replace(FREE, F_0=1.5, omega=1.7)
ORDERS = {"verlet": (2, 4), "midpoint": (2, 4), "yoshida4": (4, 4), "yoshida6": (6, 2)}
explicit = pytest.mark.parametrize("method", WEIGHTS)
fixed = pytest.mark.parametrize("method", FIXED_STEP)


def error(problem, method, setting):
    result = METHODS[method].run(problem, setting, Watch())
    return float(np.max(reference(problem).errors(result.x)))


@fixed
@pytest.mark.parametrize("problem", [FREE, DRIVEN], ids=["free", "driven"])
def test_order_by_measured_slope(method, problem):
    order, steps = ORDERS[method]
    slope = math.log2(error(problem, method, steps) / error(problem, method, 2 * steps))
    assert slope == pytest.approx(order, abs=0.15)


@explicit
def test_weights_are_symmetric_and_sum_to_one(method):
    weights = WEIGHTS[method]
    assert weights == weights[::-1]
    assert math.fsum(weights) == pytest.approx(1.0, abs=4e-16)
    for power in range(3, {"verlet": 2, "yoshida4": 4, "yoshida6": 6}[method], 2):
        assert math.fsum(w**power for w in weights) == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize(
    ("method", "limit"), [("verlet", 2.0), ("yoshida4", 1.5734), ("yoshida6", 2.2691), ("midpoint", math.inf)]
)
def test_stability_limits(method, limit):
    assert stability_limit(method) == pytest.approx(limit, abs=5e-5)
    near = [0.01, 0.5, 0.999 * min(limit, 1e6)]
    np.testing.assert_array_equal(amplification(method, near), 1.0)


@explicit
def test_a_run_grows_by_the_amplification(method):
    """One mass alone, k2 = 0, a little past the limit: the growth a step approaches the spectral radius."""
    h_omega = 1.015 * stability_limit(method)
    chain = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=0.0)
    problem = Problem(chain=chain, x_0=(1.0, 0.0), v_0=(0.1, 0.0), t=h_omega * np.arange(400.0))
    x = run_fixed(method, problem, 1, Watch()).x[0]
    growth = amplification(method, h_omega)[0]
    assert growth > 1.01
    assert abs(x[-1] / x[-2]) == pytest.approx(growth, rel=1e-6)


@explicit
@pytest.mark.parametrize(("share", "explodes"), [(0.98, False), (1.02, True)])
def test_a_step_past_the_limit_is_given_up_with_the_reason(method, share, explodes):
    spacing = share * stability_limit(method) / CHAIN.modes().omega[1]
    problem = replace(FREE, t=spacing * np.arange(2000.0))
    if not explodes:
        assert np.max(np.abs(run_fixed(method, problem, 1, Watch(bound=1e3)).x)) < 100
        return
    with pytest.raises(StoppedError, match="unstable step: h omega_") as stop:
        run_fixed(method, problem, 1, Watch(bound=1e3))
    assert 0 < stop.value.reached < problem.t[-1]


def test_explicit_steps_pay_for_a_stiff_spring():
    soft, stiff = (TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=k2) for k2 in (1e6, 1e10))
    assert stable_steps("verlet", stiff) / stable_steps("verlet", soft) == pytest.approx(100, rel=1e-4)
    assert stable_steps("midpoint", stiff) == 0.0


def test_implicit_midpoint_keeps_the_energy_and_loses_the_phase():
    truth, result = reference(FREE), METHODS["midpoint"].run(FREE, 2, Watch())
    assert np.max(truth.energy_errors(CHAIN, result)) < 1e-14
    assert np.max(truth.errors(result.x)) > 0.1


@fixed
def test_time_reversed_it_comes_back(method):
    there = run_fixed(method, FREE, 3, Watch())
    back = replace(FREE, x_0=tuple(there.x[:, -1]), v_0=tuple(-there.v[:, -1]))
    home = run_fixed(method, back, 3, Watch())
    np.testing.assert_allclose(home.x[:, -1], FREE.x_0, atol=1e-12)
    np.testing.assert_allclose(home.v[:, -1], np.negative(FREE.v_0), atol=1e-12)


@pytest.mark.parametrize("problem", [FREE, DRIVEN], ids=["free", "driven"])
@pytest.mark.parametrize("method", METHODS)
def test_every_method_finds_the_motion(method, problem):
    finest = {"fixed": 64, "adaptive": 1e-9, "closed": 0}[METHODS[method].family]
    worst = {"verlet": 2e-3, "midpoint": 4e-3, "bdf": 1e-5}.get(method, 2e-7)
    assert error(problem, method, finest) < worst
    if METHODS[method].family == "closed":
        assert error(problem, method, 0) < 1e-13


@pytest.mark.parametrize("method", [slug for slug, method in METHODS.items() if method.family == "adaptive"])
def test_a_tighter_tolerance_is_nearer_and_dearer(method):
    loose, tight = Watch(), Watch()
    far = METHODS[method].run(FREE, 1e-4, loose).x
    near = METHODS[method].run(FREE, 1e-7, tight).x
    truth = reference(FREE)
    assert np.max(truth.errors(near)) < np.max(truth.errors(far)) / 10
    assert tight.evaluations > loose.evaluations
    assert tight.evaluations > tight.steps > loose.steps > 10


def test_the_closed_form_is_within_two_roundings():
    assert error(FREE, "closed", 0) < 4 * 2.0**-53
    assert error(DRIVEN, "closed", 0) < 4 * 2.0**-53


def test_fixed_steps_always_offer_a_stable_one():
    stiff = replace(FREE, chain=TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1e10))
    for method in ("verlet", "yoshida4", "yoshida6"):
        step = stiff.spacing / METHODS[method].settings(stiff)[-1]
        assert step * stiff.chain.modes().omega[1] < stability_limit(method)
        assert METHODS[method].settings(FREE)[-1] == 256
    assert METHODS["midpoint"].settings(stiff)[-1] == 256


def test_a_step_that_doubles_cannot_tell_apart_is_refused():
    stiff = replace(FREE, chain=TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1e40))
    with pytest.raises(StoppedError, match="step below spacing"):
        METHODS["verlet"].run(stiff, METHODS["verlet"].settings(stiff)[-1], Watch())


def test_the_slides_have_no_particular_solution_at_resonance():
    at_it = replace(DRIVEN, chain=TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), omega=1.0)
    with pytest.raises(StoppedError, match=r"D\(omega\) = 0"):
        METHODS["slides"].run(at_it, 0, Watch())


def test_a_solver_that_gives_up_says_why(monkeypatch):
    from scipy import integrate

    class Failed:
        status = -1
        message = "Required step size is less than spacing between numbers."
        t = np.array([0.0, 2.5])

    monkeypatch.setattr(integrate, "solve_ivp", lambda *_, **__: Failed())
    with pytest.raises(StoppedError, match="step below spacing") as stop:
        METHODS["rk45"].run(FREE, 1e-6, Watch())
    assert stop.value.reached == 2.5


def test_steps_are_counted_and_checked():
    watch = Watch()
    run_fixed("yoshida4", FREE, 2, watch)
    assert (watch.steps, watch.evaluations) == (120, 361)
    for steps in (0, 1.5, -3):
        with pytest.raises(ValueError, match=f"steps = {steps}"):
            run_fixed("verlet", FREE, steps, Watch())

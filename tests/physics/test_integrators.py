"""Steps: orders by measured slope, stability by running into it, and one face for every method."""

import math
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from scipy import integrate

from physics.coupled import TwoMassChain
from physics.integrators import solvers
from physics.integrators.fixed_steps import FIXED_STEP, STEPPING, TABLEAUX, WEIGHTS, run_fixed
from physics.integrators.implicit_steps import RHO
from physics.integrators.problem import Problem, StoppedError, Watch
from physics.integrators.solvers import METHODS
from physics.integrators.stability import (
    amplification,
    decay_factor,
    form_change,
    stability_limit,
)
from physics.reference.driven_chain import reference
from tests.grids import spread

CHAIN = TwoMassChain(m1=1.0, m2=1.5, k1=2.0, k2=3.0)
FREE = Problem(chain=CHAIN, x_0=(1.0, -0.5), v_0=(0.2, 0.3), t=0.25 * np.arange(61.0))
DRIVEN = replace(FREE, F_0=1.5, omega=1.7)
DAMPED = Problem(
    chain=TwoMassChain(m1=1.0, m2=1.0, k1=20.0, k2=0.0), c=12.0, F_0=5.0, omega=3.0,
    x_0=(1.0, 0.0), v_0=(0.3, 0.0), t=0.01 * np.arange(201.0),
)  # fmt: skip
DAMPING = ("ieuler", "sdirk2", "radau5", "alpha")
SPLITTING = ("gautschi", "mollified")
RUBBED = [method for method in FIXED_STEP if STEPPING[method].friction]
LIMITS = dict.fromkeys(("midpoint", "newmark", "gauss4", *DAMPING, *SPLITTING), math.inf) | {
    "semi": 2.0, "verlet": 2.0, "yoshida4": 1.5734, "yoshida6": 2.2691, "rk4": 2 * math.sqrt(2),
    "nystrom4": 2.5865, "nystrom6": 3.0402, "euler": 0.0,
}  # fmt: skip
LEFT = {"midpoint": 1.0, "newmark": 1.0, "gauss4": 1.0, "alpha": RHO, "ieuler": 0.0, "sdirk2": 0.0, "radau5": 0.0}
"""|R| at -1e12: at most 1 as the method is A-stable, 0 where it is L-stable."""
FINE = {"euler": 512, "ieuler": 512, "semi": 128} | dict.fromkeys(("sdirk2", "alpha", *SPLITTING), 16)
SYMPLECTIC = {*WEIGHTS, "semi", "midpoint", "newmark", "gauss4", "mollified"}
fixed = pytest.mark.parametrize("method", FIXED_STEP)
ADAPTIVE = [slug for slug, method in METHODS.items() if method.family == "adaptive"]


def error(problem, method, setting):
    result = METHODS[method].run(problem, setting, Watch())
    return float(np.max(reference(problem).errors(result.x)))


@pytest.mark.parametrize(
    ("method", "problem"),
    [(method, problem) for method in FIXED_STEP for problem in (FREE, DRIVEN)]
    + [(method, DAMPED) for method in RUBBED],
)
def test_the_order_of_a_method_is_the_measured_slope(method, problem):
    order = STEPPING[method].order
    steps = 1 if problem.c else FINE.get(method, 2 if order == 6 else 4)
    slope = math.log2(error(problem, method, steps) / error(problem, method, 2 * steps))
    assert slope == pytest.approx(order, abs=0.15)


@fixed
def test_stability_is_that_of_the_books(method):
    limit = LIMITS[method]
    assert stability_limit(method) == pytest.approx(limit, abs=5e-5)
    if limit and method not in (*TABLEAUX, *DAMPING):
        near = [0.01, 0.5, 0.999 * min(limit, 1e3)]
        np.testing.assert_allclose(amplification(method, near), 1.0, rtol=1e-12)
    if method in LEFT:
        assert abs(decay_factor(method, 1e12)) == pytest.approx(LEFT[method], abs=1e-9)
        assert max(abs(decay_factor(method, z)) for z in np.geomspace(1e-3, 1e15, 100)) <= 1 + 1e-12
    if method in DAMPING:
        slow, fast, beyond = amplification(method, [0.05, 3.0, 1e4])
        assert fast < slow < 1 and beyond == pytest.approx(LEFT[method], abs=2e-3)
    change = form_change(method, 0.5)
    assert (change < 1e-14) == (method in SYMPLECTIC) and not 1e-14 < change < 1e-8


@pytest.mark.parametrize("method", SPLITTING)
def test_the_coupling_spring_alone_is_solved_exactly(method):
    """Steps of 700 of its swings, without a drift of phase or energy."""
    pair = TwoMassChain(m1=1.0, m2=3.0, k1=0.0, k2=2.0)
    problem = replace(FREE, chain=pair, t=2700.0 * np.arange(20.0))
    assert error(problem, method, 1) < 1e-11


@pytest.mark.parametrize("method", [*WEIGHTS, "semi", "rk4", "nystrom4"])
def test_a_step_past_the_limit_is_given_up_with_the_reason(method):
    t = np.arange(2000.0) * stability_limit(method) / CHAIN.modes().omega[1]
    assert np.max(np.abs(run_fixed(method, replace(FREE, t=0.98 * t), 1, Watch(bound=1e3)).x)) < 100
    with pytest.raises(StoppedError, match="unstable step: h omega_") as stop:
        run_fixed(method, replace(FREE, t=1.02 * t), 1, Watch(bound=1e3))
    assert 0 < stop.value.reached < 1.02 * t[-1]


@pytest.mark.parametrize(
    ("method", "problem"),
    [
        (slug, problem)
        for slug, method in METHODS.items()
        for problem in (FREE, DRIVEN, DAMPED)
        if slug not in FIXED_STEP and (method.friction or not problem.c)
    ],
)
def test_every_other_method_finds_the_motion(method, problem):
    setting, worst = (1e-9, 1e-5 if method == "bdf" else 2e-7) if METHODS[method].family == "adaptive" else (0, 1e-13)
    assert error(problem, method, setting) < worst


@pytest.mark.parametrize("method", spread(ADAPTIVE))
def test_steps_are_forgotten(method):
    """A run of 20 times as many steps holds no more memory. The first runs fill caches of libraries."""
    peaks, steps = [], []
    for periods in (20.0, 20.0, 1.0):
        tracemalloc.start()
        METHODS[method].run(replace(FREE, t=periods * np.arange(11.0)), 1e-4, watch := Watch())
        peaks.append(tracemalloc.get_traced_memory()[1])
        steps.append(watch.steps)
        tracemalloc.stop()
    assert steps[1] - steps[2] > 250
    assert (peaks[1] - peaks[2]) / (steps[1] - steps[2]) < 16


@fixed
def test_fixed_steps_go_down_by_a_decade_of_error(method):
    steps = METHODS[method].settings()
    assert steps[0] == 1 and all(n == int(n) for n in steps) and steps[-1] >= 2**40
    fine = np.array([n for n in steps if n > 30])
    np.testing.assert_allclose((fine[1:] / fine[:-1]) ** METHODS[method].order, 10, rtol=0.25)


@pytest.mark.parametrize("method", ["fortran", "adams", "lsoda", "dop853"])
def test_evaluations_are_those_that_were_made(method):
    made = []

    def counted(problem):
        A = solvers.jacobian(problem)
        return A, lambda t, y: made.append(t) or A @ y

    METHODS[method].run(FREE, 1e-6, watch := Watch(), linear=counted)
    assert watch.evaluations == len(made)


def test_lsoda_reports_its_steps_for_stiff_equations():
    METHODS["lsoda"].run(DAMPED, 1e-6, easy := Watch())
    stiff = replace(DAMPED, chain=replace(DAMPED.chain, k1=1e6), c=1e6 + 1.0, t=np.arange(11.0))
    METHODS["lsoda"].run(stiff, 1e-6, hard := Watch())
    assert easy.stiff_steps < easy.steps / 2 < hard.steps / 2 < hard.stiff_steps


RESONANT = replace(DRIVEN, chain=TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), omega=1.0)


def late(t):
    raise StoppedError("late", t)


@pytest.mark.parametrize(
    ("method", "problem", "setting", "watch", "words"),
    [
        ("fortran", FREE, 1e-6, Watch(check=late), "late"),
        ("adams", FREE, 1e-6, Watch(check=late), "late"),
        ("verlet", replace(FREE, chain=replace(CHAIN, k2=1e40)), 2.0**56, Watch(), "step below spacing"),
        ("slides", RESONANT, 0, Watch(), r"D\(omega\) = 0"),
    ],
)
def test_a_run_stops_with_the_reason(method, problem, setting, watch, words):
    with pytest.raises(StoppedError, match=words):
        METHODS[method].run(problem, setting, watch)


def test_modes_by_eigh_at_resonance():
    """Doubles suffice there, with the response in its regular form; the usual one divides by rounding."""
    near = replace(RESONANT, omega=1 + 1e-9)
    assert error(RESONANT, "eigh", 0) < 1e-14 and error(near, "eigh", 0) < 1e-14
    assert error(near, "naive", 0) > 1e-9


def test_a_solver_that_gives_up_says_why(monkeypatch):
    class Failing(integrate.RK45):
        def _step_impl(self):
            return super()._step_impl() if self.t < 2.5 else (False, self.TOO_SMALL_STEP)

    monkeypatch.setattr(integrate, "RK45", Failing)
    with pytest.raises(StoppedError, match="step below spacing") as stop:
        METHODS["rk45"].run(FREE, 1e-6, Watch())
    assert 2.5 <= stop.value.reached < 4


def test_steps_are_counted_and_checked():
    run_fixed("yoshida4", FREE, 2, watch := Watch())
    assert (watch.steps, watch.evaluations) == (120, 360)
    for steps in (0, 1.5, -3):
        with pytest.raises(ValueError, match=f"^{steps} steps from one output time to the next"):
            run_fixed("verlet", FREE, steps, Watch())

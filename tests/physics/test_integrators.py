"""Steps: orders by measured slope, stability by running into it; the measurement, prices and stiffness."""

import json
import math
from dataclasses import replace
from itertools import pairwise
from unittest.mock import Mock

import mpmath as mp
import numpy as np
import pytest
from scipy import integrate

from physics.coupled import TwoMassChain
from physics.integrators import solvers, stability
from physics.integrators.accuracy import MARKS, SYSTEMS, Limits, Run, System, entered
from physics.integrators.drift import PERIODS, drifts, exact
from physics.integrators.fixed_steps import FIXED_STEP, STEPPING, TABLEAUX, WEIGHTS, run_fixed
from physics.integrators.implicit_steps import RHO
from physics.integrators.price import at_cost, at_error, price
from physics.integrators.problem import Problem, StoppedError, Watch
from physics.integrators.race import STANDS, Ladder, bench_of, measure, yardstick
from physics.integrators.solvers import METHODS
from physics.integrators.stiffness import stiffness
from physics.reference.driven_chain import reference
from tests.physics.truth import U, by_exponential

CHAIN = TwoMassChain(m1=1.0, m2=1.5, k1=2.0, k2=3.0)
FREE = Problem(chain=CHAIN, x_0=(1.0, -0.5), v_0=(0.2, 0.3), t=0.25 * np.arange(61.0))
DRIVEN = replace(FREE, F_0=1.5, omega=1.7)
DAMPED = Problem(
    chain=TwoMassChain(m1=1.0, m2=1.0, k1=20.0, k2=0.0), c=12.0, F_0=5.0, omega=3.0,
    x_0=(1.0, 0.0), v_0=(0.3, 0.0), t=0.01 * np.arange(201.0),
)  # fmt: skip
DAMPING = ("ieuler", "sdirk2", "radau5", "alpha")
SPLITTING = ("gautschi", "mollified")
LIMITS = dict.fromkeys(("midpoint", "newmark", "gauss4", *DAMPING, *SPLITTING), math.inf) | {
    "semi": 2.0, "verlet": 2.0, "yoshida4": 1.5734, "yoshida6": 2.2691, "rk4": 2 * math.sqrt(2),
    "nystrom4": 2.5865, "nystrom6": 3.0402, "euler": 0.0,
}  # fmt: skip
LEFT = {"midpoint": 1.0, "newmark": 1.0, "gauss4": 1.0, "alpha": RHO, "ieuler": 0.0, "sdirk2": 0.0, "radau5": 0.0}
"""|R| at -1e12: at most 1 as the method is A-stable, 0 where it is L-stable."""
FINE = {"euler": 512, "ieuler": 512, "semi": 128} | dict.fromkeys(("sdirk2", "alpha", *SPLITTING), 16)
SYMPLECTIC = {*WEIGHTS, "semi", "midpoint", "newmark", "gauss4", "mollified"}
fixed = pytest.mark.parametrize("method", FIXED_STEP)
MOTIONS = [(slug, one) for slug in METHODS for one in (FREE, DRIVEN, DAMPED) if METHODS[slug].friction or not one.c]
WIDE = replace(FREE, chain=TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1e4), x_0=(1.0, 0.0), t=np.arange(101.0))
STIFF = replace(DAMPED, chain=replace(DAMPED.chain, k1=1e3), c=1001.0, t=np.arange(11.0))
ONCE = Limits(seconds=60.0, rounds=1, visit=0.0)
DRIFTING, APART, BRAKED = (
    System(slug="link", name=name, chain=TwoMassChain(m1=1.0, m2=m2, k1=k1, k2=k2), **more)
    for name, m2, k1, k2, more in (
        ("Drift", 2.0, 0.0, 3.0, {"x_0": (1.0, 0.5), "v_0": (0.1, 0.0), "F_0": 0.7, "omega": 0.3}),
        ("Apart", 2.0, 3.0, 0.0, {"x_0": (1.0, 0.5), "v_0": (0.1, 0.2), "F_0": 0.7, "omega": 0.3}),
        ("Damped", 1.0, 20.0, 0.0, {"x_0": (1.0, 0.0), "v_0": (0.3, 0.0), "F_0": 5.0, "omega": 3.0, "c": 12.0}),
    )
)


def error(problem, method, setting):
    result = METHODS[method].run(problem, setting, Watch())
    return float(np.max(reference(problem).errors(result.x)))


@pytest.mark.parametrize(("method", "problem"), MOTIONS)
def test_each_method_finds_the_motion_with_its_order_in_fixed_steps(method, problem):
    """The order is the slope of the measured error."""
    if method in FIXED_STEP:
        order = STEPPING[method].order
        steps = 1 if problem.c else FINE.get(method, 2 if order == 6 else 4)
        slope = math.log2(error(problem, method, steps) / error(problem, method, 2 * steps))
        assert slope == pytest.approx(order, abs=0.15)
    else:
        adaptive = METHODS[method].family == "adaptive"
        worst = (1e-5 if method == "bdf" else 2e-7) if adaptive else 1e-13
        assert error(problem, method, 1e-9 if adaptive else 0) < worst


@fixed
def test_stability_is_that_of_the_books(method):
    limit = LIMITS[method]
    assert stability.stability_limit(method) == pytest.approx(limit, abs=5e-5)
    if limit and method not in (*TABLEAUX, *DAMPING):
        near = [0.01, 0.5, 0.999 * min(limit, 1e3)]
        np.testing.assert_allclose(stability.amplification(method, near), 1.0, rtol=1e-12)
    if method in LEFT:
        assert abs(stability.decay_factor(method, 1e12)) == pytest.approx(LEFT[method], abs=1e-9)
        assert max(abs(stability.decay_factor(method, z)) for z in np.geomspace(1e-3, 1e15, 100)) <= 1 + 1e-12
    if method in DAMPING:
        slow, fast, beyond = stability.amplification(method, [0.05, 3.0, 1e4])
        assert fast < slow < 1 and beyond == pytest.approx(LEFT[method], abs=2e-3)
    change = stability.form_change(method, 0.5)
    assert (change < 1e-14) == (method in SYMPLECTIC) and not 1e-14 < change < 1e-8


@pytest.mark.parametrize("method", SPLITTING)
def test_the_coupling_spring_alone_is_solved_exactly(method):
    """Steps of 700 of its swings, without a drift of phase or energy."""
    pair = TwoMassChain(m1=1.0, m2=3.0, k1=0.0, k2=2.0)
    assert error(replace(FREE, chain=pair, t=2700.0 * np.arange(20.0)), method, 1) < 1e-11


@pytest.mark.parametrize("method", [*WEIGHTS, "semi", "rk4", "nystrom4"])
def test_a_step_past_the_limit_is_given_up_with_the_reason(method):
    t = np.arange(2000.0) * stability.stability_limit(method) / CHAIN.modes().omega[1]
    assert np.max(np.abs(run_fixed(method, replace(FREE, t=0.98 * t), 1, Watch(bound=1e3)).x)) < 100
    with pytest.raises(StoppedError, match="unstable step: h omega_") as stop:
        run_fixed(method, replace(FREE, t=1.02 * t), 1, Watch(bound=1e3))
    assert 0 < stop.value.reached < 1.02 * t[-1]


@fixed
def test_each_setting_has_one_step_more_or_a_tenth_of_the_error(method):
    steps = METHODS[method].settings()
    assert steps[0] == 1 and steps[-1] >= 2**40
    for few, more in pairwise(steps):
        assert few < more <= max(few + 1, 1.25 * 10 ** (1 / METHODS[method].order) * few)


@pytest.mark.parametrize(("method", "problem"), [("nystrom4", WIDE), ("rk4", STIFF), ("euler", STIFF)])
def test_the_fewest_steps_that_are_stable(method, problem):
    """A hundredth more than at the limit; 3 % fewer explode. With decays the limit is one of the fast rate."""
    count = stability.stable_count(method, problem)
    assert np.max(np.abs(run_fixed(method, problem, count, Watch()).x)) < 100
    with pytest.raises(StoppedError, match="unstable step"):
        run_fixed(method, problem, round(0.96 * count), Watch(bound=1e3))
    assert (stability.stable_count("gauss4", WIDE), stability.stable_count("euler", WIDE)) == (1, 1)


@pytest.mark.parametrize("method", ["fortran", "adams", "lsoda", "dop853"])
def test_evaluations_are_those_that_were_made(method):
    force = Mock(side_effect=lambda t, y: solvers.jacobian(FREE) @ y)
    METHODS[method].run(FREE, 1e-6, watch := Watch(), linear=lambda problem: (solvers.jacobian(problem), force))
    assert watch.evaluations == force.call_count


def test_modes_by_eigh_at_resonance():
    """Doubles suffice there, with the response in its regular form; the usual one divides by rounding."""
    resonant = replace(DRIVEN, chain=TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), omega=1.0)
    near = replace(resonant, omega=1 + 1e-9)
    assert error(resonant, "eigh", 0) < 1e-14 and error(near, "eigh", 0) < 1e-14
    assert error(near, "naive", 0) > 1e-9


def test_a_solver_that_gives_up_says_why_and_a_run_without_memory_is_a_row(monkeypatch):
    class Failing(integrate.RK45):
        def _step_impl(self):
            return super()._step_impl() if self.t < 2.5 else (False, self.TOO_SMALL_STEP)

    monkeypatch.setattr(integrate, "RK45", Failing)
    with pytest.raises(StoppedError, match="step below spacing") as stop:
        METHODS["rk45"].run(FREE, 1e-6, Watch())
    assert 2.5 <= stop.value.reached < 4
    monkeypatch.setattr(integrate, "RK45", Mock(side_effect=MemoryError))
    assert visited(SYSTEMS["benign"], "rk45", 1e-3).failure == "no memory left"


def test_steps_are_counted_and_checked():
    METHODS["lsoda"].run(DAMPED, 1e-6, easy := Watch())
    stiff = replace(DAMPED, chain=replace(DAMPED.chain, k1=1e6), c=1e6 + 1.0, t=np.arange(11.0))
    METHODS["lsoda"].run(stiff, 1e-6, hard := Watch())
    assert easy.stiff_steps < easy.steps / 2 < hard.steps / 2 < hard.stiff_steps
    run_fixed("yoshida4", FREE, 2, watch := Watch())
    assert (watch.steps, watch.evaluations) == (120, 360)
    for steps in (0, 1.5, -3):
        with pytest.raises(ValueError, match=f"^{steps} steps from one output time to the next"):
            run_fixed("verlet", FREE, steps, Watch())


def visited(system, method, setting=0.0, limits=ONCE, cancelled=lambda method: False):
    return bench_of(system, limits, cancelled, yardstick()).visit(METHODS[method], setting)


@pytest.mark.parametrize("system", (*SYSTEMS.values(), DRIFTING, APART, BRAKED), ids=lambda system: system.name)
def test_the_closed_form_and_the_reference_have_every_digit(system):
    """The reference is compared with a matrix exponential. Output times are exact doubles."""
    run, problem = visited(system, "closed"), system.problem()
    assert run.failure is None and run.error <= 4 * U and run.energy_error <= 8 * U
    assert problem.t.size == 1001 and all(n * mp.mpf(problem.t[1]) == problem.t[n] for n in range(1001))
    truth = reference(replace(problem, t=problem.t[[0, 1, 500]]))
    for n, t in enumerate(problem.t[[0, 1, 500]]):
        with mp.workdps(60):
            x1, x2, _, v1, v2 = by_exponential(problem, float(t), problem.c)
            for i, x in enumerate((x1, x2)):
                assert abs(mp.mpf(truth.x[i, n]) + mp.mpf(truth.x_rest[i, n]) - x) <= 1e-28 * truth.size
            chain = problem.chain
            for i, v in enumerate((v1, v2)):
                assert abs(truth.v[i, n] - v) <= U * abs(v) + 1e-28
            energy = (chain.m1 * v1**2 + chain.m2 * v2**2 + chain.k1 * x1**2 + chain.k2 * (x2 - x1) ** 2) / 2
            assert abs(truth.energy[n] - energy) <= U * energy


def test_methods_and_systems_are_refined_side_by_side_and_timed_again():
    """Long runs are timed only twice."""
    two, limits = [SYSTEMS["benign"], SYSTEMS["beats"]], Limits(seconds=60.0, rounds=3, visit=0.0)
    runs = list(measure(two, [METHODS[slug] for slug in ("closed", "slides")], limits))
    turn = [("closed", "benign"), ("closed", "beats"), ("slides", "benign"), ("slides", "beats")]
    assert [(run.method, run.system) for run in runs] == 3 * turn
    assert [run.rounds for run in runs] == [1] * 4 + [2] * 4 + [3] * 4
    assert all(run.time_low <= run.time <= run.time_high for run in runs)
    assert [run.repeats for run in runs[:4]] == [None] * 4
    runs = list(measure(two[:1], [METHODS["closed"]], Limits(rounds=5, visit=0.0, budget=0.0)))
    assert [run.rounds for run in runs] == [1, 2]


def test_a_run_records_its_errors_as_they_grow_at_the_end_and_mode_by_mode():
    """Verlet loses the phase of the fast mode first; with a dashpot the velocity is judged too."""
    run = visited(SYSTEMS["benign"], "verlet", 56)
    assert len(run.error_growth) == len(run.energy_growth) == len(MARKS)
    assert run.error_growth[0] < 1e-90 and np.all(np.diff(run.error_growth) >= 0)
    assert (run.error_growth[-1], run.energy_growth[-1]) == (run.error, run.energy_error)
    assert (run.steps, run.evaluations, run.rounds) == (56000, 56000, 1)
    assert run.time == run.time_low == run.time_high > 0
    slow, fast = run.mode_errors
    assert slow < fast / 30 and fast <= run.error * 2 and run.error <= slow + fast
    assert run.error / 10 < run.final_error <= run.error
    stiff = visited(SYSTEMS["dashpot"], "newmark", 1)
    assert stiff.final_error > 0.5 and not stiff.mode_errors
    assert np.max(np.abs(stiff.error)) > 100 * 2e-3, "x alone is right to 2e-3"


def ladder(method, errors=(), steps=1e9, limits=ONCE):
    """The ladder of a method after runs with these errors, all at so many steps."""
    found = Ladder(bench_of(SYSTEMS["benign"], limits, lambda method: False, yardstick()), METHODS[method])
    found.runs = [Run(system="benign", method=method, setting=steps, error=error, time=0.5) for error in errors]
    return found


def test_a_ladder_ends_at_its_floor_with_the_finest_setting_or_out_of_time():
    falling = [1e-3 * 10.0**-n for n in range(8)]
    still = [*falling, *STANDS * [falling[-1]]]
    assert ladder("rk4", falling).ending() == ladder("rk4", still[:-1]).ending() == ""
    assert ladder("rk4", still).ending() == "floor"
    assert ladder("rk4", still, steps=1.0).ending() == "", "a fast mode that is stepped over is no floor"
    closed = ladder("closed")
    assert closed.climb().end == closed.end == "finest"
    (*_, last) = measure([SYSTEMS["wide"]], [METHODS["rk45"]], Limits(seconds=0.0, rounds=1))
    assert (last.failure, last.end, last.setting) == ("time limit 0 s", "time limit", 1e-2)
    climbed = ladder("verlet", [1e-3], 10.0, replace(ONCE, seconds=1.0))
    assert climbed.foreseen(11.0) is None
    late = climbed.foreseen(100.0)
    assert (late.failure, late.end, late.reached) == ("time limit 1 s", "time limit", pytest.approx(0.2))


@pytest.mark.parametrize(
    ("system", "method", "setting", "seconds", "failure"),
    [
        (SYSTEMS["wide"], "verlet", 1, 60.0, "unstable step: h omega_+ = 632"),
        (SYSTEMS["dashpot"], "rk4", 1, 60.0, "unstable step: h f = 5e+04"),
        *(
            (SYSTEMS["wide"], method, None, 0.0, "time limit 0 s")
            for method in ("verlet", "rk45", "lsoda", "fortran", "adams", "expm")
        ),
        (SYSTEMS["resonance"], "slides", 0.0, 60.0, "D(omega) = 0: no particular solution"),
        (replace(DRIFTING, chain=replace(CHAIN, k2=1e40)), "verlet", 2.0**56, 60.0, "step below spacing"),
        (replace(DRIFTING, F_0=0.0), "slides", 0.0, 60.0, "cannot be computed: "),
        (SYSTEMS["benign"], "yoshida6", 64, 60.0, "cancelled"),
        (SYSTEMS["benign"], "dop853", 1e-9, 60.0, "cancelled"),
    ],
)
def test_a_failure_is_a_row(system, method, setting, seconds, failure):
    setting = METHODS[method].settings()[-1] if setting is None else setting
    limits = replace(ONCE, seconds=seconds)
    run = visited(system, method, setting, limits, lambda _: failure == "cancelled")
    assert run.failure.startswith(failure) and run.error is None and run.time is None
    assert 0 <= run.reached < 0.5


def test_only_methods_made_for_friction_enter_with_a_dashpot_and_a_measurement_can_be_cancelled():
    assert entered(SYSTEMS["benign"]) == tuple(METHODS)
    assert entered(SYSTEMS["dashpot"], ("closed", "eigh", "verlet", "rk4")) == ("closed", "rk4")
    asked, methods = [], [METHODS[slug] for slug in ("closed", "slides", "eigh")]
    runs = list(measure([SYSTEMS["benign"]], methods, ONCE, lambda method: asked.append(method) or len(asked) > 1))
    assert [run.method for run in runs] == ["closed"]


@pytest.mark.slow
@pytest.mark.parametrize("chain", [(1e300, 1, 1, 1), (1, 1e-300, 1, 1), (1, 1, 1e-250, 1), (1, 1, 1, 1e300)])
def test_extreme_chains_give_rows_and_never_an_exception(chain):
    m1, m2, k1, k2 = map(float, chain)
    system = System(slug="link", name="?", chain=TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), x_0=(1.0, 1.0))
    runs = list(measure([system], limits=Limits(seconds=0.001, rounds=1, visit=0.0)))
    assert {run.method for run in runs} == set(METHODS)
    assert all((run.error is None) != (run.failure is None) for run in runs)
    json.dumps([run.to_dict() for run in runs], allow_nan=False)


def priced(time, error, evaluations=1000, **more):
    facts = {"time_low": time, "time_high": time, "rounds": 3} | more
    return Run(system="benign", method="lsoda", setting=1, time=time, error=error, evaluations=evaluations, **facts)


CHEAP, DEAR = priced(1e-2, 1e-2, 1000), priced(1e-1, 1e-4, 16000)
UNSTEADY, UNREPEATED = priced(1e-1, 1e-4, time_high=1.25e-1), priced(1e-1, 1e-4, rounds=1)
LATE = Run(system="benign", method="lsoda", setting=9, failure="time limit 1 s", end="time limit")


@pytest.mark.parametrize(
    ("runs", "error", "time", "repeats"),
    [
        ([CHEAP, DEAR], 1e-3, math.sqrt(1e-2 * 1e-1), True),
        ([CHEAP, DEAR], 1e-2, 1e-2, True),
        ([CHEAP, DEAR], 1e-4, 1e-1, True),
        ([CHEAP, DEAR], 0.5, 1e-2, True),
        ([priced(1e-3, 0.0)], 1e-6, 1e-3, True),
        ([priced(0.02, 1e-5), priced(0.5, 1e-7), priced(0.05, 1e-8)], 1e-6, 0.05, True),
        ([priced(0.02, 1e-7), priced(0.5, 1e-5)], 1e-6, 0.02, True),
        ([CHEAP, UNSTEADY], 1e-3, math.sqrt(1e-2 * 1e-1), False),
        ([CHEAP, replace(UNSTEADY, time_high=1.15e-1)], 1e-3, math.sqrt(1e-2 * 1e-1), True),
        ([CHEAP, UNREPEATED], 1e-3, math.sqrt(1e-2 * 1e-1), None),
        ([CHEAP, DEAR, LATE], 1e-6, None, None),
    ],
)
def test_a_price_is_the_cheapest_on_the_line_between_runs(runs, error, time, repeats):
    """LSODA with a finer tolerance may find the stiff formulas that it missed with a coarser one."""
    found = price(runs, error)
    if time is None:
        assert (found.time, found.evaluations, found.best, found.end) == (None, None, 1e-4, "time limit")
    else:
        assert (found.time, found.repeats) == (pytest.approx(time), repeats)
        assert 1000 <= found.evaluations <= 16000


def test_runs_at_equal_error_and_at_equal_cost():
    runs = [CHEAP, DEAR, LATE]
    assert (at_error(runs, 1e-2), at_error(runs, 1e-3), at_error(runs, 1e-5)) == (CHEAP, DEAR, None)
    assert (at_cost(runs, 1.0), at_cost(runs, 0.05), at_cost(runs, 1e-3)) == (DEAR, CHEAP, None)


@pytest.mark.parametrize("slug", ["benign", "wide", "light", "dashpot"])
def test_a_method_explodes_below_its_least_steps_and_ends_there(slug):
    system, period = SYSTEMS[slug], SYSTEMS[slug].problem(1, 1)
    size = float(np.max(np.abs(exact(system).x)))
    for steps in (6, 60):
        for method, drift in drifts(system, steps, ("euler", "verlet", "rk4")).items():
            least = stability.stable_count(method, period)
            if method != "euler" or least > 1:
                assert math.isinf(drift.error) == (steps < least), (method, steps)
            assert (drift.t.size == PERIODS * steps + 1) or drift.error == math.inf
            assert np.max(np.abs(drift.x)) <= 100 * size and drift.x.size == drift.t.size


def test_the_step_of_accuracy_is_read_between_two_runs():
    runs = [Run(system="near", method="gauss4", setting=s, error=e) for s, e in ((10.0, 1e-4), (100.0, 1e-8))]
    problem = SYSTEMS["near"].problem()
    found = stiffness(SYSTEMS["near"], runs, 1e-6)
    assert found.accurate == pytest.approx(problem.rates[1] * problem.spacing / 10**1.5)
    assert problem.rates[1] * problem.spacing == pytest.approx(2 * 2 * math.pi / 20, rel=1e-9)
    assert stiffness(SYSTEMS["near"], runs[:1], 1e-6) is None

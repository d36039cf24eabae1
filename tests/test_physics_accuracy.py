"""The machinery of the measurement: reference, rows, failures, cancelling. No timing is judged."""

import json
from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest

from physics.accuracy import SYSTEMS, Case, Limits, System, measure, plan
from physics.coupled import TwoMassChain
from physics.reference import reference

U = 2.0**-53
ONCE = Limits(seconds=60.0, repeats=1)
DRIFTING = System(
    slug="link", name="Drift", chain=TwoMassChain(m1=1.0, m2=2.0, k1=0.0, k2=3.0),
    x_0=(1.0, 0.5), v_0=(0.1, 0.0), F_0=0.7, omega=0.3,
)  # fmt: skip
APART = System(
    slug="link", name="Apart", chain=TwoMassChain(m1=1.0, m2=2.0, k1=3.0, k2=0.0),
    x_0=(1.0, 0.5), v_0=(0.1, 0.2), F_0=0.7, omega=0.3,
)  # fmt: skip
ALL = (*SYSTEMS.values(), DRIFTING, APART)
systems = pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)


def by_exponential(problem, t):
    """x1, x2, v1, v2 from mpmath's matrix exponential, the drive as two more states."""
    chain = problem.chain
    m1, m2, k1, k2 = (mp.mpf(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
    omega = mp.mpf(problem.omega)
    A = mp.zeros(6)
    A[0, 2] = A[1, 3] = 1
    A[2, 0], A[2, 1], A[3, 0], A[3, 1] = -(k1 + k2) / m1, k2 / m1, k2 / m2, -k2 / m2
    A[2, 4] = mp.mpf(problem.F_0) / m1
    A[4, 5], A[5, 4] = omega, -omega
    return (mp.expm(A * mp.mpf(t)) * mp.matrix([*problem.start, 0, 1]))[:4]


@systems
def test_reference_against_a_matrix_exponential(system):
    problem = system.problem()
    truth = reference(replace(problem, t=problem.t[[0, 1, 500]]))
    for n, t in enumerate(problem.t[[0, 1, 500]]):
        with mp.workdps(60):
            x1, x2, v1, v2 = by_exponential(problem, float(t))
            for i, x in enumerate((x1, x2)):
                assert abs(mp.mpf(truth.x[i, n]) + mp.mpf(truth.x_rest[i, n]) - x) <= 1e-28 * truth.size
            chain = problem.chain
            energy = (chain.m1 * v1**2 + chain.m2 * v2**2 + chain.k1 * x1**2 + chain.k2 * (x2 - x1) ** 2) / 2
            assert abs(truth.energy[n] - energy) <= U * energy


@systems
def test_output_times_are_exact_doubles(system):
    t = system.problem().t
    assert t.size == 1001
    assert all(n * mp.mpf(t[1]) == t[n] for n in range(1001))
    slow, fast = system.chain.modes().omega
    assert t[-1] == pytest.approx(50 * 2 * np.pi / (slow or fast), rel=1e-11)


@systems
def test_the_closed_form_reaches_the_last_digit_everywhere(system):
    (run,) = measure(system, [Case("closed", 0)], ONCE)
    assert run.failure is None
    assert run.error <= 4 * U
    assert run.energy_error <= 8 * U


def test_a_run_tells_how_its_error_grew():
    (run,) = measure(SYSTEMS["benign"], [Case("verlet", 4)], ONCE)
    assert len(run.error_growth) == len(run.energy_growth) == 51
    assert run.error_growth[0] < 1e-90
    assert run.error_growth[-1] == run.error
    assert run.energy_growth[-1] == run.energy_error
    assert np.all(np.diff(run.error_growth) >= 0)
    assert (run.steps, run.evaluations) == (4000, 4001)
    assert run.time_low <= run.time <= run.time_high


def test_rows_come_one_by_one_for_every_case_of_the_plan():
    cases = [case for case in plan(SYSTEMS["beats"], ["closed", "slides", "verlet"]) if case.setting <= 4]
    runs = list(measure(SYSTEMS["beats"], cases, ONCE))
    assert [(run.method, run.setting) for run in runs] == cases == [
        ("closed", 0), ("slides", 0), ("verlet", 1), ("verlet", 4),
    ]  # fmt: skip


def test_quick_runs_are_repeated():
    (run,) = measure(SYSTEMS["beats"], [Case("slides", 0)], Limits(repeats=3, budget=60.0))
    assert run.time_low < run.time < run.time_high


def test_an_unstable_step_is_a_row():
    (run,) = measure(SYSTEMS["stiff"], [Case("verlet", 1)], ONCE)
    assert run.failure.startswith("unstable step: h omega_+ = 628")
    assert 0 < run.reached < 0.1
    assert run.error is None
    assert run.time is None


@pytest.mark.parametrize("method", ["verlet", "rk45", "radau", "lsoda", "expm"])
def test_a_run_out_of_time_is_a_row_and_finer_ones_are_not_started(method):
    cases = plan(SYSTEMS["stiff"], [method])[-2:] if method == "verlet" else plan(SYSTEMS["stiff"], [method])
    runs = list(measure(SYSTEMS["stiff"], [c for c in cases if c.setting != 256], Limits(seconds=0.0)))
    assert runs[0].failure == "time limit 0 s"
    assert 0 <= runs[0].reached < 0.5
    assert [run.failure for run in runs[1:]] == ["not started: time limit at a coarser setting"] * len(runs[1:])


def test_what_no_double_holds_is_a_row():
    (run,) = measure(SYSTEMS["resonance"], [Case("slides", 0)], ONCE)
    assert run.failure == "D(omega) = 0: no particular solution"
    (run,) = measure(replace(DRIFTING, F_0=0.0), [Case("slides", 0)], ONCE)
    assert run.failure.startswith("cannot be computed: ")


def test_cancelling_between_runs():
    asked = []

    def cancelled(method):
        asked.append(method)
        return len(asked) > 1

    runs = list(measure(SYSTEMS["benign"], [Case("closed", 0), Case("slides", 0), Case("eigh", 0)], ONCE, cancelled))
    assert [run.method for run in runs] == ["closed"]


@pytest.mark.parametrize("method", ["yoshida6", "dop853"])
def test_cancelling_within_a_run_and_skipping_one_method(method):
    skipped = set()

    def cancelled(slug):
        asked_before = slug in asked
        asked.add(slug)
        if slug == method and asked_before:
            skipped.add(slug)
        return slug in skipped

    asked = set()
    fine = {"yoshida6": 64, "dop853": 1e-9}[method]
    runs = list(
        measure(SYSTEMS["benign"], [Case(method, fine), Case(method, fine), Case("closed", 0)], ONCE, cancelled)
    )
    assert [(run.method, run.failure) for run in runs] == [(method, "cancelled"), ("closed", None)]
    assert runs[0].reached < 0.5


def test_rows_are_json():
    cases = [Case("closed", 0), Case("verlet", 1), Case("slides", 0)]
    for name in ("stiff", "resonance"):
        for run in measure(SYSTEMS[name], cases, ONCE):
            text = json.dumps(run.to_dict(), allow_nan=False)
            assert json.loads(text)["method"] == run.method


def test_the_systems_are_what_they_are_called():
    ratio = {slug: float(np.divide(*system.chain.modes().omega[::-1])) for slug, system in SYSTEMS.items()}
    assert ratio["benign"] == pytest.approx(3.19, abs=0.01)
    assert ratio["stiff"] == pytest.approx(2e3, rel=1e-3)
    assert ratio["stiffer"] == pytest.approx(2e5, rel=1e-3)
    assert SYSTEMS["light"].chain.m2 / SYSTEMS["light"].chain.m1 == 1e-6
    assert SYSTEMS["near"].omega / SYSTEMS["near"].chain.modes().omega[0] - 1 == pytest.approx(1e-8, rel=1e-7)
    assert SYSTEMS["resonance"].omega == SYSTEMS["resonance"].chain.modes().omega[0]


def test_two_free_masses_have_nothing_to_measure():
    free = System(slug="link", name="Free", chain=TwoMassChain(m1=1.0, m2=1.0, k1=0.0, k2=0.0), x_0=(1.0, 0.0))
    with pytest.raises(ValueError, match="two free masses"):
        list(measure(free))


@pytest.mark.parametrize("x_0", [(0.0, 0.0), (1e300, 1e300), (1e-320, 0.0)])
def test_a_motion_without_a_scale_is_refused(x_0):
    still = replace(SYSTEMS["benign"], x_0=x_0, v_0=(0.0, 0.0))
    with pytest.raises(ValueError, match="no scale"):
        list(measure(still))


@pytest.mark.parametrize("chain", [(1e300, 1, 1, 1), (1, 1e-300, 1, 1), (1, 1, 1e-250, 1), (1, 1, 1, 1e300)])
def test_extreme_chains_give_rows_and_never_an_exception(chain):
    m1, m2, k1, k2 = map(float, chain)
    system = System(slug="link", name="?", chain=TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), x_0=(1.0, 1.0))
    cases = plan(system)
    runs = list(measure(system, cases, Limits(seconds=0.02, repeats=1)))
    assert [(run.method, run.setting) for run in runs] == list(cases)
    assert all((run.error is None) != (run.failure is None) for run in runs)
    assert any(run.failure and run.failure.startswith("step below spacing") for run in runs)
    json.dumps([run.to_dict() for run in runs], allow_nan=False)

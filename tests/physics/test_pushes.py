"""Pushes that repeat or act once, motions under them, slices and powers, against 50 digits and closed forms."""

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.convolution import SlicedPush, joined, tails
from physics.damped import DampedOscillator
from physics.periodic import PeriodicPush
from physics.push_powers import mean_powers
from physics.pushed import PushedMass
from physics.pushed_vibration import PushedVibration, PushHarmonics
from physics.steady_motions import RestAfterPush, SteadyMotion
from tests.grids import tries
from tests.physics.truth import U, each, log_uniform, reference

each_case = each(reference("periodic"))
PERIODIC = ("square", "triangle", "pulses", "impulses")
ONE = DampedOscillator(m=1.5, c=1.2, k=20.0)


def pushed(case: dict[str, Any]) -> tuple[DampedOscillator, PushedMass]:
    width = {"width": case["duty"]} if case["duty"] else {}
    push = PeriodicPush(kind=case["kind"], size=case["F"], omega=case["omega"], **width)
    oscillator = DampedOscillator(m=case["m"], c=case["c"], k=case["k"])
    return oscillator, oscillator.pushed(push)


def within(found: Any, true: list[str], room: float) -> None:
    assert max(abs(mp.mpf(float(a)) - mp.mpf(b)) for a, b in zip(found, true, strict=True)) <= room


@each_case
def test_steady_motions_are_within_4_u_of_the_reference(case: dict[str, Any]) -> None:
    (oscillator, mass), period = pushed(case), 2 * math.pi / case["omega"]
    assert mass.steady_exists == case["steady_exists"]
    assert mass.growth == pytest.approx(float(case.get("growth_per_second") or 0.0), rel=4 * U, abs=0)
    if not mass.steady_exists:
        with pytest.raises(ValueError, match="is needed"):
            mass.steady([0.0])
        return
    motion, whole = mass.steady(case["t"]), mass.steady(np.linspace(0, period, 101))
    within(motion.x, case["x"], 4 * U * np.max(np.abs(whole.x)))
    within(motion.v, case["v"], 4 * U * np.max(np.abs(whole.v)))
    assert mass.work == pytest.approx(float(case["work_per_cycle"]), rel=2 * U, abs=0)
    later = mass.steady(np.array(case["t"]) + 2**20 * period)
    assert later.x == pytest.approx(motion.x, abs=1e-8 * np.max(np.abs(whole.v)) * period)
    assert oscillator.steady(mass.push, case["t"]).x.tolist() == motion.x.tolist()


@each_case
def test_lines_are_those_of_the_reference(case: dict[str, Any]) -> None:
    """Also in doubles, where a line that is missing may be a rounding error."""
    oscillator, mass = pushed(case)
    lines = mass.lines(9)
    for line, true in zip(lines, case["lines"], strict=True):
        f, X = (None if true[name] is None else complex(*map(float, true[name])) for name in ("f", "X"))
        assert line.n == true["n"] and abs(line.f - f) <= 4 * U * abs(f)
        assert np.isinf(line.X) if X is None else abs(line.X - X) <= 5 * U * abs(X)
    if case["k"] and not mass.push.once:
        found = PushHarmonics(oscillator=oscillator, push=mass.push).lines(range(1, 10))
        assert found.f == pytest.approx([abs(line.f) for line in lines[1:]], rel=1e-12, abs=1e-14 * case["F"])
        X = [abs(line.X) for line in lines[1:]]
        assert list(found.X) == pytest.approx(X, rel=1e-12, abs=1e-14 * X[0])


@each_case
def test_motions_from_rest_are_within_4_u_of_the_reference(case: dict[str, Any]) -> None:
    """The sum of slices of a push too."""
    (_, mass), t = pushed(case), case["rest"]["t"]
    grid = np.union1d(np.linspace(0, max(t), 61), t)
    motion = mass.from_rest(grid)
    for values, name in ((motion.x, "x"), (motion.v, "v")):
        within(values[np.searchsorted(grid, t)], case["rest"][name], 4 * U * np.max(np.abs(values)))
    for kind, key, symbol in (("impulse", "impulse_response", "h"), ("step", "step_response", "H")):
        if case.get(key):
            once = PushedMass(mass.m, mass.c, mass.k, PeriodicPush(kind=kind))
            values = once.from_rest(case[key]["t"]).x
            within(values, case[key][symbol], 4 * U * np.max(np.abs(values)))
    if true := case.get("convolution"):
        assert mass.from_rest([true["t"]]).x[0] == pytest.approx(float(true["exact"]), rel=1e-12)
        for count, value in true["midpoint"].items():
            _, sizes, left = mass.convolution(true["t"], int(count))
            assert left.sum() == pytest.approx(float(value), rel=1e-11, abs=1e-13 * np.abs(left).sum())
            assert len(sizes) == int(count)


@settings(max_examples=tries(160))
@given(
    *[log_uniform(-40, 40)] * 4, st.floats(0.01, 0.99), st.floats(0.0, 1.0), st.sampled_from(PERIODIC), st.booleans()
)
def test_over_many_decades_a_motion_that_starts_as_the_steady_one_is_the_steady_one(
    m: float, c: float, k: float, omega: float, width: float, share: float, kind: Any, critical: bool
) -> None:
    one = DampedOscillator(m=m, c=2 * math.sqrt(k * m) if critical else c, k=k)
    mass, period = one.pushed(PeriodicPush(kind=kind, omega=omega, width=width)), 2 * math.pi / omega
    t = np.array([0.0, 0.97 * share * period])
    steady, rest, whole = mass.steady(t), mass.from_rest(t), mass.steady(np.linspace(0, period, 33))
    v_0 = steady.v[0] - (mass.push.size / m if mass.push.impulsive else 0.0)
    free = one.motion(steady.x[0], v_0, t)
    drawn = SteadyMotion(oscillator=one, push=mass.push).at(t)
    swings = math.sqrt(k / m) * period  # whose phase has an additional rounding error
    for name, quick in zip("xv", drawn, strict=True):
        found, parts = getattr(steady, name), (getattr(rest, name), getattr(free, name))
        largest = max(np.max(np.abs(getattr(whole, name))), np.max(np.abs(found)))
        assert np.abs(found - sum(parts))[1] <= 16 * U * (largest + sum(map(np.abs, parts))[1])
        assert np.all(np.abs(quick - found) <= (1e-9 + 1e-12 * swings) * largest)


@each_case
def test_steady_motions_are_drawn_and_played_within_a_tenth_of_a_pixel(case: dict[str, Any]) -> None:
    """Samples join the motion within 1/2000 of the largest x, of which a plot has 100 pixels; doubles within 1e-13.

    From a start they are within 1e-12, at the resonance of a harmonic too.
    """
    oscillator, mass = pushed(case)
    if not case["k"]:
        with pytest.raises(ValueError, match="needs a spring"):
            SteadyMotion(oscillator=oscillator, push=mass.push)
        return
    if mass.push.once:
        return
    motion: Any = SteadyMotion(oscillator=oscillator, push=mass.push)
    if case["steady_exists"]:
        t = np.sort(np.concatenate([np.array(case["t"]), (np.arange(40) + 0.37) * motion.period / 40]))
        exact, (x, v) = mass.steady(t), motion.at(t)
        assert x == pytest.approx(exact.x, abs=1e-13 * motion.size)
        assert v == pytest.approx(exact.v, abs=1e-13 * np.max(np.abs(exact.v)))
        assert motion.x.played.at(t) == pytest.approx(exact.x, abs=5e-4 * motion.size)
        assert np.max(np.abs(x)) <= 1.01 * motion.size
    t = np.linspace(0.0, 7.3 * motion.period, 200)
    x, v = motion.from_start(0.3, -0.2, t)
    rest, free = mass.from_rest(t), oscillator.motion(0.3, -0.2, t)
    assert x == pytest.approx(rest.x + free.x, abs=1e-12 * np.max(np.abs(x)))
    assert v == pytest.approx(rest.v + free.v, abs=1e-12 * np.max(np.abs(v)))
    whole = PushedVibration(oscillator=oscillator, push=mass.push, x_0=0.3, v_0=-0.2, t=t).x
    assert whole.at(t) == pytest.approx(rest.x + free.x, rel=1e-15, abs=0)


@pytest.mark.parametrize("kind", ["step", "impulse"])
@pytest.mark.parametrize("c", [0.0, 0.4, 3.0])
def test_after_a_push_that_does_not_repeat_a_free_motion_is_left(kind: Any, c: float) -> None:
    oscillator, t = DampedOscillator(m=0.5, c=c, k=2.0), np.linspace(0.0, 9.0, 300)
    push = PeriodicPush(kind=kind, size=3.0)
    motion, mass = PushedVibration(oscillator=oscillator, push=push, x_0=0.2, v_0=-0.5, t=t), oscillator.pushed(push)
    true = mass.from_rest(t).x + oscillator.motion(0.2, -0.5, t).x
    assert motion.x.at(t) == pytest.approx(true, rel=1e-15, abs=0)
    assert motion.x_p.at(t) + motion.transient.x.at(t) == pytest.approx(true, abs=1e-14)
    x, v = RestAfterPush(oscillator=oscillator, push=push).from_start(0.2, -0.5, t)
    assert x == pytest.approx(true, abs=1e-13) and v[0] == (5.5 if kind == "impulse" else -0.5)
    assert motion.tallest == pytest.approx(np.abs(true).max())
    assert mass.from_rest([0.0]).v[0] == (6.0 if kind == "impulse" else 0.0)
    if c:
        at_last = 1.5 if kind == "step" else 0.0
        assert mass.steady([1.0]).x[0] == at_last
        assert mass.from_rest([400.0]).x[0] == pytest.approx(at_last, abs=1e-15)
    with pytest.raises(ValueError, match="a push that repeats is needed"):
        push.line(1)


def sliced(count: int, end: float = 6.0, **start: float) -> SlicedPush:
    """A square push, with its edges between slices."""
    push = PeriodicPush(kind="square", size=2.0, omega=2 * math.pi / 3)
    return SlicedPush(oscillator=ONE, force=ONE.pushed(push).force, end=end, count=count, **start)


@pytest.mark.parametrize("count", [1, 7, 200])
def test_the_sum_is_played_as_it_is(count: int) -> None:
    found, t = sliced(count), np.linspace(0.0, 6.0, 333)
    played: Any = found.x
    assert played.played.at(t) == pytest.approx(found.x.at(t), abs=0.01 * found.reach)
    assert found.reach == pytest.approx(np.abs(found.x.at(np.linspace(0, 6, 2000))).max(), rel=0.01)
    begun = sliced(count, x_0=0.1, v_0=-0.2)
    free = ONE.motion(0.1, -0.2, t).x
    assert begun.x.at(t) == pytest.approx(found.x.at(t) + free, abs=1e-14)
    assert begun.reach == pytest.approx(np.abs(begun.x.at(np.linspace(0, 6, 2000))).max(), rel=0.01)


def test_what_the_slices_leave_adds_up_to_the_sum() -> None:
    found = sliced(8)
    each = tails(ONE, found.times, found.sizes, found.end, 4000)
    assert [tail.t[0] for tail in each] == found.times.tolist() and {tail.t[-1] for tail in each} == {6.0}
    assert not any(tail.x[0] for tail in each) and sum(len(tail.t) for tail in each) == pytest.approx(4000, abs=20)
    t = np.linspace(0.0, 6.0, 100)
    total = sum(np.interp(t, tail.t, tail.x, left=0.0) for tail in each)
    assert total == pytest.approx(found.x.at(t), abs=1e-4)
    path = joined(each)
    assert path.t[len(each[0].t) - 1] == path.t[len(each[0].t)] == 6.0, "to the end and back"
    assert sorted(path.x) == sorted(np.concatenate([tail.x for tail in each]))


@pytest.mark.parametrize("kind", PERIODIC)
@pytest.mark.parametrize("end", [1.3, 5.0, 11.0])
def test_at_first_they_are_what_the_last_period_brought(kind: Any, end: float) -> None:
    """In the end both are the work of a cycle."""
    steady = SteadyMotion(oscillator=ONE, push=PeriodicPush(kind=kind, size=3.0, omega=2.0, width=0.3))
    last = mean_powers(steady, 0.1, 0.0, 60.0, 400)
    assert [last.t[-1], last.P_in[-1], last.P_lost[-1]] == pytest.approx(
        [60.0, *[steady.mass.work / math.pi] * 2], rel=1e-6
    )
    found = mean_powers(steady, 0.1, -0.4, end, 60)
    assert np.all(np.diff(found.t) > 0) and len(found.t) >= 60
    assert found.P_in[0] == (0.0 if kind != "impulses" else pytest.approx(3.0 * (-0.4 + 1.0) / steady.period))
    for i in (len(found.t) // 3, -1):
        last = found.t[i]
        t = np.linspace(max(last - steady.period, 0.0), last, 40001)
        _, v = steady.from_start(0.1, -0.4, t)
        assert found.P_lost[i] == pytest.approx(np.trapezoid(ONE.c * v**2, t) / steady.period, rel=1e-3)
        put_in = np.trapezoid(steady.force_at(t) * v, t)
        if kind == "impulses":
            into = np.flatnonzero(np.diff(v) > 1.0)
            assert len(into) == (1 if last >= steady.period else 0)
            put_in = sum(3.0 * (v[n] + v[n + 1]) / 2 for n in into)
            put_in += 3.0 * (-0.4 + 3.0 / ONE.m / 2) if last < steady.period else 0.0
        assert found.P_in[i] * steady.period == pytest.approx(put_in, rel=2e-3, abs=2e-3)


@pytest.mark.parametrize("k", [1e30, 1e80])
@pytest.mark.parametrize("kind", ["square", "pulses", "triangle"])
def test_a_mass_that_turns_often_in_the_last_bit_of_a_time_stays_in_its_range(kind: Any, k: float) -> None:
    push, t = PeriodicPush(kind=kind, size=2.0, omega=4.4, width=0.2), np.linspace(0.0, 6.0, 200)
    mass = DampedOscillator(m=1.0, c=2.5, k=k).pushed(push)
    for motion in (mass.steady(t), mass.from_rest(t)):
        assert np.abs(motion.x).max() < 10 * push.size / k
        assert np.abs(motion.v).max() < 10 * push.size / math.sqrt(k)

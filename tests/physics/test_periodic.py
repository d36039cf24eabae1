"""Pushes that repeat or act once, and the motions under them, against 50 digits and closed forms."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.damped import DampedOscillator
from physics.periodic import PeriodicPush
from physics.pushed import PushedMass
from physics.steady_motions import SteadyMotion
from tests.grids import tries
from tests.physics.chain_cases import log_uniform

U = 2.0**-53
CASES = json.loads((Path(__file__).parents[1] / "reference" / "periodic_cases.json").read_text())["cases"]
STEADY = [case for case in CASES if case["steady_exists"]]
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: str(case["id"]))
each_steady = pytest.mark.parametrize("case", STEADY, ids=lambda case: str(case["id"]))
PERIODIC = ("square", "triangle", "pulses", "impulses")


def mass_of(case: dict[str, Any]) -> PushedMass:
    width = {"width": case["duty"]} if case["duty"] else {}
    push = PeriodicPush(kind=case["kind"], size=case["F"], omega=case["omega"], **width)
    return DampedOscillator(m=case["m"], c=case["c"], k=case["k"]).pushed(push)


def within(found: Any, true: list[str], room: float) -> None:
    with mp.workdps(30):
        errors = [float(abs(mp.mpf(float(a)) - mp.mpf(b))) for a, b in zip(found, true, strict=True)]
    assert max(errors) <= room


@each_steady
def test_steady_motions_are_within_4_u_of_the_reference(case: dict[str, Any]) -> None:
    mass = mass_of(case)
    oscillator = DampedOscillator(m=case["m"], c=case["c"], k=case["k"])
    motion, period = oscillator.steady(mass.push, case["t"]), 2 * math.pi / case["omega"]
    whole = mass.steady(np.linspace(0, period, 101))
    within(motion.x, case["x"], 4 * U * np.max(np.abs(whole.x)))
    within(motion.v, case["v"], 4 * U * np.max(np.abs(whole.v)))
    assert mass.work == pytest.approx(float(case["work_per_cycle"]), rel=2 * U, abs=0)
    later = mass.steady(np.array(case["t"]) + 2**20 * period)
    assert later.x == pytest.approx(motion.x, abs=1e-8 * np.max(np.abs(whole.v)) * period)


@each_case
def test_steady_motions_exist_where_the_reference_says(case: dict[str, Any]) -> None:
    mass = mass_of(case)
    assert mass.steady_exists == case["steady_exists"]
    assert mass.growth == pytest.approx(float(case.get("growth_per_second") or 0.0), rel=4 * U, abs=0)
    if not mass.steady_exists:
        with pytest.raises(ValueError, match="is needed"):
            mass.steady([0.0])


@each_case
def test_lines_are_those_of_the_reference(case: dict[str, Any]) -> None:
    for line, true in zip(mass_of(case).lines(9), case["lines"], strict=True):
        f = complex(*map(float, true["f"]))
        assert line.n == true["n"] and abs(line.f - f) <= 4 * U * abs(f)
        if true["X"] is None:
            assert np.isinf(line.X)
        else:
            X = complex(*map(float, true["X"]))
            assert abs(line.X - X) <= 5 * U * abs(X)


@each_case
def test_motions_from_rest_are_within_4_u_of_the_reference(case: dict[str, Any]) -> None:
    mass, t = mass_of(case), case["rest"]["t"]
    grid = np.union1d(np.linspace(0, max(t), 61), t)
    motion = mass.from_rest(grid)
    for values, name in ((motion.x, "x"), (motion.v, "v")):
        within(values[np.searchsorted(grid, t)], case["rest"][name], 4 * U * np.max(np.abs(values)))
    for kind, key, symbol in (("impulse", "impulse_response", "h"), ("step", "step_response", "H")):
        if case.get(key):
            once = PushedMass(mass.m, mass.c, mass.k, PeriodicPush(kind=kind))
            values = once.from_rest(case[key]["t"]).x
            within(values, case[key][symbol], 4 * U * np.max(np.abs(values)))


@pytest.mark.parametrize("case", [one for one in CASES if one.get("convolution")], ids=lambda case: str(case["id"]))
def test_slices_of_a_push_add_up_as_in_the_reference(case: dict[str, Any]) -> None:
    mass, true = mass_of(case), case["convolution"]
    exact = mass.from_rest([true["t"]]).x[0]
    assert exact == pytest.approx(float(true["exact"]), rel=1e-12)
    for count, value in true["midpoint"].items():
        _, sizes, left = mass.convolution(true["t"], int(count))
        assert left.sum() == pytest.approx(float(value), rel=1e-11, abs=1e-13 * np.abs(left).sum())
        assert len(sizes) == int(count)


def divided(f: Any, nodes: list[Any], hair: Any) -> Any:
    """The divided difference of f over nodes, equal ones a hair apart."""
    apart: list[Any] = []
    for z in nodes:
        while any(abs(z - other) < hair / 2 for other in apart):
            z += hair
        apart.append(z)
    return mp.fsum(f(z) / mp.fprod(z - other for other in apart if other is not z) for z in apart)


def closed_form(mass: PushedMass, share: Any) -> tuple[Any, Any]:
    """x and v of the steady motion by one divided difference for each kind of push."""
    m, c, k, F = (mp.mpf(one) for one in (mass.m, mass.c, mass.k, mass.push.size))
    T, w = 2 * mp.pi / mp.mpf(mass.push.omega), mp.mpf(mass.push.width)
    root = mp.sqrt(mp.mpc(c * c - 4 * m * k))
    p, hair = [(-c + root) / (2 * m), (-c - root) / (2 * m)], mp.mpf(10) ** (-mp.mp.dps // 5) / T
    zero = mp.mpc(0)

    def exp(z: Any) -> Any:
        return mp.exp(z) if mp.re(z) > -1e4 else zero

    def both(f: Any, zeros: int, factor: Any) -> tuple[Any, Any]:
        x, v = (mp.re(divided(f, [zero] * n + p, hair)) for n in (zeros, zeros - 1))
        return factor * x, factor * v

    t, kind = share * T, mass.push.kind
    if kind in ("square", "triangle"):
        t, sign = (t, 1) if kind == "square" else (t + T / 4, 1)
        while t >= T / 2:
            t, sign = t - T / 2, -sign
        zeros, factor = (1, 2 * F / m) if kind == "square" else (2, 8 * F / (m * T))
        return both(lambda z: exp(z * t) / (1 + exp(z * T / 2)), zeros, sign * factor)
    if kind == "pulses":
        if share < w:
            over = both(lambda z: (exp(z * t) - exp(z * (t + T - w * T))) / (1 - exp(z * T)) if z else 1 - w, 1, F / m)
        else:
            over = both(lambda z: (exp(z * t) - exp(z * (t - w * T))) / (1 - exp(z * T)) if z else -w, 1, F / m)
        return over[0] + F * w / k, over[1]
    at = [mp.re(divided(lambda z, n=n: z**n * exp(z * t) / (1 - exp(z * T)), p, hair)) for n in (0, 1)]
    return F / m * at[0], F / m * at[1]


@settings(max_examples=tries(160))
@given(
    *[log_uniform(-40, 40)] * 4, st.floats(0.01, 0.99), st.floats(0.0, 0.999), st.sampled_from(PERIODIC), st.booleans()
)
def test_steady_motions_over_many_decades_are_within_4_u_of_closed_forms(
    m: float, c: float, k: float, omega: float, width: float, share: float, kind: Any, critical: bool
) -> None:
    c = 2 * math.sqrt(k * m) if critical else c
    mass = PushedMass(m, c, k, PeriodicPush(kind=kind, omega=omega, width=width))
    period = 2 * math.pi / omega
    t = share * period
    motion = mass.steady([t])
    whole = mass.steady(np.linspace(0, period, 33))
    with mp.workdps(250):
        true = closed_form(mass, mp.mpf(t) * mp.mpf(omega) / (2 * mp.pi))
        for value, wanted, row in zip((motion.x, motion.v), true, (whole.x, whole.v), strict=True):
            assert abs(value[0] - wanted) <= 4 * U * max(np.max(np.abs(row)), abs(float(wanted)))


@settings(max_examples=tries(100))
@given(*[log_uniform(-4, 4)] * 4, st.floats(0.1, 0.9), st.sampled_from(PERIODIC), st.floats(0.0, 30.0))
def test_from_rest_the_steady_motion_and_a_free_one_add_up(
    m: float, c: float, k: float, omega: float, width: float, kind: Any, t: float
) -> None:
    oscillator = DampedOscillator(m=m, c=c, k=k)
    mass = oscillator.pushed(PeriodicPush(kind=kind, omega=omega, width=width))
    start = mass.steady([0.0])
    jump = mass.push.size / m if mass.push.impulsive else 0.0
    free = oscillator.motion(-start.x[0], jump - start.v[0], [t])
    room = 1e-12 * (np.abs(start.x) + np.abs(start.v) / omega + jump / omega + 1 / k + 1 / (m * omega**2))
    assert mass.from_rest([t]).x == pytest.approx(mass.steady([t]).x + free.x, abs=room[0])


@settings(max_examples=tries(100))
@given(*[log_uniform(-6, 6)] * 4, st.floats(0.05, 0.95), st.sampled_from(PERIODIC))
def test_the_dashpot_takes_the_work_of_all_lines(
    m: float, c: float, k: float, omega: float, width: float, kind: Any
) -> None:
    """W = pi c omega sum n^2 |X_n|^2: what a thousand lines miss falls like 1/n or faster."""
    mass = PushedMass(m, c, k, PeriodicPush(kind=kind, omega=omega, width=width))
    assume(c * omega < 100 * k and math.sqrt(k / m) < 100 * omega)
    terms = [line.n**2 * abs(line.X) ** 2 for line in mass.lines(2000)]
    assert math.pi * c * omega * sum(terms) == pytest.approx(mass.work, rel=0.02)


@each_steady
def test_steady_motions_are_played_piece_by_piece(case: dict[str, Any]) -> None:
    """Within some 4 max(1, omega/omega_n)^2 u of the largest, and a share of u for each radian of the period."""
    mass = mass_of(case)
    oscillator = DampedOscillator(m=case["m"], c=case["c"], k=case["k"])
    if not case["k"]:
        with pytest.raises(ValueError, match="needs a spring"):
            SteadyMotion(oscillator=oscillator, push=mass.push)
        return
    motion = SteadyMotion(oscillator=oscillator, push=mass.push)
    period = 2 * math.pi / case["omega"]
    t = (np.arange(40) + 0.37) * period / 40
    quick, turns = max(1.0, case["omega"] / oscillator.omega_n), max(1.0, oscillator.omega_n * period)
    both: list[Any] = [motion.x, motion.v]
    for one in both:
        room = (16 * quick**2 + 4 * turns) * U * one.size()
        assert one.played.at(t) == pytest.approx(one.at(t), abs=room)


def test_a_line_that_is_missing_is_harmless() -> None:
    """The second harmonic of a square is missing; the third is not."""
    push = PeriodicPush(kind="square")
    assert PushedMass(1.0, 0.0, 4.0, push).steady([0.3]).x[0] == pytest.approx((1 - math.cos(0.6)) / 4, rel=1e-14)
    assert not PushedMass(1.0, 0.0, 9.0, push).steady_exists
    assert PushedMass(1.0, 0.0, math.nextafter(9.0, 10.0), push).steady_exists
    grown = np.abs(PushedMass(1.0, 0.0, 9.0, push).from_rest(np.linspace(2000, 2010, 200)).x).max()
    assert grown == pytest.approx(2005 * 0.07073553, rel=0.01)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"kind": "saw"}, "allowed"),
        ({"omega": 0.0}, "omega"),
        ({"width": 1.0}, "between 0 and 1"),
        ({"size": math.inf}, "size"),
    ],
)
def test_refusals_say_what_is_possible(change: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        PeriodicPush(**({"kind": "pulses"} | change))


def test_a_step_and_an_impulse_end_at_rest() -> None:
    step, impulse = (PushedMass(2.0, 1.0, 8.0, PeriodicPush(kind=kind, size=4.0)) for kind in ("step", "impulse"))
    assert step.steady([1.0]).x[0] == 0.5 and impulse.steady([1.0]).x[0] == 0.0
    assert step.from_rest([0.0, 200.0]).x.tolist() == [0.0, 0.5] and impulse.from_rest([0.0]).v[0] == 2.0
    with pytest.raises(ValueError, match="a push that repeats is needed"):
        step.push.line(1)

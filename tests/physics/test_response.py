"""Responses of the chain with dashpots to a force: amplitudes, lags, peaks, and the absorber."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.absorber import (
    damped_amplitude,
    damped_solution,
    highest_peak,
    swing_and_stroke,
)
from physics.bode import Resonances, chain_resonances, quarter_lags
from physics.bode_curves import bode_curves
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from tests.grids import tries
from tests.physics.references import each, reference
from tests.physics.truth import LARGEST, log_uniform, ulps

U = 2.0**-53
NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")


def chain_of(case: dict[str, Any]) -> DampedChain:
    return DampedChain(**{name: case[name] for name in NAMES})


@each(reference("bode"))
def test_peaks_dips_half_power_and_works_are_those_of_the_reference(case: dict[str, Any]) -> None:
    found = chain_resonances(chain_of(case))
    for one, name in zip(found, ("X1", "X2", "stroke"), strict=True):
        true = case["over_F_0"][name]
        check(one, [*true["peaks"], *true["dips"]])
        assert one.poles == pytest.approx([float(w) for w in true["infinite"]], rel=U, abs=0)
    wanted = [float(w) for w in case["quarter_lag_1"]]
    assert quarter_lags(chain_of(case)) == pytest.approx(wanted, rel=U, abs=0)
    for omega, true in zip(case["omega"], case["at"], strict=True):
        if true:
            works = chain_of(case).works(omega, case["F_0"])
            assert works == pytest.approx([float(one) for one in true["work"][1:]], rel=4 * U, abs=0)


def check(found: Resonances, wanted: list[dict[str, Any]]) -> None:
    every = [*found.peaks, *found.dips]
    assert len(every) == len(wanted)
    for one, true in zip(every, wanted, strict=True):
        sides = [None if side is None else float(side) for side in true.get("half_power", (None, None))]
        assert [side is None for side in one.half_power] == [side is None for side in sides]
        pairs = [(one.omega, float(true["omega"])), (one.height, float(true["height"]))]
        pairs += [(a, b) for a, b in zip(one.half_power, sides, strict=True) if a and b]
        assert all(a == pytest.approx(b, rel=U, abs=0) for a, b in pairs)


@settings(max_examples=tries(400))
@given(*[log_uniform(-150, 150)] * 7, st.sets(st.sampled_from(NAMES[2:])))
def test_lags_over_many_decades_are_those_of_the_forces(
    m1: float, m2: float, k1: float, k2: float, c1: float, c2: float, omega: float, none: set[str]
) -> None:
    """Lag 1 from 60 digits; lag 2 is behind it by an angle from 0 to pi."""
    chain = DampedChain(**(dict(zip(NAMES, (m1, m2, k1, k2, c1, c2), strict=True)) | dict.fromkeys(none, 0.0)))
    assume(chain.c1 or chain.c2)
    lags = chain.lags(omega).tolist()
    with mp.workdps(800):
        m1, m2, k1, k2, c1, c2, w = (mp.mpf(one) for one in (*(getattr(chain, name) for name in NAMES), omega))
        link, N = mp.mpc(k2, c2 * w), mp.mpc(k2 - m2 * w**2, c2 * w)
        D = mp.mpc(k1 - m1 * w**2, c1 * w) * N - m2 * w**2 * link
        assume(N)
        first = mp.arg(D / N)
        assert abs(lags[0] - first) <= 2 * U and 0 <= lags[0] <= math.pi
        if link:
            assert abs(lags[1] - lags[0] - mp.arg(N / link)) <= 8 * U and lags[0] <= lags[1] <= 2 * math.pi


F_0 = 500.0
FAMILIES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "all doubles": log_uniform(-1074, 1024),
}


def newton(chain, c, F, omega, c1=0.0):
    """The steady amplitudes from Newton's laws as two linear equations."""
    m1, m2, k1, k2, c, F, w, c1 = map(mp.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, c, F, omega, c1))
    link = mp.mpc(k2, c * w)
    a, d = mp.mpc(k1, c1 * w) + link - m1 * w**2, link - m2 * w**2
    return d * F / (a * d - link**2), link * F / (a * d - link**2)


@pytest.mark.parametrize("numbers", FAMILIES.values(), ids=FAMILIES)
@settings(max_examples=tries(120))
@given(data=st.data(), missing=st.sets(st.sampled_from(["k1", "k2", "c", "c1"])))
def test_amplitudes_and_stroke_are_those_of_newtons_laws(numbers, data, missing):
    given = {name: data.draw(numbers) for name in ("m1", "m2", "k1", "k2", "c", "F", "omega", "c1")}
    m1, m2, k1, k2, *drive = (given | dict.fromkeys(missing, 0.0)).values()
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    with mp.workprec(20000):
        one, two = newton(chain, *drive)
        try:
            swing, stroke = swing_and_stroke(chain, *drive)
            sizes, parts = damped_amplitude(chain, *drive), damped_solution(chain, *drive)
        except ValueError as refusal:
            assert "leaves the range of doubles" in str(refusal)
            assert max(abs(one), abs(two), abs(two - one)) > LARGEST / 2
            return
        assert ulps(swing, abs(one)) <= 0.51 and ulps(stroke, abs(two - one)) <= 4
        for size, part, true in zip(sizes, parts, (one, two), strict=True):
            assert ulps(size, abs(true)) <= 0.51
            assert ulps(part.real, true.real) <= 0.51 and ulps(part.imag, true.imag) <= 0.51


@pytest.mark.parametrize(
    ("numbers", "omega", "lags"),
    [
        ({"k1": 4.0, "k2": 2.0}, [0.0, 1.0, 1.2, 2.0, 9.0], [(0, 0), (0, 0), (1, 1), (0, 1), (1, 2)]),
        ({"k1": 0.0, "k2": 2.0, "c1": 1.0}, [0.0], [(0.5, 0.5)]),
        ({"k1": 0.0, "k2": 2.0, "c2": 1.0}, [0.0], [(1, 1)]),
        ({"k1": 0.0, "k2": 0.0}, [0.0], [(1, 1)]),
        ({"k1": 4.0, "k2": 0.0, "c1": 1.0}, [0.0], [(0, 0)]),
    ],
)
def test_lags_in_limits(numbers: dict[str, float], omega: list[float], lags: list[tuple[float, float]]) -> None:
    """In half turns; at a natural frequency without dashpots the lag of the frequencies just below."""
    found = DampedChain(m1=2, m2=1, **numbers).lags(omega).T / math.pi
    assert found.tolist() == [list(pair) for pair in lags]


def test_at_a_pole_a_mass_without_a_link_stays_at_rest() -> None:
    for k2 in (0.0, 2.0):
        chain = DampedChain(m1=2.0, m2=1.0, k1=4.0 if k2 else 8.0, k2=k2)
        X = bode_curves(chain, [2.0], 3.0).X
        np.testing.assert_array_equal(X, chain.response([2.0], 3.0))
        assert np.isinf(X[0]) and (X[1] == 0.0) == (k2 == 0.0)


@pytest.mark.parametrize("k1", [0.0, 250e3])
def test_at_rest_a_damper_without_a_spring_does_nothing(k1):
    """N and kappa share a factor omega, which must not become 0/0."""
    still = damped_amplitude(TwoMassChain(m1=100.0, m2=16.0, k1=k1, k2=0.0), 50.0, F_0, [0.0])
    assert np.array_equal(still, np.full((2, 1), F_0 / k1 if k1 else math.inf))


@pytest.mark.parametrize(
    ("mu", "tuning", "damping"),
    [(0.01, 1 / 1.01, 0.0603), (0.16, 0.8, 0.05), (0.16, 1.1, 0.3), (0.16, 0.86, 0.168), (1.0, 0.5, 0.2165)],
)
def test_the_highest_peak_is_that_of_the_curve(mu, tuning, damping):
    chain = TwoMassChain(m1=1.0, m2=mu, k1=1.0, k2=mu * tuning**2)
    seen = damped_amplitude(chain, 2 * mu * damping, 1.0, np.linspace(0.3, 2.0, 20_001))[0].max()
    assert highest_peak(mu, tuning, damping) == pytest.approx(seen, rel=1e-5)
    assert highest_peak(mu, tuning, 0.0) == math.inf
    assert highest_peak(mu, tuning, 1e4) > 1e3, "a nearly rigid link makes one heavier mass"

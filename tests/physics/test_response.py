"""Responses of the chain with dashpots to a force: amplitudes, lags, peaks, and the absorber."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from physics.absorber import (
    alone,
    damped_amplitude,
    damped_solution,
    den_hartog,
    fixed_points,
    helped_band,
    highest_peak,
    swing_and_stroke,
)
from physics.absorber_curves import machine_curves
from physics.bode import Resonances, chain_resonances, quarter_lags
from physics.bode_curves import bode_curves
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.forced import antiresonance, particular_solution
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


@settings(max_examples=tries(150))
@given(*[log_uniform(-40, 40)] * 7, st.sets(st.sampled_from(NAMES[2:])), st.floats(-3, 3))
def test_curves_are_those_of_single_frequencies(
    m1: float, m2: float, k1: float, k2: float, c1: float, c2: float, F_0: float, none: set[str], octaves: float
) -> None:
    """Also where a product would leave the doubles, and next to a natural frequency."""
    chain = DampedChain(**(dict(zip(NAMES, (m1, m2, k1, k2, c1, c2), strict=True)) | dict.fromkeys(none, 0.0)))
    natural = chain.chain.modes().omega
    omega = np.unique([*natural, *(natural * (1 + 1e-9)), *(natural * 2.0**octaves), 1.0])
    omega = omega[omega > 0]
    found, true, lags = bode_curves(chain, omega, F_0), chain.response(omega, F_0), chain.lags(omega)
    finite = np.isfinite(true).all(axis=0)
    np.testing.assert_array_equal(np.isfinite(found.X).all(axis=0), finite)
    assert np.all(np.abs(found.X - true)[:, finite] <= 9 * U * np.abs(true[:, finite]))
    still = (true == 0.0).any(axis=0)  # no swing, no lag
    assert np.all(np.abs(found.lags - lags)[:, finite & ~still] <= 16 * U)


def test_at_a_pole_a_mass_without_a_link_stays_at_rest() -> None:
    for k2 in (0.0, 2.0):
        chain = DampedChain(m1=2.0, m2=1.0, k1=4.0 if k2 else 8.0, k2=k2)
        X = bode_curves(chain, [2.0], 3.0).X
        np.testing.assert_array_equal(X, chain.response([2.0], 3.0))
        assert np.isinf(X[0]) and (X[1] == 0.0) == (k2 == 0.0)


MACHINE = {"m1": 100.0, "k1": 250e3}
F_0 = 500.0
FAMILIES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "all doubles": log_uniform(-1074, 1024),
}
values = st.floats(1e-3, 1e6)
or_none = st.one_of(st.just(0.0), values)


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


@pytest.mark.parametrize("k1", [0.0, 250e3])
def test_at_rest_a_damper_without_a_spring_does_nothing(k1):
    """N and kappa share a factor omega, which must not become 0/0."""
    still = damped_amplitude(TwoMassChain(m1=100.0, m2=16.0, k1=k1, k2=0.0), 50.0, F_0, [0.0])
    assert np.array_equal(still, np.full((2, 1), F_0 / k1 if k1 else math.inf))


def one_by_one(chain, c, omega):
    """Swing, stroke and swing alone from whole numbers, each rounded once."""
    by_itself = [abs(particular_solution(alone(chain), F_0, w)[0]) for w in omega]
    return np.array([*swing_and_stroke(chain, c, F_0, omega), by_itself])


def near(chain):
    """Every frequency at which something would cancel, and its neighbours."""
    poles = [*chain.modes().omega, *alone(chain).modes().omega, antiresonance(chain), math.sqrt(chain.k1 / 2)]
    return sorted({w for pole in poles if pole for w in (pole, *np.nextafter(pole, (0.0, math.inf)), 1.001 * pole)})


@settings(max_examples=tries(150))
@given(values, values, values, or_none, or_none, values)
@example(100.0, 16.0, 250e3, 36864.0, 1e250, 1.0)
def test_a_curve_is_within_six_ulps(m1, m2, k1, k2, c, omega):
    """Far out each frequency is computed by itself."""
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    for frequencies in ([*near(chain), omega], [0.0, omega], [1e-200, omega], [omega, 1e150]):
        found, true = machine_curves(chain, c, F_0, frequencies), one_by_one(chain, c, frequencies)
        finite = np.isfinite(true)
        np.testing.assert_array_equal(np.isfinite(found), finite)
        assert np.all(np.abs(found[finite] - true[finite]) <= 6 * np.spacing(true[finite]))


@pytest.mark.parametrize("c", [0.0, 3.0, 313.7, 600.0, 1e6])
@pytest.mark.parametrize(("m2", "k2"), [(16.0, 36864.0), (1.0, 100.0), (200.0, 1e5), (16.0, 0.0)])
def test_helped_band_is_where_the_machine_swings_less(m2, k2, c):
    chain = TwoMassChain(**MACHINE, m2=m2, k2=k2)
    band = helped_band(chain, c)
    omega = np.geomspace(1.0, 1e4, 4001)
    less = damped_amplitude(chain, c, F_0, omega)[0] < np.abs(particular_solution(alone(chain), F_0, omega)[0])
    if band is None:
        assert not less.any()
        return
    edges = [e for e in band if math.isfinite(e)]
    clear = np.all([np.abs(omega / e - 1) > 1e-6 for e in edges], axis=0)
    assert np.array_equal(less[clear], ((omega > band[0]) & (omega < band[1]))[clear])
    assert less.any()


@pytest.mark.parametrize("mu", [0.01, 0.16, 1.0])
def test_optimum_is_den_hartogs(mu):
    m2 = 100.0 * mu
    best = den_hartog(100.0, 250e3, m2)
    assert math.sqrt(best.k2 / m2) == pytest.approx(50.0 / (1 + mu), rel=1e-14)
    assert best.c / (2 * m2 * 50.0) == pytest.approx(math.sqrt(3 * mu / (8 * (1 + mu) ** 3)), rel=1e-14)
    assert best.height == pytest.approx(math.sqrt(1 + 2 / mu), rel=1e-14)
    chain = TwoMassChain(**MACHINE, m2=m2, k2=best.k2)
    for c in (best.c, 1e9):
        at_points = damped_amplitude(chain, c, F_0, fixed_points(chain))[0]
        assert at_points == pytest.approx(best.height * F_0 / 250e3, rel=1e-12)


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

"""Chains: N equal masses, how two masses find their modes, and their responses to a force with dashpots."""

import math
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.absorber import damped_amplitude, damped_solution, highest_peak, swing_and_stroke
from physics.bode import chain_resonances, quarter_lags
from physics.bode_curves import bode_curves
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped_chain import DampedChain
from physics.modes import determinant_curve, mixture, row_curves, trial
from physics.sweeps import PARAMETERS, limit, sweep
from tests.grids import tries
from tests.physics.truth import LARGEST, U, each, each_magnitude, log_uniform, reference, steady, ulps

ENDS = ("fixed-fixed", "fixed-free", "free-free")
starts = st.lists(st.floats(-1, 1), min_size=24, max_size=24)
GOOD = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
NO_WALL, LOOSE = replace(GOOD, k1=0.0), replace(GOOD, k2=0.0)
usual = log_uniform(-10, 10)
usual_chains = st.builds(TwoMassChain, m1=usual, m2=usual, k1=usual, k2=usual)
thorough = settings(max_examples=tries(60))
NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")


def error(value: float, true: str) -> Any:
    return abs(mp.mpf(float(value)) - mp.mpf(true))


@each([case for case in reference("beyond", "chain") if case["ends"] in ENDS])
def test_modes_and_motions_are_those_of_the_reference(case: dict[str, Any]) -> None:
    chain = UniformChain(N=case["N"], m=case["m"], k=case["k"], ends=case["ends"])
    energies = chain.modes(case["x_0"], case["v_0"]).energy
    for j, omega, shape, energy in zip(case["modes"], case["omega"], case["shapes"], case["E_modes"], strict=True):
        i = j if case["ends"] == "free-free" else j - 1
        assert error(chain.omega[i], omega) <= U * float(omega)
        for p, value in zip(case["beads"], shape, strict=True):
            assert error(chain.shapes[i, p - 1], value) <= U * abs(float(value))
        assert error(energies[i], energy) <= 4 * U * float(case["E"])
    motion = chain.motion(case["x_0"], case["v_0"], case["t"])
    for values, name, sizes in ((motion.x, "x", case["size"][0]), (motion.v, "v", case["size"][1])):
        for n in range(len(case["t"])):
            for i, p in enumerate(case["beads"]):
                assert error(values[p - 1, n], case[name][n][i]) <= 4 * U * sizes[n][i] + 5e-324
    if pluck := case.get("pluck"):
        x = chain.pluck(pluck["s"], pluck["h"])
        assert x[pluck["s"] - 1] == pluck["h"]
        modes = chain.modes(x, np.zeros(chain.N))
        found = [modes.amplitude[j - 1] * chain.shapes[j - 1, 0] / math.sin(chain.theta[j - 1]) for j in case["modes"]]
        assert np.abs(found) == pytest.approx([abs(float(B)) for B in pluck["B"]], rel=1e-9, abs=1e-12)


@settings(max_examples=tries(120))
@given(st.integers(1, 24), log_uniform(-400, 400), log_uniform(-400, 400), st.sampled_from(ENDS), starts, starts)
def test_over_all_decades_the_modes_have_all_the_energy_and_start_from_the_start(N, m, k, ends, x_0, v_0):
    chain = UniformChain(N=N, m=m, k=k, ends=ends)
    Omega = math.sqrt(k) / math.sqrt(m)
    x, v = np.array(x_0[:N]), Omega * np.array(v_0[:N])
    motion = chain.motion(x, v, [0.0, 3.0 / Omega])
    assert np.abs(motion.x[:, 0] - x).max() <= 2 * U * np.abs(x).max() + 1e-20 * np.abs(v).max() / Omega + 1e-300
    modes = chain.modes(x, v)
    walls = {"fixed-fixed": [0.0, *x, 0.0], "fixed-free": [0.0, *x], "free-free": list(x)}[ends]
    energy = (np.sum(v * v) / Omega**2 + np.sum(np.diff(walls) ** 2)) / 2
    assert np.sum(modes.energy / k) == pytest.approx(energy, rel=1e-13, abs=1e-300)
    back = chain.motion(motion.x[:, 1], -motion.v[:, 1], [3.0 / Omega])
    assert np.abs(back.x[:, 0] - x).max() <= 1e-13 * (np.abs(x).max() + np.abs(v).max() / Omega) * N + 1e-300
    if ends == "free-free":
        assert np.sum(motion.v[:, 1]) == pytest.approx(np.sum(v), abs=1e-14 * N * np.abs(v).max() + 1e-300)
        assert modes.drift == pytest.approx((np.mean(x), np.mean(v)), rel=1e-9, abs=1e-15 * (1 + Omega))


@thorough
@given(usual_chains, st.sampled_from([1.0, 1e300]))
def test_determinant_curve_keeps_its_digits_beside_a_root(chain: TwoMassChain, scale: float) -> None:
    """Also beyond the range of doubles."""
    chain = replace(chain, k1=scale * chain.k1, k2=scale * chain.k2)
    slow, fast = (float(w) for w in chain.modes().omega)
    omega = np.array([0.0, 0.5 * slow, slow * (1 + 1e-12), np.sqrt(slow * fast), fast * (1 - 1e-9), 1.2 * fast])
    curve, exponent = determinant_curve(chain, omega)
    assert (exponent == 0) == (scale == 1.0)
    exactly = [float(trial(chain, w).determinant.scaleb(-exponent)) for w in omega]
    np.testing.assert_allclose(curve, exactly, rtol=32 * U)


@thorough
@given(usual_chains, st.sampled_from(PARAMETERS))
def test_sweep_is_the_modes_of_each_chain(chain: TwoMassChain, name: str) -> None:
    """The frequencies with one mass held are between the modes, so the modes never meet: an avoided crossing."""
    run = sweep(chain, name, values := np.geomspace(1e-3, 1e3, 41))
    assert np.all(run.omega[0] <= run.held.min(axis=0) * (1 + 1e-15))
    assert np.all(run.omega[1] >= run.held.max(axis=0) * (1 - 1e-15))
    assert np.all(run.omega[0] < run.omega[1])
    for i in range(0, 41, 8):
        modes = replace(chain, **{name: float(values[i])}).modes()
        np.testing.assert_allclose(run.omega[:, i], modes.omega, rtol=8 * U)
        np.testing.assert_allclose(run.ratio[:, i], modes.ratio, rtol=1e-12)


@pytest.mark.parametrize("name", PARAMETERS)
@pytest.mark.parametrize("chain", [GOOD, NO_WALL, LOOSE], ids=["good", "no wall", "loose"])
@pytest.mark.parametrize("end", [0, 1])
def test_limits(name: str, chain: TwoMassChain, end: int) -> None:
    """A million times beyond the others the modes are their limits to about a millionth, each kind of limit its own."""
    value = np.array([1e-8, 1e8][end : end + 1])
    run, tends = sweep(chain, name, value), limit(chain, name, end, value)
    np.testing.assert_allclose(tends.omega, run.omega, rtol=1e-6)
    np.testing.assert_allclose(tends.ratio, run.ratio, rtol=1e-6)


@pytest.mark.parametrize(
    ("chain", "omega", "rows"),
    [
        (LOOSE, 1.0, (math.inf, 0.0)),
        (LOOSE, 0.0, (math.inf, None)),
        (replace(LOOSE, m1=1.0), 2.0, (None, 0.0)),
        (replace(LOOSE, k2=4.0), 2.0, (0.0, math.inf)),
    ],
)
def test_a_row_without_coupling_asks_for_rest_or_for_nothing(chain, omega, rows) -> None:
    found = trial(chain, omega)
    assert tuple(None if row is None else float(row) for row in found.rows) == rows
    assert chain.k2 or found.apart is None


@thorough
@given(usual_chains)
def test_row_curves_are_what_the_rows_say(chain: TwoMassChain) -> None:
    modes = chain.modes()
    end = 1.2 * float(modes.omega[1])
    largest = 6.0 * float(np.max(np.abs(modes.ratio)))
    first, second = row_curves(chain, end, largest)
    for branches, row in ((first, 0), (second, 1)):
        for omega, ratio in zip(branches.omega, branches.ratio, strict=True):
            assert np.all(np.diff(omega) >= 0)
            assert omega[0] >= 0 and omega[-1] <= end * (1 + 1e-15)
            for w, r in zip(omega[::20], ratio[::20], strict=True):
                found = trial(chain, float(w)).rows[row]
                assert found is None or float(found) == pytest.approx(r, rel=1e-6 * max(1, abs(r)), abs=1e-6 * largest)
    first, second = row_curves(LOOSE, 3.0, 10.0)
    np.testing.assert_allclose(first.omega[0], [np.sqrt(2.0)] * 2)
    np.testing.assert_array_equal(second.ratio[0], [0.0, 0.0])


@thorough
@given(usual_chains, st.floats(-2, 2), st.floats(-2, 2))
def test_shares_are_those_of_the_amplitudes(chain: TwoMassChain, x1: float, x2: float) -> None:
    assume(max(abs(x1), abs(x2)) > 1e-3)
    amplitude = free_modes(chain, (x1, x2), (0.0, 0.0)).amplitude
    sizes = np.hypot(*amplitude.T)
    *parts, width = mixture(chain, (x1, x2))
    np.testing.assert_allclose(parts, sizes / sizes.sum(), rtol=1e-13, atol=1e-300)
    assert width == pytest.approx(abs(np.linalg.det(amplitude)) / sizes.max() ** 2, rel=1e-9, abs=1e-15)
    assert mixture(chain, (0, 0)) == mixture(NO_WALL, (1, 1)) == (0.0, 0.0, 0.0)


@each(reference("bode"))
def test_peaks_dips_half_power_and_works_are_those_of_the_reference(case: dict[str, Any]) -> None:
    chain = DampedChain(**{name: case[name] for name in NAMES})
    for one, name in zip(chain_resonances(chain), ("X1", "X2", "stroke"), strict=True):
        true = case["over_F_0"][name]
        for found, wanted in zip([*one.peaks, *one.dips], [*true["peaks"], *true["dips"]], strict=True):
            sides = [None if side is None else float(side) for side in wanted.get("half_power", (None, None))]
            assert [side is None for side in found.half_power] == [side is None for side in sides]
            pairs = [(found.omega, float(wanted["omega"])), (found.height, float(wanted["height"]))]
            pairs += [(a, b) for a, b in zip(found.half_power, sides, strict=True) if a and b]
            assert all(a == pytest.approx(b, rel=U, abs=0) for a, b in pairs)
        assert one.poles == pytest.approx([float(w) for w in true["infinite"]], rel=U, abs=0)
    assert quarter_lags(chain) == pytest.approx([float(w) for w in case["quarter_lag_1"]], rel=U, abs=0)
    for omega, true in zip(case["omega"], case["at"], strict=True):
        if true:
            works = chain.works(omega, case["F_0"])
            assert works == pytest.approx([float(one) for one in true["work"][1:]], rel=4 * U, abs=0)


@settings(max_examples=tries(400))
@given(*[log_uniform(-150, 150)] * 7, st.sets(st.sampled_from(NAMES[2:])))
def test_lags_over_many_decades_are_those_of_the_forces(m1, m2, k1, k2, c1, c2, omega, none):
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


@each_magnitude
@settings(max_examples=tries(120))
@given(data=st.data(), missing=st.sets(st.sampled_from(["k1", "k2", "c", "c1"])))
def test_amplitudes_and_stroke_are_those_of_newtons_laws(magnitudes, data, missing):
    given = {name: data.draw(magnitudes) for name in ("m1", "m2", "k1", "k2", "c", "F", "omega", "c1")}
    m1, m2, k1, k2, c, F, omega, c1 = (given | dict.fromkeys(missing, 0.0)).values()
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    drive = (c, F, omega, c1)
    with mp.workprec(20000):
        one, two = steady(*map(mp.mpf, (m1, m2, k1, k2, F, omega, c1, c)))
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
    for k1, k2 in ((8.0, 0.0), (4.0, 2.0)):
        chain = DampedChain(m1=2.0, m2=1.0, k1=k1, k2=k2)
        X = bode_curves(chain, [2.0], 3.0).X
        np.testing.assert_array_equal(X, chain.response([2.0], 3.0))
        assert np.isinf(X[0]) and (X[1] == 0.0) == (k2 == 0.0)


@pytest.mark.parametrize("k1", [0.0, 250e3])
def test_at_rest_a_damper_without_a_spring_does_nothing(k1):
    """N and kappa share a factor omega, which must not become 0/0."""
    still = damped_amplitude(TwoMassChain(m1=100.0, m2=16.0, k1=k1, k2=0.0), 50.0, 500.0, [0.0])
    assert np.array_equal(still, np.full((2, 1), 500.0 / k1 if k1 else math.inf))


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

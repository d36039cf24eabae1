"""One driven oscillator: against the reference cases, at resonance, without damping, and by another solver."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import cumulative_trapezoid

from physics.bode import driven_resonances
from physics.driven import Drive, DrivenOscillator, drawn, lag
from physics.forced_vibration import ForcedVibration, SampledVibration
from physics.magnification import half_power, highest, magnification, ratios
from physics.sampling import drawable
from tests.grids import tries
from tests.physics.chain_families import log_uniform
from tests.physics.references import each, reference
from tests.physics.truth import U, ulps

KINDS = ("force", "base", "unbalance")

each_case = each(reference("beyond", "driven"))


def system(case):
    return DrivenOscillator(m=case["m"], c=case["c"], k=case["k"])


def drive(case):
    size = {"force": "F_0", "base": "Y"}.get(case["kind"])
    return {"omega": case["omega"], "size": case[size] if size else case["mu"] * case["e"], "kind": case["kind"]}


@each_case
def test_motion_is_within_four_u_of_the_amplitude_and_drawn_as_it_is(case):
    one, t = system(case), np.array(case["t"])
    motion = one.motion(**drive(case), x_0=case["x_0"], v_0=case["v_0"], t=t)
    free, turns = one.free.motion(case["x_0"], case["v_0"], t), 1 + max(case["omega"], one.free.omega_n) * t
    x, v = drawn(one.push(**drive(case)), t)
    for row, plain, name, sizes in (
        (motion.x, x + free.x, "x", case["size"][0]),
        (motion.v, v + free.v, "v", case["size"][1]),
    ):
        for n, text in enumerate(case[name]):
            assert abs(mp.mpf(row[n]) - mp.mpf(text)) <= 4 * U * 1.001 * sizes[n]
            assert abs(mp.mpf(plain[n]) - mp.mpf(text)) <= 6 * turns[n] * U * sizes[n]


@each_case
def test_steady_part(case):
    X = system(case).response(**drive(case))
    if case["X"] is None:
        assert math.inf == X and system(case).at_resonance(case["omega"])
        return
    for value, text in zip((X.real, X.imag), case["X"], strict=True):
        assert ulps(value, mp.mpf(text)) <= 4 if float(text) else value == 0
    assert ulps(abs(X), mp.mpf(case["amplitude"])) <= 4
    assert abs(lag(X) - mp.mpf(case["lag"])) <= 4 * U * lag(X)
    size, turned = system(case).bode([case["omega"]], drive(case)["size"], case["kind"])
    assert (size[0], turned[0]) == (abs(X), lag(X))


@each_case
def test_magnification_peak_and_half_power(case):
    zeta, r = float(case["zeta"]), float(case["r"])
    if math.isinf(r) or case["X"] is None:
        return
    near_resonance = 1 + min(1 / abs(1 - r) if r != 1 else math.inf, 1 / zeta if zeta else math.inf)
    size, over = drive(case)["size"], {"force": case["k"], "base": 1.0, "unbalance": case["m"]}[case["kind"]]
    true = float(case["amplitude"]) * over / size
    assert abs(magnification(r, zeta, case["kind"])[0]) == pytest.approx(true, rel=8 * U * near_resonance)
    found = highest(zeta, case["kind"])
    if found and zeta:
        assert ulps(found[0], mp.mpf(case["peak"]["r"])) <= 4 and ulps(found[1], mp.mpf(case["peak"]["ratio"])) <= 8
    resonances = driven_resonances(system(case), case["kind"])
    assert resonances.poles == (() if zeta else (system(case).free.omega_n,))
    assert len(resonances.peaks) == (case.get("peak") is not None and zeta > 0)
    for one in resonances.peaks:
        assert one.omega / system(case).free.omega_n == pytest.approx(float(case["peak"]["r"]), rel=2e-15)
        assert one.height * over == pytest.approx(float(case["peak"]["ratio"]), rel=1e-14)
    low, high = half_power(zeta)
    assert high - low == pytest.approx(2 * zeta, rel=1e-13, abs=4 * U)


@pytest.mark.parametrize("c", [0.0, 0.3, 9.0])
@pytest.mark.parametrize("kind", KINDS)
def test_mean_powers_are_work_over_a_period(kind, c):
    """The work of each force along the motion, in fine steps. Before t = 0 no work was done."""
    w, k, m, size, steps, end = 1.7, 8.0, 2.0, 0.7, 200_000, 14.0
    one = ForcedVibration(oscillator=DrivenOscillator(m=m, c=c, k=k), kind=kind, size=size, omega=w, x_0=0.2, v_0=-0.5)
    t = np.linspace(0.0, end, steps + 1)
    (x, v), (y, rate) = one.at(t), (size * np.sin(w * t), size * w * np.cos(w * t))
    if kind == "base":
        lost, put_in = c * (rate - v) ** 2, (k * (y - x) + c * (rate - v)) * rate
    else:
        lost, put_in = c * v**2, (w**2 if kind == "unbalance" else 1.0) * y * v
    found = one.mean_powers(end, 400)
    before = np.maximum(found.t - 2 * math.pi / w, 0.0)
    for power, mean in ((put_in, found.P_in), (lost, found.P_lost)):
        work = cumulative_trapezoid(power, t, initial=0.0)
        expected = (np.interp(found.t, t, work) - np.interp(before, t, work)) * w / (2 * math.pi)
        assert np.abs(mean - expected).max() < 1e-5 * np.abs(expected).max() + 1e-12


@settings(max_examples=tries(200))
@given(log_uniform(-13, 2), log_uniform(-6, -1), log_uniform(1, 6), st.booleans())
def test_a_curve_over_the_ratio_is_nearly_straight_between_its_points(
    zeta: float, low: float, high: float, log: bool
) -> None:
    r = ratios(zeta, low, high, log)
    assert np.all(np.diff(r) > 0) and 1.0 in r and low <= r[0] <= low + high / 90 and high * (1 - 1e-9) <= r[-1] <= high
    assert np.all(r[1:] - r[:-1] <= high / 89) if not log else np.all(r[1:] / r[:-1] <= (high / low) ** (1 / 89))
    middle = (r[1:] + r[:-1]) / 2
    for kind in KINDS:
        curve, between = (np.abs(magnification(one, zeta, kind)) for one in (r, middle))
        assert np.all(np.abs((curve[1:] + curve[:-1]) / 2 - between) <= 0.05 * curve.max())


@settings(max_examples=tries(200))
@given(st.sampled_from(KINDS), log_uniform(-3, 6), *[log_uniform(-3, 13)] * 2, log_uniform(-10, -1))
def test_what_is_too_fast_for_a_line_is_a_band_until_it_has_died(
    kind: Drive, end: float, omega: float, omega_n: float, zeta: float
) -> None:
    """The transient is seen while its amplitude is more than 0.2 % of the largest displacement."""
    one = DrivenOscillator(m=1.0, c=2 * zeta * omega_n, k=omega_n**2)
    forced = ForcedVibration(oscillator=one, kind=kind, size=0.1, omega=omega, x_0=0.2, v_0=0.0)
    t = np.linspace(0.0, end, 300)
    sampled = SampledVibration(vibration=forced, t=t, is_split=True)
    fast = [not drawable(each, t) for each in (one.free.omega_d, omega)]
    if not any(fast):
        assert not sampled.bands
    if not sampled.split:
        return
    rest = 0.2 - forced.X.imag, -omega * forced.X.real
    size = math.hypot(rest[0], (rest[1] + zeta * omega_n * rest[0]) / one.free.omega_d) * np.exp(-zeta * omega_n * t)
    seen = size > 0.002 * sampled.tallest
    assert ("x_c" in sampled.bands) == bool(fast[0] and seen[0])
    x = forced.at(t)[0]
    for name, (low, high, late) in sampled.bands.items():
        if name == "x":
            assert np.all(low - x <= 1e-9 * sampled.tallest) and np.all(x - high <= 1e-9 * sampled.tallest)
        if late is not None:
            assert late.size == np.count_nonzero(~seen)
            assert name != "x" or late == pytest.approx(x[seen.sum() :])

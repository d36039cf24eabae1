"""One mass: alone, hanging, damped and driven, a pendulum, an aircraft and analogues, against many digits.

Pendulum and phugoid are compared with Jacobi functions, Taylor series and book values.
"""

import math
import sys
from decimal import Decimal
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from scipy.integrate import cumulative_trapezoid

from physics.analogues import ANALOGUES, G
from physics.bode import driven_resonances
from physics.damped import DampedOscillator
from physics.driven import DrivenOscillator, drawn, lag
from physics.forced_vibration import ForcedVibration, SampledVibration
from physics.free_decay import FreeDecay
from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from physics.lanchester import CUSP_EXCESS, LINEAR_PERIOD, excess_at_period_excess, invariant, period_excess
from physics.magnification import half_power, highest, magnification, ratios
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.phugoid import EXCESS_AT_LATENESS, flight
from physics.reference.damped import free_part
from physics.reference.single import flight_points, period_ratio, swing
from physics.sampling import drawable
from tests.grids import sample, tries
from tests.physics.truth import U, each, each_magnitude, log_uniform, reference, ulps

LARGEST = sys.float_info.max
PRECISION = 2600  # bits: omega t may reach 2^2600
SIGNS = st.sampled_from([-1.0, 0.0, 1.0])
BITS = 4000
BOUND = 2.0  # u of the sum of the sizes of both parts
ZETAS = [0.0, 1.0, 1 + 2 * U, 1 - U, 1e8, 1e150, *(1 + apart for apart in (1e-9, -1e-9, 1e-5, -1e-5))]
AT_THE_ENDS = [  # of the doubles. A motion whose acceleration exceeds doubles is refused, so x starts small.
    ((1e-300, 1e-10, 1e280), (1e-300, 0.0), (0.0, 1e-293, 1e-290)),
    ((1e300, 1e-300, 1e-300), (1.0, 0.0), (0.0, 1e287, 1e290)),
    ((5e-324, 1.0, 1e-300), (1e-300, 0.0), (0.0, 1e-15, 1e-12)),
    ((1.0, 1e-300, 1.0), (1.0, 0.0), (0.0, 1e-3, 1.0)),
    ((1e-150, 2e150, 1e300), (1e-300, 0.0), (0.0, 1e-228, 1e-225)),
    ((2.0, 4.0, 0.0), (1.0, 3.0), (0.0, 0.5, 1e3)),
    ((2.0, 0.0, 0.0), (1.0, 3.0), (0.0, 0.5, 1e3)),
]
unit, amount = st.just(1.0) | log_uniform(-10, 10), st.integers(-999, 999).map(lambda n: n / 999)
zetas = st.sampled_from(ZETAS) | log_uniform(-27, 27)
KINDS = ("force", "base", "unbalance")
each_case = each(reference("beyond", "driven"))
MASS = HangingMass(m=2.0, k=50.0, g=9.81)
LAST = math.nextafter(math.pi, 0)
AMPLITUDES = (0.0, 1e-300, 1e-9, 0.1, 1.0, -2.0, 3.0, 3.14, 3.141592, math.pi - 1e-10, LAST, math.pi)
NEAR_CUSP = (np.nextafter(CUSP_EXCESS, 0), CUSP_EXCESS, np.nextafter(CUSP_EXCESS, 1))
EXCESSES = (1e-9, 0.01, 0.1511, 0.4585, 0.6, 0.73, 0.732, *NEAR_CUSP, 0.7321, 0.74, 1.0, 3.0, 100.0, 1e6)
ROLES = {
    "spring": lambda p: (p["m"], p["k"]),
    "shaft": lambda p: (p["J"], p["k_t"]),
    "pendulum": lambda p: (p["m"] * p["l"] ** 2, p["m"] * p["g"] * p["l"]),
    "rocking": lambda p: (p["m"] * (p["d"] ** 2 + p["r"] ** 2), p["m"] * G * p["d"]),
    "floating": lambda p: (p["m"], p["rho"] * G * p["A"]),
    "circuit": lambda p: (p["L"], 1 / p["C"]),
    "string": lambda p: (4e-4 * p["L"] / 2, (p["n"] * math.pi) ** 2 * p["T"] / (2 * p["L"])),
    "wave": lambda p: (p["rho"] * p["wavelength"] / (4 * math.pi), p["rho"] * p["g"] / 2),
    "pipe": lambda p: (1.2 * AREA * p["L"] / 2, 1.2 * AREA * p["c"] ** 2 * (p["n"] * math.pi) ** 2 / (2 * p["L"])),
}
"""Inertia and stiffness by the table of the lecture."""
AREA = 1e-3


def drawn_numbers(data, magnitudes):
    """m, k, x_0, v_0, of which two may be negative or 0, and t or c."""
    m, k, x_0, v_0, last = (data.draw(magnitudes) for _ in range(5))
    return m, k, data.draw(SIGNS) * x_0, data.draw(SIGNS) * v_0, last


def true_motion(system, x_0, v_0, t):
    """(value, size) of x, v and a."""
    m, c, k, x, v = map(mp.mpf, (system.m, getattr(system, "c", 0.0), system.k, x_0, v_0))
    a = -(c * v + k * x) / m
    rates = {"x": (x, v), "v": (v, a), "a": (a, -(c * a + k * v) / m)}
    return {name: free_part(mp, m, c, k, *pair, mp.mpf(t)) for name, pair in rates.items()}


@each_magnitude
@settings(max_examples=tries(150))
@given(data=st.data())
def test_motion_stays_within_4_u_of_its_amplitudes(magnitudes, data):
    m, k, x_0, v_0, t = drawn_numbers(data, magnitudes)
    k *= data.draw(st.sampled_from([1.0, 1.0, 0.0]))
    with mp.workprec(PRECISION):
        omega = mp.sqrt(mp.mpf(k) / m)
        assume(omega * t < 1e60)  # beyond, 80 digits of omega_n leave only the amplitude
        true = true_motion(oscillator := Oscillator(m=m, k=k), x_0, v_0, t)
        try:
            motion = oscillator.motion(x_0, v_0, [t])
        except ValueError as refusal:
            name = {"displacement": "x", "velocity": "v", "acceleration": "a"}[str(refusal).split()[1]]
            assert abs(true[name][0]) >= LARGEST * (1 - 8 * U)
            return
        for n, (name, (value, size)) in enumerate(true.items()):
            least = 2.0**-1074 * (1 + omega**n * mp.hypot(x_0, v_0 / (omega or 1)))  # the last step of a subnormal sine
            assert abs(mp.mpf(getattr(motion, name)[0]) - value) <= 4 * U * size + least, name


@each_magnitude
@settings(max_examples=tries(150))
@given(data=st.data())
def test_frequencies_and_constants_are_rounded_once_and_the_phase_within_2_ulp(magnitudes, data):
    m, k, x_0, v_0, c = drawn_numbers(data, magnitudes)
    oscillator, braked = Oscillator(m=m, k=k), DampedOscillator(m=m, c=c, k=k)
    with mp.workprec(PRECISION):
        omega, a, B = mp.sqrt(mp.mpf(k) / m), mp.mpf(c) / m / 2, v_0 / mp.sqrt(mp.mpf(k) / m)
        frequencies = [(oscillator.omega_n, omega), (oscillator.period, 2 * mp.pi / omega), (braked.omega_n, omega)]
        frequencies += [(braked.omega_d, mp.sqrt(max(omega**2 - a**2, 0))), (braked.zeta, a / omega)]
        assert all(ulps(value, true) <= 0.51 for value, true in frequencies)
        C = mp.hypot(x_0, B)
        try:
            constants = oscillator.constants(x_0, v_0)
        except ValueError as refusal:
            assert "amplitude" in str(refusal)
            assert C > LARGEST
            return
        assert (x_0, 0.0) == (constants.A, constants.drift)
        assert ulps(constants.B, B) <= 0.51 and ulps(constants.C, C) <= 0.51
        phi = mp.atan2(x_0, B) if C else mp.mpf(0)
        error = abs(mp.mpf(constants.phi) - phi)
        assert min(error, abs(error - 2 * mp.pi)) <= 2 * math.ulp(constants.phi)  # -pi + 1e-300 may round to pi
        assert -math.pi <= constants.phi <= math.pi


def check(oscillator, x_0, v_0, times):
    motion = oscillator.motion(x_0, v_0, times)
    for n, t in enumerate(times):
        for name, (value, size) in true_motion(oscillator, x_0, v_0, t).items():
            off = abs(mp.mpf(getattr(motion, name)[n]) - value)
            assert off <= BOUND * U * size + mp.mpf("1e-255") * (abs(x_0) + abs(v_0)), (name, t)


@settings(max_examples=tries(200))
@given(unit, unit, zetas, amount, amount, log_uniform(-20, 10), st.booleans())
@example(1.0, 1.0, 1.0, 1.0, 0.0, 1.0, False)
def test_motion_is_within_two_u(m, k, zeta, x_0, v_0, turns, fast):
    """The fast part alone keeps its digits too."""
    omega = math.sqrt(k / m)
    oscillator = DampedOscillator(m=m, c=2 * zeta * math.sqrt(k * m), k=k)
    times = [0.0, turns / omega, turns * zeta / omega, turns / omega / (zeta or 1.0)]
    check(oscillator, x_0, -oscillator.c / m * x_0 if fast else v_0 * omega, times)


@pytest.mark.parametrize(("numbers", "start", "times"), AT_THE_ENDS)
def test_motion_in_limits_is_within_two_u(numbers, start, times):
    check(DampedOscillator(**dict(zip("mck", numbers, strict=True))), *start, times)


def near(value, text, most):
    """Return True if a value is within `most` ulps of the case's number, or both are missing."""
    if text is None:
        return value is None or not math.isfinite(value)
    return ulps(value, mp.mpf(text)) <= most


@each(reference("beyond", "damped"))
def test_rates_moments_and_the_energy_lost_are_those_of_the_reference(case):
    one = DampedOscillator(m=case["m"], c=case["c"], k=case["k"])
    motion = FreeDecay(oscillator=one, x_0=case["x_0"], v_0=case["v_0"])
    assert one.regime == ("critical" if case["critical_within_an_ulp"] else case["regime"])
    assert all(near(value, text, 1) for value, text in zip(one.rates, case["rates"], strict=True))
    assert near(one.log_decrement, case["log_decrement"], 4)
    if case["x_0"]:  # the cases do not look for a second zero after the one at the start
        assert near(motion.first_zero, case["first_zero"], 8)
    assert near(motion.first_turn, case["first_turn"], 8)
    for share, true in case["settled"].items():
        found = motion.settled(float(share))
        assert (found is None) == (true is None)
        assert found is None or found == pytest.approx(float(true), rel=1e-8)
    lost = motion.lost(case["t"])
    assert np.all(np.diff(lost) >= 0)
    for t, value, text in zip(case["t"], lost, case["lost"], strict=True):
        true = mp.mpf(text) if case["c"] and t else 0
        assert abs(mp.mpf(float(value)) - true) <= 64 * U * abs(true) + mp.mpf("1e-300")


def test_top_speed_is_where_the_acceleration_is_zero_and_a_mass_at_rest_has_no_moments():
    one = DampedOscillator(m=1.0, c=0.4, k=4.0)
    found = one.motion(1.0, 0.0, [FreeDecay(oscillator=one, x_0=1.0, v_0=0.0).first_top_speed])
    assert abs(found.a[0]) < 1e-14 and found.x[0] == pytest.approx(-0.1 * found.v[0])
    rest = FreeDecay(oscillator=one, x_0=0.0, v_0=0.0)
    assert (rest.first_zero, rest.first_turn, rest.settled(0.02)) == (None, None, None)
    assert not rest.lost([0.0, 1.0]).any()


def driven(case):
    """Return the mass of a case, and its drive."""
    size = {"force": "F_0", "base": "Y"}.get(case["kind"])
    drive = {"omega": case["omega"], "size": case[size] if size else case["mu"] * case["e"], "kind": case["kind"]}
    return DrivenOscillator(m=case["m"], c=case["c"], k=case["k"]), drive


@each_case
def test_motion_is_within_four_u_of_the_amplitude_and_drawn_as_it_is(case):
    (one, drive), t = driven(case), np.array(case["t"])
    motion = one.motion(**drive, x_0=case["x_0"], v_0=case["v_0"], t=t)
    free, turns = one.free.motion(case["x_0"], case["v_0"], t), 1 + max(case["omega"], one.free.omega_n) * t
    x, v = drawn(one.push(**drive), t)
    for row, plain, name, sizes in (
        (motion.x, x + free.x, "x", case["size"][0]),
        (motion.v, v + free.v, "v", case["size"][1]),
    ):
        for n, text in enumerate(case[name]):
            assert abs(mp.mpf(row[n]) - mp.mpf(text)) <= 4 * U * 1.001 * sizes[n]
            assert abs(mp.mpf(plain[n]) - mp.mpf(text)) <= 6 * turns[n] * U * sizes[n]


@settings(max_examples=tries(200))
@given(*[log_uniform(-300, 300)] * 2, st.floats(0.0, 1.5), st.floats(-17.0, 2.0), st.sampled_from([-1, 0, 1]))
def test_the_detuning_is_rounded_once(m, k, zeta, decades, side):
    """The difference of two rounded frequencies would have no digit next to omega_d."""
    one = DrivenOscillator(m=m, c=zeta * math.sqrt(k) * math.sqrt(m), k=k)
    omega = max(one.free.omega_d * (1 + side * 10.0**decades), 0.0) or one.free.omega_n
    square = mp.mpf(k) / mp.mpf(m) - (mp.mpf(one.c) / (2 * mp.mpf(m))) ** 2
    assert ulps(one.push(omega).detuning, omega - mp.sqrt(max(square, 0))) <= 0.51


@each_case
def test_steady_part(case):
    one, drive = driven(case)
    X = one.response(**drive)
    if case["X"] is None:
        assert math.inf == X and one.at_resonance(case["omega"])
        return
    for value, text in zip((X.real, X.imag), case["X"], strict=True):
        assert ulps(value, mp.mpf(text)) <= 4 if float(text) else value == 0
    assert ulps(abs(X), mp.mpf(case["amplitude"])) <= 4
    assert abs(lag(X) - mp.mpf(case["lag"])) <= 4 * U * lag(X)
    size, turned = one.bode([case["omega"]], drive["size"], case["kind"])
    assert (size[0], turned[0]) == (abs(X), lag(X))


@each_case
def test_magnification_peak_and_half_power(case):
    (one, drive), zeta, r = driven(case), float(case["zeta"]), float(case["r"])
    if math.isinf(r) or case["X"] is None:
        return
    near_resonance = 1 + min(1 / abs(1 - r) if r != 1 else math.inf, 1 / zeta if zeta else math.inf)
    over = {"force": case["k"], "base": 1.0, "unbalance": case["m"]}[case["kind"]]
    true = float(case["amplitude"]) * over / drive["size"]
    assert abs(magnification(r, zeta, case["kind"])[0]) == pytest.approx(true, rel=8 * U * near_resonance)
    found = highest(zeta, case["kind"])
    if found and zeta:
        assert ulps(found[0], mp.mpf(case["peak"]["r"])) <= 4 and ulps(found[1], mp.mpf(case["peak"]["ratio"])) <= 8
    resonances = driven_resonances(one, case["kind"])
    assert resonances.poles == (() if zeta else (one.free.omega_n,))
    assert len(resonances.peaks) == (case.get("peak") is not None and zeta > 0)
    for peak in resonances.peaks:
        assert peak.omega / one.free.omega_n == pytest.approx(float(case["peak"]["r"]), rel=2e-15)
        assert peak.height * over == pytest.approx(float(case["peak"]["ratio"]), rel=1e-14)
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


@settings(max_examples=tries(300))
@given(*[log_uniform(-60, 60)] * 4, st.sampled_from([-1.0, 1.0]))
def test_energies_against_rational_arithmetic(m, k, g, x, sign):
    x *= sign
    K, W, X = (Fraction(value) for value in (k, Fraction(m) * Fraction(g), x))
    mass = HangingMass(m=m, k=k, g=g)
    true = {mass.well: K * X**2 / 2, mass.spring: K * (X + W / K) ** 2 / 2, mass.gravity: -W * X}
    for energy, value in true.items():
        assert abs(Fraction(float(energy([x])[0])) - value) <= 4 * Fraction(U) * abs(value), energy
    assert mass.well([x], "separate")[0] == pytest.approx(float(true[mass.spring] + true[mass.gravity]), rel=4 * U)
    relaxed = Fraction(m) * Fraction(g) / Fraction(k) - Fraction(mass.delta_st)  # what is left is the rounding of x
    assert mass.spring([-mass.delta_st])[0] == pytest.approx(float(K * relaxed**2 / 2), rel=1e-14)


def test_the_spring_along_a_motion_is_that_of_each_place():
    t = np.linspace(0, 4, 300)
    x = FreeOscillation(oscillator=MASS.oscillator, x_0=-MASS.delta_st, v_0=0.0).x
    along = MASS.spring_along(x)
    np.testing.assert_array_equal(along.at(t), MASS.spring(x.at(t)))
    low, high = along.band(0.0)
    assert np.all(low.at(t) <= along.at(t)) and np.all(along.at(t) <= high.at(t) * (1 + U))
    np.testing.assert_allclose(high.at(t), MASS.spring([MASS.delta_st])[0], rtol=1e-14)


@pytest.mark.parametrize("c", [0.0, 0.1, 1.9, 2 - 1e-12, 2.0, 2 + 1e-12, 2.1, 50.0, 1e6])
def test_decays_add_up_to_the_motion(c):
    oscillator, t = DampedOscillator(m=1.0, c=c, k=1.0), np.linspace(0.0, 40.0, 200)
    total = np.zeros_like(t)
    for amplitude, slope, rate, omega, phase in oscillator.decays(0.7, -0.4):
        total += (amplitude + slope * t) * np.exp(-rate * t) * np.sin(omega * t + phase)
    assert np.max(np.abs(total - oscillator.motion(0.7, -0.4, t).x)) < 1e-9


@settings(max_examples=tries(200))
@given(log_uniform(-13, 2), log_uniform(-6, -1), log_uniform(1, 6), st.booleans())
def test_a_curve_over_the_ratio_is_nearly_straight_between_its_points(zeta, low, high, log):
    r = ratios(zeta, low, high, log)
    assert np.all(np.diff(r) > 0) and 1.0 in r and low <= r[0] <= low + high / 90 and high * (1 - 1e-9) <= r[-1] <= high
    assert np.all(r[1:] - r[:-1] <= high / 89) if not log else np.all(r[1:] / r[:-1] <= (high / low) ** (1 / 89))
    middle = (r[1:] + r[:-1]) / 2
    for kind in KINDS:
        curve, between = (np.abs(magnification(one, zeta, kind)) for one in (r, middle))
        assert np.all(np.abs((curve[1:] + curve[:-1]) / 2 - between) <= 0.05 * curve.max())


@settings(max_examples=tries(200))
@given(st.sampled_from(KINDS), log_uniform(-3, 6), *[log_uniform(-3, 13)] * 2, log_uniform(-10, -1))
def test_what_is_too_fast_for_a_line_is_a_band_until_it_has_died(kind, end, omega, omega_n, zeta):
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


@pytest.mark.parametrize("theta_0", AMPLITUDES)
@pytest.mark.parametrize("periods", [1.0, 1e12])
def test_motion_within_4_u_of_its_amplitudes(theta_0, periods):
    pendulum = Pendulum(l=1.3, g=9.81)
    t = np.random.default_rng(7).uniform(0, periods * pendulum.period(theta_0), 40)
    motion = pendulum.motion(theta_0, t)
    with mp.workdps(60 if abs(theta_0) > 1e-100 else 640):
        omega = mp.sqrt(mp.mpf(9.81) / mp.mpf(1.3))
        fastest = 2 * omega * mp.sin(abs(mp.mpf(theta_0)) / 2)
        strongest = omega**2 * (mp.sin(abs(theta_0)) if abs(theta_0) < math.pi / 2 else 1)
        for i, time in enumerate(t):
            theta, rate, acceleration = swing(mp, omega, theta_0, mp.mpf(float(time)))
            assert abs(motion.theta[i] - theta) <= 4 * U * abs(theta_0)
            assert abs(motion.theta_dot[i] - rate) <= 4 * U * fastest
            assert abs(motion.theta_ddot[i] - acceleration) <= 6 * U * strongest


@settings(max_examples=tries(300))
@given(st.one_of(st.floats(1e-140, math.pi), st.floats(0, 40).map(lambda n: math.pi - 2.0**-n)))
def test_period_and_excess_are_rounded_once(theta_0):
    with mp.workdps(340):
        ratio = period_ratio(mp, theta_0)
        assert abs(excess(theta_0) - (ratio - 1)) <= 0.51 * math.ulp(excess(theta_0))
        period = Pendulum(l=2.0, g=3.0).period(theta_0)
        assert abs(period - 2 * mp.pi * mp.sqrt(mp.mpf(2) / 3) * ratio) <= 0.51 * math.ulp(period)


@pytest.mark.parametrize("theta_0", [0.0, 1e-150, 1e-9, 0.01, 1.0, 3.0, 3.14159, math.pi])
def test_amplitude_is_the_inverse_of_excess(theta_0):
    """The largest excess belongs to the last double below pi."""
    condition = 3 if theta_0 < 2 else 1e-15 / max(math.pi - theta_0, 1e-15) / U
    found = amplitude_at_excess(excess(theta_0))
    assert found == (theta_0 if theta_0 in (0.0, math.pi) else pytest.approx(theta_0, rel=condition * U))


def test_at_the_cusp_the_period_is_2_22_percent_longer():
    assert period_excess(CUSP_EXCESS) == pytest.approx(0.0222, abs=5e-5)
    assert invariant(CUSP_EXCESS) == pytest.approx(0.0, abs=4 * U)
    assert invariant(0.0) == 2 / 3
    for lateness, speed in EXCESS_AT_LATENESS.items():
        assert excess_at_period_excess(lateness) == pytest.approx(speed, rel=1e-9)
        assert period_excess(speed) == pytest.approx(lateness, rel=1e-9)


@pytest.mark.parametrize("slug", ANALOGUES)
@settings(max_examples=tries(100))
@given(data=st.data())
def test_roles_frequency_and_energy_follow_the_table(slug, data):
    system = ANALOGUES[slug]
    values = {True: st.integers(1, 20), False: log_uniform(-100, 100)}
    p = {parameter.name: data.draw(values[parameter.whole]) for parameter in system.parameters}
    tuned, (inertia, stiffness) = system.at(p), ROLES[slug](p)
    assert tuned.omega_n == pytest.approx(math.sqrt(stiffness / inertia), rel=8 * U, abs=0)
    assert tuned.inertia == pytest.approx(inertia, rel=8 * U, abs=0)
    assert tuned.stiffness == pytest.approx(stiffness, rel=8 * U, abs=0)
    start = 3 * system.swing
    assert tuned.energy(start) == pytest.approx(stiffness * start**2 / 2, rel=12 * U)
    if system.length_of is None:
        assert tuned.exact_energy(start) == tuned.energy(start)
    else:  # the exact motion of a pendulum, and the height to which it is lifted
        assert tuned.pendulum.omega_0 == pytest.approx(tuned.omega_n, rel=4 * U)
        for angle in (0.0, 1e-200, -1e-9, 1.0, 3.0):
            lifted = stiffness * 2 * math.sin(angle / 2) ** 2
            assert tuned.exact_energy(angle) == pytest.approx(lifted, rel=12 * U, abs=1e-300)
    assert (tuned.pendulum is None) == (system.length_of is None)


@pytest.mark.parametrize("excess", sample(EXCESSES))
def test_flight_is_within_32_u_in_the_first_period_and_32_more_in_each_later_one(excess):
    """Two quantities stay constant over ten linear periods."""
    whole = flight(1.0, 1.0, excess, np.linspace(0, 10 * LINEAR_PERIOD, 4001))
    C = whole.u - whole.V**3 / 3
    assert np.max(np.abs(C - invariant(excess))) <= 1e-14 * max(1.0, abs(invariant(excess)))
    np.testing.assert_allclose(whole.h + whole.V**2 / 2, 0.5, atol=2e-15 * max(1.0, np.max(whole.V) ** 2))
    t = LINEAR_PERIOD * np.array([0.1, 0.45, 0.8, 3.3])
    motion, true = flight(1.0, 1.0, excess, t), flight_points(1.0, 1.0, excess, t.tolist())
    most = 32 * U * max(1, excess**2) * (1 + t // LINEAR_PERIOD)
    for name, values in (("h", motion.h), ("v", motion.gain(1.0, 1.0))):
        for value, point, room in zip(values.tolist(), true[name], most.tolist(), strict=True):
            assert abs(Decimal(value) - point.value) <= Decimal(room) * point.size, name

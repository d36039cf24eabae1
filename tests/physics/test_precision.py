"""Numbers with more digits than doubles, motions as values, and curves or bands of what a grid can resolve."""

import math
from decimal import Decimal
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath.ctx_mp import MPContext

from physics import sampling
from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from physics.motion import Elementary, Harmonic, constant, harmonic_motion, superposed
from physics.precision import exact as digits
from physics.precision.roots import mismatch, roots
from physics.sampling import Sinusoid
from physics.sinusoids import SLOW, Beat, ExactSinusoid, added, total
from tests.grids import tries
from tests.physics.truth import U

thorough = settings(max_examples=tries(200))
DIGITS = MPContext()
DIGITS.dps = 120
BITS = 3000
T = np.linspace(0.0, 10.0, 601)
ZERO = Decimal(0)
QUANTITIES = ("one", "other")
small = st.floats(-1.0, 1.0)
WINDOWS = [(1.0, 2.0, 4), (1.0, 1.5, 4), (1.0, 1.25, 8), (1.0, 1.02, 100), (1.0, 1.0, 100), (1e-200, 2e-200, 4)]


def test_digits_that_no_double_has_are_split_rounded_compared_and_told_from_noise():
    hi, lo = digits.split(Decimal("0.1"))
    assert hi == 0.1 and lo == float(Fraction(1, 10) - Fraction(0.1))
    assert digits.split(Decimal("1e400")) == (math.inf, 0.0) and digits.rounded("x", Decimal("0.1")) == 0.1
    root, at = Decimal(2).sqrt(), math.sqrt(2)
    near = [digits.within_an_ulp(one, root) for one in (at, math.nextafter(at, 0.0), math.nextafter(at, 2.0), -at)]
    assert near == [True, True, False, False]
    assert digits.within_an_ulp(0.0, Decimal("4e-324")) and not digits.within_an_ulp(0.0, Decimal("5e-324"))
    with digits.precise():
        third = Decimal(1) / 3
        assert digits.sum_of(third * 3, Decimal(-1)) == 0 and digits.sum_of(third, Decimal(-1)) != 0
        assert digits.snapped(third * 3) == 1 and digits.snapped(third) == third


@thorough
@given(st.floats(-300.0, 300.0), st.floats(-10.0, 15.0), st.floats(-1.0, 1.0), st.floats(-3.0, 3.0))
def test_phases_of_any_frequency(exponent, turns, low, phase):
    omega = 10.0**exponent
    t = 10.0 ** min(turns - exponent, 307.0)
    lo = omega * U * low
    sine, cosine = digits.sin_cos(omega, lo, np.array([t, -t, 0.0]), phase)
    with mp.workprec(2400):
        for n, s in enumerate((t, -t, 0.0)):
            true = (mp.mpf(omega) + mp.mpf(lo)) * mp.mpf(s) + mp.mpf(phase)
            assert abs(mp.mpf(sine[n]) - mp.sin(true)) <= 0.6 * U
            assert abs(mp.mpf(cosine[n]) - mp.cos(true)) <= 0.6 * U


@pytest.mark.parametrize("spread", [1, 30, 300])
@thorough
@given(st.lists(st.floats(0.1, 1.0), min_size=2, max_size=5), st.lists(st.floats(-1.0, 1.0), min_size=5, max_size=5))
def test_the_roots_make_up_the_polynomial(spread, mantissas, exponents):
    pairs = zip(mantissas, exponents, strict=False)
    coefficients = [DIGITS.mpf(m) * DIGITS.mpf(10) ** (spread * e) for m, e in pairs]
    found = roots(DIGITS, coefficients)
    assert len(found) == len(coefficients) - 1
    assert {(z.real, abs(z.imag)) for z in found if z.imag > 0} == {(z.real, -z.imag) for z in found if z.imag < 0}
    assert mismatch(coefficients, found) < mp.mpf("1e-25")


@pytest.mark.parametrize("multiplicity", [2, 3, 4])
def test_a_multiple_root_keeps_its_share_of_the_digits(multiplicity):
    coefficients = [DIGITS.binomial(multiplicity, k) for k in range(multiplicity + 1)]
    found = roots(DIGITS, coefficients)
    assert all(abs(z + 1) < DIGITS.mpf(10) ** (5 - 120 // multiplicity) for z in found)
    assert len(set(found)) == multiplicity


def swing(omega, a, b):
    """a cos(omega t) + b sin(omega t) and 2 b sin(omega t), as a sinusoid and as a function of mpmath."""
    w, sine = digits.exact(omega), digits.exact(b) * digits.exact(omega)
    return ExactSinusoid(w, (digits.exact(a), ZERO), (sine, 2 * sine)), lambda t: (
        mp.mpf(a) * mp.cos(mp.mpf(omega) * t) + mp.mpf(b) * mp.sin(mp.mpf(omega) * t),
        2 * mp.mpf(b) * mp.sin(mp.mpf(omega) * t),
    )


@thorough
@given(st.lists(st.tuples(st.floats(0.1, 10.0), small, small), min_size=1, max_size=3), st.floats(0.0, 14.0))
def test_the_sum_is_rounded_about_once(swings, decades):
    t = np.array([0.0, 1.0, 10.0**decades])
    parts = [swing(*one) for one in swings]
    found = total(t, QUANTITIES, quick=[sinusoid for sinusoid, _ in parts])
    size = sum(abs(a) + 2 * abs(b) for _, a, b in swings)
    for n, time in enumerate(t):
        for i in (0, 1):
            true = sum(function(mp.mpf(time))[i] for _, function in parts)
            assert abs(mp.mpf(found[i, n]) - true) <= math.ulp(found[i, n]) / 2 + 0.01 * U * size + 1e-300


@pytest.mark.parametrize(
    ("omega", "t", "b"),
    [
        *((omega, t, 0.25) for omega in (1e30, 1e-300) for t in (1e25, 1e-300, -1e5)),
        *((phase, 1.0, 1.0) for phase in (SLOW * (1 - 1e-9), SLOW * (1 + 1e-9), 1e-3, 1e-200)),
    ],
)
def test_phases_up_to_1e60_and_very_slow_ones(omega, t, b):
    """A very slow sinusoid keeps the digits of its sine."""
    sinusoid, function = swing(omega, 0.5 if b < 1 else 0.0, b)
    found = added([sinusoid], np.array([t]), QUANTITIES)
    assert found[:, 0] == pytest.approx([float(value) for value in function(mp.mpf(t))], rel=2e-15)


@thorough
@given(st.floats(0.5, 2.0), st.floats(-1.0, 1.0), small, small, small)
def test_a_beat_that_has_not_begun(s, turned, a, b, c):
    """d t is at most 1/16; with d = 0 the growth is t."""
    t = np.array([1e-3, 1.0, 50.0])
    d = turned * SLOW / 50.0
    coefficients = [(digits.exact(value), ZERO) for value in (a, b, c)]
    found = total(t, QUANTITIES, beats=[Beat(digits.exact(s), digits.exact(d), *coefficients)])[0]
    for value, time in zip(found, map(mp.mpf, t), strict=True):
        slow = mp.sin(d * time) / mp.mpf(d) if d else time
        true = a * mp.cos(d * time) * mp.sin(s * time) + (b * mp.cos(s * time) + c * mp.sin(s * time)) * slow
        assert abs(value - true) <= math.ulp(value) / 2 + 0.1 * U * (abs(a) + (abs(b) + abs(c)) * time) + 1e-300


def decay(m: float = 1.0, c: float = 0.4, k: float = 4.0, x_0: float = 1.0, v_0: float = 0.0) -> FreeDecay:
    return FreeDecay(oscillator=DampedOscillator(m=m, c=c, k=k), x_0=x_0, v_0=v_0)


def test_sums_products_and_quotients_are_those_of_the_values() -> None:
    free = decay()
    x, v = free.x.at(T), free.v.at(T)
    pairs = [
        (free.x + free.v, x + v),
        (2.0 - free.x, 2.0 - x),
        (free.x - 1, x - 1),
        (3.0 * free.x / 4.0, 0.75 * x),
        (-free.v, -v),
        (free.x * free.v, x * v),
        (0.5 * free.x**2 + free.v**2, 0.5 * x**2 + v**2),
        (constant(2.0), np.full_like(T, 2.0)),
    ]
    for motion, values in pairs:
        assert np.array_equal(motion.at(T), values)


@pytest.mark.parametrize(("k", "x_0"), [(1e-300, 1e200), (1e300, 1e-200)])
def test_no_factor_alone_takes_a_product_out_of_range(k: float, x_0: float) -> None:
    """The square of the displacement leaves the range of doubles, the energy does not."""
    free = decay(m=k, c=0.0, k=k, x_0=x_0)
    assert (0.5 * k * free.x**2).at(T)[0] == pytest.approx(0.5 * k * x_0 * x_0, rel=1e-12)


def test_the_mean_of_a_fast_motion_is_that_over_a_cycle() -> None:
    free = decay(m=2.0, c=1e-3, k=50.0, v_0=1.0)
    whole = np.linspace(0.0, 2 * math.pi / free.oscillator.omega_d, 4001)
    for motion in (free.x, 25.0 * free.x**2, free.v**2, 3.0 - free.v**2, 2.0 * (free.x**2 + free.v**2)):
        averaged = np.trapezoid(motion.at(whole), whole) / whole[-1]
        size = np.max(np.abs(motion.at(whole)))
        assert motion.mean.at(whole)[2000] == pytest.approx(averaged, abs=2e-3 * size)


def test_a_fast_motion_stays_within_its_band_whose_slow_part_is_a_line() -> None:
    """If x is slow enough for a line and its square is not, the band of their sum follows x."""
    free = decay(v_0=-2.0)
    assert free.v.band(0.0) is None and (free.x * free.v).band(0.0) is None
    for motion in (free.x, 3.0 - 2.0 * free.x, 4.0 * free.x**2 + 1.0, free.x**2 - 0.5 * free.x):
        low, high = motion.band(0.0) or pytest.fail("it has no band")
        margin = 1e-12 * np.max(np.abs(high.at(T)))
        assert np.all(low.at(T) - margin <= motion.at(T)) and np.all(motion.at(T) <= high.at(T) + margin)
    low, high = (free.x**2 + free.x).band(1.5 * free.oscillator.omega_d) or pytest.fail("it has no band")
    assert np.array_equal(low.at(T), free.x.at(T))
    assert np.all(high.at(T) >= (free.x**2 + free.x).at(T))


def test_a_motion_that_stays_whole_is_one_factor_and_others_are_multiplied_out() -> None:
    V = 2.0 * (x := decay().x) ** 2
    assert [*(3.0 * V).flat()] == [(6, (x, x))]
    assert [*(5.0 * (3.0 * V)).flat(whole=lambda motion: motion is V)] == [(15, (V,))]


def wave(omega: float) -> Elementary:
    return harmonic_motion("x", Harmonic((Sinusoid(1.0, omega, 0.3),)), lambda t: np.sin(omega * t + 0.3))


@pytest.mark.parametrize("omegas", [(1.0, 1000.0), (1000.0, 1001.0), (800.0, 1000.0)])
def test_a_superposition_knows_its_band_and_its_averages(omegas: tuple[float, float]) -> None:
    """A slow part moves the band, close frequencies beat, others add up."""
    whole, fine = superposed("x", *map(wave, omegas)), np.linspace(0.0, 10.0, 200_001)
    values, averaged = whole.at(fine), whole * whole
    low, high = (np.interp(fine, T, edge.at(T)) for edge in whole.band(10.0))
    assert np.all(low <= values + 0.02) and np.all(values <= high + 0.02)
    assert values.max() == pytest.approx(high.max(), abs=0.02)
    assert np.trapezoid(averaged.mean.at(T), T) == pytest.approx(np.trapezoid(values**2, fine), rel=0.02)
    assert whole.size() == 2.0 and whole.omega == max(omegas)


@pytest.mark.parametrize(("slow", "fast", "in_slow_periods"), WINDOWS)
def test_the_window_is_4_slow_or_2_beat_periods(slow, fast, in_slow_periods):
    assert sampling.time_window(slow, fast) == pytest.approx(in_slow_periods * 2 * math.pi / slow, rel=1e-12)
    assert sampling.time_window(0.0, fast) == sampling.periods(fast, 4.0) == pytest.approx(8 * math.pi / fast)
    assert sampling.time_window(0.0, 0.0) == 10.0


def test_drawable_means_twelve_samples_a_cycle():
    step = T[1] - T[0]
    assert sampling.drawable(2 * math.pi / (sampling.SAMPLES_PER_CYCLE * step) * 0.999, T)
    assert not sampling.drawable(2 * math.pi / (sampling.SAMPLES_PER_CYCLE * step) * 1.001, T)
    assert sampling.drawable(0.0, T) and not sampling.drawable(1e300, T) and sampling.drawable(1e300, T[:1])


@pytest.mark.parametrize(
    ("components", "slow", "width"),
    [
        ([Sinusoid(1.0, 2.0, 0.3), Sinusoid(-0.5, 3.0, 0.0)], np.sin(2 * T + 0.3) - 0.5 * np.sin(3 * T), 0.0),
        ([Sinusoid(1.0, 1.0, 0.0), Sinusoid(0.5, 1e6, 0.2)], np.sin(T), 0.5),
        ([Sinusoid(1.0, 1e5, 0.0), Sinusoid(-0.5, 1e9, 0.0)], np.zeros_like(T), 1.5),
        ([], np.zeros_like(T), 0.0),
    ],
)
def test_slow_components_are_a_curve_and_fast_ones_a_band_about_it(components, slow, width):
    base = 0.1 * T
    for offset, line in ((None, slow), (base, slow + base)):
        found = sampling.curve_or_band(components, T, offset)
        assert found.lo == pytest.approx(line - width, abs=1e-14) and found.hi == pytest.approx(line + width, abs=1e-14)
        assert (found.curve is None) == bool(width)
        assert width or (np.array_equal(found.lo, found.curve) and np.array_equal(found.hi, found.curve))
    assert np.array_equal(base, 0.1 * T), "an input is not changed"


def test_mean_squares_average_the_fast_part_only():
    carrier = 2 * math.pi * 4 * 60  # four cycles from one sample to the next
    slow, fast = Sinusoid(2.0, 1.0, 0.0), [Sinusoid(1.0, carrier, 0.0), Sinusoid(0.6, carrier + 2.0, 1.0)]
    found = sampling.root_mean_square([slow, *fast], T) ** 2
    fine = np.linspace(0.0, 10.0, 600 * 400 + 1)
    x = 2 * np.sin(fine) + sum(a * np.sin(w * fine + phase) for a, w, phase in fast)
    assert np.mean((x**2)[200:-201].reshape(599, 400), axis=1) == pytest.approx(found[1:-1], abs=0.02)
    assert sampling.root_mean_square([slow], T, 0.5 * T) == pytest.approx(np.abs(2 * np.sin(T) + 0.5 * T), abs=1e-14)
    huge = sampling.root_mean_square([Sinusoid(1e200, 1e9, 0.0)], T)
    assert huge == pytest.approx(np.full_like(T, 1e200 / math.sqrt(2.0)))
    assert not np.any(sampling.root_mean_square([], T))

"""The chain of two masses: modes, motions and energies of families of chains; with dashpots, roots and their paths."""

import math
import sys
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.absorber import damped_solution
from physics.coupled import TwoMassChain, free_modes
from physics.damped_chain import NEAR, DampedChain, Kind
from physics.energy import chain_energy, half_square
from physics.forced import driven_modes, forced_motion, particular_solution, steady_start
from physics.free_motions import FreeMotions
from physics.precision.polynomials import added, context, positive_roots, product
from physics.reference.damped_chain import braked_points
from physics.root_paths import RootPath, exceptional_point
from physics.transient import DIGITS, DRAWING, FILE, DampedModes
from tests.grids import sample, tries
from tests.physics import truth
from tests.physics.truth import CASES, Case, U, case_of, cases, each, eigenvectors, log_uniform, matrices

LARGEST = mp.mpf(sys.float_info.max)
thorough = settings(max_examples=tries(30))
amount = st.floats(-1.0, 1.0)
starts = st.tuples(amount, amount) | st.sampled_from([(0.0, 0.0), (1.0, 1.0)])
LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
WITHIN = ("moderate", "1e+-8", "tuned weak coupling", "k1 = 0", "k2 = 0", "k1 = k2 = 0", "small integers")
EQUAL_EXPONENTS = [
    (TwoMassChain(m1=1.0, m2=1.0, k1=0.0, k2=2.0), 2.0),  # a critical pair, no wall
    (TwoMassChain(m1=1.0, m2=1.0, k1=2.0, k2=0.5), 1.0),  # (s^2 + s + 1)^2
    (TwoMassChain(m1=5.0, m2=20.0, k1=25.0, k2=4.0), 16.0),  # (s + 1)^4
]
MACHINE = TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
STIFF = TwoMassChain(m1=2.0, m2=1.0, k1=1.0, k2=1e12)


@truth.each_family
@thorough
@given(data=st.data())
def test_modes_are_rounded_once(family, data):
    parameters = data.draw(truth.drawn(family))
    modes, true = truth.chain_with(parameters).modes(), truth.Truth(*parameters)
    found = [*modes.omega, *modes.ratio, modes.beat]
    for value, exactly in zip(found, [*true.omega, *true.ratio, true.beat], strict=True):
        assert truth.ulps(value, exactly) <= 0.51 or (abs(exactly) > LARGEST and math.isinf(value))
    for hi, lo, exactly in zip(modes.omega, modes.omega_lo, true.omega, strict=True):
        if mp.mpf("1e-290") < exactly < LARGEST:
            assert abs(mp.mpf(hi) + mp.mpf(lo) - exactly) <= exactly * mp.mpf(2) ** -105


@st.composite
def drives(draw, parameters):
    """A drive frequency at a detuning of 0 or 1e-17 to 100 from either mode, or from the antiresonance."""
    true = truth.Truth(*parameters)
    root = draw(st.sampled_from([*true.omega, true.antiresonance]))
    detuning = draw(st.one_of(st.just(0.0), st.floats(-17.0, 2.0).map(lambda e: 10.0**e)))
    sign = draw(st.sampled_from([-1, 1])) if detuning < 1 else 1
    omega = root * (1 + sign * mp.mpf(detuning)) if root else mp.mpf(detuning)
    assume(omega < LARGEST)
    return float(omega)


@truth.each_family
@thorough
@given(data=st.data())
def test_detunings_are_rounded_once(family, data):
    """Differences of two rounded frequencies would have no digit next to a resonance."""
    parameters = data.draw(truth.drawn(family))
    omega, true = data.draw(drives(parameters)), truth.Truth(*parameters)
    assume(true.omega[1] < LARGEST)
    found = driven_modes(truth.chain_with(parameters), 1.0, omega).detuning
    with mp.workprec(truth.SETUP_BITS):
        assert all(truth.ulps(d, omega - w) <= 0.51 for d, w in zip(found, true.omega, strict=True))


@st.composite
def pushed(draw, true, omega):
    """F_0, x_0 and v_0: driven from rest, free from any start, or both where neither outweighs the other."""
    slow, fast = true.omega[0] or true.omega[1] or mp.mpf(1), max(true.omega[1], mp.mpf(omega)) or mp.mpf(1)
    is_driven, is_moved = draw(st.sampled_from([(True, False), (False, True), (True, True)]))
    if not is_moved:
        return 2.0, (0.0, 0.0), (0.0, 0.0)
    assume(mp.mpf("1e-100") < fast < mp.mpf("1e100") if is_driven else slow < LARGEST)
    x_0, v_0 = draw(starts), draw(starts)
    F_0 = float(min(mp.mpf("1e200"), true.m1 * fast**2)) if is_driven else 0.0
    return F_0, x_0, [float(v * (fast if is_driven else slow)) for v in v_0]


@truth.each_family
@thorough
@given(data=st.data())
def test_a_free_motion_is_within_4_u_and_a_driven_one_within_16_u_at_every_detuning(family, data):
    parameters = data.draw(truth.drawn(family))
    omega, true = data.draw(drives(parameters)), truth.Truth(*parameters)
    F_0, x_0, v_0 = data.draw(pushed(true, omega))
    turns = [data.draw(st.floats(low, high)) for low, high in ((-6.0, 1.0), (0.0, 7.0), (0.0, 14.9))]
    quickest = max(true.omega[1], mp.mpf(omega) if F_0 else 0) or mp.mpf(1)
    t = [0.0, *(float(s) for s in (mp.mpf(10) ** e / quickest for e in turns) if s < LARGEST)]
    parts = [(true.free(x_0, v_0, s), true.driven(F_0, omega, s)) for s in t]
    expected = [[[a + b for a, b in zip(*pair, strict=True)] for pair in zip(*both, strict=True)] for both in parts]
    chain = truth.chain_with(parameters)
    if max(abs(value) for values, _ in expected for value in values) > LARGEST:
        with pytest.raises(ValueError, match="leaves the range of doubles"):
            forced_motion(chain, F_0, omega, t, x_0, v_0)
        return
    motion = forced_motion(chain, F_0, omega, t, x_0, v_0)
    for n, (values, scales) in enumerate(expected):
        assert truth.worst(motion, n, values, scales) <= (16 if F_0 else 4)


@pytest.mark.parametrize("omega", [1.0, 2.0])
@pytest.mark.parametrize("F_0", [3.0, -3.0])
def test_resonance_has_no_steady_amplitude(omega, F_0):
    assert particular_solution(LECTURE, F_0, omega).tolist() == [math.inf, math.inf]
    assert particular_solution(LECTURE, F_0, [0.5, omega])[:, 1].tolist() == [math.inf, math.inf]
    modes = driven_modes(LECTURE, F_0, omega)
    assert not modes.split_is_meaningful and np.min(np.abs(modes.detuning)) == 0.0
    for refused in (modes.complementary, modes.particular_motion, modes.apart):
        with pytest.raises(ValueError, match=f"the drive at omega = {omega:.6g} rad/s is at a natural frequency"):
            refused([1.0])
    damped = modes_of(LECTURE, 0.0, F_0, omega)
    for without in (lambda: steady_start(LECTURE, F_0, omega), lambda: damped.transient, lambda: damped.particular):
        with pytest.raises(ValueError, match=f"omega = {omega:.6g} rad/s is at a natural frequency"):
            without()
    assert np.all(np.isfinite(damped.motion([100.0]).x))


def check(modes, times):
    """Every number within 0.51 ulp, the smallest too."""
    motion = modes.motion(times)
    for n, t in enumerate(times):
        for row, aim in zip(truth.rows(motion), truth.by_exponential(modes, t, modes.c1, modes.c), strict=True):
            assert truth.ulps(row[n], aim) <= 0.51


def modes_of(chain, c, F_0=1.0, omega=1.0, x_0=(0.0, 0.0), v_0=(0.0, 0.0), c1=0.0):
    return DampedModes(chain=chain, c=c, F_0=F_0, omega=omega, x_0=x_0, v_0=v_0, c1=c1)


@pytest.mark.parametrize("family", WITHIN)
@settings(max_examples=tries(8))
@given(data=st.data())
def test_motion_is_rounded_once(family, data):
    chain = truth.chain_with(data.draw(truth.drawn(truth.FAMILIES[family])))
    fast = float(chain.modes().omega[1]) or 1.0
    share = st.just(0.0) | st.floats(-6.0, 2.0).map(lambda e: 10.0**e)
    c, c1 = (math.sqrt(chain.m1 * chain.m2) * fast * data.draw(share) for _ in range(2))
    omega = fast * 10.0 ** data.draw(st.floats(-3.0, 1.0))
    x_0 = data.draw(st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)))
    v_0 = data.draw(st.sampled_from([(0.0, 0.0), (fast, -fast)]))
    times = [10.0 ** data.draw(st.floats(low, high)) / fast for low, high in ((-4.0, 0.0), (0.0, 2.0), (0.0, 4.0))]
    F_0 = data.draw(st.sampled_from([0.0, 1.0])) * chain.m1 * fast**2
    assume((c or c1) and max(abs(number) for number in (F_0, omega, c, c1, *times)) < 1e100)
    check(modes_of(chain, c, F_0, omega, x_0, v_0, c1), [0.0, *times])


def special():
    """Motions where digits are lost first, and times."""
    small = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0)
    for size in (2.2250738585072014e-308, 5e-320):
        yield modes_of(small, 1.618033988749895, F_0=0.0, x_0=(size, 0.0)), np.linspace(0.0, 5.0, 10).tolist()
    for chain, c in EQUAL_EXPONENTS:
        yield modes_of(chain, c, omega=0.7, x_0=(0.3, -1.0)), [0.0, 1e-6, 0.1, 1.0, 30.0, 200.0]
        for apart in (1e-15, 1e-9, 1e-3):
            yield modes_of(chain, c * (1 + apart), omega=0.7), [1e-3, 1.0, 20.0]
    for ratio in (1e3, 1e9):  # overdamped: the rates differ by a factor ratio^2
        yield modes_of(LECTURE, 3.0 * ratio, x_0=(1.0, 0.0)), [1e-9, 1e-3, 1.0, 40.0, 1e4]
    for c in (5e-324, 1e-100, 1e-20):  # at resonance x_p and the transient are 1/c large
        for omega in (1.0, 1.0 + 1e-9, 1.7):
            yield modes_of(LECTURE, c, 1.0, omega), [1e-4, 0.3, 5.0, 100.0]
    loose = TwoMassChain(m1=1.0, m2=1.0, k1=0.0, k2=0.0)  # mass 1 stays while the other moves
    yield modes_of(loose, 0.0, 0.0, 0.0, (0.1, 0.2), (0.0, 0.3), c1=0.5), [0.0, 1.0, 7.0]


@pytest.mark.parametrize(("modes", "times"), sample(list(special())))
def test_special_motions_are_rounded_once(modes, times):
    check(modes, times)


def test_what_died_out_long_ago_is_not_worked_out(monkeypatch):
    """An exponent of -1e189 is an integer, to whose power mpmath would raise e, squaring by squaring."""
    asked, ctx = [], context(DIGITS)
    exp = ctx.exp
    monkeypatch.setattr(ctx, "exp", lambda z: asked.append(z.real) or exp(z))
    modes = DampedModes(chain=LECTURE, c=1.0, F_0=1.0, omega=1e-189, x_0=(1.0, 0.0))
    far = modes.motion([1e189, 2e189])
    np.testing.assert_allclose(far.x, np.sin([1.0, 2.0]) * modes.particular[:2, None].real, rtol=1e-9)
    assert asked and min(asked) > -1e6


@pytest.mark.parametrize(("chain", "start"), [(STIFF, (1.0, 1.0)), (STIFF, (1.0, 1.000001)), (LECTURE, (1.0, -0.5))])
def test_motions_are_played_as_they_are_and_too_fast_for_a_grid_they_count_by_their_mean_energy(chain, start):
    t, free = np.linspace(0.0, 30.0, 300), free_modes(chain, start, (0.0, 0.0))
    motions = FreeMotions(free)
    for one in (*motions.slow, *motions.fast) if chain is LECTURE else motions.slow:
        assert one.played.quick(t) == pytest.approx(one.at(t), rel=1e-11, abs=1e-14)
    both = motions.both
    T, V = (
        [0.5 * size * one**2 for size, one in pairs]
        for pairs in (((chain.m1, both.v1), (chain.m2, both.v2)), ((chain.k1, both.e1), (chain.k2, both.e2)))
    )
    assert sum(one.mean.at(t) for one in (*T, *V)) == pytest.approx(math.fsum(free.energy), rel=1e-6)
    energy = chain_energy(chain, free.motion(t))
    for one, true in zip((*T, *V), (*energy.T, *energy.V), strict=True):
        assert np.array_equal(one.at(t), true)


@pytest.mark.parametrize(("factor", "value", "energy"), [(1e300, 2e-200, 2e-100), (5e-324, 2.0**537, 0.5), (2, 3, 9)])
def test_half_squares_at_the_edges(factor, value, energy):
    assert half_square("V", factor, np.array([value, -value])) == pytest.approx([energy] * 2, rel=4 * truth.U, abs=0.0)


@pytest.mark.parametrize(
    ("chain", "c", "room"),
    [
        *((MACHINE, c, 1e-12) for c in (0.0, 1e-6, 1.0, 313.7, 1e6)),
        *((chain, c * (1 + apart), 1e-5) for chain, c in EQUAL_EXPONENTS for apart in (0.0, 1e-15, 1e-3)),
    ],
)
def test_the_motion_is_its_particular_solution_and_its_transient(chain, c, room):
    """Drawn in plain doubles it is the same, and the reference of the scenes too."""
    modes = modes_of(chain, c, 500.0, 0.96 * float(chain.modes().omega[1]), (0.3, -1.0), (1.0, 0.0))
    t = np.linspace(0.0, 30.0, 100) / float(chain.modes().omega[1])
    motion = modes.motion(t)
    x = np.array([*motion.x, motion.e[1]])
    size = np.max(np.abs(x))
    assert np.max(np.abs(modes.particular_motion(t) + modes.complementary(t) - x)) < room * size
    drawn_x, drawn_v = modes.drawn(t)
    assert np.max(np.abs(drawn_x - x)) < room * size
    assert np.max(np.abs(drawn_v[:2] - motion.v)) < room * np.max(np.abs(motion.v))
    for row, points in zip(motion.x, braked_points(modes, t[::33]).values(), strict=True):
        assert row[::33] == pytest.approx([float(one.value) for one in points], abs=8 * truth.U * size)
    assert np.array_equal(modes.particular[:2], damped_solution(chain, c, 500.0, modes.omega, modes.c1))
    for exponent, (amplitude, *_) in modes.transient:
        assert exponent.imag >= 0.0 and (exponent.real < 0.0 or not (c and chain.k1))
        assert amplitude[2] == pytest.approx(amplitude[1] - amplitude[0], abs=1e-14 * np.max(np.abs(amplitude)))


def test_work_beyond_that_of_a_picture_or_a_file_is_refused():
    """At first, where x2 starts like t^4, all but everything cancels; much later few digits are needed."""
    few, many = np.linspace(0.5e-100, 1e-100, 3), np.linspace(0.5e-100, 1e-100, 500)
    damped = modes_of(MACHINE, 100.0, 500.0, 48.0)
    np.testing.assert_array_equal(damped.motion(few, DRAWING).x, damped.motion(few).x)
    for budget in (DRAWING, FILE):
        with pytest.raises(ValueError, match="more digits of arithmetic than are allowed"):
            damped.motion(many, budget)
    t = np.linspace(5e12, 1e13, 50)
    exact = damped.motion(t).x
    np.testing.assert_allclose(damped.motion(t, DRAWING).x, exact, rtol=0, atol=1e-12 * np.abs(exact).max())


# The free motions of the chain with dashpots: their roots, shapes and modes, and the paths of the roots.

NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")
KINDS = {
    "no wall spring": {Kind.DRIFT_BOTH, Kind.REST_BOTH},
    "no coupling spring": {Kind.DRIFT_TWO, Kind.REST_TWO},
    "no springs": {Kind.DRIFT_BOTH, Kind.DRIFT_TWO, Kind.REST_EACH},
    "proportional": {Kind.PROPORTIONAL},
    "exceptional point": {Kind.EXCEPTIONAL},
    "two pairs": {Kind.TWO_PAIRS},
    "two pairs, either": {Kind.PARTED},
    "pair and two real": {Kind.ONE_PAIR},
    "four real": {Kind.CREEPING, Kind.FOUR_REAL},
}
UNDER_A_MILLIONTH = {"poles-13": {Kind.EXCEPTIONAL}, "poles-15": {Kind.ONE_PAIR}}
"""Cases at one ulp from a double root: two roots that differ by less than NEAR count as one."""


@each(CASES)
def test_roots_shapes_and_kind_are_those_of_the_reference(case: dict[str, Any]) -> None:
    chain = case_of(case).damped
    if chain.c1 or chain.c2:
        expected = UNDER_A_MILLIONTH.get(case["id"]) or KINDS[case["kind"].removesuffix(", mixed").split(", double")[0]]
        assert chain.free_motions.kind in expected
    left = [*zip(chain.roots, chain.shapes, strict=True)]
    with mp.workdps(50):
        for root in case["roots"]:
            s = mp.mpc(*root["s"])
            fitting = [pair for pair in left if abs(mp.mpc(pair[0]) - s) <= 4 * U * abs(s)]
            if root["ratio"] is None:
                fitting = [pair for pair in fitting if np.isinf(pair[1])]
            elif root["ratio"] != "any":
                ratio = mp.mpc(*root["ratio"])
                fitting = [pair for pair in fitting if abs(mp.mpc(pair[1]) - ratio) <= 4 * U * abs(ratio)]
            assert fitting, (root, left)
            left.remove(fitting[0])


@settings(max_examples=tries(400))
@given(cases())
def test_each_motion_has_its_roots_its_shape_and_its_kind(case: Case) -> None:
    kind, modes = case.damped.free_motions
    every = [(s, one) for one in modes for s in one.exponents]
    found = every + [(s.conjugate(), one) for s, one in every if s.imag]
    assert len(found) == 4 and len(set(modes)) == len(modes)
    true, at_zero = eigenvectors(case), [one for s, one in found if not s]
    assert len(true) == 4 - len(at_zero)
    for s, X1, X2 in true:
        near = [one for r, one in found if abs(r - s) <= 2 * NEAR * abs(s)]
        shapes = [one.shape if s.imag >= 0 else tuple(X.conjugate() for X in one.shape) for one in near]
        assert any(abs(X2 * shape[0] - X1 * shape[1]) <= 3e-3 for shape in shapes), (kind, s, X1, X2, modes)
    for one in modes:
        if one.repeats == 1 and len(one.exponents) == 2 and all(one.exponents):
            assert kind is Kind.PROPORTIONAL or kind in DRIFTS
    check_rests(case)
    OF_KIND.get(kind, lambda _: None)(case)


def check_rests(case: Case) -> None:
    """K x = 0 for a rest; M x'' + C x' + K x = 0 of x = shape (a + b t) asks for C x = 0 too."""
    (kind, modes), (_, C, K) = case.damped.free_motions, matrices(case)
    for one in modes:
        shape = mp.matrix([X.real for X in one.shape])
        if 0 in one.exponents:
            assert not any(X.imag for X in one.shape) and not any(K * shape)
            assert (one.exponents == (0, 0)) == (not any(C * shape))
    assert any(one.exponents == (0, 0) for one in modes) == (kind in DRIFTS)


def check_two_pairs(case: Case) -> None:
    """The modulus and the branch are one order: followed in small steps from the chain without dashpots."""
    slow, fast = (abs(one.exponents[0]) for one in case.damped.free_motions.modes)
    assert slow < fast and math.isclose(slow * fast, math.prod(case.chain.modes().omega.tolist()), rel_tol=1e-9)
    for share in (1e-3, 0.2, 0.5, 0.8):
        on_the_way = DampedChain.of(case.chain, share * case.c1, share * case.c2).free_motions
        assert on_the_way.kind is not Kind.PARTED


def check_parted(case: Case) -> None:
    """Both modes have met where it is said."""
    one, two = (abs(mode.exponents[0]) for mode in case.damped.free_motions.modes)
    assert math.isclose(one, two, rel_tol=1e-9)
    c1, c2 = case.damped.meeting
    assert c1 <= case.c1 and c2 <= case.c2 and math.isclose(c1 * case.c2, c2 * case.c1)
    assert DampedChain.of(case.chain, c1, c2).free_motions.kind is Kind.EXCEPTIONAL


def check_groups(case: Case) -> None:
    """Between creeping and quick motions s^2 M + s C + K is negative definite (R. J. Duffin, 1955)."""
    kind, modes = case.damped.free_motions
    rates = [-one.exponents[0].real for one in modes]
    assert rates == sorted(rates)
    if len(modes) == 4:
        M, C, K = matrices(case)
        between = [-mp.mpf(rates[1]) * (mp.mpf(rates[2]) / rates[1]) ** (mp.mpf(i) / 64) for i in range(1, 64)]
        definite = [s for s in between for T in (s * s * M + s * C + K,) if T[0, 0] < 0 < mp.det(T)]
        assert bool(definite) == (kind is Kind.CREEPING)


DRIFTS = (Kind.DRIFT_BOTH, Kind.DRIFT_TWO)
OF_KIND = {
    Kind.TWO_PAIRS: check_two_pairs,
    Kind.PARTED: check_parted,
    Kind.CREEPING: check_groups,
    Kind.FOUR_REAL: check_groups,
}


def test_proportional_damping_is_told_from_the_numbers_as_written() -> None:
    chain = TwoMassChain(m1=2, m2=1, k1=0.3, k2=0.1)
    near = DampedChain.of(chain, 0.9, 0.3)  # these doubles are not proportional
    assert near.proportional and not DampedChain.of(chain, 0.9, 0.3000000001).proportional
    assert not any(X.imag for one in near.free_motions.modes for X in one.shape)


@pytest.mark.parametrize("size", [1e-30, 1e-130, 1e-250])
def test_the_hardly_damped_die_as_slowly_as_the_shapes_say(size: float) -> None:
    """To first order a mode decays at the power of its shape in the dashpots divided by twice its energy."""
    plain = TwoMassChain(m1=2, m2=1, k1=4, k2=2)
    found = DampedChain.of(plain, 3 * size, size).free_motions.modes
    rates = [-size * (3 * 1 + 1) / (2 * 6), -size * (3 * 1 + 4) / (2 * 3)]  # shapes (1, 2) and (1, -1)
    assert [one.exponents[0].real for one in found] == pytest.approx(rates, rel=1e-14)
    assert all(0 < abs((one.shape[1] / one.shape[0]).imag) < 10 * size for one in found), "not in line"


def numbers(low: int, high: int) -> st.SearchStrategy[dict[str, float]]:
    """Parameters of a chain between two powers of two; springs and dashpots may be missing."""
    sizes, missing = log_uniform(low, high), st.sets(st.sampled_from(NAMES[2:]))
    drawn = st.fixed_dictionaries(dict.fromkeys(NAMES, sizes))
    return st.builds(lambda values, none: values | dict.fromkeys(none, 0.0), drawn, missing)


@settings(max_examples=tries(400))
@given(numbers(-1022, 1022))
def test_roots_over_all_doubles_give_the_polynomial_again(drawn: dict[str, float]) -> None:
    """No coefficient of P cancels: the sum of the roots is -p3/p4, their product p0/p4."""
    chain = DampedChain(**drawn)
    try:
        roots = chain.roots
    except ValueError as error:
        assert "a root" in str(error)
        return
    sizes = [float(abs(part)) for s in roots for part in (s.real, s.imag) if part]
    assume(not sizes or min(sizes) > 1e-300)  # below, a part has lost digits
    m1, m2, k1, k2, c1, c2 = (Fraction(drawn[name]) for name in NAMES)
    total, wanted = sum(Fraction(s.real) for s in roots), -(m1 * c2 + m2 * (c1 + c2)) / (m1 * m2)
    assert abs(total - wanted) <= Fraction(U) * abs(wanted)
    squares = math.prod(Fraction(s.real) ** 2 + Fraction(s.imag) ** 2 for s in roots)
    assume(squares or not k1 * k2)
    assert abs(squares - (k1 * k2 / (m1 * m2)) ** 2) <= 16 * Fraction(U) * squares
    assert all(s.real <= 0 for s in roots)
    order = [(abs(s), 0.0 if s.imag >= 0 else 1.0) for s in map(complex, roots)]
    assert all(one <= two or one[0] <= two[0] * (1 + 4 * U) for one, two in pairwise(order))
    uppers = [i for i, s in enumerate(roots) if s.imag > 0]
    assert all(roots[i + 1] == roots[i].conjugate() for i in uppers)


@settings(max_examples=tries(400))
@given(numbers(-200, 200))
def test_shapes_over_many_decades_obey_newtons_laws(drawn: dict[str, float]) -> None:
    chain = DampedChain(**drawn)
    assume(not (drawn["c1"] or drawn["c2"]) or not chain.proportional)
    with mp.workdps(60):
        m1, m2, k1, k2, c1, c2 = (mp.mpf(drawn[name]) for name in NAMES)
        for s, ratio in zip(chain.roots.tolist(), chain.shapes.tolist(), strict=True):
            one, two = (mp.mpf(0), mp.mpf(1)) if math.isinf(abs(ratio)) else (mp.mpf(1), mp.mpc(ratio))
            s = mp.mpc(s)
            link, own = k2 + c2 * s, k1 + c1 * s + m1 * s * s
            first = [own * one, link * one, -link * two]
            second = [m2 * s * s * two, link * two, -link * one]
            sizes = m1 * abs(s) ** 2 + k1 + k2 + (c1 + c2) * abs(s), m2 * abs(s) ** 2 + k2 + c2 * abs(s)
            room = 8 * U * (sizes[0] * abs(one) + sizes[1] * abs(two) + (k2 + c2 * abs(s)) * (abs(one) + abs(two)))
            assert abs(mp.fsum(first)) <= room and abs(mp.fsum(second)) <= room, (s, ratio)


@each(CASES)
def test_exceptional_points_meetings_and_ends_are_those_of_the_reference(case: dict[str, Any]) -> None:
    for varied, zeros in case["limit_zeros"].items():
        ends = RootPath.of(case_of(case).damped, varied).limits.tolist()
        true = sorted((complex(*map(float, pair)) for pair in zeros), key=lambda s: (s.real, s.imag))
        assert sorted(ends, key=lambda s: (s.real, s.imag)) == pytest.approx(true, rel=4 * U, abs=0)
    if case["meet_on_ray"]:
        meetings = RootPath.of(case_of(case).damped, "both").meetings
        assert [one.double for one in meetings] == [times % 2 == 0 for _, times in case["meet_on_ray"]]
        values = [float(tau) for tau, _ in case["meet_on_ray"]]
        assert [one.value for one in meetings] == pytest.approx(values, rel=2 * U)
    found, wanted = exceptional_point(case_of(case).chain), case["exceptional"]
    assert (found is None) == (wanted is None)
    if found:
        assert (found.c1, found.c2) == pytest.approx((float(wanted["c1"]), float(wanted["c2"])), rel=2 * U, abs=0)
        true = [complex(*map(float, wanted["s"]))] if wanted["s"] else [complex(float(s)) for s in wanted["real"]]
        assert sorted(found.roots, key=abs) == pytest.approx(sorted(true, key=abs), rel=4 * U, abs=0)


@settings(max_examples=tries(200))
@given(cases(), st.sampled_from(["c1", "c2", "both"]))
def test_the_number_of_pairs_changes_at_meetings_only(case: Case, varied: Any) -> None:
    path = RootPath.of(case.damped, varied)
    ends = [0.0, *(one.value for one in path.meetings)]
    ends.append(2 * (ends[-1] or 1.0))
    for one, two in pairwise(ends):
        counts = {np.sum(path.at(one + share * (two - one)).roots.imag > 0) for share in (0.1, 0.5, 0.9)}
        assert len(counts) == 1


@settings(max_examples=tries(200))
@given(cases(), st.floats(0.01, 3.0), st.sampled_from(["c1", "c2", "both"]), st.integers(0, 3))
def test_a_root_dragged_to_a_place_of_its_path_sets_the_value_there(case, value, varied, i):
    path = RootPath.of(case.damped, varied)
    s = complex(path.at(value).roots[i])
    if s:
        found = path.at(path.dragged(s)).roots
        assert min(abs(found - s)) <= 1e-3 * abs(s)


def test_the_drawn_path_passes_through_the_roots() -> None:
    path = RootPath.of(DampedChain(m1=2, m2=1, k1=4, k2=2), "c2")
    values = path.values[::20]
    for drawn, value in zip(path.roots(values), values, strict=True):
        for s in path.at(float(value)).roots:
            assert min(abs(drawn - s)) <= 1e-7 * abs(s) + 1e-12
    (meeting,) = path.meetings
    assert meeting.value == pytest.approx(2.485980, abs=5e-7) and meeting.value in path.values


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(1, 4)), min_size=1, max_size=4, unique_by=lambda one: one[0]))
def test_positive_roots_come_with_their_multiplicity(drawn: list[tuple[int, int]]) -> None:
    square = (Fraction(2), Fraction(1), Fraction(1))  # no real root
    factors = [(Fraction(-root), Fraction(1)) for root, times in drawn for _ in range(times)]
    found = positive_roots(added(product(square, square, *factors)))
    assert [(round(float(root)), times) for root, times in found] == sorted(one for one in drawn if one[0] > 0)
    assert all(abs(root - round(float(root))) < 1e-100 for root, _ in found)

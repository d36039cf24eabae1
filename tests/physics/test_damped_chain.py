"""The free motions of the chain with dashpots: their roots, shapes and modes, and the paths of the roots."""

import math
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from physics.damped_chain import NEAR, ComplexMode, DampedChain, Kind
from physics.precision.polynomials import added, positive_roots, product
from physics.root_paths import RootPath, exceptional_point
from tests.grids import tries
from tests.physics.braked_cases import CASES, Case, case_of, cases, eigenvectors, matrices
from tests.physics.truth import U, each, log_uniform

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


def roots(modes: tuple[ComplexMode, ...]) -> list[tuple[complex, ComplexMode]]:
    """Each of the four roots with its motion."""
    every = [(s, one) for one in modes for s in one.exponents]
    return every + [(s.conjugate(), one) for s, one in every if s.imag]


@each(CASES)
def test_roots_shapes_and_kind_are_those_of_the_reference(case: dict[str, Any]) -> None:
    chain = case_of(case).damped
    if chain.c1 or chain.c2:
        expected = UNDER_A_MILLIONTH.get(case["id"]) or KINDS[case["kind"].removesuffix(", mixed").split(", double")[0]]
        assert chain.free_motions.kind in expected
    left = list(zip(chain.roots, chain.shapes, strict=True))
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
    found = roots(modes)
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


def number(pair: list[str]) -> complex:
    return complex(float(pair[0]), float(pair[1]))


@each(CASES)
def test_exceptional_points_meetings_and_ends_are_those_of_the_reference(case: dict[str, Any]) -> None:
    for varied, zeros in case["limit_zeros"].items():
        ends = RootPath.of(case_of(case).damped, varied).limits.tolist()
        true = sorted(map(number, zeros), key=lambda s: (s.real, s.imag))
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
        true = [number(wanted["s"])] if wanted["s"] else [complex(float(s)) for s in wanted["real"]]
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
def test_a_root_dragged_to_a_place_of_its_path_sets_the_value_there(
    case: Case, value: float, varied: Any, i: int
) -> None:
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

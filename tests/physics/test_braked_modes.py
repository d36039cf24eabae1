"""The free motions of the chain with dashpots: their roots, their shapes and which of them form a mode."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import mpmath as mp
import pytest
from hypothesis import given, settings

from physics.braked_modes import NEAR, BrakedMode, Kind, braked_modes, in_line, meeting
from physics.coupled import TwoMassChain
from tests.grids import tries
from tests.physics.braked_cases import BRAKED, Case, case_of, cases, eigenvectors, matrices

MODES = ("slow", "fast")
BY_SPRINGS = {
    "no wall spring": {Kind.DRIFT_BOTH, Kind.REST_BOTH},
    "no coupling spring": {Kind.DRIFT_TWO, Kind.REST_TWO},
}
BY_SPRINGS |= {"no springs": {Kind.DRIFT_BOTH, Kind.DRIFT_TWO, Kind.REST_EACH}}
KINDS = BY_SPRINGS | {
    "proportional": {Kind.PROPORTIONAL},
    "exceptional point": {Kind.EXCEPTIONAL},
    "two pairs": {Kind.TWO_PAIRS},
    "two pairs, either": {Kind.PARTED},
    "pair and two real": {Kind.ONE_PAIR},
    "four real": {Kind.CREEPING, Kind.FOUR_REAL},
}
UNDER_A_MILLIONTH = {"poles-13": {Kind.EXCEPTIONAL}, "poles-15": {Kind.ONE_PAIR}}
"""Cases at one ulp from a double root: two roots that differ by less than NEAR count as one."""


def number(pair: list[str]) -> complex:
    return complex(float(pair[0]), float(pair[1]))


def roots(modes: tuple[BrakedMode, ...]) -> list[tuple[complex, BrakedMode]]:
    """Each of the four roots with its motion."""
    every = [(s, one) for one in modes for s in one.exponents]
    return every + [(s.conjugate(), one) for s, one in every if s.imag]


@pytest.mark.parametrize("case", BRAKED, ids=lambda case: str(case["id"]))
def test_roots_shapes_and_kind_are_those_of_the_reference(case: dict[str, Any]) -> None:
    one = case_of(case)
    kind, modes = braked_modes(*one)
    expected = UNDER_A_MILLIONTH.get(case["id"]) or KINDS[case["kind"].removesuffix(", mixed").split(", double")[0]]
    assert kind in expected
    found = roots(modes)
    assert len(found) == 4
    for root in case["roots"]:
        s, room = number(root["s"]), 1e-15 / max(float(root.get("stiffness") or 1.0), 1e-7)
        near = [(r, mode) for r, mode in found if abs(r - s) <= room * abs(s)]
        assert near, (s, found)
        if root["ratio"] == "any":
            continue
        mode = near[0][1]
        X1, X2 = mode.shape if near[0][0].imag >= 0 else (X.conjugate() for X in mode.shape)
        wrong = abs(X1) if root["ratio"] is None else abs(X2 - number(root["ratio"]) * X1)
        assert wrong <= max(room, 1e-15) * 10 * max(1.0, abs(X2))
        if kind in (Kind.PROPORTIONAL, Kind.TWO_PAIRS):
            assert mode is modes[MODES.index(root["from"])]


@settings(max_examples=tries(400))
@given(cases())
def test_each_root_is_in_the_motion_of_its_own_eigenvector(case: Case) -> None:
    kind, modes = braked_modes(*case)
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
            assert kind is Kind.PROPORTIONAL or kind in (Kind.DRIFT_BOTH, Kind.DRIFT_TWO)


@settings(max_examples=tries(400))
@given(cases())
def test_a_root_at_0_is_a_rest_or_a_drift(case: Case) -> None:
    """K x = 0 for a rest; M x'' + C x' + K x = 0 of x = shape (a + b t) asks for C x = 0 too."""
    found, (_, C, K) = braked_modes(*case), matrices(case)
    for one in found.modes:
        shape = mp.matrix([X.real for X in one.shape])
        if 0 in one.exponents:
            assert not any(X.imag for X in one.shape) and not any(K * shape)
            drifts = one.exponents == (0, 0)
            assert drifts == (not any(C * shape))
    drifting = any(one.exponents == (0, 0) for one in found.modes)
    assert drifting == (found.kind in (Kind.DRIFT_BOTH, Kind.DRIFT_TWO))


@settings(max_examples=tries(400))
@given(cases())
def test_slow_and_fast_are_the_branches_that_start_without_dashpots(case: Case) -> None:
    """The modulus and the branch are one order: followed in small steps from the chain without dashpots."""
    found = braked_modes(*case)
    if found.kind is not Kind.TWO_PAIRS:
        return
    slow, fast = (abs(one.exponents[0]) for one in found.modes)
    assert slow < fast and math.isclose(slow * fast, math.prod(case.chain.modes().omega.tolist()), rel_tol=1e-9)
    for share in (1e-3, 0.2, 0.5, 0.8):
        on_the_way = braked_modes(case.chain, share * case.c1, share * case.c2)
        assert on_the_way.kind is not Kind.PARTED


@settings(max_examples=tries(400))
@given(cases())
def test_modes_that_parted_have_met_where_it_is_said(case: Case) -> None:
    found = braked_modes(*case)
    if found.kind is not Kind.PARTED:
        return
    one, two = (abs(mode.exponents[0]) for mode in found.modes)
    assert math.isclose(one, two, rel_tol=1e-9)
    c1, c2 = meeting(*case)
    assert c1 <= case.c1 and c2 <= case.c2 and math.isclose(c1 * case.c2, c2 * case.c1)
    assert braked_modes(case.chain, c1, c2).kind is Kind.EXCEPTIONAL


@settings(max_examples=tries(400))
@given(cases())
def test_creeping_and_quick_motions_are_two_groups(case: Case) -> None:
    """Between the two groups s^2 M + s C + K is negative definite (R. J. Duffin, 1955)."""
    kind, modes = braked_modes(*case)
    if kind not in (Kind.CREEPING, Kind.FOUR_REAL) or len(modes) < 4:
        return
    rates = [-one.exponents[0].real for one in modes]
    assert rates == sorted(rates)
    M, C, K = matrices(case)
    between = [-mp.mpf(rates[1]) * (mp.mpf(rates[2]) / rates[1]) ** (mp.mpf(i) / 64) for i in range(1, 64)]
    definite = [s for s in between for T in (s * s * M + s * C + K,) if T[0, 0] < 0 < mp.det(T)]
    assert bool(definite) == (kind is Kind.CREEPING)


def test_proportional_damping_is_told_from_the_numbers_as_written() -> None:
    chain = TwoMassChain(m1=2, m2=1, k1=0.3, k2=0.1)
    assert Fraction(0.9) * Fraction(chain.k2) != Fraction(0.3) * Fraction(chain.k1)
    assert in_line(chain, 0.9, 0.3) and not in_line(chain, 0.9, 0.3000000001)
    assert not any(X.imag for one in braked_modes(chain, 0.9, 0.3).modes for X in one.shape)

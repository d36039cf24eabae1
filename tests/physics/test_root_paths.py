"""Paths of the roots of a damped chain: where roots meet, where they end, and the exceptional point."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.damped_chain import DampedChain
from physics.precision.polynomials import added, positive_roots, product
from physics.root_paths import RootPath, exceptional_point
from tests.grids import tries
from tests.physics.braked_cases import CASES, Case, case_of, cases
from tests.physics.references import each

U = 2.0**-53
DEFAULT = DampedChain(m1=2, m2=1, k1=4, k2=2)


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
    path = RootPath.of(DEFAULT, "c2")
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

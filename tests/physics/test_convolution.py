"""Slices of a push, what each leaves, and their sum, against 50 digits and the motion itself."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from physics.convolution import SlicedPush, joined, outline, tails
from physics.damped import DampedOscillator
from physics.periodic import PeriodicPush
from tests.physics.references import each, reference

ONE = DampedOscillator(m=1.5, c=0.6, k=20.0)


def sliced(count: int, end: float = 6.0, **start: float) -> SlicedPush:
    """A square push, with its edges between slices."""
    push = PeriodicPush(kind="square", size=2.0, omega=2 * math.pi / 3)
    return SlicedPush(oscillator=ONE, force=ONE.pushed(push).force, end=end, count=count, **start)


def exact(t: np.ndarray) -> np.ndarray:
    return ONE.pushed(PeriodicPush(kind="square", size=2.0, omega=2 * math.pi / 3)).from_rest(t).x


@each([case for case in reference("periodic") if case.get("convolution")])
def test_the_sum_is_that_of_the_reference(case: dict[str, Any]) -> None:
    one, true = DampedOscillator(m=case["m"], c=case["c"], k=case["k"]), case["convolution"]
    width = {"width": case["duty"]} if case["duty"] else {}
    force = one.pushed(PeriodicPush(kind=case["kind"], size=case["F"], omega=case["omega"], **width)).force
    for count, value in true["midpoint"].items():
        found = SlicedPush(oscillator=one, force=force, end=float(true["t"]), count=int(count))
        assert found.x.at(np.array([found.end])) == pytest.approx(float(value), rel=1e-10)


@pytest.mark.parametrize("count", [1, 7, 200])
def test_the_sum_is_played_as_it_is(count: int) -> None:
    found, t = sliced(count), np.linspace(0.0, 6.0, 333)
    played: Any = found.x
    assert played.played.at(t) == pytest.approx(found.x.at(t), abs=0.01 * found.reach)
    assert found.reach == pytest.approx(np.abs(found.x.at(np.linspace(0, 6, 2000))).max(), rel=0.01)
    begun = sliced(count, x_0=0.1, v_0=-0.2)
    free = ONE.motion(0.1, -0.2, t).x
    assert begun.x.at(t) == pytest.approx(found.x.at(t) + free, abs=1e-14)
    assert begun.reach == pytest.approx(np.abs(begun.x.at(np.linspace(0, 6, 2000))).max(), rel=0.01)


def test_what_the_slices_leave_adds_up_to_the_sum() -> None:
    found = sliced(8)
    each = tails(ONE, found.times, found.sizes, found.end, 4000)
    assert [tail.t[0] for tail in each] == found.times.tolist() and {tail.t[-1] for tail in each} == {6.0}
    assert not any(tail.x[0] for tail in each) and sum(len(tail.t) for tail in each) == pytest.approx(4000, abs=20)
    t = np.linspace(0.0, 6.0, 100)
    total = sum(np.interp(t, tail.t, tail.x, left=0.0) for tail in each)
    assert total == pytest.approx(found.x.at(t), abs=1e-4)
    path = joined(each)
    assert path.t[len(each[0].t) - 1] == path.t[len(each[0].t)] == 6.0, "to the end and back"
    assert sorted(path.x) == sorted(np.concatenate([tail.x for tail in each]))


def test_the_outline_of_slices_has_their_area() -> None:
    t, F = outline(sliced(12).ends, sliced(12).forces)
    assert np.all(np.diff(t) >= 0) and np.trapezoid(np.abs(F), t) == pytest.approx(12.0)
    assert t[-1] == pytest.approx(6.0) and set(F.tolist()) == {-2.0, 0.0, 2.0}

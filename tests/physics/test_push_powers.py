"""Mean powers under a push that repeats, against the work of a cycle and fine sums of F v and c v^2."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from physics.damped import DampedOscillator
from physics.periodic import PeriodicPush
from physics.push_powers import mean_powers
from physics.steady_motions import SteadyMotion

ONE = DampedOscillator(m=1.5, c=1.2, k=20.0)
KINDS = ("square", "triangle", "pulses", "impulses")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("end", [1.3, 5.0, 11.0])
def test_at_first_they_are_what_the_last_period_brought(kind: Any, end: float) -> None:
    """In the end both are the work of a cycle."""
    steady = SteadyMotion(oscillator=ONE, push=PeriodicPush(kind=kind, size=3.0, omega=2.0, width=0.3))
    last = mean_powers(steady, 0.1, 0.0, 60.0, 400)
    assert [last.t[-1], last.P_in[-1], last.P_lost[-1]] == pytest.approx(
        [60.0, *[steady.mass.work / math.pi] * 2], rel=1e-6
    )
    found = mean_powers(steady, 0.1, -0.4, end, 60)
    assert np.all(np.diff(found.t) > 0) and len(found.t) >= 60
    assert found.P_in[0] == (0.0 if kind != "impulses" else pytest.approx(3.0 * (-0.4 + 1.0) / steady.period))
    for i in (len(found.t) // 3, -1):
        last = found.t[i]
        t = np.linspace(max(last - steady.period, 0.0), last, 40001)
        _, v = steady.from_start(0.1, -0.4, t)
        assert found.P_lost[i] == pytest.approx(np.trapezoid(ONE.c * v**2, t) / steady.period, rel=1e-3)
        put_in = np.trapezoid(steady.force_at(t) * v, t)
        if kind == "impulses":
            into = np.flatnonzero(np.diff(v) > 1.0)
            assert len(into) == (1 if last >= steady.period else 0)
            put_in = sum(3.0 * (v[n] + v[n + 1]) / 2 for n in into)
            put_in += 3.0 * (-0.4 + 3.0 / ONE.m / 2) if last < steady.period else 0.0
        assert found.P_in[i] * steady.period == pytest.approx(put_in, rel=2e-3, abs=2e-3)

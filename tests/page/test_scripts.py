"""The results of the scripts compared with Python: signals, texts of numbers, places of names."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from components.language.signals import AnySignal, Response, Responses, Sine, Sines
from components.quantities.axes import ONE, Axis
from components.quantities.instant import instant
from components.quantities.motion import damped, driven
from components.scenes import SCENES
from components.state.encoding import COARSE
from components.state.link import Link
from physics.damped import DampedOscillator
from physics.driven import Drive, DrivenOscillator
from tests.grids import tries
from tests.page.scripts import call, each, played
from tests.serving.server import ROOT
from tests.states import links, state_of

NEAR = 1e-12
"""Relative to the largest size so far: angles to 1000 rad, a few roundings each."""
INSTANTS = [0, 1e-6, 1e-3, 0.02, 0.5, 1.3, 7.0, 40.0, 300.0]
TEXTS = json.loads((ROOT / "tests" / "reference" / "number_texts.json").read_text(encoding="utf-8"))


def evaluated(
    signals: dict[str, AnySignal], times: list[float], scalars: dict[str, float] | None = None
) -> dict[str, list[float]]:
    """Return the signals evaluated in JavaScript, by name."""
    values = each("static/core/signals.evaluate", ([signals, scalars or {}, t] for t in times))
    return {name: [value[name] for value in values] for name in signals}


def assert_near(found: list[float], exact: Callable[[mpf], mpf], times: list[float], least: float = 0.0) -> None:
    """Check that every value is within NEAR, relative to the largest size so far."""
    with mp.workdps(80):
        truth = [exact(mpf(t)) for t in times]
        reached = mpf(least)
        for t, value, true in zip(times, found, truth, strict=True):
            reached = max([reached, abs(true), *(abs(exact(mpf(t) * k / 16)) for k in range(1, 16))])
            assert abs(mpf(value) - true) <= NEAR * reached, (t, value, float(true), float(reached))


def from_rest(omega: float, omega_n: float) -> Callable[[mpf], mpf]:
    """x'' + omega_n^2 x = sin(omega t) from rest, by its three closed forms."""
    w, n = mpf(omega), mpf(omega_n)

    def exact(t: mpf) -> mpf:
        if n == 0:
            return (w * t - mp.sin(w * t)) / w**2
        if w == n:
            return (mp.sin(w * t) - w * t * mp.cos(w * t)) / (2 * w**2)
        return (n * mp.sin(w * t) - w * mp.sin(n * t)) / (n * (n - w) * (n + w))

    return exact


DRIVES = [
    *((1.3, 1.3 * (1 + off)) for off in (0, 2.0**-52, 1e-12, 1e-9, -1e-6, 1e-3, -0.05)),
    *((1.3, own) for own in (0.0, 1e-9, 1e-4, 0.01, 0.3, 2.6, 3.0)),
    *((omega, 1.0) for omega in (1e-9, 1e-4, 0.05, 0.5, 0.54, 1.9, 3.1)),
]


@pytest.mark.parametrize(("omega", "omega_n"), DRIVES)
def test_response_to_a_drive(omega: float, omega_n: float) -> None:
    signal = Responses(responses=(Response(2.0, omega, omega_n),))
    found = evaluated({"x": signal}, INSTANTS)["x"]
    exact = from_rest(omega, omega_n)
    assert_near(found, lambda t: 2 * exact(t), INSTANTS)


ZETAS = [0.0, 1e-12, 1e-3, 0.3, 1 - 1e-6, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-6, 1.5, 40.0, 1e6]
SECONDS = Axis(0.0, 1.0, "s")


@pytest.mark.parametrize("zeta", ZETAS)
@pytest.mark.parametrize("start", [(1.0, 0.0), (0.7, -3.0), (0.0, 1.0), (0.0, 0.0)])
def test_a_damped_mass(zeta: float, start: tuple[float, float]) -> None:
    """Compare x and v with the physics: near critical damping, at rest, without a dashpot, and overdamped."""
    one, times = DampedOscillator(m=2.0, c=4 * zeta, k=2.0), np.array(INSTANTS)
    signals = dict(zip("xva", (damped(ONE, SECONDS, row) for row in one.fading(*start)), strict=True))
    found, true = evaluated(dict(signals), INSTANTS), one.motion(*start, times)
    size = max(map(abs, start))
    for name in "xv":
        off = np.abs(np.array(found[name]) - getattr(true, name))
        assert np.all(off <= 1e-15 * size * (4 + times)), (name, off)


@pytest.mark.parametrize("zeta", ZETAS)
@pytest.mark.parametrize("omega", [0.0, 0.3, 0.8, 1.0, 1 + 1e-12, 1 - 1e-6, 2.5])
@pytest.mark.parametrize("kind", ["force", "base", "unbalance"])
def test_a_driven_mass(zeta: float, omega: float, kind: Drive) -> None:
    """Compare x with the physics: at resonance with and without a dashpot, at critical damping, early and late."""
    one, times = DrivenOscillator(m=2.0, c=4 * zeta, k=2.0), np.array(INSTANTS)
    found = evaluated({"x": driven(ONE, SECONDS, one.push(omega, 1.0, kind))}, INSTANTS)["x"]
    true = one.motion(omega, 1.0, t=times, kind=kind).x
    reached = np.maximum.accumulate(np.abs(true))
    assert np.all(np.abs(np.array(found) - true) <= NEAR * reached), (found, true)


def test_sines_with_a_line_and_a_decay() -> None:
    sines = (Sine(1.5, 2.0, 0.3, 0.1), Sine(-0.2, 3.1, -2.0), Sine(4.0, 0.0, 1.0, 2.0, 3.0))
    found = evaluated({"x": Sines(sines=sines, line=(0.5, -0.01))}, INSTANTS)["x"]

    def exact(t: mpf) -> mpf:
        waves = (
            (mpf(s.size) + mpf(s.slope) * t) * mp.exp(-mpf(s.decay) * t) * mp.sin(mpf(s.omega) * t + mpf(s.phase))
            for s in sines
        )
        return mpf(0.5) - mpf(0.01) * t + sum(waves)

    assert_near(found, exact, INSTANTS)


@pytest.mark.parametrize("slug", SCENES)
def test_signals_of_any_state_have_the_values_of_python(slug: str) -> None:
    @settings(max_examples=tries(20))
    @given(links(SCENES[slug]), st.sampled_from([0.0, 1e-3, 0.02, 0.31, 0.77, 1.0]))
    def agree(link: Link, share: float) -> None:
        shown = state_of(link).shown
        t = share * shown.axes["t"].place(shown.axes["t"].end) if "t" in shown.axes else share
        wanted = instant(shown.signals, shown.scalars, t)
        for name, value in played(shown, t).items():
            assert float(value) == pytest.approx(wanted[name], rel=1e-9, abs=1e-9), name

    agree()


STEP = 30 / COARSE  # 0.00046
KINDS = ("three", "signed", "short", "tidy")
WRITTEN: dict[str, list[tuple[Any, ...]]] = {
    **{f"core/numbers.{kind}": [(case["value"], case[kind]) for case in TEXTS] for kind in KINDS},
    "core/numbers.fixed": [
        *((1.25, 1, False, "1.3"), (-1.25, 1, False, "−1.3"), (-0.001, 2, False, "0.00"), (-0.001, 2, True, "+0.00")),
        *((0.5, 2, True, "+0.50"), (-12.0, 0, True, "−12")),
    ],
    "core/numbers.grouped": [
        *((2.0, "2"), (12345.6, "12\u202f300"), (0.5, "0.5"), (999400.0, "999\u202f000"), (1.23e7, "1.23·10⁷")),
    ],
    "scene/reading.honest": [
        *((12.3456, STEP, "12.3"), (-0.123456, STEP, "−0.123"), (0.0123456, STEP, "0.012"), (-0.00234, STEP, "−0.002")),
        *((0.0003, STEP, "0"), (0.0, STEP, "0"), (2.3456, 0.03, "2.3"), (2.3456, 0.0, "2.35")),
        *((0.000123456, 0.0, "1.23·10⁻⁴"),),
    ],
}
"""Functions that write numbers: as Python does, with fixed places, how many times, and without unknown digits."""


@pytest.mark.parametrize("function", WRITTEN)
def test_a_number_is_written(function: str) -> None:
    cases = WRITTEN[function]
    assert each(f"static/{function}", (case[:-1] for case in cases)) == [case[-1] for case in cases]


AXES = [
    Axis(0.5, 4.0, log=log, power=power, exponent=exponent, factor=factor)
    for log, power, exponent, factor in product((False, True), (1, 2), (0, -4), (1.0, math.pi / 180))
    if not (log and (power > 1 or exponent))
]


@pytest.mark.parametrize("axis", AXES, ids=str)
def test_a_place_on_an_axis_stands_for_a_quantity_as_in_python_and_back(axis: Axis) -> None:
    for value in (0.25, 1.0, 3.7):
        place = call("static/core/ruler.toPlace", axis.ruler, value)
        assert place == pytest.approx(axis.place(value), rel=1e-14)
        assert call("static/core/ruler.toSI", axis.ruler, place) == pytest.approx(value, rel=1e-14)

"""The driven mass under a square, a triangle and pulses: its motion, its harmonics, and their texts."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.layout.sheet import blocks
from components.scenes import SCENES
from physics.convolution import SlicedPush
from physics.damped import DampedOscillator
from physics.magnification import highest, magnification
from physics.periodic import PeriodicPush
from physics.pushed import PushedMass
from tests.grids import tries
from tests.scenes.visible_sentences import read

DRIVEN = SCENES["driven"]
PUSHES = ("square", "triangle", "pulses", "impulses")
ONCE = ("step", "impulse")
EXACT = {"view": "harmonics", "m": 1.0, "k": 36.0}


def sentence(scene: Any, name: str = "meets") -> str:
    texts = (item for block in blocks(DRIVEN.sheet()) for item in getattr(block, "items", ()))
    variants = next(item.variants for item in texts if item.name == name)
    return read(scene, variants[scene.shown.forms[name]])


def lines_of(scene: Any) -> tuple[list[int], list[float], list[float]]:
    """The harmonics from 1 on, |f_n| in N and |X_n| in m, by the formulas of a textbook."""
    n = list(range(1, 400))
    match scene.push:
        case "impulses":
            f = [scene.J * scene.omega / math.pi for _ in n]
        case "square":
            f = [4 * scene.F_0 / (i * math.pi) if i % 2 else 0.0 for i in n]
        case "triangle":
            f = [8 * scene.F_0 / (i * math.pi) ** 2 if i % 2 else 0.0 for i in n]
        case _:
            f = [2 * scene.F_0 * abs(math.sin(i * math.pi * scene.width)) / (i * math.pi) for i in n]
    w = scene.omega
    return (
        n,
        f,
        [f_n / abs(scene.k - scene.m * (i * w) ** 2 + 1j * i * scene.c * w) for i, f_n in zip(n, f, strict=True)],
    )


def size_of(scene: Any) -> float:
    """The size of the push in N, or of impulses in N s."""
    return float(scene.J if scene.push.startswith("impulse") else scene.F_0)


def pushed(scene: Any) -> tuple[DampedOscillator, PushedMass]:
    """The mass of a scene without its push, and with it."""
    one = DampedOscillator(m=scene.m, c=scene.c, k=scene.k)
    return one, one.pushed(PeriodicPush(kind=scene.push, size=size_of(scene), omega=scene.omega, width=scene.width))


def mean_of(scene: Any) -> float:
    """The size that the harmonics are divided by, in N."""
    return float(scene.J * scene.omega / (2 * math.pi) if scene.push == "impulses" else scene.F_0)


@pytest.mark.parametrize("push", [*PUSHES, *ONCE])
@pytest.mark.parametrize("omega", [0.7, 2.0944, 5.0])
def test_a_file_has_the_exact_motion_and_its_parts(push: Any, omega: float) -> None:
    scene = DRIVEN(push=push, omega=omega, x_0=0.02, v_0=0.1, c=1.0)
    data = scene.sources["time"].data
    one, mass = pushed(scene)
    free = one.motion(scene.x_0, scene.v_0, data["t"])
    assert data["x"] == pytest.approx(mass.from_rest(data["t"]).x + free.x, rel=1e-15, abs=0)
    if push == "impulse":
        assert {"x_p", "x_c", "F_over_k"}.isdisjoint(data)
        return
    assert data["x_p"] + data["x_c"] == pytest.approx(data["x"], abs=1e-12)
    if push != "impulses":
        assert data["F_over_k"] == pytest.approx(mass.force(data["t"]) / scene.k, abs=1e-15)


@pytest.mark.parametrize("push", ONCE)
def test_what_does_not_repeat_has_no_frequency(push: Any) -> None:
    slow, quick = (DRIVEN(view="harmonics", push=push, omega=omega) for omega in (0.0, 50.0))
    assert slow.sources["time"].data["x"].tolist() == quick.sources["time"].data["x"].tolist()
    assert slow.shown.forms["meets"] == "once" and not slow.shown.forms["repeats"]
    assert not {"omega_at", "M_at"} & slow.shown.scalars.keys()
    assert {"growth", "X", "on_peak", "strongest"}.isdisjoint(quick.numbers)
    assert "does not repeat" in sentence(DRIVEN(push=push), "holds")


def test_impulses_are_drawn_where_they_act() -> None:
    scene = DRIVEN(view="harmonics", push="impulses", omega=2.0, J=0.3, window=10.0)
    jolts, flash = scene.sources["jolts"].data, scene.shown.signals["F"]
    assert jolts["jolt_t"][::3] == pytest.approx(math.pi * np.arange(4))
    assert jolts["jolt"][1::3] == pytest.approx(0.3 / math.sqrt(39.48)) and not jolts["jolt"][::3].any()
    assert len(DRIVEN(view="harmonics", push="impulses", omega=1e6).sources["jolts"].data["jolt_t"]) == 600
    assert max(flash.y) == pytest.approx(0.3) and min(flash.y) == 0.0 and flash.period == pytest.approx(math.pi)
    assert DRIVEN(push="impulse", J=0.0, x_0=0.1).shown.forms["meets"] == "idle"


@pytest.mark.parametrize("push", PUSHES)
def test_a_push_is_one_of_a_force(push: Any) -> None:
    """A shaken base and an unbalance keep their sine."""
    for kind in ("base", "unbalance"):
        assert DRIVEN(kind=kind, push=push).sources["time"].data["x"].tolist() == (
            DRIVEN(kind=kind).sources["time"].data["x"].tolist()
        )
    none = DRIVEN(push=push, F_0=0.0, J=0.0, x_0=0.1)
    assert none.sources["time"].data["x"].tolist() == DRIVEN(F_0=0.0, x_0=0.1).sources["time"].data["x"].tolist()


@pytest.mark.parametrize("push", PUSHES)
def test_bars_are_the_push_and_dots_lie_under_the_response(push: Any) -> None:
    scene = DRIVEN(view="harmonics", push=push, omega=1.7, c=2.0)
    bars, dots = scene.sources["bars"].data, scene.sources["dots"].data
    n, f, X = lines_of(scene)
    M, seen = scene.shown.axes["M"], scene.shown.axes["r"].end / scene.omega
    has = [i for i, f_n in zip(n, f, strict=True) if f_n > 1e-12 and i < seen]
    assert np.all(bars["bar"][::3] == M.start) and bars["bar_omega"][::3] == pytest.approx(np.array(has) * scene.omega)
    size = mean_of(scene)
    assert bars["bar"][1::3] == pytest.approx([max(f[i - 1] / size, M.start) for i in has])
    high = [i for i in has if X[i - 1] * scene.k / size >= M.start]
    assert dots["dot_omega"] == pytest.approx(np.array(high) * scene.omega) and len(high) > 1
    assert dots["dot"] == pytest.approx([X[i - 1] * scene.k / size for i in high])
    assert M.end >= dots["dot"].max()


@settings(max_examples=tries(120), deadline=None)
@given(
    st.sampled_from(PUSHES), st.floats(0.05, 3.0), st.floats(0.004, 1.2), st.floats(0.05, 0.95), st.floats(0.1, 10.0)
)
def test_its_sentence_is_true(push: Any, r: float, zeta: float, width: float, m: float) -> None:
    scene = DRIVEN(view="harmonics", push=push, m=m, zeta=zeta, omega=r * math.sqrt(39.48 / m), width=width)
    told, word = sentence(scene), scene.shown.forms["meets"]
    _, f, X = lines_of(scene)
    found = scene.numbers["strongest"].value
    assert X[int(found) - 1] == pytest.approx(max(X), rel=1e-9)
    assert scene.numbers["X_strongest"].value == pytest.approx(max(X))
    assert f"armonic {int(found)} moves the mass most" in told or (
        word == "hit" and f"armonic {int(found)} is at" in told
    )
    peak = highest(scene.zeta)
    if word in ("hit", "beaten", "missing"):
        assert peak
        i = int(scene.numbers["on_peak"].value)
        height = float(np.abs(magnification(i * r, scene.zeta))[0])
        assert height >= 0.7 * peak[1] or abs(i * r - peak[0]) < 0.021
        assert (word == "missing") == (f[i - 1] < 1e-12 * scene.F_0)
        assert (word == "hit") == (f[i - 1] > 0 and i == found)
    else:
        assert "on_peak" not in scene.numbers
        assert word == ("wide" if scene.zeta > 0.35 else "between")


@pytest.mark.parametrize("push", PUSHES)
def test_the_mean_powers_are_those_of_the_push(push: Any) -> None:
    scene = DRIVEN(view="power", push=push, omega=2.0944, c=1.0, window=60.0)
    _, mass = pushed(scene)
    for name in ("P_in", "P_lost"):
        assert scene.numbers[name].value == pytest.approx(mass.work * 2.0944 / (2 * math.pi), rel=1e-6)
    assert scene.shown.forms["has_power"] and not scene.shown.forms["no_powers"]


@pytest.mark.parametrize("values", [{"omega": 600.0}, {"omega": 0.01}, {"window": 1e5}, {"window": 1e-3}, {"k": 1e-6}])
@pytest.mark.parametrize("push", PUSHES)
def test_a_motion_too_fast_or_too_slow_is_drawn_all_the_same(push: Any, values: dict[str, float]) -> None:
    scene = DRIVEN(view="harmonics", push=push, **values)
    band = scene.shown.sources["band"]
    if "x_hi" not in band:
        assert np.all(np.isfinite(scene.sources["time"].data["x"]))
        return
    _, mass = pushed(scene)
    x = mass.from_rest(np.linspace(0.0, band["t"][-1], 50)).x
    assert np.all(band["x_lo"] <= x.min()) and np.all(band["x_hi"] >= x.max() * (1 - 1e-9))


@pytest.mark.parametrize("push", ["square", "triangle", "pulses", "step"])
@pytest.mark.parametrize("slices", [1, 12, 60, 200])
def test_the_sum_of_slices_follows_the_motion_as_the_page_says(push: Any, slices: int) -> None:
    scene = DRIVEN(view="convolution", push=push, slices=slices, x_0=0.01, c=1.5, width=0.31)
    data, (one, mass) = scene.sources["time"].data, pushed(scene)
    t, end = data["t"], data["t"][-1]
    sliced = SlicedPush(oscillator=one, force=mass.force, end=end, count=slices)
    assert data["x_sliced"] == pytest.approx(sliced.x.at(t) + one.motion(0.01, 0.0, t).x, abs=1e-13)
    fine = np.linspace(0.0, end, 1 + 2 * slices * math.ceil(400 / slices))
    exact = mass.from_rest(fine).x
    miss = np.abs(sliced.x.at(fine) - exact).max()
    assert scene.numbers["misses"].value == pytest.approx(miss, rel=0.02)
    share = miss / np.abs(exact).max()
    word = "follows" if share <= 0.05 else "coarse" if scene.numbers["slice_width"].value > 0.1 else "changes"
    assert scene.shown.forms["sums"] == word or abs(share - 0.05) < 0.003
    assert (push, word) not in {("step", "changes"), ("triangle", "changes")}, "these hardly change in a short slice"
    assert scene.numbers["slice_width"].value == pytest.approx(t[-1] / slices * math.sqrt(39.48) / (2 * math.pi))
    path, tails = scene.sources["outline"].data, scene.sources["tails"].data
    area = np.trapezoid(np.abs(path["slice"]), path["slice_t"])
    middles = t[-1] * (np.arange(slices) + 0.5) / slices
    assert area == pytest.approx(np.abs(mass.force(middles)).mean() * t[-1])
    assert scene.shown.forms["tail"] == ("some" if slices > 12 else "each")
    assert np.count_nonzero(tails["tail_t"] == t[-1]) <= 14


def test_a_hand_sets_the_push_where_it_is_drawn() -> None:
    pulses = DRIVEN(view="harmonics", push="pulses", omega=2.0, width=0.3, window=10.0).shown.scalars
    assert pulses["period_share"] == pytest.approx(math.pi / 10) and pulses["full_turn"] == pytest.approx(math.pi / 5)
    assert pulses["crest"] == pytest.approx(0.15 * math.pi / 10) and pulses["pulse_width"] == 0.3
    assert "period_share" not in DRIVEN(view="harmonics", push="square", omega=0.1, window=10.0).shown.scalars
    assert {"period_share", "pulse_width"}.isdisjoint(DRIVEN(view="harmonics", push="step").shown.scalars)

"""The damped mass: c and zeta as one quantity, its sentences over random parameters, its presets, its limits."""

from __future__ import annotations

import math
import re
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.layout.sheet import blocks
from components.quantities.formatting import parse_number
from components.scene import Scene
from components.scene.traces import Floats
from components.scenes import SCENES
from physics.damped import DampedOscillator
from tests.grids import tries
from tests.page.headless_page import Page, set_values
from tests.scenes.presets import taken
from tests.scenes.visible_sentences import read

DAMPED = SCENES["damped"]


def sentence(scene: Scene) -> str:
    (variants,) = [
        item.variants for block in blocks(DAMPED.sheet()) for item in getattr(block, "items", ()) if item.name == "said"
    ]
    return read(scene, variants[scene.shown.forms["said"]])


def numbers(text: str) -> list[float]:
    return [parse_number(found) for found in re.findall(r"[−\d][\d.]*(?:·10[⁻⁰¹²³⁴-⁹]+)?", text)]


def test_c_and_zeta_are_one_quantity() -> None:
    scene = DAMPED(zeta=0.5)
    assert scene.c == pytest.approx(math.sqrt(39.48)) and scene.zeta == 0.5
    scene.c = 2 * math.sqrt(39.48)
    assert scene.zeta == pytest.approx(1.0)
    scene.m = 4.0
    assert scene.zeta == pytest.approx(0.5), "c is kept"
    scene.keep = "zeta"
    scene.k = 4 * 39.48
    assert scene.zeta == pytest.approx(0.5) and scene.c == pytest.approx(4 * math.sqrt(39.48)), "zeta is kept"
    assert "zeta" in scene.value.off_default() and "c" not in scene.value.off_default()


def test_a_link_with_zeta_alone_sets_c() -> None:
    assert DAMPED.at({"zeta": 1.0}).c == pytest.approx(12.566622)
    assert DAMPED.at({"zeta": 1.0, "c": 3.0}).zeta == pytest.approx(3.0 / 12.566622)
    assert DAMPED.at({"zeta": 1.0, "c": 3.0, "keep": "zeta"}).c == pytest.approx(12.566622)


def late(scene: Scene, share: float) -> float:
    """The last time at which |x| is more than that share of |x_0|, from dense samples, and ten to each of them."""
    one = DampedOscillator(m=scene.m, c=scene.c, k=scene.k)
    start, step = 0.0, 14.0 / one.rates[0]
    for count in (40_000, 10):
        t = start + np.arange(count + 1) * (step := step / count)
        beyond = np.abs(one.motion(scene.x_0, scene.v_0, t).x) > share * abs(scene.x_0)
        start = float(t[np.flatnonzero(beyond)[-1]])
    return start


def test_the_presets_are_as_they_say() -> None:
    keep = math.exp(-DampedOscillator(m=1.0, c=1.257, k=39.48).log_decrement)
    assert keep == pytest.approx(0.532, abs=5e-4) and late(taken("damped", "Light"), 0.01) == pytest.approx(
        7.13, abs=0.01
    )
    car, worn = taken("damped", "Car"), taken("damped", "Worn")
    assert car.zeta == pytest.approx(0.306, abs=5e-4) and late(car, 0.05) == pytest.approx(0.976, abs=1e-3)
    assert car.shown.sources["time"]["x"].min() / -car.x_0 == pytest.approx(0.364, abs=1e-3)
    assert worn.c == car.c / 5 and late(worn, 0.05) == pytest.approx(5.84, abs=0.01)
    door = taken("damped", "Door closer")
    assert door.zeta == 1.5 and late(door, 0.01) == pytest.approx(8.31, abs=0.01)
    assert late(taken("damped", "Critical"), 0.01) == pytest.approx(1.06, abs=5e-3)
    assert late(DAMPED(zeta=3.0), 0.01) == pytest.approx(4.30, abs=5e-3)
    assert late(DAMPED(zeta=0.83), 0.01) == pytest.approx(0.674, abs=1e-3)
    thrown = taken("damped", "Thrown")
    columns = thrown.shown.sources["time"]
    assert columns["x"].min() == pytest.approx(-0.0525, abs=5e-5)
    heat = 1 - np.interp(0.2, columns["t"], columns["E"]) / columns["E_0"][0]
    assert heat == pytest.approx(0.988, abs=5e-4)
    assert "at 0.0506 s" in sentence(thrown)


SOME = st.floats(-1.0, 1.0).map(lambda power: 10.0**power)


def zeros(one: DampedOscillator, x_0: float, v_0: float) -> tuple[Floats, Floats]:
    """Dense instants, and the places among them before which x changes its sign."""
    t = np.linspace(0.0, 20.0 / one.rates[0], 60_001)
    x = one.motion(x_0, v_0, t).x
    return t, np.flatnonzero(np.diff(np.sign(x[np.abs(x) > 1e-9 * abs(x_0)])))


@settings(max_examples=tries(80), deadline=None)
@given(SOME, SOME, st.floats(0.01, 6.0), st.floats(-1, 1), st.sampled_from([0.0, -0.3, -4.0, 1.0]))
def test_its_sentence_is_true(m: float, k: float, zeta: float, x_0: float, throw: float) -> None:
    x_0 = round(x_0, 2) or 0.5
    omega = math.sqrt(k / m)
    scene = DAMPED(m=m, k=k, zeta=zeta, x_0=x_0, v_0=throw * x_0 * omega)
    one, told = DampedOscillator(m=m, c=scene.c, k=k), sentence(scene)
    if told.startswith("Each swing keeps"):
        tau = 2 * math.pi / one.omega_d
        a, b = (one.motion(x_0, scene.v_0, np.array([s])).x[0] for s in (0.1 * tau, 1.1 * tau))
        share, energy, longer, *_ = numbers(told)
        assert share == pytest.approx(100 * b / a, rel=6e-3) and energy == pytest.approx(100 * (b / a) ** 2, rel=6e-3)
        assert "100 %" not in told
        assert longer == pytest.approx(100 * (tau * omega / (2 * math.pi) - 1), rel=6e-3)
    elif told.startswith("It hardly swings"):
        half = one.motion(x_0, scene.v_0, np.array([0.3 / omega, 0.3 / omega + math.pi / one.omega_d])).x
        assert one.zeta < 1 and numbers(told)[0] == pytest.approx(100 * abs(half[1] / half[0]), rel=0.02)
    elif told.startswith("It passes 0 once"):
        t, signs = zeros(one, x_0, scene.v_0)
        assert signs.size == 1 and numbers(told)[1] == pytest.approx(t[signs[0]], abs=2 * t[1] + 0.01 * t[signs[0]])
        assert abs(scene.v_0) > numbers(told)[2] * 0.995
    elif told.startswith("It goes out to"):
        t, signs = zeros(one, x_0, scene.v_0)
        x = one.motion(x_0, scene.v_0, t).x
        assert (
            throw > 0
            and signs.size == 0
            and np.sign(x_0) * numbers(told)[0] == pytest.approx(np.max(np.abs(x)), rel=0.02)
        )
    else:
        t, signs = zeros(one, x_0, scene.v_0)
        assert told.startswith("It has fallen to 1 % of its start") and signs.size == 0 and throw <= 0
        x = np.abs(one.motion(x_0, scene.v_0, t).x)
        assert np.all(np.diff(x) <= 1e-12 * abs(x_0)), "it falls all the while"
        assert numbers(told)[1] == pytest.approx(late(scene, 0.01), rel=6e-3)


@pytest.mark.parametrize("zeta", [1e-12, 1e-9, 1e-6, 1e-4, 7e-4])
def test_a_swing_that_loses_little_is_not_said_to_keep_all(zeta: float) -> None:
    scene = DAMPED(zeta=zeta)
    lost, energy, longer = numbers(sentence(scene))
    delta = 2 * math.pi * zeta / math.sqrt(1 - zeta**2)
    assert "all but" in sentence(scene) and scene.shown.values["keep"].startswith("all but")
    assert lost == pytest.approx(-100 * math.expm1(-delta), rel=6e-3)
    assert energy == pytest.approx(-100 * math.expm1(-2 * delta), rel=6e-3)
    assert longer == pytest.approx(50 * zeta**2, rel=6e-3)


@pytest.mark.parametrize("zeta", [0.02, 0.1, 0.306, 0.49, 0.51, 0.9, 1.5])
@pytest.mark.parametrize("start", [{}, {"v_0": 2.0}, {"v_0": -0.1}, {"x_0": 0.0, "v_0": 1.0}])
def test_the_power_is_greatest_where_it_is_said_to_be(zeta: float, start: dict[str, float]) -> None:
    """Before x = 0 on its way there, but not close to it: with much damping halfway."""
    scene = DAMPED(zeta=zeta, **start)
    t = np.linspace(0.0, 5.0, 50_001)
    motion = DampedOscillator(m=scene.m, c=scene.c, k=scene.k).motion(scene.x_0, scene.v_0, t)
    top = int(np.argmax(np.abs(motion.v)))
    at = scene.shown.forms["fastest"]
    assert (at == "at_start") == (top == 0)
    if at == "before":
        assert motion.x[top] * motion.v[top] < 0 and (motion.x[top:] * motion.x[top] < 0).any()
    assert "just before" not in msgspec.json.encode(DAMPED.sheet()).decode()


@pytest.mark.parametrize("zeta", [1 - 9e-7, 1 - 3.6e-8, 1.0, 1 + 5e-7])
@pytest.mark.parametrize("share", [0.0, 0.1, 0.9, 0.999, 1.01, 3.0])
def test_next_to_critical_it_crosses_only_where_it_is_thrown_faster_than_is_said(zeta: float, share: float) -> None:
    scene = DAMPED(zeta=zeta, v_0=-0.1 * share * math.sqrt(39.48))
    told = sentence(scene)
    assert told.startswith("It passes 0 once" if share > 1 else "It has fallen to 1 % of its start after"), told


def test_mass_spring_and_dashpot_go_along_and_one_without_a_dashpot_brings_mass_and_spring() -> None:
    page = Page(SCENES["oscillator"](m=3.0, k=20.0))

    def go(scene: str) -> dict[str, Any]:
        told = page.send({"type": "open", "state": {"scene": scene}, "carried": True, "number": len(page.packets) + 1})
        return dict(told["state"]["parameters"])

    assert go("damped") == {"m": 3.0, "k": 20.0}
    set_values(page, c=5.0)
    assert go("energy") == {"m": 3.0, "k": 20.0}
    assert go("damped") == {"m": 3.0, "k": 20.0, "c": 5.0}

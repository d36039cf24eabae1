"""What is said of each preset when it is taken: one sentence, and what it claims holds in that preset."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from components.scene import Scene
from components.scenes import SCENES

PLAYED = {slug: scene for slug, scene in SCENES.items() if scene.work is None}


@pytest.mark.parametrize("slug", PLAYED)
def test_each_preset_that_is_played_says_what_to_watch(slug: str) -> None:
    scene = PLAYED[slug]
    assert list(scene.watch) == list(scene.presets)
    assert all(20 < len(said) <= 100 and said.endswith(".") for said in scene.watch.values()), scene.watch


def taken(slug: str, label: str) -> Any:
    scene: Scene = SCENES[slug]()
    scene.set({name: scene.preset_value(label, name) for name in scene.preset_names()})
    return scene


def figure(scene: Scene, name: str) -> float:
    return next(one.value for one in scene.figures() if one.name == name)


def test_heavier_and_stiffer_oscillators() -> None:
    usual = figure(taken("oscillator", "Pushed back"), "tau")
    assert figure(taken("oscillator", "Heavy"), "tau") == pytest.approx(2 * usual)
    assert figure(taken("oscillator", "Stiff"), "tau") == pytest.approx(usual / 2, rel=0.01)
    still = taken("oscillator", "Pushed back")
    assert still.x_0 * still.v_0 < 0


def test_the_energies_of_the_hanging_mass() -> None:
    pulled, pushed, heavy, soft = (taken("energy", label) for label in ("Pulled down", "Pushed up", "Heavy", "Soft"))
    assert figure(pushed, "E_total") == figure(pulled, "E_total") == figure(heavy, "E_total")
    assert figure(heavy, "delta_st") == pytest.approx(2 * figure(pulled, "delta_st"))
    for one in (heavy, soft):
        assert figure(one, "tau") > figure(pulled, "tau") and figure(one, "delta_st") > figure(pulled, "delta_st")


def test_analogues_and_flights() -> None:
    assert figure(taken("analogues", "Cavendish"), "period") > 600
    for label, least, most in (("60°", 0.05, 0.1), ("Clock", 0.0, 0.001), ("Nearly over", 1.0, 10.0)):
        scene = taken("analogues", label)
        late = figure(scene, "period") * figure(scene, "omega") / (2 * math.pi) - 1
        assert least < late < most, label
    assert "speed falls to 0" in SCENES["phugoid"].watch["Cusp, 0.732"]
    speed = {label: taken("phugoid", label) for label in SCENES["phugoid"].presets}
    lowest = {label: scene.v_0 + scene.shown.columns["time"]["v"].min() for label, scene in speed.items()}
    assert abs(lowest["Cusp, 0.732"]) < 0.01 * speed["Cusp, 0.732"].v_0


def test_the_modes_of_the_coupled_masses() -> None:
    for label, other in (("Slow", "fast"), ("Fast", "slow")):
        columns = taken("coupled", label).shown.columns["time"]
        assert np.abs(columns[f"x1_{other}"]).max() < 1e-15
        ways = np.sign(columns["x1"] * columns["x2"])
        assert set(ways[np.abs(columns["x1"]) > 1e-9]) == {1.0 if label == "Slow" else -1.0}
    omega = [figure(taken("coupled", "Equal (slide 8)"), name) for name in ("omega_minus", "omega_plus")]
    assert omega == pytest.approx([0.618, 1.618], abs=5e-4)
    assert omega[1] / omega[0] == pytest.approx((3 + math.sqrt(5)) / 2), "not rational"
    beats = taken("coupled", "Beats").shown.columns["time"]
    assert np.abs(beats["x1"][:40]).max() > 0.19
    heavy = taken("coupled", "Heavy, light").shown.columns["time"]
    assert np.abs(heavy["x1_fast"]).max() < 0.02 * np.abs(heavy["x1_slow"]).max()
    assert np.abs(heavy["x2_fast"]).max() > 0.9 * np.abs(heavy["x2_slow"]).max()


def test_the_driven_masses() -> None:
    assert figure(taken("forced", "Equal (slide 8)"), "Xp1") < 0
    still = taken("forced", "Still mass 1")
    assert np.abs(still.shown.columns["time"]["x1"]).max() < 1e-15
    light = taken("forced", "Light mass 2")
    slow, fast = figure(light, "omega_minus"), figure(light, "omega_plus")
    assert slow < 1 < fast < 1.3 * slow
    below, at, above = (taken("absorber", label) for label in ("Below", "Resonant", "Above"))
    own = math.sqrt(below.k1 / below.m1)
    assert below.omega < own == at.omega < above.omega

"""Presets state all values that their pictures and sentences need, one that compares changes one value, and the
sentence that is shown when one is chosen is true of it.
"""

from __future__ import annotations

import math
from contextlib import suppress

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.scenes import SCENES
from tests.grids import tries
from tests.scenes.presets import readout, taken

FREE = {
    "analogues": {
        *(f"{system}_start" for system in ("circuit", "floating", "pipe", "shaft", "spring", "string", "wave")),
        *(f"floating_{name}" for name in ("A", "m", "rho")),
        *(f"rocking_{name}" for name in "mdr"),
        *(f"pipe_{name}" for name in "Lcn"),
        *("pendulum_g", "pendulum_m", "spring_k", "spring_m", "string_L", "string_n", "wave_g", "wave_rho"),
    },
    "energy": {"g"},
    "phugoid": {"g", "m", "v_0"},
    "modes": {"omega", "ratio", "x1_0", "x2_0"},
    "coupled": {"X_slow", "X_fast", "phi_slow", "phi_fast"},
    "absorber": {"_valley", "c", "lightest", "lightest_k2", "m2", "x1_0", "x2_0", "v1_0", "v2_0"},
    "accuracy": {"F_0", "cost", "limit", "omega", "steps", "wanted", *(f"{q}{i}" for q in "mk" for i in (1, 2))}
    | {f"{q}{i}_0" for q in "xv" for i in (1, 2)},
}
"""Quantities that no preset of a scene has to state: its sentences hold for each value, or they follow from a start."""
COMPARING = {
    ("oscillator", "Heavy", "Pulled"): {"m"},
    ("oscillator", "Stiff", "Pulled"): {"k"},
    ("energy", "Heavy", "Pulled down"): {"m"},
    ("energy", "Soft", "Pulled down"): {"k"},
    ("energy", "Pushed up", "Pulled down"): {"x_0"},
    ("damped", "Worn", "Car"): {"c"},
    ("damped", "Critical", "Light"): {"c"},
    ("damped", "No dashpot", "Light"): {"c"},
    ("driven", "Resonance", "Below"): {"omega"},
    ("driven", "Above", "Below"): {"omega"},
    ("driven", "Strong dashpot", "Resonance"): {"c"},
    ("modes", "No wall", "Unequal masses"): {"k1"},
    ("modes", "Loose", "Unequal masses"): {"k2"},
    ("forced", "At slow", "All equal"): {"omega"},
    ("forced", "At fast", "All equal"): {"omega"},
    ("absorber", "Resonant", "Below"): {"omega"},
    ("absorber", "Above", "Below"): {"omega"},
}


@pytest.mark.parametrize("slug", SCENES)
def test_presets_say_what_to_watch_and_state_every_quantity_that_they_need(slug: str) -> None:
    scene = SCENES[slug]
    assert list(scene.watch) == list(scene.presets)
    for label, values in scene.presets.items():
        assert set(values) == set(scene.preset_names()), label
    silent = scene.quantities() - set(scene.preset_names()) - scene().derived() - {"window"}
    assert silent == FREE.get(slug, set())


@pytest.mark.parametrize(("slug", "label", "other"), COMPARING)
def test_a_preset_that_compares_changes_one_value(slug: str, label: str, other: str) -> None:
    one, two = (SCENES[slug].presets[name] for name in (label, other))
    assert {name for name in one if one[name] != two[name]} == COMPARING[slug, label, other]


@settings(max_examples=tries(40), suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(st.data())
def test_a_preset_has_its_values_whatever_the_state_before(data: st.DataObject) -> None:
    slug, label = data.draw(st.sampled_from([(slug, label) for slug in SCENES for label in SCENES[slug].presets]))
    names = st.sampled_from(sorted(SCENES[slug].quantities() - {"window", "lightest", "lightest_k2"}))
    before = data.draw(st.dictionaries(names, st.floats(0.01, 5.0), max_size=4))
    scene = SCENES[slug]()
    for name, value in before.items():
        with suppress(ValueError):  # a value that is refused changes nothing
            scene.set({name: value})
    scene.set(SCENES[slug].preset_all(label))
    assert {name: scene.values[name] for name in scene.presets[label]} == dict(scene.presets[label])


def test_heavier_and_stiffer_oscillators() -> None:
    usual = readout(taken("oscillator", "Pushed back"), "tau")
    assert readout(taken("oscillator", "Heavy"), "tau") == pytest.approx(2 * usual)
    assert readout(taken("oscillator", "Stiff"), "tau") == pytest.approx(usual / 2, rel=0.01)
    still = taken("oscillator", "Pushed back")
    assert still.x_0 * still.v_0 < 0


def test_the_energies_of_the_hanging_mass() -> None:
    pulled, pushed, heavy, soft = (taken("energy", label) for label in ("Pulled down", "Pushed up", "Heavy", "Soft"))
    assert readout(pushed, "E_total") == readout(pulled, "E_total") == readout(heavy, "E_total")
    assert readout(heavy, "delta_st") == pytest.approx(2 * readout(pulled, "delta_st"))
    for one in (heavy, soft):
        assert readout(one, "tau") > readout(pulled, "tau") and readout(one, "delta_st") > readout(pulled, "delta_st")


def test_analogues_and_flights() -> None:
    assert readout(taken("analogues", "Cavendish"), "period") > 600
    for label, least, most in (("60°", 0.05, 0.1), ("Clock", 0.0, 0.001), ("Nearly over", 1.0, 10.0)):
        scene = taken("analogues", label)
        late = readout(scene, "period") * readout(scene, "omega") / (2 * math.pi) - 1
        assert least < late < most, label
    assert "speed falls to 0" in SCENES["phugoid"].watch["Cusp, 0.732"]
    speed = {label: taken("phugoid", label) for label in SCENES["phugoid"].presets}
    lowest = {label: scene.v_0 + scene.shown.sources["time"]["v"].min() for label, scene in speed.items()}
    assert abs(lowest["Cusp, 0.732"]) < 0.01 * speed["Cusp, 0.732"].v_0


def test_the_modes_of_the_coupled_masses() -> None:
    for label, other in (("Slow", "fast"), ("Fast", "slow")):
        columns = taken("coupled", label).shown.sources["time"]
        assert np.abs(columns[f"x1_{other}"]).max() < 1e-15
        ways = np.sign(columns["x1"] * columns["x2"])
        assert set(ways[np.abs(columns["x1"]) > 1e-9]) == {1.0 if label == "Slow" else -1.0}
    omega = [readout(taken("coupled", "All equal"), name) for name in ("omega_minus", "omega_plus")]
    assert omega == pytest.approx([0.618, 1.618], abs=5e-4)
    assert omega[1] / omega[0] == pytest.approx((3 + math.sqrt(5)) / 2), "not rational"
    beats = taken("coupled", "Beats").shown.sources["time"]
    assert np.abs(beats["x1"][:40]).max() > 0.19
    heavy = taken("coupled", "Heavy, light").shown.sources["time"]
    assert np.abs(heavy["x1_fast"]).max() < 0.02 * np.abs(heavy["x1_slow"]).max()
    assert np.abs(heavy["x2_fast"]).max() > 0.9 * np.abs(heavy["x2_slow"]).max()


def test_the_driven_masses() -> None:
    assert readout(taken("forced", "All equal"), "Xp1") < 0
    still = taken("forced", "Still mass 1")
    assert np.abs(still.shown.sources["time"]["x1"]).max() < 1e-15
    light = taken("forced", "Light mass 2")
    slow, fast = readout(light, "omega_minus"), readout(light, "omega_plus")
    assert slow < 1 < fast < 1.3 * slow
    below, at, above = (taken("absorber", label) for label in ("Below", "Resonant", "Above"))
    own = math.sqrt(below.k1 / below.m1)
    assert below.omega < own == at.omega < above.omega

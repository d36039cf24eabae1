"""Presets state all values that their pictures and sentences need, and one that compares changes one value."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.scenes import SCENES
from tests.grids import tries

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
presets = pytest.mark.parametrize(
    ("slug", "label"), [(slug, label) for slug in SCENES for label in SCENES[slug].presets]
)


@presets
def test_a_preset_states_each_value_that_a_preset_of_its_scene_sets(slug: str, label: str) -> None:
    scene = SCENES[slug]
    assert set(scene.presets[label]) == set(scene.preset_names())


@pytest.mark.parametrize("slug", SCENES)
def test_presets_state_every_quantity_that_their_sentences_need(slug: str) -> None:
    scene = SCENES[slug]
    silent = scene.quantities() - set(scene.preset_names()) - scene().derived() - {"window"}
    assert silent == FREE.get(slug, set())


@pytest.mark.parametrize(("slug", "label", "other"), COMPARING)
def test_a_preset_that_compares_changes_one_value(slug: str, label: str, other: str) -> None:
    one, two = (SCENES[slug].presets[name] for name in (label, other))
    assert {name for name in one if one[name] != two[name]} == COMPARING[slug, label, other]


def taken_from(slug: str, label: str, before: dict[str, float]) -> Any:
    scene = SCENES[slug]()
    for name, value in before.items():
        try:
            scene.set({name: value})
        except ValueError:
            continue  # refused: the state does not change
    scene.set(SCENES[slug].preset_all(label))
    return scene


@settings(max_examples=tries(40), suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(st.data())
def test_a_preset_has_its_values_whatever_the_state_before(data: st.DataObject) -> None:
    slug, label = data.draw(st.sampled_from([(slug, label) for slug in SCENES for label in SCENES[slug].presets]))
    names = st.sampled_from(sorted(SCENES[slug].quantities() - {"window", "lightest", "lightest_k2"}))
    before = data.draw(st.dictionaries(names, st.floats(0.01, 5.0), max_size=4))
    scene = taken_from(slug, label, before)
    assert {name: scene.values[name] for name in scene.presets[label]} == dict(scene.presets[label])

"""The numbers of a scene: floats in SI with unit and meaning."""

from __future__ import annotations

import math

import mpmath as mp
import pytest
from hypothesis import Phase, given, settings

from components.quantities.readouts import SceneNumber
from components.scene import Scene
from components.scenes import SCENES
from tests.scenes.number_truth import DIGITS, TRUTHS, Truth
from tests.states import values

scenes = pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
TOLERANCE = 1e-9
NO_SHRINK = (Phase.explicit, Phase.generate)
"""A failing state is reported unshrunk, because shrinking would take minutes."""
OTHERWISE = {
    "driven": {  # test_driven_pushes
        "P_in",
        "P_lost",
        "on_peak",
        "strongest",
        "X_strongest",
        "misses",
        "slice_width",
    },
    "chain": {"E"},  # test_chain
    "modes": {"third_rate", "fourth_rate"},  # tests/physics/test_damped_chain
    "absorber": {"help_low", "help_high", "dies"},  # tests/physics/test_absorber, and below
    "analogues": {"inertia", "stiffness"},  # tests/physics/test_analogues
    "accuracy": {"drift_euler", "drift_verlet", "drift_rk4", "picked_error", "picked_time", "picked_evaluations"},
}
"""Numbers that other tests compare."""


def check(scene: Scene, numbers: dict[str, SceneNumber], truth: Truth) -> set[str]:
    """Compare the numbers of a scene with true ones, and return the names of both."""
    both = numbers.keys() & truth.keys()
    for name in both:
        value, given = numbers[name].value, truth[name]
        true, size = given if isinstance(given, tuple) else (given, abs(given))
        if math.isinf(value):
            assert mp.isinf(true) or abs(true) > 1e300, (name, dict(scene.values))
            continue
        off = abs(value - true)
        if numbers[name].unit == "rad":
            off, size = min(off, abs(off - 2 * mp.pi)), max(size, 1)
        assert off <= TOLERANCE * size or abs(true) < 1e-300, (name, value, mp.nstr(true, 20), dict(scene.values))
    return both


@scenes
def test_the_numbers_are_those_of_another_route(scene: type[Scene]) -> None:
    seen: set[str] = set()
    known: set[str] = set()

    def compare(state: dict[str, object]) -> None:
        try:
            numbers = (one := scene.at(state)).numbers
        except ValueError:
            return
        for name, number in numbers.items():
            assert not math.isnan(number.value), name
            assert number.description and not number.description.endswith("."), name
        with mp.workdps(DIGITS):
            seen.update(check(one, numbers, TRUTHS[scene.slug](one)))
        known.update(numbers)

    @settings(max_examples=100, phases=NO_SHRINK)
    @given(values(scene))
    def check_random(state: dict[str, object]) -> None:
        compare(state)

    for label in scene.presets:
        compare(dict(scene.preset_all(label)))
    check_random()
    assert known - seen <= OTHERWISE.get(scene.slug, set())
    assert len(seen) >= 2

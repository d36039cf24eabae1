"""The numbers of a scene: floats in SI with unit and meaning."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings

from components.scene.case import CaseScene
from components.scenes import SCENES
from physics.coupled import TwoMassChain
from physics.damped import DampedOscillator
from tests.states import values

MOVED = [scene for scene in SCENES.values() if issubclass(scene, CaseScene)]


@pytest.mark.parametrize("scene", MOVED, ids=lambda scene: scene.slug)
def test_every_number_has_a_meaning(scene: type[CaseScene]) -> None:
    @settings(max_examples=30, deadline=None, derandomize=True)
    @given(values(scene))
    def check(state: dict[str, object]) -> None:
        try:
            shown = scene(**state)
        except ValueError:
            return
        for name, number in shown.numbers.items():
            assert not math.isnan(number.value), name
            assert number.description and not number.description.endswith("."), name

    check()
    assert scene().numbers


def test_the_numbers_of_a_damped_mass_are_those_of_physics() -> None:
    scene = SCENES["damped"](m=2.0, c=3.0, k=50.0, view="energy")
    one = DampedOscillator(m=2.0, c=3.0, k=50.0)
    numbers = {name: (number.value, number.unit) for name, number in scene.numbers.items()}
    assert numbers["omega"] == (one.omega_n, "rad/s")
    assert numbers["zeta"] == (one.zeta, "")
    assert numbers["tau_d"] == (2 * math.pi / one.omega_d, "s")
    assert numbers["delta"] == (one.log_decrement, "")
    assert "home" not in numbers
    over = SCENES["damped"](m=2.0, c=60.0, k=50.0)
    assert over.numbers["home"].unit == "s" and "tau_d" not in over.numbers


def test_the_numbers_of_two_masses_are_those_of_physics() -> None:
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=3.0)
    numbers = SCENES["coupled"](m1=2.0, m2=1.0, k1=4.0, k2=3.0).numbers
    found = [numbers[name].value for name in ("omega_minus", "omega_plus", "slow_ratio", "fast_ratio")]
    assert found == [*chain.modes().omega.tolist(), *chain.modes().ratio.tolist()]
    assert numbers["omega_minus"].unit == "rad/s"

"""Scene absorber: its goals, its tuning, links, refusals and any machine, through its callbacks."""

from __future__ import annotations

import numpy as np
import pytest

from components.scenes import SCENES
from components.scenes.absorber import Absorber
from components.session.opening import opened
from components.state.link import read_query
from physics.absorber import den_hartog
from tests.page.headless_page import Page, apply_message, change, set_values, take_preset
from tests.scenes.checks import as_arguments, check_picture, solves

M1, K1, F_0 = 100.0, 250e3, 500.0


def met(scene: Absorber) -> list[bool]:
    return [bool(scene.shown.scalars[f"met{i}"]) for i in range(3)]


def lightest_tuned(omega: float) -> float:
    """The mass at which a tuned absorber's resonances are 20 % away: the roots of D at 0.8 and 1.2 omega."""
    below, above = ((K1 - M1 * (s * omega) ** 2) * (1 - s**2) / (s**2 * omega**2) for s in (0.8, 1.2))
    return max(below, above)


@pytest.mark.parametrize("label", ["Below", "Resonant", "Above"])
def test_goals_can_be_met_from_the_lightest_mass_on(label: str) -> None:
    scene = Absorber()
    assert take_preset(scene, label) == {}
    mass = lightest_tuned(scene.omega)
    scene.m2 = mass * (1 - 1e-3)
    assert met(scene) == [False, True, True]
    assert scene.shown.values["lightest"] == "none yet"
    scene.m2 = mass * (1 + 1e-3)
    assert met(scene) == [True, True, True]
    assert scene.shown.values["lightest"] == f"{mass * (1 + 1e-3):.4g} kg"


def test_score_is_the_lightest_mass_of_this_machine() -> None:
    scene = Absorber(m2=30.0)
    assert scene.shown.values["lightest"] == "30 kg"
    scene.m2 = 26.0
    scene.m2 = 40.0
    assert scene.shown.values["lightest"] == "26 kg"
    scene.set({"damping": "added", "c": 0.1, "m2": 25.5})
    assert scene.shown.values["lightest"] == "26 kg"
    scene.omega = 47.0
    assert scene.shown.values["lightest"] == "none yet"


def test_a_link_and_a_state_carry_the_lightest_solution_which_is_looked_at_again() -> None:
    page = Page(Absorber(m2=30.0))
    told = set_values(page, m2=40.0)
    assert told["view"]["values"]["lightest"] == "30 kg"
    again = opened(SCENES, read_query(as_arguments(told["query"]), SCENES))
    assert again.now.shown.values["lightest"] == "30 kg"
    state = {**told["state"], "parameters": {**told["state"]["parameters"], "lightest": 3.0}}
    assert change(page, **state)["view"]["values"]["lightest"] == "40 kg", "no absorber of 3 kg does it"
    assert set_values(page, lightest=3.0)["errors"], "nobody sets it"


def test_tuned_spring_follows_mass_and_speed() -> None:
    scene = Absorber()
    scene.m2 = 20.0
    assert (scene.k2, scene.tuning) == (46080.0, "tuned")
    scene.omega = 50.0
    assert (scene.k2, scene.tuning) == (50e3, "tuned")
    scene.k2 = 45e3
    assert (scene.k2, scene.tuning) == (45e3, "free")
    scene.m2 = 30.0
    assert scene.k2 == 45e3
    assert apply_message(scene, {"type": "choose", "name": "tuning", "value": "tuned"}) == {}
    assert scene.k2 == 75e3


def test_knob_drags_the_valley() -> None:
    scene = Absorber()
    assert apply_message(scene, {"type": "set", "values": {"_valley": 40.0}}) == {}
    assert (scene.k2, scene.tuning, scene.values["_valley"]) == (25600.0, "free", 40.0)
    data = scene.sources["sweep"].data
    low = np.argmin(np.where((data["w"] > 36) & (data["w"] < 44), data["swing"], np.inf))
    assert data["w"][low] == pytest.approx(40.0, abs=1e-9)


def test_den_hartogs_optimum() -> None:
    scene = Absorber(damping="added")
    assert apply_message(scene, {"type": "act", "name": "optimum"}) == {}
    best = den_hartog(M1, K1, 16.0)
    assert (scene.k2, scene.c) == (pytest.approx(best.k2, rel=5e-4), pytest.approx(best.c, rel=5e-4))
    assert scene.sources["sweep"].data["swing"].max() == pytest.approx(best.height * F_0 / K1, rel=5e-3)
    assert scene.shown.values["over_height"] == "0.27 %"
    heights = [scene.shown.scalars[f"{name}_y"] for name in "PQ"]
    assert heights == pytest.approx([1e3 * best.height * F_0 / K1] * 2, rel=1e-3)
    assert scene.shown.forms["why"] == "damped"


def test_damping_stays_out_until_asked_for() -> None:
    scene = Absorber(c=500.0)
    np.testing.assert_array_equal(scene.sources["sweep"].data["swing"], Absorber().sources["sweep"].data["swing"])


def test_one_solve_even_where_one_value_follows_another() -> None:
    scene = Absorber()
    counted = solves(scene)
    scene.m2 = 20.0
    apply_message(scene, {"type": "set", "values": {"_valley": 45.0}})
    take_preset(scene, "Above")
    assert len(counted) == 3


def test_presets_choose_the_machine_and_leave_the_absorber() -> None:
    scene = Absorber(m2=30.0)
    for label, omega, kind in (("Resonant", 50.0, "fixed"), ("Above", 60.0, "fixed"), ("Own", 48.0, "own")):
        take_preset(scene, label)
        assert (scene.omega, scene.m2, scene.preset()) == (omega, 30.0, label)
        assert scene.shown.forms[kind]
        assert scene.k2 == pytest.approx(30.0 * omega**2, rel=1e-15)


def test_a_motion_from_rest_that_cannot_be_drawn_takes_its_view_alone_away() -> None:
    machine = {"own": True, "m1": 1e130, "k1": 1e-32, "F_0": 1e57, "omega": 1e113, "m2": 1e26, "k2": 1e145}
    scene = Absorber(**machine, tuning="free")
    check_picture(scene)
    assert not scene.sources["rest"].data and len(scene.sources["sweep"].data["w"])
    with pytest.raises(ValueError, match="outside the range of doubles"):
        scene.view = "rest"
    assert scene.view == "goals"

"""Scene analogues through its callbacks: nine systems, their spring, and the pendulum at any amplitude."""

from __future__ import annotations

import itertools
import math

import mpmath as mp
import numpy as np
import pytest

from components.scenes.analogues import Analogues
from physics.analogues import ANALOGUES
from tests.page.scripts import played
from tests.scenes.checks import quantities, taken


def own(slug: str) -> list[str]:
    """The parameters of one system."""
    names = [name for name in quantities(Analogues) if name.startswith(f"{slug}_")]
    return [*names, "theta_0"] if ANALOGUES[slug].length_of else names


def test_energies_of_the_pendulum_and_of_its_spring_part() -> None:
    scene = Analogues(theta_0=100.0, pendulum_m=2.0, pendulum_l=0.5)
    data = scene.sources["time"].data
    for i in (3, 50, 200):
        named = played(scene.shown, data["t"][i])
        lifted = 2.0 * 9.81 * 0.5 * (1 - math.cos(data["q"][i]))
        assert named["V_q"] == pytest.approx(lifted, abs=1e-4)
        assert named["T_q"] + named["V_q"] == pytest.approx(9.81 * (1 - math.cos(math.radians(100))), rel=1e-12)
        assert named["T_x"] + named["V_x"] == pytest.approx(9.81 * math.radians(100) ** 2 / 2, rel=1e-12)
        assert named["V_x"] == pytest.approx(9.81 * data["x"][i] ** 2 / 2, rel=1e-9)


def test_lateness_is_that_of_the_agm_and_its_flags_stand_on_it() -> None:
    def late(degrees: float) -> float:
        return float(1 / mp.agm(1, mp.cos(mp.radians(degrees) / 2)) - 1)

    scene = Analogues(theta_0=75.0)
    curve, here = scene.sources["late"].data, scene.sources["here"].data
    np.testing.assert_allclose(curve["excess"], [late(angle) for angle in curve["angle"]], rtol=1e-9, atol=1e-15)
    assert here["excess"][0] == pytest.approx(late(75.0), rel=1e-12)
    for flag, excess in (("late_01", 0.001), ("late_1", 0.01), ("late_5", 0.05)):
        assert late(scene.shown.scalars[flag]) == pytest.approx(excess, rel=2e-5)
    scene.set({"theta_0": scene.shown.scalars["late_5"]})
    assert scene.shown.values["late_percent"] == "5.00"


@pytest.mark.parametrize(
    ("label", "period"), [("Radio", 1e-6), ("Guitar", 1 / 329.6), ("Swell", 11.32), ("Cavendish", 840)]
)
def test_microseconds_and_minutes_play_at_a_speed_that_is_seen(label: str, period: float) -> None:
    scene = taken("analogues", label)
    assert 2 * math.pi / scene.numbers["omega"].value == pytest.approx(period, rel=2e-3)
    assert 1 <= period / scene.shown.pace.auto <= 12


@pytest.mark.parametrize("slug", ANALOGUES)
def test_only_the_chosen_systems_controls_are_visible(slug: str) -> None:
    scene = Analogues(system=slug)
    shown = [group.names for group in scene.groups if group.is_shown(scene.shown.forms)]
    assert sorted(itertools.chain(*shown)) == sorted(["system", *own(slug)])

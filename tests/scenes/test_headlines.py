"""Headlines and tasks are true in every state of their view."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.scenes.analogues import Analogues
from components.scenes.analogues.controls import SWINGING
from components.scenes.phugoid import Phugoid
from physics.analogues import ANALOGUES
from tests.grids import tries
from tests.physics.braked_cases import sizes

many = settings(max_examples=tries(200), suppress_health_check=[HealthCheck.too_slow])


# Modes


# Phugoid


@many
@given(sizes(0, 3), sizes(0, 2), sizes(0, 5), sizes(0, 5), st.floats(-0.9, 1.0))
def test_the_speed_of_an_aircraft_sets_its_period_and_its_mass_does_not(
    v_0: float, g: float, m: float, other: float, excess: float
) -> None:
    def periods(speed: float, mass: float) -> list[float]:
        readouts = Phugoid(v_0=speed, g=g, m=mass, excess=excess).readouts()
        return [one.value for one in readouts if one.symbol.startswith("τ") and isinstance(one.value, float)]

    found = periods(v_0, m)
    assert found and periods(v_0, other) == found
    np.testing.assert_allclose(periods(2 * v_0, m), 2 * np.array(found), rtol=1e-9)
    assert "only" not in Phugoid.headline and Phugoid.headline.startswith("Without losses")


# Analogues


@many
@given(st.sampled_from(sorted(ANALOGUES)), sizes(-3, 0))
def test_small_swings_of_each_system_are_those_of_a_spring(slug: str, share: float) -> None:
    start = {"theta_0": 10 * share} if slug in SWINGING else {f"{slug}_start": share * ANALOGUES[slug].swing}
    readouts = {one.symbol: one.value for one in Analogues(system=slug, **start).readouts()}
    assert "for small swings" in Analogues.headline
    assert abs(readouts["τ"] * readouts["ω_n"] / (2 * math.pi) - 1) < 2e-3

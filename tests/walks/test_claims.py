"""The claims in the sentences of the walks beyond their numbers, worked out from the physics."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes import SCENES
from components.walks.links import standing_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.forced import particular_solution
from physics.oscillator import Oscillator
from tests.walks.facts import beats, equal, plain

STEPS = steps_of(load_walks(()).values())


def test_the_acceleration_is_against_the_displacement() -> None:
    """d31-01: at x = +0.150 m it is −5.91 m/s²."""
    values = standing_at(STEPS["d31-01"].state, SCENES).shown.values
    a = Oscillator(m=1, k=39.4).motion(x_0=0.15, v_0=0.0, t=np.array([0.0])).a[0]
    assert (values["top_x"], f"−{values['top_a']}") == ("0.150", f"{a:.2f}".replace("-", "−"))
    assert "x = +{top_x} m the acceleration is −{top_a}" in STEPS["d31-01"].explain


@pytest.mark.parametrize("g", [0.0, 1.62, 9.81, 24.8])
def test_the_sum_of_spring_and_gravity_is_lowest_at_equilibrium_at_a_height_that_follows_g(g: float) -> None:
    """d31-08: k (x + d)^2/2 - m g x for every g."""
    k, m, x = 39.4, 1.0, np.linspace(-1, 1, 2001)
    d = m * g / k
    total = k * (x + d) ** 2 / 2 - m * g * x
    assert x[np.argmin(total)] == pytest.approx(0, abs=1e-9)
    assert total.min() == pytest.approx(k * d * d / 2)
    assert total - total.min() == pytest.approx(k * x * x / 2, abs=1e-12)


def test_one_phase_does_for_a_start_from_rest_and_for_some_others() -> None:
    """d34-09: so 'only' would be untrue; the start of the step needs two phases."""
    phases = [free_modes(plain, (1, x2), v).phase for x2, v in ((0, (0, 1)), (0, (0, 0)), (0, (1, -0.4)))]
    assert abs(np.sin(phases[0][0] - phases[0][1])) > 0.1
    assert phases[1] == pytest.approx([math.pi / 2] * 2)
    assert phases[2][0] == pytest.approx(phases[2][1])


def test_half_way_through_a_beat_mass_1_almost_rests() -> None:
    """d34-10, tour-04: mass 2 then swings five times as far as mass 1 did, with almost all of the energy."""
    slow, fast = beats.modes().omega
    swing = np.linspace(-math.pi, math.pi, 401) / (slow + fast) + math.pi / (fast - slow)
    motion = free_motion(beats, x_0=(0.2, 0), v_0=(0, 0), t=swing)
    assert np.abs(motion.x[1]).max() == pytest.approx(5 * 0.2, rel=0.02)
    assert np.abs(motion.x[0]).max() < 0.2 * 0.2
    spring_1 = (beats.k1 * motion.x[0] ** 2 + beats.m1 * motion.v[0] ** 2) / 2
    assert spring_1.max() < 0.03 * (beats.k1 + beats.k2) * 0.2**2 / 2


@pytest.mark.parametrize("omega", [0.6, 0.61, 0.62, 0.63, 0.64])
def test_near_resonance_the_drive_s_part_is_as_large_as_the_mode_s(omega: float) -> None:
    """d34-12: from rest the free motion is the one that takes x_p's start away."""
    Xp = particular_solution(equal, F_0=1.0, omega=omega)
    slow, fast = free_modes(equal, (0, 0), (-omega * Xp[0], -omega * Xp[1])).amplitude[:, 0]
    assert abs(slow) == pytest.approx(abs(Xp[0]), rel=0.12)
    assert abs(slow) > 8 * abs(fast)
    step = STEPS["d34-12"]
    assert isinstance(step, ChoiceStep) and step.options[3].where.endswith("omega=0.62")


def test_no_chain_runs_away() -> None:
    """d34-05: with both stiffnesses above 0 both omega squared are above 0; a Delta below 0 would make them complex."""
    rng = np.random.default_rng(5)
    for m1, m2, k1, k2 in 10 ** rng.uniform(-6, 6, (200, 4)):
        omega = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2).modes().omega
        assert 0 < omega[0] < omega[1]


def test_the_product_of_the_shapes_says_where_a_wrong_answer_would_be_right() -> None:
    """d34-07: mirror images where m1 = 4 m2 and the slow ratio is 2; perpendicular lines for equal masses."""
    for m2 in (0.5, 1.0, 3.0):
        assert np.prod(TwoMassChain(m1=m2, m2=m2, k1=4, k2=2).modes().ratio) == pytest.approx(-1)
        assert np.prod(TwoMassChain(m1=4 * m2, m2=m2, k1=4, k2=2).modes().ratio) == pytest.approx(-4)

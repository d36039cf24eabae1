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
from physics.hanging import HangingMass
from physics.oscillator import Oscillator
from tests.walks.facts import beats, hanging, plain, slowly

STEPS = steps_of(load_walks(()).values())


def test_the_acceleration_is_against_the_displacement() -> None:
    """d31-01: at x = +0.150 m it is −5.90 m/s²."""
    values = standing_at(STEPS["d31-01"].state, SCENES).shown.values
    swing = Oscillator(m=1, k=39.4)
    motion = swing.motion(x_0=0.0, v_0=0.94, t=np.array([0.0, swing.period / 4]))
    assert motion.a[0] == pytest.approx(0, abs=1e-12)
    told = f"{motion.x[1]:.3f}", f"{motion.a[1]:.2f}".replace("-", "−")
    assert (values["top_x"], f"−{values['top_a']}") == told
    assert "x = +{top_x} m the acceleration is −{top_a}" in STEPS["d31-01"].explain


def test_let_go_unstretched_it_turns_twice_the_static_deflection_lower() -> None:
    """d31-08: from the natural length, where gravity has given what the spring holds."""
    swing = HangingMass(m=0.5, k=19.7, g=9.81)
    t = np.linspace(0.0, swing.oscillator.period, 2001)
    x = swing.motion(-swing.delta_st, 0.0, t).x
    assert x.max() - x[0] == pytest.approx(2 * swing.delta_st, rel=1e-6)
    assert swing.m * swing.g * 2 * swing.delta_st == pytest.approx(swing.k * (2 * swing.delta_st) ** 2 / 2)


def test_on_the_way_down_gravity_pays_for_motion_and_spring() -> None:
    """d31-10: from 0.2 m above equilibrium down to it."""
    v = 0.2 * hanging.oscillator.omega_n
    top, middle = hanging.energies([-0.2], [0.0]), hanging.energies([0.0], [v])
    gained = {name: float(getattr(middle, name)[0] - getattr(top, name)[0]) for name in ("T", "spring", "gravity")}
    assert gained == pytest.approx({"T": 0.788, "spring": 1.174, "gravity": -1.962}, abs=5e-4)
    assert sum(gained.values()) == pytest.approx(0, abs=1e-12)


def test_there_are_two_frequencies_whatever_the_chain() -> None:
    """d34-04: one crossing left of the pole of equation 2, one right of it."""
    rng = np.random.default_rng(4)
    for m1, m2, k1, k2 in 10 ** rng.uniform(-3, 3, (200, 4)):
        slow, fast = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2).modes().omega ** 2
        assert 0 < slow < k2 / m2 < fast


def test_one_phase_does_from_rest_and_through_equilibrium() -> None:
    """d34-09: the start of the answer alone needs two."""
    starts = (((1, 0), (0, 1)), ((1, 0.5), (0, 0)), ((0, 0), (1, 3)), ((1, 0), (0, 0)))
    apart = [abs(math.sin(np.subtract(*free_modes(plain, *start).phase))) for start in starts]
    assert apart[0] > 0.1
    assert apart[1:] == pytest.approx([0, 0, 0], abs=1e-12)


def test_pushed_slowly_both_masses_go_as_far_as_spring_1_gives_way() -> None:
    """d34-13: at the step's frequency to its three digits."""
    step = standing_at(STEPS["d34-13"].state, SCENES)
    assert step.shown.values["Xp2"] == "+1.00"
    assert particular_solution(slowly, F_0=1.0, omega=0.0) == pytest.approx([1.0, 1.0])
    assert all(abs(particular_solution(slowly, F_0=1.0, omega=omega)[1]) < 0.01 for omega in (20.0, 50.0))


def test_half_way_through_a_beat_mass_1_almost_rests() -> None:
    """d34-10, tour-04: mass 2 then swings five times as far as mass 1 did, with almost all of the energy."""
    slow, fast = beats.modes().omega
    swing = np.linspace(-math.pi, math.pi, 401) / (slow + fast) + math.pi / (fast - slow)
    motion = free_motion(beats, x_0=(0.2, 0), v_0=(0, 0), t=swing)
    assert np.abs(motion.x[1]).max() == pytest.approx(5 * 0.2, rel=0.02)
    assert np.abs(motion.x[0]).max() < 0.2 * 0.2
    spring_1 = (beats.k1 * motion.x[0] ** 2 + beats.m1 * motion.v[0] ** 2) / 2
    assert spring_1.max() < 0.03 * (beats.k1 + beats.k2) * 0.2**2 / 2


@pytest.mark.parametrize("omega", [0.75, 0.76, 0.77, 0.78])
def test_near_resonance_the_drive_s_part_is_as_large_as_the_mode_s(omega: float) -> None:
    """d34-12: from rest the free motion is the one that takes x_p's start away."""
    chain = TwoMassChain(m1=1, m2=1, k1=2, k2=1)
    Xp = particular_solution(chain, F_0=1.0, omega=omega)
    slow, fast = free_modes(chain, (0, 0), (-omega * Xp[0], -omega * Xp[1])).amplitude[:, 0]
    assert abs(slow) == pytest.approx(abs(Xp[0]), rel=0.12)
    assert abs(slow) > 8 * abs(fast)
    step = STEPS["d34-12"]
    assert isinstance(step, ChoiceStep) and step.options[3].where.endswith("k1=2&omega=0.77")


def test_no_chain_runs_away() -> None:
    """d34-05: with both stiffnesses above 0 both omega squared are above 0; a Delta below 0 would make them complex."""
    rng = np.random.default_rng(5)
    for m1, m2, k1, k2 in 10 ** rng.uniform(-6, 6, (200, 4)):
        omega = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2).modes().omega
        assert 0 < omega[0] < omega[1]


def test_the_product_of_the_shapes_says_where_a_wrong_answer_would_be_right() -> None:
    """d34-07: mirror images where m1 = 2.25 m2 and the slow ratio is 1.5; perpendicular lines for equal masses."""
    for m2 in (0.5, 1.0, 3.0):
        assert np.prod(TwoMassChain(m1=m2, m2=m2, k1=4, k2=2).modes().ratio) == pytest.approx(-1)
        assert np.prod(TwoMassChain(m1=2.25 * m2, m2=m2, k1=4, k2=2).modes().ratio) == pytest.approx(-2.25)

"""The claims in the sentences of the walks beyond their numbers, worked out from the physics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from components.scene import Scene
from components.scene.traces import Floats
from components.scenes import SCENES
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.sketch import SketchStep
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped import DampedOscillator
from physics.forced import particular_solution
from physics.free_decay import FreeDecay
from physics.oscillator import Oscillator
from tests.walks.facts import eight, home, plain, seventeen, slowly

STEPS = steps_of(load_walks(()).values())


def test_the_acceleration_is_against_the_displacement() -> None:
    """d31-01: at x = +0.150 m it is −5.90 m/s²."""
    values = page_state_at(STEPS["d31-01"].state, SCENES).shown.values
    swing = Oscillator(m=1, k=39.4)
    motion = swing.motion(x_0=0.0, v_0=0.94, t=np.array([0.0, swing.period / 4]))
    assert motion.a[0] == pytest.approx(0, abs=1e-12)
    told = f"{motion.x[1]:.3f}", f"{motion.a[1]:.2f}".replace("-", "−")
    assert (values["top_x"], f"−{values['top_a']}") == told
    assert "x = +{top_x} m the acceleration is −{top_a}" in STEPS["d31-01"].explain


def test_there_are_two_frequencies_whatever_the_chain() -> None:
    """d34-04: one crossing left of the pole of equation 2, one right of it."""
    assert "stiffnesses above 0" in STEPS["d34-04"].question
    rng = np.random.default_rng(4)
    for m1, m2, k1, k2 in 10 ** rng.uniform(-6, 6, (200, 4)):
        slow, fast = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2).modes().omega ** 2
        assert 0 < slow < k2 / m2 < fast


def test_one_phase_is_enough_from_rest_and_through_equilibrium() -> None:
    """d34-09: only the answer excites two modes; the other initial conditions excite the mode named in their reply."""
    starts = (((1, 0), (0, 1)), ((1, 0.5), (0, 0)), ((0, 0), (1, 1.5)), ((1, 0), (0, 0)))
    slow, fast = np.transpose([free_modes(plain, *start).phase for start in starts])
    assert abs(math.sin(slow[0] - fast[0])) > 0.1
    assert slow[1:] == pytest.approx([math.pi / 2, 0, math.pi / 2]) and fast[1:] == pytest.approx(slow[1:])
    for i, phase in ((1, "1.57 rad"), (2, "0, is enough")):
        values = page_state_at(where("d34-09", i), SCENES).shown.values
        assert {values["phi_minus"], values["phi_plus"]} == {"+ 1.57" if i == 1 else "+ 0.00"}
        assert phase in replies("d34-09")[i].reply


def test_pushed_slowly_both_masses_go_as_far_as_spring_1_gives_way() -> None:
    """d34-13: at the step's frequency to its three digits."""
    step = page_state_at(STEPS["d34-13"].state, SCENES)
    assert step.shown.values["Xp2"] == "+1.00"
    assert particular_solution(slowly, F_0=1.0, omega=0.0) == pytest.approx([1.0, 1.0])
    assert all(abs(particular_solution(slowly, F_0=1.0, omega=omega)[1]) < 0.01 for omega in (20.0, 50.0))


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


def such(step: str, i: int) -> Scene:
    """The scene that the reply i of a step leads to."""
    return page_state_at(where(step, i), SCENES).scene


def where(step: str, i: int) -> str:
    return replies(step)[i].where


def replies(step: str) -> Sequence[Any]:
    one = STEPS[step]
    return one.options if isinstance(one, ChoiceStep) else one.wrong if isinstance(one, SketchStep) else ()


def drawn(scene: Scene, name: str) -> Floats:
    """A curve of its picture, over time."""
    return scene.shown.sources["time"][name]


def test_where_damping_is_strong_a_climb_ends_level() -> None:
    """d31-15: from below up to equilibrium, and there it stays."""
    x = drawn(such("d31-15", 1), "x")
    assert x[0] < 0 and np.all(np.diff(x) > 0) and -0.01 * abs(x[0]) < x[-1] <= 0


def test_more_damping_is_sooner_up_to_critical_and_later_beyond() -> None:
    """d32-33-04: 7.13 s, 1.06 s, 4.30 s; and with 0.83, 0.674 s and 1 % past."""
    there = page_state_at(where("d32-33-04", 1), SCENES)
    assert there.held and (there.scene.values["zeta"], there.held.values["zeta"]) == (1.0, 0.1)
    assert home(0.1) > home(1.0) < home(3.0) and home(0.83) < home(1.0)
    light = DampedOscillator(m=1, c=2 * 0.83 * math.sqrt(39.48), k=39.48)
    past = light.motion(0.1, 0.0, [FreeDecay(oscillator=light, x_0=0.1, v_0=0.0).first_turn or 0.0]).x[0]
    assert -past / 0.1 == pytest.approx(0.01, rel=0.1)


def test_a_slow_throw_does_not_cross_and_a_light_dashpot_lets_it_cross_again() -> None:
    """d32-33-05."""
    slow, light = (drawn(such("d32-33-05", i), "x") for i in (0, 1))
    assert np.all(slow > 0) and slow[-1] < 0.35 * slow[0]
    assert np.sum(np.signbit(light[1:]) != np.signbit(light[:-1])) > 1


def test_the_spring_holds_the_push_far_below_and_inertia_far_above() -> None:
    """d32-33-06 and d32-33-07: where the answers that are wrong at r = 1 and r = 2 are right."""
    assert [such("d32-33-06", i).shown.forms["holds"] for i in (1, 2)] == ["spring", "inertia"]
    lags = [next(one.value for one in such("d32-33-07", i).readouts() if one.name == "phi") for i in (1, 2, 3)]
    assert lags[0] < 0.1 and lags[1] == pytest.approx(math.pi / 2, abs=1e-3)
    assert float(such("d32-33-07", 3).shown.values["M"]) < 0.003


def test_with_a_dashpot_a_resonant_swing_is_even_after_a_while() -> None:
    """d32-33-10: the swings at the end differ by less than a twentieth, and the early ones are smaller."""
    for i in (0, 2):
        scene = such("d32-33-10", i)
        t, x = scene.shown.sources["time"]["t"], abs(drawn(scene, "x"))
        early, *late = (x[(t >= n) & (t <= n + 1)].max() for n in (0, 4, 5))
        assert early < 0.8 * late[0] and late[1] == pytest.approx(late[0], rel=0.05)
        assert late[1] < 1.001 * scene.values["F_0"] / (scene.values["c"] * scene.values["omega"])


@pytest.mark.parametrize("i", [0, 2])
def test_with_friction_the_chain_s_resonant_swing_is_even_after_a_while(i: int) -> None:
    """d34-15."""
    scene = such("d34-15", i)
    t, x = scene.shown.sources["time"]["t"], abs(drawn(scene, "x1"))
    early, *late = (x[(t >= start) & (t <= start + 7)].max() for start in (0, 85, 92))
    assert scene.values["omega"] == 1.0 and early < 0.5 * late[0] and late[1] == pytest.approx(late[0], rel=0.02)


def test_with_friction_a_free_motion_dies_and_the_drive_s_is_left() -> None:
    """d34-02 and d34-12."""
    free, driven = such("d34-02", 2), such("d34-12", 1)
    for name in ("x1", "x2"):
        x = drawn(free, name)
        assert abs(x[-len(x) // 8 :]).max() < 0.2 * abs(x).max()
        assert abs(drawn(driven, f"{name}_c")[-50:]).max() < 0.05 * abs(drawn(driven, f"{name}_p")).max()


def test_with_friction_two_humps_have_a_saddle_above_zero() -> None:
    """d34-14."""
    response = such("d34-14", 1).shown.sources["branch0"]
    X, inside = response["Xp1"], slice(1, -1)
    turns = np.sign(np.diff(X))
    assert np.sum((turns[1:] < 0) & (turns[:-1] > 0)) == 2 and X[inside].min() > 0.02


def test_a_damper_brings_odd_powers() -> None:
    """d34-06."""
    shown = such("d34-06", 2).shown
    assert shown.forms["braked"] == "shown" and shown.values["p3"] != "+ 0.00" != shown.values["p1"]


def test_friction_passes_energy_from_the_fast_mode_to_the_slow_one() -> None:
    """d34-11: it starts in the fast mode, and most of the remaining energy is in the slow mode."""
    scene = such("d34-11", 2)
    chain = TwoMassChain(**{name: scene.values[name] for name in ("m1", "m2", "k1", "k2")})
    motion = scene._case().modes.motion(scene.shown.sources["time"]["t"])
    energies = [free_modes(chain, x, v).energy for x, v in zip(motion.x.T[::20], motion.v.T[::20], strict=True)]
    slow, fast = np.array(energies).T
    assert slow[0] < 1e-12 * fast[0] and slow.max() > 1e-3 * fast[0] and slow[-1] > 10 * fast[-1]


def silent(step: str, number: int) -> list[float]:
    """The silent modes of the case that a reply of a step shows."""
    return page_state_at(where(step, number), SCENES).shown.columns["silent"]["silent_j"].tolist()


def test_a_pluck_starts_no_mode_with_a_node_at_it() -> None:
    """waves-01: none at mass 2 or mass 4 of eight, the even ones at the middle of seven."""
    for p, modes in ((2, []), (3, [3, 6]), (4, [])):
        energy = eight.drawn_modes(eight.pluck(p, 0.4), np.zeros(8)).energy
        assert [j for j in range(1, 9) if energy[j - 1] < 1e-20] == modes
    middle = UniformChain(N=7, m=1.0, k=1.0)
    energy = middle.drawn_modes(middle.pluck(4, 1.0), np.zeros(7)).energy
    assert [j for j in range(1, 8) if energy[j - 1] < 1e-20] == [2, 4, 6]
    assert {2.0, 4.0, 6.0} <= set(silent("waves-01", 2))


def test_a_free_end_swings_almost_twice_as_far_as_the_pulse() -> None:
    """waves-03: and sends a pulse back that is upright; waves-02: a wall sends back one that is upside down."""
    for step, sign in (("waves-02", -1), ("waves-03", 1)):
        case = page_state_at(STEPS[step].state, SCENES).scene.of()
        chain = UniformChain(N=50, m=case.m, k=case.k, ends=case.ends)
        x = chain.motion(*case.started, np.linspace(0.0, case.lasting / 2, 400)).x
        if sign > 0:
            assert 1.7 * 0.4 < x[-1].max() < 2 * 0.4
        back = x[:, 300]
        assert sign * back[np.abs(back).argmax()] > 0.25


def test_more_masses_on_one_string_leave_its_slow_modes() -> None:
    """waves-05, with where its wrong answers would be right: the same m and k, or eight masses with the new ones."""
    assert seventeen.omega[[0, -1]] / eight.omega[[0, -1]] == pytest.approx([1.0, 2.0], rel=0.03)
    longer = UniformChain(N=17, m=0.5, k=2.0)
    assert longer.omega[[0, -1]] / eight.omega[[0, -1]] == pytest.approx([0.5, 1.0], rel=0.02)
    stiffer = UniformChain(N=8, m=0.25, k=4.0)
    assert stiffer.omega == pytest.approx(2 * eight.omega)


def test_ten_half_waves_are_eight_turned_over_and_nine_are_rest() -> None:
    """waves-06: at eight masses."""
    p = np.arange(1, 9)
    assert np.sin(10 * p * np.pi / 9) == pytest.approx(-np.sin(8 * p * np.pi / 9), abs=1e-14)
    assert np.sin(9 * p * np.pi / 9) == pytest.approx(np.zeros(8), abs=1e-14)
    energy = eight.drawn_modes(np.sin(10 * p * np.pi / 9), np.zeros(8)).energy
    assert energy[:7].max() < 1e-24 < energy[7]

"""The claims in the sentences of the walks beyond their numbers: each is true of the picture that shows it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from components.scene import Scene
from components.scene.traces import Floats
from components.scenes import SCENES
from components.state.page_state import PageState
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.sketch import SketchStep
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped_chain import DampedChain
from physics.oscillator import Oscillator
from tests.walks.facts import home

STEPS = steps_of(load_walks(()).values())


def drawn(scene: Scene, name: str = "x") -> Floats:
    """A curve of its picture, over time."""
    return scene.shown.sources["time"][name]


def climbs_and_stays(scene: Scene) -> bool:
    x = drawn(scene)
    return bool(x[0] < 0 and np.all(np.diff(x) > 0) and -0.01 * abs(x[0]) < x[-1] <= 0)


def never_crosses(scene: Scene) -> bool:
    x = drawn(scene)
    return bool(np.all(x > 0) and x[-1] < 0.35 * x[0])


def crosses_again(scene: Scene) -> bool:
    x = drawn(scene)
    return int(np.sum(np.signbit(x[1:]) != np.signbit(x[:-1]))) > 1


def lag(scene: Scene) -> float:
    return next(one.value for one in scene.readouts() if one.name == "phi")


def sooner_than_before(page: PageState) -> bool:
    assert page.held
    now, before = page.scene.values["zeta"], page.held.values["zeta"]
    return bool(now == 1.0 and home(before) > home(now) < home(3.0) and home(0.83) < home(now))


def becomes_even(scene: Scene, name: str, starts: tuple[int, int, int], length: int, early: float) -> bool:
    """The last two swings differ by less than a twentieth, and the first one is smaller."""
    t, x = drawn(scene, "t"), abs(drawn(scene, name))
    first, one, last = (x[(t >= start) & (t <= start + length)].max() for start in starts)
    return bool(first < early * one and abs(last - one) < 0.05 * one)


def dies(scene: Scene) -> bool:
    motions = [abs(drawn(scene, name)) for name in ("x1", "x2")]
    return all(x[-len(x) // 8 :].max() < 0.2 * x.max() for x in motions)


def leaves_the_drives_part(scene: Scene) -> bool:
    pairs = [(drawn(scene, f"{name}_c"), drawn(scene, f"{name}_p")) for name in ("x1", "x2")]
    return all(abs(free[-50:]).max() < 0.05 * abs(driven).max() for free, driven in pairs)


def has_two_humps(scene: Scene) -> bool:
    X = scene.shown.sources["branch0"]["Xp1"]
    turns = np.sign(np.diff(X))
    return bool(np.sum((turns[1:] < 0) & (turns[:-1] > 0)) == 2 and X[1:-1].min() > 0.02)


def has_odd_powers(scene: Scene) -> bool:
    shown = scene.shown
    return shown.forms["braked"] == "shown" and shown.values["p3"] != "+ 0.00" != shown.values["p1"]


def chain_of(scene: Scene) -> TwoMassChain:
    return TwoMassChain(**{name: scene.values[name] for name in ("m1", "m2", "k1", "k2")})


def keeps_no_guessed_shape(scene: Scene) -> bool:
    values = scene.values
    modes = DampedChain.of(chain_of(scene), values["c1"], values["c2"]).free_motions.modes
    return all(abs(one.shape[1] / one.shape[0] - values["x2_0"] / values["x1_0"]) > 0.1 for one in modes)


def ends_in_the_slow_mode(scene: Scene) -> bool:
    """It starts in the fast mode, and most of the remaining energy is in the slow one."""
    has, chain = scene.values, chain_of(scene)
    x = np.array([drawn(scene, name) for name in ("x1", "x2")])
    v = np.gradient(x, drawn(scene, "t"), axis=1)
    slow, fast = np.array([free_modes(chain, *one).energy for one in zip(x.T, v.T, strict=True)]).T
    start = free_modes(chain, (has["x1_0"], has["x2_0"]), (has["v1_0"], has["v2_0"])).energy
    return bool(start[0] < 1e-12 * start[1] and slow.max() > 1e-3 * start[1] and slow[-2] > 10 * fast[-2])


def swings_with_phase(text: str) -> Callable[[Scene], bool]:
    return lambda scene: {scene.shown.values["phi_minus"], scene.shown.values["phi_plus"]} == {text}


REPLIES: list[tuple[str, int, str, Callable[[Scene], Any]]] = [
    ("d31-15", 1, "", climbs_and_stays),
    ("d32-33-05", 0, "", never_crosses),
    ("d32-33-05", 1, "", crosses_again),
    ("d32-33-06", 1, "", lambda scene: scene.shown.forms["holds"] == "spring"),
    ("d32-33-06", 2, "", lambda scene: scene.shown.forms["holds"] == "inertia"),
    ("d32-33-07", 1, "", lambda scene: lag(scene) < 0.1),
    ("d32-33-07", 2, "", lambda scene: abs(lag(scene) - math.pi / 2) < 1e-3),
    ("d32-33-07", 3, "", lambda scene: float(scene.shown.values["M"]) < 0.003),
    *(("d32-33-10", i, "", lambda scene: becomes_even(scene, "x", (0, 4, 5), 1, 0.8)) for i in (0, 2)),
    *(("d34-15", i, "", lambda scene: becomes_even(scene, "x1", (0, 85, 92), 7, 0.5)) for i in (0, 2)),
    ("d34-02", 2, "", dies),
    ("d34-02", 2, "does not keep this shape either", keeps_no_guessed_shape),
    ("d34-06", 2, "", has_odd_powers),
    ("d34-09", 1, "1.57 rad", swings_with_phase("+ 1.57")),
    ("d34-09", 2, "0, is enough", swings_with_phase("+ 0.00")),
    ("d34-11", 2, "", ends_in_the_slow_mode),
    ("d34-12", 1, "", leaves_the_drives_part),
    ("d34-14", 1, "", has_two_humps),
    ("waves-01", 2, "", lambda scene: {2.0, 4.0, 6.0} <= {*scene.shown.columns["silent"]["silent_j"].tolist()}),
]
"""A step, one of its replies, words of it, and what is true of the picture to which it leads."""


def reply_of(step: str, i: int) -> Any:
    one = STEPS[step]
    assert isinstance(one, (ChoiceStep, SketchStep))
    return (one.options if isinstance(one, ChoiceStep) else one.wrong)[i]


@pytest.mark.parametrize(("step", "i", "words", "is_true"), REPLIES)
def test_a_reply_leads_to_a_picture_of_which_it_is_true(
    step: str, i: int, words: str, is_true: Callable[[Scene], Any]
) -> None:
    reply = reply_of(step, i)
    assert words in reply.reply and is_true(page_state_at(reply.where, SCENES).scene)


def test_more_damping_is_sooner_up_to_critical_and_later_beyond() -> None:
    assert sooner_than_before(page_state_at(reply_of("d32-33-04", 1).where, SCENES))


def test_the_acceleration_is_against_the_displacement() -> None:
    values = page_state_at(STEPS["d31-01"].state, SCENES).shown.values
    swing = Oscillator(m=1, k=39.4)
    motion = swing.motion(x_0=0.0, v_0=0.94, t=np.array([swing.period / 4]))
    told = f"{motion.x[0]:.3f}", f"{motion.a[0]:.2f}".replace("-", "−")
    assert (values["top_x"], f"−{values['top_a']}") == told
    assert "x = +{top_x} m the acceleration is −{top_a}" in STEPS["d31-01"].explain


def test_the_spring_pulls_up_all_the_way() -> None:
    step = STEPS["d31-10"]
    assert isinstance(step, ChoiceStep)
    assert any("the spring pulls up all the way" in one.reply for one in step.options)
    has = page_state_at(step.state, SCENES).scene.values
    assert has["x_0"] < 0 < has["m"] * has["g"] / has["k"] + has["x_0"], "stretched from the start on"


def test_pushed_slowly_both_masses_go_as_far_as_spring_1_gives_way() -> None:
    assert page_state_at(STEPS["d34-13"].state, SCENES).shown.values["Xp2"] == "+1.00"


@pytest.mark.parametrize(("step", "sign"), [("waves-02", -1), ("waves-03", 1)])
def test_a_free_end_sends_a_pulse_back_upright_and_a_wall_upside_down(step: str, sign: int) -> None:
    """The free end swings almost twice as far as the pulse."""
    case = page_state_at(STEPS[step].state, SCENES).scene.of()
    chain = UniformChain(N=50, m=case.m, k=case.k, ends=case.ends)
    x = chain.motion(*case.started, np.linspace(0.0, case.lasting / 2, 400)).x
    assert sign < 0 or 1.7 * 0.4 < x[-1].max() < 2 * 0.4
    back = x[:, 300]
    assert sign * back[np.abs(back).argmax()] > 0.25


@pytest.mark.parametrize("v_0", [5.0, 60.0, 300.0])
def test_without_drag_only_the_speed_counts(v_0: float) -> None:
    assert STEPS["tour-02"].explain.startswith("Without drag only speed counts")
    taus = [SCENES["phugoid"](v_0=v_0, m=m, excess=0.01).shown.values["tau"] for m in (1.0, 1e5)]
    assert taus[0] == taus[1]
    assert float(taus[0]) == pytest.approx(math.sqrt(2) * math.pi * v_0 / 9.80665, rel=6e-3)

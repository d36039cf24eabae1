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
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.sketch import SketchStep
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
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


def ends_in_the_slow_mode(scene: Scene) -> bool:
    """It starts in the fast mode, and most of the remaining energy is in the slow one."""
    has, chain = scene.values, chain_of(scene)
    x = np.array([drawn(scene, name) for name in ("x1", "x2")])
    v = np.gradient(x, drawn(scene, "t"), axis=1)
    slow, fast = np.array([free_modes(chain, *one).energy for one in zip(x.T, v.T, strict=True)]).T
    start = free_modes(chain, (has["x1_0"], has["x2_0"]), (has["v1_0"], has["v2_0"])).energy
    return bool(start[0] < 1e-12 * start[1] and slow.max() > 1e-3 * start[1] and slow[-2] > 10 * fast[-2])


def pulse_comes_back(scene: Scene, sign: int) -> bool:
    """Upright from a free end, which swings almost twice as far as the pulse, and upside down from a wall."""
    case = scene.of()
    chain = UniformChain(N=50, m=case.m, k=case.k, ends=case.ends)
    x = chain.motion(*case.started, np.linspace(0.0, case.lasting / 2, 400)).x
    back = x[:, 300]
    return bool((sign < 0 or 1.7 * 0.4 < x[-1].max() < 2 * 0.4) and sign * back[np.abs(back).argmax()] > 0.25)


CLAIMS: list[tuple[str, int | None, str, Callable[[Scene], Any]]] = [
    ("d34-13", None, "", lambda scene: scene.shown.values["Xp2"] == "+1.00"),  # as far as spring 1 gives way
    ("waves-02", None, "", lambda scene: pulse_comes_back(scene, -1)),
    ("waves-03", None, "", lambda scene: pulse_comes_back(scene, 1)),
    ("d31-15", 1, "", climbs_and_stays),
    ("d32-33-05", 0, "", never_crosses),
    ("d32-33-05", 1, "", crosses_again),
    ("d32-33-04", 1, "", lambda scene: home(0.83) < home(scene.values["zeta"]) < home(3.0)),
    ("d32-33-06", 1, "", lambda scene: scene.shown.forms["holds"] == "spring"),
    ("d32-33-06", 2, "", lambda scene: scene.shown.forms["holds"] == "inertia"),
    ("d32-33-07", 1, "", lambda scene: lag(scene) < 0.1),
    ("d32-33-07", 2, "", lambda scene: abs(lag(scene) - math.pi / 2) < 1e-3),
    ("d32-33-07", 3, "", lambda scene: float(scene.shown.values["M"]) < 0.003),
    *(("d32-33-10", i, "", lambda scene: becomes_even(scene, "x", (0, 4, 5), 1, 0.8)) for i in (0, 2)),
    *(("d34-15", i, "", lambda scene: becomes_even(scene, "x1", (0, 85, 92), 7, 0.5)) for i in (0, 2)),
    ("d34-02", 2, "", dies),
    ("d34-06", 2, "", has_odd_powers),
    ("d34-11", 2, "", ends_in_the_slow_mode),
    ("d34-12", 1, "", leaves_the_drives_part),
    ("d34-14", 1, "", has_two_humps),
    ("waves-01", 2, "", lambda scene: {2.0, 4.0, 6.0} <= {*scene.shown.columns["silent"]["silent_j"].tolist()}),
]
"""A step, one of its replies or none, words of them, and what is true of the picture of the reply or the step."""


@pytest.mark.parametrize(("step", "i", "words", "is_true"), CLAIMS)
def test_what_a_step_says_is_true_of_its_picture(
    step: str, i: int | None, words: str, is_true: Callable[[Scene], Any]
) -> None:
    one = STEPS[step]
    replies = one.options if isinstance(one, ChoiceStep) else one.wrong if isinstance(one, SketchStep) else ()
    texts = [one.explain, *(reply.reply for reply in replies)] if i is None else [replies[i].reply]
    link = one.state if i is None else replies[i].where
    assert any(words in text for text in texts) and is_true(page_state_at(link, SCENES).scene)

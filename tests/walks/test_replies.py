"""Replies of the lecture's walks that claim more than their own numbers, against the physics."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.scenes import SCENES
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain

STEPS = steps_of(load_walks(()).values())


def reply_with(step: str, words: str) -> str:
    """Return the one reply of a step that contains a text."""
    found = STEPS[step]
    assert isinstance(found, ChoiceStep)
    (reply,) = (one.reply for one in found.options if words in one.reply)
    return reply


def test_the_spring_pulls_up_all_the_way() -> None:
    assert "the spring pulls up all the way" in reply_with("d31-10", "spring pulls")
    scene = page_state_at(STEPS["d31-10"].state, SCENES).scene
    stretch = scene.values["m"] * scene.values["g"] / scene.values["k"] + scene.values["x_0"]
    assert scene.values["x_0"] < 0 < stretch, "stretched from the start on, and more on the way down"


def test_friction_does_not_keep_the_guessed_shape_either() -> None:
    reply_with("d34-02", "does not keep this shape either")
    (where,) = (one.where for one in STEPS["d34-02"].options if one.where)  # type: ignore[union-attr]
    values = page_state_at(where, SCENES).scene.values
    chain = TwoMassChain(**{name: values[name] for name in ("m1", "m2", "k1", "k2")})
    for one in DampedChain.of(chain, values["c1"], values["c2"]).free_motions.modes:
        X1, X2 = one.shape
        assert abs(X2 / X1 - values["x2_0"] / values["x1_0"]) > 0.1


@given(st.floats(5.0, 300.0))
def test_without_drag_only_the_speed_counts(v_0: float) -> None:
    assert STEPS["tour-02"].explain.startswith("Without drag only speed counts")
    assert "most aircraft" in STEPS["tour-02"].question
    taus = [SCENES["phugoid"](v_0=v_0, m=m, excess=0.01).shown.values["tau"] for m in (1.0, 1e5)]
    assert taus[0] == taus[1]
    assert float(taus[0]) == pytest.approx(math.sqrt(2) * math.pi * v_0 / 9.80665, rel=6e-3)

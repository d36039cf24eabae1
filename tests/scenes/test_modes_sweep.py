"""Scene modes, the views Sweep and Hunt, through its callbacks."""

from __future__ import annotations

import numpy as np
import pytest

from components.scenes.modes import ModesScene


def test_the_held_frequencies_cross_where_the_lecture_says() -> None:
    """m1 k2 = m2 (k1 + k2): 2 k2 = 4 + k2."""
    shown = ModesScene(view="sweep").shown
    assert 10 ** shown.scalars["cross"] == pytest.approx(4.0, rel=1e-3)


# Hunt


def test_the_answer_is_nowhere_before_it_is_asked_for() -> None:
    scene = ModesScene(view="hunt")
    shown = scene.shown
    assert "answer" not in scene.sources
    assert shown.forms["answer"] == ""
    assert not {name for name in shown.values if name.startswith(("answer", "omega", "r_"))}
    scene.answer = "shown"
    assert (scene.shown.values["answer_slow"], scene.shown.values["answer_fast"]) == ("+2.00", "−1.00")
    line = scene.sources["answer"].data
    np.testing.assert_allclose(line["slow2"] / line["slow1"], 2.0)
    np.testing.assert_allclose(line["fast2"] / line["fast1"], -1.0)

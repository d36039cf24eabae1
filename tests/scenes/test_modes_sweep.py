"""Scene modes, the views Sweep and Hunt, through its callbacks."""

from __future__ import annotations

import numpy as np
import pytest

from components.scenes.modes import ModesScene


@pytest.mark.parametrize("swept", ["m1", "m2", "k1", "k2"])
def test_a_sweep_passes_through_the_chain(swept: str) -> None:
    scene = ModesScene(view="sweep", swept=swept)
    run = scene.sources["omega_sweep"].data
    assert np.log10(run["p"][-1] / run["p"][0]) == pytest.approx(6)
    now = getattr(scene, swept)
    for mode, omega in (("slow", 1.0), ("fast", 2.0)):
        between = np.exp(np.interp(np.log(now), np.log(run["p"]), np.log(run[f"omega_{mode}"])))
        assert between == pytest.approx(omega, rel=1e-3)
    ratios = scene.sources["ratio_sweep"].data
    mass_ratio = (ratios["p"] if swept == "m1" else 2.0) / (ratios["p"] if swept == "m2" else 1.0)
    np.testing.assert_allclose(ratios["ratio_slow"] * ratios["ratio_fast"], mass_ratio, rtol=1e-12)


def test_asymptotes_are_met_at_the_ends() -> None:
    scene = ModesScene(view="sweep")
    run, low, high = (scene.sources[f"omega_{part}"].data for part in ("sweep", "low", "high"))
    for mode in ("slow", "fast"):
        assert low[f"omega_{mode}"][0] == pytest.approx(run[f"omega_{mode}"][0], rel=1e-3)
        assert high[f"omega_{mode}"][-1] == pytest.approx(run[f"omega_{mode}"][-1], rel=2e-3)
    assert (scene.shown.forms["low"], scene.shown.forms["high"]) == ("apart", "rigid")


def test_the_held_frequencies_cross_where_the_lecture_says() -> None:
    """m1 k2 = m2 (k1 + k2): 2 k2 = 4 + k2."""
    shown = ModesScene(view="sweep").shown
    assert 10 ** shown.scalars["cross"] == pytest.approx(4.0, rel=1e-3)


def test_without_coupling_there_are_no_ratios_to_draw() -> None:
    scene = ModesScene(view="sweep", k2=0.0, swept="m1")
    assert scene.sources["ratio_sweep"].data == {}
    assert scene.shown.forms["low"] == "loose"


# Hunt


@pytest.mark.parametrize(
    ("start", "verdict"),
    [
        ((1, 2), "slow"),
        ((-0.5, -1), "slow"),
        ((1, 1.96), "slow"),
        ((1, -1), "fast"),
        ((1, 0.5), "mixed"),
        ((1, 1.8), "mixed"),
        ((0, 0), "rest"),
    ],
)
def test_a_straight_line_is_marked(start: tuple[float, float], verdict: str) -> None:
    scene = ModesScene(view="hunt", x1_0=start[0], x2_0=start[1])
    assert scene.shown.forms["verdict"] == verdict
    path = scene.sources["path"].data
    if verdict in ("slow", "fast"):
        width, length = np.linalg.svd(np.array([path["x1"], path["x2"]]), compute_uv=False)[::-1]
        assert width < 0.05 * length


def test_shares_are_told() -> None:
    values = ModesScene(view="hunt", x1_0=1.0, x2_0=0.0).shown.values
    assert (values["share_slow"], values["share_fast"]) == ("44.2 %", "55.8 %")


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


def test_every_start_is_a_line_where_a_spring_is_missing() -> None:
    for missing in ("k1", "k2"):
        assert ModesScene(view="hunt", **{missing: 0.0}).shown.forms["verdict"] == "drift"

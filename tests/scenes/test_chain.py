"""The chain: initial conditions, kept values, refusals, the browser's motion, and the claims of its examples."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pandas as pd
import pytest

from components.language.signals import Modal
from components.scenes import SCENES
from components.scenes.chain import Chain
from components.session.exports import link_file
from components.state.covers import without
from tests.page.scripts import call

STARTS = ("pulse", "pluck", "mass", "mode")


def value(scene: Any, name: str) -> float:
    return float(scene.numbers[name].value)


def displacements(scene: Chain) -> np.ndarray:
    """The displacements of all masses at the times of a file (n, N)."""
    columns = scene.shown.sources["time"]
    return np.array([columns[f"x{p}"] for p in range(1, int(scene.N) + 1)]).T


def test_another_number_of_masses_keeps_the_string_or_the_masses() -> None:
    scene = Chain()
    before = {name: value(scene, name) for name in ("L", "wave_speed")}
    scene.N = 20.0
    assert {name: value(scene, name) for name in before} == pytest.approx(before)
    assert scene.m * scene.N / value(scene, "L") == pytest.approx(20 / 21)
    kept = scene.m, scene.k, scene.a
    scene.param.update(keep="masses", N=40.0)
    assert (scene.m, scene.k, scene.a) == kept


def test_a_mode_or_a_mass_that_there_is_not() -> None:
    scene = Chain(N=8, starts="mode", j=8)
    for name in ("j", "p"):
        with pytest.raises(ValueError, match=r"9.*1 to 8"):
            scene.param.update({name: 9.0})
    scene.N = 5.0
    assert (scene.j, scene.p) == (5.0, 5.0)
    with pytest.raises(ValueError, match="1 to 500 masses"):
        scene.N = 501.0


def test_a_free_chain_drifts_and_says_so() -> None:
    scene = Chain(N=8, ends="free-free", starts="mass", p=1.0, h=0.0, v_0=1.0)
    assert "0.125 m/s" in scene.shown.notes[0] and "mode 1" in scene.shown.notes[0]
    x = displacements(scene)
    t = scene.shown.sources["time"]["t"]
    np.testing.assert_allclose(x.mean(axis=1), t / 8, rtol=1e-12, atol=1e-13)
    assert Chain(ends="free-free").shown.notes == ()


def test_masses_along_the_chain_never_meet_on_the_stage() -> None:
    scene = Chain(N=50, starts="mass", way="along")
    assert "times as large" in scene.shown.to_scale
    x = displacements(scene) * scene.shown.scale
    assert np.diff(x, axis=1).min() > -0.9 * scene.a


@pytest.mark.parametrize("N", [1, 8, 60, 500])
def test_a_file_has_the_displacements_of_all_masses_over_the_whole_window(N: int) -> None:
    content = link_file({"scene": [b"chain"], "N": [str(N).encode()]}, "", SCENES, {}).content
    table = pd.read_csv(io.BytesIO(content), comment="#")
    assert table.columns.tolist() == ["t [s]", *(f"x{p} [m]" for p in range(1, N + 1))]
    scene = Chain(N=N)
    assert table["t [s]"].iloc[-1] == scene.of().end
    np.testing.assert_array_equal(table.to_numpy()[:, 1:], displacements(scene))
    assert len(table) >= 201 and table.size <= 101_000


@pytest.mark.parametrize("starts", STARTS)
@pytest.mark.parametrize(("N", "ends"), [(1, "fixed-fixed"), (1, "fixed-free"), (2, "fixed-free")])
def test_a_small_chain_leads_to_the_scene_with_the_same_motion(N: int, ends: str, starts: str) -> None:
    scene = Chain(N=N, m=2.0, k=3.0, a=1.0, ends=ends, starts=starts, p=1.0, j=1.0, v_0=0.3, centre=1.0, width=0.4)
    (way,) = scene.shown.onward
    other = SCENES[way.scene](**way.given)
    t = np.linspace(0.0, 20.0, 41)
    here, there = (one.shown.traces["time"].exact(t) for one in (scene, other))
    for name in here:
        np.testing.assert_allclose(here[name], there["x" if N == 1 else name], atol=1e-14)


def test_under_a_cover_the_chain_rests_in_its_initial_shape() -> None:
    scene = Chain(ends="free-free")
    left, _ = without(Chain, scene.shown, ("plot:field",))
    signal, axis = left.signals["x"], left.axes["y"]
    assert isinstance(signal, Modal) and not any(signal.omega)
    for t in (0.0, 0.7):
        found = call("static/core/modal.displaced", signal, t)
        np.testing.assert_allclose(found, axis.places(displacements(scene)[0]), atol=1e-12)

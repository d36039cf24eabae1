"""Scene forced with dashpots: the motion is finite at resonance and decays to the particular solution."""

from __future__ import annotations

import numpy as np
import pytest

from components.chain import of_scene, start_of
from components.chain.forces import LENGTH, on_masses
from components.language.state import Frame
from components.scenes.forced import Forced
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.words import UNDRIVEN
from physics.transient import DampedModes
from tests.page.scripts import played

CHAINS: list[dict[str, float]] = [
    {},
    {"m1": 2.0, "k1": 4.0, "k2": 2.0},
    {"k1": 0.0, "x1_0": 0.3},
    {"k2": 0.0, "v2_0": 0.1},
    {"k1": 0.0, "k2": 0.0, "v1_0": 1.0},
    {"m1": 400.0, "m2": 225.0, "k1": 625.0, "k2": 144.0, "x1_0": 0.1},
]
DASHPOTS = [(0.4, 0.2), (0.2, 0.0), (0.0, 216.0), (1e-12, 0.0), (0.0, 1e12), (1e12, 1e-3)]


def modes_of(scene: Forced) -> DampedModes:
    """The motion of a scene with dashpots."""
    x_0, v_0 = start_of(scene)
    drive = {"F_0": scene.F_0, "omega": scene.omega}
    return DampedModes(chain=of_scene(scene), c=scene.c2, c1=scene.c1, x_0=x_0, v_0=v_0, **drive)


@pytest.mark.parametrize("chain", CHAINS)
@pytest.mark.parametrize(("c1", "c2"), DASHPOTS)
def test_the_arrows_of_the_forces_are_newtons_law(chain: dict[str, float], c1: float, c2: float) -> None:
    """The browser's signals against the accelerations; its displacements are those of test_traces."""
    scene = Forced(**chain, c1=c1, c2=c2, view="forces")
    shown, modes = scene.shown, modes_of(scene)
    t = np.linspace(0.05, 0.97, 4) * shown.axes["t"].end
    forces = on_masses(modes.chain, modes.motion(t), scene.F_0, scene.omega, (c1, c2))
    now = [played(shown, shown.axes["t"].place(float(one))) for one in t]
    for i in (1, 2):
        lengths = [float(one[f"F{i}"]) * shown.scalars["newton"] for one in now]
        np.testing.assert_allclose(lengths, forces[i - 1] * shown.scalars["push"] / scene.F_0, atol=2e-3 * LENGTH)


@pytest.mark.parametrize("chain", CHAINS[:2])
@pytest.mark.parametrize(("c1", "c2"), [(0.8, 0.4), (0.6, 0.0), (0.0, 0.9)])
def test_the_swing_at_resonance_is_finite_and_remains(chain: dict[str, float], c1: float, c2: float) -> None:
    omega = float(of_scene(Forced(**chain)).modes().omega[0])
    scene = Forced(**chain, c1=c1, c2=c2, omega=omega, window=120.0)
    data = scene.sources["time"].data
    late = data["t"] > 100
    assert scene.shown.forms["steady"] == "braked"
    for i in (1, 2):
        X = data[f"x{i}_p"].max()
        assert pytest.approx(abs(modes_of(scene).particular[i - 1]), rel=0.01) == X
        assert abs(data[f"x{i}_c"][late]).max() < 0.03 * X
        np.testing.assert_allclose(data[f"x{i}_c"] + data[f"x{i}_p"], data[f"x{i}"], atol=1e-12 * X)
        response = scene.sources["branch0"].data
        assert np.all(np.isfinite(response[f"Xp{i}"])) and response[f"Xp{i}"].max() >= 0.999 * X


@pytest.mark.parametrize(("c1", "c2"), DASHPOTS[:3])
@pytest.mark.parametrize("chain", CHAINS[:4])
def test_the_work_of_the_drive_becomes_energy_and_heat(chain: dict[str, float], c1: float, c2: float) -> None:
    scene = Forced(**chain, c1=c1, c2=c2, view="work")
    data = scene.sources["energy"].data
    size = abs(data["work"]).max() + abs(data["gain"]).max()
    heat = DampedForcedCase(modes_of(scene), float(data["t"][-1])).heat(data["t"])
    np.testing.assert_allclose(data["work"] - data["gain"], heat, atol=1e-7 * size)
    assert np.all(np.diff(heat) >= 0)


def test_pushed_on_its_particular_solution_nothing_dies() -> None:
    scene = Forced(c1=0.3, c2=0.1)
    steady = Forced(c1=0.3, c2=0.1, **scene.action("steady"))
    data = steady.sources["time"].data
    assert max(abs(data["x1_c"]).max(), abs(data["x2_c"]).max()) < 1e-12
    assert not any(Forced(F_0=0.0).action("steady").values())


@pytest.mark.parametrize("curve", ["size", "signed", "log"])
@pytest.mark.parametrize(("c1", "c2"), DASHPOTS)
def test_the_response_is_drawn_of_sizes(curve: str, c1: float, c2: float) -> None:
    scene = Forced(curve=curve, c1=c1, c2=c2)
    response = scene.sources["branch0"].data
    assert np.all(response["Xp1"] >= 0) and np.all(np.diff(response["omega"]) > 0)
    assert ("neither with the push" in " ".join(scene.shown.notes)) == (curve == "signed")


@pytest.mark.parametrize("drive", [{}, {"omega": 0.0, "x1_0": 0.1}, {"F_0": 0.0, "x2_0": 0.1}])
@pytest.mark.parametrize("chain", [CHAINS[0], CHAINS[1], CHAINS[5]])
def test_a_weak_dashpot_leaves_the_words_and_marks_of_none(chain: dict[str, float], drive: dict[str, float]) -> None:
    free, braked = (Forced(**{**chain, **drive}, c1=c1).shown for c1 in (0.0, 1e-6))
    dots = ("drive_at", "Xp1_at", "Xp2_at") if drive.get("omega", 0.8) else ()
    for name in ("mark_minus", "mark_still", "mark_plus", *dots):
        assert braked.scalars[name] == pytest.approx(free.scalars[name], rel=1e-5), name
    for name in ("Xp1", "Xp2"):
        assert braked.values[name] == free.values[name].lstrip("+−")
    steady = free.forms["steady"]
    assert braked.forms["steady"] == (steady if steady in UNDRIVEN else "braked")
    assert set(free.notes) <= set(braked.notes)


@pytest.mark.parametrize("chain", CHAINS)
@pytest.mark.parametrize(("c1", "c2"), [(0.4, 0.0), (0.4, 0.2)])
def test_a_drive_that_does_not_turn_pushes_nothing(chain: dict[str, float], c1: float, c2: float) -> None:
    """F_0 sin(0 t) = 0 is no resonance, though nothing ties the masses to the wall: the swings are those of the curve
    at its left end, as without dashpots."""
    still, pushed = (Forced(**chain, c1=c1, c2=c2, omega=0.0, F_0=F_0) for F_0 in (0.0, 1.0))
    one, other = (scene.shown.traces["time"].exact(np.linspace(0.0, 9.0, 5)) for scene in (still, pushed))
    for name in ("x1", "x2"):
        np.testing.assert_array_equal(other[name], one[name])
    if chain.get("k2", 1.0):
        sizes = [[scene.numbers[f"Xp{i}"].value for i in (1, 2)] for scene in (pushed, Forced(**chain, omega=0.0))]
        np.testing.assert_allclose(*sizes)
    assert "At ω = 0 the force F₀ sin ωt is 0 at all times." in pushed.shown.notes


@pytest.mark.parametrize("c2", [0.0, 0.86])
@pytest.mark.parametrize("curve", ["size", "signed", "log"])
def test_a_frame_from_right_to_left_has_the_same_curves(c2: float, curve: str) -> None:
    forward, back = (
        Forced(c2=c2, curve=curve).picture(Frame(ranges={"omega": ends}, given=True)).columns
        for ends in ((0.3, 3.0), (3.0, 0.3))
    )
    for source in ("response", *(f"branch{i}" for i in range(4))):
        assert forward[source].keys() == back[source].keys()
        for name, values in forward[source].items():
            np.testing.assert_array_equal(values, back[source][name])

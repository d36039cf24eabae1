"""Scenes with two masses and the chain: starts given by modes, the drive, the absorber's goals, and waves."""

import math
from typing import Any

import numpy as np
import pytest

from components.chain import of_scene, start_of
from components.language.signals import Modal
from components.scenes import SCENES
from components.scenes.absorber import Absorber
from components.scenes.chain import Chain
from components.scenes.forced import Forced
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.response import response_plot
from components.state.covers import without
from components.state.page_state import fitted
from physics.absorber import den_hartog
from physics.bode_curves import locus_frequencies
from physics.damped_chain import DampedChain
from physics.forced import particular_solution
from physics.transient import DampedModes
from tests.page.hand import Hand, grabs
from tests.page.headless_page import Page, change, say, set_values
from tests.page.scripts import call
from tests.scenes.checks import by_link


@pytest.mark.parametrize(
    "start", [{"x1_0": 0.37, "x2_0": -0.2, "v1_0": 1 / 3, "k2": 0.77}, {"k1": 0.0, "x1_0": -0.3, "x2_0": -0.1}]
)
def test_the_choice_changes_nothing_and_leads_back_exactly(start: dict[str, float]) -> None:
    page = Page(SCENES["coupled"](**start))
    before = page.opening()["view"]["columns"]["time"]
    told = say(page, "choose", name="given_by", value="modes")
    assert told["errors"] == {} and told["view"]["forms"]["given_by_modes"] == "shown"
    for name in ("x1", "x2_fast"):
        assert np.abs(before[name] - told["view"]["columns"]["time"][name]).max() < 1e-4
    told = say(page, "choose", name="given_by", value="values")
    assert {name: told["state"]["parameters"][name] for name in start} == start
    told = say(Page(SCENES["coupled"](k1=0.0, v1_0=0.5)), "choose", name="given_by", value="modes")
    assert "A drift has no amplitude and no phase" in told["errors"]["given_by"]


@pytest.mark.parametrize("values", [{}, {"k1": 0.0}, {"k2": 0.0}, {"m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1}])
@pytest.mark.parametrize("shown", ["size", "log"])
def test_what_swings_against_the_push_is_dashed(values: dict[str, float], shown: str) -> None:
    """Each branch is drawn with one line sample: the sign of the particular solution is seen without asking for it."""
    scene = Forced(**values, curve=shown)
    drawn = {(one.source, one.y): one.width for one in response_plot().curves}
    branches = [scene.sources[f"branch{i}"].data.get("omega", np.empty(0))[1:-1] for i in range(4)]
    assert sum(w.size for w in branches) > 100
    for i, w in enumerate(branches):
        for name, X in zip(("Xp1", "Xp2"), particular_solution(of_scene(scene), 1.0, w), strict=True):
            assert not np.any(X < 0 if drawn[f"branch{i}", name] == "sum" else X > 0), (i, name)


@pytest.mark.parametrize(
    "values", [{"m1": 2.0, "k2": 2.0, "c1": 0.4, "c2": 0.2}, {"k1": 0.0, "x1_0": 0.3, "c2": 216.0}, {"v2_0": 0.1}]
)
def test_the_work_of_the_drive_becomes_energy_and_heat(values: dict[str, float]) -> None:
    scene = Forced(**values, view="work")
    data = scene.sources["energy"].data
    x_0, v_0 = start_of(scene)
    modes = DampedModes(
        chain=of_scene(scene), c=scene.c2, c1=scene.c1, x_0=x_0, v_0=v_0, F_0=scene.F_0, omega=scene.omega
    )
    heat = DampedForcedCase(modes, float(data["t"][-1])).heat(data["t"])
    size = abs(data["work"]).max() + abs(data["gain"]).max()
    np.testing.assert_allclose(data["work"] - data["gain"], heat, atol=1e-7 * size)
    assert np.all(np.diff(heat) >= 0)


def test_pushed_on_its_particular_solution_nothing_dies() -> None:
    scene = Forced(c1=0.3, c2=0.1)
    data = Forced(c1=0.3, c2=0.1, **scene.action("steady")).sources["time"].data
    assert max(abs(data["x1_c"]).max(), abs(data["x2_c"]).max()) < 1e-12
    assert not any(Forced(F_0=0.0).action("steady").values())


@pytest.mark.parametrize("i", [1, 2])
def test_the_dot_of_nyquist_follows_the_hand_along_its_loops(i: int) -> None:
    chain = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "c1": 0.2, "c2": 0.0}
    shape = next(one for one, grab in grabs(Forced) if grab.label.endswith(f"loops of mass {i}"))

    def held(omega: float) -> Hand:
        return Hand(fitted(Forced.at({**chain, "view": "nyquist", "omega": omega})), shape, wide=True, t=0.0)

    damped = DampedChain(**chain)
    slow, fast = damped.chain.modes().omega.tolist()
    every = locus_frequencies([root for root in damped.roots.tolist() if root.imag > 0], fast)[::48]
    way = every[(every > 0.5 * slow) & (every < 1.5 * fast)]
    places = [held(omega).at() or (0.0, 0.0) for omega in way]
    hand = held(way[0])
    hand.take()
    for omega, (x, y) in zip(way, places, strict=True):
        hand.set(hand.move((x, y)))
        assert math.dist(hand.at(moved=False) or (), (x, y)) < 2.0, omega
    assert hand.scene.values["omega"] > fast, "it has gone round both loops"


def test_twice_the_force_is_seen_as_twice_the_swing_until_the_stage_has_no_room() -> None:
    page = Page(Absorber())

    def metre() -> float:
        """The width of one metre on the stage, although the picture uses the unit of its axis."""
        return page.shown.scalars["metre"] * page.shown.axes["X1"].place(1.0)

    scale = metre()
    for force in (250.0, 100.0, 700.0):
        set_values(page, F_0=force)
        assert metre() == pytest.approx(scale), force
    set_values(page, F_0=5e4)
    small = metre()
    set_values(page, F_0=700.0)
    assert metre() == pytest.approx(small) and small < 0.5 * scale, "it grows by Fit alone"
    change(page, frame=None)
    assert metre() > 2 * small


@pytest.mark.parametrize("label", ["Below", "Resonant", "Above"])
def test_goals_can_be_met_from_the_lightest_mass_on(label: str) -> None:
    """From the mass at which a tuned absorber's resonances are 20 % away: the roots of D at 0.8 and 1.2 omega."""
    scene = Absorber()
    scene.set(SCENES["absorber"].preset_all(label))
    omega = scene.omega
    mass = max((250e3 - 100.0 * (s * omega) ** 2) * (1 - s**2) / (s**2 * omega**2) for s in (0.8, 1.2))
    found = f"{mass * (1 + 1e-3):.4g} kg"
    for share, is_met, lightest in ((1 - 1e-3, False, "none yet"), (1 + 1e-3, True, found), (1.5, True, found)):
        scene.m2 = mass * share
        assert [bool(scene.shown.scalars[f"met{i}"]) for i in range(3)] == [is_met, True, True]
        assert scene.shown.values["lightest"] == lightest
    scene.set({"damping": "added", "c": 0.1, "m2": mass})
    assert scene.shown.values["lightest"] == found, "not with a dashpot"
    scene.omega = 0.97 * scene.omega
    assert scene.shown.values["lightest"] == "none yet", "another machine"


@pytest.mark.parametrize("damping", [0.02, 1e5])
def test_the_highest_peak_is_drawn(damping: float) -> None:
    """With much damping the two masses move as one, at another natural frequency than those without damping."""
    scene = Absorber(damping="added", c=damping)
    w, swing = (scene.sources["sweep"].data[name] for name in ("w", "swing"))
    fine = np.linspace(w[0], w[-1], 400_001)
    s, link = 1j * fine, scene.k2 + 1j * fine * scene.c
    other = scene.m2 * s**2 + link
    exact = np.abs(scene.F_0 * other / ((scene.m1 * s**2 + scene.k1 + link) * other - link**2))
    assert swing.max() > 0.99 * exact.max()


def test_a_link_and_a_state_carry_the_lightest_solution_which_is_looked_at_again() -> None:
    page = Page(Absorber(m2=30.0))
    told = set_values(page, m2=40.0)
    assert told["view"]["values"]["lightest"] == "30 kg"
    assert by_link(told["query"]).now.shown.values["lightest"] == "30 kg"
    state = {**told["state"], "parameters": {**told["state"]["parameters"], "lightest": 3.0}}
    assert change(page, **state)["view"]["values"]["lightest"] == "40 kg", "no absorber of 3 kg does it"
    assert set_values(page, lightest=3.0)["errors"], "nobody sets it"


def test_den_hartogs_optimum() -> None:
    page = Page(Absorber(damping="added"))
    assert say(page, "act", name="optimum")["errors"] == {}
    scene: Any = page.scene
    best = den_hartog(100.0, 250e3, 16.0)
    assert (scene.k2, scene.c) == (pytest.approx(best.k2, rel=5e-4), pytest.approx(best.c, rel=5e-4))
    assert scene.shown.sources["sweep"]["swing"].max() == pytest.approx(best.height * 500.0 / 250e3, rel=5e-3)
    assert scene.shown.values["over_height"] == "0.27 %" and scene.shown.forms["why"] == "damped"


def test_another_number_of_masses_keeps_the_string_or_the_masses() -> None:
    scene = Chain()
    before = {name: scene.numbers[name].value for name in ("L", "wave_speed")}
    scene.N = 20.0
    assert {name: scene.numbers[name].value for name in before} == pytest.approx(before)
    assert scene.m * scene.N / scene.numbers["L"].value == pytest.approx(20 / 21)
    kept = scene.m, scene.k, scene.a
    scene.param.update(keep="masses", N=40.0)
    assert (scene.m, scene.k, scene.a) == kept
    scene.set({"N": 8.0, "starts": "mode", "j": 8.0, "p": 8.0})
    for name in ("j", "p"):
        with pytest.raises(ValueError, match=r"9.*1 to 8"):
            scene.param.update({name: 9.0})
    scene.N = 5.0
    assert (scene.j, scene.p) == (5.0, 5.0)


@pytest.mark.parametrize(
    ("N", "ends", "starts"),
    [(1, "fixed-fixed", "pulse"), (1, "fixed-free", "pluck"), (2, "fixed-free", "mass"), (2, "fixed-free", "mode")],
)
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
    columns = scene.shown.sources["time"]
    initial = axis.places(np.array([columns[f"x{p}"][0] for p in range(1, int(scene.N) + 1)]))
    for t in (0.0, 0.7):
        np.testing.assert_allclose(call("static/core/modal.displaced", signal, t), initial, atol=1e-12)

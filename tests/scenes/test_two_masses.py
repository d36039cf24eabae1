"""Scenes with two masses and the chain: starts given by modes, the drive, the absorber's goals, and waves."""

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.chain import of_scene, start_of
from components.language.shapes import AnyShape
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
from physics.coupled import TwoMassChain, free_modes
from physics.damped_chain import DampedChain
from physics.forced import particular_solution
from physics.modal_start import amplitudes_and_phases, modes_given, start_given
from physics.transient import DampedModes
from tests.grids import tries
from tests.page.hand import Hand, grabs
from tests.page.headless_page import Page, change, say, set_values
from tests.page.scripts import call
from tests.scenes.checks import by_link, check_picture

U = 2.0**-53
SIZE, TWO_SIZES = st.floats(-6, 6).map(lambda power: 10**power), st.tuples(*2 * (st.floats(0.01, 2),))
TWO_PHASES = st.tuples(*2 * (st.integers(-3000, 3000).map(lambda one: one / 1000),))


@settings(max_examples=tries(60))
@given(SIZE, SIZE, SIZE, SIZE | st.just(0.0), TWO_SIZES, TWO_PHASES)
def test_a_motion_by_its_modes_comes_back_to_the_last_digits(
    m1: float, m2: float, k1: float, k2: float, sizes: tuple[float, float], phases: tuple[float, float]
) -> None:
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    free = modes_given(chain, sizes, phases)
    back = amplitudes_and_phases(free)
    for j, omega in enumerate(chain.modes().omega):
        assert back[0][j] == pytest.approx(sizes[j] if omega else abs(sizes[j] * math.sin(phases[j])), rel=4 * U)
        assert not omega or abs(phases[j] - back[1][j]) < 4 * U * math.pi
    x_0, v_0 = start_given(free)
    for i in (0, 1):
        shape = [float(mode.shape[i]) for mode in chain.exact_modes]
        with mp.workdps(60):
            parts = [A * mp.sin(mp.mpf(phi)) * s for A, phi, s in zip(sizes, phases, shape, strict=True)]
            assert abs(x_0[i] - sum(parts)) <= 2 * U * sum(abs(part) for part in parts)
    again = free_modes(chain, x_0, v_0)
    reach = np.abs(free.amplitude).sum() + np.abs(again.amplitude).sum()
    assert np.abs(again.amplitude - free.amplitude).max() <= 1e-9 * reach


def test_the_choice_changes_nothing_and_leads_back_exactly() -> None:
    start = {"x1_0": 0.37, "x2_0": -0.2, "v1_0": 1 / 3, "k2": 0.77}
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


@pytest.mark.parametrize("label", ["At slow", "At fast"])
def test_hardly_an_ulp_from_a_natural_frequency_is_resonance(label: str) -> None:
    """The frequency is between two doubles; only these two are at most an ulp away."""
    scene, seen = Forced(), []
    scene.set(SCENES["forced"].preset_all(label))
    natural = scene.omega
    for omega in (natural, math.nextafter(natural, 0.0), math.nextafter(natural, math.inf)):
        scene.set({"omega": omega})
        seen.append(scene.shown.forms["steady"])
        if seen[-1] == "resonance":
            assert (scene.shown.values["D"], scene.shown.values["Xp1"]) == ("0.00", "+∞")
            (error,) = say(Page(scene), "act", name="steady")["errors"].values()
            assert "is at a natural frequency, where no particular solution exists: another" in error
    assert seen[0] == "resonance" and seen.count("resonance") == 2


CHAINS: list[dict[str, float]] = [
    {"m1": 2.0, "k1": 4.0, "k2": 2.0, "c1": 0.4, "c2": 0.2},
    {"k1": 0.0, "x1_0": 0.3, "c2": 216.0},
    {"k2": 0.0, "v2_0": 0.1, "c1": 0.2},
    {"m1": 400.0, "m2": 225.0, "k1": 625.0, "k2": 144.0, "x1_0": 0.1},
]


@pytest.mark.parametrize("values", CHAINS, ids=str)
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


UNEVEN = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "c1": 0.2, "c2": 0.0, "view": "nyquist"}


def held(i: int, omega: float) -> Hand:
    """A hand on the dot of mass i in the complex plane, at a drive frequency."""
    shape: AnyShape = next(one for one, grab in grabs(Forced) if grab.label.endswith(f"loops of mass {i}"))
    return Hand(fitted(Forced.at({**UNEVEN, "omega": omega})), shape, wide=True, t=0.0)


@pytest.mark.parametrize("i", [1, 2])
def test_the_dot_of_nyquist_follows_the_hand_along_its_loops(i: int) -> None:
    damped = DampedChain(**{name: one for name, one in UNEVEN.items() if name != "view"})
    slow, fast = damped.chain.modes().omega.tolist()
    every = locus_frequencies([root for root in damped.roots.tolist() if root.imag > 0], fast)[::48]
    way = every[(every > 0.5 * slow) & (every < 1.5 * fast)]
    places = [held(i, omega).at() or (0.0, 0.0) for omega in way]
    hand = held(i, way[0])
    hand.take()
    for omega, (x, y) in zip(way, places, strict=True):
        hand.set(hand.move((x, y)))
        assert math.dist(hand.at(moved=False) or (), (x, y)) < 2.0, omega
    assert hand.scene.values["omega"] > fast, "it has gone round both loops"


def drawn_to(told: dict[str, Any]) -> float:
    """The width of one metre on the stage, although the picture uses the unit of its axis."""
    axis = told["view"]["axes"]["X1"]
    return float(told["view"]["scalars"]["metre"] / axis["factor"] / 10.0 ** axis["exponent"])


def test_twice_the_force_is_seen_as_twice_the_swing_until_the_stage_has_no_room() -> None:
    page = Page(Absorber())
    scale = drawn_to(page.opening())
    for force in (250.0, 100.0, 700.0):
        assert drawn_to(set_values(page, F_0=force)) == pytest.approx(scale), force
    small = drawn_to(set_values(page, F_0=5e4))
    assert small < 0.5 * scale
    assert drawn_to(set_values(page, F_0=700.0)) == pytest.approx(small), "it grows by Fit alone"
    assert drawn_to(change(page, frame=None)) > 2 * small


@pytest.mark.parametrize("values", [{"c": 313.7, "k2": 27.4e3}, {"c": 2000.0}, {"c": 20.0, "omega": 40.0}])
def test_after_the_time_that_is_told_hardly_anything_is_left_of_the_transient(values: dict[str, float]) -> None:
    scene = Absorber(**values, damping="added", view="rest", tuning="free")
    drawn, shown = scene.sources["rest"].data, scene.shown
    assert np.abs(drawn["x1"]).max() <= 1e-3 * float(shown.values["rest1"]) * 1.005
    late = drawn["t"] > float(shown.values["dies"].removesuffix(" s"))
    assert np.all(np.abs(drawn["x1_c"][late]) < 0.02 * np.abs(drawn["x1_c"]).max())


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


def test_a_motion_from_rest_that_cannot_be_drawn_takes_its_view_alone_away() -> None:
    machine = {"own": True, "m1": 1e130, "k1": 1e-32, "F_0": 1e57, "omega": 1e113, "m2": 1e26, "k2": 1e145}
    scene = Absorber(**machine, tuning="free")
    check_picture(scene)
    assert not scene.sources["rest"].data and len(scene.sources["sweep"].data["w"])
    with pytest.raises(ValueError, match="outside the range of doubles"):
        scene.view = "rest"


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

"""Scene forced: its response, resonance, forces and work; with dashpots its lags, peaks and loops in the plane."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings

from components.chain import of_scene, start_of
from components.chain.forces import LENGTH, on_masses
from components.language.shapes import AnyShape
from components.language.state import Frame
from components.scenes import SCENES
from components.scenes.forced import Forced
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.response import response_plot
from components.state.link import Link
from components.state.page_state import fitted
from physics.bode import chain_resonances
from physics.bode_curves import locus_frequencies
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.forced import particular_solution
from physics.transient import DampedModes
from tests.grids import tries
from tests.page.hand import Hand, grabs
from tests.page.headless_page import apply_message, take_preset
from tests.page.scripts import played
from tests.scenes.sentences import visible_text
from tests.states import links

CHAINS: list[dict[str, float]] = [
    {},
    {"m1": 2.0, "k1": 4.0, "k2": 2.0},
    {"k1": 0.0, "x1_0": 0.3},
    {"k2": 0.0, "v2_0": 0.1},
    {"k1": 0.0, "k2": 0.0, "v1_0": 1.0},
    {"m1": 400.0, "m2": 225.0, "k1": 625.0, "k2": 144.0, "x1_0": 0.1},
]
DASHPOTS = [(0.0, 0.0), (0.4, 0.2), (0.2, 0.0), (0.0, 216.0), (1e-12, 0.0), (0.0, 1e12), (1e12, 1e-3)]
LIGHT = {"c1": 0.1, "c2": 0.1}
STRONG = {"c1": 1.0, "c2": 2.0}
UNEVEN = {"m1": 2.0, "k1": 4.0, "k2": 2.0, "c1": 0.2}


@pytest.mark.parametrize("values", [{}, {"k1": 0.0}, {"k2": 0.0}, {"m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1}])
@pytest.mark.parametrize("shown", ["size", "log"])
def test_what_swings_against_the_push_is_dashed(values: dict[str, float], shown: str) -> None:
    """Each branch is drawn with one line sample: the sign of the particular solution is seen without asking for it."""
    scene = Forced(**values, curve=shown)
    chain = TwoMassChain(m1=scene.m1, m2=scene.m2, k1=scene.k1, k2=scene.k2)
    drawn = {(one.source, one.y): one.width for one in response_plot().curves}
    branches = [scene.sources[f"branch{i}"].data.get("omega", np.empty(0))[1:-1] for i in range(4)]
    assert sum(w.size for w in branches) > 100
    for i, w in enumerate(branches):
        for name, X in zip(("Xp1", "Xp2"), particular_solution(chain, 1.0, w), strict=True):
            assert not np.any(X < 0 if drawn[f"branch{i}", name] == "sum" else X > 0), (i, name)


@pytest.mark.parametrize("label", ["At slow", "At fast"])
def test_hardly_an_ulp_from_a_natural_frequency_is_resonance(label: str) -> None:
    scene = Forced()
    take_preset(scene, label)
    natural = scene.omega
    seen = []
    for omega in (natural, math.nextafter(natural, 0.0), math.nextafter(natural, math.inf)):
        scene.set({"omega": omega})
        seen.append(scene.shown.forms["steady"])
        if seen[-1] != "resonance":
            continue
        assert (scene.shown.values["D"], scene.shown.values["Xp1"]) == ("0.00", "+∞")
        assert "drive_at" not in scene.shown.scalars
        assert not any("huge" in note for note in scene.shown.notes)
        before = scene.shown
        (error,) = apply_message(scene, {"type": "act", "name": "steady"}).values()
        assert "is at a natural frequency, where no particular solution exists: another" in error
        assert scene.shown is before
    # The frequency is between two doubles; only these two are at most an ulp away.
    assert seen[0] == "resonance" and seen.count("resonance") == 2


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


@pytest.mark.parametrize(("c1", "c2"), DASHPOTS[:4])
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


@pytest.mark.parametrize("c2", [0.0, 0.86])
def test_a_frame_from_right_to_left_has_the_same_curves(c2: float) -> None:
    frames = (Frame(ranges={"omega": ends}, given=True) for ends in ((0.3, 3.0), (3.0, 0.3)))
    forward, back = (Forced(c2=c2).picture(frame).columns for frame in frames)
    for source in ("response", *(f"branch{i}" for i in range(4))):
        for name, values in forward[source].items():
            np.testing.assert_array_equal(values, back[source][name])


def chain_of(values: dict[str, float]) -> DampedChain:
    equal = {"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0}
    return DampedChain(**{name: one for name, one in (equal | values).items() if name[0] in "mkc"})


@pytest.mark.parametrize("values", [LIGHT, UNEVEN, STRONG, {"k2": 0.0, "c1": 0.3}, {"c1": 4.0, "c2": 1e-9}])
def test_the_dots_are_on_the_curves(values: dict[str, float]) -> None:
    scene = SCENES["forced"](**values, view="bode", omega=1.1)
    scalars, axes, lags = scene.shown.scalars, scene.shown.axes, scene.sources["lag"].data
    assert scalars["now"] == pytest.approx(math.log10(1.1))
    for i, lag in zip((1, 2), chain_of(values).lags(1.1), strict=True):
        assert np.all(lags[f"phi{i}"] >= 0) and np.all(lags[f"phi{i}"] <= (i + 1e-15) * math.pi)
        if f"phi{i}_at" in scalars:
            assert scalars[f"phi{i}_at"] == pytest.approx(math.degrees(lag))
            assert np.interp(1.1, lags["w"], lags[f"phi{i}"]) == pytest.approx(lag, abs=0.02)
    assert ("phi2_at" in scalars) == bool(values.get("k2", 1.0)), "no motion, no lag"
    plane = scene.sources["nyquist"].data
    near = np.argmin(np.hypot(plane["re1"] - scalars["re1_at"], plane["im1"] - scalars["im1_at"]))
    assert plane["omega"][near] == pytest.approx(1.1, rel=0.02) and axes["re"].unit == "m"


@settings(max_examples=tries(80))
@given(links(Forced, 1.0))
def test_the_push_never_takes_back_in_a_cycle_and_its_work_is_a_depth(link: Link) -> None:
    scene = Forced(**{**link.values, "view": "nyquist"})
    if not (scene.c1 or scene.c2):
        return
    plane = scene.shown.sources["nyquist"]
    assert np.all(plane["im1"] <= 0)
    damped = DampedChain.of(of_scene(scene), scene.c1, scene.c2)
    works = damped.works(scene.omega, scene.F_0)
    depth = -math.pi * scene.F_0 * damped.response(scene.omega, scene.F_0)[0].imag
    assert sum(works) == pytest.approx(depth, rel=1e-12)
    assert ("no work in a cycle" in visible_text(scene)) == (not any(works))


def test_peaks_widths_and_dips_are_marked_in_their_view_and_without_dashpots_lags_jump() -> None:
    scene, found = SCENES["forced"](**LIGHT, view="bode"), chain_resonances(chain_of(LIGHT))
    scalars, up = scene.shown.scalars, scene.shown.axes["X"]
    for i, one in zip((1, 2), (found.X1, found.X2), strict=True):
        for n, peak in enumerate(one.peaks):
            assert scalars[f"peak{i}_{n}"] == pytest.approx(math.log10(peak.omega))
            assert scalars[f"up{i}_{n}"] == pytest.approx(up.place(peak.height))
            low, high = peak.half_power
            assert (f"is_wide{i}_{n}" in scalars) == bool(low and high)
        assert scalars[f"dip{i}"] == pytest.approx(math.log10(one.dips[0].omega))
    assert "peaks at 0.617 (width 0.0383) and 1.62 (width 0.256) rad/s" in visible_text(scene)
    assert not any(name.startswith("peak") for name in SCENES["forced"](**LIGHT).shown.scalars)
    jumps = SCENES["forced"](view="bode", omega=1.0).sources["lag"].data
    assert [set(np.round(jumps[name] / math.pi, 12)) for name in ("phi1", "phi2")] == [{0.0, 1.0}, {0.0, 1.0, 2.0}]


def dot(i: int) -> AnyShape:
    """The grabbed dot of a mass in the complex plane."""
    return next(shape for shape, grab in grabs(SCENES["forced"]) if grab.label.endswith(f"loops of mass {i}"))


def place(values: dict[str, float], i: int, omega: float) -> tuple[float, float]:
    """Where that dot is for a drive frequency, in pixels."""
    at = Hand(fitted(SCENES["forced"].at({**values, "view": "nyquist", "omega": omega})), dot(i), wide=True, t=0.0).at()
    return at or pytest.fail("not drawn")


@pytest.mark.parametrize("values", [LIGHT, STRONG, UNEVEN, {"c1": 1e-3, "c2": 1e-3}])
@pytest.mark.parametrize("i", [1, 2])
def test_the_dot_of_nyquist_follows_the_hand_along_its_loops(values: dict[str, float], i: int) -> None:
    slow, fast = chain_of(values).chain.modes().omega.tolist()
    roots = [root for root in chain_of(values).roots.tolist() if root.imag > 0]
    every = locus_frequencies(roots, fast)[::24]
    way = every[(every > 0.5 * slow) & (every < 1.5 * fast)]
    places = [place(values, i, omega) for omega in way]
    hand = Hand(fitted(SCENES["forced"].at({**values, "view": "nyquist", "omega": way[0]})), dot(i), wide=True, t=0.0)
    hand.take()
    for omega, (x, y) in zip(way, places, strict=True):
        hand.set(hand.move((x, y)))
        assert math.dist(hand.at(moved=False) or (), (x, y)) < 2.0, omega
    assert hand.scene.values["omega"] > fast, "it has gone round both loops"

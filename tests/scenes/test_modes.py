"""Scene modes: the buttons and arrows of Guess, and the roots, paths and sentences of Roots for any dashpots."""

from __future__ import annotations

import cmath
import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.language.blocks import StageBlock
from components.language.shapes import Label
from components.layout.sheet import in_force
from components.quantities.formatting import three
from components.scenes.modes import ModesScene
from physics.damped_chain import NEAR, Kind
from physics.root_paths import RootPath, Varied, exceptional_point
from tests.grids import tries
from tests.page.headless_page import apply_message
from tests.page.scripts import played
from tests.physics.braked_cases import BRAKED, CASES, Case, case_of, cases, eigenvectors
from tests.scenes.sentences import number, sentences, visible_text

each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: str(case["id"]))
WAYS: tuple[Varied, ...] = ("c1", "c2", "both")
TIED = [case for case in BRAKED if case["k1"] and case["k2"]]
NUMBER = r"[−+]?[0-9]+(?:\.[0-9]+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
PLACES = ("slow", "fast", "third", "fourth")


def test_as_a_mass_wants_takes_its_force_away() -> None:
    """With equal masses and springs the flag sets the double next to the golden ratio, and the button its shape."""
    for i in (1, 2):
        scene = ModesScene(view="guess")
        assert apply_message(scene, {"type": "act", "name": f"row{i}"}) == {}
        assert scene.shown.values[f"add{i}_N"] == "+0.00 N" != scene.shown.values[f"add{3 - i}_N"]
    scene = ModesScene(view="guess", **ModesScene.presets["All equal"])
    golden = (math.sqrt(5) - 1) / 2
    assert scene.shown.scalars["w_slow_si"] == pytest.approx(golden, rel=1e-15)
    scene.omega = scene.shown.scalars["w_slow_si"]
    assert apply_message(scene, {"type": "act", "name": "row1"}) == {}
    assert scene.ratio == pytest.approx(1 / golden, rel=1e-14) and scene.shown.values["add2_N"] == "+0.00 N"


@pytest.mark.parametrize(("k2", "omega"), [(1.0, 1.0), (2.0, math.sqrt(2)), (2.0, math.nextafter(math.sqrt(2), 0.0))])
def test_hardly_an_ulp_from_a_zero_is_the_zero_and_mass_1_rests(k2: float, omega: float) -> None:
    """In the default chain mass 2 alone, mass 1 held, swings at sqrt(2), which is no double."""
    scene = ModesScene(view="guess", k2=k2, omega=omega)
    values, forms = scene.shown.values, scene.shown.forms
    assert [forms[name] for name in ("row2_says", "agree", "D")] == ["pole", "pole", "value"]
    assert (values["a22"], number(values["D"])) == ("0.00", -(k2**2))
    assert "X₁ = 0" in apply_message(scene, {"type": "act", "name": "row2"})["action"] and scene.ratio == -0.8


def test_the_longest_arrow_fits_and_their_lengths_are_the_forces() -> None:
    scalars = ModesScene(view="guess", omega=0.7, ratio=3.0).shown.scalars
    arrows = np.array([scalars[f"{row}{i}_N"] for i in (1, 2) for row in ("need", "give")])
    forces = np.array([-2 * 0.49 / 3, -4 / 3 + 2 * (1 - 1 / 3), -0.49, -2 * (1 - 1 / 3)])
    np.testing.assert_allclose(arrows, 0.17 * forces / np.abs(forces).max(), rtol=1e-12, atol=1e-15)


def scene_of(case: Case, grows: str = "c1") -> ModesScene:
    return ModesScene(view="roots", grows=grows, **case.values)


def crosses(scene: ModesScene) -> list[complex]:
    """Where the four crosses are, in 1/s, however far out."""
    re, im = (scene.shown.axes[name] for name in ("re", "im"))
    places = scene.shown.scalars
    return [
        complex(places[f"root{j}_re"] * 10.0**re.exponent, places[f"root{j}_im"] * 10.0**im.exponent) for j in range(4)
    ]


@each_case
def test_the_crosses_are_the_roots(case: dict[str, Any]) -> None:
    one = case_of(case)
    for grows in WAYS:
        scene, true = scene_of(one, grows), one.damped.roots.tolist()
        found, shown = crosses(scene), scene.shown
        largest = max(map(abs, true)) or 1.0
        assert max(min(abs(s - one) for one in found) for s in true) < 2e-3 * largest  # four roots that are one
        assert sorted(s.imag for s in found) == pytest.approx(sorted(-s.imag for s in found), abs=1e-9 * largest)
        beyond = sorted((s.real for s in true if s.real < shown.axes["re"].start), reverse=True)
        assert shown.values["out"] == ", ".join(map(three, beyond)), "the roots left of the plane, nearest first"


@pytest.mark.parametrize("case", TIED, ids=lambda case: str(case["id"]))
def test_the_ring_and_the_circles_are_where_the_roots_are_bounded(case: dict[str, Any]) -> None:
    """tests/physics/test_root_paths shows that swinging roots are in the ring and between the circles."""
    one, shown = case_of(case), scene_of(case_of(case)).shown
    drawn = {name: size * 10.0 ** shown.axes["re"].exponent for name, size in shown.scalars.items()}
    rings = [float(w) for w in case["omega"]]
    assert [drawn["ring_slow"], drawn["ring_fast"]] == pytest.approx(rings, rel=1e-12)
    circles = [k / c if c else math.inf for k, c in ((one.chain.k1, one.c1), (one.chain.k2, one.c2))]
    seen = [circle if circle < 40 * rings[1] else 0.0 for circle in circles]
    assert [drawn["radius1"], drawn["radius2"]] == pytest.approx(seen, rel=1e-12)


@settings(max_examples=tries(60), suppress_health_check=[HealthCheck.too_slow])
@given(cases(), st.sampled_from(WAYS))
def test_the_paths_are_roots_without_a_gap(case: Case, grows: Varied) -> None:
    """Every point of a path is a root at some dashpot, and no path jumps to another one."""
    scene = scene_of(case, grows)
    paths = scene.sources["paths"].data
    path = RootPath.of(case.damped, grows)
    unit = max(case.chain.modes().omega[1], 1e-300)
    far = 3 * unit
    for j in range(4):
        s = paths[f"re{j}"] + 1j * paths[f"im{j}"]
        inside = [one for one in s[:: max(1, len(s) // 12)].tolist() if abs(one.real) < far * 0.999]
        for one in inside:
            near = path.at(path.dragged(one)).roots
            assert min(abs(near - one)) < 2e-3 * max(abs(one), 1e-3 * unit)
        steps = np.abs(np.diff(np.clip(s.real, -2 * unit, None) + 1j * s.imag))
        assert steps.max() < 0.35 * unit


@each_case
def test_the_diamond_is_the_exceptional_point(case: dict[str, Any]) -> None:
    one, point = case_of(case), exceptional_point(case_of(case).chain)
    for grows in WAYS:
        path, scene = RootPath.of(one.damped, grows), scene_of(one, grows)
        seen = scene.shown.scalars["met"]
        if point is None or not (point.c1 or point.c2):
            continue
        (a1, a2), (d1, d2) = path.base, path.direction
        is_on_it = (point.c1 - a1) * d2 == pytest.approx(
            (point.c2 - a2) * d1, abs=1e-9 * max(point.c1, point.c2) * max(d1, d2)
        )
        ahead = (point.c1 - a1) * d1 + (point.c2 - a2) * d2 >= 0
        assert bool(seen) == (is_on_it and ahead)
        if seen:
            unit = 10.0 ** scene.shown.axes["re"].exponent
            drawn = complex(scene.shown.scalars["met1"], scene.shown.scalars["met1_im"]) * unit
            assert min(abs(drawn - s) for s in point.roots) < 1e-6 * abs(point.roots[0])


def upper(case: Case) -> list[tuple[complex, complex]]:
    """s and X2/X1 of each root that swings, by another computation."""
    return [(complex(s), complex(X2 / X1)) for s, X1, X2 in eigenvectors(case) if 2 * s.imag > NEAR * abs(s)]


def lines(scene: ModesScene) -> list[str]:
    """The lines on the roots, as they are read."""
    names = [scene.shown.values[f"{place}_name"] for place in PLACES]
    return [line for line in sentences(scene) if any(name and line.startswith(f"{name}: ") for name in names)]


@settings(max_examples=tries(150), suppress_health_check=[HealthCheck.too_slow])
@given(cases())
def test_what_is_said_of_the_roots_and_of_the_motions_is_true(case: Case) -> None:
    scene = scene_of(case)
    check_roots(case, scene)
    check_frequencies(case, scene)
    check_statement(case, visible_text(scene))


def check_roots(case: Case, scene: ModesScene) -> None:
    """Each root is said with its numbers."""
    true = upper(case)
    sizes = [abs(float(part)) for s, _, _ in eigenvectors(case) for part in (s.real, s.imag)]
    told, every = lines(scene), case.damped.free_motions.modes
    assert len(told) == len(every)
    swings = [line for line in told if "It swings" in line]
    pairs = sum(2 if "each twice" in line else 1 for line in swings)
    assert pairs == len(true) and all("±" in line and "ζ" in line for line in swings)
    for line in told:
        assert ("±" in line) == ("It swings" in line)
        assert ("It does not swing" in line or "critical" in line or "s=0" in line) != ("It swings" in line)
        for text in re.findall(NUMBER, line.split("s=")[-1].split(" 1/s")[0]):
            value = abs(number(text))
            assert not value or any(math.isclose(value, one, rel_tol=6e-3) for one in sizes), (line, sizes)


def check_frequencies(case: Case, scene: ModesScene) -> None:
    """No frequency is named of what does not swing."""
    compared = {one.symbol: one.value for one in scene.readouts()}
    frequencies = [value for symbol, value in compared.items() if symbol.startswith("ω")]
    assert len(frequencies) == sum("It swings" in line for line in lines(scene))
    assert all(value > 0 for value in frequencies)
    named = any("−" in symbol.partition("_")[2] or "+" in symbol.partition("_")[2] for symbol in compared)
    assert named == (case.damped.free_motions.kind in (Kind.PROPORTIONAL, Kind.TWO_PAIRS))
    assert not any("rad/s" in text for text in (*sentences(scene), *shown_titles(scene)))


def check_statement(case: Case, text: str) -> None:
    """The sentence on the motions is true."""
    (chain, c1, c2), true = case, eigenvectors(case)
    ratios = [ratio for _, ratio in upper(case)]
    swinging, drifts = len(ratios), not (chain.k1 or c1) or not (chain.k2 or c2)
    assert drifts == ("Nothing brakes the drift" in text)
    assert ("both drift" in text) == (not (chain.k1 or c1)) and ("it drifts" in text) == (not (chain.k2 or c2))
    assert ("What is left at the end" in text) == (not drifts and not (chain.k1 and chain.k2))
    if not (chain.k1 and chain.k2):
        return
    assert "creeps home" not in text and "stays where it is" not in text
    assert ("Nothing swings" in text or "Neither swings" in text) == (not swinging)
    assert ("One motion swings, two do not" in text or "One pair of roots swings, one does not" in text) == (
        swinging == 1 and "stay in line" not in text
    )
    assert ("stay in line" in text) == case.damped.proportional
    if "stay in line" in text:
        assert all(abs(math.sin(cmath.phase(ratio))) < 1e-6 for ratio in ratios)
    else:
        assert max(c1, c2) < 1e-9 or all(abs(math.sin(cmath.phase(ratio))) > 1e-60 for ratio in ratios)
    if "lags behind" in text or "leads mass 1" in text:
        assert swinging == 2 and all((ratio.imag < 0) == ("lags behind" in text) for ratio in ratios)
    if "outlasts" in text:
        slowest = min(true, key=lambda root: abs(root[0]))
        assert (slowest[2] / slowest[1]).real < 0
    assert ("have become one" in text) == (swinging == 2 and abs(true_gap(case)) < NEAR)


def true_gap(case: Case) -> float:
    """The relative distance of the two roots that swing."""
    one, two = (s for s, _ in upper(case))
    return abs(one - two) / abs(one)


def shown_titles(scene: ModesScene) -> list[str]:
    """The titles on the stage."""
    now = scene.shown
    labels = [
        one for block in in_force(scene.sheet(), now.forms) if isinstance(block, StageBlock) for one in block.shapes
    ]
    drawn = [one for one in labels if isinstance(one, Label) and all(now.scalars.get(name, 1) for name in one.show)]
    return [
        "".join(now.values.get(run.text, "") if run.kind == "value" else run.text for run in one.words) for one in drawn
    ]


@settings(max_examples=tries(300), suppress_health_check=[HealthCheck.too_slow])
@given(cases())
def test_the_picture_plays_the_motions_that_its_titles_name(case: Case) -> None:
    """Re(X exp(s t)) for a root of each drawn motion, by the signals that the browser plays."""
    scene = scene_of(case)
    titles, found = shown_titles(scene), case.damped.free_motions.modes
    drawn = PLACES[: min(len(found), 2)]
    assert all(any(title.startswith(scene.shown.values[f"{place}_name"]) for title in titles) for place in drawn)
    if len(found) == 1:
        assert not any(title.startswith(("slow", "fast")) for title in titles)
    axis = scene.shown.axes["t"]
    t = 0.01 * axis.end
    now = played(scene.shown, t * 10.0**-axis.exponent)
    for place, one in zip(drawn, found, strict=False):
        x = [float(now[f"x{i}_{place}"]) for i in (1, 2)]
        could = [[(X * cmath.exp(s * t)).real for X in one.shape] for s in one.exponents]
        assert any(x == pytest.approx(both, abs=1e-6) for both in could)


@pytest.mark.parametrize("view", ["guess", "solve", "sweep", "hunt"])
def test_the_other_views_say_that_they_leave_the_dashpots_out(view: str) -> None:
    assert any("without the dashpots" in note for note in ModesScene(view=view, c1=0.1).shown.notes)
    assert not any("dashpots" in note for note in ModesScene(view=view).shown.notes)

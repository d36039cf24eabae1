"""Scene modes with dashpots: the arrows of Roots leave the line exactly where c1 k2 is not c2 k1."""

from __future__ import annotations

import cmath
import math
import re

import pytest
from hypothesis import HealthCheck, given, settings

from components.language.blocks import StageBlock
from components.language.shapes import Label
from components.layout.sheet import in_force
from components.scenes.modes import ModesScene
from physics.coupled import TwoMassChain
from physics.damped_chain import NEAR, Kind
from tests.grids import tries
from tests.page.scripts import played
from tests.physics.braked_cases import Case, cases, eigenvectors
from tests.scenes.chains import number
from tests.scenes.visible_sentences import sentences, visible_text

NUMBER = r"[−+]?[0-9]+(?:\.[0-9]+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"

CHAINS = [
    (2.0, 1.0, 4.0, 2.0),
    (0.7, 3.0, 1.0, 5.0),
    (1.0, 0.04, 0.96, 0.04),
    (1.0, 1.0, 0.0, 2.0),
    (1.0, 1.0, 2.0, 0.0),
]
PLACES = ("slow", "fast", "third", "fourth")


def scene_of(case: Case) -> ModesScene:
    return ModesScene(view="roots", **case.values)


def scenes(c1: float, c2: float) -> list[ModesScene]:
    return [
        scene_of(Case(TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), chain, strict=True))), c1, c2))
        for chain in CHAINS
    ]


def upper(case: Case) -> list[tuple[complex, complex]]:
    """s and X2/X1 of each root that swings, by another computation."""
    return [(complex(s), complex(X2 / X1)) for s, X1, X2 in eigenvectors(case) if 2 * s.imag > NEAR * abs(s)]


def lines(scene: ModesScene) -> list[str]:
    """The lines on the roots, as they are read."""
    names = [scene.shown.values[f"{place}_name"] for place in PLACES]
    return [line for line in sentences(scene) if any(name and line.startswith(f"{name}: ") for name in names)]


@settings(max_examples=tries(300), suppress_health_check=[HealthCheck.too_slow])
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
        assert max(c1, c2) < 1e-9 or all(abs(math.sin(cmath.phase(ratio))) > 1e-13 for ratio in ratios)
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

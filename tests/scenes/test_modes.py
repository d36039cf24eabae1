"""Scene modes: the buttons and arrows of Guess, and the roots, paths and sentences of Roots for any dashpots."""

import cmath
import math

import numpy as np
import pytest
from hypothesis import Phase, example, given, settings
from hypothesis import strategies as st

from components.quantities.formatting import three
from components.scenes.modes import ModesScene
from physics.coupled import TwoMassChain
from physics.damped_chain import NEAR
from physics.root_paths import RootPath, Varied
from tests.grids import tries
from tests.page.headless_page import Page, say
from tests.physics.truth import Case, cases, eigenvectors
from tests.scenes.checks import numbers, sentences, visible_text

WAYS: tuple[Varied, ...] = ("c1", "c2", "both")
PLACES = ("slow", "fast", "third", "fourth")


def test_as_a_mass_wants_takes_its_force_away() -> None:
    """With equal masses and springs the flag sets the double next to the golden ratio, and the button its shape."""
    for i in (1, 2):
        told = say(Page(ModesScene(view="guess")), "act", name=f"row{i}")["view"]["values"]
        assert told[f"add{i}_N"] == "+0.00 N" != told[f"add{3 - i}_N"]
    scene = ModesScene(view="guess", **ModesScene.presets["All equal"])
    golden = (math.sqrt(5) - 1) / 2
    assert scene.shown.scalars["w_slow_si"] == pytest.approx(golden, rel=1e-15)
    scene.omega = scene.shown.scalars["w_slow_si"]
    told = say(Page(scene), "act", name="row1")
    assert told["state"]["parameters"]["ratio"] == pytest.approx(1 / golden, rel=1e-14)
    assert told["view"]["values"]["add2_N"] == "+0.00 N"


def crosses(scene: ModesScene) -> list[complex]:
    """Where the four crosses are, in 1/s, however far out."""
    re, im = (scene.shown.axes[name] for name in ("re", "im"))
    places = scene.shown.scalars
    return [
        complex(places[f"root{j}_re"] * 10.0**re.exponent, places[f"root{j}_im"] * 10.0**im.exponent) for j in range(4)
    ]


def check_crosses(case: Case, scene: ModesScene) -> None:
    found, shown, true = crosses(scene), scene.shown, case.damped.roots.tolist()
    largest = max(map(abs, true))
    assert max(min(abs(s - one) for one in found) for s in true) < 2e-3 * largest  # four roots that are one
    assert sorted(s.imag for s in found) == pytest.approx(sorted(-s.imag for s in found), abs=1e-9 * largest)
    beyond = sorted((s.real for s in true if s.real < shown.axes["re"].start), reverse=True)
    assert shown.values["out"] == ", ".join(map(three, beyond)), "the roots left of the plane, nearest first"


def check_paths(case: Case, scene: ModesScene, grows: Varied) -> None:
    """Every point of a path is a root at some dashpot, and no path jumps to another one."""
    paths, path = scene.sources["paths"].data, RootPath.of(case.damped, grows)
    unit = case.chain.modes().omega[1]
    for j in range(4):
        s = paths[f"re{j}"] + 1j * paths[f"im{j}"]
        for one in s[:: max(1, len(s) // 12)].tolist():
            if abs(one.real) < 2.997 * unit:
                near = path.at(path.dragged(one)).roots
                assert min(abs(near - one)) < 2e-3 * max(abs(one), 1e-3 * unit)
        steps = np.abs(np.diff(np.clip(s.real, -2 * unit, None) + 1j * s.imag))
        assert steps.max() < 0.35 * unit


def upper(case: Case) -> list[tuple[complex, complex]]:
    """s and X2/X1 of each root that swings, by another computation."""
    return [(complex(s), complex(X2 / X1)) for s, X1, X2 in eigenvectors(case) if 2 * s.imag > NEAR * abs(s)]


def lines(scene: ModesScene) -> list[str]:
    """The lines on the roots, as they are read."""
    names = [scene.shown.values[f"{place}_name"] for place in PLACES]
    return [line for line in sentences(scene) if any(name and line.startswith(f"{name}: ") for name in names)]


@settings(max_examples=tries(100), phases=(Phase.explicit, Phase.generate))
@given(cases(), st.sampled_from(WAYS))
@example(Case(TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), 50.0, 50.0), "both")  # two roots left of the plane
@example(Case(TwoMassChain(m1=27.8, m2=0.00541, k1=1.0, k2=0.0), 1.0, 0.0), "c1")  # roots meet far from the light mass
def test_crosses_paths_and_what_is_said_of_the_roots_and_of_the_motions_are_true(case: Case, grows: Varied) -> None:
    scene = ModesScene(view="roots", grows=grows, **case.values)
    check_crosses(case, scene)
    if case.chain.modes().omega[1] and max(case.c1, case.c2) > 1e-100:  # else no dashpot in doubles for each place
        check_paths(case, scene, grows)
    check_roots(case, scene)
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
    frequencies = [one for one in scene.readouts() if one.symbol.startswith("ω")]
    assert len(frequencies) == len(swings) and all(one.value > 0 for one in frequencies)
    for line in told:
        assert ("±" in line) == ("It swings" in line)
        assert ("It does not swing" in line or "critical" in line or "s=0" in line) != ("It swings" in line)
        for value in map(abs, numbers(line.split("s=")[-1].split(" 1/s")[0])):
            assert not value or any(math.isclose(value, one, rel_tol=6e-3) for one in sizes), (line, sizes)


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
    roots = [s for s, _ in upper(case)]
    assert ("have become one" in text) == (swinging == 2 and abs(roots[0] - roots[1]) < NEAR * abs(roots[0]))

"""Scene modes, the view Roots: crosses, paths, circles, and a hand on a root, against the cases of the reference."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.language.shapes import ChainRoot
from components.quantities.formatting import three
from components.scenes.modes import ModesScene
from components.state.page_state import fitted
from physics.damped_chain import DampedChain
from physics.root_paths import RootPath, Varied, exceptional_point
from tests.grids import tries
from tests.page.hand import Hand, grabs
from tests.physics.braked_cases import BRAKED, CASES, Case, case_of, cases

each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: str(case["id"]))
WAYS: tuple[Varied, ...] = ("c1", "c2", "both")
TIED = [case for case in BRAKED if case["k1"] and case["k2"]]


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
def test_swinging_crosses_are_in_the_ring_and_between_the_circles(case: dict[str, Any]) -> None:
    one = case_of(case)
    shown = scene_of(one).shown
    unit = 10.0 ** shown.axes["re"].exponent
    slow, fast = (shown.scalars[f"ring_{mode}"] * unit for mode in ("slow", "fast"))
    assert (slow, fast) == pytest.approx([float(w) for w in case["omega"]], rel=1e-12)
    circles = [k / c if c else math.inf for k, c in ((one.chain.k1, one.c1), (one.chain.k2, one.c2))]
    for j, circle in enumerate(circles, start=1):
        drawn = shown.scalars[f"radius{j}"] * unit
        assert drawn == pytest.approx(circle if circle < 40 * fast else 0.0, rel=1e-12)
    for s in one.damped.roots.tolist():
        if s.imag > 1e-6 * abs(s):
            assert slow * (1 - 1e-9) <= abs(s) <= fast * (1 + 1e-9)
            assert min(circles) * (1 - 1e-9) <= abs(s) ** 2 / (-2 * s.real) <= max(circles) * (1 + 1e-9)


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


@pytest.mark.parametrize(("grows", "names"), [("c1", {"c1"}), ("c2", {"c2"}), ("both", {"c1", "c2"})])
def test_a_hand_on_a_root_sets_the_dashpot_of_the_nearest_one(grows: Varied, names: set[str]) -> None:
    scene = ModesScene(view="roots", grows=grows, c1=0.8, c2=0.5)
    now = fitted(scene.value)
    poles = [(shape, grab) for shape, grab in grabs(now.kind, now.shown.forms) if isinstance(grab.ways[-1], ChainRoot)]
    held = [(shape, grab, at) for shape, grab in poles if (at := Hand(now, shape, wide=True, t=0).at())]
    assert len(held) == 4
    roots = crosses(scene)
    other = next(j for j in range(4) if abs(roots[j].real - roots[0].real) > 0.01)
    one, two, s, r = held[0][2], held[other][2], roots[0], roots[other]
    x1, y1 = (one[0] - two[0]) / (s.real - r.real), (one[1] - two[1]) / (s.imag - r.imag)
    path = RootPath.of(DampedChain(m1=2, m2=1, k1=4, k2=2, c1=0.8, c2=0.5), grows)
    for shape, grab, (x, y) in held:
        assert {way.parameter for way in grab.ways if way.parameter} == names
        hand = Hand(now, shape, wide=True, t=0)
        hand.take()
        values = hand.move((x - 25.0, y + 6.0))
        value = path.dragged(s + complex((x - 25.0 - one[0]) / x1, (y + 6.0 - one[1]) / y1))
        wanted = [a + value * d for a, d in zip(path.base, path.direction, strict=True)]
        assert value > 0
        if grows == "both":  # there may be two such values: the drag takes the one closer to that of the dashpots
            assert values["c1"] / values["c2"] == pytest.approx(0.8 / 0.5, rel=0.05)
            continue
        assert values == pytest.approx({name: wanted[int(name[1]) - 1] for name in names}, rel=0.05)

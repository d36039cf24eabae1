"""Draggable shapes of every scene: they use names of the scene, and the frame stays fixed during a drag."""

from collections import Counter
from typing import Any

import pytest

from components.chain import START
from components.language.shapes import Along, AnyShape, Grab
from components.scenes import SCENES
from components.scenes.coupled import BY_MODES
from components.state.page_state import fitted
from tests.grids import WHOLE
from tests.page.hand import Hand, grabs, sets
from tests.page.scripts import played
from tests.scenes.checks import choices

AT = 0.37
"""The instant at which a hand takes hold, in the unit of the time axis."""
NEAR = 0.6
"""Pixels: a drag rounds the set value to about half a pixel."""
OFTEN = 100 if WHOLE else 3
"""In how many states each shape is dragged."""
ALSO: dict[str, tuple[dict[str, Any], ...]] = {
    "modes": (
        {"view": "guess"},
        {"view": "guess", "ratio": 2.0},
        *({"view": "roots", "grows": grows, "c1": c, "c2": c} for grows in ("c1", "c2", "both") for c in (0.5, 10.0)),
    ),
    "absorber": ({"view": "rest", "x1_0": 0.002},),
}
"""States in which something else is in hand."""
FOLLOWS = {"damped": ("c",), "driven": ("c",), "absorber": ("k2",), "coupled": ("given_by", *BY_MODES, *START)}
"""Parameters that follow from one that is set: a tuned spring follows the speed, modes a start."""


@pytest.mark.parametrize("slug", SCENES)
def test_each_grab_sets_what_it_names_and_its_handle_is_where_the_hand_was(slug: str) -> None:
    """In each preset and each way of showing things, on a wide page and on a phone."""
    taken = Counter[AnyShape]()
    ways = (*SCENES[slug].presets.values(), *ALSO.get(slug, ()), *choices(SCENES[slug]))
    for values, wide in (({}, False), *((values, True) for values in ways)):
        now = fitted(SCENES[slug].at(values))
        for shape, grab in grabs(now.kind, now.shown.forms):
            if taken[shape] < OFTEN:
                taken[shape] += dragged(Hand(now, shape, wide=wide, t=AT), grab)
    every = {shape for shape, _ in grabs(SCENES[slug])}
    assert {shape for shape in every if taken[shape]} == every, f"not taken in hand: {slug}"


def dragged(hand: Hand, grab: Grab) -> bool:
    """Take a grip and drag it; return whether it is drawn."""
    before, grip = hand.scene.values, hand.at()
    free = {way.across for way in grab.ways if isinstance(way, Along) and not way.parameter}
    if not grip:
        return False
    hand.set(hand.take())
    x, y = hand.at() or pytest.fail(f"{grab.label} vanishes when it is taken")
    if grab.start:
        said = f"{grab.label} jumps when it is taken: is `size` one of the parameter in SI, `place` where it is drawn?"
        assert (x, y) == pytest.approx(grip, abs=0.15), said
    for far in ((7.0, -5.0), (-9.0, 6.0)):
        values = hand.move((x + far[0], y + far[1]))
        if any(hand.scene.param[name].refusal(value) for name, value in values.items()):
            continue
        hand.set(values)
        changed = hand.scene.differing(before) & hand.scene.linked().keys()
        assert changed <= {*sets(grab), *(one.parameter for one in grab.start), *FOLLOWS.get(hand.scene.slug, ())}
        assert values.items() <= hand.scene.values.items()
        after = hand.at(moved=False) or pytest.fail(f"{grab.label} vanishes when it is dragged")
        for across, answered, drawn in zip("xy", after, hand.at() or (), strict=True):
            assert across in free or answered == pytest.approx(drawn, abs=NEAR), grab.label
        again, aside = hand.move(after), hand.move((after[0] + 1, after[1] + 1))
        for name, value in values.items():
            assert again[name] == pytest.approx(value, rel=1e-12, abs=0.1 * abs(aside[name] - value)), name
    return True


@pytest.mark.parametrize(("stiff", "exponent"), [(2.0, 0), (2e10, -6), (2e-12, 6)])
def test_the_mode_that_is_not_taken_goes_on_with_the_velocity_that_it_had(stiff: float, exponent: int) -> None:
    """The slope of its part of the motion gives the velocity, for times in s, in µs and in 10⁶ s."""
    now = fitted(SCENES["coupled"](k1=stiff, k2=stiff, v1_0=0.1 * stiff**0.5).value)
    time, place = now.shown.axes["t"].ruler, now.shown.axes["x"].ruler
    assert (time.exponent, place.exponent) == (exponent, 0)
    at, gap = 0.3 * time.end, 1e-6 * time.end
    seen = played(now.shown, [at - gap, at + gap])
    going = 0
    for shape, grab in grabs(now.kind):
        if velocities := [one for one in grab.start if one.of.startswith("v")]:
            begun = Hand(now, shape, wide=True, t=at).take()
            for one in velocities:
                before, after = seen[f"x{one.of.removeprefix('v')}"]
                slope = (after - before) / (2 * gap) / 10.0**exponent
                assert begun[one.parameter] == pytest.approx(slope, rel=1e-6), grab.label
                going += 1
    assert going == 8

"""The amount of text on the first screen."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from tests.browser.texts import pieces
from tests.browser.waiting import seek, turned

pytestmark = pytest.mark.browser
MOST = {
    "oscillator": 99,
    "energy": 97,
    "analogues": 97,
    "phugoid": 95,
    "damped": 107,
    "driven": 109,
    "coupled": 108,
    "modes": 101,
    "forced": 110,
    "absorber": 93,
    "accuracy": 180,
}
USUAL = 91
PASSING = {"New here? Ten-minute tour"}
"""The tour is offered on the first visit."""


@pytest.mark.parametrize("slug", SCENES)
def test_a_scene_opens_with_no_more_than_its_idea_needs(slug: str, turning: Page) -> None:
    turned(turning, slug, {})
    seek(turning, 0.0)
    found = pieces(turning)
    assert SCENES[slug].headline in found
    assert sum(piece not in PASSING for piece in found) <= MOST.get(slug, USUAL), found

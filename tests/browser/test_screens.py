"""How every scene lies on any screen: nothing overlaps, nothing is cut off, nothing is too small to read."""

from __future__ import annotations

from urllib.parse import parse_qs

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from components.url import write_query
from tests.browser.boxes import faults
from tests.browser.fixtures import READY
from tests.browser.views import LINKS
from tests.browser.waiting import passed, seek
from tests.scenes.checks import WHOLE
from tests.serving.server import Server

pytestmark = pytest.mark.browser
SAMPLE = ((1280, 590), (1024, 768), (844, 390), (360, 640))
GRID = (
    *SAMPLE,
    *((1280, 720), (1279, 1000), (1920, 1080), (2560, 1440), (3840, 2160), (1600, 480)),
    *((853, 480), (768, 1024), (640, 360), (600, 800), (390, 844), (320, 640), (320, 320)),
)
SIZES = GRID if WHOLE else SAMPLE
MEANT: dict[str, tuple[str, ...]] = {
    # Rows of stability whose limits nearly coincide are named on one line.
    "accuracy": ("Explicit Euler", "Newmark"),
    # The loops' names stand at their right, beyond which a narrow screen ends.
    "phugoid": ("cut: block stage: loop",),
}
"""What overlaps on purpose, or is known to, by scene."""
STAYING = """() => {
  scrollTo(0, 500)
  const staying = [...document.querySelectorAll(".paper *, .nav")].filter(one =>
    getComputedStyle(one).position === "sticky" && one.checkVisibility() && one.getBoundingClientRect().height)
  const heights = staying.map(one => one.getBoundingClientRect().height)
  scrollTo(0, 0)
  return heights.reduce((sum, height) => sum + height, 0) / innerHeight
}"""


PRESETS = [write_query(scene(**values)) for scene in SCENES.values() for values in scene.presets.values() if values]


@pytest.mark.parametrize("link", LINKS + PRESETS * WHOLE)
def test_nothing_overlaps_is_cut_or_too_small(link: str, page: Page, server: Server) -> None:
    page.goto(f"{server.url}?{link}")
    page.wait_for_function(READY)
    meant = MEANT.get(parse_qs(link)["scene"][0], ())
    found = []
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        seek(page, 0.0)
        told = [fault for fault in faults(page) if not any(words in fault for words in meant)]
        found += [f"{width} x {height}: {fault}" for fault in told]
        if page.evaluate(STAYING) > 0.45:
            found.append(f"{width} x {height}: what stays in sight covers {page.evaluate(STAYING):.0%}")
    assert not found, "\n".join(found)

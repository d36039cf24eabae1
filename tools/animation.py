"""`python -m tools.animation` makes the animation of README.md, docs/coupled.webp, from the current page."""

from __future__ import annotations

import io
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

from tests.browser.fixtures import READY
from tests.browser.waiting import passed, played
from tests.serving.server import serving
from tools.browsers.chromium import find
from tools.pictures import STOP

ROOT = Path(__file__).parents[1]
MOVING = ROOT / "docs" / "coupled.webp"
LINK = "scene=coupled&m1=1&k1=0.96&m2=0.04&k2=0.04&x1_0=0.2"
WIDTH, HEIGHT = 1280, 800
SIZE = (960, 600)
FRAMES, SECONDS = 60, 5.0
MOST_BYTES = 1_000_000


def frames(page: Page) -> list[Image.Image]:
    """Take pictures of the page at equal steps of its time window."""
    found = []
    for frame in range(FRAMES):
        page.evaluate(STOP, frame / FRAMES)
        played(page)
        passed(page)
        found.append(Image.open(io.BytesIO(page.screenshot(caret="hide"))).convert("RGB").resize(SIZE))
    return found


def moving() -> bytes:
    """Return the animation, which repeats for ever."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        with serving(Path(name) / "log") as server:
            page = browser.new_page(
                viewport={"width": WIDTH, "height": HEIGHT}, bypass_csp=True, reduced_motion="reduce"
            )
            page.goto(f"{server.url}?{LINK}")
            page.wait_for_function(READY)
            first, *rest = frames(page)
        browser.close()
    text = io.BytesIO()
    first.save(
        text,
        "WEBP",
        save_all=True,
        append_images=rest,
        duration=int(1000 * SECONDS / FRAMES),
        loop=0,
        quality=50,
        method=6,
    )
    return text.getvalue()


if __name__ == "__main__":
    content = moving()
    if len(content) > MOST_BYTES:
        raise SystemExit(f"{len(content)} bytes are too many for README.md: {MOST_BYTES} are the most.")
    MOVING.write_bytes(content)
    print(f"{MOVING.relative_to(ROOT)}: {len(content) / 1e6:.2f} MB")

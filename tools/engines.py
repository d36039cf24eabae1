"""`python -m tools.engines FOLDER` shows each scene in Chromium, Safari's engine and Firefox, side by side.

The pictures are of a desktop and of a phone, at a fixed clock time. Look for differences between the engines.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import sync_playwright

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import FRAMES, PASSED
from tests.serving.server import serving
from tools.browsers import chromium, firefox, webkit
from tools.pictures import INSTANT, SIZES, STOP

SCREENS = ("desk", "phone")
DRIVEN: tuple[tuple[str, Any, Any], ...] = (
    ("WebKit", webkit.find, webkit.WebKit),
    ("Firefox", firefox.find, firefox.Firefox),
)


def shoot(window: Any, url: str, folder: Path, engine: str, slugs: list[str]) -> None:
    """Take the pictures of one engine, as FOLDER/coupled-desk-Firefox.png."""
    for screen in SCREENS:
        width, height = SIZES[screen]
        window.set_viewport_size({"width": width, "height": height})
        for slug in slugs:
            window.goto(f"{url}?scene={slug}")
            window.wait_for_function(READY)
            window.evaluate(STOP, INSTANT)
            window.evaluate(FRAMES, 1)
            window.evaluate(PASSED, 5)
            window.screenshot(path=folder / f"{slug}-{screen}-{engine}.png")


def joined(pictures: list[Path]) -> Image.Image:
    """Join pictures side by side, in the order of the engines."""
    opened = [Image.open(path).convert("RGB") for path in pictures]
    whole = Image.new("RGB", (sum(one.width for one in opened), max(one.height for one in opened)), "white")
    left = 0
    for one in opened:
        whole.paste(one, (left, 0))
        left += one.width
    return whole


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tools.engines", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", nargs="*", choices=[*SCENES], default=[*SCENES], help="scenes: coupled damped")
    options = parser.parse_args()
    engines = ["Chromium"]
    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        rough = Path(name)
        with serving(rough / "log", environment={"ARRIVALS": "1000000", "SESSIONS": "100000"}) as server:
            browser = playwright.chromium.launch(executable_path=chromium.find())
            shoot(browser.new_page(bypass_csp=True), server.url, rough, "Chromium", options.only)
            browser.close()
            for engine, find, window in DRIVEN:
                if path := find():
                    engines.append(engine)
                    (rough / engine).mkdir()
                    driven = window(path, rough / engine)
                    shoot(driven, server.url, rough, engine, options.only)
                    driven.close()
                else:
                    print(f"{engine} is not installed: make browsers installs it.")
        options.folder.mkdir(parents=True, exist_ok=True)
        for slug in options.only:
            for screen in SCREENS:
                pictures = [rough / f"{slug}-{screen}-{engine}.png" for engine in engines]
                joined(pictures).save(options.folder / f"{slug}-{screen}.png")
    print(f"{', '.join(engines)}, from left to right, in {options.folder}")


if __name__ == "__main__":
    main()

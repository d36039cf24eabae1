"""`python -m tools.pictures shoot FOLDER` takes a picture of everything that the lecture shows, at a fixed clock time.

`python -m tools.pictures compare BEFORE AFTER` lists differences, for a change that must keep every picture. The server
is the one in the current checkout.
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PIL import Image
from playwright.sync_api import Browser, Page, sync_playwright

from components.scenes import SCENES
from components.state.page_state import fitted
from components.walks.registry import all_walks
from tests.browser.fixtures import READY
from tests.browser.looks import seen
from tests.browser.waiting import passed, played
from tests.serving.server import serving
from tools.browsers.chromium import find

SIZES = {"desk": (1280, 720), "phone": (390, 844), "hall": (1920, 1080)}
INSTANT = 0.3
"""Fraction of the time window at which all motions have left their initial positions."""
LEVELS = 32
"""A pixel counts as changed from this difference on (of 255)."""
SHARE = 0.001
"""Fraction of changed pixels from which a picture is listed."""
TRIES = 20
"""Largest number of attempts until two pictures in a row are equal."""
BEFORE = "localStorage.setItem('seed', '1')"
"""A script that fixes the seed, so that options are always in the same order."""
STOP = """share => {
  const {clock} = oscillations
  clock.playing = false
  clock.seek(share * clock.end)
  return document.fonts.ready.then(() => true)
}"""
COVERED = "oscillations.shown.state.covered.length"
ANSWERED = f"before => oscillations.walks.walk?.lesson && (!{COVERED} || {COVERED} < before)"
"""An answer removes covers, except covers for the answers of later steps."""


class Sight(NamedTuple):
    """A page to take a picture of: its name, its link, and whether it is a step of a walk, shown with its answer
    too."""

    name: str
    link: str
    asks: bool = False


def views() -> Iterator[Sight]:
    """Each scene in each word of its choices and in each preset, and each step of each walk."""
    for slug, scene in SCENES.items():
        for chosen in seen(scene):
            link = fitted(chosen).query
            yield Sight(link, link)
        for label, values in scene.presets.items():
            yield Sight(f"scene={slug} preset {label}", fitted(scene.at(values)).query)
    for name, walk in all_walks((), SCENES).items():
        for step in walk.steps:
            yield Sight(f"walk {step.id}", f"walk={name}&step={step.id}", asks=True)


def shoot(folder: Path, only: str) -> int:
    """Save a picture of each view whose name matches `only` in each screen size, and return their number."""
    folder.mkdir(parents=True, exist_ok=True)
    wanted = [view for view in views() if re.search(only, view.name)]
    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        with serving(Path(name) / "log", environment={"ARRIVALS": "1000000", "SESSIONS": "100000"}) as server:
            return sum(_shoot_all(browser, server.url, folder, wanted, screen) for screen in SIZES)


def _shoot_all(browser: Browser, url: str, folder: Path, wanted: list[Sight], screen: str) -> int:
    """Take the pictures of one screen, all in one page."""
    width, height = SIZES[screen]
    # Playwright's waiting for an expression is an eval, which the page forbids.
    context = browser.new_context(
        viewport={"width": width, "height": height}, bypass_csp=True, reduced_motion="reduce", color_scheme="light"
    )
    context.add_init_script(BEFORE)
    page, count = context.new_page(), 0
    for view in wanted:
        page.goto(f"{url}?{view.link}{'&projector' * (screen == 'hall')}")
        page.wait_for_function(READY)
        if view.asks:
            page.wait_for_function("oscillations.walks.walk?.card?.page === oscillations.page")
        # On a phone a step's card scrolls to its question: a picture of the whole page would move it.
        _take(page, _path(folder, view.name, screen), not view.asks)
        count += 1
        if view.asks:
            covered = page.evaluate(COVERED)
            page.evaluate("oscillations.walks.walk.show(true)")
            page.wait_for_function(ANSWERED, arg=covered)
            _take(page, _path(folder, f"{view.name} answered", screen), False)
            count += 1
    context.close()
    return count


def _path(folder: Path, name: str, screen: str) -> Path:
    return folder / f"{re.sub(r'[^a-zA-Z0-9._=-]+', '-', name)}-{screen}.png"


def _take(page: Page, path: Path, whole: bool = True) -> None:
    """Save a picture of a page, or of its visible part, when nothing more is drawn."""
    page.evaluate(STOP, INSTANT)
    played(page)
    last = b""
    for _ in range(TRIES):
        passed(page)
        picture = page.screenshot(full_page=whole, animations="disabled", caret="hide")
        if picture == last:
            path.write_bytes(picture)
            return
        last = picture
    raise RuntimeError(f"{path.stem} does not come to rest")


def differing(before: Path, after: Path) -> Iterator[str]:
    """Return the differences between two folders of pictures, one line for each picture."""
    old, new = ({path.name: path for path in folder.glob("*.png")} for folder in (before, after))
    if not old and not new:
        yield "There are no pictures."
    for name in sorted(old.keys() | new.keys()):
        if name not in old or name not in new:
            yield f"{name}: only {'after' if name in new else 'before'}"
        elif fault := _difference(old[name], new[name]):
            yield f"{name}: {fault}"


def _difference(before: Path, after: Path) -> str:
    """Return the difference of two pictures as text; "" if the eye sees none."""
    old, new = (np.asarray(Image.open(path).convert("RGB"), dtype=np.int16) for path in (before, after))
    if old.shape != new.shape:
        return f"{old.shape[1]} x {old.shape[0]} before, {new.shape[1]} x {new.shape[0]} after"
    apart = (np.abs(old - new) > LEVELS).any(axis=2)
    if apart.mean() <= SHARE:
        return ""
    rows, columns = apart.any(axis=1).nonzero()[0], apart.any(axis=0).nonzero()[0]
    return f"{apart.mean():.2%} of the pixels, from ({columns[0]}, {rows[0]}) to ({columns[-1]}, {rows[-1]})"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tools.pictures", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    shooting = commands.add_parser("shoot", help="take the pictures of this checkout")
    shooting.add_argument("folder", type=Path)
    shooting.add_argument(
        "--only", default="", metavar="PATTERN", help="views whose name has it: scene=coupled, walk d31"
    )
    comparing = commands.add_parser("compare", help="list what differs between two folders")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    options = parser.parse_args()
    if options.command == "shoot":
        begun = time.monotonic()
        count = shoot(options.folder, options.only)
        print(f"{count} pictures in {time.monotonic() - begun:.0f} s")
        sys.exit(not count)
    found = list(differing(options.before, options.after))
    print("\n".join(found) or "No picture differs.")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()

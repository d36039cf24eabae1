"""`python -m tools.visible_text --states 200` prints all text of random states, to be read for false sentences.

Each state of `tests/states.py` is opened in Chromium; below its link comes each text of its page, on the screen or
below it, then the descriptions of its plots for screen readers.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from hypothesis import HealthCheck, Phase, given, seed, settings
from playwright.sync_api import Page, sync_playwright

from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import Link
from tests.browser.fixtures import READY
from tests.serving.server import serving
from tests.states import links
from tools.browsers.chromium import find

TEXTS = """() => {
  const lines = new Set()
  const walker = document.createTreeWalker(document.querySelector("#app"), NodeFilter.SHOW_TEXT)
  const inText = element => /^(inline|math|block math|ruby)/.test(getComputedStyle(element).display)
  const blocks = new Map()
  while (walker.nextNode()) {
    let block = walker.currentNode.parentElement
    if (!block.checkVisibility({opacityProperty: true, visibilityProperty: true})) continue
    if (block.closest("button, a")) continue
    while (!block.matches("text, td, th") && inText(block)) block = block.parentElement
    blocks.set(block, (blocks.get(block) ?? "") + walker.currentNode.textContent)
  }
  for (const text of blocks.values()) lines.add(text.replace(/\\s+/g, " ").trim())
  for (const plot of document.querySelectorAll("[role=img][aria-label]")) lines.add(`[${plot.ariaLabel}]`)
  return [...lines].filter(line => /[a-z]{3}/i.test(line))
}"""
"""Texts of at least one word, a line for each block."""


def states(count: int, start: int, slugs: list[str], decades: float) -> list[Link]:
    """Return so many random states, in equal parts of the scenes."""
    found: list[Link] = []
    for slug in slugs:

        def keep(link: Link) -> None:
            found.append(link)

        drawing: Any = given(links(SCENES[slug], decades))
        most = settings(max_examples=-(-count // len(slugs)), phases=[Phase.generate], database=None, deadline=None)
        test: Any = settings(most, suppress_health_check=list(HealthCheck))(drawing(keep))
        seed(start)(test)()
    return found


def texts(page: Page, url: str, query: str) -> list[str]:
    page.goto(f"{url}?{query}")
    page.wait_for_function(READY)
    return cast(list[str], page.evaluate(TEXTS))


def read(count: int, start: int, slugs: list[str], decades: float) -> Iterator[str]:
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        page = browser.new_page(viewport={"width": 1280, "height": 720}, bypass_csp=True)
        with serving(Path(folder) / "log") as server:
            for number, link in enumerate(states(count, start, slugs, decades)):
                query = opened(SCENES, link).now.query
                yield "\n".join([f"== {number} ?{query}", *texts(page, server.url, query), ""])
        browser.close()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--states", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--decades", type=float, default=2.0, help="how far numbers reach beyond their sliders")
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    given_ = parser.parse_args()
    warnings.simplefilter("ignore")
    for text in read(given_.states, given_.seed, given_.scenes, given_.decades):
        print(text, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

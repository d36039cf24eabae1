"""axe-core finds no fault. The contrast of texts over drawings, which axe cannot decide, is checked here."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import axe_playwright_python
import pytest
from playwright.sync_api import Page

from tests.browser.fixtures import READY
from tests.browser.views import LINKS, screens
from tests.browser.waiting import seek
from tests.grids import spread
from tests.serving.server import Server

pytestmark = pytest.mark.browser

AXE = (Path(axe_playwright_python.__file__).parent / "axe.min.js").read_text(encoding="utf-8")
# Results are marked on the page, because axe names texts by positions that change if a stage changes its size.
RUN = """async () => {
  const wanted = {resultTypes: ["violations", "incomplete"], elementRef: true}
  const {violations, incomplete} = await axe.run(document, wanted)
  let found = 0
  return [...violations, ...incomplete].flatMap(({id, nodes}, i) => nodes.map(({element, html}) => {
    element.dataset.found ??= ++found
    const target = `[data-found="${element.dataset.found}"]`
    return {id, html: html.slice(0, 160), target, fault: i < violations.length}
  }))
}"""
# A drawing has no background of its own. Its texts are on paper, those of a mass on the mass; a halo of paper separates
# them from lines.
CONTRAST = """targets => {
  const channel = c => (c /= 255, c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  const parsed = colour => colour.match(/[\\d.]+/g).map(Number)
  const light = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b)
  const opaque = colour => colour.startsWith("rgb") && (parsed(colour)[3] ?? 1) === 1
  const ground = one => {
    const label = one.closest("text.on")
    for (let at = label; at; at = at.previousElementSibling ?? at.parentElement?.previousElementSibling) {
      const filled = [at, ...at.children].filter(part => part.matches(".mass, .body, .fill, circle, rect"))
      const fill = filled.map(part => getComputedStyle(part).fill).find(opaque)
      if (fill) return fill
    }
    for (let at = one; at; at = at.parentElement) {
      const {backgroundColor} = getComputedStyle(at)
      if (opaque(backgroundColor)) return backgroundColor
    }
  }
  return targets.map(selector => {
    const one = document.querySelector(selector), style = getComputedStyle(one)
    const [a, b] = [one instanceof SVGElement ? style.fill : style.color, ground(one)].map(c => light(parsed(c)))
    const large = parseFloat(style.fontSize) >= (style.fontWeight >= 600 ? 18.66 : 24)
    return {ratio: (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), least: large ? 3 : 4.5}
  })
}"""


def faults(page: Page) -> list[Any]:
    page.evaluate(AXE)
    found = page.evaluate(RUN)
    open_ = [one for one in found if not one["fault"] and one["id"] == "color-contrast"]
    contrasts = page.evaluate(CONTRAST, [one["target"] for one in open_])
    pale = [one for one, of in zip(open_, contrasts, strict=True) if of["ratio"] < of["least"]]
    return [one for one in found if one not in open_] + pale


@pytest.mark.parametrize("link", spread(LINKS))
def test_no_violation_and_nothing_undecided(new_page: Callable[..., Page], server: Server, link: str) -> None:
    for theme, width, height in screens(link):
        page = new_page(width, height, color_scheme=theme, reduced_motion="reduce")
        page.goto(f"{server.url}?{link}")
        page.wait_for_function(READY)
        seek(page, 0.0)  # a moving text would be a different one at the second look
        assert faults(page) == [], (link, theme, width)


def test_the_choice_of_pictures_has_no_fault(new_page: Callable[..., Page], open_scene: Callable[..., Page]) -> None:
    page = open_scene(new_page(reduced_motion="reduce"), scene="coupled")
    page.get_by_role("button", name="Pictures").click()
    page.get_by_role("dialog").wait_for()
    assert faults(page) == []

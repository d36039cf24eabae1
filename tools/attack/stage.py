"""Extreme pictures in the browser: the page never shows NaN, Infinity or undefined."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from playwright.sync_api import Page, sync_playwright

from components.scene import Scene
from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import Link
from components.state.page_state import fitted
from tools.attack.extremes import ExtremeValues, values
from tools.attack.result import AttackResult
from tools.browsers.chromium import find

READY = "document.documentElement.dataset.ready === 'true'"
SHOW = r"""async data => {
  const [sheet] = oscillations.sheets.known.keys()  // as this server has it: Bokeh counts its models
  oscillations.messages.receive({sheet, data: Uint8Array.from(data).buffer})
  await oscillations.messages.handled
  await oscillations.turning
  const {page} = oscillations, fault = /NaN|Infinity|undefined/
  for (const share of [0, 0.37, 1]) {
    page.clock.seek(share * page.clock.end)
    page.draw(page.clock.t)
    for (const one of document.querySelectorAll("svg *")) {
      const wrong = [...one.attributes].find(({value}) => fault.test(value))
      if (wrong) return `${one.tagName} ${one.getAttribute("class")}: ${wrong.name}=${wrong.value.slice(0, 60)}`
    }
    for (const one of document.querySelectorAll("#app *")) {
      if (!one.children.length && fault.test(one.textContent)) return `${one.className}: ${one.textContent}`
    }
  }
  page.clock.tick(page.clock.last + 16)
  return Number.isFinite(page.clock.t) ? "" : `the clock: ${page.clock.t}`
}"""


def attack(url: str, size: int, start: int) -> Iterator[AttackResult]:
    """Draw each scene in Chromium with extreme pictures as the server would send them."""
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=find())
        for slug, scene in SCENES.items():
            page = chromium.new_page(bypass_csp=True)
            page.goto(f"{url}?scene={slug}")
            page.wait_for_function(READY)
            faults = list(faults_of(page, scene, size, start))
            yield AttackResult(f"{slug}: {size} extreme pictures in Chromium", not faults, "\n".join(faults))
            page.close()
        chromium.close()


def faults_of(page: Page, scene: type[Scene], size: int, start: int) -> Iterator[str]:
    """Yield the faults of pages, each with its link."""
    for query, packet in pictures(scene, size, start):
        fault = page.evaluate(SHOW, list(packet["data"]))
        if fault:
            yield f"/?{query}  {fault}"


def pictures(scene: type[Scene], size: int, start: int) -> list[tuple[str, dict[str, Any]]]:
    """Return links with extreme values that the scene can draw, and the message that opens each."""
    found: dict[str, dict[str, Any]] = {}

    @seed(start)
    @settings(
        max_examples=size,
        derandomize=False,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(values(scene))
    def draw(link: ExtremeValues) -> None:
        session = opened(SCENES, Link(scene.slug, link))
        found[fitted(session.now.scene).query] = session.opening()

    draw()
    return list(found.items())

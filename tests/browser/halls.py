"""Faults of a page in a hall: parts that scroll, are cut off, overlap, or are too small for the last row."""

from __future__ import annotations

from collections.abc import Iterator

from playwright.sync_api import Page

from tests.browser.looks import faults
from tests.browser.waiting import passed, seek

LAID = "oscillations.walks.walk.card?.page === oscillations.page"
TAUGHT = (
    "oscillations.walks.walk.lesson && "
    "oscillations.shown.state.covered.length === oscillations.walks.walk.step.reveals.covered.length"
)
"""A step is laid out and its answer is visible."""
MEANT = "under pill-mark"
"""Words at the mark that the student has set. They may overlap others."""
SCROLLED = """() => [...document.querySelectorAll("body *")].filter(part => {
  if (part instanceof SVGElement || part.closest(".figure, .in-force, .heard") || !part.checkVisibility()) return false
  const {overflowX, overflowY} = getComputedStyle(part)
  const [wide, high] = [part.scrollWidth - part.clientWidth, part.scrollHeight - part.clientHeight]
  return (overflowY !== "visible" && high > 1) || (overflowX !== "visible" && wide > 1)
}).map(part => `${part.tagName} ${part.className}: ${part.scrollWidth - part.clientWidth} px to the side, ` +
  `${part.scrollHeight - part.clientHeight} px down`)"""
"""Parts whose content is larger than their box."""
LARGE = (
    *("h1.waits", "h1:not(.waits)", ".asked-line", ".answers .name", ".card .why", ".act"),
    *(".corner-words b", ".vote-count", ".votes .all", ".scale text", ".stage text", ".block .head"),
)
"""Parts that everybody reads: question, answers, explanation, drawings; the code of a class, and its answers."""
SMALL = """([least, kinds]) => {
  const size = part => parseFloat(getComputedStyle(part).fontSize) * (part.getScreenCTM?.().a ?? 1)
  return kinds.flatMap(kind => [...document.querySelectorAll(kind)]
    .filter(part => part.checkVisibility() && size(part) < least - 0.01)
    .map(part => `${kind} is small: ${part.textContent}`))
}"""
LOW = """least => [...document.querySelectorAll(".plot-area")]
  .map(area => [area.checkVisibility() ? area.getBoundingClientRect().height : least, area])
  .filter(([height]) => height < least)
  .map(([height, area]) => `a plot is ${height.toFixed()} px high: ${area.parentElement.textContent.slice(0, 20)}`)"""
"""Plots that are lower than this many pixels, and therefore unreadable."""


def seen(page: Page, height: int, when: str) -> Iterator[str]:
    """The faults of the page in a window of this height."""
    passed(page)
    seek(page, 0.0)
    small = [22 * height / 1080, 19 * height / 1080]
    found = [*faults(page, *small), *page.evaluate(SCROLLED), *page.evaluate(SMALL, [27 * height / 1080, LARGE])]
    found += page.evaluate(LOW, height / 30)
    yield from (f"{when} Show: {fault}" for fault in found if MEANT not in fault)

"""Faults of a page in a hall: parts that scroll, are cut off, overlap, or are too small for the last row."""

from __future__ import annotations

import io
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Page

from tests.browser.boxes import faults
from tests.browser.waiting import passed, seek

Flags = NDArray[np.bool_]
PAPER = """(({left, top, right, bottom}) => [left, top, right, bottom])(
  document.querySelector(".paper").getBoundingClientRect())"""
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


CELL = 12
"""Pixels of the squares in which drawn content is searched."""


def empty(page: Page) -> float:
    """The share of the paper that the largest empty rectangle takes."""
    shot = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB")).astype(int)
    left, top, right, bottom = map(int, page.evaluate(PAPER))
    drawn = np.abs(shot[top:bottom, left:right] - shot[top + 2, left + 2]).max(axis=2) > 12
    rows, columns = (size // CELL for size in drawn.shape)
    free = ~drawn[: rows * CELL, : columns * CELL].reshape(rows, CELL, columns, CELL).any(axis=(1, 3))
    largest, heights = 0, np.zeros(columns, int)
    for row in free:
        heights = np.where(row, heights + 1, 0)
        largest = max(largest, *(height * _widest(heights >= height) for height in set(heights.tolist())))
    return largest / (rows * columns)


def _widest(free: Flags) -> int:
    """The length of the longest run of free squares."""
    return max(len(run) for run in "".join("x" if one else " " for one in free).split(" "))

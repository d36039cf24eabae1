"""The pieces of text that a page shows: each sentence, formula, number at an axis or in a field is one piece."""

from __future__ import annotations

from typing import cast

from playwright.sync_api import Page

PIECES = """() => {
  const inText = element => /^(inline|math|block math)/.test(getComputedStyle(element).display)
  // An SVG text inside a group that is not drawn passes for visible, but has no size.
  const stands = element => {
    const {width, height, top} = element.getBoundingClientRect()
    return element.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
      width > 1 && height > 1 && top < innerHeight
  }
  const pieces = new Map()
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
  while (walker.nextNode()) {
    const {textContent, parentElement} = walker.currentNode
    let piece = parentElement.closest("text, math, button, a") ?? parentElement
    if (!textContent.trim() || !stands(parentElement)) continue
    while (!piece.matches("text, button, a") && inText(piece)) piece = piece.parentElement
    pieces.set(piece, (pieces.get(piece) ?? "") + textContent)
  }
  const fields = [...document.querySelectorAll("input:not([type=range])")].filter(stands)
  // Bokeh draws the numbers under a plot on its canvas.
  const plots = oscillations.page.plots.filter(plot => plot.block.x_labels && stands(plot.host))
  return [
    ...pieces.values(),
    ...fields.map(field => field.value || field.placeholder),
    ...plots.flatMap(plot => [...plot.figure.model.below[0].major_label_overrides.values()]),
  ].map(text => text.replace(/\\s+/g, " ").trim()).filter(Boolean)
}"""


def pieces(page: Page) -> list[str]:
    """The texts that are readable without scrolling or opening anything."""
    return cast(list[str], page.evaluate(PIECES))

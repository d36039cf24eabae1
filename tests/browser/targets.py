"""The sizes of everything that is pressed or dragged: the area around the middle of each that a pointer hits, to the
pixel.
"""

from __future__ import annotations

from typing import cast

from playwright.sync_api import Page

TARGETS = r"""least => {
  const pressed = "a[href], button, input, summary, [role=slider]"
  const moved = ".grip, .pill"
  const faults = []
  const seen = one => one.checkVisibility({opacityProperty: true, visibilityProperty: true}) && !one.disabled
  for (const one of document.querySelectorAll(pressed)) {
    // A link in a sentence is as high as its line.
    if (!seen(one) || one.closest(".skip, .words, p") || one.matches(".take")) continue
    one.scrollIntoView({block: "center", inline: "center"})
    const {left, right, top, bottom} = one.getBoundingClientRect()
    if (right - left < 1 || bottom - top < 1) continue
    const [x, y] = [(left + right) / 2, (top + bottom) / 2]
    const hits = (dx, dy) => {
      const hit = document.elementFromPoint(x + dx, y + dy)
      // Of handles that lie on each other, as their values do, the upper one takes the hand.
      const shared = one.matches(moved) && hit?.closest(moved)
      return hit && (one.contains(hit) || shared || (hit.control ?? hit.closest("label")?.control) === one)
    }
    const reach = (dx, dy) => {
      let far = 0
      while (far < least && hits(dx * far, dy * far)) far += 0.5
      return far
    }
    const [wide, high] = [reach(-1, 0) + reach(1, 0), reach(0, -1) + reach(0, 1)]
    if (Math.min(wide, high) >= least - 1) continue
    const name = one.getAttribute("aria-label") ?? one.name ?? ""
    faults.push(`${one.className || one.tagName}: ${name || one.textContent.trim()} ${wide} x ${high}`)
  }
  scrollTo(0, 0)
  return faults
}"""


def small_targets(page: Page, least: int) -> list[str]:
    """The targets that are smaller than this many pixels in width or height."""
    return cast(list[str], page.evaluate(TARGETS, least))

"""Texts over the plots of a page: those that a curve crosses, and those that leave their plot."""

from __future__ import annotations

from typing import cast

from playwright.sync_api import Page

TOUCHED = r"""() => {
  const isSeen = part => part.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
    part.getBoundingClientRect().width > 1
  const AIR = 0.25 // of the height of a line, above and below its letters
  const lettersOf = part => {
    const {left, right, top, bottom, height} = part.getBoundingClientRect()
    return {left: left + 1, right: right - 1, top: top + AIR * height, bottom: bottom - AIR * height}
  }
  const named = part => part.textContent.trim().replace(/\s+/g, " ")
  const plots = oscillations.page.plots.filter(({host, absent, box}) => !absent && box && isSeen(host))
  const linesOf = plot => {
    const {left, top} = plot.host.getBoundingClientRect(), {frame} = plot, scale = plot.over.getScreenCTM().a
    const at = (x, y) => [left + scale * plot.px(x), top + scale * plot.py(y)]
    const within = ([x, y]) => x >= left + scale * frame.left && x <= left + scale * (frame.left + frame.width) &&
      y >= top + scale * frame.top && y <= top + scale * (frame.top + frame.height)
    return plot.block.curves.flatMap(curve => {
      const {[curve.x]: xs, [curve.y]: ys} = plot.view.columns[curve.source] ?? {}
      if (!ys?.length || plot.hidden.has(curve.group) || curve.width === "none") return []
      const points = []
      for (let i = 0; i < ys.length; i++) {
        const end = at(xs[i], ys[i]), start = i ? at(xs[i - 1], ys[i - 1]) : end
        const count = Math.min(Math.ceil(Math.hypot(end[0] - start[0], end[1] - start[1]) / 2), 200) || 1
        for (let n = 1; n <= count; n++) {
          const share = n / count
          const point = [start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])]
          if (within(point)) points.push(point)
        }
      }
      return [{name: `${plot.block.name}.${curve.y}`, points}]
    })
  }
  const lines = plots.flatMap(linesOf)
  const faults = []
  const texts = [...document.querySelectorAll(".plot-area :is(.over text, .flag, .stage text), .block.stage text")]
  for (const text of texts.filter(isSeen)) {
    if (!named(text)) continue
    const box = lettersOf(text)
    for (const {name, points} of lines) {
      const over = points.filter(([x, y]) => x > box.left && x < box.right && y > box.top && y < box.bottom)
      if (over.length) faults.push(`“${named(text)}” is crossed by ${name}`)
    }
    if (!text.closest(".plot-area")) continue
    const {top, bottom} = text.closest(".block").getBoundingClientRect()
    const paper = text.closest(".paper").getBoundingClientRect()
    const {left, right} = paper.width ? paper : {left: 0, right: innerWidth}
    const far = Math.max(left - box.left, box.right - right, top - box.top, box.bottom - bottom)
    if (far > 1) faults.push(`“${named(text)}” is ${far.toFixed()} px outside its plot`)
  }
  return faults
}"""


def touched(page: Page) -> list[str]:
    """A sentence for each text that a curve crosses, or that is outside its plot."""
    return cast(list[str], page.evaluate(TOUCHED))

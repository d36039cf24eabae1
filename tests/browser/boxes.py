"""The boxes of everything that is read or touched on a page, and faults in its layout: overlaps, cuts, small parts."""

from __future__ import annotations

from typing import cast

from playwright.sync_api import Page

FAULTS = r"""([least, leastIndex]) => {
  const faults = []
  const style = element => getComputedStyle(element)
  const hasSize = ({width, height}) => width > 1 && height > 1
  // An SVG text inside a group that is not drawn passes for visible, but has no size.
  const stands = element =>
    element.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
    hasSize(element.getBoundingClientRect())
  const scrollers = new Map()
  const scroller = element => {
    if (!element || element === document.body) return null
    if (!scrollers.has(element)) {
      const {overflowX, overflowY, display} = style(element)
      const holds = display !== "contents" && /auto|scroll|hidden|clip/.test(overflowX + overflowY)
      scrollers.set(element, holds && !(element instanceof SVGElement) ? element : scroller(element.parentElement))
    }
    return scrollers.get(element)
  }
  const named = ({owner, text}) => {
    const place = owner.closest(".block, .group, .transport, .nav, .panel, .page")
    return `${(place?.getAttribute("class") ?? "").trim()}: ${text.replace(/\s+/g, " ")}`
  }
  const pieces = new Map()
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
  const range = document.createRange()
  while (walker.nextNode()) {
    const node = walker.currentNode, element = node.parentElement
    const owner = element.closest("text, math, td, th") ?? element
    if (!node.textContent.trim() || !stands(element) || !stands(owner) || element.closest("option, .figure")) continue
    range.selectNodeContents(node)
    const piece = pieces.get(owner) ?? {owner, text: "", boxes: []}
    piece.text += node.textContent
    piece.boxes.push(...[...range.getClientRects()].filter(hasSize))
    pieces.set(owner, piece)
    const size = parseFloat(style(element).fontSize) * (element.getScreenCTM?.().a ?? 1)
    const isIndex = element.closest("sub, sup, .sub, msub, msup, msubsup, mover, mfrac, tspan")
    if (size < (isIndex ? leastIndex : least) - 0.01) faults.push(`small, ${size.toFixed(1)} px: ${named(piece)}`)
  }
  const texts = [...pieces.values()]
  const controls = [...document.querySelectorAll("button, input, summary, .pill, .flag, nav a")].filter(stands)
  for (const field of controls) {
    if (field.matches("input:not([type=range])") && field.scrollWidth > field.clientWidth + 1)
      faults.push(`cut in its field: ${field.name} ${field.value}`)
  }
  if (document.documentElement.scrollWidth > innerWidth) faults.push("the page scrolls sideways")

  const wide = holder => holder.scrollWidth > holder.clientWidth + 1 && style(holder).overflowX !== "hidden"
  const parts = controls.map(owner => ({owner, text: owner.getAttribute("aria-label") ?? owner.textContent,
                                       boxes: [owner.getBoundingClientRect()]}))
  const staying = [...document.querySelectorAll(".paper *")]
    .filter(part => style(part).position === "sticky" && stands(part))
    .map(part => ({part, box: part.getBoundingClientRect()}))
  const isCut = ({left, right}, frame) => left < frame.left - 1.5 || right > frame.right + 1.5
  for (const piece of [...texts, ...parts]) {
    const holder = scroller(piece.owner)
    const frame = holder?.getBoundingClientRect() ?? {left: 0, right: innerWidth, top: -Infinity, bottom: Infinity}
    // What a list that scrolls along holds beyond its edge is not cut off.
    const isList = holder?.matches(".tabs, .tiles, .chips, .mode-row, .roles, .words, .table, .choice, .head, .group")
    if (isList && wide(holder)) piece.gone = true
    else if (piece.boxes.some(box => isCut(box, frame))) faults.push(`cut: ${named(piece)}`)
    piece.boxes = piece.boxes.filter(({top, bottom}) => bottom > frame.top && top < frame.bottom)
    if (!piece.boxes.length) piece.gone = true
    // Nor is what lies under a part that stays in sight.
    const lies = ({top, bottom}, over) => top < over.bottom && bottom > over.top
    for (const {part, box} of staying)
      if (!part.contains(piece.owner) && piece.boxes.some(one => lies(one, box))) piece.gone = true
  }

  const seen = texts.filter(piece => !piece.gone)
  // Whatever is clicked through, what lies uppermost at the foot of a text is that text, or can be seen through.
  const reached = document.head.appendChild(document.createElement("style"))
  reached.textContent = "*:not(.pointer) { pointer-events: auto !important }"
  const isClear = colour => /^(none|transparent|rgba\(.*, 0\))$/.test(colour)
  const hides = (part, owner) => {
    if (part instanceof SVGRectElement && !isClear(style(part).fill)) return part
    for (; part && !part.contains(owner); part = part.parentElement)
      if (!isClear(style(part).backgroundColor)) return part
  }
  for (const piece of seen) {
    const {left, width, bottom, height} = piece.boxes[piece.boxes.length - 1]
    const y = bottom - height / 3
    const covers = [0.2, 0.5, 0.8].map(share => left + share * width).map(x => {
      const over = document.elementFromPoint(x, y)
      const cover = over && !piece.owner.contains(over) && hides(over, piece.owner)
      // A finger's handle is hit beyond its box, where it shows nothing.
      const box = cover && cover.getBoundingClientRect()
      return box && x > box.left && x < box.right && y > box.top && y < box.bottom && cover
    })
    const cover = covers.find(cover => cover && stands(cover))
    if (cover) faults.push(`under ${cover.getAttribute("class")}: ${named(piece)}`)
  }
  reached.remove()
  const top = ({boxes}) => Math.min(...boxes.map(box => box.top))
  const bottom = ({boxes}) => Math.max(...boxes.map(box => box.bottom))
  seen.sort((one, other) => top(one) - top(other))
  // Letters do not fill their line: a quarter of it above and below is air.
  const meet = (one, other) =>
    one.left + 1.5 < other.right && other.left + 1.5 < one.right &&
    one.top + one.height / 4 < other.bottom - other.height / 4 &&
    other.top + other.height / 4 < one.bottom - one.height / 4
  for (const [i, one] of seen.entries()) {
    for (const other of seen.slice(i + 1)) {
      if (top(other) > bottom(one)) break
      if (one.owner.contains(other.owner) || other.owner.contains(one.owner)) continue
      if (one.boxes.some(box => other.boxes.some(another => meet(box, another))))
        faults.push(`overlap: ${named(one)} | ${named(other)}`)
    }
  }
  return faults
}"""


TILTED = """pairs => {
  const frames = Object.fromEntries(oscillations.plots
    .filter(({host}) => host.checkVisibility()).map(({block, host, frame, y}) => {
    const low = host.getBoundingClientRect().top + frame.top
    return [block.name, {low, high: low + frame.height, start: y.start, end: y.end}]
  }))
  const level = (one, other) => one.start === other.start && one.end === other.end &&
    Math.hypot(one.low - other.low, one.high - other.high) < 1
  return pairs.filter(pair => pair.every(name => name in frames))
    .filter(([one, other]) => !level(frames[one], frames[other])).map(pair => `${pair} are not level`)
}"""
STACKED = "getComputedStyle(document.querySelector('#view')).display === 'contents'"
LINKED = (("v", "plane"), ("a", "law"), ("well", "energy"))
"""Pairs of plots connected by lines, next to each other if there is room."""


def faults(page: Page, least: float = 12, index: float = 11) -> list[str]:
    """Return the faults in the layout of a page: parts that overlap, are cut off, leave their frame, are not level, or
    have letters below `least` pixels of the page, an index below `index`.
    """
    tilted = [] if page.evaluate(STACKED) else page.evaluate(TILTED, LINKED)
    return cast(list[str], [*page.evaluate(FAULTS, [least, index]), *tilted])

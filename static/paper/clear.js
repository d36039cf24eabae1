// Clearance of texts in a picture: of two that would overlap the later one moves up or down, or leaves.

import {surface, unitSize} from "../core/dom.js"

/**
 * @typedef {{left: number, right: number, top: number, bottom: number}} Box in units
 * @typedef {{spec: page.AnyShape, group: SVGElement, parts: SVGElement[]}} Drawn
 */

const AIR = 2 // units between texts that stand side by side
const FAR = 2.5 // lines that a text may move
const EDGE = 4 // units that it keeps from the edges of the paper, and may stand out of the picture

export class Clear {
  /** @type {Map<string, {width: number, size: number}>} by style and words: all digits are of one width */
  #sizes = new Map()

  room = {left: -Infinity, right: Infinity, bottom: Infinity}

  /** @type {Box[]} */
  standing = []

  /** @param {Drawn[]} shapes in the order of what matters most */
  constructor(shapes) {
    this.labels = shapes.flatMap(({spec, group, parts}) =>
      parts
        .filter(part => part instanceof SVGTextElement)
        .map(text => ({text: /** @type {SVGTextElement} */ (text), group, fixed: spec.kind !== "text"})),
    )
  }

  /** Sizes of texts are taken anew: their type may be another one. */
  forget() {
    this.#sizes.clear()
  }

  /**
   * Where texts may stand, when the page has changed: on the paper, and clear of those of `under`, a drawing of the
   * same size.
   * @param {Element} host @param {DOMRect} picture @param {SVGSVGElement} [under]
   */
  measure(host, picture, under) {
    this.standing = under ? this.#boxes(under) : []
    const paper = surface(host)
    if (!paper) return
    const [left, right] = [paper.left, paper.right].map(x => (x - picture.left) / unitSize())
    this.room = {left, right, bottom: picture.height / unitSize()}
  }

  /** Once a frame. What stands in a box stays there. */
  place() {
    const shown = this.labels.filter(({group}) => group.style.display === "")
    const fixed = shown.filter(label => label.fixed && label.text.style.display === "")
    const kept = [...this.standing, ...fixed.map(({text}) => this.box(text))]
    for (const {text} of shown.filter(label => !label.fixed)) {
      const box = this.#inside(text, this.box(text))
      const down = box.right > box.left ? way(box, kept, this.room.bottom) : 0
      text.style.display = down === null ? "none" : ""
      if (down === null) continue
      if (down) text.setAttribute("y", String(Number(text.getAttribute("y")) + down))
      kept.push({...box, top: box.top + down, bottom: box.bottom + down})
    }
  }

  /** Where the texts of a drawing stand. @param {SVGSVGElement} drawing */
  #boxes(drawing) {
    return [...drawing.querySelectorAll("text")].filter(({style}) => style.display === "").map(text => this.box(text))
  }

  /** Where a text stands. @param {SVGTextElement} text @returns {Box} */
  box(text) {
    const {width, size} = this.#sizeOf(text)
    const [x, y] = ["x", "y"].map(name => Number(text.getAttribute(name)))
    const left = x - width * ({middle: 0.5, end: 1}[text.getAttribute("text-anchor") ?? ""] ?? 0)
    return {left, right: left + width, top: y - 0.75 * size, bottom: y + 0.2 * size}
  }

  /** @param {SVGTextElement} text */
  #sizeOf(text) {
    const key = `${text.getAttribute("class")}: ${text.textContent?.replace(/\d/g, "0")}`
    const known = this.#sizes.get(key)
    if (known) return known
    text.style.display = ""
    const size = {width: text.getComputedTextLength(), size: parseFloat(getComputedStyle(text).fontSize)}
    this.#sizes.set(key, size)
    return size
  }

  /** @param {SVGTextElement} text @param {Box} box */
  #inside(text, box) {
    const {left, right, bottom} = this.room
    const isWide = box.right - box.left > right - left
    const across = isWide ? 0 : Math.max(Math.min(0, right - EDGE - box.right), left + EDGE - box.left)
    // What stands at the foot of the picture stays above the transport; what is drawn over plots below it is not moved.
    const up = box.top < bottom ? Math.min(0, bottom + EDGE - box.bottom) : 0
    if (across) text.setAttribute("x", String(Number(text.getAttribute("x")) + across))
    if (up) text.setAttribute("y", String(Number(text.getAttribute("y")) + up))
    return {left: box.left + across, right: box.right + across, top: box.top + up, bottom: box.bottom + up}
  }
}

/**
 * How far down, or up, a box stands clear of all others; null where it does not.
 * @param {Box} box @param {Box[]} others @param {number} foot of the picture
 */
function way(box, others, foot) {
  const near = others.filter(({left, right}) => box.left < right + AIR && left < box.right + AIR)
  const isClear = (/** @type {number} */ down) =>
    !near.some(({top, bottom}) => box.top + down < bottom - 0.01 && top < box.bottom + down - 0.01)
  if (isClear(0)) return 0
  const most = FAR * (box.bottom - box.top)
  const ways = near.flatMap(({top, bottom}) => [top - box.bottom, bottom - box.top])
  // What stands in the picture is not moved out of it: a heading is above, the transport below.
  const stays = (/** @type {number} */ down) =>
    down < 0 ? box.top + down > -EDGE : box.bottom > foot + EDGE || box.bottom + down < foot + EDGE
  const best = ways.filter(down => Math.abs(down) <= most && stays(down) && isClear(down))
  return best.length ? best.reduce((one, other) => (Math.abs(other) < Math.abs(one) ? other : one)) : null
}

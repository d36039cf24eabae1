// Label collisions on a stage: of two overlapping texts the later one moves up or down, or is hidden. A text next to a
// point of a plot also avoids the plot's lines, if possible.

import {extent, shrunk, surface, unitSize} from "../core/dom.js"
import {EVERYWHERE, meet, moved, places} from "./places.js"

/**
 * @typedef {import("./places.js").Box} Box in units
 * @typedef {{spec: page.AnyShape, group: SVGElement, parts: SVGElement[]}} DrawnShape
 * @typedef {{text: SVGTextElement, group: SVGElement, fixed: boolean, beside?: boolean, wishes?: () => Box[]}} Label
 * a text on a stage. `fixed`: it is not moved. `beside`: it belongs next to a point of a plot. `wishes`: preferred
 * boxes, if not its own position
 */

const AIR = 2 // units between neighbouring texts
const FAR = 2.5 // the most lines by which a text may move
const EDGE = 4 // units that stay free at the edges of the page, and by which a text may exceed the picture
const NEAR = 0.001 // units: a smaller shift counts as none
const POINT = 9 // units from a point to its text
const DROP = 0.37 // share of the line height by which a text is lowered to be centred on its point
const OUT = 2.5 // largest shift from the height of the point, in lines
const STEPS = [0, 1, -1, 2, -2] // shifts to try, in lines, if the text cannot avoid everything
const PIECE = 8 // units between two points with which a curve is represented
const MOST = 500 // most such points between two neighbouring points of a column
const OFF = 3 // units from such a point that texts avoid
const BASE = 0.2 // share of a text's size below its base line

export class LabelCollisions {
  /** @type {Map<string, {width: number, size: number, font: string}>} sizes by style and text, digits alike */
  #sizes = new Map()

  /** @type {Map<Element, number>} where texts begin that do not move */
  #starts = new Map()

  room = {left: -Infinity, right: Infinity, bottom: Infinity}

  /** @type {Box[]} */
  placed = []

  /** @type {Box[]} boxes along the curves of the plot under the texts */
  lines = []

  /** @type {Box[]} boxes of the flags of that plot */
  flags = []

  frame = EVERYWHERE // the frame of that plot, with the space on its right, and the space above it if it has no flags

  /** @param {DrawnShape[]} shapes the most important first */
  constructor(shapes) {
    this.dots = shapes.filter(({spec}) => spec.kind === "circle")
    /** @type {Label[]} */
    this.labels = shapes.flatMap(({spec, group, parts}) =>
      parts
        .filter(part => part instanceof SVGTextElement)
        .map(text => ({
          text: /** @type {SVGTextElement} */ (text),
          group,
          fixed: spec.kind !== "text",
          beside: spec.kind === "text" && spec.anchor === "beside",
        })),
    )
    for (const {spec, parts} of shapes)
      if (spec.kind === "text" && spec.anchor === "start" && typeof spec.x === "number")
        this.#starts.set(parts[0], spec.x)
  }

  /** The visible dots. @returns {Box[]} */
  #dots() {
    const shown = this.dots.filter(({group}) => group.style.display === "")
    return shown.map(({parts: [dot]}) => {
      const [x, y, r] = ["cx", "cy", "r"].map(name => Number(dot.getAttribute(name)))
      return around({x, y}, r)
    })
  }

  /** Measures the texts again, because their font may have changed. */
  forget() {
    this.#sizes.clear()
  }

  /**
   * The free area for texts after a change of the page: the page, without the labels of `under`, a plot of the same
   * size.
   * @param {Element} host @param {DOMRect} picture @param {Canvas} [under]
   */
  measure(host, picture, under) {
    const texts = [...(under?.over.querySelectorAll("text") ?? [])].filter(({style}) => style.display === "")
    this.placed = texts.map(text => aired(this.box(text, false)))
    if (under && this.labels.some(({beside}) => beside)) {
      const {left, top, height} = under.frame
      const flags = [...under.controls.querySelectorAll(".flag")].map(flag => flag.getBoundingClientRect())
      this.flags = flags.filter(({width}) => width).map(flag => within(flag, picture))
      const right = picture.width / unitSize() + 2 * EDGE
      this.frame = {left, right, top: this.flags.length ? top : 0, bottom: top + height}
      this.lines = under.view ? piecesOf(under) : []
    }
    const paper = surface(host)
    if (!paper) return
    const [left, right] = [paper.left, paper.right].map(x => (x - picture.left) / unitSize())
    if (left !== this.room.left || right !== this.room.right) this.forget()
    this.room = {left, right, bottom: picture.height / unitSize()}
  }

  /** Called in each animation frame: moves or hides texts that overlap. */
  place() {
    const shown = this.labels.filter(({group}) => group.style.display === "")
    const boxed = shown.filter(({fixed, text}) => fixed && text.style.display === "")
    const placed = [...this.placed, ...boxed.map(({text}) => aired(this.box(text)))]
    for (const label of shown.filter(({fixed}) => !fixed)) {
      const box = this.box(label.text)
      const place = box.right > box.left ? this.#find(label, box, placed) : box
      label.text.style.display = place ? "" : "none"
      if (!place) continue
      placed.push(place)
      this.#put(label.text, place)
    }
  }

  /** @param {Label} label @param {Box} box @param {Box[]} placed */
  #find({wishes, beside}, box, placed) {
    const line = box.bottom - box.top
    if (!beside) {
      const asked = (wishes?.() ?? [box]).map(aired)
      return places([{wishes: asked, down: FAR * line, room: this.#roomOf(box)}], placed)[0]
    }
    return this.#beside(moved(box, POINT, DROP * line), [...placed, ...this.flags])
  }

  /**
   * Finds a place next to a point that avoids all lines and dots, or as many as possible.
   * @param {Box} after it @param {Box[]} placed placed texts
   */
  #beside(after, placed) {
    const {frame} = this
    const lines = [...this.lines, ...this.#dots()]
    const line = after.bottom - after.top
    const before = moved(after, after.left - after.right - 2 * POINT, 0)
    const sides = [after, before].map(aired).filter(({left, right}) => left >= frame.left && right <= frame.right)
    const [place] = places([{wishes: sides, down: OUT * line, room: frame}], [...placed, ...lines])
    if (place) return place
    const steps = STEPS.flatMap(step => sides.map(side => moved(side, 0, step * line)))
    const free = steps.flatMap(wish => places([{wishes: [wish], room: frame}], placed)[0] ?? [])
    const crossed = free.map(box => lines.filter(piece => meet(box, piece)).length)
    return free[crossed.indexOf(Math.min(...crossed))] ?? null
  }

  /**
   * The area in which a text may move. A text in the picture stays in it, because a heading is above and the transport
   * below. A text drawn over plots below the picture may move down, and a text wider than the page keeps its x.
   * @param {Box} box
   */
  #roomOf(box) {
    const {left, right, bottom} = this.room
    const isWide = box.right - box.left > right - left - 2 * EDGE
    return {
      left: isWide ? -Infinity : left + EDGE - AIR / 2,
      right: isWide ? Infinity : right - EDGE + AIR / 2,
      top: Math.min(box.top, -EDGE),
      bottom: box.top < bottom ? bottom + EDGE : Infinity,
    }
  }

  /**
   * The box of a text of this stage, or of the plot under it.
   * @param {SVGTextElement} text @param {boolean} [isOwn] @returns {Box}
   */
  box(text, isOwn = true) {
    const {width, size} = this.#sizeOf(text, isOwn)
    const [x, y] = ["x", "y"].map(name => Number(text.getAttribute(name)))
    const left = x - width * anchored(text)
    return {left, right: left + width, top: y - 0.75 * size, bottom: y + BASE * size}
  }

  /** @param {SVGTextElement} text @param {Box} place */
  #put(text, {left, right, bottom}) {
    const [x, y] = [left + AIR / 2 + (right - left - AIR) * anchored(text), bottom - BASE * this.#sizeOf(text).size]
    for (const [name, to] of Object.entries({x, y}))
      if (Math.abs(to - Number(text.getAttribute(name))) > NEAR) text.setAttribute(name, String(to))
  }

  /** @param {SVGTextElement} text @param {boolean} [isOwn] */
  #sizeOf(text, isOwn = true) {
    const key = `${text.getAttribute("class")}: ${text.textContent?.replace(/\d/g, "0")}`
    const known = this.#sizes.get(key) ?? (isOwn ? this.#fitted(text) : extent(text))
    this.#sizes.set(key, known)
    if (isOwn && text.style.fontSize !== known.font) text.style.fontSize = known.font
    return known
  }

  /** Makes a text smaller that is wider than the paper after its start. @param {SVGTextElement} text */
  #fitted(text) {
    const start = Math.max(this.room.left + EDGE, this.#starts.get(text) ?? -Infinity)
    return shrunk(text, this.room.right - EDGE - AIR - start)
  }
}

/** The share of a text's width to the left of its x. @param {SVGTextElement} text */
const anchored = text => ({middle: 0.5, end: 1})[text.getAttribute("text-anchor") ?? ""] ?? 0

/** @param {Box} box @returns {Box} */
const aired = ({left, right, top, bottom}) => ({left: left - AIR / 2, right: right + AIR / 2, top, bottom})

/** The lines of a plot inside its frame, and its points. @param {Canvas} plot @returns {Box[]} */
export function piecesOf(plot) {
  const {left, top, width, height} = plot.frame
  const isIn = (/** @type {Point} */ {x, y}) => x >= left && x <= left + width && y >= top && y <= top + height
  return plot.block.curves.flatMap(curve => {
    const {[curve.x]: xs, [curve.y]: ys} = plot.view.columns[curve.source] ?? {}
    if (!ys?.length || plot.hidden.has(curve.group)) return []
    const ends = Array.from(xs, (x, i) => ({x: plot.px(x), y: plot.py(ys[i])}))
    const points = curve.width === "none" ? [] : ends.flatMap((end, i) => between(ends[i - 1] ?? end, end))
    return [
      ...points.filter(isIn).map(point => around(point, OFF)),
      ...(curve.marker ? ends.filter(isIn).map(point => around(point, 2 * OFF)) : []),
    ]
  })
}

/** @param {Box} box on the page @param {DOMRect} picture @returns {Box} in units of the picture */
const within = (box, {left, top}) => ({
  left: (box.left - left) / unitSize(),
  right: (box.right - left) / unitSize(),
  top: (box.top - top) / unitSize(),
  bottom: (box.bottom - top) / unitSize(),
})

/** @param {Point} point @param {number} far @returns {Box} */
const around = ({x, y}, far) => ({left: x - far, right: x + far, top: y - far, bottom: y + far})

/** Evenly spaced points between two points, including the second one. @param {Point} from @param {Point} to */
function between(from, to) {
  const count = Math.min(Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / PIECE), MOST) || 1
  return Array.from({length: count}, (_, i) => {
    const share = (i + 1) / count
    return {x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y)}
  })
}

// Empty axes to draw on, with mouse, pen, finger or keys. There is one height for each x, so drawing over a part
// replaces it. A stroke outside the frame follows its edge. Gaps between strokes are kept.

import {element, inUnits, long, setAttributes, svg, unitSize} from "../core/dom.js"
import {short, withUnit} from "../core/numbers.js"
import {focusByHand} from "../controls/drag.js"
import {clamp, toPlace, toSI} from "../core/ruler.js"
import {mark} from "./question.js"

const COLUMNS = 200 // columns across the frame
const SLACK = 12 // units around the frame in which a press counts too
const STEP = 0.02 // share of the frame that an arrow key with Shift moves
const SENT = 101 // heights of a curve in a message: components/language/messages.py

export class Pad {
  /** @type {Map<string, (number | null)[]>} heights by curve */
  heights = new Map()

  pen = {column: 0, height: 0, down: false}

  /** @type {number | null} the column where the pointer was last */
  last = null

  /** @type {page.Finding[]} */
  findings = []

  /**
   * `drawn` is called after every stroke; the sketch `earlier` stays, dotted.
   * @param {import("../scene/plots.js").Plot} plot
   * @param {page.StepCard} step @param {page.Given["curves"]} earlier @param {() => void} drawn
   */
  constructor(plot, {curves, frame}, earlier, drawn) {
    const [across, up] = /** @type {[page.Ruler, page.Ruler]} */ (frame)
    this.across = across
    this.up = up
    this.plot = plot
    this.drawn = drawn
    this.span = {...plot.x}
    this.earlier = Object.values(earlier ?? {}).map(sent => this.#heights(sent))
    this.status = element("p", {class: "hint", role: "status"})
    for (const name of curves) this.heights.set(name, Array(COLUMNS + 1).fill(null))
    this.name = curves[0]
    this.ink = svg("svg", {class: "strokes"})
    this.layer = element("div", {
      class: "drawing",
      tabindex: 0,
      role: "application",
      "aria-label": "Drawing: arrows move the pen, Enter lowers or lifts it",
    })
    this.layer.append(this.ink)
    this.plot.host.append(this.layer)
    this.plot.host.classList.add("sketched")
    this.#listen()
    this.observer = new ResizeObserver(() => this.place())
    this.observer.observe(this.plot.host)
    this.pen.height = (this.plot.y.start + this.plot.y.end) / 2
    this.place()
  }

  #listen() {
    this.layer.addEventListener("pointerdown", event => {
      event.preventDefault()
      event.stopPropagation()
      focusByHand(this.layer)
      this.layer.setPointerCapture(event.pointerId)
      this.last = null
      this.#draw(event)
    })
    this.layer.addEventListener("pointermove", event => {
      if (!this.layer.hasPointerCapture(event.pointerId)) return
      event.stopPropagation()
      const parts = event.getCoalescedEvents?.() ?? []
      for (const part of parts.length ? parts : [event]) this.#draw(part)
    })
    this.layer.addEventListener("keydown", event => this.#key(event))
  }

  /** @param {string} name the curve that is drawn from now on */
  take(name) {
    this.name = name
    this.place()
  }

  get current() {
    return /** @type {(number | null)[]} */ (this.heights.get(this.name))
  }

  /** @param {number} column */
  #abscissa(column) {
    return this.span.start + ((this.span.end - this.span.start) * column) / COLUMNS
  }

  /** @param {PointerEvent} event */
  #draw(event) {
    const {top, height} = this.plot.frame
    const box = this.plot.host.getBoundingClientRect()
    const share = (this.plot.valueAt(event) - this.span.start) / (this.span.end - this.span.start)
    const column = Math.round(clamp(share, 0, 1) * COLUMNS)
    if (this.last === column && (share < 0 || share > 1)) return // outside the frame, the edge keeps its height
    const y = clamp((event.clientY - box.top) / unitSize(), top, top + height)
    this.#reach(column, this.plot.y.end - ((y - top) / height) * (this.plot.y.end - this.plot.y.start))
  }

  /** Fills the columns from the last position to this one. @param {number} column @param {number} height */
  #reach(column, height) {
    const from = this.last ?? column
    const start = this.last === null ? height : (this.current[from] ?? height)
    const count = Math.abs(column - from)
    for (let i = 0; i <= count; i++) {
      const share = count ? i / count : 1
      this.current[from + Math.sign(column - from) * i] = start + (height - start) * share
    }
    this.last = column
    Object.assign(this.pen, {column, height})
    this.place()
    this.drawn()
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const {start, end} = this.plot.y
    const size = event.shiftKey ? 10 : 1
    const move = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key]
    if (!move && event.key !== "Enter") return
    event.preventDefault()
    event.stopPropagation()
    if (!move) this.pen.down = !this.pen.down
    const [right = 0, up = 0] = move ?? []
    const column = clamp(this.pen.column + right * size, 0, COLUMNS)
    const above = this.pen.height + (up * size * STEP * (end - start)) / 2
    const height = clamp(above, Math.min(start, end), Math.max(start, end))
    this.last = this.pen.down && move ? this.pen.column : null
    Object.assign(this.pen, {column, height})
    if (this.pen.down) this.#reach(column, height)
    this.place()
    this.#describePen()
  }

  #describePen() {
    const {column, height, down} = this.pen
    const x = withUnit(short(this.#abscissa(column), 2), this.plot.x.unit)
    const y = withUnit(short(height, 2), this.plot.y.unit)
    this.status.textContent = `Pen at ${x}, ${y}, ${down ? "down" : "lifted"}.`
  }

  clear() {
    this.current.fill(null)
    this.last = null
    this.place()
    this.drawn()
  }

  /** @param {(number | null)[]} heights */
  #points(heights) {
    /** @type {[number, number][]} */
    const points = []
    for (const [i, height] of heights.entries()) if (height !== null) points.push([this.#abscissa(i), height])
    return points
  }

  /**
   * The curves as they are sent: heights at evenly spaced x, in thousandths of the frame, which is the same for all
   * phones.
   */
  get sent() {
    const {start, end} = this.up
    const {y} = this.plot
    /** @param {number | null | undefined} height */
    const share = height => {
      if (height === null || height === undefined) return null
      const place = toPlace(this.up, toSI(y, height))
      return clamp(Math.round((1000 * (place - start)) / (end - start)), -100, 1100)
    }
    const drawn = [...this.heights].filter(([, heights]) => heights.some(height => height !== null))
    const columns = Array.from({length: SENT}, (_, i) => Math.round(this.#column(i / (SENT - 1))))
    return Object.fromEntries(drawn.map(([name, heights]) => [name, columns.map(column => share(heights[column]))]))
  }

  /** Converts a fraction of the shared frame's width to this frame. @param {number} share */
  #column(share) {
    const {start, end} = this.across
    const place = toPlace(this.plot.x, toSI(this.across, start + share * (end - start)))
    return ((place - this.span.start) / (this.span.end - this.span.start)) * COLUMNS
  }

  /** Draws curves that were sent. @param {Record<string, (number | null)[]>} sent */
  restore(sent) {
    for (const [name, shares] of Object.entries(sent))
      if (this.heights.has(name)) this.heights.set(name, this.#heights(shares))
    this.place()
  }

  /** The columns of a curve that was sent, by linear interpolation. @param {(number | null)[]} sent */
  #heights(sent) {
    const {start, end} = this.up
    const [first, last] = [this.#column(0), this.#column(1)]
    const ys = sent.map(share =>
      share === null ? null : toPlace(this.plot.y, toSI(this.up, start + (share / 1000) * (end - start))),
    )
    return Array.from({length: COLUMNS + 1}, (_, i) => {
      const at = Number((((i - first) / (last - first)) * (SENT - 1)).toFixed(6))
      const [low, high] = [ys[Math.floor(at)] ?? null, ys[Math.ceil(at)] ?? null]
      return low === null || high === null ? null : low + (high - low) * (at % 1)
    })
  }

  /** Places the ink over the axes after a change of their position. */
  place() {
    const box = this.plot.frame
    const old = this.earlier.map(heights => svg("path", {class: "old", d: this.#path(this.#points(heights))}))
    const lines = [...this.heights].map(([name, heights]) => this.#line(name, this.#points(heights)))
    const {column, height} = this.pen
    const pen = svg("circle", {class: "pen", r: 7, cx: this.plot.px(this.#abscissa(column)), cy: this.plot.py(height)})
    const marks = this.findings.flatMap(({has, at}) => (at ? [this.#mark(has, at)] : []))
    this.ink.replaceChildren(...this.#numbers(), ...old, ...lines.flat(), ...marks, ...(this.taught ? [] : [pen]))
    inUnits(this.ink, box.left + box.width + 2 * SLACK, box.top + box.height)
    for (const [key, value] of Object.entries(box)) this.layer.style.setProperty(`--${key}`, long(value))
  }

  /** Draws numbers at an axis that usually are under another plot, because the pad may be visible alone. */
  #numbers() {
    const {figure, abscissae, frame} = this.plot
    const y = frame.top + frame.height - 4
    const numbers = figure.numbered ? [] : [...abscissae]
    return numbers.map(([at, words]) => svg("text", {class: "tick", x: this.plot.px(at), y}, words))
  }

  /** @param {string} name @param {[number, number][]} points */
  #line(name, points) {
    const last = points[points.length - 1]
    const path = svg("path", {
      class: name === this.name || this.taught ? "yours" : "yours other",
      d: this.#path(points),
    })
    if (!last) return [path]
    const words = this.heights.size > 1 ? `yours, ${name}` : "yours"
    const place = {x: this.plot.px(last[0]) - 4, y: this.plot.py(last[1]) - 8, "text-anchor": "end"}
    return [path, svg("text", {class: "t0", ...place}, words)]
  }

  /** A path that keeps gaps. @param {[number, number][]} points */
  #path(points) {
    const wide = (1.5 * Math.abs(this.span.end - this.span.start)) / COLUMNS
    return points
      .map(([x, y], i) => {
        const goesOn = i > 0 && Math.abs(x - points[i - 1][0]) < wide
        return `${goesOn ? "L" : "M"}${this.plot.px(x).toFixed(1)} ${this.plot.py(y).toFixed(1)}`
      })
      .join("")
  }

  /** @param {boolean} has @param {[number, number]} at */
  #mark(has, [x, y]) {
    const {left, top, width, height} = this.plot.frame
    const sign = mark(has)
    const place = {x: clamp(this.plot.px(x), left, left + width), y: this.plot.py(y)}
    setAttributes(sign, {x: place.x - 9, y: clamp(place.y, top, top + height) - 9, width: 18, height: 18})
    return sign
  }

  taught = false

  /** Shows the true curve under the sketch, and marks right and wrong features. @param {page.Finding[]} findings */
  teach(findings) {
    this.taught = true
    this.findings = findings
    this.layer.classList.add("taught")
    this.layer.removeAttribute("tabindex")
    this.status.textContent = ""
    this.place()
  }

  leave() {
    this.observer.disconnect()
    this.plot.host.classList.remove("sketched")
    this.layer.remove()
  }
}

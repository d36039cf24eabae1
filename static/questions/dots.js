// The numbers that a class has given, each a dot: for a point on the axis itself, for a typed number on its own line.

import {short} from "../core/numbers.js"
import {inUnits, set, svg, unitSize} from "../core/dom.js"

const R = 3.5
const WIDTH = 280
const HEIGHT = 84
const TOP = 18 // above it the truth is named

export class Dots {
  /** @param {import("./question.js").Question} question */
  constructor({step, plot, element}) {
    this.step = step
    this.unit = step.unit
    /** @type {import("../paper/plots.js").Plot | undefined} */
    this.plot = plot
    this.svg = svg("svg", {class: this.plot ? "vote-dots" : "vote-line", role: "img"})
    if (this.plot) this.plot.host.append(this.svg)
    else element.after(this.svg)
    this.observer = new ResizeObserver(() => this.#draw())
    if (this.plot) this.observer.observe(this.plot.host)
  }

  /** @type {page.Tally | null} */
  tally = null

  /** @type {readonly number[]} the right numbers, as soon as they are shown; on an axis the question marks them */
  truths = []

  /** @param {page.Tally} tally @param {page.Lesson | null} lesson */
  update(tally, lesson) {
    this.tally = tally
    this.truths = lesson?.places ?? []
    this.#draw()
  }

  /** @param {page.Tally} tally */
  headline({right, now}) {
    return `${right} of ${now.answered} are right`
  }

  #draw() {
    if (!this.tally) return
    const {now, before} = this.tally
    const numbers = now.numbers.toSorted((a, b) => a - b)
    const middle = numbers[Math.floor(numbers.length / 2)]
    set(this.svg, {
      "aria-label": numbers.length ? `${numbers.length} numbers, median ${short(middle)}` : "no answers yet",
    })
    const place = this.plot ? this.#onAxis(this.plot) : this.#onLine([...numbers, ...(before?.numbers ?? [])])
    const dots = [...stacked(before?.numbers ?? [], place, "before"), ...stacked(now.numbers, place, "")]
    this.svg.replaceChildren(...place.marks, ...dots, ...place.over)
  }

  /** @param {import("../paper/plots.js").Plot} plot */
  #onAxis(plot) {
    const {left, top, width, height} = plot.frame
    inUnits(this.svg, plot.host.clientWidth / unitSize(), plot.host.clientHeight / unitSize())
    const across = this.step.axis === "x"
    /** @param {number} value */
    const at = value => (across ? plot.px(value) : plot.py(value))
    const base = across ? top + height : left
    return {at, across, base, way: across ? -1 : 1, room: (across ? height : width) - R, zero: 0, marks: [], over: []}
  }

  /** What lies far off the others is drawn at an end of the line, but never the truth. @param {number[]} numbers */
  #onLine(numbers) {
    const sorted = numbers.toSorted((a, b) => a - b)
    const most = [0.05, 0.95].map(share => sorted[Math.round(share * (sorted.length - 1))] ?? this.truths[0] ?? 0)
    const low = Math.min(...most, ...this.truths)
    const high = Math.max(...most, ...this.truths)
    const span = high - low || Math.abs(high) || 1
    const [start, end] = [low - 0.2 * span, high + 0.2 * span]
    set(this.svg, {viewBox: `0 0 ${WIDTH} ${HEIGHT}`})
    /** @param {number} value */
    const at = value => 8 + (WIDTH - 16) * Math.min(Math.max((value - start) / (end - start), 0), 1)
    const base = HEIGHT - 18
    const line = svg("line", {x1: 0, x2: WIDTH, y1: base, y2: base, stroke: "currentColor"})
    const ends = [...new Set([low, high])].map(value => this.#named(at(value), HEIGHT - 3, value, ""))
    const over = this.truths.flatMap(value => this.#truth(at(value), value, base))
    const top = over.length ? TOP : 0
    return {
      at,
      across: true,
      base,
      way: -1,
      room: base - top - R,
      zero: this.truths.length ? at(this.truths[0]) : 0,
      marks: [line, ...ends],
      over,
    }
  }

  /** @param {number} x @param {number} y @param {number} value @param {string} name */
  #named(x, y, value, name) {
    return svg("text", {x, y, class: `t0 ${name}`, "text-anchor": "middle"}, `${short(value)} ${this.unit}`.trim())
  }

  /** @param {number} x @param {number} value @param {number} base */
  #truth(x, value, base) {
    const line = svg("line", {x1: x, x2: x, y1: TOP, y2: base + 4, stroke: "currentColor", "stroke-width": 2})
    return [line, this.#named(x, TOP - 4, value, "truth")]
  }

  leave() {
    this.observer.disconnect()
    this.svg.remove()
  }
}

/**
 * Dots of one place lie on each other; where they are too many, closer. `zero` is where one column stands.
 * @typedef {{at: (value: number) => number, across: boolean, base: number, way: number, room: number,
 *   zero: number}} Place
 * @param {readonly number[]} numbers @param {Place} place @param {string} name
 */
function stacked(numbers, {at, across, base, way, room, zero}, name) {
  /** @type {Map<number, number>} */
  const heights = new Map()
  const columns = numbers.map(number => Math.round((at(number) - zero) / (2 * R)))
  for (const column of columns) heights.set(column, (heights.get(column) ?? 0) + 1)
  const step = Math.min(2 * R, room / Math.max(1, ...heights.values()))
  /** @type {Map<number, number>} */
  const filled = new Map()
  return columns.map(column => {
    const level = filled.get(column) ?? 0
    filled.set(column, level + 1)
    const [along, up] = [zero + column * 2 * R, base + way * (R + level * step)]
    return svg("circle", {class: name, r: R - 0.5, cx: across ? along : up, cy: across ? up : along})
  })
}

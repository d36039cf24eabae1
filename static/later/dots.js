// The numbers that a class has given, each a dot: for a point on the axis itself, for a typed number on its own line.

import {inUnits, set, svg, unitSize} from "../dom.js"

const R = 3.5
const WIDTH = 280
const HEIGHT = 84

export class Dots {
  /** @param {import("./card.js").Card} card @param {page.StepCard} step */
  constructor(card, step) {
    this.step = step
    this.unit = step.unit
    this.plot = step.kind === "point" ? card.page.plots.find(({block}) => block.name === step.plot) : undefined
    this.svg = svg("svg", {class: this.plot ? "vote-dots" : "vote-line", role: "img"})
    if (this.plot) this.plot.host.append(this.svg)
    else card.question.element.after(this.svg)
    this.observer = new ResizeObserver(() => this.#draw())
    if (this.plot) this.observer.observe(this.plot.host)
  }

  /** @type {page.Tally | null} */
  tally = null

  /** @param {page.Tally} tally @param {boolean} _shown */
  update(tally, _shown) {
    this.tally = tally
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
      "aria-label": numbers.length ? `${numbers.length} numbers, the middle one ${short(middle)}` : "none",
    })
    const place = this.plot ? this.#onAxis(this.plot) : this.#onLine([...numbers, ...(before?.numbers ?? [])])
    const dots = [...stacked(before?.numbers ?? [], place, "before"), ...stacked(now.numbers, place, "")]
    this.svg.replaceChildren(...place.marks, ...dots)
  }

  /** @param {import("../plots.js").Plot} plot */
  #onAxis(plot) {
    const {left, top, width, height} = plot.frame
    inUnits(this.svg, plot.host.clientWidth / unitSize(), plot.host.clientHeight / unitSize())
    const across = this.step.axis === "x"
    /** @param {number} value */
    const at = value => (across ? plot.px(value) : plot.py(value))
    const base = across ? top + height : left
    return {at, across, base, way: across ? -1 : 1, room: (across ? height : width) - R, marks: []}
  }

  /** What lies far off the others is drawn at an end of the line. @param {number[]} numbers */
  #onLine(numbers) {
    const sorted = numbers.toSorted((a, b) => a - b)
    const [low, high] = [0.05, 0.95].map(share => sorted[Math.round(share * (sorted.length - 1))] ?? 0)
    const span = high - low || Math.abs(high) || 1
    const [start, end] = [low - 0.2 * span, high + 0.2 * span]
    set(this.svg, {viewBox: `0 0 ${WIDTH} ${HEIGHT}`})
    /** @param {number} value */
    const at = value => 8 + (WIDTH - 16) * Math.min(Math.max((value - start) / (end - start), 0), 1)
    const base = HEIGHT - 18
    const line = svg("line", {x1: 0, x2: WIDTH, y1: base, y2: base, stroke: "currentColor"})
    const marks = [line, ...[...new Set([low, high])].map((value, i) => this.#tick(at(value), value, i))]
    return {at, across: true, base, way: -1, room: base - R, marks}
  }

  /** @param {number} x @param {number} value @param {number} i */
  #tick(x, value, i) {
    const anchor = i ? "end" : "start"
    return svg("text", {x, y: HEIGHT - 3, class: "t0", "text-anchor": anchor}, `${short(value)} ${this.unit}`)
  }

  leave() {
    this.observer.disconnect()
    this.svg.remove()
  }
}

/**
 * Dots of one place lie on each other; where they are too many, closer.
 * @typedef {{at: (value: number) => number, across: boolean, base: number, way: number, room: number}} Place
 * @param {readonly number[]} numbers @param {Place} place @param {string} name
 */
function stacked(numbers, {at, across, base, way, room}, name) {
  /** @type {Map<number, number>} */
  const heights = new Map()
  const columns = numbers.map(number => Math.round(at(number) / (2 * R)))
  for (const column of columns) heights.set(column, (heights.get(column) ?? 0) + 1)
  const step = Math.min(2 * R, room / Math.max(1, ...heights.values()))
  /** @type {Map<number, number>} */
  const filled = new Map()
  return columns.map(column => {
    const level = filled.get(column) ?? 0
    filled.set(column, level + 1)
    const [along, up] = [column * 2 * R, base + way * (R + level * step)]
    return svg("circle", {class: name, r: R - 0.5, cx: across ? along : up, cy: across ? up : along})
  })
}

/** @param {number} number */
const short = number => String(Number(number.toPrecision(3))).replace("-", "−")

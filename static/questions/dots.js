// The numbers that a class answered, as dots: on the axis of the plot if a point was asked for, else on a separate
// line.

import {short, withUnit} from "../core/numbers.js"
import {inUnits, setAttributes, svg, unitSize} from "../core/dom.js"

const R = 3.5
const WIDTH = 280
const HEIGHT = 96
const GAP = 8 // units between two labels
const LEAD = 12 // length of the line from a column to its label
const TOP = 18 // space above the dots for the label of the correct value

export class Dots {
  /** @param {import("./question.js").Question} question */
  constructor({step, plot, element}) {
    this.step = step
    this.unit = step.unit
    /** @type {import("../scene/plots.js").Plot | undefined} */
    this.plot = plot
    this.svg = svg("svg", {class: this.plot ? "vote-dots" : "vote-line", role: "img"})
    if (this.plot) this.plot.host.append(this.svg)
    else element.after(this.svg)
    this.observer = new ResizeObserver(() => this.#draw())
    if (this.plot) this.observer.observe(this.plot.host)
  }

  /** @type {page.Tally | null} */
  tally = null

  /**
   * @type {readonly number[]} the right numbers once they are shown; empty on an axis, where the question marks them
   */
  truths = []

  /** @param {page.Tally} tally @param {page.Lesson | null} lesson */
  update(tally, lesson) {
    this.tally = tally
    this.truths = lesson?.places ?? []
    this.#draw()
  }

  /** @param {page.Tally} tally */
  headline({right, now}) {
    return `${right} of ${now.answered} ${right === 1 ? "is" : "are"} right`
  }

  #draw() {
    if (!this.tally) return
    const {now, before} = this.tally
    const numbers = now.numbers.toSorted((a, b) => a - b)
    const middle = middleOf(numbers)
    setAttributes(this.svg, {
      "aria-label": numbers.length ? `${numbers.length} numbers, median ${short(middle)}` : "no answers yet",
    })
    const place = this.plot ? this.#onAxis(this.plot) : this.#onLine(numbers, before?.numbers ?? [])
    const isOn = (/** @type {number} */ number) => number >= place.start && number <= place.end
    const dots = [
      ...stacked((before?.numbers ?? []).filter(isOn), place, "before"),
      ...stacked(now.numbers.filter(isOn), place, ""),
    ]
    this.svg.replaceChildren(...place.marks, ...dots, ...place.over)
  }

  /** @param {import("../scene/plots.js").Plot} plot */
  #onAxis(plot) {
    const {left, top, width, height} = plot.frame
    inUnits(this.svg, plot.host.clientWidth / unitSize(), plot.host.clientHeight / unitSize())
    const across = this.step.axis === "x"
    /** @param {number} value */
    const at = value => (across ? plot.px(value) : plot.py(value))
    const base = across ? top + height : left
    const room = (across ? height : width) - R
    return {at, across, base, way: across ? -1 : 1, room, zero: 0, start: -Infinity, end: Infinity, marks: [], over: []}
  }

  /**
   * Draws the numbers on the line. Outliers are counted at its end, except the right value; the most frequent values
   * are written below with their counts.
   * @param {readonly number[]} now @param {readonly number[]} before
   */
  #onLine(now, before) {
    const [low, high] = reach([...now, ...before], this.truths)
    const span = high - low || Math.abs(high) || 1
    const [start, end] = [low - 0.2 * span, high + 0.2 * span]
    setAttributes(this.svg, {viewBox: `0 0 ${WIDTH} ${HEIGHT}`})
    /** @param {number} value */
    const at = value => 8 + ((WIDTH - 16) * (value - start)) / (end - start)
    const base = HEIGHT - 18 - LEAD
    const line = svg("line", {x1: 0, x2: WIDTH, y1: base, y2: base, stroke: "currentColor"})
    const ends = this.#counted(now, low, high, at).flatMap(({from, x, words}) => [
      svg("line", {class: "lead", x1: from, x2: x, y1: base + 2, y2: base + LEAD, stroke: "currentColor"}),
      label(x, HEIGHT - 5, words, "middle"),
    ])
    const [below, above] = [now.filter(value => value < start), now.filter(value => value > end)].map(all => all.length)
    if (below) ends.push(label(0, TOP - 4, `← ${below} below`, "start"))
    if (above) ends.push(label(WIDTH, TOP - 4, `${above} above →`, "end"))
    const over = this.truths.flatMap(value => this.#truth(at(value), value, base))
    const top = over.length || below || above ? TOP : 0
    return {
      at,
      across: true,
      base,
      way: -1,
      room: base - top - R,
      zero: this.truths.length ? at(this.truths[0]) : 0,
      start,
      end,
      marks: [line, ...ends],
      over,
    }
  }

  /**
   * The most frequent values with their counts, as many as fit in a row, each near its column.
   * @param {readonly number[]} numbers @param {number} low @param {number} high @param {(value: number) => number} at
   */
  #counted(numbers, low, high, at) {
    /** @type {Map<number, number>} */
    const counts = new Map()
    for (const value of numbers) if (value >= low && value <= high) counts.set(value, (counts.get(value) ?? 0) + 1)
    const often = [...counts].toSorted(([, one], [, other]) => other - one)
    const [bare, whole] = [short, this.#written.bind(this)].map(written =>
      often.map(([value, count]) => this.#measured(value, `${written(value)} × ${count}`)),
    )
    return beside(fitting(whole).length === whole.length ? whole : fitting(bare), at)
  }

  /** @param {number} value @param {string} words */
  #measured(value, words) {
    const text = label(0, 0, words, "start")
    this.svg.append(text)
    const width = text.getComputedTextLength()
    text.remove()
    return {value, words, width}
  }

  /** @param {number} value */
  #written(value) {
    return withUnit(short(value), this.unit)
  }

  /** @param {number} x @param {number} value @param {number} base */
  #truth(x, value, base) {
    const line = svg("line", {x1: x, x2: x, y1: TOP, y2: base + 4, stroke: "currentColor", "stroke-width": 2})
    return [line, label(x, TOP - 4, this.#written(value), "middle", "truth")]
  }

  leave() {
    this.observer.disconnect()
    this.svg.remove()
  }
}

/** @typedef {{value: number, words: string, width: number}} Measured a label of a value */

/** The first labels, as many as a row has room for. @param {Measured[]} labels */
export function fitting(labels) {
  let room = WIDTH
  return labels.filter(({width}) => (room -= width + GAP) >= -GAP)
}

/**
 * Places labels in one row, without overlaps, each as near to its value as possible.
 * @param {Measured[]} labels @param {(value: number) => number} at
 */
export function beside(labels, at) {
  const row = labels.toSorted((one, other) => one.value - other.value)
  const places = row.map(({value}) => at(value))
  const apart = (/** @type {number} */ i) => (row[i].width + row[i + 1].width) / 2 + GAP
  for (const i of row.keys()) places[i] = Math.max(places[i], i ? places[i - 1] + apart(i - 1) : row[i].width / 2)
  for (let i = row.length - 1; i >= 0; i--) {
    const most = i + 1 < row.length ? places[i + 1] - apart(i) : WIDTH - row[i].width / 2
    places[i] = Math.min(places[i], most)
  }
  return row.map(({value, words}, i) => ({from: at(value), x: places[i], words}))
}

/** @param {number} x @param {number} y @param {string} words @param {string} anchor @param {string} [name] */
const label = (x, y, words, anchor, name = "") => svg("text", {x, y, class: `t0 ${name}`, "text-anchor": anchor}, words)

/** @param {readonly number[]} sorted */
const middleOf = sorted => sorted[Math.floor(sorted.length / 2)]

/**
 * The range of numbers that the line shows: the middle four fifths of the answers, those near them, and the right
 * values.
 * @param {readonly number[]} numbers @param {readonly number[]} truths @returns {[number, number]}
 */
export function reach(numbers, truths) {
  const sorted = numbers.toSorted((a, b) => a - b)
  const last = sorted.length - 1
  const middle = middleOf(sorted) ?? truths[0] ?? 0
  const usual = middleOf(sorted.map(value => Math.abs(value - middle)).toSorted((a, b) => a - b)) ?? 0
  const most = 6 * usual || Math.abs(middle)
  const near = sorted.filter(value => Math.abs(value - middle) <= most)
  const inner = sorted.slice(Math.ceil(0.1 * last), Math.floor(0.9 * last) + 1)
  const shown = [...near, ...inner, ...truths]
  return shown.length ? [Math.min(...shown), Math.max(...shown)] : [0, 0]
}

/**
 * Stacks the dots of equal values, closer if there are many. `zero` is the position if there is one column.
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

// Measured points over the curve of a plot and, below the plot, the residuals: their distances from the curve.

import {element, inUnits, reword, setAttributes, svg, textWidth, unitSize} from "../core/dom.js"
import {short, withUnit} from "../core/numbers.js"
import {toPlace} from "../core/ruler.js"
import {over} from "../core/signals.js"
import {drawnRows} from "./record.js"

const APART = 2 // units between the drawn points along the axis
const GAP = 4
const LANE = {top: 6, bottom: 6}

/**
 * Displacements in m at times in s. `scatter`: standard deviation of the residuals; 0 before a fit.
 * @typedef {{t: Float64Array, x: Float64Array, scatter: number}} DrawnPoints
 */

/** The points over a plot. @implements {PointsHost} */
export class Points {
  /** @type {DrawnPoints | null} */
  shown = null

  /** @param {PlotHost} plot */
  constructor(plot) {
    this.plot = plot
    this.path = svg("path", {class: "measured-points"})
    plot.over.prepend(this.path)
    plot.points = this
  }

  /** @param {DrawnPoints | null} shown */
  show(shown) {
    this.shown = shown
    this.place()
  }

  /** True while the view of the points is shown. */
  get isSeen() {
    return this.path.style.display === ""
  }

  place() {
    setAttributes(this.path, {d: this.#line(this.plot)})
  }

  /** The points for a saved picture of the plot. @param {Canvas} canvas */
  drawing(canvas) {
    return svg("path", {class: "measured-points", d: this.#line(canvas)})
  }

  /** @param {Canvas} canvas */
  #line(canvas) {
    if (!this.shown) return ""
    const {t, x} = this.shown
    const {top, height} = canvas.frame
    const places = t.map(time => canvas.px(toPlace(canvas.x, time)))
    const heights = x.map(value => canvas.py(toPlace(canvas.y, value)))
    const isInside = (/** @type {number} */ i) => heights[i] >= top && heights[i] <= top + height
    return dots(canvas.frame, places, heights, isInside)
  }
}

/** The residuals, on the same time axis as the plot. */
export class Residuals {
  /** @type {DrawnPoints | null} */
  shown = null

  /** @type {Float64Array} */
  residuals = new Float64Array()

  /** @param {HTMLElement} host @param {PlotHost} plot @param {string} head */
  constructor(host, plot, head) {
    this.host = host
    this.plot = plot
    this.words = head
    this.svg = svg("svg", {class: "measured-lane", role: "img", "aria-label": `${head}, against time`})
    this.head = element("p", {class: "measured-head"}, head)
    host.append(this.head, this.svg)
    this.observer = new ResizeObserver(() => this.place())
    this.observer.observe(host)
  }

  /**
   * Shows residuals in units of the plot's axis, NaN outside of it.
   * @param {DrawnPoints | null} shown @param {Float64Array} residuals
   */
  show(shown, residuals) {
    this.shown = shown
    this.residuals = residuals
    this.host.classList.toggle("empty", !shown)
    this.place()
  }

  leave() {
    this.observer.disconnect()
  }

  place() {
    if (!this.shown || !this.host.checkVisibility()) return
    const box = this.svg.getBoundingClientRect()
    const {x, y, frame} = this.plot
    const shift = (this.plot.host.getBoundingClientRect().left - box.left) / unitSize()
    const [width, high] = [box.width / unitSize(), box.height / unitSize()]
    inUnits(this.svg, width, high)
    const lane = {left: frame.left + shift, top: LANE.top, width: frame.width, height: high - LANE.top - LANE.bottom}
    const sigma = Math.abs(toPlace(y, this.shown.scatter))
    const finite = this.residuals.filter(Number.isFinite)
    const most =
      1.1 *
        Math.max(
          finite.reduce((far, one) => Math.max(far, Math.abs(one)), 0),
          2.2 * sigma,
        ) || 1
    const py = (/** @type {number} */ value) => lane.top + (lane.height * (most - value)) / (2 * most)
    const places = this.shown.t.map(time => this.plot.px(toPlace(x, time)) + shift)
    const d = dots(lane, places, this.residuals.map(py), i => Number.isFinite(this.residuals[i]))
    this.svg.replaceChildren(
      ...band(lane, py, sigma),
      ...ticks(lane, py, most, y.unit),
      svg("path", {class: "measured-points", d}),
    )
    reword(this.head, sigma ? `${this.words}; the band is ± 2σ` : this.words)
  }
}

/**
 * A path of dots: at most two in each step along the axis.
 * @param {Frame} frame @param {Float64Array} places @param {Float64Array} heights
 * @param {(i: number) => boolean} isInside
 */
function dots({left, width}, places, heights, isInside) {
  return drawnRows(places, heights, APART)
    .filter(i => places[i] >= left - 1 && places[i] <= left + width + 1 && isInside(i))
    .map(i => `M${places[i].toFixed(1)} ${heights[i].toFixed(1)}h0`)
    .join("")
}

/** @param {Frame} lane @param {(value: number) => number} py @param {number} sigma */
function band({left, width}, py, sigma) {
  if (!(sigma && py(-1) > py(1))) return []
  return [
    svg("rect", {class: "measured-band", x: left, y: py(2 * sigma), width, height: py(-2 * sigma) - py(2 * sigma)}),
  ]
}

/** @param {Frame} lane @param {(value: number) => number} py @param {number} most @param {string} unit */
function ticks({left, width}, py, most, unit) {
  const size = 10 ** Math.floor(Math.log10(most))
  const step = [5, 2, 1].find(one => one * size <= 0.9 * most) ?? 0.5
  const texts = [-step * size, 0, step * size].map(value => ({
    value,
    text: value > 0 ? withUnit(short(value), unit) : short(value),
  }))
  return texts.flatMap(({value, text}) => [
    svg("line", {class: value ? "grid" : "hair", x1: left, x2: left + width, y1: py(value), y2: py(value)}),
    svg("text", {class: "t0 mute", x: Math.max(left - GAP - textWidth(text), 0), y: py(value) + 4}, text),
  ])
}

/**
 * The distances of a record from the curve of a plot, in units of its axis; NaN outside the time window.
 * @param {PlotHost} plot @param {DrawnPoints} shown @returns {Float64Array}
 */
export function residualsOf(plot, {t, x}) {
  const {signals, scalars} = plot.view
  const signal = plot.block.curves.find(curve => curve.width === "sum")?.signal ?? ""
  if (!signals[signal]) return t.map(() => NaN)
  const times = t.map(time => toPlace(plot.x, time))
  const curve = over(signals, scalars, times, new Set([signal]))[signal]
  return curve.map((value, i) => (times[i] < 0 || times[i] > plot.x.end ? NaN : toPlace(plot.y, x[i]) - value))
}

/**
 * The points as they are drawn: displacements without the fitted offset and drift. A measured velocity or acceleration
 * becomes a displacement: the fitted one, plus the residual divided by the same power of the natural frequency (of two
 * frequencies, their geometric mean).
 * @param {{rows: import("./record.js").Rows | null, fit: page.Fitted | null} | null} file
 * @returns {DrawnPoints[] | null}
 */
export function shownOf(file) {
  if (!file?.rows || (file.rows.derivative && !file.fit)) return null
  const {t, columns, derivative} = file.rows
  const motion = file.fit?.motion
  const [omega, decay] = [motion?.omega ?? [], motion?.decay ?? []]
  const sizes = omega.map((w, j) => Math.log(Math.hypot(w, decay[j])))
  const scale = Math.exp((derivative * sizes.reduce((sum, one) => sum + one, 0)) / (sizes.length || 1))
  return columns.map((x, i) => {
    const {C = [], S = [], offset = 0, drift = 0, scatter = 0} = motion?.columns[i] ?? {}
    const swing = (/** @type {number} */ time, /** @type {number} */ order) =>
      omega.reduce((sum, w, j) => {
        const size = Math.hypot(C[j], S[j]) * Math.hypot(w, decay[j]) ** order
        const phase = Math.atan2(-S[j], C[j]) + order * Math.atan2(w, -decay[j])
        return sum + size * Math.exp(-decay[j] * time) * Math.cos(w * time + phase)
      }, 0)
    const points = x.map((one, row) => {
      const rest = one - offset - drift * t[row]
      return derivative ? swing(t[row], 0) + (rest - swing(t[row], derivative)) / scale : rest
    })
    return {t, x: points, scatter: scatter / scale}
  })
}

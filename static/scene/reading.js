// Shows the coordinates and curve values at the pointer over a plot.

import {element, long, setAttributes, svg, unitSize} from "../core/dom.js"
import {short, withUnit} from "../core/numbers.js"
import {stepOf} from "../core/ruler.js"
import {evaluate} from "../core/signals.js"

const PRESSED = "button, .pill, .flag, .cover"

export class Reading {
  /** @param {PlotHost} plot */
  constructor(plot) {
    this.plot = plot
    this.aim = svg("line", {class: "aim"})
    this.box = element("div", {class: "reading", hidden: ""})
    plot.over.append(this.aim)
    plot.host.append(this.box)
  }

  hide() {
    this.box.hidden = true
    this.aim.style.display = "none"
  }

  /** @param {PointerEvent} event */
  show(event) {
    const {plot} = this
    const isFinger = event.pointerType === "touch"
    if (!plot.shown || plot.block.square || isFinger || isOnControl(event) || !plot.isInside(event)) return this.hide()
    const place = plot.valueAt(event)
    const lines = [...this.#curves(place), ...this.#bands(place)]
    if (!lines.length) return this.hide()
    this.box.replaceChildren(element("b", {}, measured(place, plot.x, 0)), ...lines)
    this.#showAt(plot.px(place))
  }

  /** @param {number} place */
  #curves(place) {
    const {plot} = this
    const {signals, scalars, time, columns} = plot.view
    const named = plot.block.x === time ? evaluate(signals, scalars, place) : {}
    return plot.block.curves.flatMap(curve => {
      const {[curve.x]: xs, [curve.y]: ys} = columns[curve.source] ?? {}
      if (!ys?.length || plot.hidden.has(curve.group) || !curve.read) return []
      const exact = curve.signal_x ? undefined : named[curve.signal]
      const y = exact ?? this.#between(xs, ys, place)
      if (y === null) return []
      const value = measured(y, plot.y, exact === undefined ? this.#step : 0)
      return [element("span", {class: `tint ${curve.tint}`}, `${curve.read} ${value}`)]
    })
  }

  /** @param {number} place */
  #bands(place) {
    return this.plot.block.regions.flatMap(band => {
      const {[band.x]: xs, [band.high]: high, [band.low]: low} = this.plot.view.columns[band.source] ?? {}
      if (!band.read || !high?.length || !low?.length) return []
      const [top, bottom] = [this.#between(xs, high, place), this.#between(xs, low, place)]
      if (top === null || bottom === null) return []
      const thick = measured(Math.abs(top - bottom), this.plot.y, 2 * this.#step)
      return [element("span", {}, `${band.read} ${thick}`)]
    })
  }

  /** The steps to which the heights of curves are rounded. */
  get #step() {
    return stepOf(this.plot.view.axes[this.plot.block.y])
  }

  /**
   * The value between two points of a column. Outside the frame a column has no exact values.
   * @param {Float64Array} xs in order @param {Float64Array} ys @param {number} x @returns {number | null}
   */
  #between(xs, ys, x) {
    if (!xs?.length || x < xs[0] || x > xs[xs.length - 1]) return null
    const i = before(xs, x)
    const {start, end} = this.plot.view.axes[this.plot.block.y]
    const far = 1.5 * Math.abs(end - start) - this.#step
    if ([ys[i], ys[i + 1]].some(y => Math.abs(y - (start + end) / 2) > far)) return null
    const span = xs[i + 1] - xs[i]
    return span > 0 ? ys[i] + ((ys[i + 1] - ys[i]) * (x - xs[i])) / span : ys[i]
  }

  /** @param {number} x */
  #showAt(x) {
    const {left, top, width, height} = this.plot.frame
    this.box.hidden = false
    this.box.style.left = long(x > left + width / 2 ? x - this.box.offsetWidth / unitSize() - 10 : x + 10)
    this.box.style.top = long(top)
    this.aim.style.display = ""
    setAttributes(this.aim, {x1: x, x2: x, y1: top, y2: top + height})
  }
}

/** True if the pointer is on a part of the overlay that has its own action. @param {PointerEvent} event */
export const isOnControl = ({target}) => target instanceof Element && Boolean(target.closest(PRESSED))

/**
 * The index of the last point before x, at most the last but one. @param {Float64Array} xs in order @param {number} x
 */
function before(xs, x) {
  let low = 0
  let high = xs.length - 1
  while (high - low > 1) {
    const middle = (low + high) >> 1
    if (xs[middle] <= x) low = middle
    else high = middle
  }
  return low
}

/**
 * The number of known digits, at most three. Numbers are rounded to multiples of `step`; 0 means that all digits are
 * known.
 * @param {number} value @param {number} step
 */
export function honest(value, step) {
  if (!step) return short(value)
  const digits = Math.floor(Math.log10(Math.abs(value))) + 1 - Math.ceil(Math.log10(step))
  return digits > 0 ? short(value, Math.min(digits, 3)) : "0"
}

/**
 * The value at a coordinate of an axis, as text.
 * @param {number} place @param {page.Ruler} ruler @param {number} step
 */
function measured(place, {unit, log}, step) {
  return withUnit(log ? honest(10 ** place, 10 ** place * (10 ** step - 1)) : honest(place, step), unit)
}

// Dragging on a page: the dragged shape follows the pointer at once; the server gets the values and answers later.

import {polynomial, roots, valueAt} from "../core/signals.js"
import {PLAIN, clamp, toPlace, toSI} from "../core/ruler.js"
import {onLocus} from "./locus.js"

const FLICK = 120 // ms before the release over which the velocity is measured
const QUARTER = Math.PI / 2 // of a turn
const GROWTH_STEPS = 30
const STILL = 40 // pixels a second; a slower pointer counts as resting

export class Hand {
  /** @type {Grab | null} the drag in progress */
  grab = null

  /** @type {Named} the values at the pointer, which a press would start to drag */
  pointed = {}

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
  }

  /** @param {page.Grab} spec */
  holds(spec) {
    return this.grab?.spec === spec
  }

  /** @param {page.Grab} spec */
  take(spec) {
    if (this.grab?.spec === spec) return this.grab.again()
    const {clock, compare} = this.page
    const now = compare.named(clock.t)
    this.grab = new Grab(spec, this.page)
    if (spec.begins) this.grab.begin(now)
  }

  /** @param {Drawn} shown */
  update(shown) {
    if (this.grab?.handleAnswer(shown)) {
      const {grab} = this
      this.grab = null
      grab.end()
    }
  }
}

/** The drag of one shape, from the press to the last answer after the release. */
class Grab {
  /** @type {Named} SI values drawn instead of the picture's numbers, by name */
  moved = {}

  /** @type {Named} the last values that the server accepted */
  good = {}

  /** @type {Named} values that stay fixed until the first answer */
  frozen = {}

  /** @type {Named} initial conditions that the drag has sent */
  begun = {}

  /** @type {{at: Point, when: number}[]} */
  trail = []

  refusal = ""
  first = 0 // number of the first message of this drag
  leaving = false
  plays = false // true if the clock was playing before the drag

  /** @param {page.Grab} spec @param {PartHost} page */
  constructor(spec, page) {
    this.spec = spec
    this.page = page
  }

  /** The numbers that replace the picture's while dragging. @returns {Named} */
  get named() {
    /** @type {Named} */
    const named = {...this.frozen}
    for (const {moves, axis} of this.spec.ways) {
      if (moves in this.moved) named[moves] = toPlace(this.#ruler(axis), this.moved[moves])
    }
    return named
  }

  /** @param {string} axis */
  #ruler(axis) {
    return this.page.shown.view.axes[axis] ?? PLAIN
  }

  /** Starts a motion with the values at an instant as initial conditions. @param {Named} now */
  begin(now) {
    const {start} = this.spec
    const {clock, shown} = this.page
    this.frozen = roots(shown.view.signals, now)
    this.plays = clock.playing
    clock.playing = false
    clock.seek(0)
    if (!start.length) return
    const values = start.map(({parameter, of, axis, size, exactly, angle}) => {
      const value = of ? toSI(this.#ruler(axis), now[of]) / size : 0
      return [parameter, angle ? turned(value) : exactly ? value : digits(value)]
    })
    this.begun = Object.fromEntries(values)
    this.#send(this.begun)
  }

  /** Continues the drag, if the shape is taken again before everything is answered. */
  again() {
    this.leaving = false
    this.refusal = ""
    this.rest()
  }

  /**
   * Sends the values for a position of the pointer on a stage. `all`: the quantities of the stage by name.
   * @param {Point} at @param {Named} all
   */
  move(at, all) {
    this.trail.push({at, when: performance.now()})
    /** @type {Record<string, number>} */
    const values = {}
    for (const way of this.spec.ways) {
      const {si, value, pixel, at: held} = placed(way, at, all, this.#ruler(way.axis))
      at = held ?? at
      if (way.moves && !this.refusal) this.moved[way.moves] = si
      if (way.parameter) values[way.parameter] = pixel === null ? value : rounded(value / way.size, pixel / way.size)
    }
    if (Object.keys(values).length) this.#send(values)
    this.page.clock.dirty = true
  }

  /** Sets the first parameter to this value; the others do not change. @param {number} value */
  setTo(value) {
    const way = this.spec.ways.find(one => one.parameter)
    if (!way) return
    this.moved = {}
    this.#send({[way.parameter]: value})
  }

  /** The pointer has stopped, so the release does not throw the shape. */
  rest() {
    this.trail = []
  }

  /**
   * Ends the drag. The motion starts with the velocity of the pointer as soon as all messages are answered. Axes along
   * which a pointer has moved are not fitted again.
   * @param {Named} all @param {boolean} isPointer
   */
  release(all, isPointer) {
    this.leaving = true
    this.#send(this.#flick(all), false, isPointer ? this.spec.ways.filter(isOnPlot) : [])
  }

  /** The values that a throw sets; none if the pointer rested before the release. @param {Named} all */
  #flick(all) {
    const {spec, trail, page} = this
    const last = trail[trail.length - 1]
    const recent = trail.findIndex(({when}) => when > last.when - FLICK)
    const first = trail[Math.min(recent, trail.length - 2)]
    if (!first || performance.now() - last.when > FLICK) return {}
    /** @type {Record<string, number>} */
    const values = {}
    for (const way of spec.ways) {
      if (this.refusal || !(way.rate || way.kind === "swung")) continue
      const seconds = (last.when - first.when) / 1000
      const far = Math.hypot(last.at.x - first.at.x, last.at.y - first.at.y)
      if (!seconds || far / seconds < STILL) continue
      const ruler = this.#ruler(way.axis)
      const [before, after] = [first, last].map(({at}) => placed(way, at, all, ruler))
      const [from, to] = [before, after].map(({goes, value}) => goes ?? value)
      const rate = (to - from) / seconds / page.clock.factor
      if (way.kind === "swung") Object.assign(values, this.#swung(way, to, rate))
      else values[way.rate] = digits((this.begun[way.rate] ?? 0) + rate / way.size)
    }
    return values
  }

  /**
   * The amplitude or phase of a sine with this initial position and velocity; none if its frequency is 0.
   * @param {page.Swung} way @param {number} place @param {number} velocity
   */
  #swung({parameter, of, turn}, place, velocity) {
    const signal = this.page.shown.view.signals[turn]
    const omega = signal?.kind === "sines" ? signal.line[1] / this.page.clock.unit : 0
    if (!omega) return {}
    const lag = velocity / omega
    return {[parameter]: digits(of === "phase" ? Math.atan2(place, lag) : Math.hypot(place, lag))}
  }

  /**
   * @param {Record<string, number>} values @param {boolean} [holding] @param {page.AnyWay[]} [ways] rules whose axes
   * are not fitted again
   */
  #send(values, holding = true, ways = this.spec.ways) {
    const along = [...new Set(ways.map(({axis}) => axis).filter(Boolean))]
    this.page.send({type: "set", values, holding, along})
    this.first ||= this.page.host.messages.last
  }

  /** Handles an answer; returns true if it is the last one. @param {Drawn} shown */
  handleAnswer({answer, errors}) {
    if (answer === null || answer < this.first) return false
    this.refusal = this.spec.ways.map(way => errors[way.parameter]).find(Boolean) ?? ""
    if (this.refusal) Object.assign(this.moved, this.good)
    else this.good = {...this.moved}
    this.frozen = {}
    return this.leaving && this.page.host.messages.rests
  }

  /** Plays the motion that the drag has started. */
  end() {
    const {clock, compare} = this.page
    if (this.spec.begins && !compare.still)
      clock.playing = this.plays || !matchMedia("(prefers-reduced-motion: reduce)").matches
  }
}

/**
 * The value at the position of the pointer: `si` in SI as drawn; `value` as it is set; `pixel`, the change per pixel,
 * or null if every digit counts; `goes`, the velocity of a throw, if it is not the change of the value; `at`, the
 * position on a curve to which the drag is limited, which the following rules use.
 * @typedef {{si: number, value: number, pixel: number | null, goes?: number, at?: Point}} Placed
 */

/**
 * @param {page.AnyWay} way @param {Point} at @param {Named} all @param {page.Ruler} ruler @returns {Placed}
 */
function placed(way, at, all, ruler) {
  if (way.kind === "turn") {
    const [across, down] = [at.x - polynomial(way.x, all), (at.y - polynomial(way.y, all)) / way.tall]
    const si = (Math.atan2(across, down) - way.zero) / way.unit
    return {si, value: si, pixel: 1 / Math.hypot(across, down) / Math.abs(way.unit)}
  }
  if (way.kind === "chain_root") return onChainRoot(way, at, all)
  if (way.kind === "locus") return onLocus(way, at, all)
  const unit = polynomial(way.unit, all)
  const place = ((way.kind === "trade" ? at.y : at[way.across]) - polynomial(way.zero, all)) / unit
  if (way.kind !== "trade") return onLine(way, place, Math.abs(1 / unit), all, ruler)
  const head = toSI(ruler, all[way.head])
  const high = Math.min(toSI(ruler, place), head / 2)
  return {si: high, value: Math.sqrt(1 - (2 * high) / head) - 1, pixel: 0.01}
}

/**
 * The value of a parameter for a root of the chain, and its change for a tenth of a pixel.
 * @param {page.ChainRoot} way @param {Point} at @param {Named} all @returns {Placed}
 */
function onChainRoot(way, at, all) {
  const [right, down] = [way.right, way.down].map(one => polynomial(one, all))
  const terms = way.terms.map(term => term.map(one => polynomial(one, all)))
  const [base, slope, now] = [way.base, way.slope, way.now].map(one => polynomial(one, all))
  const [re, im] = [(at.x - polynomial(way.x, all)) / right, (at.y - polynomial(way.y, all)) / down]
  const [value, near] = [re, re - 1 / right].map(one => base + slope * growth(terms, now, one, im))
  return {si: value, value, pixel: Math.abs(near - value) / 10}
}

/**
 * The u >= 0 for which |A(s) + u B(s) + u^2 C(s)| is least: exact in one step without C, else by steps of Gauss and
 * Newton.
 * @param {number[][]} terms @param {number} now @param {number} re @param {number} im
 */
function growth(terms, now, re, im) {
  const [a, b, c] = terms.map(term => valueAt(term, re, im))
  let u = now
  for (let step = 0; step < GROWTH_STEPS; step++) {
    const [p, q] = [a[0] + u * (b[0] + u * c[0]), a[1] + u * (b[1] + u * c[1])]
    const [dp, dq] = [b[0] + 2 * u * c[0], b[1] + 2 * u * c[1]]
    const square = dp * dp + dq * dq
    if (!square) break
    u = Math.max(0, u - (p * dp + q * dq) / square)
  }
  return u
}

/**
 * @param {page.Along | page.Share | page.Quotient | page.Root | page.Swung} way
 * @param {number} place @param {number} pixel of the axis
 * @param {Named} all @param {page.Ruler} ruler @returns {Placed}
 */
function onLine(way, place, pixel, all, ruler) {
  const [least, most] = [way.least, way.most].map(end => (end === null ? end : toPlace(ruler, end)))
  const inside = clamp(place, least ?? -Infinity, most ?? Infinity)
  const [si, beside] = [inside, inside + pixel].map(one => toSI(ruler, one))
  if (way.kind === "along") return {si, value: si, pixel: Math.abs(beside - si)}
  if (way.kind === "quotient") {
    const value = all[way.over] / inside
    return {si, value, pixel: Math.abs(value - all[way.over] / (inside + pixel))}
  }
  if (way.kind === "root") {
    const [value, near] = [inside, inside + pixel].map(p => (way.real || p > 1 ? (p + 1 / p) / 2 : p))
    return {si, value, pixel: Math.abs(near - value)}
  }
  const part = polynomial(way.share, all) * si
  if (way.kind === "share") return {si: part, value: part + toSI(ruler, all[way.rest]), pixel: null}
  const [goes, near] = [si, beside].map(one => polynomial(way.counted, all) * one)
  if (way.of === "phase") return {si: part, value: goes < 0 ? -QUARTER : QUARTER, pixel: null, goes}
  return {si: part, value: Math.abs(goes), pixel: Math.abs(near - goes), goes}
}

/** Rounds a value to the resolution of a pixel. @param {number} value @param {number} pixel */
function rounded(value, pixel) {
  if (!pixel) return digits(value)
  const step = 10 ** Math.floor(Math.log10(pixel))
  return Number((Math.round(value / step) * step).toPrecision(12)) + 0
}

/** True if the drag is along an axis of a plot. This axis must not be fitted again. @param {page.AnyWay} way */
const isOnPlot = way =>
  "zero" in way && typeof way.zero !== "number" && way.zero.terms.some(([, names]) => names.some(isOfPlot))

/** @param {string} name such as plane.x0 */
const isOfPlot = name => name.includes(".")

/** An angle without whole turns. @param {number} angle */
const turned = angle => angle - 4 * QUARTER * Math.round(angle / (4 * QUARTER))

/** @param {number} value */
const digits = value => Number(value.toPrecision(4)) + 0

// Evaluates signals at any instant: the counterpart of components/language/signals.py in the browser.

import {circled, damped, driven} from "./damped.js"
import {modal} from "./modal.js"

const SERIES = 1 // rad; below it the power series is exact to the last digit, but the closed forms lose digits
const TERMS = 9

/** @param {number} phase */
const sin = phase => Math.sin(circled(phase))

/** @param {number} phase */
const cos = phase => Math.cos(circled(phase))

/** sin(rate t) / rate, also at rate 0. @param {number} rate @param {number} t */
const sinc = (rate, t) => (Math.abs(rate * t) < 1e-4 ? t * (1 - (rate * t) ** 2 / 6) : sin(rate * t) / rate)

/**
 * The response from rest, x'' + n² x = sin(w t); regular at w = n and at n = 0.
 * @param {number} w @param {number} n @param {number} t
 */
function response(w, n, t) {
  if (Math.max(w, n) * t < SERIES) return fromRest(w, n, t)
  const s = (w + n) / 2
  const d = (w - n) / 2
  if (Math.abs(d) > 0.3 * s) return (sin(w * t) - w * sinc(n, t)) / ((n - w) * (n + w))
  return (cos(d * t) * sinc(s, t) - cos(s * t) * sinc(d, t)) / (2 * n)
}

/**
 * The response from rest, as a power series: w t³ times the sum of (-1)^k h_k / (2k + 3)!, where h_k is the sum of all
 * products of k factors, each (w t)² or (n t)².
 * @param {number} w @param {number} n @param {number} t
 */
function fromRest(w, n, t) {
  const a = (w * t) ** 2
  const b = (n * t) ** 2
  let term = 1 / 6
  let sum = term
  let products = 1
  let power = 1
  for (let k = 1; k < TERMS; k++) {
    power *= b
    products = a * products + power
    term /= -(2 * k + 2) * (2 * k + 3)
    sum += term * products
  }
  return w * t ** 3 * sum
}

/** @typedef {Omit<page.Sampled, "y" | "dy"> & {y: ArrayLike<number>, dy: ArrayLike<number>}} Sampled */

/** @param {Sampled} signal @param {number} t */
function hermite({period, y, dy, drift}, t) {
  const turns = Math.floor(t / period)
  const count = y.length - 1
  const place = (t / period - turns) * count
  const i = Math.min(Math.floor(place), count - 1)
  const u = place - i
  const h = period / count
  const start = (1 + 2 * u) * (1 - u) ** 2 * y[i] + u * (1 - u) ** 2 * h * dy[i]
  const end = u * u * (3 - 2 * u) * y[i + 1] + u * u * (u - 1) * h * dy[i + 1]
  return turns * drift + start + end
}

/**
 * A number of a shape, or a sum of products of named quantities.
 * @param {page.Number} number @param {Named} named
 */
export function polynomial(number, named) {
  if (typeof number === "number") return number
  let sum = 0
  for (const [factor, names] of number.terms) {
    let product = factor
    for (const name of names) product *= named[name] ?? unknown(name)
    sum += product
  }
  return sum
}

/**
 * A polynomial at re + i im: its real and its imaginary part.
 * @param {number[]} term the coefficients, constants first @param {number} re @param {number} im
 */
export const valueAt = (term, re, im) =>
  term.reduceRight(([x, y], one) => [x * re - y * im + one, x * im + y * re], [0, 0])

/**
 * A shape with evaluated numbers; `moving` are the ones that depend on the instant.
 * @param {{spec: page.AnyShape, moving: [string, page.Number][]}} shape @param {Named} all
 */
export function atInstant({spec, moving}, all) {
  const shape = {...spec}
  for (const [key, value] of moving) Object.assign(shape, {[key]: polynomial(value, all)})
  return /** @type {AtInstant} */ (shape)
}

/** @type {Set<string>} */
const reported = new Set()

/**
 * Logs an unknown name once in the console, so that tests fail; the picture continues without it.
 * @param {string} name
 */
export function unknown(name) {
  if (!reported.has(name)) console.error(`The picture has no “${name}”.`)
  reported.add(name)
  return 0
}

/** @param {page.Sines} signal @param {number} t */
function sines({line: [a, b], sines: waves}, t) {
  let sum = a + b * t
  for (const [size, omega, phase, decay, slope] of waves) {
    sum += (size + slope * t) * sin(omega * t + phase) * (decay ? Math.exp(-decay * t) : 1)
  }
  return sum
}

/** @param {page.AnySignal} signal @param {number} t @param {Named} named the scalars and the signals before it */
function valueOf(signal, t, named) {
  switch (signal.kind) {
    case "sines":
      return sines(signal, t)
    case "responses":
      return signal.responses.reduce((sum, [size, omega, own]) => sum + size * response(omega, own, t), 0)
    case "damped":
      return damped(signal, t)
    case "driven":
      return driven(signal, t)
    case "modal":
      return modal(signal, t, named)
    case "derived":
      return polynomial(signal.value, named)
    case "sine":
      return sin(named[signal.of] ?? unknown(signal.of))
    case "cosine":
      return cos(named[signal.of] ?? unknown(signal.of))
    case "sampled":
      return hermite(/** @type {Sampled} */ (signal), t)
  }
}

/** The names of the quantities that a signal depends on. @param {page.AnySignal} signal */
function spokenOf(signal) {
  if (signal.kind === "derived") return signal.value.terms.flatMap(([, names]) => names)
  if (signal.kind === "modal") return [signal.at]
  return "of" in signal ? [signal.of] : []
}

const MADE = new Set(["derived", "sine", "cosine", "modal"]) // signals that depend on others, or that set many names

/**
 * The named signals at many instants, in columns. Of the other signals, only those that they need are evaluated.
 * @param {Record<string, page.AnySignal>} signals @param {Named} scalars @param {Float64Array} times
 * @param {Set<string>} names
 */
export function over(signals, scalars, times, names) {
  const needed = new Set(names)
  const ofMany = [...names].some(name => !(name in signals)) // names that a modal signal sets
  for (const [name, signal] of Object.entries(signals).toReversed()) {
    if (ofMany && signal.kind === "modal") needed.add(name)
    if (needed.has(name)) for (const other of spokenOf(signal)) needed.add(other)
  }
  const wanted = Object.entries(signals).filter(([name]) => needed.has(name))
  const columns = Object.fromEntries([...names].map(name => [name, new Float64Array(times.length)]))
  /** @type {Named} */
  const named = {...scalars, t: 0}
  for (const [i, t] of times.entries()) {
    named.t = t
    for (const [name, signal] of wanted) named[name] = valueOf(signal, t, named)
    for (const name of names) columns[name][i] = named[name]
  }
  return columns
}

/**
 * The signals that depend on no others, at an instant. All positions follow from them.
 * @param {Record<string, page.AnySignal>} signals @param {Named} named @returns {Named}
 */
export function roots(signals, named) {
  const own = Object.entries(signals).filter(([, {kind}]) => !MADE.has(kind))
  return Object.fromEntries(own.map(([name]) => [name, named[name]]))
}

/**
 * Scalars and all signals at time t. Numbers in `instead` replace signals of the same name.
 * @param {Record<string, page.AnySignal>} signals @param {Named} scalars @param {number} t @param {Named} [instead]
 * @returns {Named}
 */
export function evaluate(signals, scalars, t, instead = {}) {
  /** @type {Named} */
  const named = {...scalars, ...instead, t}
  for (const [name, signal] of Object.entries(signals)) named[name] = instead[name] ?? valueOf(signal, t, named)
  return named
}

// Dragging a dot along the curve of a response in the complex plane, which sets the drive frequency.

import {clamp} from "../core/ruler.js"
import {polynomial, valueAt} from "../core/signals.js"

const STRIDE = 8 // pixels: the longest step along the curve
const SHORT = 0.4 // the longest step of a frequency, relative to the distance to the nearest pole
const STRIDES = 200
const AROUND = 2.5 // longest move along the curve, relative to the pointer's; at most pi/2 on a half circle
const NEAR = 0.01 // pixels
const LEAST = 1e-3 // lowest frequency in the drag, because at 0 there is no oscillation
const HALVINGS = 30
const SHARE = 1e-6 // share of a step over which a slope is measured

/**
 * A curve on the screen: `at` returns the point at a frequency, `longest` the longest step from there that does not
 * jump over a loop.
 * @typedef {{at: (w: number) => Point, longest: (w: number) => number}} Locus
 */

/**
 * The curve along which this rule drags the dot. @param {page.Locus} way @param {Named} all @returns {Locus}
 */
function locusOf(way, all) {
  const [x, y, right, down] = [way.x, way.y, way.right, way.down].map(one => polynomial(one, all))
  const above = way.above.map(one => polynomial(one, all))
  const poles = way.poles.map(([re, im]) => [polynomial(re, all), polynomial(im, all)])
  const at = (/** @type {number} */ w) => {
    const [re, im] = poles.reduce(([a, b], [p, q]) => over(a, b, -p, w - q), valueAt(above, 0, w))
    return {x: x + right * re, y: y + down * im}
  }
  return {at, longest: w => SHORT * Math.min(...poles.map(([p, q]) => Math.hypot(p, w - q)))}
}

/**
 * (a + i b)/(c + i d). @param {number} a @param {number} b @param {number} c @param {number} d
 */
function over(a, b, c, d) {
  const square = c * c + d * d
  return [(a * c + b * d) / square, (b * c - a * d) / square]
}

/** @param {Point} one @param {Point} two */
const far = (one, two) => Math.hypot(one.x - two.x, one.y - two.y)

/**
 * The direction of the curve, in pixels per unit of frequency. @param {Locus} locus @param {number} w
 */
function slopeOf({at, longest}, w) {
  const step = SHARE * longest(w)
  const [here, next] = [at(w), at(w + step)]
  const [x, y] = [(next.x - here.x) / step, (next.y - here.y) / step]
  return {x, y, speed: Math.hypot(x, y) || Infinity}
}

/**
 * The frequency some pixels further along the curve, at most a stride.
 * @param {Locus} locus @param {number} w @param {number} length
 */
function stride(locus, w, length) {
  const {at, longest} = locus
  const most = longest(w)
  const step = clamp(clamp(length, -STRIDE, STRIDE) / slopeOf(locus, w).speed, -most, most)
  let next = w
  for (let n = 0; n < HALVINGS; n++) {
    next = Math.max(0, w + step / 2 ** n)
    if (far(at(next), at(w)) < 1.5 * STRIDE) break
  }
  return next
}

/**
 * The frequency at the point of the curve that is nearest to the pointer, the change per pixel, and the point. Only the
 * part of the curve near the current frequency is searched, so that the dot does not jump to another loop that crosses
 * this one.
 * @param {page.Locus} way @param {Point} hand @param {Named} all
 */
export function onLocus(way, hand, all) {
  const locus = locusOf(way, all)
  let w = nearest(locus, polynomial(way.now, all), hand)
  let speed = Infinity
  for (let n = 0; n < STRIDES; n++) {
    const here = locus.at(w)
    const slope = slopeOf(locus, w)
    speed = slope.speed
    const length = ((hand.x - here.x) * slope.x + (hand.y - here.y) * slope.y) / speed
    if (Math.abs(length) < NEAR) break
    w = stride(locus, w, length)
  }
  w = Math.max(w, LEAST)
  const unit = polynomial(way.unit, all)
  return {si: w, value: unit * w, pixel: unit * Math.min(1 / speed, w / 10), at: locus.at(w)}
}

/**
 * The frequency, in strides from the current one, at the point nearest to the pointer.
 * @param {Locus} locus @param {number} now @param {Point} hand
 */
function nearest(locus, now, hand) {
  const reach = AROUND * far(locus.at(now), hand)
  let best = now
  for (const length of [STRIDE, -STRIDE]) {
    let [w, gone] = [now, 0]
    for (let n = 0; n < STRIDES && gone < reach; n++) {
      const next = stride(locus, w, length)
      gone += far(locus.at(next), locus.at(w))
      w = next
      if (far(locus.at(w), hand) < far(locus.at(best), hand) - 1) best = w
    }
  }
  return best
}

/**
 * The point some pixels further along the curve.
 * @param {page.Locus} way @param {number} length @param {Named} all
 */
export function furtherOn(way, length, all) {
  const locus = locusOf(way, all)
  let w = polynomial(way.now, all)
  let left = Math.abs(length)
  for (let n = 0; n < STRIDES && left > NEAR; n++) {
    const next = stride(locus, w, Math.sign(length) * left)
    left -= far(locus.at(next), locus.at(w))
    w = next
  }
  return locus.at(w)
}

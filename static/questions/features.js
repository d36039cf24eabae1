// Finds the features that a sketch of a curve should have: its start and its turning points, from the drawn curve.

import {motionOf, turned} from "../scene/describe.js"

const MOST = 3 // largest number of turning points
const ALONG = [0.08, 0.05, 0.03] // tolerances, relative to the width of the frame; the largest that fits is used
const HIGH = 0.15 // tolerance, relative to the height of the frame
const AROUND = 2.5 // a turning point is looked for within so many tolerances, as in components/walks/features.py
const STANDS_OUT = 0.12 // least height of a peak over the curve around it, relative to the height of the frame

/** The value at a coordinate of an axis. @param {page.Ruler} ruler @param {number} place */
function number({log, exponent, start, end}, place) {
  if (log) return Number((10 ** place).toPrecision(4))
  const least = 1e-9 * Math.abs(end - start) // smaller values count as 0
  return Math.abs(place) < least ? 0 : Number((place * 10 ** exponent).toPrecision(4))
}

/** @param {page.Ruler} ruler @param {number} share of its length */
const off = (ruler, share) =>
  Number((Math.abs(number(ruler, ruler.end) - number(ruler, ruler.start)) * share).toPrecision(2))

/**
 * Features in the units of the axes, as in a walk's file.
 * @param {import("../scene/plots.js").Plot} plot @param {page.Curve} curve
 */
export function features(plot, curve) {
  const {view, block} = plot
  const motion = motionOf(curve, plot)
  const [x, y] = [view.axes[block.x], view.axes[block.y]]
  const {[curve.x]: xs = [], [curve.y]: ys = []} = view.columns[curve.source] ?? {}
  const [tall, tol_y] = [Math.abs(y.end - y.start), off(y, HIGH)]
  const seen = (/** @type {number} */ i) => ys[i] > y.start && ys[i] < y.end
  const turns = [...ys.keys()].filter(i => seen(i) && i > 0 && (ys[i] - ys[i - 1]) * (after(ys, i) - ys[i]) < 0)
  const found = turns.flatMap(i => {
    const sign = Math.sign(ys[i] - ys[i - 1])
    const share = ALONG.find(one => standsOut(xs, ys, i, sign, AROUND * one * Math.abs(x.end - x.start), tall))
    if (!share) return []
    const [at, is] = turned({xs, ys, motion}, i, sign)
    return [{f: sign > 0 ? "peak" : "trough", at: number(x, at), is: number(y, is), tol: off(x, share), tol_y}]
  })
  const start = seen(0) ? [{f: "value", at: number(x, xs[0]), is: number(y, ys[0]), tol: tol_y}] : []
  return [...start, ...found.slice(0, MOST)]
}

/**
 * The next different height, because two points next to a turning point may be drawn at the same height.
 * @param {ArrayLike<number>} ys @param {number} i
 */
const after = (ys, i) => Array.prototype.find.call(ys, (height, j) => j > i && height !== ys[i]) ?? ys[i]

/**
 * True if a turning point is the highest (lowest) within the distance `far`.
 * @param {ArrayLike<number>} xs @param {ArrayLike<number>} ys @param {number} i @param {number} sign
 * @param {number} far @param {number} tall
 */
function standsOut(xs, ys, i, sign, far, tall) {
  const around = Array.from(ys).filter((_, j) => Math.abs(xs[j] - xs[i]) <= far)
  const top = sign * ys[i]
  const edges = Math.max(sign * around[0], sign * around[around.length - 1])
  return around.every(one => sign * one <= top) && top - edges > STANDS_OUT * tall
}

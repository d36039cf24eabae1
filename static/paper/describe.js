// The description of a plot as it is now, in words and as a table: from the numbers that it is drawn with.

import {isCovered} from "../compare/cover.js"
import {element} from "../core/dom.js"
import {short, withUnit} from "../core/numbers.js"
import {evaluate} from "../core/signals.js"
import {indexed, plain} from "../core/plain.js"
import {stepOf} from "../core/ruler.js"

const BEYOND = "outside the frame"
const HALVINGS = 40 // of the way between two points, in which a curve turns
const ROWS = 25 // of a table: enough to follow a curve by ear

/** @typedef {import("./plots.js").Plot} Plot */
/**
 * A curve as it is drawn within the window, in one piece or several; `lines` counts those that lie side by side.
 * @typedef {{name: string, xs: number[], ys: number[], lines: number, motion: ((t: number) => number) | null}} Trace
 */

/**
 * A place of an axis as a number with its unit.
 * @param {page.Ruler} ruler @param {number} place
 */
export const measured = (ruler, place) => withUnit(digits(ruler, place), ruler.unit)

/**
 * No digit that a column does not have; what cannot be told from 0 is 0.
 * @param {page.Ruler} ruler @param {number} place
 */
function digits(ruler, place) {
  if (ruler.log) return short(10 ** place)
  const least = 10 ** Math.ceil(Math.log10(stepOf(ruler)))
  return short(Number((Math.round(place / least) * least).toPrecision(12)))
}

/**
 * Whether a place is in the frame: what is far outside is not sent.
 * @param {page.Ruler} ruler @param {number} place
 */
function isWithin({start, end}, place) {
  const room = 1e-3 * Math.abs(end - start)
  return place >= Math.min(start, end) - room && place <= Math.max(start, end) + room
}

/** The axes as they were told: those of a square plot show more. @param {Plot} plot */
export const axes = ({block, view}) => ({x: view.axes[block.x], y: view.axes[block.y]})

/** @param {page.Ruler} axis */
const span = axis => `${measured(axis, axis.start)} to ${measured(axis, axis.end)}`

/** @param {Plot} plot */
export function description(plot) {
  const {block, shown} = plot
  if (isCovered(plot))
    return `${block.title}. Covered until you press ${shown.state.step ? "Show the answer" : "Reveal"}.`
  const {x, y} = axes(plot)
  const told = [...traces(plot).map(trace => course(trace, x, y)), ...bands(plot), ...layers(plot)]
  return [`${block.title}.`, `Horizontal axis ${span(x)}, vertical axis ${span(y)}.`, ...told].join(" ")
}

/** The curves that are seen; pieces of one curve are one. @param {Plot} plot @returns {Trace[]} */
export function traces(plot) {
  const {block, view, hidden} = plot
  const {x} = axes(plot)
  /** @type {Map<string, Trace>} */
  const found = new Map()
  for (const curve of block.curves) {
    const {[curve.x]: xs, [curve.y]: ys} = view.columns[curve.source] ?? {}
    if (!ys?.length || hidden.has(curve.group)) continue
    const seen = [...xs.keys()].filter(i => isWithin(x, xs[i]))
    if (!seen.length) continue
    const name = nameOf(curve, plot)
    const trace = found.get(name) ?? {name, xs: [], ys: [], lines: 1, motion: motionOf(curve, plot)}
    if (xs[seen[0]] < (trace.xs.at(-1) ?? -Infinity)) trace.lines++
    trace.xs.push(...seen.map(i => xs[i]))
    trace.ys.push(...seen.map(i => ys[i]))
    found.set(name, trace)
  }
  return [...found.values()]
}

/**
 * The motion of a curve over time: its signal at an instant, where it has one.
 * @param {page.Curve} curve @param {Plot} plot
 */
export function motionOf({signal, signal_x: across}, {block, view}) {
  const {signals, scalars} = view
  if (!block.time || across || !(signal in signals)) return null
  return (/** @type {number} */ t) => evaluate(signals, scalars, t)[signal]
}

/**
 * Where a curve truly turns next to its highest point that is drawn, or its lowest: between the points beside it.
 * @param {{xs: ArrayLike<number>, ys: ArrayLike<number>, motion: Trace["motion"]}} trace
 * @param {number} i @param {number} sign @returns {[number, number]}
 */
export function turned({xs, ys, motion}, i, sign) {
  if (!motion || i === 0 || i === xs.length - 1) return [xs[i], ys[i]]
  let [low, high] = [xs[i - 1], xs[i + 1]]
  for (let n = 0; n < HALVINGS; n++) {
    const [a, b] = [low + (high - low) / 3, high - (high - low) / 3]
    if (sign * motion(a) < sign * motion(b)) low = a
    else high = b
  }
  return [(low + high) / 2, motion((low + high) / 2)]
}

/** The points that are drawn lowest and highest. @param {Trace} trace */
const extremes = ({ys}) => [Math.min, Math.max].map(most => ys.indexOf(ys.reduce((a, b) => most(a, b))))

/**
 * A curve is called as it is read out, else as its label or its switch in the heading.
 * @param {page.Curve} curve @param {Plot} plot
 */
function nameOf({read, label, group}, {block, host}) {
  const place = block.heading.findIndex(term => term.curve === group)
  const part = host.parentElement?.querySelectorAll(".head .part")[place]
  return read || words(label) || (part ? plain(part).trim() : "") || "The curve"
}

/** @param {page.Runs} runs */
const words = runs => runs.map(({text}) => text).join("")

/**
 * Where a curve goes: from, to, its lowest and highest point.
 * @param {Trace} trace @param {page.Ruler} x @param {page.Ruler} y
 */
function course(trace, x, y) {
  const {name, xs, ys, lines} = trace
  const [lowest, highest] = extremes(trace)
  const last = ys.length - 1
  /** @param {number} i */
  const height = i => (isWithin(y, ys[i]) ? measured(y, ys[i]) : BEYOND)
  /** @param {[number, number]} place */
  const at = ([across, up]) => (isWithin(y, up) ? `${measured(y, up)} at ${measured(x, across)}` : BEYOND)
  const ends = `lowest ${at(turned(trace, lowest, -1))}, highest ${at(turned(trace, highest, 1))}`
  const [from, to] = [height(0), height(last)]
  if (lines > 1) return `${name}, ${lines} lines: ${ends}.`
  if (!last) return `${name}: ${at([xs[0], ys[0]])}.`
  if (height(lowest) === height(highest)) return `${name}: ${from} throughout.`
  const steps = ys.slice(1).map((value, i) => value - ys[i])
  if (steps.every(step => step >= 0)) return `${name}: rises from ${from} to ${to}.`
  if (steps.every(step => step <= 0)) return `${name}: falls from ${from} to ${to}.`
  return `${name}: from ${from} to ${to}, ${ends}.`
}

/** Curves too fast for a line. @param {Plot} plot */
function bands(plot) {
  const {block, view, hidden} = plot
  const {y} = axes(plot)
  return block.regions.flatMap(({of, source, low, high, group}) => {
    const {[low]: lows, [high]: highs} = view.columns[source] ?? {}
    if (!of || !lows?.length || !highs?.length || hidden.has(group)) return []
    const ends = `${measured(y, Math.min(...lows))} and ${measured(y, Math.max(...highs))}`
    return [`${indexed(of)}: too fast to be drawn as a line; it fills the band between ${ends}.`]
  })
}

/** The layers of a stack, each by its thickness. @param {Plot} plot */
function layers(plot) {
  const {block, view} = plot
  const {y} = axes(plot)
  return block.regions.flatMap(({read, source, low, high}) => {
    const {[low]: lows, [high]: highs} = view.columns[source] ?? {}
    if (!read || !lows?.length || !highs?.length) return []
    const sizes = [...highs].map((top, i) => Math.abs(top - lows[i]))
    return [`${read}: between ${measured(y, Math.min(...sizes))} and ${measured(y, Math.max(...sizes))}.`]
  })
}

/**
 * A few points of each curve and those at which a motion turns lowest and highest, in the units of the axes.
 * @param {Plot} plot
 */
export function table(plot) {
  const {x, y} = axes(plot)
  const all = traces(plot)
  const places = [...new Set([...spread(all), ...all.flatMap(turns)])].toSorted((a, b) => a - b)
  const head = [
    element("th", {scope: "col"}, `at, ${x.unit}`),
    ...all.map(({name}) => element("th", {scope: "col"}, unit(name, y))),
  ]
  const lines = places.map(place =>
    element(
      "tr",
      {},
      element("th", {scope: "row"}, digits(x, place)),
      ...all.map(trace => element("td", {}, near(trace, place, y))),
    ),
  )
  return element(
    "table",
    {class: "points"},
    element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...lines),
  )
}

/** @param {string} name @param {page.Ruler} ruler */
const unit = (name, {unit: sign}) => (sign ? `${name}, ${sign}` : name)

/** Places spread evenly over those of the longest curve. @param {Trace[]} all */
function spread(all) {
  const {xs} = all.toSorted((a, b) => b.xs.length - a.xs.length)[0] ?? {xs: []}
  const step = Math.max((xs.length - 1) / (ROWS - 1), 1)
  return [...new Set(Array.from({length: Math.min(ROWS, xs.length)}, (_, i) => xs[Math.round(i * step)]))]
}

/** The instants at which a motion is lowest and highest. @param {Trace} trace */
function turns(trace) {
  if (!trace.motion) return []
  const [lowest, highest] = extremes(trace)
  return [turned(trace, lowest, -1)[0], turned(trace, highest, 1)[0]]
}

/**
 * The number of a curve at a place of its own, or of its motion at any; else none.
 * @param {Trace} trace @param {number} place @param {page.Ruler} y
 */
function near({xs, ys, motion}, place, y) {
  const height = ys[xs.indexOf(place)] ?? motion?.(place)
  if (height === undefined) return ""
  return isWithin(y, height) ? digits(y, height) : "outside"
}

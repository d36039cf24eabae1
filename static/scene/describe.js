// The description of a plot in words and as a table, from the numbers that it is drawn with.

import {isCovered} from "../compare/cover.js"
import {element} from "../core/dom.js"
import {short, withUnit} from "../core/numbers.js"
import {evaluate} from "../core/signals.js"
import {indexed, plain} from "../core/plain.js"
import {stepOf} from "../core/ruler.js"

const BEYOND = "outside the frame"
const HALVINGS = 40 // steps of the search for a turning point between two drawn points
const MOST_PIECES = 3 // the most pieces of a curve that are described one by one
const ROWS = 25 // rows of a table, enough to follow a curve with a screen reader

/** @typedef {import("./plots.js").Plot} Plot */
/**
 * A curve for the description: its points within the time window, all its connected pieces, and how many lines have
 * this name.
 * @typedef {{name: string, xs: number[], ys: number[], pieces: Piece[], lines: number,
 *   motion: ((t: number) => number) | null}} Trace
 */
/**
 * A connected piece of a curve. `cutStart`, `cutEnd`: the edge of the frame cuts off that end.
 * @typedef {{xs: number[], ys: number[], cutStart?: boolean, cutEnd?: boolean}} Piece
 */

/**
 * A coordinate of an axis as a number with its unit.
 * @param {page.Ruler} ruler @param {number} place
 */
export const measured = (ruler, place) => withUnit(digits(ruler, place), ruler.unit)

/**
 * Rounds to the digits of a column; numbers that cannot be distinguished from 0 become 0.
 * @param {page.Ruler} ruler @param {number} place
 */
function digits(ruler, place) {
  if (ruler.log) return short(10 ** place)
  const least = 10 ** Math.ceil(Math.log10(stepOf(ruler)))
  return short(Number((Math.round(place / least) * least).toPrecision(12)))
}

/**
 * True if a coordinate is in the frame.
 * @param {page.Ruler} ruler @param {number} place
 */
function isWithin({start, end}, place) {
  const room = 1e-3 * Math.abs(end - start)
  return place >= Math.min(start, end) - room && place <= Math.max(start, end) + room
}

/** The axes as the server sent them; a square plot shows a larger range. @param {Plot} plot */
export const axes = ({block, view}) => ({x: view.axes[block.x], y: view.axes[block.y]})

/** @param {page.Ruler} axis */
const span = axis => `${measured(axis, axis.start)} to ${measured(axis, axis.end)}`

/**
 * Texts with their {live numbers}, by name, except texts with a hidden number.
 * @param {Record<string, string>} texts @param {Record<string, string>} values
 */
export function spoken(texts, values) {
  /** @type {Map<string, string>} */
  const found = new Map()
  for (const [name, text] of Object.entries(texts)) {
    const parts = text.split(/[{}]/)
    const isThere = parts.every((part, i) => i % 2 === 0 || values[part])
    if (isThere) found.set(name, parts.map((part, i) => (i % 2 ? values[part] : part)).join(""))
  }
  return found
}

/** @param {Plot} plot */
export function description(plot) {
  const {block, shown, view} = plot
  if (isCovered(plot))
    return `${block.title}. Covered until you press ${shown.state.step ? "Show the answer" : "Reveal"}.`
  const {x, y} = axes(plot)
  const lines = [...traces(plot).map(trace => course(trace, x, y)), ...bands(plot), ...layers(plot)]
  const numbers = [...spoken(block.says, view.values)].map(([name, text]) => `${name} ${text}`).join("; ")
  const now = numbers && [`${numbers[0].toUpperCase()}${numbers.slice(1)}.`]
  return [`${block.title}.`, ...now, `Horizontal axis ${span(x)}, vertical axis ${span(y)}.`, ...lines].join(" ")
}

/** The visible curves; the pieces of a curve are together. @param {Plot} plot @returns {Trace[]} */
export function traces(plot) {
  const {block, view, hidden} = plot
  const {x} = axes(plot)
  /** @type {Map<string, Trace>} */
  const found = new Map()
  for (const curve of block.curves) {
    const {[curve.x]: xs, [curve.y]: ys} = view.columns[curve.source] ?? {}
    if (!ys?.length || hidden.has(curve.group)) continue
    const name = nameOf(curve, plot)
    const trace = found.get(name) ?? {name, xs: [], ys: [], pieces: [], lines: 1, motion: motionOf(curve, plot)}
    const seen = [...xs.keys()].filter(i => isWithin(x, xs[i]))
    if (seen.length && xs[seen[0]] < (trace.xs.at(-1) ?? -Infinity)) trace.lines++
    trace.xs.push(...seen.map(i => xs[i]))
    trace.ys.push(...seen.map(i => ys[i]))
    join(trace.pieces, connected(xs, ys))
    found.set(name, trace)
  }
  return [...found.values()]
}

/**
 * The function of time that a curve shows; null if it has no signal.
 * @param {page.Curve} curve @param {Plot} plot
 */
export function motionOf({signal, signal_x: across}, {block, view}) {
  const {signals, scalars} = view
  if (!block.time || across || !(signal in signals)) return null
  return (/** @type {number} */ t) => evaluate(signals, scalars, t)[signal]
}

/**
 * The exact extremum of a curve near its highest or lowest drawn point, between the neighbouring points.
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

/** The lowest and the highest drawn point. @param {Trace} trace */
const extremes = ({ys}) => [Math.min, Math.max].map(most => ys.indexOf(ys.reduce((a, b) => most(a, b))))

/**
 * The name of a curve: the name for the tooltip, else its label, else its switch in the heading.
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
 * The pieces of a line between its gaps.
 * @param {ArrayLike<number>} xs @param {ArrayLike<number>} ys @returns {Piece[]}
 */
function connected(xs, ys) {
  /** @type {Piece[]} */
  const found = []
  for (let i = 0, apart = true; i < ys.length; i++) {
    const isGap = !Number.isFinite(xs[i]) || !Number.isFinite(ys[i])
    if (!isGap && apart) found.push({xs: [], ys: []})
    if (!isGap) found.at(-1)?.xs.push(xs[i])
    if (!isGap) found.at(-1)?.ys.push(ys[i])
    apart = isGap
  }
  return found
}

/**
 * Appends pieces, and joins the first of them to the last known piece if they meet. @param {Piece[]} known @param
 * {Piece[]} more
 */
function join(known, more) {
  const [last, next] = [known.at(-1), more[0]]
  const goesOn = last && next && last.xs.at(-1) === next.xs[0] && last.ys.at(-1) === next.ys[0]
  if (goesOn) {
    last.xs.push(...next.xs)
    last.ys.push(...next.ys)
  }
  known.push(...more.slice(goesOn ? 1 : 0))
}

/**
 * The parts of a piece inside the frame.
 * @param {Piece} piece @param {page.Ruler} x @param {page.Ruler} y @returns {Piece[]}
 */
function inside({xs, ys}, x, y) {
  /** @type {Piece[]} */
  const found = []
  const isSeen = (/** @type {number} */ i) => isWithin(x, xs[i]) && isWithin(y, ys[i])
  if (xs.length === 1) return isSeen(0) ? [{xs, ys}] : []
  for (let i = 1; i < xs.length; i++) {
    const [from, to] = cut([xs[i - 1], ys[i - 1]], [xs[i], ys[i]], x, y)
    if (from > to) continue
    const place = (/** @type {number} */ share) => [between(xs, i, share), between(ys, i, share)]
    let part = from === 0 && isSeen(i - 1) ? found.at(-1) : undefined
    if (!part) {
      const [across, up] = place(from)
      part = {xs: [across], ys: [up], cutStart: isCut(y, ys[i - 1], up)}
      found.push(part)
    }
    const [across, up] = place(to)
    part.xs.push(across)
    part.ys.push(up)
    part.cutEnd = isCut(y, ys[i], up)
  }
  return found
}

/** Linear interpolation between entries i - 1 and i. @param {number[]} all @param {number} i @param {number} share */
const between = (all, i, share) => (share === 1 ? all[i] : all[i - 1] + share * (all[i] - all[i - 1]))

/**
 * True if a line that ends outside the frame leaves it at this height, through the upper or lower edge.
 * @param {page.Ruler} y @param {number} end @param {number} height
 */
function isCut(y, end, height) {
  const least = Math.min(...edges(y).map(edge => Math.abs(height - edge)))
  return !isWithin(y, end) && least < 1e-6 * Math.abs(y.end - y.start)
}

/** The edges of the frame, with a margin. @param {page.Ruler} ruler @param {number} [share] */
function edges({start, end}, share = 1e-3) {
  const more = share * Math.abs(end - start)
  return [Math.min(start, end) - more, Math.max(start, end) + more]
}

/**
 * The shares of the distance between two points at which a line enters the frame and leaves it; the first is larger if
 * the line stays outside (Y.-D. Liang and B. A. Barsky, ACM Trans. Graph. 3 (1984) 1).
 * @param {number[]} one @param {number[]} two @param {page.Ruler} x @param {page.Ruler} y
 */
function cut(one, two, x, y) {
  let [from, to] = [0, 1]
  for (const [i, ruler] of [x, y].entries()) {
    const step = two[i] - one[i]
    const [low, high] = edges(ruler, ruler === x && step !== 0 ? 0 : undefined)
    if (step === 0) {
      if (one[i] < low || one[i] > high) return [1, 0]
      continue
    }
    const [enters, leaves] = step > 0 ? [low, high] : [high, low]
    from = Math.max(from, (enters - one[i]) / step)
    to = Math.min(to, (leaves - one[i]) / step)
  }
  return [from, to]
}

/**
 * The course of a curve within the frame: one phrase for each piece, or only its extremes if there are many pieces.
 * @param {Pick<Trace, "name" | "pieces" | "lines" | "motion">} trace @param {page.Ruler} x @param {page.Ruler} y
 */
export function course({name, pieces, lines, motion}, x, y) {
  const seen = pieces.flatMap(piece => inside(piece, x, y))
  if (!seen.length) return `${name}: ${BEYOND} throughout.`
  if (lines > 1 || seen.length > MOST_PIECES) {
    const what = lines > 1 ? `${lines} lines` : `${seen.length} pieces`
    return `${name}, ${what}: ${extent(seen, motion, x, y)}.`
  }
  if (seen.length === 1) return `${name}: ${way(seen[0], motion, x, y, isAlone(seen[0], pieces, x))}.`
  const parts = seen.map(one => placed(one, motion, x, y))
  return `${name}, ${seen.length} pieces: ${parts.join("; ")}.`
}

/**
 * The course of one of several pieces, with its range of x.
 * @param {Piece} one @param {Trace["motion"]} motion @param {page.Ruler} x @param {page.Ruler} y
 */
function placed(one, motion, x, y) {
  const [first, last] = [one.xs[0], one.xs.at(-1) ?? 0].map(place => measured(x, place))
  const phrase = way(one, motion, x, y, false)
  if (isUpright(one)) return phrase
  return `from ${first} to ${last} it ${phrase.startsWith("from ") ? "goes " : ""}${phrase}`
}

/** True if a piece is a point or a vertical line. @param {Piece} piece */
const isUpright = ({xs}) => xs.every(place => place === xs[0])

/**
 * True if the only piece inside the frame is the whole curve within the window.
 * @param {Piece} one @param {Piece[]} pieces @param {page.Ruler} x
 */
function isAlone({cutStart, cutEnd}, pieces, x) {
  const others = pieces.filter(({xs}) => xs.some(place => isWithin(x, place)))
  return !cutStart && !cutEnd && others.length <= 1
}

/**
 * The lowest and highest point of all pieces; "outside the frame" if the frame cuts them off.
 * @param {Piece[]} seen @param {Trace["motion"]} motion @param {page.Ruler} x @param {page.Ruler} y
 */
function extent(seen, motion, x, y) {
  const ends = [-1, 1].map(sign => {
    const places = seen.map(one => extreme(one, motion, sign))
    return places.reduce((best, place) => (sign * (place[1] - best[1]) > 0 ? place : best))
  })
  const [lowest, highest] = ends.map(([across, up]) =>
    isWithin(y, up) ? `${measured(y, up)} at ${measured(x, across)}` : BEYOND,
  )
  return `lowest ${lowest}, highest ${highest}`
}

/**
 * The lowest (sign −1) or highest (1) point of a piece; infinite if it is cut there.
 * @param {Piece} one @param {Trace["motion"]} motion @param {number} sign @returns {[number, number]}
 */
function extreme(one, motion, sign) {
  const {xs, ys, cutStart, cutEnd} = one
  const i = ys.indexOf(ys.reduce((a, b) => (sign > 0 ? Math.max(a, b) : Math.min(a, b))))
  const isEnd = (i === 0 && cutStart) || (i === ys.length - 1 && cutEnd)
  return isEnd ? [xs[i], sign * Infinity] : turned({xs, ys, motion}, i, sign)
}

/**
 * The course of one piece: its first and last value, and its lowest and highest point.
 * @param {Piece} one @param {Trace["motion"]} motion @param {page.Ruler} x @param {page.Ruler} y
 * @param {boolean} isWhole
 */
function way(one, motion, x, y, isWhole) {
  const {xs, ys, cutStart, cutEnd} = one
  const from = cutStart ? BEYOND : measured(y, ys[0])
  const to = cutEnd ? BEYOND : measured(y, ys.at(-1) ?? 0)
  const [lowest, highest] = [Math.min(...ys), Math.max(...ys)].map(place => measured(y, place))
  const isLevel = lowest === highest && !cutStart && !cutEnd
  if (isUpright(one)) {
    const at = `at ${measured(x, xs[0])}`
    return isLevel ? `${from} ${at}` : `upright ${at}, from ${from} to ${to}`
  }
  if (isLevel) return isWhole ? `${from} throughout` : `stays at ${from}`
  const steps = ys.slice(1).map((value, i) => value - ys[i])
  if (steps.every(step => step >= 0)) return `rises from ${from} to ${to}`
  if (steps.every(step => step <= 0)) return `falls from ${from} to ${to}`
  return `from ${from} to ${to}, ${extent([one], motion, x, y)}`
}

/**
 * Curves that are drawn as bands, because their motion is too fast for a line, or too fast at first. @param {Plot} plot
 */
function bands(plot) {
  const {block, view, hidden} = plot
  const {x, y} = axes(plot)
  return block.regions.flatMap(({of, source, x: across, low, high, group}) => {
    const {[across]: xs, [low]: lows, [high]: highs} = view.columns[source] ?? {}
    if (!of || !lows?.length || !highs?.length || hidden.has(group)) return []
    const ends = `${measured(y, Math.min(...lows))} and ${measured(y, Math.max(...highs))}`
    const last = xs?.at(-1) ?? x.end
    const until = last < x.end * (1 - 1e-4) ? `up to ${measured(x, last)} ` : ""
    return [`${indexed(of)}: ${until}too fast to be drawn as a line; it fills the band between ${ends}.`]
  })
}

/** The layers of a stack, each described by its thickness. @param {Plot} plot */
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
 * A table with some points of each curve and with the extremes of each motion, in the units of the axes.
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

/** Some x of the curve with most points, evenly spread over its points. @param {Trace[]} all */
function spread(all) {
  const {xs} = all.toSorted((a, b) => b.xs.length - a.xs.length)[0] ?? {xs: []}
  const step = Math.max((xs.length - 1) / (ROWS - 1), 1)
  return [...new Set(Array.from({length: Math.min(ROWS, xs.length)}, (_, i) => xs[Math.round(i * step)]))]
}

/** The instants of the minima and maxima of a motion. @param {Trace} trace */
function turns(trace) {
  if (!trace.motion) return []
  const [lowest, highest] = extremes(trace)
  return [turned(trace, lowest, -1)[0], turned(trace, highest, 1)[0]]
}

/**
 * The value of a curve at `place`, if it has a point there or a motion; else "".
 * @param {Trace} trace @param {number} place @param {page.Ruler} y
 */
function near({xs, ys, motion}, place, y) {
  const height = ys[xs.indexOf(place)] ?? motion?.(place)
  if (height === undefined) return ""
  return isWithin(y, height) ? digits(y, height) : "outside"
}

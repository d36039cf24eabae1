// A record, made from columns of a table: times, and for each mass its displacements, velocities or accelerations in SI
// units. This module also cuts a record into the pieces that are sent to the server.

const MOST_SENT = 20_000
const PIECE = 1250 // rows: components/language/messages.py
const LEAST = 8
const DIGITS = 9
const MOTION = /^\W*(x|y|z|pos|disp|dist|height|left|right)/i

/** Sizes of units. @type {Record<string, number>} */
export const TIMES = {s: 1, ms: 1e-3, min: 60}
/** @type {Record<string, number>} */
export const VALUES = {m: 1, cm: 1e-2, mm: 1e-3, "m/s": 1, "m/s²": 1, g: 9.80665}
/** The order of the derivative of the displacement, by unit. @type {Record<string, number>} */
const DERIVATIVES = {"m/s": 1, "m/s²": 2, g: 2}

/** A chosen column and its unit, "" for a unit that is not known. @typedef {{place: number, unit: string}} Column */
/** The columns of the time and of each motion. @typedef {{time: Column, motions: Column[]}} ColumnChoice */
/**
 * Times from the first row, and columns of displacements or of a derivative of them; `left` is the number of rows that
 * are left out.
 * @typedef {{t: Float64Array, columns: Float64Array[], derivative: number, left: number}} Rows
 */
/** @typedef {import("./table.js").Table} Table */

/**
 * A first choice of columns, by their names, or else by their numbers.
 * @param {Table} table @param {number} count of motions @returns {ColumnChoice}
 */
export function guessed({names, columns}, count) {
  const named = names.findIndex(name => /^\W*(t|time|zeit)\b/i.test(name))
  const grows = columns.findIndex(column => column.every((value, i) => !i || !(value <= column[i - 1])))
  const time = [named, grows, 0].find(place => place >= 0) ?? 0
  const others = columns.map((_, i) => i).filter(i => i !== time)
  const motions = others.toSorted((a, b) => Number(MOTION.test(names[b])) - Number(MOTION.test(names[a])))
  return {
    time: {place: time, unit: unitIn(names[time], TIMES)},
    motions: Array.from({length: count}, (_, i) => motions[Math.min(i, motions.length - 1)]).map(place => ({
      place,
      unit: unitIn(names[place], VALUES),
    })),
  }
}

/** The unit in "t (s)", "x [mm]" or "x/mm"; "" for none that is known. @param {string} name @param {object} known */
export function unitIn(name, known) {
  const [, unit = ""] = name.replace("^2", "²").match(/[([/]\s*([^\s)\]]+)\s*[)\]]?\s*$/) ?? []
  return unit in known ? unit : ""
}

/**
 * The rows of the chosen columns, without rows in which a number is missing.
 * @param {Table} table @param {ColumnChoice} choice @returns {Rows}
 */
export function rowsOf({columns, lines}, {time, motions}) {
  const places = [time, ...motions].map(({place}) => place)
  if (new Set(places).size < places.length)
    throw new Error("One column is chosen twice: a file needs a column of times and one for each mass.")
  const derivatives = motions.map(({unit}) => DERIVATIVES[unit] ?? 0)
  if (new Set(derivatives).size > 1)
    throw new Error("The units of the columns differ in kind: choose displacements, velocities or accelerations.")
  const whole = lines.map((_, i) => i).filter(i => places.every(place => !Number.isNaN(columns[place][i])))
  if (whole.length < LEAST)
    throw new Error(`${whole.length} rows have a number in each column: ${LEAST} or more are needed.`)
  const times = columns[time.place]
  const t = Float64Array.from(whole, i => (times[i] - times[whole[0]]) * TIMES[time.unit])
  const back = t.findIndex((now, i) => i > 0 && now < t[i - 1])
  if (back >= 0) throw new Error(`Line ${lines[whole[back]]}: the time goes back. The times of a file must increase.`)
  return {
    t,
    columns: motions.map(({place, unit}) => Float64Array.from(whole, i => columns[place][i] * VALUES[unit])),
    derivative: derivatives[0],
    left: lines.length - whole.length,
  }
}

/**
 * The messages that carry rows to the server: means of neighbouring rows if there are too many.
 * @param {Rows} rows @returns {page.SendRows[]}
 */
export function piecesOf({t, columns, derivative}) {
  const size = Math.ceil(t.length / MOST_SENT)
  const [times, ...means] = [t, ...columns].map(column => meansOf(column, size))
  const of = Math.ceil(times.length / PIECE)
  return Array.from({length: of}, (_, piece) => {
    const part = (/** @type {number[]} */ rows) => rows.slice(piece * PIECE, (piece + 1) * PIECE)
    return {type: "rows", piece, of, size, derivative, t: part(times), columns: means.map(part)}
  })
}

/** @param {Float64Array} column @param {number} size */
function meansOf(column, size) {
  return Array.from({length: Math.floor(column.length / size)}, (_, i) => {
    const block = column.subarray(i * size, (i + 1) * size)
    return Number((block.reduce((sum, one) => sum + one, 0) / size).toPrecision(DIGITS))
  })
}

/**
 * The rows that a drawing shows: the lowest and the highest one of each step along the axis.
 * @param {ArrayLike<number>} places in units along the axis, never decreasing @param {ArrayLike<number>} values
 * @param {number} step in units
 */
export function drawnRows(places, values, step) {
  /** @type {number[]} */
  const drawn = []
  for (let i = 0; i < places.length;) {
    const bin = Math.floor(places[i] / step)
    let [low, high] = [i, i]
    for (i++; i < places.length && Math.floor(places[i] / step) === bin; i++) {
      if (values[i] < values[low]) low = i
      if (values[i] > values[high]) high = i
    }
    drawn.push(...(low === high ? [low] : [Math.min(low, high), Math.max(low, high)]))
  }
  return drawn
}

// A record: times and displacements, velocities or accelerations in SI units, from two columns of a table; and its
// pieces for the server.

const MOST_SENT = 20_000
const PIECE = 1250 // rows: components/language/messages.py
const LEAST = 8
const DIGITS = 10

/** Sizes of units. @type {Record<string, number>} */
export const TIMES = {s: 1, ms: 1e-3, min: 60}
/** @type {Record<string, number>} */
export const VALUES = {m: 1, cm: 1e-2, mm: 1e-3, "m/s": 1, "m/s²": 1, g: 9.80665}
/** The order of the derivative, by its unit. @type {Record<string, number>} */
const DERIVATIVES = {"m/s": 1, "m/s²": 2, g: 2}

/**
 * The chosen columns and their units, "" for a unit that is not known.
 * @typedef {{time: number, value: number, timeUnit: string, valueUnit: string}} ColumnChoice
 */
/**
 * Times from the first row, and displacements or a derivative of them; `left` is the number of rows that are left out.
 * @typedef {{t: Float64Array, x: Float64Array, derivative: number, left: number}} Rows
 */
/** @typedef {import("./table.js").Table} Table */

/**
 * A first choice of columns, by their names, or else by what they hold.
 * @param {Table} table @returns {ColumnChoice}
 */
export function guessed({names, columns}) {
  const named = (/** @type {RegExp} */ pattern) => names.findIndex(name => pattern.test(name))
  const grows = columns.findIndex(column => column.every((value, i) => !i || !(value <= column[i - 1])))
  const time = [named(/^\W*(t|time|zeit)\b/i), grows, 0].find(place => place >= 0) ?? 0
  const others = columns.map((_, i) => i).filter(i => i !== time)
  const value = others.find(i => /^\W*(x|y|z|pos|disp|dist|height)/i.test(names[i])) ?? others[0]
  return {time, value, timeUnit: unitIn(names[time], TIMES), valueUnit: unitIn(names[value], VALUES)}
}

/** The unit in "t (s)", "x [mm]" or "x/mm"; "" for none that is known. @param {string} name @param {object} known */
export function unitIn(name, known) {
  const [, unit = ""] = name.replace("^2", "²").match(/[([/]\s*([^\s)\]]+)\s*[)\]]?\s*$/) ?? []
  return unit in known ? unit : ""
}

/**
 * The rows of two columns, without those that lack a number.
 * @param {Table} table @param {ColumnChoice} choice @returns {Rows}
 */
export function rowsOf({columns, lines}, {time, value, timeUnit, valueUnit}) {
  const whole = lines.map((_, i) => i).filter(i => !Number.isNaN(columns[time][i] + columns[value][i]))
  if (whole.length < LEAST) throw new Error(`${whole.length} rows have both numbers: ${LEAST} or more are needed.`)
  const start = columns[time][whole[0]]
  const t = Float64Array.from(whole, i => (columns[time][i] - start) * TIMES[timeUnit])
  const back = t.findIndex((now, i) => i > 0 && now < t[i - 1])
  if (back >= 0) throw new Error(`Line ${lines[whole[back]]}: the time goes back. The times of a file must increase.`)
  return {
    t,
    x: Float64Array.from(whole, i => columns[value][i] * VALUES[valueUnit]),
    derivative: DERIVATIVES[valueUnit] ?? 0,
    left: lines.length - whole.length,
  }
}

/**
 * The messages that carry rows to the server: means of neighbouring rows if there are too many.
 * @param {Rows} rows @returns {page.SendRows[]}
 */
export function piecesOf({t, x, derivative}) {
  const size = Math.ceil(t.length / MOST_SENT)
  const [times, means] = [t, x].map(column => meansOf(column, size))
  const of = Math.ceil(times.length / PIECE)
  return Array.from({length: of}, (_, piece) => {
    const [start, end] = [piece * PIECE, (piece + 1) * PIECE]
    return {type: "rows", piece, of, size, derivative, t: times.slice(start, end), x: means.slice(start, end)}
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

// A table of numbers from the text of a file: CSV or TSV, with or without names of its columns.

export const MOST_BYTES = 5 * 2 ** 20
const MOST_ROWS = 200_000
const MOST_COLUMNS = 50
const LONGEST_LINE = 2000 // characters
const MOST_NAMES = 100 // lines before the numbers
const NEEDED = "A file needs a column of times and one of the motion."
const SEPARATORS = ["\t", ";", ","]

/**
 * Columns of numbers, NaN where a cell is empty or is no number; `lines` has the line of the file of each row.
 * @typedef {{names: string[], columns: Float64Array[], lines: number[]}} Table
 */
/**
 * The parser of lines: Papa Parse.
 * @typedef {{parse(text: string, how: {delimiter: string}): {data: string[][]}}} Parser
 */

/** A table and the name of its file. @typedef {{name: string, table: Table}} NamedTable */

/** The text of a file; spreadsheets also write UTF-16. @param {Uint8Array} bytes */
export function textOf(bytes) {
  const isWide = bytes[0] === 0xff && bytes[1] === 0xfe
  return new TextDecoder(isWide ? "utf-16le" : "utf-8").decode(bytes)
}

/**
 * The tables among files, or throws the reason why the first one is none.
 * @param {{name: string, bytes: Uint8Array}[]} files @param {Parser} parser @returns {NamedTable[]}
 */
export function tablesOf(files, parser) {
  /** @type {Error[]} */
  const reasons = []
  const tables = files.flatMap(({name, bytes}) => {
    try {
      return [{name, table: tableOf(textOf(bytes), parser)}]
    } catch (reason) {
      reasons.push(new Error(`${name}: ${/** @type {Error} */ (reason).message}`))
      return []
    }
  })
  if (!tables.length) throw reasons[0]
  return tables
}

/** Reads a table, or throws the reason with the line. @param {string} text @param {Parser} parser @returns {Table} */
export function tableOf(text, parser) {
  const lines = linesOf(text)
  const delimiter = delimiterOf(lines)
  const rows = parser.parse(lines.join("\n"), {delimiter}).data
  const read = (/** @type {string[]} */ cells) => cells.map(cell => numberOf(cell, delimiter))
  const first = firstRow(rows.slice(0, MOST_NAMES).map(read))
  if (first < 0)
    throw new Error(`Line ${filled(lines)}: “${excerpt(lines[filled(lines) - 1])}” has no two numbers. ${NEEDED}`)
  const width = rows[first].length
  if (width > MOST_COLUMNS)
    throw new Error(`Line ${first + 1}: it has ${width} columns, and at most ${MOST_COLUMNS} are read.`)
  const numbers = rows.slice(first).map(read)
  const kept = numbers.flatMap((_, i) => (rows[first + i].some(cell => cell.trim()) ? [i] : []))
  refuseWords(rows, numbers, first, kept)
  return {
    names: namesOf(rows[first - 1] ?? [], width),
    columns: Array.from({length: width}, (_, column) => Float64Array.from(kept, i => numbers[i][column] ?? NaN)),
    lines: kept.map(i => first + i + 1),
  }
}

/** The lines of a text that may be a table. @param {string} text */
function linesOf(text) {
  if (text.includes("\0")) throw new Error("Line 1: this is no text. Save the table as a CSV file.")
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/)
  if (!text.trim()) throw new Error(`Line 1: it is empty. ${NEEDED}`)
  if (lines.length > MOST_ROWS + MOST_NAMES) {
    const rows = MOST_ROWS.toLocaleString("en")
    throw new Error(`Line ${MOST_ROWS + MOST_NAMES + 1}: the file goes on, and at most ${rows} rows are read.`)
  }
  const long = lines.findIndex(line => line.length > LONGEST_LINE)
  if (long >= 0) {
    const count = LONGEST_LINE.toLocaleString("en")
    throw new Error(`Line ${long + 1}: it is too long. At most ${count} characters of a line are read.`)
  }
  return lines
}

/**
 * The index of the first row of numbers. Rows in which some numbers are missing may come before the first complete one.
 * @param {number[][]} rows
 */
function firstRow(rows) {
  const counts = rows.map(row => row.filter(Number.isFinite).length)
  const whole = counts.findIndex(count => count > 1)
  return whole < 0 ? -1 : counts.findLastIndex((count, i) => i < whole && !count) + 1
}

/** The number of the first line that is not empty. @param {string[]} lines */
const filled = lines => lines.findIndex(line => line.trim()) + 1

/** The separator that most lines have; a comma only if nothing else separates. @param {string[]} lines */
function delimiterOf(lines) {
  const looked = lines.filter(line => line.trim()).slice(0, MOST_NAMES)
  return SEPARATORS.find(sign => looked.filter(line => line.includes(sign)).length > looked.length / 2) ?? ","
}

/** @param {string} cell @param {string} delimiter unless it is a comma, a comma in the cell is a decimal sign */
function numberOf(cell, delimiter) {
  const text = cell.trim().replace("\u2212", "-")
  const number = text ? Number(delimiter === "," ? text : text.replace(",", ".")) : NaN
  return Number.isFinite(number) ? number : NaN
}

/**
 * Throws the first cell that is no number, if most rows have no two numbers.
 * @param {string[][]} rows @param {number[][]} numbers @param {number} first @param {number[]} kept
 */
function refuseWords(rows, numbers, first, kept) {
  const bad = kept.filter(i => numbers[i].filter(Number.isFinite).length < 2)
  if (2 * bad.length <= kept.length) return
  const word = rows[first + bad[0]].find((cell, i) => cell.trim() && !Number.isFinite(numbers[bad[0]][i]))
  throw new Error(`Line ${first + bad[0] + 1}: “${excerpt(word ?? "")}” is not a number. ${NEEDED}`)
}

/** The names of columns; those without one are numbered. @param {string[]} cells @param {number} width */
const namesOf = (cells, width) =>
  Array.from({length: width}, (_, i) => (cells.length <= width && cells[i]?.trim().slice(0, 60)) || `Column ${i + 1}`)

/** The start of a text from the file, for error messages. @param {string} text */
const excerpt = text => (text.length > 40 ? `${text.slice(0, 39)}…` : text)

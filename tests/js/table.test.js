// Tables of measured data: separators, decimal signs, with or without names, with holes; and files that are no table.

import assert from "node:assert/strict"
import {execFileSync} from "node:child_process"
import {readFileSync} from "node:fs"
import {test} from "node:test"
import {runInThisContext} from "node:vm"

import {drawnRows, guessed, piecesOf, rowsOf} from "../../static/measured/record.js"
import {tableOfRows} from "../../static/measured/recorder.js"
import {tableOf, tablesOf, textOf} from "../../static/measured/table.js"
import {unpacked} from "../../static/measured/zip.js"

runInThisContext(readFileSync(new URL("../../components/serving/vendor/papaparse.min.js", import.meta.url), "utf8"))
const parser = globalThis.Papa

const rows = (count, row) => Array.from({length: count}, (_, i) => row(i)).join("\n")
const recordIn = (text, count = 1) => {
  const table = tableOf(text, parser)
  const {columns, ...rest} = rowsOf(table, guessed(table, count))
  return {...rest, columns, x: columns[0]}
}

const isClose = (found, expected) => Math.abs(found - expected) < 1e-12

for (const [name, text] of Object.entries({
  commas: `t (s),x (mm)\n${rows(10, i => `${i / 10},${i * i}`)}\n`,
  tabs: `"Time (ms)"\t"Position (cm)"\r\n${rows(10, i => `${100 * i}\t${i * i * 0.1}`).replaceAll("\n", "\r\n")}`,
  semicolons: `Zeit [s];x/mm\n${rows(10, i => `${i / 10};${i * i}`.replaceAll(".", ","))}`,
  remarks: `Recorded on a phone\n\nrow,t (s),x (mm)\n${rows(10, i => `${i},${i / 10},${i * i}`)}`,
}))
  test(`a file with ${name} gives the same record`, () => {
    const {t, x, left} = recordIn(text)
    assert.deepEqual([left, t.length], [0, 10])
    assert.ok(t.every((value, i) => isClose(value, i / 10)) && x.every((value, i) => isClose(value, i * i * 1e-3)))
  })

test("without names the first column that only grows is the time, and units are asked for", () => {
  const text = rows(10, i => `${Math.cos(i)};${i}`)
  const table = tableOf(text, parser)
  assert.deepEqual(table.names, ["Column 1", "Column 2"])
  assert.deepEqual(guessed(table, 1), {time: {place: 1, unit: ""}, motions: [{place: 0, unit: ""}]})
})

for (const [unit, derivative, size] of [
  ["cm", 0, 0.01],
  ["m/s", 1, 1],
  ["m/s^2", 2, 1],
  ["g", 2, 9.80665],
])
  test(`a column in ${unit} is a displacement, a velocity or an acceleration`, () => {
    const record = recordIn(`Time (s),Linear Acceleration x (${unit})\n${rows(10, i => `${i},${i}`)}`)
    assert.deepEqual([record.derivative, record.x[3]], [derivative, 3 * size])
  })

test("two columns of one kind are read for two masses; rows with holes are left out and counted", () => {
  const text = `n,t (s),left (mm),right (cm)\n${rows(12, i => `${7 - i},${i},${i % 6 ? i * i : ""},${i % 3}`)}\n\n`
  const {t, columns, derivative, left} = recordIn(text, 2)
  assert.deepEqual([columns.length, columns[0][2], columns[1][4], derivative], [2, 9 * 1e-3, 0.02, 0])
  assert.deepEqual([t.length, t[0], left], [10, 0, 2])
})

test("a file without a record is refused with the line and the reason", () => {
  const refused = [
    ["", /^Line 1: it is empty/],
    ["\0\u0001", /^Line 1: this is no text/],
    ["\nA letter.\nIt has words.\n", /^Line 2: “A letter\.” has no two numbers/],
    [`1,2\n${rows(9, () => "one,two")}`, /^Line 2: “one” is not a number/],
    [`t (s),x (m)\n${rows(10, i => `${i === 7 ? 2 : i},${i}`)}`, /^Line 9: the time goes back/],
    ["t (s),x (m)\n1,2\n2,3\n", /^2 rows have a number in each column: 8 or more are needed/],
    [Array(1e6).fill("x").join(","), /^Line 1: it is too long. At most 2,000 characters/],
    [`t,x\n1,2\n${"9".repeat(5e6)}`, /^Line 3: it is too long/],
    [rows(9, () => "1,".repeat(60)), /^Line 1: it has 61 columns, and at most 50/],
    [`t (s),x (mm)\n${rows(10, i => `${i},${i * i}`)}`, /^One column is chosen twice/, 2],
    [`t (s),x (mm),y (m/s)\n${rows(10, i => `${i},${i * i},${i}`)}`, /^The units of the columns differ in kind/, 2],
    ["1,2\n".repeat(200101), /^Line 200101: the file goes on, and at most 200,000 rows/],
  ]
  for (const [text, reason, masses = 1] of refused) assert.throws(() => recordIn(text, masses), {message: reason})
})

test("a long record is sent as means, in pieces that fit into a message", () => {
  const count = 200_000
  const t = Float64Array.from({length: count}, (_, i) => i / 1000)
  const x = t.map(time => 1e-7 * Math.sin(6.3 * time) - 1e-7 / 3)
  const pieces = piecesOf({t, columns: [x, x], derivative: 0, left: 0})
  assert.equal(pieces.length, 16)
  for (const [i, {piece, of, size, t: times}] of pieces.entries()) {
    assert.deepEqual([piece, of, size, times.length], [i, 16, 10, 1250])
    assert.ok(JSON.stringify(pieces[i]).length < 60_000)
  }
  assert.equal(pieces[0].t[0], 0.0045)
})

test("a drawing keeps the lowest and the highest point of each step", () => {
  const places = Array.from({length: 1000}, (_, i) => i / 100)
  const values = places.map((_, i) => (i === 250 ? 9 : i === 777 ? -9 : Math.sin(i)))
  const drawn = drawnRows(places, values, 2)
  assert.ok(drawn.length <= 2 * 5)
  assert.ok(drawn.includes(250) && drawn.includes(777))
  assert.ok(drawn.every((row, i) => !i || row > drawn[i - 1]))
})

const bytesOf = text => new TextEncoder().encode(text)

const PACK = `import sys, zipfile
with zipfile.ZipFile(sys.stdout.buffer, "w", zipfile.ZIP_DEFLATED) as out:
    out.writestr(sys.argv[1], sys.argv[2] * int(sys.argv[3]))`

/** A zip file with a text so many times, packed by Python. */
const zip = (name, text, times = 1) => new Uint8Array(execFileSync("python3", ["-c", PACK, name, text, `${times}`]))

test("a zip file without tables, with too large ones, or a damaged one is refused with the reason", async () => {
  const whole = zip("a.csv", "1,2\n3,4\n")
  const cut = whole.slice()
  cut.set([255, 255, 255, 255], 35)
  for (const [file, reason] of [
    [zip("photo.jpg", "ab"), /^it has no CSV file\. Export/],
    [zip("bomb.csv", "9", 2 ** 23), /^its tables have more than 5 MB/],
    [cut, /^it is damaged or encrypted/],
    [whole.slice(0, 60), /^it is damaged or encrypted/],
  ])
    await assert.rejects(unpacked(file), {message: reason})
  assert.throws(() => tablesOf([{name: "a.csv", bytes: bytesOf("no\ntable\n")}], parser), {
    message: /^a\.csv: Line 1: “no” has no two numbers/,
  })
})

test("spreadsheets' UTF-16 is text too", () => {
  const wide = new Uint8Array([0xff, 0xfe, ...[..."t;x"].flatMap(sign => [sign.charCodeAt(0), 0])])
  assert.deepEqual([textOf(wide), textOf(bytesOf("t;x"))], ["t;x", "t;x"])
})

test("the axis of a recording with the largest motion comes first", () => {
  const {names, columns} = tableOfRows(Array.from({length: 9}, (_, i) => [500 + 20 * i, 0.1, (-1) ** i, 9.8]))
  assert.deepEqual(names, ["t (s)", "y (m/s²)", "x (m/s²)", "z (m/s²)"])
  assert.deepEqual([columns[0][2], columns[1][3]], [0.04, -1])
})

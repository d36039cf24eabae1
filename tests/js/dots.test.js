// The number line with a class's answers: absurd values do not stretch it.

import assert from "node:assert/strict"
import {test} from "node:test"

import "./browser.js"

const {beside, fitting, reach} = await import("../../static/questions/dots.js")

const many = (count, value) => Array.from({length: count}, () => value)

test("the line covers the most frequent answers and the correct value", () => {
  assert.deepEqual(reach([], []), [0, 0])
  assert.deepEqual(reach([], [2]), [2, 2])
  assert.deepEqual(reach([1, 2, 3], []), [1, 3])
  assert.deepEqual(reach([1, 2, 3], [20]), [1, 20])
  assert.deepEqual(reach([...many(100, 0.5), ...many(50, 5), ...many(30, 0.05)], [0.5]), [0.05, 5])
})

test("a few outliers are counted at the ends of the line, even with few answers", () => {
  assert.deepEqual(reach([0.5, 0.52, 1e6], [0.5]), [0.5, 0.52])
  assert.deepEqual(reach([...many(280, 0.498), -1e9, 1e300, 1e300], [0.498]), [0.498, 0.498])
  for (const far of [1e3, 1e30, -1e12, 1.7e308]) {
    const [low, high] = reach([1, 1.1, 1.2, 1.3, 1.4, far], [])
    assert.ok(low >= 1 && high <= 1.4)
  }
})

test("labels do not overlap; each is as close to its bar as the others allow", () => {
  const labels = [2, 1, 3].map(value => ({value, words: `${value}`, width: 60}))
  const at = value => 100 + 10 * value
  const row = beside(labels, at)
  assert.deepEqual(
    row.map(({from}) => from),
    [110, 120, 130],
  )
  for (const [i, {x}] of row.slice(1).entries()) assert.ok(x - row[i].x >= 68)
  assert.ok(row[0].x >= 30 && row[2].x <= 250)
  assert.deepEqual(
    beside([{value: 20, words: "20", width: 60}], at).map(({x}) => x),
    [250],
  )
  assert.equal(fitting(Array.from({length: 9}, () => labels[0])).length, 4)
})

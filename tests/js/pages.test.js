// The steps of a handout on pages: unbroken, in order, on as few pages as possible, evenly filled.

import "./browser.js"
import assert from "node:assert/strict"
import {test} from "node:test"
import {packed} from "../../static/export/pages.js"

const MOST = 950
let seed = 1
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647

/** The number of pages if each is filled before the next. @param {number[]} heights */
function inTurn(heights) {
  let [pages, used] = [1, 0]
  for (const height of heights) {
    if (used && used + height > MOST) {
      pages++
      used = 0
    }
    used += height
  }
  return pages
}

test("steps are unbroken, in order, on as few pages as possible", () => {
  for (let round = 0; round < 500; round++) {
    const heights = Array.from({length: 1 + Math.floor(20 * random())}, () => 60 + 900 * random())
    const pages = packed(heights, MOST)
    assert.deepEqual(
      pages.flatMap(([from, end]) => heights.slice(from, end)),
      heights,
    )
    const sums = pages.map(([from, end]) => heights.slice(from, end).reduce((sum, height) => sum + height))
    for (const [i, sum] of sums.entries()) assert.ok(sum <= MOST || pages[i][1] === pages[i][0] + 1)
    assert.equal(pages.length, inTurn(heights))
  }
})

test("pages are filled evenly, the last one too", () => {
  assert.deepEqual(packed([300, 300, 300, 100], MOST), [
    [0, 2],
    [2, 4],
  ])
  assert.deepEqual(packed([400, 400, 400, 400], MOST), [
    [0, 2],
    [2, 4],
  ])
})

test("a step longer than a page has its own page", () => {
  assert.deepEqual(packed([100, 2000, 100], MOST), [
    [0, 1],
    [1, 2],
    [2, 3],
  ])
  assert.deepEqual(packed([100], MOST), [[0, 1]])
})

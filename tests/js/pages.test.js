// A handout's steps on pages: whole, in their order, on as few as there can be, none half empty that need not be.

import "./browser.js"
import assert from "node:assert/strict"
import {test} from "node:test"
import {packed} from "../../static/export/pages.js"

const MOST = 950
let seed = 1
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647

/** The number of pages where each takes as much as it can. @param {number[]} heights */
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

test("steps stand whole, in their order, on as few pages as there can be", () => {
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

test("pages are filled evenly: the last one takes its share", () => {
  assert.deepEqual(packed([300, 300, 300, 100], MOST), [
    [0, 2],
    [2, 4],
  ])
  assert.deepEqual(packed([400, 400, 400, 400], MOST), [
    [0, 2],
    [2, 4],
  ])
})

test("a step that is longer than a page has one to itself", () => {
  assert.deepEqual(packed([100, 2000, 100], MOST), [
    [0, 1],
    [1, 2],
    [2, 3],
  ])
  assert.deepEqual(packed([100], MOST), [[0, 1]])
})

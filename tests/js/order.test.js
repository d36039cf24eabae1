// The order of options: the file's order if it is fixed, otherwise a permutation for each step and seed.

import assert from "node:assert/strict"
import {test} from "node:test"

import {orderOf} from "../../static/questions/order.js"

const options = count => Array.from({length: count})

test("a fixed order stays; otherwise each seed has its own permutation", () => {
  assert.deepEqual(orderOf({id: "d31-01", options: options(4), fixed: true}, "ABCD"), [0, 1, 2, 3])
  const found = ["a", "b", "c", "d", "e", "f"].map(seed => orderOf({id: "x", options: options(4), fixed: false}, seed))
  for (const order of found) assert.deepEqual([...order].sort(), [0, 1, 2, 3])
  assert.ok(new Set(found.map(String)).size > 2)
})

test("every option is first equally often", () => {
  const firsts = Array.from({length: 4000}, (_, seed) => {
    return orderOf({id: "d31-01", options: options(4), fixed: false}, seed.toString(16).toUpperCase())[0]
  })
  for (const place of [0, 1, 2, 3]) {
    const count = firsts.filter(first => first === place).length
    assert.ok(count > 900 && count < 1100)
  }
})

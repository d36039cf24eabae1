// The order of answers: of the file where it is fixed, else one for each step and seed, in Python the same.

import assert from "node:assert/strict"
import {test} from "node:test"

import {orderOf} from "../../static/questions/order.js"

const CASES = JSON.parse(process.env.ORDERS ?? "[]")
const options = count => Array.from({length: count})

test("a fixed order stays, another is a permutation of the seed's own", () => {
  assert.deepEqual(orderOf({id: "d31-01", options: options(4), fixed: true}, "ABCD"), [0, 1, 2, 3])
  const found = ["a", "b", "c", "d", "e", "f"].map(seed => orderOf({id: "x", options: options(4), fixed: false}, seed))
  for (const order of found) assert.deepEqual([...order].sort(), [0, 1, 2, 3])
  assert.ok(new Set(found.map(String)).size > 2)
})

test("Python has the same", () => {
  for (const {id, count, seed, order} of CASES)
    assert.deepEqual(orderOf({id, options: options(count), fixed: false}, seed), order)
})

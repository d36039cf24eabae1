// Numbers as they are written.

import assert from "node:assert/strict"
import {test} from "node:test"

import {three} from "../../static/core/numbers.js"

test("what is no number says so", () => {
  assert.deepEqual(
    [NaN, Infinity, -Infinity].map(value => three(value)),
    ["NaN", "∞", "−∞"],
  )
})

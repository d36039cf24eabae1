// Numbers as text.

import assert from "node:assert/strict"
import {test} from "node:test"

import {three, withUnit} from "../../static/core/numbers.js"

test("NaN and infinity are written as words", () => {
  assert.deepEqual(
    [NaN, Infinity, -Infinity].map(value => three(value)),
    ["NaN", "∞", "−∞"],
  )
})

test("a space separates a unit from its number, except for degrees and powers of ten", () => {
  assert.deepEqual(
    ["kg", "°", "°C", "·10³ m", ""].map(unit => withUnit("1.5", unit)),
    ["1.5 kg", "1.5°", "1.5 °C", "1.5·10³ m", "1.5"],
  )
})

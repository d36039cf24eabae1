// Scales of sliders, and the last digit of a field.

import assert from "node:assert/strict"
import {test} from "node:test"

import {sliderPlace, sliderValue, stepped} from "../../static/controls/scales.js"

const EACH = [
  ["linear", [-2, 2], 0.01],
  ["linear", [0, 4.045], 0.01],
  ["near0", [0, 100], 0.01],
  ["log", [0.01, 10], null],
]

for (const [scale, soft, unit] of EACH)
  test(`a slider runs evenly over its range: ${scale}, ${soft}`, () => {
    const values = Array.from({length: 1001}, (_, i) => sliderValue(scale, i / 1000, soft))
    assert.equal(values[0], soft[0])
    assert.ok(Math.abs(values[1000] / soft[1] - 1) < 2e-3)
    values.forEach((value, i) => {
      assert.ok(!i || value >= values[i - 1])
      assert.equal(Number(value.toPrecision(3)), value)
      assert.ok(!unit || Math.abs(value / unit - Math.round(value / unit)) < 1e-9)
      const place = sliderPlace(scale, value, soft)
      assert.ok(place >= 0 && place <= 1)
      assert.ok(i <= 100 || Math.abs(place - i / 1000) < 0.002)
    })
  })

test("the last digit of a field is stepped up and down", () => {
  const up = ["9.99", "-3e5", "2.00", "−1.5e-7", "x"].map(text => stepped(text, 1))
  assert.deepEqual([...up, stepped("0.00", -1)], ["10.00", "-2e5", "2.01", "-1.4e-7", null, "-0.01"])
})

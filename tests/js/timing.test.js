// The estimate of the server's clock over a fast and a slow network: its error is within its bound.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, pass} from "./browser.js"

const {Timing} = await import("../../static/live_class/timing.js")

const AHEAD = 4321.4 // ms by which the server's clock is ahead of the page's

beforeEach(() => {
  clock()
  mock.method(performance, "now", () => Date.now() - performance.timeOrigin)
})
afterEach(() => {
  mock.timers.reset()
  mock.restoreAll()
})

/** A server that answers at once, but whose answers take `delay` ms. @param {() => number} delay */
function reached(delay) {
  new FakeServer().answers = () => {
    const time = Math.floor(Date.now() + AHEAD)
    return new Promise(done => setTimeout(() => done(Response.json(time)), delay()))
  }
}

for (const [name, spread, most] of [
  ["fast", 0, 10],
  ["slow", 100, 75],
])
  // prettier-ignore
  test(`over a ${name} network the error is within the bound`, async () => {
    let seed = 17
    const chance = () => (seed = (seed * 48271) % 2147483647) / 2147483647
    reached(() => spread * (0.5 + chance()))
    const timing = new Timing()
    for (let i = 0; i < 5; i++) {
      await pass(5000)
      await timing.measured
      const error = Math.abs(timing.now - Date.now() - AHEAD)
      assert.ok(error <= timing.bound + 1, `${error} ms`) // the server sends whole ms
      assert.ok(timing.bound <= most, `${timing.bound} ms`)
      timing.measured = timing.measure()
    }
  })

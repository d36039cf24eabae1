// Numbers as text, storage that may refuse, files that are saved, and the estimate of the server's clock.

import assert from "node:assert/strict"
import {resolveObjectURL} from "node:buffer"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, numbers, pass, storage} from "./browser.js"

const {save} = await import("../../static/export/save.js")
const {three, withUnit} = await import("../../static/core/numbers.js")
const {browserStorage, tabStorage} = await import("../../static/core/storage.js")
const {Timing} = await import("../../static/live_class/timing.js")

const AHEAD = 4321.4 // ms by which the server's clock is ahead of the page's

/** @param {string} name @param {PropertyDescriptor} how */
const define = (name, how) => Object.defineProperty(globalThis, name, {configurable: true, ...how})

beforeEach(() => {
  clock()
  define("localStorage", {value: storage()})
  define("sessionStorage", {value: storage()})
})
afterEach(() => {
  mock.timers.reset()
  mock.restoreAll()
})

test("NaN and infinity are words; a space separates a unit, except for degrees and powers of ten", () => {
  assert.deepEqual([NaN, Infinity, -Infinity].map(three), ["NaN", "∞", "−∞"])
  const written = ["kg", "°", "°C", "·10³ m", ""].map(unit => withUnit("1.5", unit))
  assert.deepEqual(written, ["1.5 kg", "1.5°", "1.5 °C", "1.5·10³ m", "1.5"])
})

test("texts are stored unchanged, values as JSON, and each shelf separately", () => {
  assert.ok(browserStorage.keep("theme", "dark") && tabStorage.keep("walk", {a: [1]}))
  assert.deepEqual(
    [localStorage.theme, browserStorage.text("theme"), browserStorage.value("walk")],
    ["dark", "dark", null],
  )
  assert.deepEqual([tabStorage.value("walk"), tabStorage.names()], [{a: [1]}, ["walk"]])
  tabStorage.forget("walk", "none")
  assert.deepEqual(tabStorage.names(), [])
  localStorage.setItem("answers", "{half") // by another page
  assert.equal(browserStorage.value("answers"), null)
})

const refuses = () => {
  throw new DOMException("Access is denied for this document.", "SecurityError")
}

for (const [name, get] of [
  ["refused", refuses],
  ["full", () => storage(refuses)],
])
  test(`a storage that is ${name} stores nothing, and this is reported once`, async () => {
    define("localStorage", {get})
    const {browserStorage: shelf} = await import(`../../static/core/storage.js?${name}`)
    const before = document.body.children.length
    assert.deepEqual([shelf.keep("visited", "yes"), shelf.text("visited"), shelf.names()], [false, null, []])
    shelf.forget("visited")
    assert.equal(document.body.children.length, before)
    shelf.keepOrSay("theme", "dark")
    shelf.keepOrSay("theme", "light")
    assert.equal(document.body.children.length, before + 1)
  })

test("a saved file's address works for half a minute, because Safari reads it after the click", async () => {
  const made = mock.method(URL, "createObjectURL")
  save("k2.csv", "t,x\n", "text/csv")
  const address = made.mock.calls[0].result
  await pass(30000, 50)
  assert.equal(await resolveObjectURL(address).text(), "t,x\n")
  await pass(30000, 50)
  assert.equal(resolveObjectURL(address), undefined)
})

for (const [name, spread, most] of [
  ["fast", 0, 10],
  ["slow", 100, 75],
])
  // prettier-ignore
  test(`over a ${name} network the error of the server's time is within its bound`, async () => {
    mock.method(performance, "now", () => Date.now() - performance.timeOrigin)
    const chance = numbers(17)
    new FakeServer().answers = () => {
      const time = Math.floor(Date.now() + AHEAD)
      return new Promise(done => setTimeout(() => done(Response.json(time)), spread * (0.5 + chance())))
    }
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

// The address bar: written at once if possible, less often while much changes, and before the page is left.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {clock, happens} from "./browser.js"

const {Address} = await import("../../static/net/address.js")

/** @type {string[]} */
let written = []
let address = new Address()

beforeEach(() => {
  clock()
  written = []
  globalThis.location = /** @type {Location} */ ({search: "?m=2"})
  globalThis.history = /** @type {History} */ ({
    replaceState: (_entry, _title, to) => void written.push(String(to)),
    pushState: (_entry, _title, to) => void written.push(`new ${to}`),
  })
  address = new Address()
})
afterEach(() => {
  happens("popstate")
  mock.reset()
})

const say = (/** @type {number} */ m, more = false) => address.write({address: `?m=${m}`, entry: {}}, more)
const some = () => [2, 3, 4].forEach(m => say(m))
const tick = (/** @type {number} */ ms) => mock.timers.tick(ms)

/** Makes the most changes that are written at once; the next waits. */
function spend() {
  for (let m = 0; m < 11; m++) say(m)
  written = []
}

for (const [name, act, expected] of /** @type {[string, () => void, string[]][]} */ ([
  ["a few changes are each written at once, so that a reload finds them", some, ["?m=2", "?m=3", "?m=4"]],
  ["nothing is written again when the page is left", () => (say(2), happens("pagehide")), ["?m=2"]],
  ["a change waits while more follow", () => (say(2, true), tick(349)), []],
  ["what followed is written at once", () => (say(2, true), say(3)), ["?m=3"]],
  ["a change after many waits", () => (spend(), some(), tick(349)), []],
  ["only the last of them is written", () => (spend(), some(), tick(350)), ["?m=4"]],
  [
    "it is written once when the page is left",
    () => (spend(), some(), happens("pagehide"), happens("pagehide")),
    ["?m=4"],
  ],
  ["it is not written into another history entry", () => (spend(), some(), happens("popstate"), tick(1000)), []],
  [
    "it is written before a new entry",
    () => (spend(), some(), address.turn({address: "?m=5", entry: {}})),
    ["?m=4", "new ?m=5"],
  ],
]))
  test(name, () => {
    act()
    assert.deepEqual(written, expected)
  })

for (const pause of [1, 10, 100, 201, 309, 311, 500])
  test(`changes every ${pause} ms are written less than a hundred times in 30 s`, () => {
    for (let at = 0; at < 30_000; at += pause) {
      say(at)
      tick(pause)
    }
    assert.ok(written.length > 40 && written.length < 100, `${written.length} times`)
  })

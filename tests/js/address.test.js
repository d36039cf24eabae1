// The address bar: written at once where it can be, rationed while much changes, and before the page is left.

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

const say = (/** @type {string} */ to, more = false) => address.write({address: to, entry: {}}, more)

test("a change alone is written at once", () => {
  say("?m=2")
  assert.deepEqual(written, ["?m=2"])
  happens("pagehide")
  assert.equal(written.length, 1)
})

test("a few changes soon after one another are each written at once: a page loaded anew takes its address", () => {
  for (const to of ["?m=2", "?m=3", "?m=4"]) say(to)
  assert.deepEqual(written, ["?m=2", "?m=3", "?m=4"])
})

/** Eleven changes, as many as are written at once. */
const spent = () => {
  for (let at = 0; at < 11; at++) say(`?m=${at}`)
  written = []
}

test("of many changes soon after one another the last is written, a moment later", () => {
  spent()
  for (const to of ["?m=2", "?m=3", "?m=4"]) say(to)
  mock.timers.tick(349)
  assert.deepEqual(written, [])
  mock.timers.tick(1)
  assert.deepEqual(written, ["?m=4"])
})

test("while more is coming nothing is written", () => {
  say("?m=2", true)
  assert.deepEqual(written, [])
  say("?m=3")
  assert.deepEqual(written, ["?m=3"])
})

test("however it changes it is written less than a hundred times in 30 s", () => {
  for (const pause of [1, 10, 100, 201, 309, 311, 500]) {
    written = []
    for (let at = 0; at < 30_000; at += pause) {
      say(`?m=${at}`)
      mock.timers.tick(pause)
    }
    assert.ok(written.length > 40 && written.length < 100, `${pause} ms: ${written.length} times`)
  }
})

test("what is not written yet is when the page is left", () => {
  spent()
  say("?m=3")
  happens("pagehide")
  assert.deepEqual(written, ["?m=3"])
  happens("pagehide")
  assert.equal(written.length, 1)
})

test("what was for an entry that has been left is not written into another", () => {
  spent()
  say("?m=3")
  happens("popstate")
  mock.timers.tick(1000)
  assert.deepEqual(written, [])
})

test("a turn is an entry of its own, after what was not written yet", () => {
  spent()
  say("?m=3")
  address.turn({address: "?scene=forced", entry: {}})
  assert.deepEqual(written, ["?m=3", "new ?scene=forced"])
})

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

const say = (/** @type {string} */ to, more = false) => address.write({address: to, entry: {}}, more)

test("a change alone is written at once", () => {
  say("?m=2")
  assert.deepEqual(written, ["?m=2"])
  happens("pagehide")
  assert.equal(written.length, 1)
})

test("a few changes in quick succession are each written at once, so that a reload finds them", () => {
  for (const to of ["?m=2", "?m=3", "?m=4"]) say(to)
  assert.deepEqual(written, ["?m=2", "?m=3", "?m=4"])
})

/** Eleven changes: the most that are written at once. */
const spent = () => {
  for (let at = 0; at < 11; at++) say(`?m=${at}`)
  written = []
}

test("after many changes in quick succession the last is written, with a short delay", () => {
  spent()
  for (const to of ["?m=2", "?m=3", "?m=4"]) say(to)
  mock.timers.tick(349)
  assert.deepEqual(written, [])
  mock.timers.tick(1)
  assert.deepEqual(written, ["?m=4"])
})

test("nothing is written while changes continue", () => {
  say("?m=2", true)
  assert.deepEqual(written, [])
  say("?m=3")
  assert.deepEqual(written, ["?m=3"])
})

test("the address is written less than a hundred times in 30 s", () => {
  for (const pause of [1, 10, 100, 201, 309, 311, 500]) {
    written = []
    for (let at = 0; at < 30_000; at += pause) {
      say(`?m=${at}`)
      mock.timers.tick(pause)
    }
    assert.ok(written.length > 40 && written.length < 100, `${pause} ms: ${written.length} times`)
  }
})

test("a pending change is written when the page is left", () => {
  spent()
  say("?m=3")
  happens("pagehide")
  assert.deepEqual(written, ["?m=3"])
  happens("pagehide")
  assert.equal(written.length, 1)
})

test("a pending change of one history entry is not written into another", () => {
  spent()
  say("?m=3")
  happens("popstate")
  mock.timers.tick(1000)
  assert.deepEqual(written, [])
})

test("a new step is a separate entry, after the pending change is written", () => {
  spent()
  say("?m=3")
  address.turn({address: "?scene=forced", entry: {}})
  assert.deepEqual(written, ["?m=3", "new ?scene=forced"])
})

// Storage where a browser keeps nothing: read as empty, never thrown, and said once where it matters.

import assert from "node:assert/strict"
import {beforeEach, test} from "node:test"

import "./browser.js"

const {browserStorage, tabStorage} = await import("../../static/core/storage.js")

/** @param {string} name @param {PropertyDescriptor} how */
const define = (name, how) => Object.defineProperty(globalThis, name, {configurable: true, ...how})

function keep(name, text) {
  this[name] = String(text)
}

/** A storage as a browser has it: its names are its own keys. */
function works(setItem = keep) {
  const hidden = value => ({value, enumerable: false})
  return Object.create(null, {
    getItem: hidden(function (name) {
      return this[name] ?? null
    }),
    setItem: hidden(setItem),
    removeItem: hidden(function (name) {
      delete this[name]
    }),
  })
}

const refuses = () => {
  throw new DOMException("Access is denied for this document.", "SecurityError")
}

beforeEach(() => {
  define("localStorage", {value: works()})
  define("sessionStorage", {value: works()})
})

test("texts stay as they are, values cross as JSON, and each shelf keeps its own", () => {
  assert.ok(browserStorage.keep("theme", "dark") && tabStorage.keep("walk", {a: [1]}))
  assert.equal(localStorage.theme, "dark")
  assert.equal(browserStorage.text("theme"), "dark")
  assert.deepEqual(tabStorage.value("walk"), {a: [1]})
  assert.equal(browserStorage.value("walk"), null)
  assert.deepEqual(tabStorage.names(), ["walk"])
  tabStorage.forget("walk", "none")
  assert.deepEqual(tabStorage.names(), [])
})

test("what another page has kept under a name is no value", () => {
  browserStorage.keep("answers", "{half")
  assert.equal(browserStorage.value("answers"), null)
})

for (const [name, storage] of [
  ["refused", refuses],
  ["full", () => works(refuses)],
]) {
  test(`a storage that is ${name} keeps nothing, and that is said once`, async () => {
    define("localStorage", {get: storage})
    const {browserStorage: anew} = await import(`../../static/core/storage.js?${name}`)
    const before = document.body.children.length
    assert.equal(anew.keep("visited", "yes"), false)
    assert.equal(anew.text("visited"), null)
    assert.deepEqual(anew.names(), [])
    anew.forget("visited")
    assert.equal(document.body.children.length, before)
    anew.keepOrSay("theme", "dark")
    anew.keepOrSay("theme", "light")
    assert.equal(document.body.children.length, before + 1)
  })
}

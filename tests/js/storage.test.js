// Storage in a browser that stores nothing: it reads as empty, never throws, and is reported once.

import assert from "node:assert/strict"
import {beforeEach, test} from "node:test"

import "./browser.js"

const {browserStorage, tabStorage} = await import("../../static/core/storage.js")

/** @param {string} name @param {PropertyDescriptor} how */
const define = (name, how) => Object.defineProperty(globalThis, name, {configurable: true, ...how})

function keep(name, text) {
  this[name] = String(text)
}

/** A browser's storage: its names are its own keys. */
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

test("texts are stored unchanged, values as JSON, and each shelf separately", () => {
  assert.ok(browserStorage.keep("theme", "dark") && tabStorage.keep("walk", {a: [1]}))
  assert.equal(localStorage.theme, "dark")
  assert.equal(browserStorage.text("theme"), "dark")
  assert.deepEqual(tabStorage.value("walk"), {a: [1]})
  assert.equal(browserStorage.value("walk"), null)
  assert.deepEqual(tabStorage.names(), ["walk"])
  tabStorage.forget("walk", "none")
  assert.deepEqual(tabStorage.names(), [])
})

test("a value stored by another page is ignored", () => {
  browserStorage.keep("answers", "{half")
  assert.equal(browserStorage.value("answers"), null)
})

for (const [name, storage] of [
  ["refused", refuses],
  ["full", () => works(refuses)],
]) {
  test(`a storage that is ${name} stores nothing, and this is reported once`, async () => {
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

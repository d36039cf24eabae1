// Scales of sliders, units, storage that may refuse, files that are saved, the server's clock, the address bar, and the
// queue of messages.

import assert from "node:assert/strict"
import {resolveObjectURL} from "node:buffer"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, happens, numbers, pass, storage} from "./browser.js"

const {sliderPlace, sliderValue, stepped} = await import("../../static/controls/scales.js")
const {Messages} = await import("../../static/net/messages.js")
const {Address} = await import("../../static/net/address.js")
const {save} = await import("../../static/export/save.js")
const {withUnit} = await import("../../static/core/numbers.js")
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

for (const [scale, soft, unit] of [
  ["linear", [-2, 2], 0.01],
  ["linear", [0, 4.045], 0.01],
  ["near0", [0, 100], 0.01],
  ["log", [0.01, 10], null],
])
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

test("a space separates a unit, except for degrees and powers of ten", () => {
  const written = ["kg", "°", "°C", "·10³ m", ""].map(unit => withUnit("1.5", unit))
  assert.deepEqual(written, ["1.5 kg", "1.5°", "1.5 °C", "1.5·10³ m", "1.5"])
})

const refuses = () => {
  throw new DOMException("Access is denied for this document.", "SecurityError")
}

for (const [name, get] of Object.entries({refused: refuses, full: () => storage(refuses)}))
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

let address
let written = []

/** Listens to the address bar; lets most changes that are written at once pass, if asked for. */
function bar(isBusy = false) {
  globalThis.location = {search: "?m=2"}
  globalThis.history = {
    replaceState: (_entry, _title, to) => void written.push(to),
    pushState: (_entry, _title, to) => void written.push(`new ${to}`),
  }
  address = new Address()
  for (let m = 0; m < 11; m++) if (isBusy) say(m)
  written = []
}

const say = (m, more = false) => address.write({address: `?m=${m}`, entry: {}}, more)
const some = () => [2, 3, 4].forEach(m => say(m))
const tick = ms => mock.timers.tick(ms)

for (const [name, isBusy, act, expected] of [
  ["a few changes are each written at once, so that a reload finds them", false, some, ["?m=2", "?m=3", "?m=4"]],
  ["nothing is written again when the page is left", false, () => (say(2), happens("pagehide")), ["?m=2"]],
  ["a change waits while more follow", false, () => (say(2, true), tick(349)), []],
  ["what followed is written at once", false, () => (say(2, true), say(3)), ["?m=3"]],
  ["only the last of many changes is written", true, () => (some(), tick(350)), ["?m=4"]],
  ["it is written once when the page ends", true, () => (some(), happens("pagehide"), happens("pagehide")), ["?m=4"]],
  ["it is not written into another history entry", true, () => (some(), happens("popstate"), tick(1000)), []],
  ["it is written first", true, () => (some(), address.turn({address: "?m=5", entry: {}})), ["?m=4", "new ?m=5"]],
])
  test(`address bar: ${name}`, () => {
    bar(isBusy)
    act()
    assert.deepEqual(written, expected)
    happens("popstate")
  })

for (const pause of [1, 100, 201, 309, 311, 500])
  test(`changes every ${pause} ms are written less than a hundred times in 30 s`, () => {
    bar()
    for (let at = 0; at < 30_000; at += pause) {
      say(at)
      tick(pause)
    }
    assert.ok(written.length > 40 && written.length < 100, `${written.length} times`)
    happens("popstate")
  })

// The queue of messages: repeated until the server has accepted them, and when the connection counts as lost.

const STATE = {step: "own/first"}
let sent, failed, reported, lost

/** @param {boolean} isNew for a new session */
function made(isNew, handle = () => {}) {
  ;[sent, failed, reported, lost] = [[], [], [], 0]
  const [fail, report] = [failed, reported].map(list => error => list.push(error.message))
  const messages = new Messages(async packet => packet, handle, fail, report)
  messages.overdue = () => void lost++
  messages.state = STATE
  messages.greeting = () => [{type: "walk", name: "own", text: ""}]
  attach(messages, isNew)
  return messages
}

const attach = (messages, isNew) => messages.attach({send: message => sent.push(message)}, isNew)
const kinds = () => sent.map(({type}) => type)

async function answer(messages, fields) {
  messages.receive({answer: messages.asked.message.number, ...fields})
  await messages.handled
}

test("a walk that a busy new session could not read is sent again, also after a loss, then the state", async () => {
  const messages = made(true)
  for (const tries of [1, 2, 3]) {
    assert.deepEqual(kinds(), Array(tries).fill("walk"))
    await answer(messages, {type: "walking", is_busy: true})
    assert.ok(messages.behind)
    mock.timers.tick(1000)
  }
  messages.detach()
  mock.timers.tick(1000)
  assert.equal(sent.length, 4)
  attach(messages, true)
  await answer(messages, {type: "walking", is_busy: false})
  assert.deepEqual(kinds(), ["walk", "walk", "walk", "walk", "walk", "open"])
  assert.deepEqual(sent.at(-1).state, STATE)
})

test("an exception in a message handler does not end the connection, and the next message is sent", async () => {
  const throws = () => {
    throw new Error("!")
  }
  const messages = made(false, throws)
  for (const name of ["first", "second"]) messages.send({type: "act", name})
  for (const count of [1, 2]) {
    await answer(messages, {type: "shown", state: STATE})
    assert.equal(reported.length, count)
  }
  assert.deepEqual([failed, sent.map(({name}) => name), messages.rests], [[], ["first", "second"], true])
})

test("when a page becomes visible again, one message without an answer ends the connection", async () => {
  const messages = made(false)
  messages.detach()
  messages.probe()
  attach(messages, false)
  messages.probe()
  assert.deepEqual(sent, [{type: "set", values: {}, number: 1}])
  await answer(messages, {type: "kept"})
  mock.timers.tick(20000)
  assert.equal(lost, 0)
  messages.probe()
  mock.timers.tick(3000)
  assert.equal(lost, 1)
  messages.detach()
  assert.equal(messages.changes, 0)
})

for (const [type, patience] of Object.entries({act: 5000, about: 20000, csv: 20000, rows: 20000}))
  // prettier-ignore
  test(`a message ${type} is repeated after ${patience} ms; then the connection counts as lost`, () => {
    made(false).send({type})
    for (const [after, expected] of [[patience - 1, [1, 0]], [1, [2, 0]], [patience - 1, [2, 0]], [1, [2, 1]]]) {
      mock.timers.tick(after)
      assert.deepEqual([sent.length, lost], expected)
    }
    assert.deepEqual(sent[0], sent[1], "the server applies a number once")
  })

test("an answer that comes again or late is ignored", async () => {
  const heard = []
  const messages = made(false, ({answer}) => void heard.push(answer))
  for (const name of ["first", "second"]) messages.send({type: "act", name})
  for (const number of [1, 1, 2, 1, 2]) {
    messages.receive({answer: number, type: "kept"})
    await messages.handled
  }
  assert.deepEqual([heard, sent.length], [[1, 2], 2])
})

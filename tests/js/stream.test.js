// The stream of a live class, with a clock that the test advances.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, events, happens, pass, refusing} from "./browser.js"

const {Stream} = await import("../../static/live_class/stream.js")

/** @type {FakeServer} */ let server
let stream, heard, streams

beforeEach(() => {
  clock()
  server = new FakeServer()
  streams = []
  heard = {news: [], connected: [], refused: []}
})

afterEach(async () => {
  stream?.close()
  const {length} = server.asked
  await pass(60000, 500)
  assert.equal(server.asked.length, length, "a closed stream sends no request")
  mock.timers.reset()
  mock.reset()
})

const opened = signal => streams[streams.push(events(signal)) - 1].answer

/** Answer requests for a stream with one that the test writes to. */
const served = (path, signal) => (path.includes("/events") ? opened(signal) : undefined)

function begin(more) {
  stream = new Stream("ABCD", "word", {
    news: ({number}) => heard.news.push(number),
    refused: ({message}) => heard.refused.push(`${message} ${Date.now()}`),
    connected: (is, why = "") => heard.connected.push(is || why),
    ...more,
  })
}

test("a stream that ends or is silent is resumed at the same event; faults of the page do not end it", async () => {
  mock.method(console, "warn", () => {})
  server.answers = served
  const news = ({number}) => {
    heard.news.push(number)
    throw new TypeError("a fault")
  }
  begin({news})
  await pass(10)
  streams[0].say({number: "a.1"})
  streams[0].say({number: "a.2"})
  await pass(24000, 50)
  assert.deepEqual([heard.news, streams.length], [["a.1", "a.2"], 1])
  await pass(3000)
  assert.equal(streams.length, 2)
  streams[1].end()
  await pass(700)
  const paths = server.asked.map(({path}) => path)
  assert.deepEqual(paths, ["ABCD/events?after=", "ABCD/events?after=a.2", "ABCD/events?after=a.2"])
  assert.deepEqual(heard.connected.slice(0, 3), [true, true, ""])
})

test("a silent stream is replaced by polling, and tried again in parallel", async () => {
  server.answers = (path, signal) => {
    if (path.includes("/now")) return Response.json({number: "a.1"})
    if (Date.now() > 60000) return opened(signal)
  }
  begin()
  await pass(2990)
  assert.equal(stream.by, "events")
  await pass(4000)
  assert.equal(stream.by, "now")
  assert.deepEqual(server.times("/now"), [3000, 4000, 5000, 6000])
  await pass(57100, 50)
  assert.equal(server.times("/events").length, 2)
  streams[0].say({number: "a.2"})
  await pass(10)
  assert.equal(stream.by, "events")
  assert.ok(!heard.connected.includes(""))
  streams.at(-1).say({number: "a.3"})
  await pass(2000)
  assert.equal(heard.news.at(-1), "a.3")
  assert.ok(server.times("/now").at(-1) < 64200)
})

test("a page that wakes up reconnects quickly and drops dead connections", async () => {
  server.answers = served
  begin()
  await pass(1)
  streams[0].say({number: "a.1"})
  await pass(10000)
  server.answers = () => {}
  const woken = Date.now()
  happens("online")
  await pass(1000)
  const after = server.times("/events").map(at => at - woken)
  assert.deepEqual(after.slice(1), [0, 150, 380, 720])
  assert.equal(server.times("time").length, 15)
  server.answers = served
  await pass(600)
  streams.at(-1).say({number: "a.2"})
  await pass(1)
  assert.equal(stream.state, "events")
  assert.ok(server.asked.filter(({path}) => path === "time").every(({signal}) => signal.aborted))
})

test("a hidden page has no stream and sends no request until it is visible, then at once", async () => {
  const hide = is => {
    document.hidden = is
    document.dispatchEvent(new Event("visibilitychange"))
  }
  server.answers = served
  begin({sleeps: true})
  await pass(10)
  hide(true)
  await pass(30000, 50)
  assert.ok(server.asked[0].signal.aborted)
  assert.equal(server.asked.length, 1)
  hide(false)
  await pass(10)
  assert.equal(server.asked.length, 2)
})

const missing = refusing(404, "Not there.")
const restored = (...how) => (Date.now() < 25000 ? missing() : served(...how))
for (const [name, answers, more, told, refused] of [
  ["a full server never ends it", refusing(503, "Later."), {}, "Later.", []],
  ["a missing class ends it after half a minute", missing, {}, "Not there.", ["Not there. 33300"]],
  ["a class that has ended ends it at once", refusing(410, "Over."), {}, undefined, ["Over. 0"]],
  ["a missing class ends it at once on the instructor's page", missing, {doubt: 0}, undefined, ["Not there. 0"]],
  ["a class that is restored meanwhile does not", restored, {}, "Not there.", []],
])
  test(`refusals with a reason: ${name}`, async () => {
    server.answers = answers
    begin(more)
    await pass(60000, 50)
    assert.deepEqual([heard.connected[0], heard.refused], [told, refused])
    const {length} = server.asked
    happens("online")
    await pass(100)
    assert.equal(server.asked.length > length, !refused.length)
  })

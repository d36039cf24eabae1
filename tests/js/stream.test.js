// The stream of a live class, with a clock that the test advances.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, events, happens, pass} from "./browser.js"

const {STATES, Stream} = await import("../../static/live_class/stream.js")

let server, stream, heard

beforeEach(() => {
  clock()
  server = new FakeServer()
  heard = {news: [], connected: [], refused: []}
})

afterEach(() => {
  stream?.close()
  mock.timers.reset()
  mock.reset()
})

function begin(more) {
  stream = new Stream("ABCD", "word", {
    ...more,
    news: news => heard.news.push(news.number),
    refused: refusal => heard.refused.push(refusal.message),
    connected: (is, why = "") => heard.connected.push(is || why),
  })
}

const refuse = (status, sentence) => () => Response.json({sentence}, {status})
const news = number => () => Response.json({number})

test("each state leads to an existing one, and finally to polling", () => {
  for (const name of Object.keys(STATES)) {
    let state = name
    for (let i = 0; i < 8; i++) state = STATES[state].late
    assert.equal(state, "now")
  }
})

test("a stream is read until it ends and then resumed at the same event", async () => {
  const streams = []
  server.answers = (path, signal) => streams[streams.push(events(signal)) - 1].answer
  begin()
  await pass(10)
  streams[0].say({number: "a.1"})
  streams[0].say({number: "a.2"})
  await pass(20000)
  assert.deepEqual(heard.news, ["a.1", "a.2"])
  streams[0].end()
  await pass(400)
  assert.deepEqual(server.times("events?after=").length, 2)
  assert.equal(server.asked[1].path, "ABCD/events?after=a.2")
  assert.deepEqual(heard.connected, [true, true, ""])
})

test("a silent stream is replaced by polling, and tried again in parallel", async () => {
  let late
  server.answers = (path, signal) => {
    if (path.includes("/now")) return news("a.1")()
    if (Date.now() > 60000) return (late = events(signal)).answer
  }
  begin()
  await pass(2990)
  assert.equal(stream.by, "events")
  await pass(4000)
  assert.equal(stream.by, "now")
  assert.deepEqual(server.times("/now"), [3000, 4000, 5000, 6000])
  await pass(57100)
  assert.equal(server.times("/events").length, 2)
  late.say({number: "a.2"})
  await pass(10)
  assert.equal(stream.by, "events")
  assert.ok(!heard.connected.includes(""))
  late.say({number: "a.3"})
  await pass(2000)
  assert.equal(heard.news.at(-1), "a.3")
  assert.ok(server.times("/now").at(-1) < 64200)
})

test("a page that wakes up reconnects quickly and drops dead connections", async () => {
  let last
  server.answers = (path, signal) => (path.includes("/events") ? (last = events(signal)).answer : undefined)
  begin()
  await pass(1)
  last.say({number: "a.1"})
  await pass(10000)
  const {answers} = server
  server.answers = () => {}
  const woken = Date.now()
  happens("online")
  await pass(1000)
  assert.deepEqual(
    server
      .times("/events")
      .slice(1)
      .map(at => at - woken),
    [0, 150, 380, 720],
  )
  assert.equal(server.times("time").length, 15)
  server.answers = answers
  await pass(600)
  last.say({number: "a.2"})
  await pass(1)
  assert.equal(stream.state, "events")
  assert.ok(server.asked.filter(({path}) => path === "time").every(({signal}) => signal.aborted))
})

test("a hidden page has no stream and sends no request until it is visible, then at once", async () => {
  const seen = is => {
    document.hidden = !is
    document.dispatchEvent(new Event("visibilitychange"))
  }
  server.answers = (path, signal) => events(signal).answer
  begin({sleeps: true})
  await pass(10)
  seen(false)
  await pass(30000)
  assert.ok(server.asked[0].signal.aborted)
  assert.equal(server.asked.length, 1)
  seen(true)
  await pass(10)
  assert.equal(server.asked.length, 2)
})

test("an unreachable page asks less and less often, and at once when the network is back", async () => {
  server.answers = () => {
    throw new TypeError("Failed to fetch")
  }
  begin()
  await pass(60000)
  const times = server.times("/events")
  const pauses = times.slice(1).map((at, i) => at - times[i])
  assert.deepEqual(pauses, [300, 600, 1200, 2400, 4800, 8000, 8000, 8000, 8000, 8000, 8000])
  const now = Date.now()
  happens("online")
  await pass(1)
  assert.equal(server.times("/events").at(-1), now)
  assert.equal(heard.refused.length, 0)
})

test("a missing class ends the stream after some tries, a full server never", async () => {
  server.answers = refuse(503, "Try later.")
  begin()
  await pass(60000)
  assert.ok(heard.connected.every(why => why === "Try later.") && !heard.refused.length)
  server.answers = refuse(404, "No class has this code.")
  await pass(60000)
  assert.deepEqual(heard.refused, ["No class has this code."])
  const count = server.asked.length
  happens("online")
  await pass(60000)
  assert.equal(server.asked.length, count)
})

test("a restarted server has half a minute to restore the class, for the instructor's page none", async () => {
  server.answers = (path, signal) => (Date.now() < 25000 ? refuse(404, "Not there.")() : events(signal).answer)
  begin()
  await pass(60000)
  assert.equal(heard.refused.length, 0)
  stream.close()
  server.answers = refuse(404, "Not there.")
  const count = server.asked.length
  begin({doubt: 0})
  await pass(60000)
  assert.equal(server.asked.length, count + 1)
  assert.deepEqual(heard.refused, ["Not there."])
})

test("an exception in the news handler does not end the stream", async () => {
  mock.method(console, "warn", () => {})
  let last
  server.answers = (path, signal) => (last = events(signal)).answer
  begin()
  heard.news.push = () => {
    throw new TypeError("a fault")
  }
  await pass(10)
  last.say({number: "a.1"})
  last.say({number: "a.2"})
  await pass(5000)
  assert.equal(server.asked.length, 1)
  assert.ok(!heard.connected.includes(""))
})

test("a silent stream is opened again", async () => {
  const streams = []
  server.answers = (path, signal) => streams[streams.push(events(signal)) - 1].answer
  begin()
  await pass(10)
  streams[0].say({number: "a.1"})
  await pass(24000)
  assert.equal(streams.length, 1)
  await pass(3000)
  assert.equal(streams.length, 2)
})

test("a closed stream sends no request", async () => {
  server.answers = refuse(503, "")
  begin()
  await pass(100)
  stream.close()
  await pass(60000)
  assert.equal(server.asked.length, 1)
})

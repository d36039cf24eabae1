// A phone's requests to a class that is away, in every way of being away: each arrives once when the class is back; and
// the stream of a class. The tests advance the clock.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, events, happens, pass, refusing, storage} from "./browser.js"

const {Copies} = await import("../../static/live_class/class_backup.js")
const {Delivery} = await import("../../static/live_class/delivery.js")
const {entered, mine} = await import("../../static/live_class/my_answers.js")
const {Stream} = await import("../../static/live_class/stream.js")

const AWAY = 20000 // ms
const BACK = 9500 // ms within which everything has arrived: longer than the longest pause, shorter than a minute
const STEP = 50
const QUESTION = "d31/d31-03/1"
const ANSWER = {walk: "d31", step: "d31-03", vote: 1, option: 1}
const OTHER = {...ANSWER, option: 2}
const SKETCH = {walk: "d31", step: "d31-02", vote: 1, curves: {x1: [0, 500, null]}}
const FOLLOWER = {code: "ABCD", token: "word", server: "a"}

/** @type {FakeServer} */ let server
let room, away, last, holdsStreams, streams, heard

/** A class on the server: it stores the answers by the phone's token. */
class Room {
  answers = new Map()
  tokens = 0

  take(path, {method, body, headers}, signal) {
    if (path.endsWith("/token")) return Response.json({code: "ABCD", token: `token ${++this.tokens}`})
    if (path.includes("/events")) return holdsStreams ? undefined : this.#stream(signal)
    if (method !== "PUT") return Response.json({number: "a.1"})
    this.answers.set(headers.Authorization, JSON.parse(body))
    return new Response(null, {status: 204})
  }

  #stream(signal) {
    const answer = opened(signal)
    streams.at(-1).say({number: "a.1"})
    return answer
  }
}

const opened = signal => streams[streams.push(events(signal)) - 1].answer

const page = status => () => new Response("<html>", {status})

/** Ways of being away: each answers a request that `take` would answer normally. */
const WAYS = {
  offline: () => {
    throw new TypeError("Failed to fetch")
  },
  "502 of a proxy": page(502),
  "404 of a proxy": page(404),
  "404 of a server that has lost the class": refusing(404, "The class cannot be reached at the moment."),
  "503 of a server that does not have the question again": refusing(503, "The class has no question yet."),
  429: refusing(429, "Too many messages at once."),
  "200 of a hotel's login page": page(200),
  "killed during the request": take => {
    take()
    room = new Room()
    throw new TypeError("Failed to fetch")
  },
  slow: (take, signal) =>
    new Promise((done, failed) => {
      const answer = take()
      setTimeout(() => done(answer), 15000)
      signal.addEventListener("abort", () => failed(signal.reason))
    }),
}

/** Requests of a phone. Each returns a check that the request has arrived. */
const REQUESTS = {
  "to join": () => {
    localStorage.removeItem("class-ABCD")
    const found = []
    entered("ab cd", "the QR code's", () => {}).then(({token}) => found.push(token))
    return () => assert.deepEqual(found, [mine("ABCD").token])
  },
  "an answer that is changed meanwhile": () => {
    delivering().give(QUESTION, ANSWER)
    setTimeout(() => last.give(QUESTION, OTHER), AWAY / 2)
    return () => {
      assert.deepEqual([...room.answers], [["Bearer word", OTHER]])
      assert.deepEqual(last.answer(QUESTION), OTHER)
      assert.ok(last.isSent(QUESTION) && !last.refused.size && !last.isFailing)
    }
  },
  "a sketch, and the answer to the next question": () => {
    delivering().give("d31/d31-02/1", SKETCH)
    last.give(QUESTION, ANSWER)
    return () => assert.deepEqual([...last.sent], [["d31/d31-02/1", SKETCH], [QUESTION, ANSWER]]) // prettier-ignore
  },
  "an answer of a page that is loaded again": () => {
    delivering().give(QUESTION, ANSWER)
    setTimeout(() => {
      last.close()
      delivering()
    }, AWAY / 2)
    return () => {
      assert.deepEqual([...room.answers], [["Bearer word", ANSWER]])
      assert.deepEqual(mine("ABCD").unsent, {})
    }
  },
  news: () => {
    listen()
    return () => assert.deepEqual([heard.news.includes("a.1"), heard.refused], [true, []])
  },
  "news through a proxy that holds streams back": () => {
    holdsStreams = true
    listen()
    return () => assert.deepEqual([heard.news.includes("a.1"), heard.refused, last.by], [true, [], "now"])
  },
}

function delivering() {
  last = new Delivery(FOLLOWER, () => {})
  return last
}

function listen(more) {
  last = new Stream("ABCD", "word", {
    news: ({number}) => heard.news.push(number),
    refused: ({message}) => heard.refused.push(`${message} ${Date.now()}`),
    connected: (is, why = "") => heard.connected.push(is || why),
    ...more,
  })
}

beforeEach(() => {
  clock()
  globalThis.localStorage = storage()
  localStorage.setItem("class-ABCD", JSON.stringify({token: "word"}))
  room = new Room()
  ;[away, holdsStreams, streams, heard] = [undefined, false, [], {news: [], connected: [], refused: []}]
  server = new FakeServer()
  server.answers = (path, signal, how) => {
    const take = () => room.take(path, how, signal)
    return away ? away(take, signal) : take()
  }
})

afterEach(async () => {
  last?.close()
  const {length} = server.asked
  await pass(60000, 500)
  assert.equal(server.asked.length, length, "what is closed sends no request")
  mock.timers.reset()
  mock.reset()
})

for (const [request, begin] of Object.entries(REQUESTS))
  for (const [how, way] of Object.entries(WAYS))
    test(`${request}: ${how}`, async () => {
      away = way
      const arrived = begin()
      await pass(AWAY, STEP)
      const tries = server.asked.length
      assert.ok(tries > 1 && tries < 60, `${tries} tries`)
      away = undefined
      await pass(BACK + (how === "slow" ? 15000 : 0) + (holdsStreams ? 3000 : 0), STEP)
      arrived()
      const {length} = server.asked
      await pass(60000, 500)
      if (!(last instanceof Stream)) assert.equal(server.asked.length, length, "nothing is sent again")
    })

for (const [when, again] of Object.entries({
  "the stream is back": () => last.wake(),
  "the question is back": () => last.resend(QUESTION),
}))
  test(`an answer is sent at once when ${when}`, async () => {
    away = WAYS.offline
    delivering().give(QUESTION, ANSWER)
    await pass(AWAY, STEP)
    away = undefined
    again()
    await pass(5)
    assert.ok(last.isSent(QUESTION))
  })

test("an answer that is changed on its way does not overtake, and is sent next", async () => {
  away = take => new Promise(done => setTimeout(() => done(take()), 2000))
  delivering().give(QUESTION, ANSWER)
  await pass(500)
  last.give(QUESTION, OTHER)
  await pass(1000)
  assert.equal(server.asked.length, 1)
  await pass(3000)
  assert.deepEqual([...room.answers.values(), mine("ABCD").answers[QUESTION]], [OTHER, OTHER])
  assert.ok(server.asked.length === 2 && last.isSent(QUESTION))
})

test("an answer that is refused for good is not sent again, and the reason is kept", async () => {
  away = refusing(409, "This question is closed.")
  delivering().give(QUESTION, ANSWER)
  await pass(60000, 500)
  assert.deepEqual([server.asked.length, last.answer(QUESTION)], [1, null])
  assert.equal(last.refused.get(QUESTION), "This question is closed.")
  away = undefined
  last.give(QUESTION, OTHER)
  await pass(60000, 500)
  assert.ok(last.isSent(QUESTION) && !last.refused.size)
})

test("an answer counts even if a restarted server no longer has its question and refuses it", async () => {
  delivering().give(QUESTION, ANSWER)
  await pass(10)
  away = refusing(409, "This question is closed.")
  last.follower = {...FOLLOWER, server: "b"}
  last.resend(QUESTION)
  await pass(1000)
  assert.equal(server.asked.length, 2)
  assert.ok(last.isSent(QUESTION) && !last.refused.size)
})

test("a wrong typed code is refused at once, a scanned one after half a minute", async () => {
  localStorage.removeItem("class-ABCD")
  away = refusing(404, "No class has this code.")
  const found = []
  for (const word of ["", "the QR code's"])
    entered("abcd", word, () => {}).catch(({message}) => found.push([Date.now() > 25000, message]))
  await pass(45000, STEP)
  assert.deepEqual(found, [[false, "No class has this code."], [true, "No class has this code."]]) // prettier-ignore
})

const PUT = {walk: "mine", step: "pull", vote: 1, isShown: false, isClosed: false, answered: false, sure: false}

for (const [name, put, refused, expected] of [
  ["a question", PUT, "", ["walk", "put"]],
  ["no question", null, "", ["walk", "withdraw"]],
  ["a question that is refused", PUT, "put", ["walk", "put", "withdraw"]],
])
  test(`a lost class is restored from the instructor's browser, with ${name}; phones never wait for one`, async () => {
    mock.method(console, "warn", () => {})
    const orders = []
    server.answers = (path, signal, {method, body}) => {
      if (method === "PUT") return Response.json({code: "ABCD", key: "key"})
      const {type} = JSON.parse(body)
      orders.push(type)
      return type === refused ? refusing(409, "No.")() : new Response(null, {status: 204})
    }
    const copies = new Copies({code: "ABCD", key: "key", put})
    copies.take("mine", "a text")
    await copies.restore()
    assert.deepEqual(orders, expected)
  })

// The stream of news.

/** Answer requests for a stream with one that the test writes to. */
const served = (path, signal) => (path.includes("/events") ? opened(signal) : undefined)

test("a stream that ends or is silent is resumed at the same event; faults of the page do not end it", async () => {
  mock.method(console, "warn", () => {})
  server.answers = served
  const news = ({number}) => {
    heard.news.push(number)
    throw new TypeError("a fault")
  }
  listen({news})
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
  listen()
  await pass(2990)
  assert.equal(last.by, "events")
  await pass(4000)
  assert.equal(last.by, "now")
  assert.deepEqual(server.times("/now"), [3000, 4000, 5000, 6000])
  await pass(57100, 50)
  assert.equal(server.times("/events").length, 2)
  streams[0].say({number: "a.2"})
  await pass(10)
  assert.equal(last.by, "events")
  assert.ok(!heard.connected.includes(""))
  streams.at(-1).say({number: "a.3"})
  await pass(2000)
  assert.equal(heard.news.at(-1), "a.3")
  assert.ok(server.times("/now").at(-1) < 64200)
})

test("a page that wakes up reconnects quickly and drops dead connections", async () => {
  server.answers = served
  listen()
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
  assert.equal(last.state, "events")
  assert.ok(server.asked.filter(({path}) => path === "time").every(({signal}) => signal.aborted))
})

test("a hidden page has no stream and sends no request until it is visible, then at once", async () => {
  const hide = is => {
    document.hidden = is
    document.dispatchEvent(new Event("visibilitychange"))
  }
  server.answers = served
  listen({sleeps: true})
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
    listen(more)
    await pass(60000, 50)
    assert.deepEqual([heard.connected[0], heard.refused], [told, refused])
    const {length} = server.asked
    happens("online")
    await pass(100)
    assert.equal(server.asked.length > length, !refused.length)
  })

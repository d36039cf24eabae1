// A phone's requests to a class that is away, in every way of being away: each arrives once when the class is back.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, events, pass, refusing, storage} from "./browser.js"

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
let room, away, last, holdsStreams

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
    const {answer, say} = events(signal)
    say({number: "a.1"})
    return answer
  }
}

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
    const heard = listening()
    return () => assert.ok(heard.includes("a.1"))
  },
  "news through a proxy that holds streams back": () => {
    holdsStreams = true
    const heard = listening()
    return () => assert.deepEqual([heard.includes("a.1"), last.by], [true, "now"])
  },
}

function delivering() {
  last = new Delivery(FOLLOWER, () => {})
  return last
}

/** A stream; returns the numbers of the news that it has received. */
function listening() {
  const heard = []
  last = new Stream("ABCD", "word", {
    news: ({number}) => heard.push(number),
    refused: ({message}) => assert.fail(message),
    connected: () => {},
  })
  return heard
}

beforeEach(() => {
  clock()
  globalThis.localStorage = storage()
  localStorage.setItem("class-ABCD", JSON.stringify({token: "word"}))
  room = new Room()
  away = undefined
  holdsStreams = false
  server = new FakeServer()
  server.answers = (path, signal, how) => {
    const take = () => room.take(path, how, signal)
    return away ? away(take, signal) : take()
  }
})

afterEach(() => {
  last?.close()
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

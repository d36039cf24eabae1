// Requests of a phone to a class whose server is unreachable arrive once when it is back, for every kind of outage.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {FakeServer, clock, events, pass} from "./browser.js"

const {entered, mine} = await import("../../static/live_class/my_answers.js")
const {Delivery} = await import("../../static/live_class/delivery.js")
const {Stream} = await import("../../static/live_class/stream.js")

const AWAY = 20000 // ms
const BACK = 9500 // ms within which everything has arrived: longer than the longest pause, shorter than a minute
const QUESTION = "d31/d31-03/1"
const ANSWER = {walk: "d31", step: "d31-03", vote: 1, option: 1}
const OTHER = {...ANSWER, option: 2}

/** @type {FakeServer} */ let server
let room, away

/** A class on the server: it stores the answers by the phone's token. */
class Room {
  answers = new Map()
  tokens = 0

  take(path, {method, body, headers}, signal) {
    if (path.endsWith("/token")) return Response.json({code: "ABCD", token: `token ${++this.tokens}`})
    if (path.includes("/events")) return events(signal).answer
    if (method !== "PUT") return Response.json({number: "a.1"})
    this.answers.set(headers.Authorization, JSON.parse(body))
    return new Response(null, {status: 204})
  }
}

const said = (status, sentence) => () => Response.json({sentence}, {status})
const page = status => () => new Response("<html>", {status})

/** Kinds of outage: each answers a request that `take` would answer normally. */
const OUTAGES = {
  offline: () => {
    throw new TypeError("Failed to fetch")
  },
  "502 of a proxy": page(502),
  "404 of a proxy": page(404),
  "404 of a server that has lost the class": said(404, "The class cannot be reached at the moment."),
  "503 of a server that does not have the question again": said(503, "The class has no question yet."),
  429: said(429, "Too many messages at once."),
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
  "an answer": () => {
    const delivery = delivered()
    delivery.give(QUESTION, ANSWER)
    return () => {
      assert.deepEqual([...room.answers], [["Bearer word", ANSWER]])
      assert.ok(delivery.isSent(QUESTION) && !delivery.refused.size && !delivery.isFailing)
    }
  },
  "an answer that is changed during the outage": () => {
    const delivery = delivered()
    delivery.give(QUESTION, ANSWER)
    setTimeout(() => delivery.give(QUESTION, OTHER), AWAY / 2)
    return () => {
      assert.deepEqual([...room.answers], [["Bearer word", OTHER]])
      assert.deepEqual(delivery.answer(QUESTION), OTHER)
    }
  },
  "the answers to two questions": () => {
    const delivery = delivered()
    delivery.give("d31/d31-02/1", OTHER)
    delivery.give(QUESTION, ANSWER)
    return () => assert.deepEqual([...delivery.sent], [["d31/d31-02/1", OTHER], [QUESTION, ANSWER]]) // prettier-ignore
  },
  "an answer whose page is loaded again": () => {
    delivered().give(QUESTION, ANSWER)
    setTimeout(() => {
      last.close()
      last = new Delivery(FOLLOWER, () => {})
    }, AWAY / 2)
    return () => {
      assert.deepEqual([...room.answers], [["Bearer word", ANSWER]])
      assert.deepEqual(mine("ABCD").unsent, {})
    }
  },
  "a token": () => {
    forgetAll()
    const found = []
    entered("ab cd", "the QR code's", () => {}).then(one => found.push(one.token))
    return () => {
      assert.equal(found.length, 1)
      assert.equal(mine("ABCD").token, found[0])
    }
  },
  news: () => {
    const heard = []
    last = new Stream("ABCD", "word", {
      news: ({number}) => heard.push(number),
      refused: refusal => assert.fail(refusal.message),
      connected: () => {},
    })
    return () => assert.ok(heard.length > 0)
  },
}

const FOLLOWER = {code: "ABCD", token: "word", server: "a"}
let last

function delivered() {
  last = new Delivery(FOLLOWER, () => {})
  return last
}

const kept = new Map()
function forgetAll() {
  kept.clear()
}

beforeEach(() => {
  clock()
  forgetAll()
  globalThis.localStorage = {
    getItem: name => kept.get(name) ?? null,
    setItem: (name, text) => kept.set(name, text),
    removeItem: name => kept.delete(name),
  }
  kept.set("class-ABCD", JSON.stringify({token: "word"}))
  room = new Room()
  away = undefined
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
  for (const [how, outage] of Object.entries(OUTAGES))
    test(`${request}: ${how}`, async () => {
      away = outage
      const arrived = begin()
      await pass(AWAY)
      const tries = server.asked.length
      assert.ok(tries > 1 && tries < 60, `${tries} tries`)
      away = undefined
      await pass(BACK + (how === "slow" ? 15000 : 0))
      arrived()
      const {length} = server.asked
      await pass(60000)
      if (request !== "news") assert.equal(server.asked.length, length, "nothing is sent again")
    })

for (const [when, again] of Object.entries({
  "the stream is back": delivery => delivery.wake(),
  "the question is back": delivery => delivery.resend(QUESTION),
}))
  test(`an answer is sent at once when ${when}`, async () => {
    away = OUTAGES.offline
    const delivery = delivered()
    delivery.give(QUESTION, ANSWER)
    await pass(AWAY)
    away = undefined
    again(delivery)
    await pass(5)
    assert.ok(delivery.isSent(QUESTION))
  })

test("an answer that is refused for good is not sent again, and the reason is kept", async () => {
  const delivery = delivered()
  away = said(409, "This question is closed.")
  delivery.give(QUESTION, ANSWER)
  await pass(60000)
  assert.equal(server.asked.length, 1)
  assert.equal(delivery.refused.get(QUESTION), "This question is closed.")
  assert.equal(delivery.answer(QUESTION), null)
  away = undefined
  delivery.give(QUESTION, OTHER)
  await pass(60000)
  assert.ok(delivery.isSent(QUESTION) && !delivery.refused.size)
})

test("an answer counts even if a restarted server no longer has its question and refuses it", async () => {
  const delivery = delivered()
  delivery.give(QUESTION, ANSWER)
  await pass(10)
  away = said(409, "This question is closed.")
  delivery.follower = {...FOLLOWER, server: "b"}
  delivery.resend(QUESTION)
  await pass(1000)
  assert.ok(delivery.isSent(QUESTION) && !delivery.refused.size)
})

test("a wrong typed code is refused at once, a scanned one after half a minute", async () => {
  forgetAll()
  away = said(404, "No class has this code.")
  const found = []
  const failed = reason => found.push([Date.now(), reason.message])
  entered("abcd", "", () => {}).catch(failed)
  await pass(100)
  assert.deepEqual(found, [[0, "No class has this code."]])
  entered("abcd", "the QR code's", () => {}).catch(failed)
  await pass(25000)
  assert.equal(found.length, 1)
  await pass(20000)
  assert.equal(found[1][1], "No class has this code.")
})

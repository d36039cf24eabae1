// The first messages to a new session: they are repeated until the server has accepted them.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {Messages} from "../../static/net/messages.js"

const OWN = {type: "walk", name: "own", text: ""}
const STATE = {step: "own/first"}

beforeEach(() => mock.timers.enable({apis: ["setTimeout"]}))
afterEach(() => mock.timers.reset())

/** Messages of a page that has just reconnected, with everything sent over its new connection. */
function reconnected() {
  const sent = []
  const messages = new Messages(
    async packet => packet,
    () => {},
    error => assert.fail(error),
    error => assert.fail(error),
  )
  messages.state = STATE
  messages.greeting = () => [OWN]
  messages.attach({send: message => sent.push(message)}, true)
  return {messages, sent}
}

/** Messages over a connection. The first waits for its answer; `failed` and `reported` collect errors. */
function asking(unpack, handle) {
  const [sent, failed, reported] = [[], [], []]
  const messages = new Messages(
    unpack,
    handle,
    error => failed.push(error.message),
    error => reported.push(error.message),
  )
  messages.attach({send: message => sent.push(message)}, false)
  messages.send({type: "act", name: "first"})
  messages.send({type: "act", name: "second"})
  return {messages, sent, failed, reported}
}

const kinds = sent => sent.map(({type}) => type)

async function answer(messages, fields) {
  messages.receive({type: "walking", answer: messages.asked.message.number, ...fields})
  await messages.handled
}

test("a walk that a busy new session could not read is sent again, and the state after it", async () => {
  const {messages, sent} = reconnected()
  for (const tries of [1, 2, 3]) {
    assert.deepEqual(kinds(sent), Array(tries).fill("walk"))
    await answer(messages, {is_busy: true})
    assert.ok(messages.behind)
    mock.timers.tick(1000)
  }
  await answer(messages, {is_busy: false})
  assert.deepEqual(kinds(sent), ["walk", "walk", "walk", "walk", "open"])
  assert.deepEqual(sent.at(-1).state, STATE)
})

test("nothing is lost if the connection breaks before the answer", async () => {
  const {messages, sent} = reconnected()
  await answer(messages, {is_busy: true})
  messages.detach()
  mock.timers.tick(1000)
  assert.deepEqual(kinds(sent), ["walk"])
  messages.attach({send: message => sent.push(message)}, true)
  await answer(messages, {is_busy: false})
  assert.deepEqual(kinds(sent), ["walk", "walk", "open"])
})

const shown = number => ({type: "shown", answer: number, state: STATE})

test("an exception in a message handler does not end the connection, and the next message is sent", async () => {
  const {messages, sent, failed, reported} = asking(
    async packet => packet,
    () => {
      throw new Error("!")
    },
  )
  for (const count of [1, 2]) {
    messages.receive(shown(messages.asked.message.number))
    await messages.handled
    assert.equal(reported.length, count)
  }
  assert.deepEqual(failed, [])
  assert.deepEqual(
    sent.map(({name}) => name),
    ["first", "second"],
  )
  assert.ok(messages.rests)
})

test("an unreadable packet ends the connection", async () => {
  const {messages, failed, reported} = asking(
    async () => {
      throw new Error("!")
    },
    () => {},
  )
  messages.receive({})
  await messages.handled
  assert.deepEqual([failed, reported], [["!"], []])
})

test("when a page becomes visible again, one message without an answer ends the connection", async () => {
  const sent = []
  let lost = 0
  const messages = new Messages(async packet => packet, () => {}, assert.fail, assert.fail) // prettier-ignore
  messages.overdue = () => void lost++
  messages.probe()
  messages.attach({send: message => sent.push(message)}, false)
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

test("the page waits four times as long for a worker that is still starting", () => {
  for (const [type, patience] of [
    ["act", 5000],
    ["about", 20000],
    ["csv", 20000],
    ["rows", 20000],
  ]) {
    let lost = 0
    const messages = new Messages(async packet => packet, () => {}, assert.fail, assert.fail) // prettier-ignore
    messages.overdue = () => void lost++
    messages.attach({send: () => {}}, false)
    messages.send({type})
    mock.timers.tick(patience) // it is repeated
    mock.timers.tick(patience - 1)
    assert.equal(lost, 0)
    mock.timers.tick(1)
    assert.equal(lost, 1)
  }
})

// The queue of messages: repeated until the server has accepted them, and when the connection counts as lost.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {Messages} from "../../static/net/messages.js"

const STATE = {step: "own/first"}

let sent, failed, reported, lost

beforeEach(() => {
  mock.timers.enable({apis: ["setTimeout"]})
  ;[sent, failed, reported, lost] = [[], [], [], 0]
})
afterEach(() => mock.timers.reset())

/** @param {boolean} isNew for a new session */
function made(isNew, handle = () => {}) {
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

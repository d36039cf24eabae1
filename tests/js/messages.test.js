// The first words to a new session: they are said until they have been heard.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {Messages} from "../../static/net/messages.js"

const OWN = {type: "walk", name: "own", text: ""}
const STATE = {step: "own/first"}

beforeEach(() => mock.timers.enable({apis: ["setTimeout"]}))
afterEach(() => mock.timers.reset())

/** The messages of a page whose session has just been lost, with all that is sent over its new wire. */
function anew() {
  const sent = []
  const messages = new Messages(
    async told => told,
    () => {},
    error => assert.fail(error),
  )
  messages.state = STATE
  messages.before = () => [OWN]
  messages.attach({send: message => sent.push(message)}, true)
  return {messages, sent}
}

const kinds = sent => sent.map(({type}) => type)

async function answer(messages, told) {
  messages.receive({type: "walking", answer: messages.asked.message.number, ...told})
  await messages.heard
}

test("a walk that a new session had no time for is told again, and the state after it", async () => {
  const {messages, sent} = anew()
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

test("a wire that is lost meanwhile takes nothing with it", async () => {
  const {messages, sent} = anew()
  await answer(messages, {is_busy: true})
  messages.detach()
  mock.timers.tick(1000)
  assert.deepEqual(kinds(sent), ["walk"])
  messages.attach({send: message => sent.push(message)}, true)
  await answer(messages, {is_busy: false})
  assert.deepEqual(kinds(sent), ["walk", "walk", "open"])
})

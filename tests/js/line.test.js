// The first words to a new session: they are said until they have been heard.

import assert from "node:assert/strict"
import {afterEach, beforeEach, mock, test} from "node:test"

import {Line} from "../../static/net/line.js"

const OWN = {type: "walk", name: "own", text: ""}
const STATE = {step: "own/first"}

beforeEach(() => mock.timers.enable({apis: ["setTimeout"]}))
afterEach(() => mock.timers.reset())

/** A line whose session has just been lost, with all that is sent over its new wire. */
function anew() {
  const sent = []
  const line = new Line(
    async told => told,
    () => {},
    error => assert.fail(error),
  )
  line.state = STATE
  line.before = () => [OWN]
  line.attach({send: message => sent.push(message)}, true)
  return {line, sent}
}

const kinds = sent => sent.map(({type}) => type)

async function answer(line, told) {
  line.receive({type: "walking", answer: line.asked.message.number, ...told})
  await line.heard
}

test("a walk that a new session had no time for is told again, and the state after it", async () => {
  const {line, sent} = anew()
  for (const tries of [1, 2, 3]) {
    assert.deepEqual(kinds(sent), Array(tries).fill("walk"))
    await answer(line, {is_busy: true})
    assert.ok(line.behind)
    mock.timers.tick(1000)
  }
  await answer(line, {is_busy: false})
  assert.deepEqual(kinds(sent), ["walk", "walk", "walk", "walk", "open"])
  assert.deepEqual(sent.at(-1).state, STATE)
})

test("a wire that is lost meanwhile takes nothing with it", async () => {
  const {line, sent} = anew()
  await answer(line, {is_busy: true})
  line.detach()
  mock.timers.tick(1000)
  assert.deepEqual(kinds(sent), ["walk"])
  line.attach({send: message => sent.push(message)}, true)
  await answer(line, {is_busy: false})
  assert.deepEqual(kinds(sent), ["walk", "walk", "open"])
})

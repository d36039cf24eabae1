// A saved file can be read for a while: Safari reads it some time after the click.

import assert from "node:assert/strict"
import {resolveObjectURL} from "node:buffer"
import {afterEach, beforeEach, mock, test} from "node:test"

import {clock, pass} from "./browser.js"

const {save} = await import("../../static/export/save.js")

beforeEach(clock)
afterEach(() => {
  mock.timers.reset()
  mock.restoreAll()
})

test("a file is there for half a minute after the click, and not for ever", async () => {
  const made = mock.method(URL, "createObjectURL")
  save("k2.csv", "t,x\n", "text/csv")
  const address = made.mock.calls[0].result
  await pass(30000)
  assert.equal(await resolveObjectURL(address).text(), "t,x\n")
  await pass(30000)
  assert.equal(resolveObjectURL(address), undefined)
})

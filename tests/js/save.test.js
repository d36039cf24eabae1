// A saved file stays readable for some time, because Safari reads it after the click.

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

test("a file's address works for half a minute after the click", async () => {
  const made = mock.method(URL, "createObjectURL")
  save("k2.csv", "t,x\n", "text/csv")
  const address = made.mock.calls[0].result
  await pass(30000)
  assert.equal(await resolveObjectURL(address).text(), "t,x\n")
  await pass(30000)
  assert.equal(resolveObjectURL(address), undefined)
})

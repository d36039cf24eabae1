// A class that a restarted server has lost, restored from the copies in the instructor's browser.

import assert from "node:assert/strict"
import {mock, test} from "node:test"

import {FakeServer} from "./browser.js"

const {Copies} = await import("../../static/live_class/class_backup.js")

const PUT = {walk: "mine", step: "pull", vote: 1, isShown: false, isClosed: false, answered: false, sure: false}

/** The orders of a page that restores a class with this question; the server refuses some. */
async function restored(put, refused = "") {
  const orders = []
  const server = new FakeServer()
  server.answers = (path, signal, {method, body}) => {
    if (method === "PUT") return Response.json({code: "ABCD", key: "key"})
    const {type} = JSON.parse(body)
    orders.push(type)
    return type === refused ? Response.json({sentence: "No."}, {status: 409}) : new Response(null, {status: 204})
  }
  const copies = new Copies({code: "ABCD", key: "key", put})
  copies.take("mine", "a text")
  await copies.restore()
  return orders
}

test("phones do not wait for a question that is not restored", async () => {
  mock.method(console, "warn", () => {})
  assert.deepEqual(await restored(PUT), ["walk", "put"])
  assert.deepEqual(await restored(null), ["walk", "withdraw"])
  assert.deepEqual(await restored(PUT, "put"), ["walk", "put", "withdraw"])
})

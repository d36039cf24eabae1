// The page's own reading of messages, for tests in Python: one message a line, in and out.

import {createInterface} from "node:readline"
import {unpacked} from "../../static/net/columns.js"

/** @param {string} _ @param {unknown} value */
const plain = (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value)

for await (const line of createInterface({input: process.stdin})) {
  const {data, usual} = JSON.parse(line)
  const told = await unpacked(Uint8Array.from(Buffer.from(data, "base64")).buffer, usual)
  process.stdout.write(JSON.stringify(told, plain) + "\n")
}

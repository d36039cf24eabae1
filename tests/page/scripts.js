// The page's own scripts for tests in Python: each input line has a function and its cases, each output line results.

import {createInterface} from "node:readline"
import "../js/browser.js"

/** @param {string} _ @param {unknown} value */
const plain = (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value)

console.error = text => {
  throw new Error(text)
}

for await (const line of createInterface({input: process.stdin})) {
  const [module, name, cases] = JSON.parse(line)
  const told = {found: []}
  try {
    const {[name]: called} = await import(`../../${module}.js`)
    for (const given of cases) told.found.push(await called(...given))
  } catch (error) {
    told.fault = error.stack
  }
  process.stdout.write(JSON.stringify(told, plain) + "\n")
}

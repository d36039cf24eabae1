// The votes of an earlier class: read from its table; other files are refused with a reason.

import assert from "node:assert/strict"
import {test} from "node:test"

import "./browser.js"

const {countedOf, earlier} = await import("../../static/live_class/earlier.js")

const HEAD = "phone,time,here,walk,step,vote,question,answer,unit,right\r\n"
const row = (answer, step = "d31-03", vote = 1) => `1,,2,d31,${step},${vote},"Why, ""so""?",${answer},,no\r\n`
const CHOICE = {options: ["Twice as far", "k2 alone"], plot: ""}
globalThis.DOMParser ??= class {
  parseFromString = html => ({body: {textContent: html}})
}

test("first votes are counted by the options' texts, not by their letters", () => {
  const text = HEAD + row("Twice as far") + row('"k₂, alone"') + row("Twice as far", "d31-03", 2) + row("=gone")
  const counted = countedOf(earlier(text, ["d31"]).get("d31/d31-03"), CHOICE)
  assert.deepEqual([counted.answered, counted.options], [3, [1, 1]])
})

test("cells that are not numbers are left out", () => {
  const answers = earlier(HEAD + row("2.5") + row("'-1") + row("two"), ["d31"]).get("d31/d31-03")
  assert.deepEqual(countedOf(answers, {options: [], plot: ""}).numbers, [2.5, -1])
  assert.equal(countedOf(["x"], {options: [], plot: ""}), null)
  assert.equal(countedOf(["1"], {options: [], plot: "x1"}), null)
})

test("a file that is no table of a class, or is from another walk, is refused with a reason", () => {
  assert.throws(() => earlier("", ["d31"]), /needs the columns walk, step, vote and answer/)
  assert.throws(() => earlier("<html>🙂</html>", ["d31"]), /needs the columns/)
  assert.throws(() => earlier(HEAD, ["d31"]), /This file has no answers/)
  assert.throws(() => earlier(HEAD + row("A"), ["mine"]), /to the walk “d31”. Open/)
  assert.throws(() => earlier("x".repeat(5e6 + 1), ["d31"]), /at most 5 MB/)
  assert.throws(() => earlier(`${HEAD}"never closed`, ["d31"]), /no answers/)
})

// The answers of a class: the order of options, the line with numbers, an earlier class, the headline of the summary.

import assert from "node:assert/strict"
import {test} from "node:test"

import "./browser.js"

const {beside, fitting, reach} = await import("../../static/questions/dots.js")
const {countedOf, earlier} = await import("../../static/live_class/earlier.js")
const {headline} = await import("../../static/live_class/summary.js")
const {orderOf} = await import("../../static/questions/order.js")

test("a fixed order of options stays; otherwise each seed has its own, with every option first equally often", () => {
  const options = Array(4).fill("")
  assert.deepEqual(orderOf({id: "d31-01", options, fixed: true}, "ABCD"), [0, 1, 2, 3])
  const firsts = [0, 0, 0, 0]
  for (let seed = 0; seed < 4000; seed++) {
    const order = orderOf({id: "d31-01", options, fixed: false}, seed.toString(16).toUpperCase())
    assert.deepEqual(order.toSorted(), [0, 1, 2, 3])
    firsts[order[0]]++
  }
  for (const count of firsts) assert.ok(count > 900 && count < 1100, String(firsts))
})

const many = (count, value) => Array(count).fill(value)

for (const [answers, truths, line] of [
  [[], [], [0, 0]],
  [[], [2], [2, 2]],
  [[1, 2, 3], [], [1, 3]],
  [[1, 2, 3], [20], [1, 20]],
  [[...many(100, 0.5), ...many(50, 5), ...many(30, 0.05)], [0.5], [0.05, 5]],
  [[0.5, 0.52, 1e6], [0.5], [0.5, 0.52]],
  [[...many(280, 0.498), -1e9, 1e300, 1e300], [0.498], [0.498, 0.498]],
  ...[1e3, 1e30, -1e12, 1.7e308].map(far => [[1, 1.1, 1.2, 1.3, 1.4, far], [], [1, 1.4]]),
])
  test(`the line with ${answers.slice(-3)} has room for most answers and the right one, not for outliers`, () => {
    assert.deepEqual(reach(answers, truths), line)
  })

test("labels do not overlap; each is as close to its bar as the others allow", () => {
  const labels = [2, 1, 3].map(value => ({value, words: `${value}`, width: 60}))
  const at = value => 100 + 10 * value
  const places = beside(labels, at).map(({from, x}) => [from, x])
  assert.deepEqual(places, [[110, 110], [120, 178], [130, 246]]) // prettier-ignore
  assert.equal(beside([{value: 20, words: "20", width: 60}], at)[0].x, 250)
  assert.equal(fitting(many(9, labels[0])).length, 4)
})

const HEAD = "phone,time,here,walk,step,vote,question,answer,unit,right\r\n"
const row = (answer, vote = 1) => `1,,2,d31,d31-03,${vote},"Why, ""so""?",${answer},,no\r\n`
const read = rows => earlier(HEAD + rows, ["d31"]).get("d31/d31-03")
globalThis.DOMParser ??= class {
  parseFromString = html => ({body: {textContent: html}})
}

test("first votes of an earlier class are counted by the options' texts, or as numbers", () => {
  const chosen = read(row("Twice as far") + row('"k₂, alone"') + row("Twice as far", 2) + row("=gone"))
  const {answered, options} = countedOf(chosen, {options: ["Twice as far", "k2 alone"], plot: ""})
  assert.deepEqual([answered, options], [3, [1, 1]])
  const numbers = read(row("2.5") + row("'-1") + row("two"))
  assert.deepEqual(countedOf(numbers, {options: [], plot: ""}).numbers, [2.5, -1])
  assert.equal(countedOf(["x"], {options: [], plot: ""}), null)
  assert.equal(countedOf(["1"], {options: [], plot: "x1"}), null)
})

for (const [text, walk, reason] of [
  ["", "d31", /needs the columns walk, step, vote and answer/],
  ["<html>🙂</html>", "d31", /needs the columns/],
  [HEAD, "d31", /This file has no answers/],
  [HEAD + row("A"), "mine", /to the walk “d31”. Open/],
  ["x".repeat(5e6 + 1), "d31", /at most 5 MB/],
  [`${HEAD}"never closed`, "d31", /no answers/],
])
  test(`a file that is no table of a class, or is from another walk, is refused: ${reason}`, () => {
    assert.throws(() => earlier(text, [walk]), reason)
  })

const step = (place, votes, walk = "d34") => ({
  walk,
  place,
  votes: votes.map(([right, answered], i) => ({vote: i + 1, right, answered})),
})

// prettier-ignore
for (const [steps, words] of [
  [[], "Nobody has answered a question yet."],
  [
    [step(2, [[90, 100]]), step(7, [[1, 4]]), step(9, [[0, 10], [8, 10]])],
    "Wrong most: step 7 (75 % of the answers)",
  ],
  [[step(1, [[1, 2]]), step(4, [[2, 4]])], "Wrong most: step 1, step 4 (50 % of the answers)"],
  [[step(1, [[1, 2]], "d31"), step(1, [[0, 2]])], "Wrong most: step 1 of d34 (100 % of the answers)"],
])
  test(`the summary names the step with the most wrong answers in its last vote: ${words}`, () => {
    assert.equal(headline(steps), words)
  })

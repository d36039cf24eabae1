// The headline of a class's summary: the step with the most wrong answers.

import assert from "node:assert/strict"
import {test} from "node:test"

import "./browser.js"

const {headline} = await import("../../static/live_class/summary.js")

const step = (place, votes, walk = "d34") => ({
  walk,
  place,
  votes: votes.map(([right, answered], i) => ({vote: i + 1, right, answered})),
})

test("it names the step with the largest share of wrong answers in its last vote", () => {
  assert.equal(headline([]), "Nobody has answered a question yet.")
  assert.equal(headline([step(1, [[3, 3]])]), "All answers were right.")
  const steps = [step(2, [[90, 100]]), step(7, [[1, 4]]), step(9, [[0, 10], [8, 10]])] // prettier-ignore
  assert.equal(headline(steps), "Wrong most: step 7 (75 % of the answers)")
  assert.equal(headline([step(1, [[1, 2]]), step(4, [[2, 4]])]), "Wrong most: step 1, step 4 (50 % of the answers)")
  const two = [step(1, [[1, 2]], "d31"), step(1, [[0, 2]], "d34")]
  assert.equal(headline(two), "Wrong most: step 1 of d34 (100 % of the answers)")
})

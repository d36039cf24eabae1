// A vote on a question asked aloud: a step on the current picture, with four answers and no right one.

import {ALOUD, shownBy, stepText, walkText} from "../walks/draft.js"

const LETTERS = ["A", "B", "C", "D"]

/**
 * Leaves the current step and starts the vote. Resolves with "", or with the reason why that is not possible.
 * @param {LectureHost} lecture @returns {Promise<string>}
 */
export async function poll({walks, messages, kept}) {
  const covered = walks.walk?.lesson ? [] : kept.covered
  const answer = await messages.request({type: "open", state: {...kept, covered, step: ""}})
  if (answer.type !== "shown") return "This picture cannot be voted on."
  const before = walks.texts[ALOUD] ?? walkText("Votes", [])
  const place = before.split("\n[[step]]\n").length - 1
  return walks.run(ALOUD, before + stepText(stepOn(shownBy(answer.query), covered, place + 1)), place)
}

/**
 * @param {string} state of the page, as a link @param {string[]} cover hidden parts @param {number} number of the vote
 */
const stepOn = (state, cover, number) => ({
  id: `vote-${number}`,
  kind: "choice",
  poll: true,
  fixed: true,
  title: `Vote ${number}`,
  state,
  cover,
  question: `Vote ${number}. What is your answer to the question just asked?`,
  options: LETTERS.map(text => ({text})),
  explain: "The question was asked aloud.",
})

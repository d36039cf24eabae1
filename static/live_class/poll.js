// A vote on a question asked aloud: a step with four answers of which none is right, on what is shown.

import {stepText, walkText} from "../walks/asked.js"

const VOTES = "votes" // the name of their walk
const LETTERS = ["A", "B", "C", "D"]

/**
 * Leaves the step of a walk that stands, as it stands, and puts the vote; why it cannot be, or "".
 * @param {LectureHost} lecture @returns {Promise<string>}
 */
export async function poll({walks, line, kept}) {
  const covered = walks.walk?.lesson ? [] : kept.covered
  const told = await line.ask({type: "open", state: {...kept, covered, step: ""}})
  if (told.type !== "shown") return "This picture cannot be voted on."
  const query = told.query.split("&").filter(part => !part.startsWith("cover="))
  const before = walks.texts[VOTES] ?? walkText("Votes", [])
  const place = before.split("\n[[step]]\n").length - 1
  return walks.run(VOTES, before + stepText(stepOn(query.join("&"), covered, place + 1)), place)
}

/** @param {string} query of what is shown @param {string[]} cover @param {number} number of the vote */
const stepOn = (query, cover, number) => ({
  id: `vote-${number}`,
  kind: "choice",
  poll: true,
  fixed: true,
  title: `Vote ${number}`,
  state: `?${query}`,
  cover,
  question: "What is your answer to the question just asked?",
  options: LETTERS.map(text => ({text})),
  explain: "The question was asked aloud.",
})

// The votes of an earlier class, from its CSV, which are outlined behind the current ones.

import {bare} from "../core/plain.js"

const LARGEST = 5e6 // characters of a file
const NEEDED = ["walk", "step", "vote", "answer"]
const FIRST = "1" // number of the vote that is read; later votes follow a discussion

/** Answers by question, "d31/d31-03". @typedef {Map<string, string[]>} Earlier */

/**
 * Reads the answers in a file; throws an error with a sentence if it is no table of a class, or has no known walk.
 * @param {string} text @param {string[]} walks @returns {Earlier}
 */
export function earlier(text, walks) {
  if (text.length > LARGEST) throw new Error("This file is too large: at most 5 MB can be read.")
  const [head = [], ...rows] = table(text)
  const places = NEEDED.map(name => head.indexOf(name))
  if (places.includes(-1))
    throw new Error(
      "This is not the CSV of a class: it needs the columns walk, step, vote and answer in its first line.",
    )
  /** @type {Earlier} */
  const found = new Map()
  for (const row of rows) {
    const [walk, step, vote, answer] = places.map(place => row[place] ?? "")
    if (vote !== FIRST) continue
    const question = `${walk}/${step}`
    found.set(question, [...(found.get(question) ?? []), answer])
  }
  if (!found.size) throw new Error("This file has no answers.")
  const names = new Set([...found.keys()].map(question => question.split("/")[0]))
  if (!walks.some(name => names.has(name))) {
    const [first] = names
    throw new Error(`Its answers belong to the walk “${first.slice(0, 40)}”. Open that walk first.`)
  }
  return found
}

/**
 * Counts answers like the votes on a step; null if the table has too little data for this kind of question.
 * @param {string[]} answers @param {page.StepCard} step @returns {page.Counted | null}
 */
export function countedOf(answers, step) {
  const nothing = {options: [], numbers: [], sketches: [], having: [], sure: [], words: []}
  if (step.options.length) {
    const names = step.options.map(html => letters(bare(html)))
    const chosen = answers.map(letters)
    const options = names.map(name => chosen.filter(one => one === name).length)
    return {...nothing, answered: answers.length, options}
  }
  const numbers = answers.map(answer => Number(answer.replace(/^'/, ""))).filter(Number.isFinite)
  return step.plot || !numbers.length ? null : {...nothing, answered: numbers.length, numbers}
}

/** A text without signs and spaces, because the table and the page may differ in them. @param {string} text */
const letters = text => text.normalize("NFKC").replaceAll(/[^\p{L}\p{N}]/gu, "")

/** The cells of a CSV by rows. @param {string} text */
function table(text) {
  /** @type {string[][]} */
  const rows = [[]]
  const cells = /(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r?\n|\r|$)/gy
  const whole = text.replace(/^\ufeff/, "")
  while (cells.lastIndex < whole.length) {
    const match = cells.exec(whole)
    if (!match) break // for a quote that is not closed
    rows[rows.length - 1].push(match[1]?.replaceAll('""', '"') ?? match[2])
    if (match[3] !== ",") rows.push([])
  }
  return rows.filter(row => row.length)
}

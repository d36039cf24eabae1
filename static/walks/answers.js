// The visitor's answers, stored only in this browser. The tab also stores the answer to the current step, so that it is
// visible after a reload.

import {browserStorage, tabStorage} from "../core/storage.js"
import {bare} from "../core/plain.js"

/**
 * @typedef {{said: string, right: boolean, title: page.Html}} KeptAnswer an answer, in words, whether it was right, and
 * the title of its step
 * @typedef {{step: string, given: Partial<page.Given>}} Answered the answer to a step of a walk, such as "d34/d34-07"
 */

const KEY = "walk-answers"
const HERE = "answered-step"

/** @returns {Answered | null} */
export const answered = () => tabStorage.value(HERE)

/** @param {Answered} known */
export const keepAnswered = known => tabStorage.keep(HERE, known)

export const forgetAnswered = () => tabStorage.forget(HERE)

export class Answers {
  constructor() {
    /** @type {Record<string, KeptAnswer>} by the id of the step */
    this.kept = browserStorage.value(KEY) ?? {}
  }

  /** @param {string} step */
  of(step) {
    return /** @type {KeptAnswer | undefined} */ (this.kept[step])
  }

  /** @param {string} step @param {KeptAnswer} answer */
  keep(step, answer) {
    this.kept[step] = answer
    this.#store()
  }

  clear() {
    this.kept = {}
    this.#store()
  }

  #store() {
    browserStorage.keepOrSay(KEY, this.kept)
  }

  /** All answers as a text that the visitor can save. @param {page.WalkSheet[]} sheets */
  text(sheets) {
    const lines = sheets.flatMap(({title, steps}) => {
      const known = steps.filter(step => this.of(step.id))
      return known.length ? [title, "", ...known.flatMap(step => this.#lines(step)), ""] : []
    })
    return lines.length ? lines.join("\n") : "No question has been answered yet.\n"
  }

  /** @param {page.StepCard} step */
  #lines(step) {
    const {said, right, title} = /** @type {KeptAnswer} */ (this.of(step.id))
    return [
      `${step.place} (${step.id})`,
      `  ${bare(step.given)} ${bare(step.question)}`.trimEnd(),
      `  Your answer: ${said}${right ? ", right" : ""}`,
      `  ${bare(title)}`,
    ]
  }
}

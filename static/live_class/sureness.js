// Confidence in an answer: three levels, which are sent and counted with it.

import {chip, element} from "../core/dom.js"

const LEVELS = ["I guessed", "Fairly sure", "Certain"]
const COUNTED = ["guessed", "fairly sure", "certain"]

/** The three buttons under the question on a phone. */
export class Sureness {
  level = 0 // from 1 on

  /** @param {() => void} changed */
  constructor(changed) {
    this.chips = LEVELS.map((name, i) => chip(name, () => this.#choose(i + 1, changed)))
    const about = {class: "chips sureness", role: "group", "aria-label": "How sure are you?"}
    this.element = element("div", about, element("span", {}, "How sure are you?"), ...this.chips)
    this.setTo(0)
  }

  /** @param {number} level @param {() => void} changed */
  #choose(level, changed) {
    this.setTo(level)
    changed()
  }

  /** Marks the chosen level. @param {number} level */
  setTo(level) {
    this.level = level
    for (const [i, one] of this.chips.entries()) one.setAttribute("aria-pressed", String(i + 1 === level))
  }
}

/**
 * The levels with their counts and, if the answer is shown, the number of right ones.
 * @param {page.Counted} counted @param {boolean} isShown
 */
export function sureness({sure}, isShown) {
  const levels = sure.map(([count, right], i) => `${count} ${COUNTED[i]}${isShown && count ? ` (${right} right)` : ""}`)
  return levels.length ? `How sure: ${levels.join(", ")}` : ""
}

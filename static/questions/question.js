// The base class of all kinds of question, with the methods that cards, classes, handouts and 'Write a question' use.
// kinds.js lists the kinds.

import {element, svg} from "../core/dom.js"

/**
 * @typedef {import("../scene/plots.js").Plot} Plot
 * @typedef {Omit<page.Given, "walk" | "step" | "vote">} Answer
 * @typedef {Record<string, Toml>} Fields of a step, by their names in a walk's file
 */

/**
 * The answers of a class, over or next to the question until they are hidden; a headline summarises them.
 * @typedef {{update: (tally: page.Tally, lesson: page.Lesson | null,
 *   moderate?: import("./word_groups.js").Moderate) => void,
 *   headline: (tally: page.Tally) => string, leave: () => void}} Tallied
 */

/** Label of the button that opens a case that a reply mentions. */
export const SUCH = "Show such a case"

/** A disc with a tick, or a ring with a cross. @param {boolean} right */
export function mark(right) {
  const sign = right ? "M5.5 10.200l3 3 6-6.400" : "M6.500 6.500l7 7m0-7l-7 7"
  const [fill, stroke] = right ? ["var(--ink)", "var(--paper)"] : ["var(--paper)", "var(--ink)"]
  const parts = [svg("circle", {cx: 10, cy: 10, r: 8.5, fill}), svg("path", {d: sign, stroke})]
  return svg("svg", {viewBox: "0 0 20 20", class: "judged", role: "img",
    "aria-label": right ? "right" : "wrong"}, ...parts) // prettier-ignore
}

/** A plot of a page by its name. @param {Plot[]} plots @param {string} name */
export const plotOf = (plots, name) => /** @type {Plot} */ (plots.find(({block}) => block.name === name))

export class Question {
  /** The name of the kind in the editor. */
  static label = ""

  /** The fields that the editor shows for this kind. @type {(plots: Plot[]) => HTMLElement[]} */
  static fields

  /**
   * The filled-in fields, as they are written into a walk's file. @type {(form: HTMLFormElement, plots: Plot[]) =>
   * Fields & {cover?: string[]}}
   */
  static read

  /** @type {() => void} called when the answer changes */
  changed = () => {}

  element = element("div")

  again = "Answer again"

  /** @param {page.StepCard} step @param {WalkHost} walk @param {PartHost} page */
  constructor(step, walk, page) {
    this.step = step
    this.walk = walk
    this.page = page
    this.plot = plotOf(page.plots, step.plot) // the plot on which the visitor marks or draws, if any
  }

  /** The answer, in words. @returns {string} */
  said() {
    return ""
  }

  /** Chooses an option by its position on the screen. @param {number} _place */
  choose(_place) {}

  /** The answer for the message, or null. @returns {Answer | null} */
  given() {
    return null
  }

  /** Shows an answer that was sent before. @param {Answer} _given */
  restore(_given) {}

  /** @param {page.Lesson} _lesson */
  teach(_lesson) {}

  /** @param {Drawn} _shown */
  update(_shown) {}

  leave() {}

  /** The answers of a class. @param {HTMLElement} _chips below them @returns {Tallied} */
  tally(_chips) {
    throw new Error(`No answers to a ${this.step.kind} can be shown.`)
  }

  /** Space for the answer, on paper. @returns {HTMLElement} */
  space() {
    return element("p")
  }

  /** The right answer on paper. @param {page.Lesson} lesson @returns {HTMLElement[]} */
  printed({truth}) {
    return truth ? [element("p", {}, element("b", {}, `${truth}.`))] : []
  }
}

// The four kinds of question: what the card shows of each, what was answered, and what is said of it.

import {element, marked, svg} from "../dom.js"
import {Marker} from "./marker.js"
import {Pad} from "./pad.js"

/**
 * @typedef {import("./walk.js").Walk} Walk
 * @typedef {Partial<Pick<page.Given, "option" | "text" | "value" | "curves">>} Answer
 * @typedef {import("./pad.js").Strokes} Strokes
 */

/** A disc with a tick, or a ring with a cross. @param {boolean} right */
export function mark(right) {
  const sign = right ? "M5.5 10.200l3 3 6-6.400" : "M6.500 6.500l7 7m0-7l-7 7"
  const parts = [svg("circle", {cx: 10, cy: 10, r: 8.5}), svg("path", {d: sign})]
  return svg("svg", {viewBox: "0 0 20 20", class: right ? "judged right" : "judged", role: "img",
    "aria-label": right ? "right" : "wrong"}, ...parts) // prettier-ignore
}

class Question {
  /** @type {() => void} called when the answer is another */
  changed = () => {}

  /** What was drawn. @returns {Strokes} */
  get strokes() {
    return {}
  }

  /** @type {HTMLElement | undefined} the plot that is marked or drawn on */
  host

  element = element("div", {class: "question"})

  /** What was answered, in words. @returns {string} */
  said() {
    return ""
  }

  /** An option by its number. @param {number} _option */
  choose(_option) {}

  /** What is sent; null without an answer. @returns {Answer | null} */
  given() {
    return null
  }

  /** The answer as it is restored. @returns {Partial<page.Vote>} */
  get vote() {
    const {text = "", option = null, value = null} = this.given() ?? {}
    return {text, option, value}
  }

  /** What was answered before. @param {Partial<page.Vote>} _vote */
  restore(_vote) {}

  /** @param {page.Lesson} _lesson */
  teach(_lesson) {}

  /** @param {Drawn} _shown */
  update(_shown) {}

  leave() {}
}

class Choice extends Question {
  chosen = -1
  taught = false

  /** @param {page.StepCard} step @param {Walk} walk */
  constructor({options}, walk) {
    super()
    this.walk = walk
    this.rows = options.map((html, i) => this.#row(html, i))
    this.element.classList.add("answers")
    this.element.setAttribute("role", "group")
    this.element.setAttribute("aria-label", "Answers")
    this.element.append(...this.rows.map(({row}) => row))
  }

  /** @param {page.Html} html @param {number} i */
  #row(html, i) {
    const line = element("span", {class: "line"})
    const yours = element("span", {class: "yours"})
    const name = marked("span", {class: "name"}, html)
    const key = element("span", {class: "key"}, String(i + 1))
    const row = element("button", {type: "button", "aria-pressed": "false"}, key, name, yours, line)
    row.addEventListener("click", () => this.choose(i))
    return {row, line, yours, name, where: /** @type {page.State | null} */ (null)}
  }

  /** @param {number} i */
  choose(i) {
    if (!this.rows[i]) return
    if (this.taught) return this.#taught(i)
    this.chosen = i
    for (const [j, {row}] of this.rows.entries()) row.setAttribute("aria-pressed", String(i === j))
    this.changed()
  }

  /** What is said of an answer, and the state where it would be right. @param {number} i */
  #taught(i) {
    const {row, where} = this.rows[i]
    const {hall} = this.walk.lecture
    const isTold = row.classList.toggle("told")
    if (hall.on) for (const other of this.rows) other.row.classList.toggle("told", isTold && other.row === row)
    if (where && (isTold || !hall.on)) this.walk.lecture.open(where)
  }

  said() {
    return this.rows[this.chosen]?.name.textContent ?? ""
  }

  given() {
    return this.chosen < 0 ? null : {option: this.chosen}
  }

  /** @param {Partial<page.Vote>} vote */
  restore({option}) {
    this.choose(option ?? -1)
  }

  /** @param {page.Lesson} lesson */
  teach({verdicts}) {
    this.taught = true
    this.element.classList.add("taught")
    for (const [i, {right, reply, where}] of verdicts.entries()) {
      const {row, line, yours} = this.rows[i]
      row.classList.toggle("told", i === this.chosen)
      line.innerHTML = where ? `${reply} <u>Show a case where this is right</u>` : reply
      this.rows[i].where = where
      yours.textContent = i === this.chosen ? "your answer" : ""
      if (right || i === this.chosen) row.append(mark(right))
    }
  }
}

class Numeric extends Question {
  /** @param {page.StepCard} step @param {Walk} walk */
  constructor({unit}, walk) {
    super()
    this.unit = unit
    this.field = element("input", {
      name: "answer",
      autocomplete: "off",
      "aria-label": "Your answer",
    })
    this.field.addEventListener("input", () => this.changed())
    this.field.addEventListener("keydown", event => {
      if (event.key === "Enter") walk.show(false)
    })
    this.yours = element("span", {class: "yours"})
    this.element.append(element("label", {class: "number"}, this.field, element("span", {}, unit), this.yours))
  }

  said() {
    const text = this.field.value.trim()
    return /^[-−+]?[\d.,]+$/.test(text) ? `${text} ${this.unit}`.trim() : text
  }

  given() {
    return this.field.value.trim() ? {text: this.field.value} : null
  }

  /** @param {Partial<page.Vote>} vote */
  restore({text = ""}) {
    this.field.value = text
  }

  /** @param {page.Lesson} lesson */
  teach({right}) {
    this.field.readOnly = true
    this.yours.textContent = right === null ? "" : "your answer"
    if (right !== null) this.yours.after(mark(right))
  }
}

class Point extends Question {
  /**
   * @param {page.StepCard} step @param {Walk} _walk
   * @param {import("../page.js").Page} page
   */
  constructor(step, _walk, page) {
    super()
    this.unit = step.unit
    this.marker = new Marker(page, step, () => this.#moved())
    this.host = this.marker.plot.host
    this.shown = element("p", {class: "hint", role: "status"}, "Press on the axis, or move the ? with the arrow keys.")
    this.element.append(this.shown)
  }

  #moved() {
    this.shown.textContent = `Your mark: ${this.said()}`
    this.changed()
  }

  said() {
    return `${this.marker.number} ${this.unit}`.trim()
  }

  given() {
    return this.marker.value === null ? null : {value: this.marker.value}
  }

  /** @param {Partial<page.Vote>} vote */
  restore({value}) {
    if (typeof value === "number") this.marker.put(value)
  }

  /** @param {page.Lesson} lesson */
  teach({right, places}) {
    if (right !== null) this.shown.append(" ", mark(right))
    else this.shown.textContent = "" // how to mark is of no use any more
    this.marker.teach(places)
  }

  update() {
    this.marker.place()
  }

  leave() {
    this.marker.leave()
  }
}

class Sketch extends Question {
  /**
   * @param {page.StepCard} step @param {Walk} walk
   * @param {import("../page.js").Page} page
   */
  constructor(step, walk, page) {
    super()
    this.curves = step.curves
    this.pad = new Pad(page, step, walk.before, () => this.changed())
    this.host = this.pad.plot.host
    this.clear = element("button", {type: "button", class: "chip"}, "Clear")
    this.clear.addEventListener("click", () => this.pad.clear())
    this.pens = step.curves.map(name => this.#pen(name))
    this.tools = element("div", {class: "chips"}, ...(this.pens.length > 1 ? this.pens : []), this.clear)
    const hint = "Draw on the empty axes. With keys: arrows move the pen, Enter lowers or lifts it."
    this.hint = element("p", {class: "hint"}, hint)
    this.element.append(this.hint, this.pad.status, this.tools)
    this.#take(step.curves[0])
  }

  get strokes() {
    return this.pad.strokes
  }

  /** @param {string} name */
  #pen(name) {
    const pen = element("button", {type: "button", class: "chip", "aria-pressed": "false"}, `Draw ${name}`)
    pen.addEventListener("click", () => this.#take(name))
    return pen
  }

  /** @param {string} name */
  #take(name) {
    this.pad.take(name)
    for (const [i, pen] of this.pens.entries()) pen.setAttribute("aria-pressed", String(this.curves[i] === name))
  }

  said() {
    return this.counted
  }

  given() {
    const {strokes} = this.pad
    return Object.values(strokes).some(stroke => stroke.length > 1) ? {curves: strokes} : null
  }

  get vote() {
    return {curves: this.pad.sent}
  }

  /** @param {Partial<page.Vote>} vote */
  restore({curves = {}}) {
    this.pad.restore(curves)
  }

  counted = "a sketch"

  /** @param {page.Lesson} lesson */
  teach({findings}) {
    this.counted = `${findings.filter(finding => finding.has).length} of ${findings.length} features`
    const rows = findings.map(({has, name, words}) =>
      element("li", {}, mark(has), marked("b", {}, name), marked("span", {}, words)),
    )
    this.hint.remove()
    this.tools.replaceWith(element("ul", {class: "findings"}, ...(this.given() ? rows : [])))
    this.pad.teach(this.given() ? findings : [])
  }

  update() {
    this.pad.place()
  }

  leave() {
    this.pad.leave()
  }
}

const KINDS = {choice: Choice, number: Numeric, point: Point, sketch: Sketch}

/**
 * @param {page.StepCard} step @param {Walk} walk
 * @param {import("../page.js").Page} page @returns {Question}
 */
export const questionOf = (step, walk, page) => new KINDS[step.kind](step, walk, page)

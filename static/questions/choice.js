// The choice question: buttons for the answers, each with a comment; a class's votes are bars next to them.

import {button, element, marked} from "../core/dom.js"
import {box, text} from "./fields.js"
import {orderOf} from "./order.js"
import {Question, SUCH, mark} from "./question.js"

const OFFERED = [1, 2, 3, 4] // number of options that the editor offers

export class Choice extends Question {
  static label = "Choice"

  static fields() {
    return [...OFFERED.map(optionRow), box("fixed", "fixed", "The answers keep this order")]
  }

  /** @param {HTMLFormElement} form */
  static read(form) {
    /** @type {import("./question.js").Fields} */
    const fields = {options: OFFERED.flatMap(n => optionOf(form, n))}
    return text(form, "fixed") ? {...fields, fixed: true} : fields
  }

  chosen = -1
  taught = false
  order = orderOf(this.step, this.walk.seed)
  rows = this.step.options.map((html, i) => this.#row(html, i))
  element = element(
    "div",
    {class: "question answers", role: "group", "aria-label": "Answers"},
    ...this.order.map(i => this.rows[i].row),
  )

  /** @param {page.Html} html @param {number} i */
  #row(html, i) {
    const line = element("span", {class: "line"})
    const yours = element("span", {class: "yours"})
    const name = marked("span", {class: "name"}, html)
    const key = element("span", {class: "key"}, String(this.order.indexOf(i) + 1))
    const row = button({"aria-pressed": "false", "data-option": i}, () => this.#choose(i), key, name, yours, line)
    return {row, line, yours, name, where: /** @type {page.State | null} */ (null)}
  }

  /** @param {number} place in the shown order */
  choose(place) {
    this.#choose(this.order[place])
  }

  /** @param {number} i its place in the file */
  #choose(i) {
    if (!this.rows[i]) return
    if (this.taught) return this.#taught(i)
    this.chosen = i
    for (const [j, {row}] of this.rows.entries()) row.setAttribute("aria-pressed", String(i === j))
    this.changed()
  }

  /** Shows the reply to an answer, and the case that it mentions. @param {number} i */
  #taught(i) {
    const {row, where} = this.rows[i]
    const {host} = this.page
    const isShown = row.classList.toggle("replied")
    if (host.hall.on) for (const other of this.rows) other.row.classList.toggle("replied", isShown && other.row === row)
    if (where && (isShown || !host.hall.on)) host.open(where)
  }

  said() {
    return this.rows[this.chosen]?.name.textContent ?? ""
  }

  given() {
    return this.chosen < 0 ? null : {option: this.chosen}
  }

  /** @param {import("./question.js").Answer} given */
  restore({option}) {
    this.#choose(option ?? -1)
  }

  /** @param {page.Lesson} lesson */
  teach({verdicts}) {
    this.taught = true
    this.element.classList.add("taught")
    for (const [i, {right, reply, where}] of verdicts.entries()) {
      const {row, line, yours} = this.rows[i]
      row.classList.toggle("replied", i === this.chosen)
      line.innerHTML = where ? `${reply} <u>${SUCH}</u>` : reply
      this.rows[i].where = where
      yours.textContent = i === this.chosen ? "your answer" : ""
      if (right || i === this.chosen) row.append(mark(right))
    }
  }

  tally() {
    return new Bars(this.rows.map(({row}) => row))
  }

  space() {
    return element("ul", {class: "boxes"}, ...this.order.map(i => marked("li", {}, this.step.options[i])))
  }

  /** @param {page.Lesson} lesson */
  printed({verdicts}) {
    const right = this.step.options.filter((_, i) => verdicts[i]?.right)
    return right.map(option => marked("p", {}, `<b>${option}.</b>`))
  }
}

/** The votes for each answer, in its row. */
class Bars {
  /** @param {HTMLElement[]} rows */
  constructor(rows) {
    this.rows = rows
  }

  /** @param {page.Tally} tally @param {page.Lesson | null} lesson */
  update({now, before}, lesson) {
    this.leave()
    // Uses shares of the answers, so that two votes can be compared if different numbers of phones took part.
    const sizes = [now, before].map(
      counted => counted?.options.map(count => count / Math.max(1, counted.answered)) ?? [],
    )
    const most = Math.max(...sizes.flat()) || 1
    for (const [i, row] of this.rows.entries()) {
      const parts = [element("i", {style: `--share: ${sizes[0][i] / most}`})]
      if (before?.options[i]) parts.push(element("i", {class: "before", style: `--share: ${sizes[1][i] / most}`}))
      const count = element("span", {class: "vote-count"}, ...(before ? [`${before.options[i]} → `] : []))
      count.append(element("b", {}, String(now.options[i])))
      row.classList.toggle("right-vote", Boolean(lesson?.verdicts[i]?.right))
      const bar = element("span", {class: "vote-bar"}, ...parts)
      row.append(element("span", {class: before ? "vote-row twice" : "vote-row"}, bar, count))
    }
  }

  headline() {
    return "" // the bars show the result
  }

  leave() {
    for (const row of this.rows) row.querySelector(".vote-row")?.remove()
  }
}

/** The right option needs no reply. @param {number} n */
const optionRow = n =>
  element(
    "div",
    {class: "ask-option"},
    element("input", {
      type: "radio",
      name: "right",
      value: n,
      checked: n === 1 ? "" : undefined,
      "aria-label": `Answer ${n} is right`,
    }),
    element("input", {name: `text-${n}`, placeholder: `Answer ${n}`, "aria-label": `Answer ${n}`, autocomplete: "off"}),
    element("input", {
      name: `reply-${n}`,
      placeholder: "Reply to those who choose it",
      "aria-label": `Reply to those who choose answer ${n}`,
    }),
  )

/** @param {HTMLFormElement} form @param {number} n */
function optionOf(form, n) {
  const right = text(form, "right") === String(n)
  const [words, reply] = [text(form, `text-${n}`), text(form, `reply-${n}`)]
  if (!words) return []
  return [{text: words, ...(right ? {right} : {reply})}]
}

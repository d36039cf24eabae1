// The contents of all walks on the paper: an answered step shows its claim, a later one its question.

import {button, chip, element, marked} from "../core/dom.js"
import {mark} from "../questions/question.js"
import {save} from "../export/save.js"
import {STEPS} from "./steps.js"

export class Contents {
  /** @type {page.WalkSheet[]} */
  sheets = []

  /** @param {import("./walk.js").Walk} walk */
  constructor(walk) {
    this.walk = walk
    this.element = element("dialog", {class: "contents", "aria-label": "Steps of this lecture"})
    document.body.append(this.element)
    this.element.addEventListener("click", event => {
      if (event.target === this.element) this.close()
    })
    // Page Up closes the dialog if it is scrolled to the top; Page Down closes it at the end, except after the last
    // step.
    this.element.addEventListener("keydown", ({key}) => {
      const {scrollTop, scrollHeight, clientHeight} = this.element
      const isAtFoot = scrollTop + clientHeight > scrollHeight - 1
      if (key === "PageUp" ? scrollTop < 1 : key === "PageDown" && isAtFoot && !this.isOver) this.close()
    })
  }

  isOver = false

  /** @param {boolean} isOver */
  async open(isOver) {
    const {walks} = this.walk
    this.isOver = isOver
    const names = [...walks.own.keys(), ...walks.menu.names] // walks from the visitor's files first
    this.sheets = await Promise.all(names.map(name => walks.sheet(name)))
    this.#fill()
    if (!this.element.open) this.element.showModal()
  }

  close() {
    this.element.close()
  }

  leave() {
    this.element.remove()
  }

  #fill() {
    const {sheets} = this
    const close = chip("Close", () => this.close())
    const head = element("header", {}, element("h1", {}, "Steps of this lecture"), ...this.#apart(), close)
    const columns = element("div", {class: "columns"}, ...sheets.map(sheet => this.#column(sheet)))
    const tools = [chip("Save as text", () => this.#export(sheets)), chip("Delete my answers", () => this.#clear())]
    this.element.replaceChildren(
      head,
      ...this.#end(),
      ...this.#core(),
      columns,
      element("div", {class: "tools"}, ...tools),
    )
  }

  /** A button that opens the contents in another window, because the hall must not see later questions. */
  #apart() {
    const {sheet, walks, lecture} = this.walk
    if (!lecture.hall.on) return []
    // The other window gets walks from files later.
    const name = walks.own.has(sheet.name) ? walks.menu.names[0] : sheet.name
    return [chip("Questions in a separate window", () => open(`./?walk=${name}${STEPS}`, "_blank", "noopener"))]
  }

  /** After the last step: the walk in a few sentences. */
  #end() {
    const {end} = this.walk.sheet
    if (!this.isOver || !end.length) return []
    return [element("ol", {class: "end"}, ...end.map(html => marked("li", {}, html)))]
  }

  /** The switch to the shorter walk, if this walk has one. */
  #core() {
    const {walk} = this
    const core = walk.sheet.steps.filter(step => step.core)
    if (!core.length) return []
    const words = `Core steps only: ${core.length}, ${minutes(core)}`
    const choose = () => {
      walk.shorten(!walk.isShort)
      this.#fill()
    }
    return [chip(words, choose, {"aria-pressed": String(walk.isShort)})]
  }

  /** @param {page.WalkSheet} sheet */
  #column(sheet) {
    const rows = sheet.steps.map((step, i) => this.#row(sheet, step, i))
    const title = element("h2", {}, `${sheet.title}, ${minutes(sheet.steps)}`)
    return element("section", {}, title, element("ol", {}, ...rows))
  }

  /** @param {page.WalkSheet} sheet @param {page.StepCard} step @param {number} i */
  #row(sheet, step, i) {
    const kept = this.walk.answers.of(step.id)
    const where = [step.place, step.scene].filter(Boolean).join(", ")
    const said = kept ? `${where}, your answer: ${kept.said}` : `${where}, ${minutes([step])}`
    const {given, question} = this.walk.numbered(step)
    const words = kept ? kept.title : this.walk.lecture.hall.on ? "" : `${given} ${question}`.trim()
    const claim = marked("span", {class: "claim"}, words) // the hall must not see later questions
    const number = element("span", {class: "number-of-step"}, String(i + 1))
    const parts = [number, claim, element("span", {class: "said"}, said), ...(kept ? [mark(kept.right)] : [])]
    const row = button({}, () => this.walk.walks.choose(sheet.name, i), ...parts)
    const isHere = sheet === this.walk.sheet && i === this.walk.place
    if (sheet === this.walk.sheet && !this.walk.steps.includes(step)) row.classList.add("left-out")
    if (isHere) row.setAttribute("aria-current", "step")
    return element("li", {}, row)
  }

  #clear() {
    this.walk.answers.clear()
    this.#fill()
  }

  /** @param {page.WalkSheet[]} sheets */
  #export(sheets) {
    save("answers.txt", this.walk.answers.text(sheets), "text/plain")
  }
}

/** @param {page.StepCard[]} steps */
function minutes(steps) {
  const sum = steps.reduce((all, step) => all + step.minutes, 0)
  return `${sum} ${sum === 1 ? "minute" : "minutes"}`
}

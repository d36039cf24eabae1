// The contents of all walks on the paper: a step that was answered stands as its claim, one to come as its question.

import {button, chip, element, marked} from "../core/dom.js"
import {mark} from "../questions/question.js"
import {save} from "../export/save.js"

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
    // What a clicker went on to by one key it comes back from by the other.
    this.element.addEventListener("keydown", event => {
      if (event.key === "PageUp" && this.element.scrollTop === 0) this.close()
    })
  }

  async open() {
    const {walks} = this.walk
    this.sheets = await Promise.all(walks.names.map(name => walks.sheet(name)))
    this.#fill()
    if (!this.element.open) this.element.showModal()
  }

  close() {
    this.element.close()
  }

  #fill() {
    const {sheets} = this
    const close = chip("Close", () => this.close())
    const head = element("header", {}, element("h1", {}, "Steps of this lecture"), close)
    const hint = element("p", {class: "hint"}, "The number before a step is its slide, or its page of the notes.")
    const columns = element("div", {class: "columns"}, ...sheets.map(sheet => this.#column(sheet)))
    const tools = [chip("Save as text", () => this.#export(sheets)), chip("Delete my answers", () => this.#clear())]
    this.element.replaceChildren(head, hint, columns, element("div", {class: "tools"}, ...tools))
  }

  /** @param {page.WalkSheet} sheet */
  #column(sheet) {
    const rows = sheet.steps.map((step, i) => this.#row(sheet, step, i))
    return element("section", {}, element("h2", {}, sheet.title), element("ol", {}, ...rows))
  }

  /** @param {page.WalkSheet} sheet @param {page.StepCard} step @param {number} i */
  #row(sheet, step, i) {
    const kept = this.walk.answers.of(step.id)
    const said = kept ? `${step.scene}, your answer: ${kept.said}` : `${step.scene}, ${step.minutes} minutes`
    const claim = marked("span", {class: "claim"}, kept ? kept.title : step.question)
    const slide = element("span", {class: "slide"}, step.place.replace(/^\S+ slide |^\S+ notes /, ""))
    const parts = [slide, claim, element("span", {class: "said"}, said), ...(kept ? [mark(kept.right)] : [])]
    const go = () => {
      this.close()
      this.walk.walks.enter(sheet.name, i)
    }
    const row = button({}, go, ...parts)
    const isHere = sheet === this.walk.sheet && i === this.walk.place
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

// The editor of questions: a question on the current picture becomes a step of a walk, and several steps a file. The
// session checks each one like any file of a walk.

import {chip, element} from "../core/dom.js"
import {Draft, shownBy} from "./draft.js"
import {parts, sentences} from "../compare/coverable.js"
import {box, chooser, labelled, text} from "../questions/fields.js"
import {KINDS} from "../questions/kinds.js"
import {save} from "../export/save.js"

const NAME = "asked"

/** @typedef {import("../questions/question.js").Fields} Fields */

/** @param {LectureHost["walks"]} walks */
export const openEditor = walks => new Editor(walks).open()

class Editor {
  /** @type {string[]} parts that are covered already and have no check box here */
  covered = []

  draft = new Draft()

  /** @param {LectureHost["walks"]} walks */
  constructor(walks) {
    this.walks = walks
    this.page = walks.lecture.page
    this.plots = this.page.plots.filter(plot => !plot.absent && plot.host.offsetParent !== null)
    this.kind = chooser(
      "Kind of answer",
      "kind",
      Object.entries(KINDS).map(([value, {label}]) => ({value, label})),
    )
    this.kind.addEventListener("change", () => this.#fields())
    this.answers = element("div", {class: "ask-answers"})
    this.problem = element("p", {class: "problem", role: "alert"})
    this.list = element("ol", {})
    const title = labelled("Title of the walk", "walk", this.draft.title)
    const add = element("button", {class: "act filled"}, "Add this question")
    this.form = element("form", {class: "ask-form"}, ...this.#parts(), this.problem, add)
    this.form.addEventListener("submit", event => this.#add(event))
    title.addEventListener("input", () => {
      this.draft.title = field(title).value || "My walk"
      this.draft.keep()
      this.#show()
    })
    this.tools = element("div", {class: "tools"}, ...this.#tools())
    this.element = element("dialog", {class: "asking", "aria-label": "Write a question"})
    this.element.append(element("h1", {}, "Write a question on this picture"), this.form, title, this.list, this.tools)
    this.element.addEventListener("close", () => this.element.remove())
    document.body.append(this.element)
  }

  open() {
    this.#fields()
    this.#show()
    this.element.showModal()
  }

  #parts() {
    const covers = [...parts(this.page), ...sentences(this.page)]
    const {covered} = this.page.shown.state
    const boxes = covers.map(part => box("cover", part.cover, part.text, covered.includes(part.cover)))
    this.covered = covered.filter(name => !covers.some(({cover}) => cover === name))
    return [
      labelled("Question, ending with ? or beginning with Sketch or Mark", "question", "", true),
      this.kind,
      this.answers,
      element("fieldset", {}, element("legend", {}, "Covered until the answer is shown"), ...boxes),
      labelled("Title of the answer", "title", "", true),
      labelled("Explanation", "explain", "", true),
      labelled("Notes for yourself, which only the remote control shows", "notes"),
    ]
  }

  #tools() {
    const entries = /** @type {[string, string, () => void][]} */ ([
      ["Save the walk as a file", "of-steps", () => save("my-walk.toml", this.draft.file(), "application/toml")],
      ["Try it", "of-steps", () => this.#try()],
      ["Remove all questions", "of-steps", () => this.#remove()],
      ["Close", "", () => this.element.close()],
    ])
    return entries.map(([name, style, act]) => chip(name, act, {class: `chip ${style}`.trim()}))
  }

  #fields() {
    this.answers.replaceChildren(...KINDS[field(this.kind).value].fields(this.plots))
  }

  /** Shows the list of the steps. */
  #show() {
    this.list.replaceChildren(...this.draft.steps.map((step, i) => this.#row(step, i)))
    for (const tool of this.tools.querySelectorAll(".of-steps"))
      tool.toggleAttribute("disabled", !this.draft.steps.length)
  }

  /** @param {Fields} step @param {number} i */
  #row(step, i) {
    const remove = chip("Remove", () => this.#remove(i))
    return element("li", {}, element("span", {}, String(step.question)), remove)
  }

  /** @param {number} [i] the index of one step; all if it is missing */
  #remove(i) {
    if (i === undefined) this.draft.steps = []
    else this.draft.steps.splice(i, 1)
    this.draft.keep()
    this.#show()
  }

  /** @param {Event} event */
  async #add(event) {
    event.preventDefault()
    const step = this.#read()
    const refused = await this.walks.check(NAME, this.draft.file([step]))
    this.problem.textContent = refused.replaceAll(`${NAME}, step 1 (${step.id}), `, "")
    if (refused) return
    this.draft.steps.push(step)
    this.draft.keep()
    this.form.reset()
    this.#fields()
    this.#show()
  }

  /** @returns {Fields} */
  #read() {
    const {form} = this
    const boxes = [...form.querySelectorAll("input[name=cover]:checked")].map(one => one.getAttribute("value") ?? "")
    const [kind, notes] = [text(form, "kind"), text(form, "notes")]
    const {cover = [], ...asks} = KINDS[kind].read(form, this.plots)
    return {
      id: this.draft.nextId,
      kind,
      title: text(form, "title"),
      state: shownBy(this.page.shown.query),
      cover: [...new Set([...this.covered, ...boxes, ...cover])],
      question: text(form, "question"),
      ...asks,
      explain: text(form, "explain"),
      ...(notes ? {notes} : {}),
    }
  }

  async #try() {
    const refused = await this.walks.run(NAME, this.draft.file())
    this.problem.textContent = refused
    if (!refused) this.element.close()
  }
}

/** @param {HTMLElement} label */
const field = label => /** @type {HTMLInputElement} */ (label.querySelector("input, select"))

// Ask: a question about what is shown becomes a step of a walk, and several steps a file to keep. Each is checked by
// the session as any walk's file is, so that what is made here runs.

import {element} from "../dom.js"
import {Asked} from "./asked.js"
import {parts, sentences} from "./coverable.js"
import {features} from "./features.js"
import {save} from "../save.js"

const NAME = "asked"

/**
 * What a kind of question asks the instructor for.
 * @typedef {import("./asked.js").Fields} Fields
 * @type {Record<string, {label: string, fields: (ask: Ask) => HTMLElement[], read: (ask: Ask) => Fields}>}
 */
const KINDS = {
  choice: {
    label: "Choice",
    fields: () => [1, 2, 3, 4].map(optionRow),
    read: ({form}) => ({options: [1, 2, 3, 4].flatMap(n => optionOf(form, n))}),
  },
  number: {
    label: "Number",
    fields: () => [labelled("Right answer", "is"), labelled("Unit", "unit"), labelled("Tolerance (±)", "tol")],
    read: ({form}) => ({answer: answerIn(form, text(form, "unit"))}),
  },
  point: {
    label: "Point on an axis",
    fields: ({plots}) => [
      chooser("Axis", "axis", plots.flatMap(axesOf)),
      labelled("Right place", "is"),
      labelled("Tolerance (±)", "tol"),
    ],
    read: ({form, plots}) => {
      const [name, which] = text(form, "axis").split(".")
      const {x, y} = plotOf(plots, name)
      const {unit} = which === "x" ? x : y
      return {axis: `${name}.${which}`, answer: answerIn(form, unit)}
    },
  },
  sketch: {
    label: "Sketch",
    fields: ({plots}) => [chooser("Curve", "curve", plots.flatMap(curvesOf))],
    read: ({form, plots}) => {
      const [name, y] = text(form, "curve").split(".")
      const plot = plotOf(plots, name)
      const curve = /** @type {page.Curve} */ (plot.block.curves.find(one => one.y === y))
      return {plot: name, curve: y, must: features(plot, curve)}
    },
  },
}

/** @typedef {import("../plots.js").Plot} Plot */

/** @param {Plot[]} plots @param {string} name */
const plotOf = (plots, name) => /** @type {Plot} */ (plots.find(({block}) => block.name === name))

/** @param {import("../walks.js").Walks} walks */
export const ask = walks => new Ask(walks).open()

class Ask {
  /** @type {string[]} what is covered already and is not offered here */
  covered = []

  asked = new Asked()

  /** @param {import("../walks.js").Walks} walks */
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
    const title = labelled("Title of the walk", "walk", this.asked.title)
    const add = element("button", {class: "act filled"}, "Add this question")
    this.form = element("form", {class: "ask-form"}, ...this.#parts(), this.problem, add)
    this.form.addEventListener("submit", event => this.#add(event))
    title.addEventListener("input", () => {
      this.asked.title = field(title).value || "My walk"
      this.asked.keep()
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
    const boxes = covers.map(({cover, text}) => box("cover", cover, text, covered.includes(cover)))
    this.covered = covered.filter(name => !covers.some(({cover}) => cover === name)) // they have no box, and stay
    return [
      labelled("Question, ending with ? or beginning with Sketch or Mark", "question", "", true),
      this.kind,
      this.answers,
      element("fieldset", {}, element("legend", {}, "Covered until the answer is shown"), ...boxes),
      labelled("Title of the answer", "title", "", true),
      labelled("Explanation", "explain", "", true),
    ]
  }

  #tools() {
    const entries = /** @type {[string, string, () => void][]} */ ([
      ["Save the walk as a file", "of-steps", () => save("my-walk.toml", this.asked.file(), "application/toml")],
      ["Try it", "of-steps", () => this.#try()],
      ["Remove all questions", "of-steps", () => this.#remove()],
      ["Close", "", () => this.element.close()],
    ])
    return entries.map(([name, style, act]) => {
      const button = element("button", {type: "button", class: `chip ${style}`.trim()}, name)
      button.addEventListener("click", act)
      return button
    })
  }

  #fields() {
    this.answers.replaceChildren(...KINDS[field(this.kind).value].fields(this))
  }

  /** The steps that there are. */
  #show() {
    this.list.replaceChildren(...this.asked.steps.map((step, i) => this.#row(step, i)))
    for (const tool of this.tools.querySelectorAll(".of-steps"))
      tool.toggleAttribute("disabled", !this.asked.steps.length)
  }

  /** @param {Fields} step @param {number} i */
  #row(step, i) {
    const remove = element("button", {type: "button", class: "chip"}, "Remove")
    remove.addEventListener("click", () => this.#remove(i))
    return element("li", {}, element("span", {}, String(step.question)), remove)
  }

  /** @param {number} [i] one of them, or all */
  #remove(i) {
    if (i === undefined) this.asked.steps = []
    else this.asked.steps.splice(i, 1)
    this.asked.keep()
    this.#show()
  }

  /** @param {Event} event */
  async #add(event) {
    event.preventDefault()
    const step = this.#read()
    const refused = await this.walks.check(NAME, this.asked.file([step]))
    this.problem.textContent = refused.replaceAll(`${NAME}, step 1 (${step.id}), `, "")
    if (refused) return
    this.asked.steps.push(step)
    this.asked.keep()
    this.form.reset()
    this.#fields()
    this.#show()
  }

  /** @returns {Fields} */
  #read() {
    const {form} = this
    const boxes = [...form.querySelectorAll("input[name=cover]:checked")].map(one => one.getAttribute("value") ?? "")
    const query = this.page.shown.query.split("&").filter(part => !part.startsWith("cover="))
    const kind = text(form, "kind")
    const asks = KINDS[kind].read(this)
    const drawn = kind === "sketch" ? [`plot:${asks.plot}`] : [] // it would be traced
    return {
      id: this.asked.nextId,
      kind,
      title: text(form, "title"),
      state: `?${query.join("&")}`,
      cover: [...new Set([...this.covered, ...boxes, ...drawn])],
      question: text(form, "question"),
      ...asks,
      explain: text(form, "explain"),
    }
  }

  async #try() {
    const refused = await this.walks.run(NAME, this.asked.file())
    this.problem.textContent = refused
    if (!refused) this.element.close()
  }
}

/** @param {string} label @param {string} name @param {string} [value] @param {boolean} [required] */
function labelled(label, name, value = "", required = false) {
  const input = element("input", {name, value, autocomplete: "off", required: required ? "" : undefined})
  return element("label", {class: `ask-${name}`}, element("span", {}, label), input)
}

/** @param {string} label @param {string} name @param {{value: string, label: string}[]} options */
function chooser(label, name, options) {
  const select = element("select", {name}, ...options.map(one => element("option", {value: one.value}, one.label)))
  return element("label", {}, element("span", {}, label), select)
}

/** @param {string} name @param {string} value @param {string} label @param {boolean} isSet */
const box = (name, value, label, isSet) => {
  const input = element("input", {type: "checkbox", name, value, checked: isSet ? "" : undefined})
  return element("label", {class: "ask-box"}, input, ` ${label}`)
}

/** The right one needs no reply. @param {number} n */
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

/** @param {Plot} plot */
const axesOf = ({block}) =>
  ["x", "y"].map(which => ({
    value: `${block.name}.${which}`,
    label: `${block.brief}, ${which === "x" ? "horizontal" : "vertical"}`,
  }))

/** @param {Plot} plot */
const curvesOf = ({block, view}) =>
  block.curves
    .filter(curve => view.columns[curve.source]?.[curve.y]?.length)
    .map(({y, read}) => ({value: `${block.name}.${y}`, label: `${block.brief}: ${read || y}`}))

/** @param {HTMLElement} label */
const field = label => /** @type {HTMLInputElement} */ (label.querySelector("input, select"))

/** @param {HTMLFormElement} form @param {string} name */
const text = (form, name) => String(new FormData(form).get(name) ?? "").trim()

/**
 * Its numbers as they are typed: the session reads them as it reads a field.
 * @param {HTMLFormElement} form @param {string} unit
 */
const answerIn = (form, unit) => ({is: text(form, "is"), unit, tol: text(form, "tol")})

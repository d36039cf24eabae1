// The number question: a field to type in; a class's answers are dots on a separate line.

import {button, element} from "../core/dom.js"
import {withUnit} from "../core/numbers.js"
import {Dots} from "./dots.js"
import {answerFields, answerIn, labelled, text} from "./fields.js"
import {Question, mark} from "./question.js"

const LONGEST = 60 // characters: components/language/messages.py

export class Numeric extends Question {
  static label = "Number"

  static fields() {
    return [...answerFields("Right answer"), labelled("Unit", "unit"), labelled("Tolerance (±)", "tol")]
  }

  /** @param {HTMLFormElement} form */
  static read(form) {
    return {answer: answerIn(form, text(form, "unit"))}
  }

  field = this.#field()
  yours = element("span", {class: "yours"})
  element = element(
    "div",
    {class: "question"},
    element("label", {class: "number"}, this.field, element("span", {}, this.step.unit), this.yours),
    button({class: "chip sign", "aria-label": "Change the sign"}, () => this.#turn(), "±"),
  )

  /** The number keyboard of a phone may have no minus sign. */
  #turn() {
    const {value} = this.field
    if (this.field.readOnly) return
    this.field.value = /^\s*[-−]/.test(value) ? value.replace(/^\s*[-−]/, "") : `−${value.trim()}`
    this.field.focus()
    this.changed()
  }

  #field() {
    const field = element("input", {
      name: "answer",
      autocomplete: "off",
      inputmode: "decimal",
      maxlength: LONGEST,
      "aria-label": "Your answer",
    })
    field.addEventListener("input", () => this.changed())
    field.addEventListener("keydown", event => {
      if (event.key === "Enter") this.walk.show(false)
    })
    return field
  }

  said() {
    const typed = this.field.value.trim()
    return /^[-−+]?[\d.,]+$/.test(typed) ? withUnit(typed, this.step.unit) : typed
  }

  given() {
    return this.field.value.trim() ? {text: this.field.value} : null
  }

  /** @param {import("./question.js").Answer} given */
  restore(given) {
    this.field.value = given.text ?? ""
  }

  /** @param {page.Lesson} lesson */
  teach({right}) {
    this.field.readOnly = true
    this.element.hidden = right === null // the visitor gave no answer
    this.yours.textContent = right === null ? "" : "your answer"
    if (right !== null) this.yours.after(mark(right))
  }

  tally() {
    return new Dots(this)
  }

  space() {
    return element("p", {class: "to-fill"}, this.step.unit)
  }
}

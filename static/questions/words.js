// The question that is answered in a few words. The hall sees only the answers that the instructor shows.

import {element} from "../core/dom.js"
import {Question} from "./question.js"
import {grouped} from "./word_groups.js"

const LONGEST = 80 // characters: components/language/messages.py

export class Words extends Question {
  static label = "Words"

  static fields() {
    return []
  }

  static read() {
    return {}
  }

  field = this.#field()
  element = element("div", {class: "question"}, element("label", {class: "words"}, this.field))

  #field() {
    const about = {name: "answer", autocomplete: "off", maxlength: LONGEST, "aria-label": "Your answer in a few words"}
    const field = element("input", about)
    field.addEventListener("input", () => this.changed())
    field.addEventListener("keydown", event => {
      if (event.key === "Enter") this.walk.show(false)
    })
    return field
  }

  said() {
    return this.field.value.trim()
  }

  given() {
    return this.said() ? {text: this.field.value} : null
  }

  /** @param {import("./question.js").Answer} given */
  restore(given) {
    this.field.value = given.text ?? ""
  }

  teach() {
    this.field.readOnly = true
  }

  tally() {
    return new Shown(this)
  }

  space() {
    return element("p", {class: "to-fill"})
  }
}

/** In hall mode the shown answers, else all answers, each with a button to show or remove it. */
class Shown {
  /** @param {Words} question */
  constructor({page, element: field}) {
    this.page = page
    this.list = element("ul", {class: "words-shown"})
    this.waiting = element("p", {class: "hint"})
    field.after(this.list, this.waiting)
  }

  /** @param {page.Tally} tally @param {unknown} _lesson @param {import("./word_groups.js").Moderate} [moderate] */
  update({now}, _lesson, moderate) {
    const {hall} = this.page.host
    const words = hall.on ? now.words.filter(({shown}) => shown) : now.words
    this.list.replaceChildren(...words.map(group => grouped(group, hall.on ? undefined : moderate)))
    const waits = now.words.filter(({shown}) => !shown).length
    const where = hall.on ? " for “Show” on the remote control" : ""
    this.waiting.textContent = waits ? `${waits} ${waits === 1 ? "answer waits" : "answers wait"}${where}` : ""
  }

  headline() {
    return "" // the words show the result
  }

  leave() {
    this.list.remove()
    this.waiting.remove()
  }
}

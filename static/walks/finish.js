// The end of a walk with scenes to try: which answers were right, and these scenes in motion.

import {button, chip, element, marked} from "../core/dom.js"
import {play} from "../core/moving.js"
import {mark} from "../questions/question.js"

export class Finish {
  /** @param {import("./walk.js").Walk} walk */
  constructor(walk) {
    this.walk = walk
    this.element = element("dialog", {class: "finish", "aria-labelledby": "finish-title"})
    document.body.append(this.element)
    this.element.addEventListener("keydown", ({key}) => key === "PageUp" && this.element.close())
  }

  open() {
    const {end, trials} = this.walk.sheet
    const cards = trials.map(card)
    const sentences = [this.#score(), ...end].filter(Boolean)
    const close = () => this.element.close()
    this.element.replaceChildren(
      button({class: "close", "aria-label": "Close"}, close, "×"),
      element("h1", {id: "finish-title"}, "Done"),
      marked("p", {}, sentences.join(" ")),
      this.#results(),
      element("h2", {}, "Now with your own hands"),
      ...cards,
      element(
        "div",
        {class: "chips"},
        element("a", {class: "chip", href: "./"}, "All scenes"),
        chip("Back to the questions", close),
      ),
    )
    if (!this.element.open) this.element.showModal()
    this.element.scrollTop = 0
    this.#draw(cards)
  }

  #score() {
    const {steps} = this.walk.sheet
    const answered = steps.map(step => this.walk.answers.of(step.id)).filter(Boolean)
    const right = answered.filter(answer => answer?.right).length
    return answered.length ? `${right} of your ${answered.length} answers ${right === 1 ? "was" : "were"} right.` : ""
  }

  /** Each step with its result: its claim, or its question if it was skipped. */
  #results() {
    const rows = this.walk.sheet.steps.map(step => {
      const kept = this.walk.answers.of(step.id)
      const words = marked("span", {}, kept ? kept.title : this.walk.numbered(step).question)
      if (!kept) return element("li", {}, words, element("b", {}, "skipped"))
      const sign = mark(kept.right)
      sign.setAttribute("aria-hidden", "true")
      return element("li", {}, words, element("b", {}, kept.right ? "you were right" : "you were wrong", sign))
    })
    return element("ol", {class: "results"}, ...rows)
  }

  /** Takes the pictures from the start page. @param {HTMLElement[]} cards */
  async #draw(cards) {
    const text = await fetch("./").then(answer => answer.text())
    const start = new DOMParser().parseFromString(text, "text/html")
    const pictures = cards.flatMap(one => {
      const picture = start.querySelector(`[href="${one.getAttribute("href")}"] svg`)
      if (!(picture instanceof SVGSVGElement)) return []
      one.prepend(picture)
      return [picture]
    })
    play(pictures)
  }

  leave() {
    this.element.remove()
  }
}

/** @param {page.WalkTrial} trial */
const card = ({scene, title, text}) =>
  element(
    "a",
    {class: "scene-card", href: `?scene=${scene}`},
    marked("span", {class: "name"}, title),
    marked("span", {class: "claim"}, text),
  )

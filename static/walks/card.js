// The card of a step, which replaces the panel: a text, the question, the answer, the explanation, links to try.

import {button, chip, element, marked} from "../core/dom.js"
import {KINDS} from "../questions/kinds.js"
import {SUCH, mark} from "../questions/question.js"
import {claim, showQuestion} from "./headline.js"

export const ANSWER_FIRST = "Answer first: a guess is fine"
const CHOOSE = "Choose an answer" // on the filled button of a tour that waits for one
export const FOLLOWS = "How it follows"
const CHOSEN = ".seg, .tiles, .window" // controls other than sliders
const HELD = ".transport, .paper .handles, .block .seg, .paper .grips" // parts that are disabled before the answer
const GRABBED = ".grip, .handles [data-grab]" // parts that can be dragged

export class Card {
  /** @type {{part: Element, place: Comment}[]} controls that are now on the card, and their old places */
  borrowed = []

  /** @type {HTMLDetailsElement | null} the formulas of the step, once it has been answered */
  fold = null

  /**
   * @param {WalkHost} walk
   * @param {PartHost} page
   */
  constructor(walk, page) {
    this.walk = walk
    this.page = page
    this.seed = walk.seed
    const {step} = walk
    this.question = new KINDS[step.kind](step, walk, page)
    this.refusal = element("p", {class: "problem", role: "alert"})
    this.after = element("div", {class: "after"})
    this.back = button({class: "act", "data-key": "PageUp"}, () => walk.back(), "Back")
    this.back.disabled = walk.place === 0
    this.forward = button({class: "act filled"}, () => walk.forward())
    this.skip = button({class: "act"}, () => walk.next(), "Skip")
    const asks = marked("h2", {class: "asks", tabindex: -1}, step.question)
    const parts = [...given(step), asks, this.question.element, this.after]
    this.body = element("div", {class: "card-body"}, ...parts)
    this.element = element("section", {class: "card", "aria-label": "The walk"}, this.body)
    const foot = element("div", {class: "foot"}, this.refusal, this.back, this.skip, this.forward)
    this.element.append(foot) // last, so that it stays visible
    ;(walk.isTour ? foot : this.body).prepend(this.#head())
    this.question.changed = () => this.ready()
    page.panel.prepend(this.element)
    page.root.classList.add("walked")
    page.root.classList.toggle("tour", walk.isTour)
    // On a phone the card is between the plots, so drawings over the plots must follow changes of its height.
    this.observer = new ResizeObserver(() => page.redraw())
    this.observer.observe(this.element)
    this.line = element("p", {class: "asked-line"}, ...asked(step))
    page.heading[walk.isTour ? "before" : "after"](this.line)
    this.judgement = element("p", {class: "judgement", role: "status"})
    page.heading.before(this.judgement)
    this.#ask()
    const heard = asks.checkVisibility() ? asks : page.heading
    scrollTo(0, 0)
    heard.focus({preventScroll: true})
    this.question.plot?.host.scrollIntoView({block: "nearest"}) // after everything has its final position
  }

  #head() {
    const {sheet, place, where} = this.walk
    const contents = button({class: "plain"}, () => this.walk.open(), "Contents")
    const dashes = sheet.steps.map((other, i) =>
      element("i", {class: i === place ? "here" : this.walk.answers.of(other.id) ? "done" : ""}),
    )
    const ruler = element("div", {class: "ruler", "aria-hidden": "true"}, ...dashes)
    return element("div", {class: "card-head"}, element("span", {}, where), contents, ruler)
  }

  #ask() {
    const {page} = this
    const {question, opens} = this.walk.step
    page.root.classList.add("asked")
    showQuestion(page, question)
    for (const {name, holder} of page.sheet.items)
      holder.classList.toggle("at-issue", opens.covered.includes(`form:${name}`))
    for (const part of page.root.querySelectorAll(HELD)) part.setAttribute("inert", "")
    this.ready()
  }

  /** Labels the filled button with what the next press does. */
  ready() {
    const {words, needsAnswer} = this.walk.press
    this.skip.hidden = !needsAnswer
    const isReady = !needsAnswer || this.question.given() !== null
    this.forward.textContent = isReady || !this.walk.isTour ? words : CHOOSE
    this.forward.classList.toggle("waiting", !isReady)
    this.forward.title = isReady ? "" : ANSWER_FIRST
    this.refusal.textContent = ""
  }

  /** @param {string} why */
  refuse(why) {
    this.refusal.textContent = why
  }

  /** Puts the lesson of the step under the question. @param {page.Lesson} lesson */
  teach(lesson) {
    const {page} = this
    this.#release()
    this.#confine()
    claim(page, lesson.title)
    this.#judge(lesson.right)
    this.question.teach(lesson)
    this.after.replaceChildren(...this.#meaning(lesson))
    if (this.walk.isTour) this.after.after(this.question.element)
    page.live.find(this.after)
    page.redraw()
    ;(lesson.right === null ? page.heading : this.judgement).scrollIntoView({block: "nearest"})
    this.ready()
  }

  /** Shows above the headline if the answer is right, because on a phone the answers are below. @param {boolean | null}
   * right */
  #judge(right) {
    if (right === null) return
    const sign = mark(right)
    sign.setAttribute("aria-hidden", "true")
    this.judgement.replaceChildren(sign, ` Your answer is ${right ? "right" : "wrong"}.`)
  }

  /** Opens the formulas of the step, or closes them. */
  derive() {
    if (this.fold) this.fold.open = !this.fold.open
  }

  /** @param {page.Lesson} lesson */
  #meaning({reply, where, truth, explain, follows, next}) {
    const answered = [truth ? `It is ${truth}.` : ""].filter(Boolean).map(text => element("p", {class: "truth"}, text))
    const sentence = reply ? [marked("p", {class: "reply"}, reply)] : []
    if (where)
      sentence[0].append(
        " ",
        chip(SUCH, () => this.page.host.open(where)),
      )
    return [
      ...answered,
      ...sentence,
      marked("p", {class: "why"}, explain),
      ...this.#derivation(follows),
      ...this.#try(next),
    ]
  }

  /**
   * The equations of the slide: closed at first, later open or closed as the visitor left them. If there is room, they
   * open over the page. In hall mode they stay closed, so that the plots are visible.
   * @param {page.Html[]} follows
   */
  #derivation(follows) {
    const {walk, page} = this
    if (!follows.length) return []
    const lines = follows.map(html => marked("div", {class: "line"}, html))
    const sheet = element("div", {class: "lines", tabindex: 0, role: "group", "aria-label": FOLLOWS}, ...lines)
    const fold = element("details", {class: "fold follows"}, element("summary", {}, FOLLOWS), sheet)
    fold.open = walk.unfolded && !page.host.hall.on
    fold.addEventListener("toggle", () => {
      walk.unfolded = fold.open
      this.ready()
    })
    this.fold = fold
    return [fold]
  }

  /** @param {page.Html} next */
  #try(next) {
    const again = chip(this.question.again, () => this.walk.again())
    const words = next ? [marked("p", {class: "try"}, `<b>Try:</b> ${next}`)] : []
    const parts = element(
      "div",
      {class: "tries"},
      ...words,
      element("div", {class: "borrowed"}, ...this.#borrow()),
      again,
    )
    return [this.#opener(), parts]
  }

  /** A button for hall mode: there the links to try do not fit next to the explanation, so they replace the options. */
  #opener() {
    const toggle = () => opener.setAttribute("aria-expanded", String(this.element.classList.toggle("trying")))
    const opener = button({class: "chip opens-tries", "aria-expanded": "false"}, toggle, "Try")
    return opener
  }

  /** Moves the controls that the step names to the card for the time of the step. */
  #borrow() {
    const {controls, root, spec} = this.page
    const parts = this.walk.step.controls.map(
      name => controls.sliders.get(name)?.element ?? root.querySelector(`:is(${CHOSEN})[data-name="${name}"]`),
    )
    return parts.flatMap(part => {
      if (!part || !spec) return []
      const place = document.createComment("on the card")
      part.replaceWith(place)
      this.borrowed.push({part, place})
      return [part]
    })
  }

  /** @param {Drawn} shown */
  update(shown) {
    this.question.update(shown)
  }

  #release() {
    const {page} = this
    page.root.classList.remove("asked")
    for (const part of page.root.querySelectorAll(`${HELD}, ${GRABBED}`)) part.removeAttribute("inert")
  }

  /** After the answer, lets visitors drag only the parts that set a parameter in `controls` of the step. */
  #confine() {
    const names = new Set(this.walk.step.controls)
    for (const part of this.page.root.querySelectorAll(GRABBED)) {
      const sets = part.getAttribute("data-grab")?.split(" ") ?? []
      part.toggleAttribute("inert", !sets.some(name => names.has(name)))
    }
  }

  leave() {
    for (const {part, place} of this.borrowed) place.replaceWith(part)
    this.#release()
    this.question.leave()
    this.observer.disconnect()
    this.element.remove()
    this.line.remove()
    this.judgement.remove()
    this.page.root.classList.remove("walked", "tour")
    claim(this.page)
  }
}

/** Below the headline: the given text and, when the headline is the claim, the question. @param {page.StepCard} step */
const asked = step => [
  ...(step.given ? [marked("span", {}, `${step.given} `)] : []),
  marked("span", {class: "asks-again"}, step.question),
]

/** @param {page.StepCard} step */
const given = step => (step.given ? [marked("p", {class: "given"}, step.given)] : [])

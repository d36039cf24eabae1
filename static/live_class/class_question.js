// The question of a class on a phone: answered by a touch, changed until the answer is shown.

import {element} from "../core/dom.js"
import {Card} from "../walks/card.js"
import {answer, mine} from "./attendance.js"
import {Refusal, ask, pause} from "./requests.js"

const SENT = "Sent. You can change it until the answer is shown."
const VOTED = "Sent. You can change it until the vote is closed."
const MOMENT = 400 // ms without a change until an answer is sent
const SPREAD = 1500 // ms over which all phones ask what is said of their answers

export class ClassQuestion {
  /** @type {page.PutTo | null} */
  question = null

  /** @type {Card | null} */
  card = null

  /** @type {page.Given | null} the answer that was sent last */
  given = null

  /** @type {number | undefined} */
  timer

  changes = 0

  isClosed = false // and so it says

  sentTo = "" // the server that has the answer

  /** @param {import("./follow.js").Following} following */
  constructor(following) {
    this.following = following
    this.status = element("p", {class: "hint", role: "status"})
  }

  /** @param {page.PutTo} question */
  async put(question) {
    const before = this.question
    this.question = question
    const same = before && nameOf(before) === nameOf(question) && isSame(before.card, question.card)
    if (!question.step) this.#leave()
    else if (!same || !this.card) await this.#lay()
    else this.#resend()
    if (this.card) this.#close(question)
    if (this.card && question.lesson) await this.#teach(question.lesson)
  }

  /** @param {page.PutTo} question which takes no answers, or does again */
  #close({closed, lesson}) {
    const isClosed = closed && !lesson
    this.card?.question.element.toggleAttribute("inert", isClosed)
    if (isClosed) this.status.textContent = "The vote is closed."
    else if (this.isClosed) this.status.textContent = this.given ? this.#sent : ""
    this.isClosed = isClosed
  }

  /** A picture of another scene has no card yet. @param {Drawn} shown */
  shown(shown) {
    if (this.card && this.card.page === this.following.page) this.card.update(shown)
    else if (this.question?.step) this.put(this.question)
  }

  async #lay() {
    const question = /** @type {page.PutTo} */ (this.question)
    this.#leave()
    const {page, shown} = this.following
    // Its plot may not be there before the picture that belongs to it.
    if (!page || !question.card || shown.state.scene !== question.card.opens.scene) return
    this.isClosed = false
    this.card = new Card(this.#walk(question.card, question.place), page)
    this.card.question.element.after(this.status)
    const {changed} = this.card.question
    this.card.question.changed = () => {
      changed()
      this.changes++
      clearTimeout(this.timer)
      this.status.textContent = ""
      this.timer = setTimeout(() => this.#send(), MOMENT)
    }
    this.status.textContent = question.vote > 1 ? `A new vote, number ${question.vote}: answer once more.` : ""
    this.#restore()
    page.redraw() // plots have made way for it
  }

  /** A phone goes nowhere by itself. @param {page.StepCard} step @param {string} where @returns {WalkHost} */
  #walk(step, where) {
    const [sheet, answers] = [{steps: [step]}, {of: () => null}]
    const {code: seed} = this.following
    const own = {seed, sheet, place: 0, where, step: {...step, controls: []}, answers, before: null, lesson: null}
    return {...own, unfolded: false, show: () => this.#send(), forward: none, back: none, again: none, open: none}
  }

  get #sent() {
    return this.card?.walk.step.poll ? VOTED : SENT
  }

  get #name() {
    return nameOf(/** @type {page.PutTo} */ (this.question))
  }

  /** @returns {page.Given | null} */
  #vote() {
    const {walk, step, vote} = /** @type {page.PutTo} */ (this.question)
    const given = this.card?.question.given()
    if (!given) return null
    return {walk, step, vote, ...given}
  }

  /** The answers on their way, one after the other: none takes the place of a newer one. @type {Promise<unknown>} */
  sending = Promise.resolve()

  #send() {
    this.sending = this.sending.then(() => this.#sendNow()).catch(error => console.warn(error))
  }

  async #sendNow() {
    const vote = this.question?.lesson ? null : this.#vote()
    if (!vote) return
    const {changes, card} = this
    try {
      await ask(`${this.following.code}/answer`, {method: "PUT", body: vote, word: this.following.token})
      answer(this.following.code, nameOf(vote), vote)
      if (card !== this.card) return // the lecture has gone on
      this.given = vote
      this.sentTo = this.following.server
      if (card?.walk.lesson) return
      if (changes === this.changes) this.status.textContent = this.#sent
    } catch (reason) {
      if (!(reason instanceof Refusal)) throw reason
      if (card !== this.card || card?.walk.lesson) return
      this.status.textContent = reason.status ? reason.message : "Not sent yet; trying again."
      if (reason.passes) this.timer = setTimeout(() => this.#send(), 2000)
    }
  }

  /** A server that has begun anew may not have the answer. */
  async #resend() {
    const {card, given} = this
    if (!given || card?.walk.lesson || this.following.server === this.sentTo) return
    await pause(Math.random() * SPREAD)
    if (card === this.card && given === this.given && !this.following.stream.over) this.#send()
  }

  /** The answer from before the page was loaded anew. */
  #restore() {
    this.given = mine(this.following.code)?.answers[this.#name] ?? null
    if (!this.given) return
    this.card?.question.restore(this.given)
    clearTimeout(this.timer)
    this.status.textContent = this.#sent
    this.#resend()
  }

  /** @param {page.Lesson} lesson what it teaches everybody; of one's own answer the server says more */
  async #teach(lesson) {
    const {card} = this
    clearTimeout(this.timer)
    this.status.textContent = ""
    if (!card || card.walk.lesson) return
    card.walk.lesson = lesson
    await Promise.race([this.sending, pause(SPREAD)]) // of an answer that is on its way
    if (card !== this.card) return // the lecture has gone on
    const {given} = this
    if (!given) return card.teach(lesson)
    await pause(Math.random() * SPREAD)
    if (card !== this.card) return
    const {code, token} = this.following
    const taught = await ask(`${code}/answer`, {method: "POST", body: given, word: token}).catch(() => null)
    if (card === this.card) card.teach(taught?.lesson ?? lesson)
  }

  #leave() {
    clearTimeout(this.timer)
    this.card?.leave()
    this.card?.page.redraw()
    this.card = null
  }
}

const none = () => {}

/** @param {{walk: string, step: string, vote?: number}} question or answer */
const nameOf = ({walk, step, vote}) => `${walk}/${step}/${vote}`

/** @param {unknown} one @param {unknown} other */
const isSame = (one, other) => JSON.stringify(one) === JSON.stringify(other)

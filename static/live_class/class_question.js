// The question of a class on a phone: answered by a touch, changed until the answer is shown.

import {element} from "../core/dom.js"
import {Card} from "../walks/card.js"
import {haveAnswered} from "./counts.js"
import {Delivery} from "./delivery.js"
import {fetchJson, insist, pause} from "./requests.js"
import {Sureness} from "./sureness.js"

const UNTIL_SHOWN = "You can change it until the answer is shown."
const UNTIL_CLOSED = "You can change it until the vote is closed."
const MOMENT = 400 // ms without a change until an answer is sent
const SPREAD = 1500 // ms; each phone waits a random part of it, so that their requests do not come at once
const TOO_LATE = "Your answer to an earlier question came too late."
const ANSWERED = "This question has been answered. It takes no more answers."
const CLOSED = "The vote is closed."
const PATIENCE = 3000 // ms that the lesson waits for the reply to this phone's answer

export class ClassQuestion {
  /** @type {page.PutTo | null} */
  question = null

  /** @type {page.PutTo} the question on the card */
  laid

  /** @type {Card | null} */
  card = null

  /** @type {number | undefined} set while the answer on the card waits to be sent */
  timer

  /** @param {import("./follow.js").Following} following */
  constructor(following) {
    this.following = following
    this.delivery = new Delivery(following, () => this.#showStatus())
    this.status = element("p", {class: "hint", role: "status"})
    this.sureness = new Sureness(() => this.card?.question.changed())
  }

  /** @param {page.PutTo} question */
  async show(question) {
    const earlier = this.question
    this.question = question
    const isSame = earlier && nameOf(earlier) === nameOf(question) && isEqual(earlier.card, question.card)
    const isTakenBack = earlier?.lesson && !question.lesson
    if (!question.step) this.#leave()
    else if (!isSame || isTakenBack || this.card?.page !== this.following.page) await this.#lay()
    else this.#resend()
    this.#showStatus()
    if (this.card && question.lesson) await this.#teach(question.lesson)
    if (this.card?.walk.lesson && isSame) this.#split(this.card, this.card.walk.lesson)
  }

  /** Shows whether the question takes answers and whether the class has this phone's answer. */
  #showStatus() {
    const {card, question} = this
    if (!card || !question) return
    const isClosed = question.closed && !question.lesson
    card.question.element.toggleAttribute("inert", isClosed)
    this.sureness.element.toggleAttribute("inert", isClosed)
    this.sureness.element.hidden = !question.sure || Boolean(question.lesson)
    const closed = question.answered ? ANSWERED : CLOSED
    const parts = [this.#earlier, isClosed ? closed : "", this.#ofMine(isClosed), this.#ofAll()]
    this.status.textContent = parts.filter(Boolean).join(" ")
  }

  /** The answers of the class in a sentence: their number, and with the shown answer the number of right ones. */
  #ofAll() {
    const {split, lesson} = this.question ?? {}
    if (lesson) return split?.judges && split.answered ? rightOf(split) : ""
    const {answered, here} = this.following.news
    return answered && here ? `${haveAnswered(answered, here)}.` : ""
  }

  /** Updates the number of answers. */
  count() {
    if (this.card && !this.card.walk.lesson) this.#showStatus()
  }

  get #earlier() {
    return [...this.delivery.refused.keys()].some(question => question !== this.name) ? TOO_LATE : ""
  }

  /** The state of this phone's answer in a sentence. @param {boolean} isClosed */
  #ofMine(isClosed) {
    const {delivery, name, laid, timer} = this
    const refused = delivery.refused.get(name)
    if (refused) return `${delivery.sent.has(name) ? "Your last change" : "Your answer"} does not count. ${refused}`
    if (this.card?.walk.lesson) return ""
    const isUnsent = delivery.unsent.has(name)
    if (isUnsent && delivery.isFailing) return "Not sent yet; trying again."
    if (timer !== undefined || isClosed) return ""
    if (delivery.isSent(name)) return `${this.#sent} ${laid.card?.poll ? UNTIL_CLOSED : UNTIL_SHOWN}`
    return laid.vote > 1 && !isUnsent ? `A new vote, number ${laid.vote}: answer once more.` : ""
  }

  get #sent() {
    const answer = this.card?.question.said()
    return answer ? `Sent: ${answer}.` : "Sent."
  }

  get name() {
    return nameOf(this.laid)
  }

  /** The newest answer to this question, sent or not. */
  get given() {
    return this.card && this.delivery.answer(this.name)
  }

  /** Called for each picture. A picture of another scene has no card yet. @param {Drawn} shown */
  shown(shown) {
    if (this.card && this.card.page === this.following.page) this.card.update(shown)
    else if (this.question?.step) this.show(this.question)
  }

  async #lay() {
    const question = /** @type {page.PutTo} */ (this.question)
    this.#leave()
    const {page, shown} = this.following
    // The plot of the question exists only after the picture of its scene has arrived.
    if (!page || !question.card || shown.state.scene !== question.card.opens.scene) return
    this.laid = question
    this.card = new Card(this.#walk(question.card, question.place), page)
    this.card.question.element.after(this.sureness.element, this.status)
    const {changed} = this.card.question
    this.card.question.changed = () => {
      changed()
      clearTimeout(this.timer)
      this.timer = setTimeout(() => this.#give(), MOMENT)
      this.#showStatus()
    }
    this.#restore()
    page.redraw() // the plots became smaller for the card
  }

  /**
   * A walk of one step. The phone cannot turn its pages; the instructor does. @param {page.StepCard} step @param
   * {string} where @returns {WalkHost}
   */
  #walk(step, where) {
    const [sheet, answers] = [{steps: [step]}, {of: () => null}]
    const {code: seed} = this.following
    const own = {
      seed,
      sheet,
      place: 0,
      where,
      step: {...step, controls: []},
      answers,
      earlierAnswer: null,
      lesson: null,
    }
    return {
      ...own,
      unfolded: false,
      isTour: false,
      press: NONE,
      show: () => this.#give(),
      forward: none,
      back: none,
      next: none,
      again: none,
      open: none,
    }
  }

  /** Sends the answer on the card. */
  #give() {
    const {walk, step, vote} = this.laid
    const given = this.card?.question.given()
    this.#settle()
    if (given && !this.card?.walk.lesson)
      this.delivery.give(this.name, {walk, step, vote, ...given, sure: this.sureness.level})
    this.#showStatus()
  }

  #settle() {
    clearTimeout(this.timer)
    this.timer = undefined
  }

  /** Called when the server can be reached again. */
  wake() {
    this.delivery.wake()
  }

  close() {
    this.#leave()
    this.delivery.close()
  }

  /** Sends the answer again to a restarted server, which may have lost it. */
  async #resend() {
    const {card, delivery} = this
    if (!this.given || delivery.isTaken(this.name)) return
    await pause(Math.random() * SPREAD)
    const {closed, lesson} = /** @type {page.PutTo} */ (this.question)
    if (card === this.card && !closed && !lesson) delivery.resend(this.name)
  }

  /** Shows this phone's answer that counts: after a reload, when a question is asked again, with the lesson. */
  #restore() {
    const {given} = this
    this.sureness.setTo(given?.sure ?? 0)
    if (!given) return
    this.card?.question.restore(given)
    this.#settle()
    this.#resend()
  }

  /** Shows the lesson; if this phone has answered, with the reply to its answer. @param {page.Lesson} lesson */
  async #teach(lesson) {
    const {card} = this
    if (this.timer !== undefined) this.#give()
    if (!card || card.walk.lesson) return
    card.walk.lesson = lesson
    this.#showStatus()
    const own = this.#ownLesson(card)
    const first = await Promise.race([own, pause(PATIENCE)])
    if (card !== this.card) return // the lecture is at another question by now
    this.#show(card, first ?? lesson)
    if (!first) own.then(late => this.#teachLate(card, late))
  }

  /** Shows a late reply on a new card. @param {Card} card @param {page.Lesson | null} lesson */
  async #teachLate(card, lesson) {
    if (!lesson || card !== this.card) return
    await this.#lay()
    if (!this.card) return
    this.card.walk.lesson = lesson
    this.#show(this.card, lesson)
    this.#showStatus()
  }

  /**
   * Shows the lesson with the counts of the class, without links to try, at the answer that counts: what was typed
   * while the lesson was on its way does not. @param {Card} card @param {page.Lesson} lesson
   */
  #show(card, lesson) {
    this.#restore()
    card.teach({...lesson, next: ""})
    this.#split(card, lesson)
  }

  /** Shows the counts of the class at each option. @param {Card} card @param {page.Lesson} lesson */
  #split({question}, lesson) {
    const {split} = this.question ?? {}
    if (!split?.options.length) return
    this.layer ??= question.tally(element("div"))
    this.layer.update(tallyOf(split), lesson)
  }

  /** @type {import("../questions/question.js").Tallied | null} the counts of the class on the card */
  layer = null

  /**
   * The lesson with the reply to this phone's answer; null without an answer.
   * @param {Card} card @returns {Promise<page.Lesson | null>}
   */
  async #ownLesson(card) {
    const {given} = this
    const {code, token} = this.following
    if (!given) return null
    await pause(Math.random() * SPREAD)
    const request = () =>
      card === this.card ? fetchJson(`${code}/answer`, {method: "POST", body: given, word: token}) : null
    const taught = await insist(async () => request(), {woken: () => this.delivery.retry.signal}).catch(() => null)
    return taught?.lesson ?? null
  }

  #leave() {
    if (this.timer !== undefined) this.#give()
    this.layer = null
    this.card?.leave()
    this.card?.page.redraw()
    this.card = null
  }
}

/** A tally from a split; the missing fields are empty. @param {page.Split} split @returns {page.Tally} */
function tallyOf({answered, right, options, having}) {
  const now = {answered, options, having, numbers: [], sketches: [], sure: [], words: []}
  return {walk: "", step: "", vote: 1, before: null, features: [], right, now}
}

/** @param {page.Split} split */
const rightOf = ({answered, right}) => `${right} of ${answered} ${right === 1 ? "is" : "are"} right.`

const none = () => {}

/** @type {Press} */
const NONE = {words: "", act: none}

/** @param {{walk: string, step: string, vote?: number}} question or answer */
const nameOf = ({walk, step, vote}) => `${walk}/${step}/${vote}`

/** @param {unknown} one @param {unknown} other */
const isEqual = (one, other) => JSON.stringify(one) === JSON.stringify(other)

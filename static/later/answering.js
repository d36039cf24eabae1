// The lecture's question on a phone: answered by a touch, changed until the answer is shown.

import {element} from "../dom.js"
import {Card} from "./card.js"
import {Refusal, ask} from "./room.js"

const HEIGHTS = 101 // of a sketch as it is sent
const MOMENT = 400 // ms without a change until an answer is sent
const SPREAD = 1500 // ms over which all phones ask what is said of their answers

export class AskedPut {
  /** @type {page.PutTo | null} */
  question = null

  /** @type {Card | null} */
  card = null

  /** @type {page.Vote | null} the answer that was sent last */
  given = null

  /** @type {number | undefined} */
  timer

  /** @param {import("./follow.js").Following} following */
  constructor(following) {
    this.following = following
    this.status = element("p", {class: "hint", role: "status"})
  }

  /** @param {page.PutTo} question */
  async put(question) {
    const before = this.question
    this.question = question
    const same = before && before.step === question.step && before.vote === question.vote
    if (!question.step) this.#leave()
    else if (!same || !this.card) await this.#lay()
    if (this.card && question.lesson) await this.#teach(question.lesson)
  }

  /** A picture of another scene has no card yet. @param {Drawn} shown */
  shown(shown) {
    if (this.card && this.card.page === this.following.page) this.card.update(shown)
    else if (this.question?.step) this.put(this.question)
  }

  async #lay() {
    const question = /** @type {page.PutTo} */ (this.question)
    this.#leave()
    const sheet = /** @type {page.WalkSheet} */ (await this.following.sheet(question.sheet))
    const place = sheet.steps.findIndex(({id}) => id === question.step)
    const step = sheet.steps[place]
    const {page, shown} = this.following
    // Its plot may not be there before the picture that belongs to it.
    if (!page || !step || shown.state.scene !== step.opens.scene) return
    this.card = new Card(this.#walk(sheet, place), page)
    this.card.question.element.after(this.status)
    const {changed} = this.card.question
    this.card.question.changed = () => {
      changed()
      clearTimeout(this.timer)
      this.status.textContent = ""
      this.timer = setTimeout(() => this.#send(), MOMENT)
    }
    this.status.textContent = ""
    this.#restore()
  }

  /** As much of a walk as a card asks for. @param {page.WalkSheet} sheet @param {number} place @returns {any} */
  #walk(sheet, place) {
    return {
      sheet,
      place,
      step: {...sheet.steps[place], controls: []},
      lesson: null,
      before: {},
      unfolded: false,
      answers: {of: () => null},
      lecture: this.following,
      show: () => this.#send(),
    }
  }

  get #name() {
    const {walk, step, vote} = /** @type {page.PutTo} */ (this.question)
    return `class-${this.following.code}-${walk}-${step}-${vote}`
  }

  /** @returns {page.Vote | null} */
  #vote() {
    const {walk, step, vote} = /** @type {page.PutTo} */ (this.question)
    const question = /** @type {any} */ (this.card?.question)
    const given = question?.given()
    if (!given) return null
    const {option = null, text = "", value = null} = given
    const {pad} = question
    return {walk, step, vote, option, text, value, curves: pad ? heightsOf(pad) : {}}
  }

  async #send() {
    const vote = this.question?.lesson ? null : this.#vote()
    if (!vote) return
    try {
      await ask(`${this.following.code}/answer`, {method: "PUT", body: vote, word: this.following.token})
      this.given = vote
      this.status.textContent = "Sent. You can change it until the answer is shown."
      sessionStorage.setItem(this.#name, JSON.stringify(vote))
    } catch (reason) {
      if (!(reason instanceof Refusal)) return // a browser that keeps nothing
      this.status.textContent = reason.status ? reason.message : "Not sent yet; it is tried again."
      if (!reason.status || reason.status >= 500) this.timer = setTimeout(() => this.#send(), 2000)
    }
  }

  /** What was answered before the page was loaded anew. */
  #restore() {
    this.given = null
    try {
      this.given = JSON.parse(sessionStorage.getItem(this.#name) ?? "null")
    } catch {
      // A browser that keeps nothing.
    }
    if (!this.given) return
    const question = /** @type {any} */ (this.card?.question)
    if (this.given.option !== null) question.choose(this.given.option)
    if (question.field) question.field.value = this.given.text
    clearTimeout(this.timer)
    this.status.textContent = "Sent. You can change it until the answer is shown."
  }

  /** @param {page.Lesson} lesson what it teaches everybody; of one's own answer the server says more */
  async #teach(lesson) {
    const {card, given} = this
    clearTimeout(this.timer)
    this.status.textContent = ""
    if (!card || card.walk.lesson) return
    card.walk.lesson = lesson
    if (!given) return card.teach(lesson)
    await new Promise(done => setTimeout(done, Math.random() * SPREAD))
    const {code, token} = this.following
    const taught = await ask(`${code}/answer`, {method: "POST", body: given, word: token}).catch(() => ({lesson}))
    if (card === this.card) card.teach(taught.lesson)
  }

  #leave() {
    clearTimeout(this.timer)
    this.card?.leave()
    this.card = null
  }
}

/** Heights in thousandths of the frame, evenly from its left to its right. @param {import("./pad.js").Pad} pad */
function heightsOf({heights, plot}) {
  const {start, end} = plot.y
  /** @param {number | null} y */
  const share = y =>
    y === null ? null : Math.min(Math.max(Math.round((1000 * (y - start)) / (end - start)), -100), 1100)
  const drawn = [...heights].filter(([, ys]) => ys.some(y => y !== null))
  return Object.fromEntries(
    drawn.map(([name, ys]) => [
      name,
      Array.from({length: HEIGHTS}, (_, i) => share(ys[Math.round((i * (ys.length - 1)) / (HEIGHTS - 1))])),
    ]),
  )
}

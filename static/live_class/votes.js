// The answers of the class on the instructor's page: a count, then bars, dots or sketches on demand.

import {chip, element} from "../core/dom.js"
import {claim} from "../walks/headline.js"
import {fetchJson} from "./requests.js"
import {haveAnswered} from "./counts.js"
import {countedOf} from "./earlier.js"
import {sureness} from "./sureness.js"

const MOMENT = 250 // ms between counts; a failed one is repeated

export class Votes {
  /** @type {page.Tally | null} */
  tally = null

  /** @type {import("../walks/card.js").Card | null} the card that shows the votes */
  card = null

  /** @type {import("../questions/question.js").Tallied | null} */
  layer = null

  /** @type {import("./earlier.js").Earlier} the votes of an earlier class */
  earlier = new Map()

  isOpen = false
  counting = false
  again = false

  /** @param {import("./teach.js").Teach} teach */
  constructor(teach) {
    this.teach = teach
    this.status = element("p", {role: "status"})
    this.all = element("p", {class: "all"})
    this.once = chip("Vote again", () => teach.again())
    this.hide = chip("Hide the votes", () => this.close())
    this.end = chip("Close the vote", () => teach.close())
    this.closing = chip("Close at 0", () => teach.closeAtEnd())
    this.answer = chip("Show the answer", () => teach.lecture.walks.walk?.show(true))
    this.sure = element("p", {class: "sure"})
    this.chips = element("div", {class: "chips"})
    this.element = element(
      "div",
      {class: "votes"},
      teach.countdown.element,
      this.all,
      this.status,
      this.sure,
      this.chips,
    )
  }

  /** Called for a new question or a new card. @param {import("../walks/walk.js").Walk | null} walk */
  begin(walk) {
    this.#clear()
    this.isOpen = false
    this.tally = null
    this.card = walk?.card ?? null
    this.card?.question.element.after(this.element)
    if (this.card) this.count()
    else this.element.remove()
  }

  /** True if the filled button shows the votes of a class before the answer. */
  get isUnopened() {
    return Boolean(this.card) && !this.isOpen && !this.teach.lecture.walks.walk?.lesson
  }

  /** True if the question can be asked again. */
  get canRepeat() {
    return this.isOpen || Boolean(this.teach.news.question?.closed)
  }

  open() {
    this.isOpen = true
    this.update()
  }

  /** Hides the votes, so that the explanation is visible after the answer. */
  close() {
    const {walk} = this.teach.lecture.walks
    this.isOpen = false
    if (this.card && walk?.lesson) claim(this.card.page, walk.lesson.title)
    this.#clear()
    this.update()
  }

  #clear() {
    this.card?.page.root.classList.remove("voted")
    this.layer?.leave()
    this.layer = null
  }

  /** Requests the answers, with a pause between two counts. */
  async count() {
    this.again = true
    if (this.counting || !this.card) return
    this.counting = true
    this.again = false
    const {code, key} = this.teach.room
    const tally = await fetchJson(`${code}/tally`, {word: key}).catch(() => {
      this.again = true
    })
    if (tally && `${tally.walk}/${tally.step}` === this.teach.askedStep) this.tally = tally
    this.update()
    setTimeout(() => {
      this.counting = false
      if (this.again) this.count()
    }, MOMENT)
  }

  update() {
    const {card, tally} = this
    const {walk} = this.teach.lecture.walks
    if (!card || !walk) return
    const here = this.teach.news.here ?? 0
    const beside = tally && this.#beside(tally)
    const before = beside ? `, outlined: ${tally?.before ? "first vote" : "earlier class"}` : ""
    const turn = tally && tally.vote > 1 && !walk.lesson ? `Vote ${tally.vote}: ` : ""
    const answered = tally?.now.answered ?? 0
    const drawn = tally?.now.sketches.length ?? 0
    const some = drawn && drawn < answered ? `, ${drawn} of them drawn here` : "" // more would merge
    const words = `${turn}${haveAnswered(answered, here)}${this.isOpen ? some + before : ""}`
    this.status.textContent = tally ? words : "" // a missing count is not 0
    const isTakenBack = this.teach.isTakenBack(walk)
    card.ready()
    const {closed} = this.teach.news.question ?? {}
    if (closed && !walk.lesson)
      this.status.append(isTakenBack ? ". The answer has been shown." : ". The vote is closed.")
    const isAsked = !walk.lesson && !isTakenBack
    this.closing.setAttribute("aria-pressed", String(Boolean(this.teach.news.question?.closes)))
    const tools = [
      ...(this.isOpen && !walk.lesson ? [this.hide] : []),
      ...(isTakenBack ? [this.answer] : []),
      ...(isAsked && this.canRepeat ? [this.once] : []),
      ...(isAsked && !closed ? [this.end] : []),
      ...(isAsked && !closed && this.teach.countdown.until ? [this.closing] : []),
    ]
    this.chips.replaceChildren(...tools)
    this.all.textContent = ""
    this.sure.textContent = this.isOpen && tally ? sureness(tally.now, Boolean(walk.lesson)) : ""
    card.page.root.classList.toggle("voted", this.isOpen)
    if (this.isOpen && tally) this.#draw(walk, tally)
  }

  /** The outlined answers: the first vote, or an earlier class. @param {page.Tally} tally */
  #beside({walk, step, before}) {
    const answers = this.earlier.get(`${walk}/${step}`)
    return before ?? (answers && this.card ? countedOf(answers, this.card.walk.step) : null)
  }

  /** @param {import("../walks/walk.js").Walk} walk @param {page.Tally} tally */
  #draw({lesson}, tally) {
    const card = /** @type {import("../walks/card.js").Card} */ (this.card)
    this.layer ??= card.question.tally(this.chips)
    this.layer.update({...tally, before: this.#beside(tally)}, lesson, this.teach.moderate)
    if (lesson && tally.now.answered) this.all.textContent = this.layer.headline(tally)
  }

  leave() {
    const {card} = this
    this.#clear()
    this.isOpen = false
    this.element.remove()
    this.card = null
    card?.ready()
  }
}

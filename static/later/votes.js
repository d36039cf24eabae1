// The answers of the hall in front: a count, then bars, dots or sketches when they are asked for.

import {element} from "../dom.js"
import {claim} from "./claim.js"
import {Dots} from "./dots.js"
import {Sketches} from "./sketches.js"
import {ask} from "./room.js"

const MOMENT = 250 // ms between counts; one that fails is taken anew

export class Votes {
  /** @type {page.Tally | null} */
  tally = null

  /** @type {import("./card.js").Card | null} the card that they stand on */
  card = null

  /** @type {Dots | Sketches | null} over the plot */
  layer = null

  isOpen = false
  counting = false
  again = false

  /** @param {import("./teach.js").Teach} teach */
  constructor(teach) {
    this.teach = teach
    this.status = element("p", {role: "status"})
    this.all = element("p", {class: "all"})
    this.once = element("button", {type: "button", class: "chip"}, "Vote again")
    this.once.addEventListener("click", () => teach.again())
    this.hide = element("button", {type: "button", class: "chip"}, "Hide the votes")
    this.hide.addEventListener("click", () => this.#close())
    this.chips = element("div", {class: "chips"})
    this.element = element("div", {class: "votes"}, this.all, this.status, this.chips)
  }

  /** A question begins, or its card is another. @param {import("./walk.js").Walk | null} walk */
  begin(walk) {
    this.#clear()
    this.isOpen = false
    this.tally = null
    this.card = walk?.card ?? null
    this.card?.question.element.after(this.element)
    if (this.card) this.count()
    else this.element.remove()
  }

  /** What the filled button does in a class, before it shows the answer. */
  get waits() {
    return Boolean(this.card) && !this.isOpen && !this.teach.lecture.walks.walk?.lesson
  }

  open() {
    this.isOpen = true
    this.update()
  }

  #close() {
    const {walk} = this.teach.lecture.walks
    this.isOpen = false
    if (this.card && walk?.lesson) claim(this.card.page, walk.lesson.title)
    this.#clear()
    this.update()
  }

  #clear() {
    this.card?.page.root.classList.remove("gallery", "voted")
    this.layer?.leave()
    this.layer = null
    for (const bar of document.querySelectorAll(".answers .vote-row")) bar.remove()
  }

  /** Asks for the answers, not more often than they can be looked at. */
  async count() {
    this.again = true
    if (this.counting || !this.card) return
    this.counting = true
    this.again = false
    const {code, key} = this.teach.room
    const tally = await ask(`${code}/tally`, {word: key}).catch(() => {
      this.again = true
    })
    if (tally && `${tally.walk}/${tally.step}` === this.teach.put) this.tally = tally
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
    const before = tally?.before ? ", outlined: first vote" : ""
    const answered = tally?.now.answered ?? 0
    const of = answered > here ? "" : ` of ${here}` // some have left since
    const drawn = tally?.now.sketches.length ?? 0
    const some = drawn && drawn < answered ? `, ${drawn} of them drawn here` : "" // more would be one dark area
    this.status.textContent = `${answered}${of} have answered${this.isOpen ? some + before : ""}`
    if (!walk.lesson) card.forward.textContent = this.waits ? "Show the votes" : "Show the answer"
    if (!walk.lesson) card.forward.classList.remove("waiting")
    const tools = this.isOpen ? [this.hide, ...(walk.lesson ? [] : [this.once])] : []
    this.chips.replaceChildren(...tools)
    this.all.textContent = ""
    card.page.root.classList.toggle("voted", this.isOpen)
    if (this.isOpen && tally) this.#draw(walk, tally)
  }

  /** @param {import("./walk.js").Walk} walk @param {page.Tally} tally */
  #draw({step, lesson}, tally) {
    const card = /** @type {import("./card.js").Card} */ (this.card)
    if (step.kind === "choice") return bars(card, tally, lesson)
    if (step.kind === "sketch") this.layer ??= new Sketches(card, step, this.chips)
    else this.layer ??= new Dots(card, step)
    this.layer.update(tally, lesson)
    const headline = lesson ? this.layer.headline(tally) : ""
    this.all.textContent = headline
    if (step.kind === "sketch") card.page.root.classList.add("gallery")
    if (step.kind === "sketch" && lesson && this.teach.lecture.hall.on) card.page.heading.textContent = headline
  }

  leave() {
    this.#clear()
    this.element.remove()
    this.card = null
  }
}

/** @param {import("./card.js").Card} card @param {page.Tally} tally @param {page.Lesson | null} lesson */
function bars(card, {now, before}, lesson) {
  const most = Math.max(1, ...now.options, ...(before?.options ?? []))
  const rows = [...card.question.element.querySelectorAll("button")]
  for (const [i, row] of rows.entries()) {
    row.querySelector(".vote-row")?.remove()
    const parts = [element("i", {style: `--share: ${now.options[i] / most}`})]
    if (before?.options[i]) parts.push(element("i", {class: "before", style: `--share: ${before.options[i] / most}`}))
    const count = element("span", {class: "vote-count"}, ...(before ? [`${before.options[i]} → `] : []))
    count.append(element("b", {}, String(now.options[i])))
    row.classList.toggle("right-vote", Boolean(lesson?.verdicts[i]?.right))
    const bar = element("span", {class: "vote-bar"}, ...parts)
    row.append(element("span", {class: before ? "vote-row twice" : "vote-row"}, bar, count))
  }
}

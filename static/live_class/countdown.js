// The countdown of a vote: large, on the hall's screen, on phones and on the remote control, by the server's clock.

import {element} from "../core/dom.js"

const TICK = 200 // ms
export const [FIRST, MORE] = [30, 15] // seconds that the first press and each further press add

export class Countdown {
  element = element("p", {class: "countdown", role: "timer"})

  until = 0 // end of the countdown in ms of the server's clock; 0 without a countdown

  /** @param {{now: number}} timing */
  constructor(timing) {
    this.timing = timing
    this.ticking = setInterval(() => this.#tick(), TICK)
    this.#tick()
  }

  /** Shows the countdown of a question that takes answers. @param {page.PutTo | null | undefined} question */
  show(question) {
    this.until = question?.step && !question.lesson && !question.closed ? question.until : 0
    this.#tick()
  }

  /** Seconds that are left. */
  get left() {
    return Math.max(0, Math.ceil((this.until - this.timing.now) / 1000))
  }

  get isOver() {
    return this.until > 0 && this.left === 0
  }

  #tick() {
    const {left, until} = this
    this.element.hidden = !until
    const words = left ? `${Math.floor(left / 60)}:${String(left % 60).padStart(2, "0")}` : "Time is up"
    if (this.element.textContent !== words) this.element.textContent = words
  }

  end() {
    clearInterval(this.ticking)
  }
}

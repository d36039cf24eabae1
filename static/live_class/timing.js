// The server's clock as this browser can know it: from the fastest of several requests, with the bound of its error.

import {ask} from "./requests.js"

const FIRST = [3, 12] // requests, at least and at most
const THEN = [1, 3]
const LIMIT = 2000 // ms for one: what takes longer says little
const CLOSE = 10 // ms: more requests need not better such a bound
const AGAIN = 60000 // ms, after which it is measured anew
const DRIFT = 1e-4 // of the time since: clocks of phones run fast or slow by a fifth of that

export class Timing {
  offset = 0 // ms to be added to this browser's clock
  within = Infinity // ms by which that was off at most
  at = 0 // when it was measured, by this browser's clock
  apart = 0 // the time of day less this browser's clock, then

  /** @param {() => void} [changed] called when the bound is another */
  constructor(changed = () => {}) {
    this.changed = changed
    this.measured = this.measure(FIRST)
    setInterval(() => document.hidden || this.measure(THEN), AGAIN)
    document.addEventListener("visibilitychange", () => document.hidden || this.#wake())
  }

  /** ms by which the server's time may be off. */
  get bound() {
    return this.within + DRIFT * (clock() - this.at)
  }

  /** The server's time, in ms. */
  get now() {
    return clock() + this.offset
  }

  /** While a phone sleeps its clock may stand: the time of day serves until the server has been asked. */
  #wake() {
    const apart = Date.now() - clock()
    this.offset += apart - this.apart
    this.apart = apart
    this.within = Infinity
    this.measured = this.measure(FIRST)
  }

  /** The server looked at its clock between sending and receiving: the middle is off by half of that at most. */
  async measure([least, most] = THEN) {
    const sent = clock()
    const server = await ask("time", {signal: AbortSignal.timeout(LIMIT)}).catch(() => null)
    const back = clock()
    const within = (back - sent) / 2
    if (server !== null && within < this.bound) {
      Object.assign(this, {offset: server - (sent + back) / 2, within, at: back, apart: Date.now() - back})
      this.changed()
    }
    if (most > 1 && (least > 1 || this.bound > CLOSE)) await this.measure([least - 1, most - 1])
  }
}

/** It never jumps, as that of the day may. */
const clock = () => performance.timeOrigin + performance.now()

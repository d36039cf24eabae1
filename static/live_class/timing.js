// An estimate of the server's clock from the fastest of several requests, with a bound of its error.

import {fetchJson} from "./requests.js"

const FIRST = [3, 12] // requests to estimate the clock offset, at least and at most
const THEN = [1, 3]
const LIMIT = 2000 // ms for one: what takes longer says little
const CLOSE = 10 // ms: more requests need not better such a bound
const AGAIN = 60000 // ms until it is measured again
const DRIFT = 1e-4 // of the time since: clocks of phones run fast or slow by a fifth of that

export class Timing {
  offset = 0 // ms to be added to this browser's clock
  within = Infinity // ms by which that was off at most
  at = 0 // when it was measured, by this browser's clock
  apart = 0 // the time of day minus this browser's clock at that time

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

  /** Uses the time of day until the next measurement, because the clock of a sleeping phone may stop. */
  #wake() {
    const apart = Date.now() - clock()
    this.offset += apart - this.apart
    this.apart = apart
    this.within = Infinity
    this.measured = this.measure(FIRST)
  }

  /** Measures once. The server read its clock within the round trip, so its middle is off by at most half of it. */
  async measure([least, most] = THEN) {
    const sent = clock()
    const server = await fetchJson("time", {signal: AbortSignal.timeout(LIMIT)}).catch(() => null)
    const back = clock()
    const within = (back - sent) / 2
    if (server !== null && within < this.bound) {
      Object.assign(this, {offset: server - (sent + back) / 2, within, at: back, apart: Date.now() - back})
      this.changed()
    }
    if (most > 1 && (least > 1 || this.bound > CLOSE)) await this.measure([least - 1, most - 1])
  }
}

/** The browser's clock, which never jumps, unlike the time of day. */
const clock = () => performance.timeOrigin + performance.now()

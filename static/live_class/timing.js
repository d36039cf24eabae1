// An estimate of the server's clock from the fastest of several requests, with a bound of its error.

import {fetchJson} from "./requests.js"

const FIRST = [3, 12] // requests to estimate the clock offset, at least and at most
const THEN = [1, 3] // the same for each later estimate
const LIMIT = 2000 // ms for one request; a slower one would be too inaccurate
const CLOSE = 10 // ms; a smaller bound needs no further requests
const AGAIN = 60000 // ms until the next estimate
const DRIFT = 1e-4 // assumed relative drift of the clock; phones drift by about a fifth of it

export class Timing {
  offset = 0 // ms to be added to this browser's clock
  within = Infinity // bound of the error of `offset` in ms, when it was measured
  at = 0 // time of the measurement, by this browser's clock
  apart = 0 // time of day minus this browser's clock, at the measurement

  /** @param {() => void} [changed] called when the bound has changed */
  constructor(changed = () => {}) {
    this.changed = changed
    this.measured = this.measure(FIRST)
    setInterval(() => document.hidden || this.measure(THEN), AGAIN)
    document.addEventListener("visibilitychange", () => document.hidden || this.#wake())
  }

  /** Bound of the error of `now`, in ms. */
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

  /**
   * Measures with one request. It assumes that the server read its clock in the middle of the round trip; the error is
   * at most half the duration of the trip.
   */
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

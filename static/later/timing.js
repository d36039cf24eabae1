// The server's clock as this browser can know it: from the fastest of several requests, with the bound of its error.

import {ask} from "./room.js"

const REQUESTS = 8
const AGAIN = 60000 // ms, after which it is measured anew: clocks of phones drift

export class Timing {
  offset = 0 // ms to be added to this browser's clock
  bound = Infinity // ms by which that may be off

  constructor() {
    this.measured = this.measure()
    setInterval(() => document.hidden || this.measure(), AGAIN)
    document.addEventListener("visibilitychange", () => document.hidden || this.measure())
  }

  /** The server looked at its clock between sending and receiving: the middle is off by half of that at most. */
  async measure() {
    let best = {offset: this.offset, bound: Infinity}
    /** @param {number} left */
    const again = async left => {
      const sent = clock()
      const server = await ask("time").catch(() => null)
      const back = clock()
      const bound = (back - sent) / 2
      if (server !== null && bound < best.bound) best = {offset: server - (sent + back) / 2, bound}
      if (left > 1) await again(left - 1)
    }
    await again(REQUESTS)
    if (best.bound < Infinity) Object.assign(this, best)
  }

  /** The server's time, in ms. */
  get now() {
    return clock() + this.offset
  }
}

/** It never jumps, as that of the day may. */
const clock = () => performance.timeOrigin + performance.now()

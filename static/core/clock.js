// The page's only clock: it plays through the time window in the browser alone.

import {clamp} from "./ruler.js"

const STEPS_PER_CYCLE = 24

export class Clock {
  /** @param {(t: number) => void} draw shows an instant */
  constructor(draw) {
    this.draw = draw
    this.t = 0 // the current time, in the unit of the time axis
    this.end = 1
    this.unit = 1 // length of that unit in seconds
    this.places = 2 // decimals of the time in messages
    this.pace = 1 // simulated seconds per real second at the speed Auto
    this.limit = Infinity // highest speed at which the fastest motion can still be seen
    /** @type {number | "auto"} */
    this.choice = "auto"
    this.playing = playsByItself()
    this.played = this.playing // true if the clock was playing in the last frame
    /** @type {number | null} */
    this.last = null
    this.dirty = true
    this.running = true
    this.frames = 0
    /** @type {(() => void)[]} */
    this.listeners = []
    /** @type {(() => number) | null} time of another clock, which this one follows */
    this.lead = null
    requestAnimationFrame(now => this.tick(now))
  }

  // The simulated seconds per real second that the visitor has chosen.
  get asked() {
    return this.choice === "auto" ? this.pace : this.choice
  }

  get factor() {
    return Math.min(this.asked, this.limit)
  }

  get slowed() {
    return this.asked > this.limit
  }

  /** Takes the time axis and speeds of a new picture. Without a time axis nothing moves. @param {Drawn} shown */
  update({view: {axes, time, pace}}) {
    const {[time]: axis} = axes
    this.places = axis ? clamp(Math.ceil(2 - Math.log10(axis.end)), 0, 5) + 1 : 2
    this.end = axis?.end ?? 1
    this.unit = 10 ** (axis?.exponent ?? 0)
    this.pace = pace.auto
    this.limit = pace.limit ?? Infinity
    if (this.t > this.end) this.t = 0
    this.touch()
  }

  touch() {
    this.dirty = true
    this.listeners.forEach(listen => listen())
  }

  toggle() {
    this.playing = !this.playing
    this.touch()
  }

  restart() {
    this.playing = playsByItself()
    this.seek(0)
  }

  /** @param {number} t */
  seek(t) {
    this.t = clamp(t, 0, this.end)
    this.touch()
  }

  /** Moves the time by 1/24 of what the speed Auto plays in 6 s. @param {1 | -1} direction */
  step(direction) {
    this.playing = false
    this.seek(
      this.t + (direction * Math.min((6 * Math.min(this.pace, this.limit)) / this.unit, this.end)) / STEPS_PER_CYCLE,
    )
  }

  /** Multiplies the speed by 2 ** power. @param {number} power */
  faster(power) {
    this.choice = Math.min(
      Math.max(2 ** (Math.round(Math.log2(this.choice === "auto" ? 1 : this.choice)) + power), 1 / 16),
      16,
    )
    this.touch()
  }

  auto() {
    this.choice = "auto"
    this.touch()
  }

  /** Follows another clock. @param {boolean} playing @param {() => number} lead */
  follow(playing, lead) {
    this.playing = playing
    this.lead = lead
    this.touch()
  }

  /** @param {number} now in ms */
  tick(now) {
    if (!this.running) return
    requestAnimationFrame(later => this.tick(later))
    if (this.lead) {
      const t = Math.min(this.lead(), this.end)
      this.dirty ||= t !== this.t
      this.t = t
    } else if (this.playing && this.last !== null) {
      // A tab that was hidden continues from the instant at which it was hidden.
      const seconds = Math.min((now - this.last) / 1000, 0.1)
      this.t += (seconds * this.factor) / this.unit
      // At a high speed, a short window can pass several times in one frame.
      if (this.t > this.end) this.t = Math.min(this.t, Number.MAX_VALUE) % this.end
      this.dirty = true
    }
    this.last = now
    this.dirty ||= this.playing !== this.played // draw once more after a stop, with all numbers of this time
    this.played = this.playing
    if (!this.dirty) return
    this.dirty = false
    this.frames += 1
    this.draw(this.t)
  }

  leave() {
    this.running = false
  }
}

const playsByItself = () => !matchMedia("(prefers-reduced-motion: reduce)").matches

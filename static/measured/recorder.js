// The phone as its own sensor: its accelerations for up to 30 s, after a countdown.

const LEAD = 5 // s of the countdown
const LONGEST = 30 // s
const SILENT = 2 // s without data until a reason is shown
const NAMES = ["x (m/s²)", "y (m/s²)", "z (m/s²)"]
const REFUSED =
  "This browser gives the page no accelerations. Allow motion sensors for it in the browser's settings, or record " +
  "with an app and open its file."

/** True on a phone or tablet whose browser can probably give the page accelerations. */
export const canRecord = () =>
  isSecureContext && typeof DeviceMotionEvent !== "undefined" && matchMedia("(pointer: coarse)").matches

/**
 * The host of a recording: `waits` and `records` the seconds that are left, `done` the table, `refused` a reason.
 * @typedef {{waits(left: number): void, records(left: number): void, done(table: import("./table.js").Table): void,
 *   refused(reason: string): void}} Listener
 */

export class Recorder {
  /** @type {number[][]} time in ms and the accelerations along three axes */
  rows = []

  begun = 0 // s since the countdown began

  /** @param {Listener} listener */
  constructor(listener) {
    this.listener = listener
    this.take = (/** @type {DeviceMotionEvent} */ event) => this.#take(event)
    this.allowed = this.#allow()
  }

  /** True after the countdown. */
  get isRunning() {
    return this.begun >= LEAD
  }

  /** Requests permission. iOS allows this only during the event of a press. */
  async #allow() {
    const sensor = /** @type {{requestPermission?: () => Promise<string>}} */ (
      /** @type {unknown} */ (DeviceMotionEvent)
    )
    const answer = sensor.requestPermission ? await sensor.requestPermission().catch(() => "denied") : "granted"
    if (answer !== "granted") return this.listener.refused(REFUSED)
    window.addEventListener("devicemotion", this.take)
    this.ticking = setInterval(() => this.#tick(++this.begun - LEAD), 1000)
    this.listener.waits(LEAD)
  }

  /** @param {number} seconds since the countdown ended */
  #tick(seconds) {
    if (seconds < 0) this.listener.waits(-seconds)
    else if (seconds >= SILENT && !this.rows.length) this.#refuse()
    else if (seconds < LONGEST) this.listener.records(LONGEST - seconds)
    else this.stop()
  }

  /** @param {DeviceMotionEvent} event */
  #take({timeStamp, acceleration, accelerationIncludingGravity}) {
    const {x, y, z} = (isKnown(acceleration) ? acceleration : accelerationIncludingGravity) ?? NOTHING
    if (this.isRunning && isKnown({x, y, z})) this.rows.push([timeStamp, Number(x), Number(y), Number(z)])
  }

  #refuse() {
    this.leave()
    this.listener.refused(REFUSED)
  }

  /** Ends the recording. */
  stop() {
    this.leave()
    this.listener.done(tableOfRows(this.rows))
  }

  leave() {
    clearInterval(this.ticking)
    window.removeEventListener("devicemotion", this.take)
  }
}

const NOTHING = {x: null, y: null, z: null}

/** @param {{x: number | null, y: number | null, z: number | null} | null} acceleration */
const isKnown = acceleration => typeof acceleration?.x === "number"

/** A table of the times and the axes, the one with the largest motion first. @param {number[][]} rows */
export function tableOfRows(rows) {
  const column = (/** @type {number} */ place) => Float64Array.from(rows, row => row[place])
  const axes = NAMES.map((name, i) => ({name, values: column(i + 1)})).toSorted(
    (a, b) => range(b.values) - range(a.values),
  )
  const times = column(0).map(time => (time - rows[0][0]) / 1000)
  return {
    names: ["t (s)", ...axes.map(({name}) => name)],
    columns: [times, ...axes.map(({values}) => values)],
    lines: rows.map((_, i) => i + 1),
  }
}

/** @param {Float64Array} values */
const range = values =>
  values.reduce((most, one) => Math.max(most, one), -Infinity) -
  values.reduce((least, one) => Math.min(least, one), Infinity)

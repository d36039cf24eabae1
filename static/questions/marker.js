// The marker with which a visitor marks a value on an axis: press the axis, drag the marker, or use the arrow keys.

import {short, withUnit} from "../core/numbers.js"
import {element, long, setAttributes, unitSize} from "../core/dom.js"
import {focusByHand} from "../controls/drag.js"
import {clamp} from "../core/ruler.js"
import {EVERYWHERE, places} from "../scene/places.js"

const STEPS = 100 // arrow key presses from one end to the other

export class Marker {
  /** @type {number | null} the marked value */
  value = null

  /** @type {number[]} */
  truths = []

  /** @param {import("../scene/plots.js").Plot} plot @param {page.StepCard} step @param {() => void} moved */
  constructor(plot, {axis, unit}, moved) {
    this.plot = plot
    this.which = axis || "x"
    this.unit = unit
    this.moved = moved
    this.pill = element("button", {type: "button", class: "pill-mark", role: "slider", "aria-label": "Your mark"}, "?")
    this.line = element("i", {class: "line-mark"})
    this.layer = element("div", {class: `marking ${this.which}`}, this.line, this.pill)
    this.plot.host.append(this.layer)
    this.plot.host.classList.add("marked")
    this.observer = new ResizeObserver(() => this.place())
    this.observer.observe(this.plot.host)
    this.layer.addEventListener("pointerdown", event => this.#press(event))
    this.layer.addEventListener("pointermove", event => this.#drag(event))
    this.pill.addEventListener("keydown", event => this.#key(event))
    this.place()
  }

  get ruler() {
    return this.plot[this.which === "x" ? "x" : "y"]
  }

  /** The number at the mark, to three digits, in the unit of the axis. */
  get number() {
    return this.value === null ? "" : this.#number(this.value)
  }

  /** @param {number} value a place on the axis */
  #number(value) {
    const {log, exponent} = this.ruler
    return short(log ? 10 ** value : value * 10 ** exponent)
  }

  /** @param {PointerEvent} event */
  #press(event) {
    event.preventDefault()
    event.stopPropagation()
    this.layer.setPointerCapture(event.pointerId)
    focusByHand(this.pill)
    this.setTo(this.plot.valueAt(event, this.which === "x" ? "x" : "y"))
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    if (!this.layer.hasPointerCapture(event.pointerId)) return
    event.stopPropagation()
    this.setTo(this.plot.valueAt(event, this.which === "x" ? "x" : "y"))
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key]
    if (!way) return
    event.preventDefault()
    event.stopPropagation()
    const {start, end} = this.ruler
    const size = (end - start) / STEPS / (event.shiftKey ? 10 : 1)
    this.setTo((this.value ?? (start + end) / 2) + way * size)
  }

  /** @param {number} value a place on the axis */
  setTo(value) {
    const {start, end} = this.ruler
    this.value = clamp(value, Math.min(start, end), Math.max(start, end))
    this.place()
    this.moved()
  }

  /** The current position of the axis. */
  place() {
    const {start, end} = this.ruler
    this.#placeAt(this.pill, this.value ?? (start + end) / 2)
    this.#placeAt(this.line, this.value ?? (start + end) / 2)
    this.line.hidden = this.value === null
    this.pill.textContent = this.value === null ? "?" : this.number
    setAttributes(this.pill, {
      "aria-valuemin": start,
      "aria-valuemax": end,
      "aria-valuenow": this.value ?? (start + end) / 2,
    })
    setAttributes(this.pill, {"aria-valuetext": this.value === null ? "not set" : withUnit(this.number, this.unit)})
    for (const [i, truth] of this.truths.entries())
      this.#placeAt(/** @type {HTMLElement} */ (this.layer.children[i + 2]), truth)
    if (this.truths.length) requestAnimationFrame(() => this.#clear()) // runs after the clock's listener
  }

  /**
   * Moves the marker along its line so that it does not cover the plot's handles, flags and numbers, which are visible
   * again.
   */
  #clear() {
    const {left, top, height} = this.plot.frame
    const isX = this.which === "x"
    const low = isX ? top + height : left
    this.pill.style.setProperty("--low", long(low)) // shift from its position on the axis
    const own = this.pill.getBoundingClientRect()
    const standing = this.plot.host.querySelectorAll(".handles > *, text")
    const others = [...standing].map(one => one.getBoundingClientRect()).filter(({width}) => width)
    const ways = isX
      ? {down: Infinity, room: {...EVERYWHERE, bottom: own.bottom}}
      : {across: Infinity, room: {...EVERYWHERE, left: own.left}}
    const [place] = places([{wishes: [own], ...ways}], others)
    const way = place ? place.left - own.left + place.top - own.top : 0
    this.pill.style.setProperty("--low", long(low + way / unitSize()))
  }

  /** @param {HTMLElement} part @param {number} value */
  #placeAt(part, value) {
    const {left, top, width, height} = this.plot.frame
    const along = this.which === "x" ? this.plot.px(value) : this.plot.py(value)
    part.style.setProperty("--at", long(along))
    part.style.setProperty("--low", long(this.which === "x" ? top + height : left))
    part.style.setProperty("--high", long(this.which === "x" ? top : left + width))
  }

  /** Shows the right values next to the marked one. @param {number[]} truths */
  teach(truths) {
    this.truths = truths
    this.layer.classList.add("taught")
    this.pill.disabled = true
    this.pill.hidden = this.value === null // the visitor marked nothing
    const lines = truths.map(truth => element("i", {class: "line-mark true"}, this.#named(truth)))
    this.layer.append(...lines)
    this.place()
  }

  /** The number at a line, if there are several; a single one is on the card. @param {number} truth */
  #named(truth) {
    return this.truths.length > 1 ? element("b", {}, withUnit(this.#number(truth), this.unit)) : ""
  }

  leave() {
    this.observer.disconnect()
    this.plot.host.classList.remove("marked")
    this.layer.remove()
  }
}

// A hint, shown once, that a stage can be grabbed: on it or right over it, where nothing is drawn, moves, is read or
// pressed. Where there is no such place the transport says it.

import {element} from "../core/dom.js"
import {evaluate} from "../core/signals.js"

const MOMENT = 400 // ms without a further change
const INSTANTS = 24 // at which it is seen what is where
const CELL = 4 // pixels
const AIR = 6 // pixels around what is drawn
const BESIDE = 24 // pixels beside words, or the hint is read on from them
const CORNER = 28 // pixels of the button in the upper right corner
const OVER = 32 // pixels over the stage, where it does not stay in sight while the page scrolls
const WORDS = "Drag what moves, and let it go."
const WRITTEN = "h1, button, label, .item > div, .head" // what stands around a stage

/** @typedef {{left: number, right: number, top: number, bottom: number}} Box */

export class Hint {
  /** @type {number | undefined} */
  timer

  aside = "" // what the transport is to say

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    this.element = element("div", {class: "hint", hidden: ""}, WORDS)
    this.update = () => {
      this.element.hidden = true
      this.aside = ""
      clearTimeout(this.timer)
      this.timer = setTimeout(() => this.#place(), MOMENT)
    }
    this.observer = new ResizeObserver(this.update)
    for (const {host} of page.stages) this.observer.observe(host)
  }

  leave() {
    clearTimeout(this.timer)
    this.observer.disconnect()
    this.element.remove()
    this.page.hand.hint = undefined
  }

  #place() {
    if (this.page.left) return this.leave()
    const grip = this.page.root.querySelector(".block.stage > .grips > .grip.begins:not([hidden])")
    const host = grip?.parentElement?.parentElement
    if (!grip || !host || grip.closest("[inert], [hidden]")) return
    this.element.style.width = ""
    host.append(this.element)
    this.element.hidden = false
    const over = getComputedStyle(host).position === "sticky" ? 0 : OVER
    const taken = this.#taken(host.getBoundingClientRect(), over)
    const to = grip.getBoundingClientRect()
    const stands = [1, 0.6].some(share => {
      if (share < 1) this.element.style.width = `${share * this.element.offsetWidth}px`
      return this.#stand(host, taken, to)
    })
    this.element.hidden = !stands
    this.aside = stands ? "" : WORDS
    this.page.clock.touch()
  }

  /**
   * Where the hint has room, nearest to a grip; false where it has none.
   * @param {HTMLElement} host @param {Taken} taken @param {DOMRect} to
   */
  #stand(host, taken, to) {
    const {offsetWidth: width, offsetHeight: height} = this.element
    const own = host.getBoundingClientRect()
    const [x, y] = [to.left + to.width / 2 - own.left - width / 2, to.top + to.height / 2 - own.top - height / 2]
    let best = null
    let closest = Infinity
    for (let top = -taken.over; top <= own.height - height; top += CELL) {
      for (let left = 0; left <= own.width - width; left += CELL) {
        const far = Math.hypot(left - x, top - y)
        if (far >= closest || taken.any({left, right: left + width, top, bottom: top + height})) continue
        best = {left, top}
        closest = far
      }
    }
    if (best) this.element.style.translate = `${best.left}px ${best.top}px`
    return best !== null
  }

  /** What is drawn or written at any instant, seen from a stage. @param {DOMRect} own @param {number} over */
  #taken(own, over) {
    const {page} = this
    const {view} = page.shown
    const taken = new Taken(own.width, own.height, over)
    /** @param {DOMRect} box @param {number} air over and under it @param {number} [beside] it */
    const take = ({left, right, top, bottom, width, height}, air, beside = air) => {
      if (!width && !height) return
      const [x, y] = [own.left, own.top]
      taken.take({left: left - x - beside, right: right - x + beside, top: top - y - air, bottom: bottom - y + air})
    }
    taken.take({left: own.width - CORNER, right: own.width, top: 0, bottom: CORNER})
    const range = document.createRange()
    for (const part of page.paper.querySelectorAll(WRITTEN)) {
      range.selectNodeContents(part)
      take(range.getBoundingClientRect(), 1, BESIDE) // a line has air of its own
    }
    for (let i = 0; i < INSTANTS; i++) {
      const named = evaluate(view.signals, view.scalars, (page.clock.end * i) / INSTANTS)
      for (const stage of page.stages) stage.frame(named)
      for (const part of page.paper.querySelectorAll("svg.stage > g")) take(part.getBoundingClientRect(), AIR)
    }
    page.redraw()
    return taken
  }
}

/** @param {number} at @param {number} most */
const limit = (at, most) => Math.min(Math.max(at, 0), most)

/** The cells of a part of the page, and of so much over it, of which something is taken. */
class Taken {
  /** @param {number} width @param {number} height @param {number} over */
  constructor(width, height, over) {
    this.over = over
    this.across = Math.ceil(width / CELL)
    this.down = Math.ceil((height + over) / CELL)
    this.cells = new Uint8Array(this.across * this.down)
  }

  /** The cells that a box touches: first and last column, first and last row. @param {Box} box */
  #within({left, right, top, bottom}) {
    return [
      limit(Math.floor(left / CELL), this.across),
      limit(Math.ceil(right / CELL), this.across),
      limit(Math.floor((top + this.over) / CELL), this.down),
      limit(Math.ceil((bottom + this.over) / CELL), this.down),
    ]
  }

  /** @param {Box} box */
  take(box) {
    const [first, last, top, bottom] = this.#within(box)
    for (let row = top; row < bottom; row++) this.cells.fill(1, row * this.across + first, row * this.across + last)
  }

  /** Whether anything of a box is taken. @param {Box} box */
  any(box) {
    const [first, last, top, bottom] = this.#within(box)
    for (let row = top; row < bottom; row++) {
      const start = row * this.across
      if (this.cells.subarray(start + first, start + last).includes(1)) return true
    }
    return false
  }
}

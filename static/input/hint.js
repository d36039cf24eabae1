// A hint, shown once, that a stage can be grabbed: on it or right over it, where nothing is drawn, moves, is read or
// pressed. Where there is no such place the transport says it.

import {element} from "../core/dom.js"
import {evaluate} from "../core/signals.js"
import {places} from "../paper/places.js"

const MOMENT = 400 // ms without a further change
const INSTANTS = 24 // at which it is seen what is where
const AIR = 6 // pixels around what is drawn
const BESIDE = 24 // pixels beside words, or the hint is read on from them
const CORNER = 28 // pixels of the button in the upper right corner
const OVER = 32 // pixels over the stage, where it does not stay in sight while the page scrolls
const WORDS = "Drag what moves, and let it go."
const WRITTEN = "h1, button, label, .item > div, .head" // what stands around a stage

/** @typedef {import("../paper/places.js").Box} Box */

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
    const taken = this.#taken(host.getBoundingClientRect())
    const to = grip.getBoundingClientRect()
    const stands = [1, 0.65].some(share => {
      if (share < 1) this.element.style.width = `${share * this.element.offsetWidth}px`
      return this.#stand(host, taken, to, over)
    })
    this.element.hidden = !stands
    this.aside = stands ? "" : WORDS
    this.page.clock.touch()
  }

  /**
   * Where the hint has room, nearest to a grip; false where it has none.
   * @param {HTMLElement} host @param {Box[]} taken @param {DOMRect} to @param {number} over
   */
  #stand(host, taken, to, over) {
    const {offsetWidth: width, offsetHeight: height} = this.element
    const own = host.getBoundingClientRect()
    const [x, y] = [to.left + to.width / 2 - own.left, to.top + to.height / 2 - own.top]
    const wish = {left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2}
    const room = {left: 0, right: own.width, top: -over, bottom: own.height}
    const [place] = places([{wishes: [wish], across: Infinity, down: Infinity, room}], taken)
    if (place) this.element.style.translate = `${place.left}px ${place.top}px`
    return place !== null
  }

  /** The boxes of all that is drawn or written at any instant, seen from a stage. @param {DOMRect} own */
  #taken(own) {
    const {page} = this
    const {view} = page.shown
    /** @type {Map<string, Box>} each once */
    const taken = new Map()
    /** @param {DOMRect} box @param {number} air over and under it @param {number} [beside] it */
    const take = ({left, right, top, bottom, width, height}, air, beside = air) => {
      if (!width && !height) return
      const [x, y] = [own.left, own.top]
      const box = {left: left - x - beside, right: right - x + beside, top: top - y - air, bottom: bottom - y + air}
      taken.set(JSON.stringify(box), box)
    }
    take(new DOMRect(own.right - CORNER, own.top, CORNER, CORNER), 0)
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
    page.draw(page.clock.t) // before a hand can take what stood somewhere else
    return [...taken.values()]
  }
}

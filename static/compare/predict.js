// The list of parts that a visitor can cover before predicting them: the next change, a plot, a number.

import {button, element} from "../core/dom.js"
import {parts} from "./coverable.js"

/** The list next to its button. A second press, Escape or a press outside closes it. */
class CoverMenu {
  /** @param {PartHost} page @param {HTMLElement} opener */
  constructor(page, opener) {
    this.page = page
    this.opener = opener
    this.element = element("div", {class: "predict", role: "menu", "aria-label": "Hide until you press Reveal"})
    this.element.addEventListener("keydown", event => this.#move(event))
    opener.setAttribute("aria-expanded", "true")
    opener.after(this.element)
    this.#fill()
    this.gone = new AbortController()
    const {signal} = this.gone
    addEventListener("keydown", event => event.key === "Escape" && this.close(true), {signal})
    addEventListener("pointerdown", event => this.#elsewhere(event), {signal, capture: true})
  }

  #fill() {
    this.#add("next", "Everything that changes next")
    for (const {cover, text} of parts(this.page)) this.#add(cover, text)
    const [first] = this.element.children
    if (first instanceof HTMLElement) first.focus()
  }

  /** @param {string} cover @param {string} text */
  #add(cover, text) {
    const act = () => {
      this.page.compare.cover(cover)
      this.close(true)
    }
    this.element.append(button({role: "menuitem"}, act, text))
  }

  /** @param {KeyboardEvent} event */
  #move(event) {
    const items = [...this.element.children]
    const here = items.findIndex(item => item === document.activeElement)
    const to = {ArrowDown: here + 1, ArrowUp: here - 1, Home: 0, End: -1}[event.key]
    if (to === undefined) return
    event.preventDefault()
    event.stopPropagation()
    const item = items.at(to % items.length)
    if (item instanceof HTMLElement) item.focus()
  }

  /** @param {PointerEvent} event */
  #elsewhere(event) {
    const {target} = event
    if (target instanceof Node && !this.element.contains(target) && !this.opener.contains(target)) this.close(false)
  }

  /** @param {boolean} back true to return the focus to the button */
  close(back) {
    this.gone.abort()
    this.element.remove()
    this.opener.setAttribute("aria-expanded", "false")
    if (back) this.opener.focus()
    open = null
  }
}

/** @type {CoverMenu | null} */
let open = null

/** @param {PartHost} page @param {HTMLElement} opener */
export function choose(page, opener) {
  if (open) open.close(true)
  else open = new CoverMenu(page, opener)
}

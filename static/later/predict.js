// What a visitor can cover until a prediction has been made: what the next change shows, a plot, a number.

import {element} from "../dom.js"

/** The list, beside its button; a second press, Escape or a press elsewhere closes it. */
class Menu {
  /** @param {import("../page.js").Page} page @param {HTMLElement} button */
  constructor(page, button) {
    this.page = page
    this.button = button
    this.element = element("div", {class: "predict", role: "menu", "aria-label": "Cover until Reveal"})
    button.setAttribute("aria-expanded", "true")
    button.after(this.element)
    this.#fill()
    this.gone = new AbortController()
    const {signal} = this.gone
    addEventListener("keydown", event => event.key === "Escape" && this.close(true), {signal})
    addEventListener("pointerdown", event => this.#elsewhere(event), {signal, capture: true})
  }

  #fill() {
    const {plots, spec, stages} = this.page
    this.#add("next", "All that the next change changes")
    for (const {block, host, absent} of plots)
      if (!absent && host.offsetParent) this.#add(`plot:${block.name}`, block.title)
    for (const [name, text] of Object.entries(spec.spoken)) {
      const values = [...text.matchAll(/\{(\w+)\}/g)].map(([, value]) => `value:${value}`)
      if (values.length) this.#add(values[0], `Number: ${name}`)
    }
    if (stages.some(stage => stage.svg.role === "img")) this.#add("stage", "The motion of the apparatus")
    const [first] = this.element.children
    if (first instanceof HTMLElement) first.focus()
  }

  /** @param {string} cover @param {string} text */
  #add(cover, text) {
    const item = element("button", {type: "button", role: "menuitem"}, text)
    item.addEventListener("click", () => {
      this.page.compare.cover(cover)
      this.close(true)
    })
    this.element.append(item)
  }

  /** @param {PointerEvent} event */
  #elsewhere(event) {
    const {target} = event
    if (target instanceof Node && !this.element.contains(target) && !this.button.contains(target)) this.close(false)
  }

  /** @param {boolean} back the focus */
  close(back) {
    this.gone.abort()
    this.element.remove()
    this.button.setAttribute("aria-expanded", "false")
    if (back) this.button.focus()
    open = null
  }
}

/** @type {Menu | null} */
let open = null

/** @param {import("../page.js").Page} page @param {HTMLElement} button */
export function choose(page, button) {
  if (open) open.close(true)
  else open = new Menu(page, button)
}

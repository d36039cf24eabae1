// The live numbers of a page: texts that change with every picture, or with time.

import {coverNumber} from "../compare/cover.js"
import {reword} from "../core/dom.js"
import {fixed} from "../core/numbers.js"

export class Live {
  /** @type {Map<string, Element[]>} the elements of each number */
  elements = new Map()

  /** @type {Drawn["view"] | undefined} */
  view

  /** Finds the live numbers in a part that was added to the page. @param {Element} part */
  find(part) {
    for (const one of part.querySelectorAll("[data-value]")) {
      const name = one.getAttribute("data-value") ?? ""
      this.elements.set(name, [...this.#of(name).filter(other => other.isConnected), one])
      one.textContent = this.view?.values[name] ?? ""
    }
  }

  /** @param {string} name */
  #of(name) {
    return this.elements.get(name) ?? []
  }

  /** @param {string} name @param {string} text */
  tell(name, text) {
    for (const one of this.#of(name)) reword(one, text)
  }

  /** @param {Drawn} shown */
  update({view}) {
    this.view = view
    for (const name of this.elements.keys()) if (name in view.values) this.tell(name, view.values[name])
    for (const name of view.left_out) this.#of(name).forEach(coverNumber)
  }

  /** Called in each animation frame. @param {Named} named */
  draw(named) {
    for (const [name, [places, signed]] of Object.entries(this.view?.live ?? {}))
      this.tell(name, fixed(named[name], places, signed))
  }
}

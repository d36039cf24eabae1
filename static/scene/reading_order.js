// The order in which the Tab key and screen readers reach the parts of a page. On a desk it is the order in which the
// page is built. On smaller screens, where the styles stack the parts by their `order`, the parts move in the document.

import {viewOf} from "./views.js"

/** @param {Element} part */
const isFlat = part => getComputedStyle(part).display === "contents"

/** @param {Element} part */
const orderOf = part => Number(getComputedStyle(part).order)

/** @implements {Part} */
export class ReadingOrder {
  view = ""
  followed = "" // what was shown when the parts were last moved

  /** @type {Map<Element, Comment>} for each moved part, where it is on a desk */
  homes = new Map()

  /** @param {PartHost} page */
  constructor({root, paper, panel, sheet, views}) {
    this.root = root
    this.paper = paper
    this.panel = panel
    this.sheet = sheet.element
    this.views = views
    this.blocks = [...sheet.hosts.values()].filter(host => !host.matches(".row, .column"))
    this.observer = new ResizeObserver(() => this.arrange())
    this.observer.observe(root)
  }

  /** @param {Drawn} shown */
  update({settings}) {
    this.view = viewOf(settings)
  }

  /** Arranges the parts if another view, question or answer is shown. */
  follow() {
    if (this.followed === this.#shown()) return
    this.arrange()
    this.followed = this.#shown()
  }

  /** A card or a notice is another part of the panel or of the paper. */
  #shown() {
    return [this.root.className, this.view, this.panel.childElementCount, this.paper.childElementCount].join(" ")
  }

  /** Moves the parts to where the layout has them. The focus stays where it is. */
  arrange() {
    const focused = document.activeElement
    if (isFlat(this.sheet)) this.#stack()
    else for (const part of this.homes.keys()) this.#return(part)
    if (focused instanceof HTMLElement && focused !== document.activeElement) focused.focus({preventScroll: true})
  }

  /** Parts after the tabs move into the view, but the last parts of the panel stay there. */
  #stack() {
    const {paper, panel, sheet, views} = this
    for (const part of this.homes.keys()) if (!part.isConnected || this.#isApart(part)) this.#return(part)
    const parts = this.#sorted()
    const tabs = parts.findIndex(part => part === views.row || part === views.element)
    const last = parts.findLastIndex(part => this.#home(part).parentNode !== panel)
    for (const part of parts.slice(last + 1)) this.#return(part)
    this.#place(sheet, null, parts.slice(tabs + 1, last + 1))
    this.#place(paper, sheet, parts.slice(0, tabs + 1))
  }

  /** The parts from top to bottom; if two have the same order, as the page is built. */
  #sorted() {
    const {paper, panel, sheet, views, blocks} = this
    const holders = [paper, sheet, views.element, panel].filter(holder => holder === paper || isFlat(holder))
    const parts = new Set([...blocks, ...holders.flatMap(({children}) => Array.from(children))])
    const follows = (/** @type {Element} */ one, /** @type {Element} */ other) =>
      this.#home(one).compareDocumentPosition(this.#home(other)) & Node.DOCUMENT_POSITION_PRECEDING ? 1 : -1
    return [...parts]
      .filter(part => !isFlat(part))
      .map(part => ({part, order: orderOf(part)}))
      .toSorted((one, other) => one.order - other.order || follows(one.part, other.part))
      .map(({part}) => part)
  }

  /** @param {Element} part */
  #home(part) {
    return this.homes.get(part) ?? part
  }

  /** True if the panel or the head to which the part belongs is not stacked. @param {Element} part */
  #isApart(part) {
    const {parentElement} = this.#home(part)
    return (parentElement === this.panel || parentElement === this.views.element) && !isFlat(parentElement)
  }

  /** @param {Element} host @param {Element | null} next @param {Element[]} parts */
  #place(host, next, parts) {
    for (const part of parts.toReversed()) {
      if (part.parentNode !== host || part.nextElementSibling !== next) this.#move(part, host, next)
      next = part
    }
  }

  /** @param {Element} part @param {Element} host @param {Element | null} next */
  #move(part, host, next) {
    if (!this.homes.has(part)) {
      const home = document.createComment("")
      part.before(home)
      this.homes.set(part, home)
    }
    host.insertBefore(part, next)
  }

  /** Puts a part back where it is on a desk, unless it has left the page. @param {Element} part */
  #return(part) {
    const home = this.homes.get(part)
    if (part.isConnected) home?.replaceWith(part)
    else home?.remove()
    this.homes.delete(part)
  }

  leave() {
    this.observer.disconnect()
  }
}

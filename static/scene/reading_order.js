// The order in which the Tab key and screen readers reach the parts of a page. On a desk it is the order in which the
// page is built. On smaller screens, where the styles stack the parts by their `order`, the parts move in the document.

/** @param {Element} part */
const isFlat = part => getComputedStyle(part).display === "contents"

/** @param {Element} part */
const orderOf = part => Number(getComputedStyle(part).order)

export class ReadingOrder {
  /** @type {Map<Element, Comment>} for each moved part, its place in the page as it is built */
  places = new Map()

  /** @param {PartHost} page */
  constructor({paper, panel, sheet, views}) {
    this.paper = paper
    this.panel = panel
    this.view = sheet.element
    this.views = views
    this.blocks = [...sheet.hosts.values()].filter(host => !host.matches(".row, .column"))
  }

  /** Moves the parts if the layout has changed. The focus stays where it is. */
  follow() {
    const focused = document.activeElement
    if (isFlat(this.view)) this.#stack()
    else for (const part of this.places.keys()) this.#return(part)
    if (focused instanceof HTMLElement && focused !== document.activeElement) focused.focus({preventScroll: true})
  }

  /** Parts after the tabs move into the view, but the last parts of the panel stay there. */
  #stack() {
    const {paper, panel, view, views} = this
    for (const part of this.places.keys()) if (!part.isConnected || this.#isApart(part)) this.#return(part)
    const parts = this.#sorted()
    const tabs = parts.findIndex(part => part === views.row || part === views.element)
    const last = parts.findLastIndex(part => this.#home(part).parentNode !== panel)
    for (const part of parts.slice(last + 1)) this.#return(part)
    this.#place(view, null, parts.slice(tabs + 1, last + 1))
    this.#place(paper, view, parts.slice(0, tabs + 1))
  }

  /** The parts from top to bottom; if two have the same order, as the page is built. */
  #sorted() {
    const {paper, panel, view, views, blocks} = this
    const holders = [paper, view, views.element, panel].filter(holder => holder === paper || isFlat(holder))
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
    return this.places.get(part) ?? part
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
    if (!this.places.has(part)) {
      const place = document.createComment("")
      part.before(place)
      this.places.set(part, place)
    }
    host.insertBefore(part, next)
  }

  /** Returns a part to its place, unless it has left the page. @param {Element} part */
  #return(part) {
    const place = this.places.get(part)
    if (part.isConnected) place?.replaceWith(part)
    else place?.remove()
    this.places.delete(part)
  }
}

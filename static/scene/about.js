// The section "About these numbers": the errors of the drawn numbers, computed by components/scene/about.py. While it
// is open, it requests them again shortly after each change.

import {element, marked} from "../core/dom.js"

const MOMENT = 300 // ms after the last change

export class About {
  /** @type {number | undefined} */
  timer

  /** Called when `fold` is opened for the first time. @param {HTMLDetailsElement} fold @param {Send} send */
  constructor(fold, send) {
    this.send = send
    this.body = element("div", {class: "about-body"})
    this.element = fold
    fold.append(this.body)
    fold.addEventListener("toggle", () => this.#toggled())
    this.#toggled()
  }

  leave() {
    clearTimeout(this.timer)
  }

  #toggled() {
    this.arriving = this.element.open
    clearTimeout(this.timer)
    if (this.element.open) this.#ask()
  }

  update() {
    clearTimeout(this.timer)
    if (!this.element.open) return
    this.body.setAttribute("aria-busy", "true")
    this.timer = setTimeout(() => this.#ask(), MOMENT)
  }

  #ask() {
    this.body.setAttribute("aria-busy", "true")
    this.send({type: "about"})
  }

  /** @param {page.AboutNumbers} message the server's message */
  show({reading, tables, notes}) {
    this.body.replaceChildren(
      ...(reading ? [marked("p", {}, reading)] : []),
      ...tables.flatMap(({bound, rows}) => [
        marked("p", {class: "bound"}, bound),
        ...(rows.length ? [points(rows)] : []),
      ]),
      ...notes.map(note => marked("p", {}, note)),
    )
    this.body.removeAttribute("aria-busy")
    if (this.arriving) this.#reveal()
    this.arriving = false
  }

  // Scrolls the opened section to the top of the panel, as far as the panel scrolls.
  #reveal() {
    const panel = this.element.parentElement
    if (!panel) return
    panel.scrollTop += this.element.getBoundingClientRect().top - panel.getBoundingClientRect().top
  }
}

/** @param {page.AboutPoint[]} rows */
function points(rows) {
  const head = element(
    "tr",
    {},
    element("td", {}),
    element("th", {scope: "col"}, "shown, exact"),
    element("th", {scope: "col"}, "error, ulp"),
  )
  const lines = rows.flatMap((row, i) => [
    ...(row.place !== rows[i - 1]?.place
      ? [element("tr", {class: "place"}, marked("th", {colspan: 3, scope: "colgroup"}, row.place))]
      : []),
    element("tr", {}, marked("th", {scope: "row"}, row.name), numbers(row), element("td", {class: "off"}, row.off)),
  ])
  return element("table", {}, head, ...lines)
}

/** Two texts, one under the other. The part in which they differ is paler. @param {page.AboutPoint} point */
function numbers({drawn, true: exact}) {
  let same = 0
  while (same < drawn.length && drawn[same] === exact[same]) same++
  /** @param {string} text */
  const line = text => element("div", {}, text.slice(0, same), element("span", {}, text.slice(same)))
  return element("td", {class: "pair"}, line(drawn), line(exact))
}

// "About these numbers", folded away until asked for: what components/about.py knows of the errors of what is drawn.
// Asked again a moment after a change, while it is open.

import {element} from "../dom.js"

const MOMENT = 300 // ms without a further change

const html = (tag, attributes, markup) => Object.assign(element(tag, attributes), {innerHTML: markup})

export class About {
  // `fold` is the <details> that has just been opened for the first time.
  constructor(fold, send) {
    this.send = send
    this.body = element("div", {class: "about-body"})
    this.element = fold
    fold.append(this.body)
    fold.addEventListener("toggle", () => this.#toggled())
    this.#toggled()
  }

  #toggled() {
    this.arriving = this.element.open
    clearTimeout(this.timer)
    if (this.element.open) this.#ask()
  }

  changed() {
    clearTimeout(this.timer)
    if (!this.element.open) return
    this.body.setAttribute("aria-busy", "true")
    this.timer = setTimeout(() => this.#ask(), MOMENT)
  }

  #ask() {
    this.body.setAttribute("aria-busy", "true")
    this.send({type: "about"})
  }

  show({reading, tables, notes}) {
    this.body.replaceChildren(
      ...(reading ? [html("p", {}, reading)] : []),
      ...tables.flatMap(({bound, rows}) => [html("p", {class: "bound"}, bound), ...(rows.length ? [points(rows)] : [])]),
      ...notes.map(note => html("p", {}, note)))
    this.body.removeAttribute("aria-busy")
    if (this.arriving) this.#reveal()
    this.arriving = false
  }

  // What has just been unfolded starts at the top of the panel, as far as the panel scrolls.
  #reveal() {
    const panel = this.element.parentElement
    panel.scrollTop += this.element.getBoundingClientRect().top - panel.getBoundingClientRect().top
  }
}

function points(rows) {
  const head = element("tr", {}, element("td", {}), element("th", {scope: "col"}, "drawn, true"), element("th", {scope: "col"}, "off, ulp"))
  const lines = rows.flatMap((row, i) => [
    ...(row.place !== rows[i - 1]?.place ? [element("tr", {class: "place"}, html("th", {colspan: 3, scope: "colgroup"}, row.place))] : []),
    element("tr", {}, html("th", {scope: "row"}, row.name), numbers(row), element("td", {class: "off"}, row.off)),
  ])
  return element("table", {}, head, ...lines)
}

// One under the other; from where they part they are paler.
function numbers({drawn, true: exact}) {
  let same = 0
  while (same < drawn.length && drawn[same] === exact[same]) same++
  const line = text => element("div", {}, text.slice(0, same), element("span", {}, text.slice(same)))
  return element("td", {class: "pair"}, line(drawn), line(exact))
}

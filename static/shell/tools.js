// The tools of a scene: hold, predict, copy the link, save, and links to other scenes.

import {copyButton} from "../export/copy.js"
import {button, chip, element} from "../core/dom.js"
import {using} from "../later.js"

/** @typedef {import("../scene/plots.js").Plot | import("../scene/stage.js").Stage} Subject */

const SAVE =
  '<svg viewBox="0 0 16 16" width="1rem" height="1rem" aria-hidden="true" fill="none" stroke="currentColor"' +
  ' stroke-width="1.5"><path d="M8 2v8' +
  'M4.5 6.5 8 10l3.5-3.5M2.5 13.5h11"/></svg>'

export class Tools {
  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    const {sheet, plots, spec} = page
    const title = "The numbers of all plots as a CSV file; several tables come in one ZIP file"
    this.csv = chip("CSV", () => page.send({type: "csv", page: location.origin + location.pathname}), {title})
    const pictures = chip("Pictures", () => this.#take())
    for (const stage of sheet.stages.filter(({svg}) => svg.role === "img"))
      this.#takeable(stage.host, stage, stage.svg.getAttribute("aria-label") ?? "")
    for (const plot of plots) this.#takeable(plot.host.parentElement, plot, plot.block.title)
    const ways = spec.onward.map(way => this.#onward(way))
    this.same = element("div", {class: "chips"})
    const chips = element(
      "div",
      {class: "chips"},
      copyButton(() => page.link),
      this.csv,
      pictures,
      ...ways,
    )
    const away = element("details", {class: "fold away"}, element("summary", {}, "Save and share"), chips)
    this.element = element("div", {class: "tools"}, page.compare.hold, page.compare.predict, this.same, away)
  }

  /** @param {Drawn} shown */
  update({view: {onward}}) {
    this.same.replaceChildren(...onward.map(way => this.#onward(way)))
  }

  /**
   * A button for saving on a plot or a stage, for the pointer only; keyboard users have the button among the tools.
   * @param {HTMLElement | null} host @param {Subject} subject @param {string} name
   */
  #takeable(host, subject, name) {
    const title = "Save the picture, or read its table"
    const look = {class: "take", tabindex: -1, title, "aria-label": `${title}: ${name}`}
    const taking = button(look, () => this.#take(subject))
    taking.innerHTML = SAVE
    host?.append(taking)
  }

  /** @param {Subject} [subject] */
  #take(subject) {
    using("export/take", ({take}) => this.page.left || take(this.page, subject))
  }

  /** A link to another scene, with values of this one. @param {page.Onward} way */
  #onward({label, scene, given, taken}) {
    const link = element("a", {class: "chip", href: "#"}, label)
    link.addEventListener("click", event => {
      event.preventDefault()
      const {host, shown} = this.page
      const values = Object.fromEntries(Object.entries(taken).map(([name, own]) => [name, shown.settings[own].value]))
      host.open({scene, parameters: {...given, ...values}})
    })
    return link
  }
}

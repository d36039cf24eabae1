// The tools of a page: it is held or predicted, copied as a link, saved, and left for another scene.

import {copyButton} from "../export/copy.js"
import {button, chip, element} from "../core/dom.js"
import {using} from "../later.js"

/** @typedef {import("../paper/plots.js").Plot | import("../paper/stage.js").Stage} Subject */

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
    const chips = element(
      "div",
      {class: "chips"},
      copyButton(() => page.link),
      this.csv,
      pictures,
      ...ways,
    )
    const away = element("details", {class: "fold away"}, element("summary", {}, "Save and share"), chips)
    this.element = element("div", {class: "tools"}, page.compare.hold, page.compare.predict, away)
  }

  /**
   * A button on a plot or a stage, for the pointer; the keys have that among the tools.
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

  /** A link that takes values of this scene along to another. @param {page.Onward} way */
  #onward({label, scene, given, taken}) {
    const link = element("a", {class: "chip", href: "#"}, label)
    link.addEventListener("click", event => {
      event.preventDefault()
      const {host, shown} = this.page
      const values = Object.fromEntries(taken.map(name => [name, shown.settings[name].value]))
      host.open({scene, parameters: {...given, ...values}})
    })
    return link
  }

  /** @param {Drawn} shown */
  update({view}) {
    const blocks = this.page.plots.map(({block}) => block)
    this.csv.textContent = tables(blocks, view) > 1 ? "CSV (ZIP)" : "CSV"
  }
}

/**
 * The number of tables that the CSV export has: several are packed into one ZIP file (components/state/csv_export.py).
 * @param {page.PlotBlock[]} blocks @param {Drawn["view"]} view
 */
export function tables(blocks, view) {
  /** @type {Map<string, string>} the axis of each column */
  const axes = new Map()
  for (const {curves, regions, x, y} of blocks) {
    for (const curve of curves) axes.set(`${curve.source}.${curve.x}`, x).set(`${curve.source}.${curve.y}`, y)
    for (const {source, ...own} of regions)
      axes.set(`${source}.${own.x}`, x).set(`${source}.${own.low}`, y).set(`${source}.${own.high}`, y)
  }
  const heads = Object.entries(view.columns).map(([source, columns]) =>
    Object.keys(columns).filter(name => columns[name].length && (axes.get(`${source}.${name}`) ?? "") in view.axes),
  )
  return new Set(heads.filter(names => names.length).map(names => names.toSorted().join())).size
}

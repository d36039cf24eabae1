// The dialog for saving: each plot and the stage as a picture, the numbers as a table.

import {button, chip, element} from "../core/dom.js"
import {save} from "./save.js"
import {description, table} from "../scene/describe.js"
import {plotPicture, png, stagePicture} from "./picture.js"
import {things} from "./things.js"

/**
 * @typedef {import("../scene/plots.js").Plot} Plot
 * @typedef {import("../scene/stage.js").Stage} Stage
 */

/**
 * A plot or stage that can be saved: its names for the file and the button, and functions that draw and describe it.
 * @typedef {{subject: Plot | Stage, file: string, name: string, draw: () => import("./picture.js").Picture,
 *   says: () => string, table: (() => HTMLElement) | null}} Thing
 */

/**
 * Opens the dialog, in which `subject` is chosen first.
 * @param {PartHost} page @param {Plot | Stage} [subject]
 */
export function take(page, subject) {
  const all = choices(page)
  const first = all.find(one => one.subject === subject) ?? all[0]
  if (first) new Taking(page, all).open(first)
}

/** The visible parts of the page: the stages, then the plots. @param {PartHost} page @returns {Thing[]} */
function choices(page) {
  const {stages, plots} = things(page)
  return [
    ...stages.map((stage, i) => ({
      subject: stage,
      file: i ? `stage-${i + 1}` : "stage",
      name: i ? `Stage ${i + 1}` : "Stage",
      draw: () => stagePicture(stage, page),
      says: () => `${stage.svg.getAttribute("aria-label")}.`,
      table: null,
    })),
    ...plots.map(plot => ({
      subject: plot,
      file: plot.block.name,
      name: plot.block.brief,
      draw: () => plotPicture(plot),
      says: () => description(plot),
      table: () => table(plot),
    })),
  ]
}

class Taking {
  /** @param {PartHost} page @param {Thing[]} all */
  constructor(page, all) {
    this.page = page
    this.image = element("img", {alt: ""})
    this.says = element("p", {})
    this.table = element("div", {class: "points-room", tabindex: 0, role: "region", "aria-label": "Table"})
    this.choices = all.map(thing => this.#choice(thing))
    const close = button({class: "close", "aria-label": "Close"}, () => this.dialog.close(), "×")
    this.dialog = element(
      "dialog",
      {class: "taking", "aria-labelledby": "taking"},
      element("header", {}, element("h2", {id: "taking"}, "Save a picture or its numbers"), close),
      element("div", {class: "chips", role: "group", "aria-label": "Of"}, ...this.choices.map(one => one.chip)),
      element("div", {class: "chips"}, this.#save("PNG", ".png"), this.#save("SVG", ".svg")),
      this.image,
      this.says,
      this.table,
    )
    this.dialog.addEventListener("close", () => this.dialog.remove())
  }

  /** @param {Thing} first */
  open(first) {
    document.body.append(this.dialog)
    this.#show(first)
    this.dialog.showModal()
  }

  /** @param {Thing} thing */
  #choice(thing) {
    return {thing, chip: chip(thing.name, () => this.#show(thing))}
  }

  /** @param {Thing} thing */
  #show(thing) {
    this.thing = thing
    this.picture = thing.draw()
    this.image.src = `data:image/svg+xml,${encodeURIComponent(this.picture.svg)}`
    this.says.textContent = thing.says()
    this.table.hidden = !thing.table
    this.table.replaceChildren(...(thing.table ? [thing.table()] : []))
    for (const one of this.choices) one.chip.setAttribute("aria-pressed", String(one.thing === thing))
  }

  /** @param {string} name @param {".png" | ".svg"} kind */
  #save(name, kind) {
    return chip(name, async () => {
      const {thing, picture, page} = this
      if (!thing || !picture) return
      const content = kind === ".png" ? await png(picture) : new Blob([picture.svg], {type: "image/svg+xml"})
      save(`${page.spec.slug}-${thing.file}${kind}`, content, content.type)
    })
  }
}

// Prints a page: replaces it by its pictures, in the light theme, on one sheet of paper per scene.

import {element} from "../core/dom.js"
import {instant, link, parameters} from "./caption.js"
import {plotPicture, plotsUnder, stagePicture} from "./picture.js"
import {things} from "./things.js"

export class Print {
  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    this.before = () => this.#lay()
    this.after = () => this.sheet?.remove()
    addEventListener("beforeprint", this.before)
    addEventListener("afterprint", this.after)
  }

  leave() {
    removeEventListener("beforeprint", this.before)
    removeEventListener("afterprint", this.after)
    this.sheet?.remove()
  }

  #lay() {
    this.sheet?.remove()
    if (document.querySelector(".handout")) return
    const {page} = this
    page.redraw()
    page.draw(page.clock.t) // so that the numbers in texts and the pictures show the same time
    const {stages, plots} = things(page)
    const under = stages.map(stage => plotsUnder(stage, page))
    const style = under.flat().length ? "wide" : ""
    const drawn = plots.filter(plot => !under.flat().includes(plot))
    const pictures = [
      ...stages.map(stage => shown(stagePicture(stage, page, false), style)),
      ...drawn.map(plot => shown(plotPicture(plot, false))),
    ]
    this.sheet = element(
      "div",
      {class: "printed", "data-theme": "light"},
      element("h1", {}, page.spec.headline),
      element("div", {class: "printed-pictures"}, ...pictures),
      element("div", {class: "printed-words"}, ...words(page.paper)),
      element("p", {}, [instant(page), ...parameters(page)].filter(Boolean).join(", ")),
      element("p", {}, link(page)),
    )
    document.body.append(this.sheet)
  }
}

/** A picture as wide as its container. @param {import("./picture.js").Picture} picture @param {string} [style] */
export function shown({svg}, style) {
  const host = element("div", {class: style})
  host.innerHTML = svg
  for (const attribute of ["width", "height"]) host.firstElementChild?.removeAttribute(attribute)
  return host
}

/** The visible sentences, formulas and tables, without the task. @param {HTMLElement} paper */
function words(paper) {
  const blocks = [...paper.querySelectorAll(".block.words:not(.task), .block.table")]
  const seen = blocks.filter(block => block instanceof HTMLElement && block.offsetParent !== null)
  return seen.map(block => {
    const copy = /** @type {HTMLElement} */ (block.cloneNode(true))
    copy.removeAttribute("style")
    return copy
  })
}

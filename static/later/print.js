// The page on paper: made of its pictures when it is printed, one sheet a scene, in ink.

import {element} from "../dom.js"
import {instant, link, parameters} from "./given.js"
import {plotPicture, stagePicture} from "./picture.js"
import {things} from "./things.js"

export class Print {
  /** @param {import("../page.js").Page} page */
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
    const {stages, plots} = things(page)
    const drawn = plots.filter(plot => !stages.some(stage => isUnder(plot, stage)))
    const pictures = [
      ...stages.map(stage => stagePicture(stage, page, false)),
      ...drawn.map(plot => plotPicture(plot, false)),
    ]
    this.sheet = element(
      "div",
      {class: "printed", "data-theme": "light"},
      element("h1", {}, page.spec.headline),
      element("div", {class: "printed-pictures"}, ...pictures.map(shown)),
      element("div", {class: "printed-words"}, ...words(page.paper)),
      element("p", {}, [instant(page), ...parameters(page)].filter(Boolean).join(", ")),
      element("p", {}, link(page)),
    )
    document.body.append(this.sheet)
  }
}

/**
 * @param {import("../plots.js").Plot} plot
 * @param {import("../stage.js").Stage} stage
 */
const isUnder = (plot, stage) => plot.host.closest(".column") === stage.host.parentElement

/** @param {import("./picture.js").Picture} picture */
function shown({svg}) {
  const host = element("div", {})
  host.innerHTML = svg
  for (const attribute of ["width", "height"]) host.firstElementChild?.removeAttribute(attribute)
  return host
}

/** The sentences, formulas and tables that are seen, but for the task. @param {HTMLElement} paper */
function words(paper) {
  const blocks = [...paper.querySelectorAll(".block.words:not(.task), .block.table")]
  const seen = blocks.filter(block => block instanceof HTMLElement && block.offsetParent !== null)
  return seen.map(block => {
    const copy = /** @type {HTMLElement} */ (block.cloneNode(true))
    copy.removeAttribute("style")
    return copy
  })
}

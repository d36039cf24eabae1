// Covers for plots and numbers that the visitor has to predict. The server does not send the numbers under them.

import {chip, element, long} from "../core/dom.js"

const FIGURE_SPACE = "\u2007"

const LONGEST = 16 // characters; a longer text becomes a single "?", because a blank cannot wrap

/** Replaces a number by "?", padded to its width. @param {Element} number */
export function coverNumber(number) {
  const {length} = number.textContent ?? ""
  const side = FIGURE_SPACE.repeat(length > LONGEST ? 0 : Math.floor(Math.max(length - 1, 0) / 2))
  number.textContent = `${side}?${side}`
}

/** Parts of a drawing that would reveal the answer while the stage is covered. On the page, sketch.css hides them. */
export const REVEALING = ".revealing, .shaft, .shaft + .fill, text:has([data-value])"

const NAMED = new Set(["text", "circle", "wave"])

/** The plots that are covered, by name. @param {page.State} state */
export const coveredPlots = ({covered}) =>
  covered.filter(name => name.startsWith("plot:")).map(name => name.slice("plot:".length))

/** @param {{block: page.PlotBlock, shown: Drawn}} plot */
export const isCovered = ({block, shown}) => coveredPlots(shown.state).includes(block.name)

/**
 * True if a shape would reveal a hidden quantity: if it uses one, if it is a text, dot or wave on a plot's scale that
 * does not show given values, or if it is inside a plot.
 * @param {{spec: page.AnyShape, needs: Set<string>, plots: Set<string>}} shape
 * @param {string[]} leftOut @param {string[]} covered plots
 */
export function tells({spec, needs, plots}, leftOut, covered) {
  const isNamed = NAMED.has(spec.kind) && !spec.style.includes("given") && covered.some(plot => plots.has(plot))
  return isNamed || covered.includes(spec.inside) || leftOut.some(name => needs.has(name))
}

export class Cover {
  /** @type {HTMLElement | undefined} */
  element

  /** @param {PlotHost} plot */
  constructor(plot) {
    this.plot = plot
  }

  update() {
    const {block, host} = this.plot
    const stands = isCovered(this.plot)
    if (stands && !this.element) {
      const act = () => this.plot.page.compare.reveal(`plot:${block.name}`)
      const reveal = chip("Reveal", act, {"aria-label": `Reveal ${block.title}`})
      this.element = element("div", {class: "cover"}, element("span", {}, "Covered. What do you expect?"), reveal)
      host.append(this.element)
    }
    if (this.element) this.element.hidden = !stands
    this.place()
  }

  /** Covers only the frame, because predicting needs the axes. */
  place() {
    const {left, top, width, height} = this.plot.frame
    for (const [side, size] of Object.entries({left, top, width, height})) {
      this.element?.style.setProperty(side, long(size))
    }
  }
}

// The picture of a chain under the curves of a plot: one column per mass, coloured by its displacement, with the time
// axis down. It is painted only after a change.

import {isCovered} from "../compare/cover.js"
import {colour, element, long, svg} from "../core/dom.js"
import {displaced} from "../core/modal.js"
import {clamp} from "../core/ruler.js"

const ROWS = 240
const MOST = 30_000 // largest number of points of the picture, because each is a sum over all modes
const SHADE = 0.7 // exponent of the shade, so that small ripples are visible

export class Field {
  /** @type {Drawn["view"]["signals"] | null} the signals of the current picture */
  drawn = null

  /** @param {import("./plots.js").Plot} plot */
  constructor(plot) {
    this.plot = plot
    this.canvas = element("canvas", {class: "field", "aria-hidden": "true"})
    plot.host.prepend(this.canvas)
  }

  update() {
    const {plot} = this
    const signal = plot.view.signals[plot.block.modal]
    const isShown = !plot.absent && signal?.kind === "modal" && !isCovered(plot)
    this.canvas.hidden = !isShown
    if (!isShown) return
    const {signals, scalars} = plot.view
    if (this.drawn === signals) return
    this.drawn = signals
    this.#paint(/** @type {page.Modal} */ (signal), scalars[plot.block.full])
  }

  /** @param {page.Modal} signal @param {number} full the displacement of full colour */
  #paint(signal, full) {
    const {canvas, plot} = this
    const count = signal.omega.length
    const rows = Math.round(Math.min(ROWS, MOST / count))
    Object.assign(canvas, {width: count, height: rows})
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"))
    const picture = context.createImageData(count, rows)
    const hues = ["m1", "m2"].map(rgb)
    const {start, end} = plot.y
    /** @type {page.Modal} */
    const still = {...signal, line: [signal.line[0], 0]} // the drift of a free chain is not drawn, as on the stage
    for (let row = 0, at = 0; row < rows; row++) {
      for (const x of displaced(still, end + ((start - end) * (row + 0.5)) / rows)) {
        picture.data.set(hues[x > 0 ? 0 : 1], at)
        picture.data[at + 3] = 255 * Math.min(Math.abs(x / full), 1) ** SHADE
        at += 4
      }
    }
    context.putImageData(picture, 0, 0)
  }

  /** The box of the columns; half a spacing stays free at a wall. @param {Canvas | PlotHost} plot */
  #box(plot) {
    const {top, height} = plot.frame
    const [left, right] = [plot.px(0.5), plot.px(this.canvas.width + 0.5)]
    return {left, top, width: right - left, height}
  }

  place() {
    for (const [side, size] of Object.entries(this.#box(this.plot))) this.canvas.style.setProperty(side, long(size))
  }

  /** The picture for a drawing of the plot. @param {Canvas} plot */
  image(plot) {
    const {left, top, width, height} = this.#box(plot)
    const box = {x: left, y: top, width, height, preserveAspectRatio: "none", style: "image-rendering: pixelated"}
    return svg("image", {...box, href: this.canvas.toDataURL()})
  }

  theme() {
    this.drawn = null
    this.update()
  }
}

/** A colour of the page as red, green and blue. @param {string} tint */
function rgb(tint) {
  const hex = colour(tint)
  return [1, 3, 5].map(i => clamp(parseInt(hex.slice(i, i + 2), 16), 0, 255))
}

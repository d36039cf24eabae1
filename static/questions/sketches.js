// The sketches of a class over each other, in faint ink, so that agreement is dark; the true curve is on top.

import {chip, element, unitSize, units} from "../core/dom.js"
import {bare} from "../core/plain.js"
import {toPlace, toSI} from "../core/ruler.js"

const FAINT = 0.1
const PASSED = 0.03 // opacity of sketches without the chosen feature

export class Sketches {
  /** @type {page.Tally | null} */
  tally = null

  /** @type {number} index of the chosen feature, whose sketches are dark; -1 for all */
  lit = -1

  band = false

  /** @param {import("./question.js").Question} question @param {HTMLElement} chips */
  constructor({step, plot, page}, chips) {
    this.step = step
    this.chips = chips
    this.plot = plot
    this.page = page
    page.root.classList.add("gallery")
    this.canvas = element("canvas", {class: "class-sketches", role: "img"})
    this.plot.host.prepend(this.canvas) // under the true curve
    this.observer = new ResizeObserver(() => this.#draw())
    this.observer.observe(this.plot.host)
    this.themes = new MutationObserver(() => this.#draw())
    this.themes.observe(document.documentElement, {attributeFilter: ["data-theme"]})
  }

  /** @param {page.Tally} tally @param {page.Lesson | null} lesson */
  update(tally, lesson) {
    this.tally = tally
    const {answered, sketches} = tally.now
    const some = sketches.length < answered ? `${sketches.length} of ` : ""
    this.canvas.setAttribute("aria-label", `${some}${answered} sketches of the class`)
    const kinds = lesson ? tally.features.map((name, i) => this.#kind(name, i)) : []
    const all = toggle(`All ${answered}`, this.lit < 0, () => this.#light(-1))
    const band = toggle("Middle 50 %", this.band, () => {
      this.#toggle()
      band.setAttribute("aria-pressed", String(this.band))
    })
    const lights = [all, ...kinds]
    for (const light of lights)
      light.addEventListener("click", () => {
        for (const other of lights) other.setAttribute("aria-pressed", String(other === light))
      })
    this.chips.append(...(lesson ? lights : []), band)
    if (lesson && answered && this.page.host.hall.on) this.page.heading.textContent = this.headline(tally)
    this.#draw()
  }

  /** The sketches of a class, in numbers. @param {page.Tally} tally */
  headline({features, now}) {
    const counts = features.map((name, i) => ({name, count: now.having[i] ?? 0}))
    const sorted = counts.toSorted((a, b) => b.count - a.count)
    const [best, worst] = [sorted[0], sorted[sorted.length - 1]]
    const all = `${now.answered} sketch${now.answered === 1 ? "" : "es"}`
    const first = `“${bare(best.name)}” is right in ${best.count} of ${all}`
    return best === worst ? first : `${first}, “${bare(worst.name)}” in ${worst.count}`
  }

  /** @param {page.Html} name @param {number} i */
  #kind(name, i) {
    return toggle(`${bare(name)} ${this.tally?.now.having[i] ?? 0}`, this.lit === i, () => this.#light(i))
  }

  /** @param {number} feature */
  #light(feature) {
    this.lit = feature
    this.#draw()
  }

  #toggle() {
    this.band = !this.band
    this.#draw()
  }

  #draw() {
    const {host, frame} = this.plot
    const dense = devicePixelRatio
    this.canvas.width = host.clientWidth * dense
    this.canvas.height = host.clientHeight * dense
    const ink = this.canvas.getContext("2d")
    if (!ink || !this.tally) return
    ink.scale(dense * unitSize(), dense * unitSize())
    ink.beginPath()
    ink.rect(frame.left, frame.top, frame.width, frame.height)
    ink.clip()
    const style = getComputedStyle(document.documentElement)
    ink.strokeStyle = style.getPropertyValue("--ink")
    ink.lineWidth = units("w1")
    for (const {curves, has} of this.tally.now.sketches) {
      ink.globalAlpha = this.lit < 0 || has[this.lit] ? Math.max(FAINT, 1 / this.tally.now.sketches.length) : PASSED
      for (const heights of Object.values(curves)) this.#line(ink, heights)
    }
    if (this.band) this.#middle(ink)
  }

  /**
   * A point in the frame, which is the same for all phones. @param {number} i @param {number} count @param {number}
   * height
   */
  #point(i, count, height) {
    const [across, up] = /** @type {[page.Ruler, page.Ruler]} */ (this.step.frame)
    const {plot} = this
    const [x, y] = [between(across, i / (count - 1)), between(up, height / 1000)]
    return /** @type {[number, number]} */ ([plot.px(toPlace(plot.x, x)), plot.py(toPlace(plot.y, y))])
  }

  /** Draws a sketch, with its gaps. @param {CanvasRenderingContext2D} ink @param {(number | null)[]} heights */
  #line(ink, heights) {
    ink.beginPath()
    let down = false
    for (const [i, height] of heights.entries()) {
      if (height !== null) ink[down ? "lineTo" : "moveTo"](...this.#point(i, heights.length, height))
      down = height !== null
    }
    ink.stroke()
  }

  /**
   * Fills the area between the lower and upper quartile of the heights at each x. @param {CanvasRenderingContext2D} ink
   */
  #middle(ink) {
    const [name] = this.step.curves
    const sketches = this.tally?.now.sketches.flatMap(({curves}) => (curves[name] ? [curves[name]] : [])) ?? []
    if (!sketches.length) return
    const count = sketches[0].length
    /** @param {number} share @param {number} i */
    const quartile = (share, i) => {
      const sorted = sketches.flatMap(curve => (curve[i] === null ? [] : [curve[i]])).toSorted((a, b) => a - b)
      return sorted.length ? sorted[Math.round(share * (sorted.length - 1))] : null
    }
    const low = Array.from({length: count}, (_, i) => quartile(0.25, i))
    const high = Array.from({length: count}, (_, i) => quartile(0.75, i))
    const edge = [...low.entries(), ...[...high.entries()].toReversed()]
    ink.globalAlpha = 0.25
    ink.fillStyle = ink.strokeStyle
    ink.beginPath()
    for (const [i, height] of edge) if (height !== null) ink.lineTo(...this.#point(i, count, height))
    ink.fill()
  }

  leave() {
    this.page.root.classList.remove("gallery")
    this.observer.disconnect()
    this.themes.disconnect()
    this.canvas.remove()
  }
}

/** A chip that is pressed or not. @param {string} words @param {boolean} pressed @param {() => void} act */
export const toggle = (words, pressed, act) => chip(words, act, {"aria-pressed": pressed})

/** The quantity in SI at a share of an axis. @param {page.Ruler} ruler @param {number} share */
const between = (ruler, share) => toSI(ruler, ruler.start + share * (ruler.end - ruler.start))

// The sketches of a class over each other, in faint ink, so that agreement is darkness; the true curve lies over them.

import {element, unitSize, units} from "../dom.js"

const FAINT = 0.1
const PASSED = 0.03 // what the chip in force leaves out

export class Sketches {
  /** @type {page.Tally | null} */
  tally = null

  /** @type {number} the feature that is lit, -1 for all */
  lit = -1

  band = false

  /** @param {import("./card.js").Card} card @param {page.StepCard} step @param {HTMLElement} chips */
  constructor(card, step, chips) {
    this.step = step
    this.chips = chips
    this.plot = /** @type {import("../plots.js").Plot} */ (card.page.plots.find(({block}) => block.name === step.plot))
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
    const {length} = tally.now.sketches
    this.canvas.setAttribute("aria-label", `${length} sketches of the class`)
    const kinds = lesson ? tally.features.map((name, i) => this.#kind(name, i)) : []
    const all = this.#chip(`All ${length}`, this.lit < 0, () => this.#light(-1))
    const band = this.#chip("Middle half", this.band, () => this.#toggle())
    this.chips.append(...(lesson ? [all, ...kinds] : []), band)
    this.#draw()
  }

  /** What the class drew, in numbers. @param {page.Tally} tally */
  headline({features, now}) {
    const counts = features.map((name, i) => ({name, count: now.sketches.filter(({has}) => has[i]).length}))
    const sorted = counts.toSorted((a, b) => b.count - a.count)
    const [best, worst] = [sorted[0], sorted[sorted.length - 1]]
    if (!best.count) return `None of ${now.sketches.length} drew any of what was looked for`
    return `${best.count} of ${now.sketches.length} drew “${plain(best.name)}”, ${worst.count} “${plain(worst.name)}”`
  }

  /** @param {page.Html} name @param {number} i */
  #kind(name, i) {
    const count = this.tally?.now.sketches.filter(({has}) => has[i]).length
    return this.#chip(`${plain(name)} ${count}`, this.lit === i, () => this.#light(i))
  }

  /** @param {string} words @param {boolean} pressed @param {() => void} act */
  #chip(words, pressed, act) {
    const chip = element("button", {type: "button", class: "chip", "aria-pressed": pressed}, words)
    chip.addEventListener("click", () => {
      act()
      const {parentElement} = chip
      for (const other of parentElement?.querySelectorAll("[aria-pressed]") ?? [])
        if (words !== "Middle half" && !other.textContent?.startsWith("Middle"))
          other.setAttribute("aria-pressed", "false")
      chip.setAttribute("aria-pressed", String(words === "Middle half" ? this.band : true))
    })
    return chip
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

  /** @param {number} i @param {number} count @param {number} height */
  #point(i, count, height) {
    const {left, top, width, height: tall} = this.plot.frame
    return /** @type {[number, number]} */ ([left + (width * i) / (count - 1), top + tall * (1 - height / 1000)])
  }

  /** Gaps stay gaps. @param {CanvasRenderingContext2D} ink @param {(number | null)[]} heights */
  #line(ink, heights) {
    ink.beginPath()
    let down = false
    for (const [i, height] of heights.entries()) {
      if (height !== null) ink[down ? "lineTo" : "moveTo"](...this.#point(i, heights.length, height))
      down = height !== null
    }
    ink.stroke()
  }

  /** Between the first and the third quarter of the heights at each place. @param {CanvasRenderingContext2D} ink */
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
    this.observer.disconnect()
    this.themes.disconnect()
    this.canvas.remove()
  }
}

/** A name without its markup. @param {page.Html} html */
function plain(html) {
  return (
    element("span", {}, new DOMParser().parseFromString(html, "text/html").body.textContent ?? "").textContent ?? ""
  )
}

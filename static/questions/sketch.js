// The sketch question: a curve to draw on the empty axes of a plot; a class's sketches are drawn over each other.

import {chip, element, marked} from "../core/dom.js"
import {features} from "./features.js"
import {chooser, labelled, text} from "./fields.js"
import {Pad} from "./pad.js"
import {Question, mark, plotOf} from "./question.js"
import {Sketches, toggle} from "./sketches.js"

/** @typedef {import("./question.js").Plot} Plot */

export class Sketch extends Question {
  static label = "Sketch"

  /** @param {Plot[]} plots */
  static fields(plots) {
    const curve = chooser("Curve", "curve", plots.flatMap(curvesOf))
    const rows = element("div", {class: "ask-answers"})
    const fill = () => rows.replaceChildren(...seen(plots, curve.querySelector("select")?.value).flatMap(featureFields))
    curve.addEventListener("change", fill)
    fill()
    return [curve, rows]
  }

  /**
   * The question from the form. The plot to sketch in is covered, otherwise its curve could be copied.
   * @param {HTMLFormElement} form @param {Plot[]} plots
   */
  static read(form, plots) {
    const [name, y] = text(form, "curve").split(".")
    const must = seen(plots, `${name}.${y}`).map((one, i) =>
      Object.assign(one, {
        at: numberOrText(text(form, `at-${i}`), one.at),
        is: numberOrText(text(form, `is-${i}`), one.is),
      }),
    )
    return {plot: name, curve: y, must, cover: [`plot:${name}`]}
  }

  again = "Draw again"

  counted = "a sketch"
  pad = new Pad(this.plot, this.step, this.walk.earlierAnswer?.curves ?? {}, () => this.changed())
  pens = this.step.curves.map((name, i) => toggle(`Draw ${name}`, i === 0, () => this.#take(name)))
  tools = element(
    "div",
    {class: "chips"},
    ...(this.pens.length > 1 ? this.pens : []),
    chip("Clear", () => this.pad.clear()),
  )
  hint = element(
    "p",
    {class: "hint"},
    "Draw on the empty axes. With keys: arrows move the pen, Enter lowers or lifts it.",
  )
  element = element("div", {class: "question"}, this.hint, this.pad.status, this.tools)

  /** @param {string} name */
  #take(name) {
    this.pad.take(name)
    for (const [i, pen] of this.pens.entries()) pen.setAttribute("aria-pressed", String(this.step.curves[i] === name))
  }

  said() {
    return this.counted
  }

  given() {
    const curves = this.pad.sent
    const isDrawn = Object.values(curves).some(heights => heights.filter(height => height !== null).length > 1)
    return isDrawn ? {curves} : null
  }

  /** @param {import("./question.js").Answer} given */
  restore({curves = {}}) {
    this.pad.restore(curves)
  }

  /** @param {page.Lesson} lesson */
  teach({findings}) {
    const found = this.given() ? findings : []
    this.counted = `${findings.filter(finding => finding.has).length} of ${findings.length} features`
    const rows = found.map(({has, name, words}) =>
      element("li", {}, mark(has), marked("b", {}, name), marked("span", {}, words)),
    )
    this.hint.remove()
    this.tools.replaceWith(element("ul", {class: "findings"}, ...rows))
    this.pad.teach(found)
  }

  update() {
    this.pad.place()
  }

  leave() {
    this.pad.leave()
  }

  /** @param {HTMLElement} chips */
  tally(chips) {
    return new Sketches(this, chips)
  }

  space() {
    return element("p", {class: "small"}, "Draw in the picture.")
  }
}

/** @param {Plot} plot */
const curvesOf = plot =>
  plot.block.curves
    .filter(curve => plot.view.columns[curve.source]?.[curve.y]?.length)
    .map(({y, read}) => ({value: `${plot.block.name}.${y}`, label: `${plot.block.brief}: ${read || y}`}))

/** The features of the curve that is chosen in the form. @param {Plot[]} plots @param {string} [named] */
function seen(plots, named = "") {
  const [name, y] = named.split(".")
  const plot = plotOf(plots, name)
  const curve = plot?.block.curves.find(one => one.y === y)
  return curve ? features(plot, curve) : []
}

/** The position of a feature, and its height. @param {{f: string, at: number, is: number}} feature @param {number} i */
const featureFields = ({f, at, is}, i) => [
  labelled(
    `${f === "value" ? "Height" : f === "peak" ? "Peak" : "Trough"} at, or an expression`,
    `at-${i}`,
    String(at),
  ),
  labelled("is, or an expression", `is-${i}`, String(is)),
]

/** A number, or an expression of the scene's. @param {string} typed @param {number} read off the curve */
const numberOrText = (typed, read) => (typed === "" ? read : Number.isNaN(Number(typed)) ? typed : Number(typed))

// The question that asks for a point on an axis of a plot. A class's answers are dots on that axis.

import {element} from "../core/dom.js"
import {withUnit} from "../core/numbers.js"
import {Dots} from "./dots.js"
import {answerFields, answerIn, chooser, labelled, text} from "./fields.js"
import {Marker} from "./marker.js"
import {Question, mark, plotOf} from "./question.js"

/** @typedef {import("./question.js").Plot} Plot */

export class AxisPlace extends Question {
  static label = "Point on an axis"

  /** @param {Plot[]} plots */
  static fields(plots) {
    const axes = plots.flatMap(plot => [axis(plot, "x", "horizontal"), axis(plot, "y", "vertical")])
    return [chooser("Axis", "axis", axes), ...answerFields("Right place"), labelled("Tolerance (±)", "tol")]
  }

  /** @param {HTMLFormElement} form @param {Plot[]} plots */
  static read(form, plots) {
    const [name, which] = text(form, "axis").split(".")
    const {x, y} = plotOf(plots, name)
    return {axis: `${name}.${which}`, answer: answerIn(form, (which === "x" ? x : y).unit)}
  }

  marker = new Marker(this.plot, this.step, () => this.#moved())
  shown = element("p", {class: "hint", role: "status"}, "Press on the axis, or move the ? with the arrow keys.")
  element = element("div", {class: "question"}, this.shown)

  #moved() {
    this.shown.textContent = `Your mark: ${this.said()}`
    this.changed()
  }

  said() {
    return withUnit(this.marker.number, this.step.unit)
  }

  given() {
    return this.marker.value === null ? null : {value: this.marker.value}
  }

  /** @param {import("./question.js").Answer} given */
  restore({value}) {
    if (typeof value === "number") this.marker.setTo(value)
  }

  /** @param {page.Lesson} lesson */
  teach({right, places}) {
    if (right !== null) this.shown.append(" ", mark(right))
    else this.shown.textContent = "" // remove the hint on how to mark
    this.marker.teach(places)
  }

  update() {
    this.marker.place()
  }

  leave() {
    this.marker.leave()
  }

  tally() {
    return new Dots(this)
  }

  space() {
    return element("p", {class: "small"}, "Mark it in the picture.")
  }
}

/** @param {Plot} plot @param {string} which @param {string} way */
const axis = (plot, which, way) => ({value: `${plot.block.name}.${which}`, label: `${plot.block.brief}, ${way}`})

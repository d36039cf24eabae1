// The number of the compared picture, next to each stage label that has a live number.

import {setAttributes, svg} from "../core/dom.js"
import {fixed} from "../core/numbers.js"
import {moved} from "../scene/places.js"

const GAP = 9 // units between a label and the compared number

export class HeldNumber {
  /**
   * @param {import("../scene/stage.js").Stage} stage @param {SVGTextElement} label
   * @param {page.TextRun[]} words the label's number and the words after it @param {string} tint
   */
  constructor(stage, label, [{text: name}, ...rest], tint) {
    this.stage = stage
    this.label = label
    this.name = name
    this.rest = rest
    this.text = svg("text", {class: "halo"})
    this.group = svg("g", {class: tint}, this.text)
    this.group.style.display = "none"
    stage.svg.append(this.group)
    stage.collisions.labels.push({text: this.text, group: this.group, fixed: false, wishes: () => this.#wishes()})
  }

  /**
   * Shows the compared number, unless it equals the current one.
   * @param {Named} named the quantities of the compared picture @param {Drawn["view"]} view @param {string} prefix
   */
  frame(named, view, prefix) {
    const {label, name, rest} = this
    const digits = view.live[name]
    const isThere = Boolean(digits) && name in named && label.style.display !== "none"
    const held = isThere ? fixed(named[name], ...digits) : ""
    const now = label.querySelector("[data-value]")?.textContent
    const isShown = isThere && held !== now && label.parentElement?.style.display === ""
    this.group.style.display = isShown ? "" : "none"
    if (!isShown) return
    const after = rest.map(({kind, text}) => (kind === "value" ? (view.values[text] ?? "") : text)).join("")
    this.text.textContent = `${prefix} ${held}${after}`
  }

  /** Possible positions: to the right of the label, or above or below it if there is no room. */
  #wishes() {
    const {collisions, size} = this.stage
    const {left, right, top, bottom} = collisions.box(this.label)
    setAttributes(this.text, {x: right + GAP, y: this.label.getAttribute("y")})
    const beside = collisions.box(this.text)
    const line = bottom - top + 3
    const below = moved(beside, left - beside.left, bottom + line < size.H ? line : -line)
    const edge = size.narrow ? collisions.room.right : size.W // on a phone the plots are below the stage
    return beside.right <= edge ? [beside, below] : [below]
  }
}

/**
 * One compared number for each label of a stage with a moving number. @param {import("../scene/stage.js").Stage} stage
 */
export function heldNumbers(stage) {
  return stage.shapes.flatMap(({spec, parts: [label]}) => {
    if (spec.kind !== "text" || !(label instanceof SVGTextElement)) return []
    const words = spec.words.slice(spec.words.findIndex(({kind}) => kind === "value"))
    return words[0]?.kind === "value" ? [new HeldNumber(stage, label, words, spec.tint)] : []
  })
}

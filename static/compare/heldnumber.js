// The number that a label of a stage would show of the picture held, beside it.

import {set, svg} from "../core/dom.js"
import {fixed} from "../core/numbers.js"

const GAP = 9 // units between a label and the number held

export class HeldNumber {
  /**
   * @param {import("../paper/stage.js").Stage} stage @param {SVGTextElement} label
   * @param {page.TextRun[]} words its number,
   * and what follows that @param {string} tint
   */
  constructor(stage, label, [{text: name}, ...rest], tint) {
    this.stage = stage
    this.label = label
    this.name = name
    this.rest = rest
    this.text = svg("text", {class: "t0 halo held-number"})
    this.group = svg("g", {class: tint}, this.text)
    this.group.style.display = "none"
    stage.svg.append(this.group)
    stage.clear.labels.push({text: this.text, group: this.group, fixed: false})
  }

  /** Not where it would say the same. @param {Named} named the quantities held @param {Drawn["view"]} view */
  frame(named, view) {
    const {label, name, rest} = this
    const digits = view.live[name]
    const isThere = Boolean(digits) && name in named && label.style.display !== "none"
    const held = isThere ? fixed(named[name], ...digits) : ""
    const now = label.querySelector("[data-value]")?.textContent
    const isShown = isThere && held !== now && label.parentElement?.style.display === ""
    this.group.style.display = isShown ? "" : "none"
    if (!isShown) return
    const after = rest.map(({kind, text}) => (kind === "value" ? (view.values[text] ?? "") : text)).join("")
    this.text.textContent = `held ${held}${after}`
    set(this.text, this.#place())
  }

  /** To the right of the label, or under or over it where the stage ends or another label stands. */
  #place() {
    const {clear, size} = this.stage
    const {left, right, top, bottom} = clear.box(this.label)
    const {left: start, right: end} = clear.box(this.text)
    const y = Number(this.label.getAttribute("y"))
    const line = bottom - top + 3
    const beside = {x: right + GAP, y}
    const below = {x: left, y: y + (y + line < size.H ? line : -line)}
    const edge = size.narrow ? clear.room.right : size.W // nothing stands beside a stage on a phone
    const isIn = right + GAP + end - start <= edge
    return isIn && this.#isFree({left: right + GAP, right: right + GAP + end - start, top, bottom}) ? beside : below
  }

  /** @param {import("../paper/clear.js").Box} box */
  #isFree(box) {
    const {clear} = this.stage
    const others = clear.labels.filter(({text, group}) => {
      const isOwn = text === this.label || text === this.text || text.classList.contains("held-number")
      return !isOwn && group.style.display === "" && text.style.display === ""
    })
    return !others.some(({text}) => {
      const {left, right, top, bottom} = clear.box(text)
      return left < box.right && box.left < right && top < box.bottom && box.top < bottom
    })
  }
}

/** Of each label of a stage whose number moves. @param {import("../paper/stage.js").Stage} stage */
export function heldNumbers(stage) {
  return stage.shapes.flatMap(({spec, parts: [label]}) => {
    if (spec.kind !== "text" || !(label instanceof SVGTextElement)) return []
    const words = spec.words.slice(spec.words.findIndex(({kind}) => kind === "value"))
    return words[0]?.kind === "value" ? [new HeldNumber(stage, label, words, spec.tint)] : []
  })
}

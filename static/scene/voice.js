// Announcements for screen readers: the description of a plot, and the effect of a change, in one sentence.

import {isCovered} from "../compare/cover.js"
import {element} from "../core/dom.js"
import {description, spoken} from "./describe.js"

const MOMENT = 700 // ms without a further change, so that a drag is announced when it ends

export class Voice {
  /** @type {number | undefined} */
  timer

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    this.status = element("p", {class: "heard", role: "status"})
    page.root.append(this.status)
    this.describe()
    this.parameters = JSON.stringify(page.shown.state.parameters)
    this.lastNumbers = this.#numbers()
  }

  leave() {
    clearTimeout(this.timer)
  }

  update() {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => this.#speak(), MOMENT)
  }

  describe() {
    for (const plot of this.page.plots) {
      if (!plot.absent) plot.figure.says.textContent = description(plot)
    }
  }

  #speak() {
    this.describe()
    const now = this.#numbers()
    const parameters = JSON.stringify(this.page.shown.state.parameters)
    if (parameters !== this.parameters) this.status.textContent = changedNumbers(this.lastNumbers, now)
    this.parameters = parameters
    this.lastNumbers = now
  }

  /** The numbers to announce, by name: those of the scene and of the visible plots, without hidden ones. */
  #numbers() {
    const {plots, shown, spec} = this.page
    const visible = plots.filter(plot => !plot.absent && !isCovered(plot))
    return spoken(Object.assign({}, spec.spoken, ...visible.map(({block}) => block.says)), shown.view.values)
  }
}

/**
 * "slow mode 1.22 rad/s, was 1.00 rad/s; unchanged: fast mode".
 * @param {Map<string, string>} before @param {Map<string, string>} now
 */
export function changedNumbers(before, now) {
  const names = [...now.keys()]
  const moved = names.filter(name => now.get(name) !== before.get(name))
  const still = names.filter(name => !moved.includes(name))
  const parts = moved.map(name => `${name} ${now.get(name)}${before.has(name) ? `, was ${before.get(name)}` : ""}`)
  if (still.length) parts.push(`unchanged: ${still.join(", ")}`)
  const sentence = parts.join("; ")
  return sentence && `${sentence[0].toUpperCase()}${sentence.slice(1)}.`
}

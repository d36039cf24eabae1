// The bar of a scene that measures run times, in place of the transport: run or cancel, progress, skip.

import {button, chip, element} from "../core/dom.js"
import {Fit, icon} from "../controls/transport.js"

export class RunBar {
  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    const run = () => page.send({type: "run", order: this.busy ? "cancel" : "start"})
    this.disc = button({class: "icon play"}, run)
    this.name = element("b", {})
    this.count = element("span", {class: "count"})
    this.bar = element("progress", {max: 1, value: 0, "aria-label": "Runs done"})
    this.note = element("span", {class: "note", role: "status"})
    this.skip = chip("Skip this method", () => page.send({type: "run", order: "skip"}))
    this.fit = new Fit(page)
    this.element = element(
      "div",
      {class: "transport"},
      this.disc,
      this.name,
      this.count,
      this.bar,
      this.note,
      this.skip,
      this.fit.element,
    )
  }

  /** @param {Drawn} shown */
  update(shown) {
    const {progress, errors} = shown
    const {notes} = shown.view
    this.fit.update(shown)
    if (!progress) return
    const {state, done, total, unit, text} = progress
    this.busy = state === "running" || state === "waiting"
    const name = this.busy ? "Cancel" : done ? "Run again" : "Run"
    this.disc.setAttribute("aria-label", name)
    this.disc.innerHTML = icon(this.busy ? "stop" : "play")
    this.name.textContent = name
    this.count.textContent = total ? `${done} of ${total} ${unit}` : ""
    this.bar.value = total ? done / total : 0
    const watch = this.busy ? "" : this.page.controls.presets.watch(shown.preset)
    this.note.textContent = [this.page.compare.says(shown.state), watch || text, errors.run, ...notes]
      .filter(Boolean)
      .join(" ")
    this.skip.hidden = state !== "running"
  }
}

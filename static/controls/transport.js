// The transport: play, step, restart, speed and time window.

import {button, chip, element, reword} from "../core/dom.js"
import {MINUS, grouped, short} from "../core/numbers.js"

/** @typedef {keyof typeof ICONS} Icon */
const ICONS = {
  restart: "M5 5h2.4v14H5zM19 5v14L8.6 12z",
  back: "M16.5 6v12l-9-6zM18 6h2v12h-2z",
  forward: "M7.500 6v12l9-6zM4 6h2v12H4z",
  stop: "M8 8h8v8H8z",
  play: "M8 5.500v13l11-6.500z",
  pause: "M7.500 5.500h3.200v13H7.500zM13.300 5.500h3.200v13h-3.200z",
}

/** @param {Icon} name */
export const icon = name =>
  `<svg viewBox="0 0 24 24" width="1.375rem" height="1.375rem" aria-hidden="true"><path d="${ICONS[name]}"/></svg>`

/** @param {string} name @param {string} drawing @param {() => void} act @param {string} [style] */
function key(name, drawing, act, style = "icon") {
  const made = button({class: style, "aria-label": name, title: name}, act)
  made.innerHTML = drawing
  return made
}

/** A factor as text: powers of two from 1/16 to 16 as 4× or 1/4×, others with two digits. @param {number} factor */
function factorText(factor) {
  for (const power of [1, 2, 4, 8, 16]) {
    if (factor === power) return `${power}×`
    if (factor === 1 / power) return `1/${power}×`
  }
  return `${short(factor, 2).replace(/^1·/, "")}×`
}

/** The live number "speed": how fast the motion is played, unless in real time. @param {number} factor */
function speedText(factor) {
  if (Math.abs(factor - 1) < 1e-9) return ""
  const times = Math.max(factor, 1 / factor)
  return `played ${grouped(times)} times ${factor < 1 ? "slower" : "faster"}`
}

/** The button Fit, visible if the axes are not fitted to the picture. Its space stays reserved. */
export class Fit {
  /** @param {PartHost} page */
  constructor(page) {
    const look = {class: "chip fit", title: "Fit axes, time window and speed (0)"}
    this.element = chip("Fit", () => page.host.fit(), look)
    page.paper.addEventListener("dblclick", event => {
      if (event.target instanceof Element && event.target.closest(".plot-area")) page.host.fit()
    })
  }

  /** @param {Drawn} shown */
  update({state}) {
    this.element.classList.toggle("fitted", !state.frame)
  }
}

export class Transport {
  /** @type {string | undefined} */
  problem

  /** @type {string[]} */
  notes = []

  isPlaying = true // the state that the button shows

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    const {clock} = page
    this.play = key("Pause", icon("pause"), () => clock.toggle(), "icon play")
    this.auto = key("Auto speed", "Auto", () => clock.auto(), "")
    this.factor = element("span", {class: "factor", title: "Seconds of motion shown in one second"})
    this.window = element("input", {
      name: "window",
      inputmode: "decimal",
      autocomplete: "off",
      "aria-label": "Time window, in seconds",
      placeholder: "auto",
    })
    this.window.addEventListener("change", () => page.send({type: "typed", name: "window", text: this.window.value}))
    this.note = element("div", {class: "note", role: "status"})
    this.fit = new Fit(page)
    this.element = element(
      "div",
      {class: "transport"},
      key("Restart", icon("restart"), () => clock.seek(0)),
      key("Step back", icon("back"), () => clock.step(-1), "icon back"),
      this.play,
      key("Step forward", icon("forward"), () => clock.step(1), "icon forward"),
      element(
        "div",
        {class: "seg speeds", role: "group", "aria-label": "Speed"},
        this.auto,
        key("Slower", MINUS, () => clock.faster(-1), ""),
        this.factor,
        key("Faster", "+", () => clock.faster(1), ""),
      ),
      this.note,
      this.fit.element,
      element("label", {class: "window", "data-name": "window"}, "Window, s ", this.window),
    )
    clock.listeners.push(() => this.refresh())
  }

  /** @param {Drawn} shown */
  update(shown) {
    const {axes, time, notes} = shown.view
    const {settings, errors} = shown
    this.fit.update(shown)
    const axis = axes[time]
    // Disable the buttons if nothing moves.
    this.element.classList.toggle("idle", !axis)
    this.notes = [this.page.compare.says(shown.state), this.page.controls.presets.watch(shown.preset), ...notes]
    const error = errors.window
    this.window.classList.toggle("bad", Boolean(error))
    this.window.title = error ?? "Leave empty for automatic"
    this.problem = error
    if (document.activeElement !== this.window || !error) {
      if (!error && !this.page.waiting.has("window")) this.window.value = settings.window.text
      this.window.placeholder = axis ? short(axis.end * 10 ** axis.exponent) : "auto"
    }
    this.refresh()
  }

  refresh() {
    const {clock} = this.page
    if (this.isPlaying !== clock.playing) {
      this.isPlaying = clock.playing
      const name = clock.playing ? "Pause" : "Play"
      this.play.title = name
      this.play.setAttribute("aria-label", name)
      this.play.innerHTML = icon(clock.playing ? "pause" : "play")
    }
    this.auto.classList.toggle("here", clock.choice === "auto")
    this.auto.setAttribute("aria-pressed", String(clock.choice === "auto"))
    const factor = factorText(clock.factor)
    reword(this.factor, factor)
    this.page.live.tell("speed", speedText(clock.factor))
    const lines = [
      this.problem,
      clock.slowed ? `Slowed to ${factor}, so that the fast motion can be seen.` : "",
      ...this.notes,
    ]
    if (!reword(this.note, lines.filter(Boolean).join(" "))) return
    // A scrollable area must be reachable by keys.
    if (this.note.scrollHeight > this.note.clientHeight) this.note.tabIndex = 0
    else this.note.removeAttribute("tabindex")
  }
}

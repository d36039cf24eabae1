// Hall mode: large type and thick lines, and a folded panel. It is part of the link, not of the state.

import {button, element} from "../core/dom.js"
import {later} from "../later.js"
import {tabStorage} from "../core/storage.js"
import {follow} from "../walks/steps.js"

const FULL = "full-screen"
const WALK = "data-in-walk"
const root = document.documentElement

export class Hall {
  /** @type {HTMLElement | undefined} the hint that the next key press will open full screen */
  offer

  /**
   * @type {BroadcastChannel | undefined} receives messages from a separate window with the contents; open since hall
   * mode was first on
   */
  steps

  /** @param {LectureHost} lecture */
  constructor(lecture) {
    this.lecture = lecture
    addEventListener("pagehide", () => tabStorage.keep(FULL, document.fullscreenElement ? "was" : ""))
    if (tabStorage.text(FULL) === "was" && !document.fullscreenElement) this.#offer()
    if (this.on) this.#point()
  }

  get on() {
    return root.dataset.mode === "projector"
  }

  /** The part of the address for hall mode. */
  get ending() {
    return this.on ? "&projector" : ""
  }

  toggle() {
    if (this.on) delete root.dataset.mode
    else root.dataset.mode = "projector"
    delete root.dataset.panel
    this.lecture.page.place()
    this.lecture.readdress()
    this.#point()
    this.shown(this.lecture.page)
  }

  /** A walk has smaller text, because its card needs room. @param {page.State} state */
  applyStep({step}) {
    if (root.hasAttribute(WALK) === Boolean(step)) return
    root.toggleAttribute(WALK, Boolean(step))
    if (this.on) this.lecture.page?.place()
  }

  /** Shows the values in one line while the panel is folded away. @param {PartHost} page */
  async shown(page) {
    if (!this.on) return
    const {values} = await later("shell/hall_values")
    values(page)
  }

  /** The tab that opens the folded panel. */
  tab() {
    return button({class: "tab"}, () => this.fold(), "Controls, key C")
  }

  /** Opens the panel, or folds it behind its tab. */
  fold() {
    const {panel} = this.lecture.page
    root.dataset.panel = panel.classList.contains("folded") || isFolded(panel) ? "open" : "folded"
    this.lecture.page.place()
  }

  /** Opens full screen. It lasts when the scene or step changes, because the page is not loaded again. */
  async full() {
    if (document.fullscreenElement) await document.exitFullscreen()
    else await root.requestFullscreen?.().catch(() => {})
  }

  /** Opens full screen again after a reload, at the next key or press, because browsers allow it only then. */
  #offer() {
    this.offer = element("p", {class: "offer", role: "status"}, "Press a key to go back to full screen.")
    document.body.append(this.offer)
    const pressed = new AbortController()
    const end = (/** @type {Event} */ event) => {
      pressed.abort()
      this.offer?.remove()
      const leaves = event instanceof KeyboardEvent && (event.key === "Escape" || event.key.toLowerCase() === "f")
      if (!leaves && event instanceof KeyboardEvent) this.full()
    }
    for (const kind of ["keydown", "pointerdown"]) addEventListener(kind, end, {capture: true, signal: pressed.signal})
  }

  async #point() {
    if (!this.on) return
    this.steps ??= follow(this.lecture)
    const {pointer} = await later("controls/pointer")
    pointer()
  }
}

/** @param {HTMLElement} panel */
const isFolded = panel => getComputedStyle(panel).getPropertyValue("--folded").trim() === "1"

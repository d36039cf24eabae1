// The hall: type and lines that the last row reads, the panel folded away. It is part of the link, not of the state.

import {button, element} from "../core/dom.js"
import {later} from "../later.js"
import {tabStorage} from "../core/storage.js"
import {follow} from "../walks/steps.js"

const FULL = "full-screen"
const WALK = "data-in-walk"
const root = document.documentElement

export class Hall {
  /** @type {HTMLElement | undefined} says what the next key does */
  offer

  /** @type {BroadcastChannel | undefined} from a window with the contents, once this page has been a hall's */
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

  /** Its part of the address. */
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
  stand({step}) {
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

  /** It stays through scenes and steps, which are one page. */
  async full() {
    if (document.fullscreenElement) await document.exitFullscreen()
    else await root.requestFullscreen?.().catch(() => {})
  }

  /** Browsers enter full screen only after a key or a press. After a reload, which some clickers cause, the next one
   * does it. */
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

// What can be grabbed on a stage: an element over each such shape, for mouse, finger, keys and screen readers.

import {element, long, unitSize} from "./dom.js"
import {brief} from "./handles.js"

const FINGER = 44 // pixels, the least that a finger hits
const STEP = 4 // pixels that an arrow key moves
/** @type {Record<string, [number, number]>} */
const KEYS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}
const GRABBED = "grabbed"

/**
 * Where a hand takes hold of a shape, and how large that is.
 * @type {Record<string, (s: any) => [number, number, number]>}
 */
const HOLDS = {
  box: s => [s.x, s.y - s.side / 2, s.side],
  circle: s => [s.x, s.y, 2 * s.r],
  path: s => [s.x, s.y, FINGER],
  arrow: s => [s.x2, s.y2, 0],
}

/** @typedef {{grip: HTMLElement, grab: page.Grab, x: number, y: number}} Grip */

export class Grips {
  /** @type {Map<object, Grip>} by the shape */
  grips = new Map()

  /** @type {Named} */
  all = {}

  /** @param {HTMLElement} host @param {import("./page.js").Page} page */
  constructor(host, page) {
    this.page = page
    this.element = element("div", {class: "grips"})
    this.why = element("div", {class: "why", role: "status"})
    host.append(this.element)
  }

  /** @param {page.AnyShape & {grab: page.Grab}} shape */
  add(shape) {
    const {grab} = shape
    const names = grab.ways.map(way => way.parameter).filter(Boolean)
    const look = {class: "grip", role: "slider", tabindex: 0, "aria-label": grab.label, "data-grab": names.join(" ")}
    const grip = {grip: element("div", look), grab, x: 0, y: 0}
    grip.grip.addEventListener("pointerdown", event => this.#drag(event, grip))
    grip.grip.addEventListener("keydown", event => this.#key(event, grip))
    grip.grip.addEventListener("blur", () => this.#let(grip))
    this.element.append(grip.grip, this.why)
    this.grips.set(shape, grip)
    if (grab.begins && !hasGrabbed()) this.page.hand.hint = "Drag what moves, and let it go."
  }

  /** Once a frame. @param {object} shape @param {any} s its numbers @param {boolean} shown @param {Named} all */
  place(shape, s, shown, all) {
    const found = this.grips.get(shape)
    if (!found) return
    this.all = all
    found.grip.hidden = !shown
    if (!shown) return
    const [x, y, size] = HOLDS[s.kind](s)
    Object.assign(found, {x, y})
    const wide = Math.max(size, FINGER / Math.min(unitSize(), 1))
    const {style} = found.grip
    style.width = style.height = long(wide)
    style.transform = `translate(${long(x - wide / 2)}, ${long(y - wide / 2)})`
    if (this.page.hand.grab === found.grab) this.#say(found, wide)
  }

  /** Why a value cannot be, beside the hand. @param {Grip} grip @param {number} wide */
  #say({x, y}, wide) {
    const {refusal} = this.page.hand
    if (this.why.textContent !== refusal) this.why.textContent = refusal
    this.why.style.transform = `translate(${long(x + wide / 2)}, ${long(y - 12)})`
  }

  /** The numbers of what is grabbed, for a screen reader. */
  update() {
    const {settings} = this.page.shown
    for (const {grip, grab} of this.grips.values()) {
      const names = grab.ways.map(way => way.parameter).filter(Boolean)
      const spoken = names.map(name => `${name} ${brief(settings[name].text)} ${settings[name].unit ?? ""}`)
      grip.setAttribute("aria-valuenow", String(settings[names[0]].value))
      grip.setAttribute("aria-valuetext", spoken.join(", "))
    }
    if (!this.page.hand.grab) this.why.textContent = ""
  }

  /** @param {PointerEvent} event @param {Grip} grip */
  #drag(event, grip) {
    if (event.button) return
    event.preventDefault()
    event.stopPropagation()
    const box = this.element.getBoundingClientRect()
    /** @param {PointerEvent} event */
    const at = ({clientX, clientY}) => ({x: (clientX - box.left) / unitSize(), y: (clientY - box.top) / unitSize()})
    const off = {x: at(event).x - grip.x, y: at(event).y - grip.y}
    grip.grip.focus({preventScroll: true})
    grip.grip.setPointerCapture(event.pointerId)
    grip.grip.classList.add("held")
    this.#take(grip)
    const move = (/** @type {PointerEvent} */ moved) => this.#move({x: at(moved).x - off.x, y: at(moved).y - off.y})
    grip.grip.addEventListener("pointermove", move)
    const stop = () => {
      grip.grip.removeEventListener("pointermove", move)
      grip.grip.classList.remove("held")
      this.#let(grip)
    }
    grip.grip.addEventListener("lostpointercapture", stop, {once: true})
  }

  /** @param {Grip} grip */
  #take(grip) {
    const {hand} = this.page
    hand.hint = ""
    remember()
    hand.take(grip.grab)
    if (grip.grab.begins && !grip.grab.start.length) hand.move({x: grip.x, y: grip.y}, this.all)
  }

  /** Where the hand is, no further than the paper. @param {{x: number, y: number}} at */
  #move({x, y}) {
    const own = this.element.getBoundingClientRect()
    const {left, right, top, bottom} = this.page.paper.getBoundingClientRect()
    const across = Math.min(Math.max(x, (left - own.left) / unitSize()), (right - own.left) / unitSize())
    const down = Math.min(Math.max(y, (top - own.top) / unitSize()), (bottom - own.top) / unitSize())
    this.page.hand.move({x: across, y: down}, this.all)
  }

  /**
   * Arrows move what has the focus, and hold it still; Enter and Space let it go.
   * @param {KeyboardEvent} event @param {Grip} grip
   */
  #key(event, grip) {
    const {hand} = this.page
    const way = KEYS[event.key]
    if (way) {
      event.preventDefault()
      if (hand.grab !== grip.grab) this.#take(grip)
      const far = event.shiftKey ? 1 : STEP
      this.#move({x: grip.x + far * way[0], y: grip.y + far * way[1]})
      hand.rest()
    } else if ((event.key === "Enter" || event.key === " ") && hand.grab === grip.grab) {
      event.preventDefault()
      this.#let(grip)
    }
  }

  /** @param {Grip} grip */
  #let(grip) {
    if (this.page.hand.grab === grip.grab) this.page.hand.release(this.all)
  }
}

function hasGrabbed() {
  try {
    return localStorage.getItem(GRABBED) !== null
  } catch {
    return true
  }
}

function remember() {
  try {
    localStorage.setItem(GRABBED, "yes")
  } catch {
    // A browser that keeps nothing is told again.
  }
}

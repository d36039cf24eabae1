// Grips of a stage: an invisible element over each draggable shape, for mouse, finger, keys and screen readers.

import {element, long, reword, surface, unitSize} from "../core/dom.js"
import {brief} from "./handles.js"
import {focusByHand, whileHeld} from "./drag.js"
import {withUnit} from "../core/numbers.js"
import {furtherOn} from "./locus.js"
import {clamp} from "../core/ruler.js"
import {polynomial} from "../core/signals.js"

const FINGER = 44 // pixels, the smallest target for a finger
const STEP = 4 // pixels that an arrow key moves; with Shift it is one
const LEAP = 40 // pixels that Page Up and Page Down move
const REACH = 60 // pixels that a finger moves at least to cross a limited range

/** Directions of the arrow keys on the screen, to the right and up. @type {Record<string, [number, number]>} */
const KEYS = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  PageUp: [0, LEAP / STEP],
  PageDown: [0, -LEAP / STEP],
}
/** The end of the slider that a key goes to. @type {Record<string, 0 | 1>} */
const ENDS = {Home: 0, End: 1}

/** @typedef {{grip: HTMLElement, grab: page.Grab, needs: string[], x: number, y: number, lift: number}} Grip */

export class Grips {
  /** @type {Map<object, Grip>} the grip of each shape */
  grips = new Map()

  /** @type {Named} */
  all = {}

  /** @param {HTMLElement} host @param {PartHost} page */
  constructor(host, page) {
    this.page = page
    this.element = element("div", {class: "grips"})
    this.why = element("div", {class: "why", role: "status"})
    host.append(this.element)
  }

  /** @param {object} shape @param {page.Grab} grab */
  add(shape, grab) {
    const look = {class: `grip ${grab.begins ? "begins" : ""}`, role: "slider", tabindex: 0, "aria-label": grab.label}
    const grip = {
      grip: element("div", {...look, "data-grab": set(grab).join(" ")}),
      grab,
      needs: needed(grab),
      x: 0,
      y: 0,
      lift: 0,
    }
    const [only, ...more] = grab.ways.filter(way => way.parameter)
    if (!more.length && only.kind !== "turn") {
      const upright = !("across" in only) || only.across === "y"
      grip.grip.setAttribute("aria-orientation", upright ? "vertical" : "horizontal")
    }
    grip.grip.addEventListener("pointerdown", event => this.#drag(event, grip))
    grip.grip.addEventListener("keydown", event => this.#key(event, grip))
    // The browser has taken the pointer away, so the shape is not thrown.
    grip.grip.addEventListener("pointercancel", () => this.page.hand.grab?.rest())
    grip.grip.addEventListener("blur", () => this.#release(grip))
    this.element.append(grip.grip, this.why)
    this.grips.set(shape, grip)
  }

  /**
   * Called in each animation frame: puts the grip over its shape. `hold` is its position and size, or null if the shape
   * is not drawn.
   * @param {object} shape @param {[number, number, number] | null | undefined} hold @param {Named} all
   */
  place(shape, hold, all) {
    const found = this.grips.get(shape)
    if (!found) return
    const shown = hold && found.needs.every(name => name in all)
    this.all = all
    const isHeld = this.page.hand.holds(found.grab)
    found.grip.hidden = !shown && !isHeld // a shape stays while it is dragged
    if (!shown) return
    const [x, y, size] = hold
    Object.assign(found, {x, y})
    const wide = Math.max(size, FINGER / Math.min(unitSize(), 1))
    const {style} = found.grip
    style.width = style.height = long(wide)
    // At the lower edge of the stage the grip is higher than its shape, because the buttons for playing are below.
    if (!isHeld) found.lift = y <= all.H ? Math.min(0, all.H - wide / 2 - y) : 0
    style.transform = `translate(${long(x - wide / 2)}, ${long(y - wide / 2 + found.lift)})`
    if (isHeld) this.#showRefusal(found, wide)
  }

  /** Shows next to the pointer why a value is rejected. @param {Grip} grip @param {number} wide */
  #showRefusal({x, y}, wide) {
    reword(this.why, this.page.hand.grab?.refusal ?? "")
    this.why.style.transform = `translate(${long(x + wide / 2)}, ${long(y - 12)})`
  }

  /** Updates the names and values of the grips for screen readers. */
  update() {
    const {settings} = this.page.shown
    for (const {grip, grab} of this.grips.values()) {
      const names = set(grab)
      const [low, high] = this.#ends(names[0])
      grip.setAttribute("aria-valuenow", String(settings[names[0]].value))
      grip.setAttribute("aria-valuemin", String(low))
      grip.setAttribute("aria-valuemax", String(high))
      grip.setAttribute("aria-valuetext", names.map(name => this.#spoken(name)).join("; "))
    }
    if (!this.page.hand.grab) this.why.textContent = ""
  }

  /** A parameter as its slider calls it, and its value: x1, displacement: 0.40 m. @param {string} name */
  #spoken(name) {
    const {text, unit} = this.page.shown.settings[name]
    const spec = this.page.controls.sliders.get(name)?.spec
    return `${spec?.label ?? name}: ${withUnit(brief(text), unit ?? spec?.unit ?? "")}`
  }

  /** The ends of the slider of a parameter. @param {string} name @returns {[number, number]} */
  #ends(name) {
    return this.page.shown.settings[name].soft ?? this.page.controls.sliders.get(name)?.spec.soft ?? [0, 1]
  }

  /** Takes a press near the only visible grip of a stage. @param {PointerEvent} event */
  press(event) {
    const hit = [...this.grips.values()].find(({grip}) => !grip.hidden)
    if (hit && Math.hypot(...this.#from(hit, event)) <= FINGER) this.#drag(event, hit)
  }

  /** The distance from a grip to a pointer. @param {Grip} grip @param {PointerEvent} event */
  #from({x, y}, {clientX, clientY}) {
    const {left, top} = this.element.getBoundingClientRect()
    return [(clientX - left) / unitSize() - x, (clientY - top) / unitSize() - y]
  }

  /** Chooses the nearest of overlapping grips. @param {PointerEvent} event @param {Grip} hit */
  #drag(event, hit) {
    if (event.button) return
    event.preventDefault()
    event.stopPropagation()
    /**
     * The pointer's position on the stage. Measured at each move, because text lines above can move the stage. @param
     * {PointerEvent} event
     */
    const at = ({clientX, clientY}) => {
      const {left, top} = this.element.getBoundingClientRect()
      return {x: (clientX - left) / unitSize(), y: (clientY - top) / unitSize()}
    }
    const {x, y} = at(event)
    const far = (/** @type {Grip} */ one) => Math.hypot(x - one.x, y - one.y - one.lift)
    const under = document.elementsFromPoint(event.clientX, event.clientY)
    const all = [...this.grips.values()].filter(one => under.includes(one.grip))
    const grip = all.reduce((best, one) => (far(one) < far(best) ? one : best), hit)
    const lever = event.pointerType === "touch" ? leverOf(grip.grab, this.all) : EQUAL
    const off = {x: x - grip.x, y: y - lever.finger(grip.y)}
    grip.grip.setPointerCapture(event.pointerId)
    grip.grip.classList.add("held")
    const move = (/** @type {PointerEvent} */ moved) =>
      this.#move({x: at(moved).x - off.x, y: lever.thing(at(moved).y - off.y)})
    whileHeld(grip.grip, move, () => {
      grip.grip.classList.remove("held")
      this.#release(grip, true)
    })
    focusByHand(grip.grip)
    this.#take(grip)
  }

  /** @param {Grip} grip */
  #take(grip) {
    this.page.hand.take(grip.grab)
    const begun = new Set(grip.grab.start.map(({parameter}) => parameter))
    if (grip.grab.begins && !set(grip.grab).every(name => begun.has(name)))
      this.page.hand.grab?.move({x: grip.x, y: grip.y}, this.all)
  }

  /** Moves the shape to the pointer, but keeps it inside the page or the frame of a plot. @param {Point} at */
  #move({x, y}) {
    const {grab} = this.page.hand
    const {left, right, top, bottom} = grab?.spec.inside ? this.#frame(grab.spec.inside) : this.#paper()
    grab?.move({x: clamp(x, left, right), y: clamp(y, top, bottom)}, this.all)
  }

  #paper() {
    const own = this.element.getBoundingClientRect()
    const {left, right, top, bottom} = surface(this.element) ?? own
    const [x, y] = [own.left, own.top]
    const [start, end, first, last] = [left - x, right - x, top - y, bottom - y].map(far => far / unitSize())
    return {left: start, right: end, top: first, bottom: last}
  }

  /** @param {string} plot */
  #frame(plot) {
    const [left, right, top, bottom] = ["left", "right", "top", "bottom"].map(side => this.all[`${plot}.${side}`])
    return {left, right, top, bottom}
  }

  /**
   * Arrows and Page keys move the shape in focus; Home and End set its first value to an end of the slider. The motion
   * is paused until Enter or Space releases the shape.
   * @param {KeyboardEvent} event @param {Grip} grip
   */
  #key(event, grip) {
    const {hand} = this.page
    const way = KEYS[event.key]
    const end = ENDS[event.key]
    const held = hand.holds(grip.grab)
    const lets = held && (event.key === "Enter" || event.key === " ")
    if (!way && end === undefined && !lets) return
    event.preventDefault()
    if (lets) return this.#release(grip)
    if (!held) this.#take(grip)
    if (way) this.#move(stepped(grip, way, event.shiftKey ? 1 : STEP, this.all))
    else hand.grab?.setTo(this.#ends(set(grip.grab)[0])[end])
    hand.grab?.rest()
  }

  /** @param {Grip} grip @param {boolean} [isPointer] true if a pointer, not a key, releases the shape */
  #release(grip, isPointer = false) {
    if (this.page.hand.holds(grip.grab)) this.page.hand.grab?.release(this.all, isPointer)
  }
}

/**
 * Converts between the height of the finger and the height of the dragged shape, which can differ.
 * @typedef {{finger: (y: number) => number, thing: (y: number) => number}} Lever
 * @type {Lever}
 */
const EQUAL = {finger: y => y, thing: y => y}

/**
 * A finger is less precise than a mouse. If the range of a height is short, the finger moves farther than the shape.
 * @param {page.Grab} grab @param {Named} all @returns {Lever}
 */
function leverOf({ways}, all) {
  const trade = ways.find(way => way.kind === "trade")
  if (!trade) return EQUAL
  const level = polynomial(trade.zero, all)
  const range = Math.abs(polynomial(trade.unit, all) * all[trade.head]) / 2
  const gain = Math.min(1, range / REACH)
  return {
    finger: y => level + (y - level) / (y < level ? gain : 1),
    thing: y => level + (y - level) * (y < level ? gain : 1),
  }
}

/** The quantities from which a motion starts. While one is hidden, no motion can be started. @param {page.Grab} grab */
const needed = grab =>
  [...grab.start.map(({of}) => of), ...grab.ways.map(way => ("rest" in way ? way.rest : ""))].filter(Boolean)

/** The parameters that a drag sets. @param {page.Grab} grab */
const set = grab => grab.ways.map(way => way.parameter).filter(Boolean)

/**
 * The point to which a key moves a shape. If the shape moves along one line only, up and right go forward, down and
 * left back.
 * @param {Grip} grip @param {[number, number]} way @param {number} far @param {Named} all
 */
function stepped({grab, x, y}, [across, up], far, all) {
  const ways = grab.ways.filter(one => one.parameter)
  const both = (across + up) * far
  const [{kind}] = ways
  if (kind === "locus") return furtherOn(/** @type {page.Locus} */ (ways[0]), both, all)
  if (kind === "turn") {
    const {x: cx, y: cy, tall} = /** @type {page.Turn} */ (ways[0])
    const [dx, dy] = [x - polynomial(cx, all), (y - polynomial(cy, all)) / tall]
    const radius = Math.hypot(dx, dy)
    const angle = Math.atan2(dx, dy) + both / radius
    return {x: x - dx + radius * Math.sin(angle), y: y + (radius * Math.cos(angle) - dy) * tall}
  }
  if (kind === "chain_root") return {x: x + across * far, y: y - up * far}
  if (new Set(ways.map(one => ("across" in one ? one.across : "y"))).size > 1)
    return {x: x + across * far, y: y - up * far}
  return "across" in ways[0] && ways[0].across === "x" ? {x: x + both, y} : {x, y: y - both}
}

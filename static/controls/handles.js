// Handles of a plot: pills at its axes that set a parameter, and the one that moves the current instant.

import {element, long, reword, textWidth, units} from "../core/dom.js"
import {focusByHand, whileHeld, whilePressed} from "./drag.js"
import {MINUS, three, tidy, withUnit} from "../core/numbers.js"
import {clamp, toPlace, toSI} from "../core/ruler.js"

const LONGEST = 7 // characters; a handle rounds a longer number
const HEIGHT = 24 // of a handle, in units
const STEPS = 200 // arrow key presses from one end of an axis to the other
/** @type {Record<string, number>} */
const KEYS = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10}

/**
 * A pill; if `handle` is null, it is the time cursor's.
 * @typedef {{element: HTMLElement, handle: page.Handle | null, off: boolean}} Pill
 * @typedef {Pill & {handle: page.Handle}} Setter
 */

export class Handles {
  /** @param {PlotHost} plot */
  constructor(plot) {
    this.plot = plot
    const {handles, time, brief: name, x_labels: numbered} = plot.block
    this.setters = handles.map(handle => /** @type {Setter} */ (this.#pill(handle.tint, handle.label, handle)))
    this.time = time && numbered ? this.#pill("ink", `Time, ${name}`, null) : null
    /** @type {Record<string, page.Ruler> | null} */
    this.frozenAxes = null
  }

  /** An axis is frozen while a handle is dragged along it, because otherwise the value would change the scale. */
  ruler(/** @type {string} */ name) {
    const now = this.plot.view.axes[name]
    const frozen = this.frozenAxes?.[name]
    return frozen && frozen.exponent === now?.exponent ? frozen : now
  }

  /**
   * Shows the help of a parameter while its handle has the focus, as for its slider.
   * @param {PartHost["controls"]} controls
   */
  help(controls) {
    for (const {element: pill, handle} of this.setters) {
      if (controls.sliders.has(handle.parameter)) pill.setAttribute("aria-describedby", `help-${handle.parameter}`)
      controls.help(pill, handle.parameter)
    }
  }

  place() {
    for (const pill of this.setters) {
      const {parameter, text, form, bare} = pill.handle
      pill.off = Boolean(form) && !this.plot.view.forms[form]
      pill.element.hidden = pill.off || bare
      const {text: shown, size} = this.plot.shown.settings[parameter]
      const pending = this.plot.page.waiting.get(parameter)
      const own = typeof pending === "number" ? tidy(pending / size) : shown
      this.#place(pill, this.#value(pill), text ? this.plot.view.values[text] : brief(own))
    }
  }

  /** @param {number} t @param {string} text */
  placeTime(t, text) {
    if (this.time) this.#place(this.time, t, text)
  }

  /** Moves all handles of a plot to the pointer, from the press to the release. @param {PointerEvent} event */
  follow(event) {
    event.preventDefault()
    const pills = this.setters.filter(({off, element: pill}) => !off && !pill.inert)
    const move = (/** @type {PointerEvent} */ moved) =>
      pills.forEach(pill => this.#moveTo(pill, this.plot.valueAt(moved, pill.handle.axis)))
    this.#hold(pills)
    whilePressed(this.plot.host, event, move, () => this.#release())
  }

  /** Moves the current instant with a drag over a plot against time. @param {PointerEvent} event */
  followTime(event) {
    const {host, page} = this.plot
    const {clock} = page
    const {playing} = clock
    const side = this.plot.down ? "y" : "x"
    const move = (/** @type {PointerEvent} */ moved) => clock.seek(this.plot.valueAt(moved, side))
    clock.playing = false
    whilePressed(host, event, move, () => {
      clock.playing = playing
      clock.touch()
    })
  }

  /** @param {string} tint @param {string} label @param {page.Handle | null} handle */
  #pill(tint, label, handle) {
    const isUpright = this.#side(handle) === "y"
    const made = element("div", {
      class: `pill ${tint} ${isUpright ? "upright" : ""}`,
      role: "slider",
      tabindex: 0,
      "aria-label": label,
      "aria-orientation": isUpright ? "vertical" : "horizontal",
      "data-grab": handle?.parameter,
    })
    const pill = {element: made, handle, off: false}
    made.addEventListener("keydown", event => this.#key(event, pill))
    made.addEventListener("pointerdown", event => this.#drag(event, pill))
    this.plot.controls.append(made)
    return pill
  }

  /** @param {KeyboardEvent} event @param {Pill} pill */
  #key(event, pill) {
    const axis = this.#axis(pill)
    const least = (axis.end - axis.start) / (event.shiftKey ? STEPS / 10 : STEPS)
    const step = KEYS[event.key] * (pill.handle?.whole ? Math.max(1, Math.round(least)) : least)
    /** @type {Record<string, number>} */
    const ends = {Home: axis.start, End: axis.end}
    const to = ends[event.key] ?? this.#here(pill) + step
    if (Number.isNaN(to)) return
    event.preventDefault()
    this.#moveTo(pill, to)
  }

  /** @param {Pill} pill */
  #axis({handle}) {
    return this.plot[this.#side(handle)]
  }

  /** The axis of a handle; null is the time cursor. @param {page.Handle | null} handle @returns {"x" | "y"} */
  #side(handle) {
    return handle?.axis ?? (this.plot.down ? "y" : "x")
  }

  /** @param {Pill} pill @param {number} value @param {string} text */
  #place(pill, value, text) {
    const {left, top, height} = this.plot.frame
    const axis = this.#axis(pill)
    const inside = onAxis(value, axis)
    const {style, classList} = pill.element
    const x = axis === this.plot.y ? left - 6 : this.plot.px(inside)
    const y = axis === this.plot.y ? this.plot.py(inside) - HEIGHT / 2 : top + height + 3
    style.translate = `${long(x)} ${long(y)}` // unlike `left` and `top`, `transform` needs no new layout in each frame
    classList.toggle("outside", inside !== value)
    const shown = this.#text(pill, text, inside)
    reword(pill.element, shown)
    pill.element.setAttribute("aria-valuenow", String(value))
    pill.element.setAttribute("aria-valuetext", withUnit(text ?? "", this.#unit(pill)))
    pill.element.setAttribute("aria-valuemin", String(axis.start))
    pill.element.setAttribute("aria-valuemax", String(axis.end))
  }

  /**
   * The unit after the number of a handle: the unit of its parameter, or of the axis if the handle shows another
   * number.
   */
  #unit(/** @type {Pill} */ pill) {
    const {handle} = pill
    if (!handle) return ""
    if (handle.unit || handle.text) return handle.unit.trim() || this.#axis(pill).unit
    const {page, shown} = this.plot
    return shown.settings[handle.parameter].unit ?? page.controls.sliders.get(handle.parameter)?.spec.unit ?? ""
  }

  /** @param {Pill} pill @param {string} text @param {number} at */
  #text({handle}, text, at) {
    if (!handle) return text
    const bare = `${handle.symbol ? `${handle.symbol} ` : ""}${text ?? ""}${handle.unit}`
    return handle.covering && this.#hidesUnit(bare, at) ? `${bare} ${handle.covering}` : bare
  }

  /**
   * True if a handle with this text covers the last number of the axis, which carries the unit.
   * @param {string} text @param {number} at
   */
  #hidesUnit(text, at) {
    return this.#touches(this.plot.x.ticks.length - 1, text, at, "x")
  }

  /**
   * True if a handle covers a part of a number of the axis.
   * @param {number} i its place @param {"x" | "y"} name of the axis
   */
  cuts(i, name) {
    const axis = this.plot[name]
    const hasUnit = axis.labels[i].includes(" ")
    return this.setters
      .filter(({element: pill, handle}) => handle.axis === name && !pill.hidden && (handle.covering || !hasUnit))
      .some(pill => this.#touches(i, pill.element.textContent ?? "", onAxis(this.#value(pill), axis), name))
  }

  /** @param {number} i @param {string} text of a handle @param {number} at @param {"x" | "y"} name of its axis */
  #touches(i, text, at, name) {
    const {ticks, labels} = this.plot[name]
    if (name === "y") return Math.abs(this.plot.py(ticks[i]) - this.plot.py(at)) < (units("t0") + HEIGHT) / 2
    return Math.abs(this.plot.px(ticks[i]) - this.plot.px(at)) < (textWidth(labels[i]) + textWidth(text)) / 2 + 12
  }

  /** @param {Setter} pill */
  #value(pill) {
    const {parameter} = pill.handle
    const pending = this.plot.page.waiting.get(parameter)
    const {value} = this.plot.shown.settings[parameter]
    return toPlace(this.#axis(pill), Number(typeof pending === "number" ? pending : value))
  }

  /** The position of a pill on its axis. @param {Pill} pill */
  #here(pill) {
    return isSetter(pill) ? this.#value(pill) : this.plot.page.clock.t
  }

  /** @param {Pill} pill @param {number} place */
  #moveTo(pill, place) {
    const axis = this.#axis(pill)
    const inside = onAxis(place, axis)
    const {page, block} = this.plot
    if (!pill.handle) return page.clock.seek(inside)
    page.compare.along = [block.x, block.y] // a moved pill stays in place when it is released
    const {parameter, least, whole} = pill.handle
    const value = whole ? clamp(Math.round(inside), Math.max(1, axis.start), Math.floor(axis.end)) : null
    page.send({type: "set", values: {[parameter]: value ?? settable(axis, inside, least)}})
  }

  /** Drags a pill. It moves by the same distance as the pointer. @param {PointerEvent} event @param {Pill} pill */
  #drag(event, pill) {
    if (event.button) return
    event.preventDefault()
    pill.element.setPointerCapture(event.pointerId)
    const {clock} = this.plot.page
    const {playing} = clock
    const at = (/** @type {PointerEvent} */ hand) => this.plot.valueAt(hand, this.#side(pill.handle))
    const off = at(event) - onAxis(this.#here(pill), this.#axis(pill))
    if (isSetter(pill)) this.#hold([pill])
    else clock.playing = false
    const move = (/** @type {PointerEvent} */ moved) => this.#moveTo(pill, at(moved) - off)
    whileHeld(pill.element, move, () => {
      if (pill.handle) return this.#release()
      clock.playing = playing
      clock.touch()
    })
    focusByHand(pill.element)
  }

  /** @param {Setter[]} pills */
  #hold(pills) {
    const {x, y, square} = this.plot.block
    const names = square ? [x, y] : pills.map(pill => (pill.handle.axis === "y" ? y : x))
    this.frozenAxes = Object.fromEntries(names.map(name => [name, this.plot.view.axes[name]]))
  }

  #release() {
    this.frozenAxes = null
    this.plot.update(this.plot.shown)
    this.plot.page.redraw()
  }
}

/** @param {Pill} pill @returns {pill is Setter} */
const isSetter = pill => pill.handle !== null

/**
 * The value at the position of a handle, with four digits in the unit of the axis, or two if the axis is logarithmic.
 * @param {page.Ruler} ruler @param {number} place @param {number | null} least
 */
function settable(ruler, place, least) {
  const {factor, log, power, start, end} = ruler
  const isPlain = factor === 1 || log || power > 1
  const value = isPlain
    ? toSI(ruler, place).toPrecision(log && end - start > 4 ? 2 : 4)
    : toSI(ruler, Number(place.toPrecision(4))).toPrecision(15)
  return Math.max(Number(value), least ?? -Infinity)
}

/** @param {number} value @param {Span} span */
const onAxis = (value, {start, end}) => clamp(value, Math.min(start, end), Math.max(start, end))

/** The text on a handle: if the number is long, only three digits. @param {string} text */
export function brief(text) {
  return text.length > LONGEST ? three(Number(text.replaceAll(MINUS, "-"))) : text
}

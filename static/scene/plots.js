// A plot: a figure with an overlay. Names and marks change only with a message; the time cursor, the dots and the
// handles move.

import {Cover} from "../compare/cover.js"
import {element, inUnits, setAttributes, svg, textWidth, unitSize} from "../core/dom.js"
import {Field} from "./field.js"
import {Figure} from "./figure.js"
import {Handles} from "../controls/handles.js"
import {Flags, Labels} from "./labels.js"
import {everyWhich} from "./places.js"
import {Reading, isOnControl} from "./reading.js"
import {PLAIN, toOneScale} from "../core/ruler.js"
import {unlessScrolled} from "../controls/drag.js"

const REACH = 16 // largest distance in units from a press to the point that it selects
const NOWHERE = {left: 0, top: 0, width: 1, height: 1}

/** @implements {PlotHost} */
export class Plot {
  /** @type {Drawn} the current picture, set from the first answer on */
  shown

  /** @type {Drawn["view"]} */
  view

  /** @type {Frame | undefined} the frame, after layout */
  box

  /** @type {import("../compare/ghosts.js").PlotGhost | undefined} curves drawn under those of the figure */
  ghost

  /** @type {PointsHost | undefined} */
  points

  /** @param {page.PlotBlock} block @param {HTMLElement} host @param {PartHost} page */
  constructor(block, host, page) {
    this.block = block
    this.host = host
    this.page = page
    this.absent = true
    this.x = PLAIN
    this.y = PLAIN
    /** @type {Set<string>} */
    this.hidden = new Set()
    this.figure = new Figure(block)
    this.over = svg("svg", {class: "over", "aria-hidden": "true"})
    this.controls = element("div", {class: "handles"})
    host.append(this.figure.element, this.figure.says, this.over, this.controls)
    this.field = block.modal ? new Field(this) : null
    this.cursor = block.cursor ? svg("line", {class: "now"}) : null
    this.flags = new Flags(this)
    this.cover = new Cover(this)
    /** @type {Handles} */
    this.handles = new Handles(this)
    this.labels = new Labels(this)
    this.reading = new Reading(this)
    if (this.cursor) this.over.append(this.cursor)
    this.dots = block.curves.filter(curve => curve.signal).map(curve => this.#dot(curve))
    if (block.handles.some(handle => handle.axis === "y")) host.style.touchAction = "none"
    this.#pointer()
    this.observer = new ResizeObserver(() => this.place() && this.page.join())
    this.observer.observe(host)
  }

  /** @param {page.Curve} curve */
  #dot(curve) {
    const dot = svg("circle", {class: `dot ${curve.tint}`, r: 4.5})
    this.over.append(dot)
    return {curve, dot, covers: [curve.y, curve.group].map(name => `curve:${this.block.name}.${name}`)}
  }

  /** Adds the figure; names, marks and handles have their positions already. */
  async mount() {
    this.mounted = true
    this.figure.make()
    this.#draw()
    await this.figure.mount()
  }

  leave() {
    this.observer.disconnect()
    this.figure.leave()
    this.box = undefined
  }

  /** Position of a number of the axis, in units from the host's upper left corner. @param {number} value */
  px(value) {
    return this.frame.left + ((value - this.x.start) / (this.x.end - this.x.start)) * this.frame.width
  }

  /** @param {number} value */
  py(value) {
    return this.frame.top + ((this.y.end - value) / (this.y.end - this.y.start)) * this.frame.height
  }

  /** True if its time axis points down. */
  get down() {
    return this.block.time && this.block.modal !== ""
  }

  /** @returns {Frame} */
  get frame() {
    return this.box ?? NOWHERE
  }

  /**
   * The frame and the axes as named quantities, for a stage whose upper left corner is at `origin` on the page. Empty
   * if the plot is not visible.
   * @param {DOMRect} origin @returns {Named}
   */
  geometry(origin) {
    if (!this.host.checkVisibility()) return {}
    const box = this.host.getBoundingClientRect()
    return geometry(this, this.block.name, (box.left - origin.left) / unitSize(), (box.top - origin.top) / unitSize())
  }

  /** True if it is visible and has no figure yet. */
  get needsFigure() {
    return !this.mounted && !this.absent && this.box && this.host.offsetParent !== null
  }

  /** The available frame: Bokeh keeps the same margins, in whole pixels. @returns {Frame} */
  get room() {
    const {left, right, top, bottom} = this.figure.room
    const {width, height} = this.host.getBoundingClientRect()
    const [across, down] = [Math.floor(width) - left - right, Math.floor(height) - top - bottom]
    const size = unitSize()
    return {left: left / size, top: top / size, width: across / size, height: down / size}
  }

  /** Lays the plot out in a box; returns true if its size has changed. */
  place(box = this.room) {
    if (box.width <= 0 || box.height <= 0) return false
    const isSame = box.width === this.box?.width && box.height === this.box.height && this.unit === unitSize()
    if (isSame) return false
    this.box = box
    this.unit = unitSize()
    const {width, height} = this.host.getBoundingClientRect()
    inUnits(this.over, width / unitSize(), height / unitSize())
    this.figure.fit()
    if (this.shown && !this.absent) {
      this.#widen()
      this.#axes()
    }
    this.cover.place()
    this.still()
    this.page.redraw()
    return true
  }

  /** @param {Drawn} shown */
  update(shown) {
    const {view} = shown
    this.shown = shown
    this.view = view
    const isHidden = this.host.closest("[hidden]") !== null
    this.absent = isHidden || !view.axes[this.block.x] || !view.axes[this.block.y]
    const up = this.handles.ruler(this.block.y)
    this.asked = {x: this.handles.ruler(this.block.x), y: this.down && up ? turned(up) : up}
    this.x = this.asked.x ?? this.x
    this.y = this.asked.y ?? this.y
    this.hidden = new Set(this.page.hidden)
    this.cover.update()
    this.field?.update()
    if (this.absent) return
    this.#number(shown.state.show ?? [])
    this.#widen()
    this.#draw()
    this.still()
    if (this.needsFigure) this.page.join()
  }

  #draw() {
    if (!this.mounted) return
    this.figure.fill(this.view.columns, this.hidden)
    this.figure.setTicks(this.x.ticks, this.y.ticks)
    this.#axes()
  }

  #axes() {
    if (!this.mounted) return
    this.figure.setRanges(this.x, this.y)
    this.figure.setLabels(this.abscissae)
  }

  // If numbers would touch, draw only every n-th one, counted from the last, which has the unit.
  // Numbers that a handle would cover are not drawn either.
  get abscissae() {
    const {ticks, labels} = this.x
    const last = ticks.length - 1
    const spans = ticks.map((tick, i) => ({at: this.px(tick), size: textWidth(labels[i]) + 4}))
    const step = this.box ? everyWhich(spans) : 1
    return new Map(ticks.map((tick, i) => [tick, (last - i) % step || this.handles.cuts(i, "x") ? "" : labels[i]]))
  }

  #widen() {
    if (this.block.square && this.box && this.asked) [this.x, this.y] = toOneScale(this.asked.x, this.asked.y, this.box)
  }

  /** A plot that a step lists always has numbers below it. @param {readonly string[]} listed */
  #number({length}) {
    const isNumbered = this.block.x_labels || (length > 0 && !this.block.plain)
    if (isNumbered === this.figure.numbered) return
    this.figure.numbered = isNumbered
    this.place()
  }

  theme() {
    this.figure.theme()
    this.field?.theme()
  }

  // Parts that change only with a message: end labels, band labels, marks.
  still() {
    if (!this.box || !this.shown || this.absent) return
    this.field?.place()
    this.ghost?.place()
    this.points?.place()
    this.labels.place()
    this.flags.place()
    this.handles.place()
  }

  /** The coordinate at the pointer. @param {PointerEvent} event @param {"x" | "y"} [which] */
  valueAt(event, which = "x") {
    const {x, y} = this.#at(event)
    const {left, top, width, height} = this.frame
    if (which === "y") return this.y.end - ((y - top) / height) * (this.y.end - this.y.start)
    return this.x.start + ((x - left) / width) * (this.x.end - this.x.start)
  }

  /** @param {PointerEvent} event */
  #at(event) {
    const box = this.host.getBoundingClientRect()
    return {x: (event.clientX - box.left) / unitSize(), y: (event.clientY - box.top) / unitSize()}
  }

  // Shows the numbers at the pointer; a press on a time plot moves the clock there.
  #pointer() {
    this.host.addEventListener("pointermove", event => this.reading.show(event))
    this.host.addEventListener("pointerleave", () => this.reading.hide())
    this.host.addEventListener("pointerdown", event => {
      if (isOnControl(event) || !this.isInside(event)) return
      unlessScrolled(this.host, event, press => this.#press(press))
    })
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const point = this.block.pick && this.#nearest(event)
    if (point) this.page.send({type: "choose", name: this.block.pick, value: point})
    else if (this.block.time) this.handles.followTime(event)
    else if (this.block.handles.length) this.handles.follow(event)
  }

  /** The point nearest to a press, as [source, index in its column]. @param {PointerEvent} event */
  #nearest(event) {
    const {x, y} = this.#at(event)
    let best = null
    let closest = REACH
    for (const curve of this.block.curves) {
      const {[curve.x]: xs, [curve.y]: ys} = this.view.columns[curve.source] ?? {}
      if (this.hidden.has(curve.group)) continue
      for (let i = 0; i < (ys?.length ?? 0); i++) {
        const distance = Math.hypot(this.px(xs[i]) - x, this.py(ys[i]) - y)
        if (distance < closest) [best, closest] = [[curve.source, String(i)], distance]
      }
    }
    return best
  }

  /** @param {PointerEvent} event */
  isInside(event) {
    const {x, y} = this.#at(event)
    return isWithin(this.frame, x, y, 0, 0)
  }

  /**
   * Called in each animation frame: moves cursor and dots to the current time.
   * @param {Named} named @param {number} t @param {string} timeText
   */
  draw(named, t, timeText) {
    if (!this.box || !this.shown || this.absent) return
    const {top, height} = this.frame
    if (this.cursor) {
      const {left, width} = this.frame
      const [x, y] = [this.px(t), this.py(t)]
      if (this.down) setAttributes(this.cursor, {x1: left, x2: left + width, y1: y, y2: y})
      else setAttributes(this.cursor, {x1: x, x2: x, y1: top, y2: top + height})
      this.handles.placeTime(t, timeText)
      if (this.down) this.labels.clear(y)
    }
    const {covered} = this.shown.state
    for (const {curve, dot, covers} of this.dots) {
      const x = this.px(curve.signal_x ? named[curve.signal_x] : t)
      const y = this.py(named[curve.signal])
      const isCovered = this.hidden.has(curve.group) || covers.some(name => covered.includes(name))
      const isShown = !isCovered && isWithin(this.frame, x, y, 1, 2)
      dot.style.display = isShown ? "" : "none"
      if (isShown) setAttributes(dot, {cx: x, cy: y})
    }
  }
}

/**
 * The frame and the axes of a plot as named quantities, in coordinates shifted by (dx, dy).
 * @param {Pick<Canvas, "frame" | "x" | "y" | "px" | "py">} plot @param {string} name
 * @param {number} [dx] @param {number} [dy] @returns {Named}
 */
export function geometry(plot, name, dx = 0, dy = 0) {
  const {left, top, width, height} = plot.frame
  return {
    [`${name}.left`]: left + dx,
    [`${name}.right`]: left + width + dx,
    [`${name}.top`]: top + dy,
    [`${name}.bottom`]: top + height + dy,
    [`${name}.x0`]: plot.px(0) + dx,
    [`${name}.x1`]: width / (plot.x.end - plot.x.start),
    [`${name}.y0`]: plot.py(0) + dy,
    [`${name}.y1`]: -height / (plot.y.end - plot.y.start),
  }
}

/** A reversed axis. @param {page.Ruler} ruler @returns {page.Ruler} */
export const turned = ruler => ({...ruler, start: ruler.end, end: ruler.start})

/**
 * True if a point is in the frame. False for NaN, which means that the picture has no such signal.
 * @param {Frame} frame @param {number} x @param {number} y @param {number} wide @param {number} high
 */
function isWithin({left, top, width, height}, x, y, wide, high) {
  return x >= left - wide && x <= left + width + wide && y >= top - high && y <= top + height + high
}

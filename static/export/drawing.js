// A plot as a standalone SVG: the content of the figure, in a frame of any size, with its names, flags and shapes.

import {REVEALING, coveredPlots, isCovered} from "../compare/cover.js"
import {setAttributes, svg, unitSize} from "../core/dom.js"
import {Flags, Labels} from "../scene/labels.js"
import {fixed} from "../core/numbers.js"
import {geometry, turned} from "../scene/plots.js"
import {clamp, toOneScale} from "../core/ruler.js"
import {evaluate} from "../core/signals.js"
import {Stage} from "../scene/stage.js"
import {axes, measured} from "../scene/describe.js"
import {HeldName, linesOf, StageGhost} from "../compare/ghosts.js"
import {plain} from "../core/plain.js"

const FAR = 1e4 // pixels from the frame at which curves are cut off
/** @type {Record<page.Curve["width"], number>} */
const WIDTHS = {sum: 3, line: 1.75, dash: 1.75, dots: 1, thin: 1, none: 0}
/** @type {Partial<Record<page.Curve["width"], string>>} */
const DASHES = {dash: "7 5", dots: "1 3"}
let clips = 0

/** @implements {Canvas} */
export class Drawing {
  /**
   * `host`: an element of the page with the size of the plot and its margins. `frame`: the rectangle of the axes in it.
   * `alone`: also draw axis numbers that the page shows only at a neighbouring plot.
   * @param {import("../scene/plots.js").Plot} plot @param {HTMLElement} host
   * @param {Frame} frame @param {boolean} [alone]
   */
  constructor(plot, host, frame, alone = false) {
    this.crossed = plot.block.plain
    this.block = alone ? {...plot.block, plain: false} : plot.block
    this.view = plot.view
    this.hidden = plot.hidden
    this.under = plot.ghost?.under
    this.field = plot.field
    this.points = plot.points
    this.page = plot.page
    this.host = host
    this.frame = frame
    const {x, y} = numbered(plot)
    const [across, up] = this.block.square ? toOneScale(x, y, frame) : [x, y]
    this.x = across
    this.y = up
    this.over = svg("g")
    this.controls = document.createElement("div")
    host.append(this.controls)
    const clip = `within-${++clips}`
    this.over.append(svg("clipPath", {id: clip}, svg("rect", this.#box())))
    this.inside = svg("g", {"clip-path": `url(#${clip})`})
  }

  #box() {
    const {left, top, width, height} = this.frame
    return {x: left, y: top, width, height}
  }

  /** @param {number} value */
  px(value) {
    return this.frame.left + ((value - this.x.start) / (this.x.end - this.x.start)) * this.frame.width
  }

  /** @param {number} value */
  py(value) {
    return this.frame.top + ((this.y.end - value) / (this.y.end - this.y.start)) * this.frame.height
  }

  /**
   * Draws everything. Call it while `over` is in the page. `marks` are shapes of a stage inside the frame.
   * @param {Named} named the quantities at the instant shown @param {page.AnyShape[]} [marks]
   */
  draw(named, marks = this.#ofStages()) {
    this.over.append(...this.#grid(), this.inside)
    const lines = this.under ? linesOf(this, this.under) : []
    const held = (/** @type {boolean} */ over) =>
      lines.filter(({above}) => above === over).map(({look, d}) => svg("path", {class: `held ${look}`, d}))
    if (this.field && !isCovered({block: this.block, shown: this.page.shown}))
      this.inside.append(this.field.image(this))
    this.inside.append(...held(false))
    for (const region of this.block.regions) this.#region(region)
    this.inside.append(...held(true))
    for (const curve of this.block.curves) this.#curve(curve)
    if (this.points?.isSeen) this.inside.append(this.points.drawing(this))
    if (this.under) this.#name(lines, this.under.name)
    const flags = new Flags(this)
    const labels = new Labels(this)
    fill(this.over, this.view, named)
    fill(this.controls, this.view, named)
    labels.place()
    flags.place()
    if (marks.length) this.inside.append(this.#shapes(named, marks))
    if (this.block.shapes.length && !isCovered({block: this.block, shown: this.page.shown}))
      this.over.append(this.#shapes(named, this.block.shapes))
    this.over.append(...flags.marks.flatMap(({flag}) => this.#flag(flag)))
  }

  /** @param {import("../compare/ghosts.js").GhostLine[]} lines @param {string} name */
  #name(lines, name) {
    this.ghost = new HeldName(this.over)
    this.ghost.tell(lines, name, this)
  }

  #grid() {
    const {left, top, width, height} = this.frame
    const {plain: bare} = this.block
    const across = bare
      ? []
      : this.y.ticks.map(tick => ({x1: left, x2: left + width, y1: this.py(tick), y2: this.py(tick)}))
    const upright = bare
      ? []
      : this.x.ticks.map(tick => ({x1: this.px(tick), x2: this.px(tick), y1: top, y2: top + height}))
    const zeros = [{x1: left, x2: left + width, y1: this.py(0), y2: this.py(0)}]
    if (this.crossed) zeros.push({x1: this.px(0), x2: this.px(0), y1: top, y2: top + height})
    const numbers = bare ? [] : this.x.ticks.map((tick, i) => this.#number(this.px(tick), this.x.labels[i]))
    const seen = zeros.filter(({y1, x1}) => y1 >= top - 1 && y1 <= top + height + 1 && x1 >= left - 1)
    return [
      ...[...across, ...upright].map(ends => svg("line", {class: "grid", ...ends})),
      ...seen.map(ends => svg("line", {class: "hair", ...ends})),
      ...numbers,
    ]
  }

  /** @param {number} x @param {string} label */
  #number(x, label) {
    return svg("text", {x, y: this.frame.top + this.frame.height + 18, "text-anchor": "middle"}, label)
  }

  /** @param {number} x @param {number} y */
  #at(x, y) {
    const place = clamp(this.py(y), -FAR, FAR)
    return `${this.px(x).toFixed(2)} ${place.toFixed(2)}`
  }

  /** @param {page.Region} region */
  #region({source, x, low, high, tint, alpha, group}) {
    const {[x]: xs, [low]: lows, [high]: highs} = this.view.columns[source] ?? {}
    if (!lows?.length || !highs?.length || this.hidden.has(group)) return
    const there = [...xs].map((at, i) => this.#at(at, highs[i]))
    const back = [...xs].map((at, i) => this.#at(at, lows[i])).toReversed()
    const d = `M${[...there, ...back].join("L")}Z`
    this.inside.append(svg("g", {class: tint}, svg("path", {class: "body", d, "fill-opacity": alpha})))
  }

  /** @param {page.Curve} curve */
  #curve({source, x, y, tint, width, marker, group}) {
    const {[x]: xs, [y]: ys} = this.view.columns[source] ?? {}
    if (!ys?.length || this.hidden.has(group)) return
    const points = [...xs].map((at, i) => this.#at(at, ys[i]))
    const look = {"stroke-width": `${WIDTHS[width]}px`, "stroke-dasharray": DASHES[width] ?? "none"}
    const line = svg("path", {class: "ln", d: `M${points.join("L")}`})
    Object.assign(line.style, {strokeWidth: look["stroke-width"], strokeDasharray: look["stroke-dasharray"]})
    const dots = marker ? points.map(point => dotAt(point, marker)) : []
    this.inside.append(svg("g", {class: tint}, ...(width === "none" ? [] : [line]), ...dots))
  }

  /** Dots and lines that do not move and that a stage draws over this plot alone. */
  #ofStages() {
    const own = `${this.block.name}.`
    const isOwn = (/** @type {Set<string>} */ needs) =>
      [...needs].some(name => name.startsWith(own)) &&
      ![...needs].some(name => name in this.view.signals) &&
      [...needs].every(name => name.startsWith(own) || (!name.includes(".") && name !== "W" && name !== "H"))
    const stages = this.page.sheet.stages.filter(stage => stage.svg.role === "img" && !stage.host.closest("[hidden]"))
    const shapes = stages.flatMap(stage => stage.shapes.filter(({needs}) => isOwn(needs)).map(({spec}) => spec))
    return shapes.filter(({kind}) => kind === "circle" || kind === "line")
  }

  /** @param {Named} named @param {page.AnyShape[]} shapes */
  #shapes(named, shapes) {
    const layer = document.createElement("div")
    this.host.append(layer)
    const stage = new Stage({shapes, label: ""}, layer)
    stage.leave()
    stage.under = this
    const [W, H] = [this.host.offsetWidth / unitSize(), this.host.offsetHeight / unitSize()]
    stage.size = {W, H, narrow: 0, wide: 1, hall: 0, desk: 1, low: 0}
    // Other plots are not in the picture, so lines to them are left out.
    const names = this.page.plots.map(plot => plot.block.name)
    stage.measure(names.map(name => ({host: this.host, geometry: () => geometry(this, name)})))
    stage.cover(this.view.left_out, coveredPlots(this.page.shown.state))
    fill(stage.svg, this.view, named)
    stage.frame(named)
    this.#held(stage, named)
    if (this.page.root.classList.contains("at-rest"))
      for (const part of stage.svg.querySelectorAll(REVEALING)) part.remove()
    const drawn = svg("g", {}, ...stage.svg.childNodes)
    layer.remove()
    return drawn
  }

  /**
   * Adds the shapes of the compared picture; their numbers avoid the current labels.
   * @param {Stage} stage @param {Named} named
   */
  #held(stage, named) {
    const {compare, clock} = this.page
    const {held, name} = compare.ghosts ?? {}
    if (!held) return
    new StageGhost(stage).frame(evaluate(held.signals, held.scalars, clock.t), this.view, name ?? "")
    stage.frame(named)
  }

  /** A flag, which is HTML on the page. @param {HTMLElement} flag */
  #flag(flag) {
    if (flag.hidden || flag.style.display === "none") return []
    const origin = this.host.getBoundingClientRect()
    const place = flag.getBoundingClientRect()
    const [x, y, width, height] = [place.left - origin.left, place.top - origin.top, place.width, place.height].map(
      length => length / unitSize(),
    )
    const words = [...flag.children].filter(child => plain(child).trim())
    const lines = words.length > 1 && !flag.classList.contains("one") ? words : [flag]
    const middle = x + width / 2
    const texts = lines.map((line, i) =>
      svg(
        "text",
        {x: middle, y: y + (height / lines.length) * (i + 0.5) + 4.5, "text-anchor": "middle"},
        [...line.childNodes].map(plain).join(" "),
      ),
    )
    const box = svg("rect", {class: "ring", x, y, width, height, rx: 4})
    return [svg("g", {class: flag.className.replace("flag", "")}, box, ...texts)]
  }
}

/**
 * Fills in the live numbers of the displayed instant.
 * @param {Element} root @param {Drawn["view"]} view @param {Named} named
 */
export function fill(root, view, named) {
  for (const one of root.querySelectorAll("[data-value]")) {
    const name = one.getAttribute("data-value") ?? ""
    const [places, signed] = view.live[name] ?? []
    one.textContent = places === undefined ? (view.values[name] ?? "?") : fixed(named[name], places, signed)
  }
}

/** @param {string} point @param {string} marker */
function dotAt(point, marker) {
  const [cx, cy] = point.split(" ")
  const dot = svg("circle", {class: marker === "ring" ? "ring" : "body", r: 4.5})
  setAttributes(dot, {cx, cy})
  return dot
}

/**
 * The axes of a plot with the numbers and the unit that the page shows only at a neighbouring plot.
 * @param {import("../scene/plots.js").Plot} plot
 */
export function numbered(plot) {
  const {x, y} = axes(plot)
  const up = whole(y)
  return {x: whole(x), y: plot.down ? turned(up) : up}
}

/** @param {page.Ruler} ruler */
function whole(ruler) {
  const {labels, ticks, unit} = ruler
  if (labels.some(label => label.endsWith(unit))) return ruler
  const last = ticks.length - 1
  const bare = labels.some(Boolean) ? unit : ""
  return {
    ...ruler,
    labels: labels.map((label, i) => label || measured({...ruler, unit: i === last ? unit : bare}, ticks[i])),
  }
}

// Curves of another picture, dotted, under the current ones. For the compared picture there are also outlines of the
// moving shapes on the stage, the old positions of the sliders, and a table of numbers (the ledger).

import {element, long, marked, setAttributes, svg, textWidth, units} from "../core/dom.js"
import {heldNumbers} from "./compared_number.js"
import {clamp, toPlace, toSI} from "../core/ruler.js"
import {sliderPlace} from "../controls/scales.js"
import {atInstant, evaluate} from "../core/signals.js"
import {piecesOf} from "../scene/label_collisions.js"
import {places} from "../scene/places.js"
import {kindOf} from "../scene/stage.js"

const FAR = 1e4 // pixels from the frame at which curves are cut off
const NEAR = 0.05 // pixels; points closer than this are the same
const RING = 5.5 // radius in pixels of the ring around a common start
const SAME = "same start"

/**
 * Columns drawn under the current ones, with their own axes and a name.
 * @typedef {{columns: Columns, axes: Record<string, page.Ruler>, name: string}} Under
 * @typedef {{look: string, d: string, end: number, start: Point, same: boolean, named: boolean,
 *   above: boolean}} GhostLine
 * a path, its ends, and `same` if it starts at the same point as the current one
 */

export class Ghosts {
  /** @type {Kept | null} */
  held = null

  name = "" // of the picture under the current curves

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    this.plots = page.plots.map(plot => new PlotGhost(plot))
    this.stages = page.sheet.stages.map(stage => new StageGhost(stage))
    this.thumbs = [...page.controls.sliders.values()].map(slider => new Thumb(slider))
    this.ledger = element("section", {class: "group ledger", "aria-label": "Held and now", hidden: ""})
    const {sections, says} = page.controls
    const last = sections[sections.length - 1] ?? says
    last.after(this.ledger)
  }

  /** @param {Under | null} under @param {Kept | null} held */
  update(under, held) {
    this.held = held
    this.name = under?.name ?? ""
    for (const plot of this.plots) plot.update(under)
    for (const stage of this.stages) stage.show(Boolean(held))
    for (const thumb of this.thumbs) thumb.update(held)
    this.ledger.hidden = !held
    if (held) this.ledger.replaceChildren(element("h2", {}, "Held and now"), table(held.ledger))
    this.page.redraw()
  }

  /** Called in each animation frame. @param {number} t @param {boolean} writes true if numbers are written again */
  frame(t, writes) {
    if (!this.held) return
    const named = evaluate(this.held.signals, this.held.scalars, t)
    for (const stage of this.stages) stage.frame(named, writes ? this.page.shown.view : null, this.name)
  }
}

/** @param {page.LedgerRow[]} rows */
function table(rows) {
  const head = element(
    "tr",
    {},
    element("td"),
    ...["held", "", "now", ""].map(name => element("th", {scope: "col"}, name)),
  )
  const lines = rows.map(({symbol, tint, held, now, unit, ratio, same}, i) => {
    const name = marked("th", {scope: "row", class: `tint ${tint}`}, symbol)
    const value = element("td", {}, now, " ", element("span", {class: "unit"}, unit))
    const became = element("td", {class: "became"}, ratio)
    const line = element("tr", {}, name, element("td", {}, held), element("td", {}, same ? "=" : "→"), value, became)
    line.classList.toggle("first-same", same && !rows[i - 1]?.same && i > 0)
    return line
  })
  return element("table", {}, head, ...lines)
}

/** A mark on a slider at its value in the compared picture. */
class Thumb {
  /** @param {import("../controls/slider.js").Slider} slider */
  constructor(slider) {
    this.slider = slider
    this.mark = element("i", {class: "was", hidden: ""})
    slider.slider.before(this.mark)
  }

  /** @param {Kept | null} held */
  update(held) {
    const {spec, size, soft} = this.slider
    const value = held?.values[spec.name]
    this.mark.hidden = typeof value !== "number"
    if (typeof value !== "number") return
    const place = sliderPlace(spec.scale, value / size, [soft[0] / size, soft[1] / size])
    this.mark.style.setProperty("--at", String(clamp(place, 0, 1)))
  }
}

/** The label of the compared curves in a plot, and a ring where they start at the same point as the current ones. */
export class HeldName {
  /** @type {number | null} the preferred height of the label */
  end = null

  /** @param {SVGElement} over the layer over the plot */
  constructor(over) {
    this.name = svg("text", {class: "curve-label held-name"})
    this.same = svg("g", {class: "same"})
    over.append(this.name, this.same)
  }

  /** @param {GhostLine[]} lines @param {string} name of their picture, or "" @param {Canvas} plot */
  tell(lines, name, plot) {
    const named = lines.find(line => line.named)
    this.same.replaceChildren(...(name && plot.block.time ? starts(lines, plot) : []))
    this.end = name && named ? named.end : null
    this.name.textContent = this.end === null ? "" : name
    this.name.setAttribute("class", `curve-label held-name ${named?.look ?? ""}`)
  }
}

/** Over a plot. */
export class PlotGhost extends HeldName {
  /** @type {Under | null} */
  under = null

  /** @type {HTMLElement | null} the entry of the legend */
  legend = null

  /** @param {import("../scene/plots.js").Plot} plot */
  constructor(plot) {
    super(plot.over)
    this.plot = plot
    this.lines = svg("svg", {class: "ghosts", "aria-hidden": "true"})
    this.edges = svg("svg", {class: "ghosts", "aria-hidden": "true"}) // over the fills
    plot.host.prepend(this.lines)
    plot.figure.element.after(this.edges)
    plot.ghost = this
  }

  /** @param {Under | null} under */
  update(under) {
    const isPlaced = under?.columns === this.under?.columns && under?.name === this.under?.name
    this.under = under
    if (!isPlaced) this.plot.still()
  }

  /** Places the label so that it does not overlap names of nearby curves. */
  place() {
    const {left, top, width, height} = this.plot.frame
    const lines = this.under ? linesOf(this.plot, this.under) : []
    for (const [host, above] of /** @type {[SVGSVGElement, boolean][]} */ ([
      [this.lines, false],
      [this.edges, true],
    ])) {
      setAttributes(host, {viewBox: `${left} ${top} ${width} ${height}`})
      for (const [side, length] of Object.entries({left, top, width, height}))
        host.style.setProperty(side, long(length))
      const drawn = lines.filter(line => line.above === above)
      host.replaceChildren(...drawn.map(({look, d}) => svg("path", {class: `held ${look}`, d})))
    }
    const name = this.under?.name ?? ""
    this.tell(lines, name, this.plot)
    this.#explain(this.end === null && lines.length ? name : "")
  }

  /** Adds the dotted lines to the legend if no curve has room for their name. @param {string} name */
  #explain(name) {
    if (name === this.legend?.textContent) return
    this.legend?.remove()
    this.legend = name ? element("span", {class: "part mute"}, element("i", {class: "key dots"}), name) : null
    if (this.legend) this.plot.host.parentElement?.querySelector(".head")?.append(this.legend)
  }
}

/**
 * The paths of all curves of a plot for which there are columns, and of the edges of its bands.
 * @param {Canvas} plot @param {Under} under @returns {GhostLine[]}
 */
export function linesOf(plot, {columns, axes}) {
  const {block, hidden} = plot
  const right = translated(axes[block.x], plot.x)
  const up = translated(axes[block.y], plot.y)
  /** @type {Map<string, GhostLine>} */
  const lines = new Map()
  const live = plot.view?.columns ?? {}
  /**
   * @param {page.Curve | page.Region} part @param {string} name
   * @param {Pick<GhostLine, "look" | "named" | "above">} line
   */
  const add = ({source, x, group}, name, line) => {
    const {[x]: xs, [name]: ys} = columns[source] ?? {}
    const key = `${source} ${name}`
    if (hidden.has(group) || !xs?.length || xs.length !== ys?.length || lines.has(key)) return
    const points = Array.from(xs, (_, i) => [plot.px(right(xs[i])), plot.py(up(ys[i]))])
    const look = isRetraced(xs) ? `${line.look} part` : line.look
    const [[x0, y0]] = points
    const {[x]: [across] = [NaN], [name]: [high] = [NaN]} = live[source] ?? {}
    const same = isOne(plot.px(across) - x0) && isOne(plot.py(high) - y0)
    lines.set(key, {...line, look, d: path(points), end: points[points.length - 1][1], start: {x: x0, y: y0}, same})
  }
  const sums = block.curves.some(({width}) => width === "sum")
  for (const curve of block.curves) {
    const look = `${curve.tint} ${sums && curve.width !== "sum" ? "part" : ""}`
    if (curve.width !== "none") add(curve, curve.y, {look, named: curve.label.length > 0, above: false})
  }
  for (const region of block.regions) {
    const above = region.alpha === 1 && !region.of
    const look = above ? "ink" : region.tint
    for (const edge of [region.low, region.high]) add(region, edge, {look, named: false, above})
  }
  return [...lines.values()]
}

/** @param {number} far */
const isOne = far => Math.abs(far) < NEAR

/**
 * Rings where a curve and its compared curve start at the same point.
 * @param {GhostLine[]} lines @param {Canvas} plot
 */
function starts(lines, plot) {
  const points = lines.filter(({same, above}) => same && !above).map(({start}) => start)
  const apart = points.filter(
    ({x, y}, i) => !points.slice(0, i).some(one => Math.hypot(one.x - x, one.y - y) < 2 * RING),
  )
  const rings = apart.map(({x, y}) => svg("circle", {cx: x, cy: y, r: RING}))
  return apart.length ? [...rings, sameStart(apart[0], plot)] : []
}

/** The label of a ring: above or below it, preferably where no curve crosses it. @param {Point} ring
 * @param {Canvas} plot */
function sameStart({x, y}, plot) {
  const {left: start, top: high, width, height} = plot.frame
  const [left, size] = [x + RING + 5, units("t1")]
  const right = left + textWidth(SAME)
  const wishes = [y - RING - 2, y + RING + size].map(foot => ({left, right, top: foot - size, bottom: foot}))
  const end = high + height
  const room = {left: start, right: start + width, top: high, bottom: end}
  const time = {left: start - 3 * size, right: start + 3 * size, top: end - size, bottom: end + size} // at the start
  const [found] = places([{wishes, across: 6 * size, down: 4 * size, room}], [...piecesOf(plot), time])
  const place = found ?? wishes[0]
  return svg("text", {x: place.left, y: place.bottom}, SAME)
}

/** True if a curve oscillates so often that its dots would fill an area. @param {Float64Array} xs */
function isRetraced(xs) {
  let turns = 0
  for (let i = 2; i < xs.length; i++) if ((xs[i] - xs[i - 1]) * (xs[i - 1] - xs[i - 2]) < 0) turns++
  return turns > 3
}

/** Converts coordinates of one axis to another. @param {page.Ruler | undefined} from @param {page.Ruler} to */
function translated(from, to) {
  const isSame =
    !from ||
    ["exponent", "factor", "power", "log"].every(
      key => from[/** @type {"log"} */ (key)] === to[/** @type {"log"} */ (key)],
    )
  return isSame
    ? (/** @type {number} */ place) => place
    : (/** @type {number} */ place) => toPlace(to, toSI(from, place))
}

/** @param {number[][]} points */
function path(points) {
  let d = ""
  let joined = false
  for (const [x, y] of points) {
    const isNear = Math.abs(x) < FAR && Math.abs(y) < FAR
    if (isNear) d += `${joined ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`
    joined = isNear
  }
  return d
}

/**
 * Outlines of a stage's moving shapes in the compared picture: shapes that start a motion when dragged, and shapes
 * marked `held`.
 */
export class StageGhost {
  /** @param {import("../scene/stage.js").Stage} stage */
  constructor(stage) {
    this.stage = stage
    this.shapes = stage.shapes
      .filter(({spec}) => spec.held || spec.grab?.begins)
      .map(({spec, moving, needs}) => {
        const parts = kindOf(spec).make(spec)
        const group = svg("g", {class: `held-shape ${spec.tint}`}, ...parts)
        group.style.display = "none"
        stage.svg.prepend(group)
        return {spec, moving, needs, parts, group}
      })
    this.numbers = heldNumbers(stage)
  }

  /** @param {boolean} isHeld */
  show(isHeld) {
    if (!isHeld) for (const {group} of [...this.shapes, ...this.numbers]) group.style.display = "none"
  }

  /**
   * Without a `view` the numbers stay as they are.
   * @param {Named} named @param {Drawn["view"] | null} view @param {string} prefix
   */
  frame(named, view, prefix) {
    const {stage} = this
    if (view) for (const number of this.numbers) number.frame(named, view, prefix)
    const all = {...named, ...stage.plots, ...stage.size}
    for (const shape of this.shapes) {
      const {spec, needs, parts, group} = shape
      const isShown = spec.show.every(name => all[name]) && [...needs].every(name => name in all)
      group.style.display = isShown ? "" : "none"
      if (isShown) kindOf(spec).move(parts, atInstant(shape, all), all)
    }
  }
}

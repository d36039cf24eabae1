// Labels over a plot, which stand still between changes: numbers beside it, names of curves and bands, flags at marks.

import {toSI} from "../core/ruler.js"
import {long, marked, set, svg, textWidth, units, unitSize, words} from "../core/dom.js"

const OVERHANG = 6 // a number with its unit may stand out by so much to the left before the unit goes under it

const LIFT = 44 // units that a flag stands over the frame; one over another stands higher

export class Labels {
  /** @param {Canvas} plot */
  constructor(plot) {
    const {curves, regions} = plot.block
    this.plot = plot
    this.curves = curves
      .filter(c => c.label.length)
      .map(curve => ({curve, text: svg("text", {class: `curve-label ${curve.tint}`}, ...words(curve.label))}))
    this.bands = regions
      .filter(r => r.label.length)
      .map(band => ({band, text: svg("text", {class: "band-label", "text-anchor": "middle"}, ...words(band.label))}))
    this.scale = svg("g", {class: "scale"})
    plot.over.append(this.scale, ...this.curves.map(l => l.text), ...this.bands.map(l => l.text))
  }

  place() {
    /** @type {Point[]} */
    const taken = []
    this.#numbers()
    this.#nameCurves()
    for (const {band, text} of this.bands) this.#labelBand(band, text, taken)
  }

  // Numbers beside the vertical axis. They are not Bokeh's, which would move the frame, and stacked plots share a time
  // axis. The lowest stands on the floor, where the handle of the time does not cover it.
  #numbers() {
    const {left, top, height} = this.plot.frame
    const {ticks, labels} = this.plot.y
    const last = ticks.length - 1
    const step = everyWhich(ticks.map(tick => this.plot.py(tick)))
    this.scale.replaceChildren(
      ...(this.plot.block.plain ? [] : ticks).flatMap((tick, i) => {
        const y = this.plot.py(tick)
        if (y < top - 1 || y > top + height + 1 || (last - i) % step) return []
        const [value, ...rest] = textWidth(labels[i]) > left + OVERHANG ? labels[i].split(" ") : [labels[i]]
        const unit = rest.join(" ")
        const lines = [
          svg("tspan", {x: left - 7}, value),
          ...(unit ? [svg("tspan", {x: left - 7, dy: "1.1em"}, unit)] : []),
        ]
        return [svg("text", {"text-anchor": "end", x: left - 7, y: Math.min(y + 4.5, top + height)}, ...lines)]
      }),
    )
  }

  // At the right end of each curve.
  #nameCurves() {
    const {left, top, width, height} = this.plot.frame
    const shown = []
    for (const {curve, text} of this.curves) {
      const column = this.plot.view.columns[curve.source]?.[curve.y] ?? this.#middle(curve.y)
      const isShown = column?.length && !this.plot.hidden.has(curve.group)
      text.style.display = isShown ? "" : "none"
      if (!isShown) continue
      const y = this.plot.py(column[column.length - 1])
      shown.push({text, y: Math.min(Math.max(y, top + 4), top + height - 2)})
    }
    const {ghost} = this.plot
    if (ghost && ghost.end !== null) {
      shown.push({text: ghost.name, y: Math.min(Math.max(ghost.end, top + 4), top + height - 2)})
    }
    shown.sort((a, b) => a.y - b.y)
    const gap = units("t1") + 2
    const places = apart(
      shown.map(one => one.y),
      gap,
      top + height,
    )
    for (const [i, {text}] of shown.entries()) set(text, {x: left + width + 7, y: places[i] + 4})
  }

  /** Where a curve is drawn as its band, its name stands at the band's middle. @param {string} name */
  #middle(name) {
    const band = this.plot.block.regions.find(({of}) => of === name)
    if (!band) return undefined
    const {[band.low]: low, [band.high]: high} = this.plot.view.columns[band.source] ?? {}
    return low?.length ? [(low[low.length - 1] + high[high.length - 1]) / 2] : undefined
  }

  /**
   * The name of a band stands where the band is thickest and no other name stands.
   * @param {page.Region} band @param {SVGTextElement} text @param {Point[]} taken
   */
  #labelBand(band, text, taken) {
    const {[band.high]: high, [band.low]: low, [band.x]: xs} = this.plot.view.columns[band.source] ?? {}
    text.style.display = "none"
    if (!high?.length || !low?.length) return
    const at = (/** @type {number} */ i) => ({x: this.plot.px(xs[i]), y: this.plot.py((high[i] + low[i]) / 2)})
    let best = -1
    let size = 0
    for (let i = Math.floor(high.length * 0.1); i < high.length * 0.9; i++) {
      const thick = Math.abs(high[i] - low[i])
      if (thick > size * 1.02 && !isTaken(at(i), taken)) [best, size] = [i, thick]
    }
    const {y, frame} = this.plot
    if (best < 0 || (size / (y.end - y.start)) * frame.height < 20) return
    const place = at(best)
    taken.push(place)
    text.style.display = ""
    set(text, {x: place.x, y: place.y + 5})
  }
}

/** Where numbers would touch, every second one stands, or fewer. @param {number[]} heights */
function everyWhich(heights) {
  const gap = Math.min(...heights.slice(1).map((height, i) => Math.abs(height - heights[i])))
  return Math.max(Math.ceil(units("t0") / gap), 1)
}

/** @param {Point} place @param {Point[]} taken */
const isTaken = ({x, y}, taken) => taken.some(other => Math.abs(other.x - x) < 56 && Math.abs(other.y - y) < 14)

/**
 * Heights from top to bottom, moved down as far as they would touch, and up as far as they would leave at the bottom.
 * @param {number[]} heights @param {number} gap @param {number} bottom
 */
export function apart(heights, gap, bottom) {
  const places = [...heights]
  for (let i = 1; i < places.length; i++) places[i] = Math.max(places[i], places[i - 1] + gap)
  if (!places.length || places[places.length - 1] <= bottom) return places
  return places.map((place, i) => Math.min(place, bottom - (places.length - 1 - i) * gap))
}

export class Flags {
  /** @param {Canvas} plot */
  constructor(plot) {
    this.plot = plot
    this.marks = plot.block.marks.map(mark => this.#mark(mark))
  }

  place() {
    for (const mark of this.marks) this.#place(mark)
    this.#spread()
  }

  /** @param {page.Mark} mark */
  #mark(mark) {
    const line = svg("line", {class: `mark ${mark.tint} ${mark.style}`})
    this.plot.over.append(line)
    const look = {class: `flag ${mark.tint} ${mark.flag} ${(mark.lift ?? LIFT) > LIFT ? "upper" : ""}`}
    const isPressed = Boolean(mark.set || mark.act)
    const flag = isPressed ? marked("button", {...look, type: "button"}, mark.html) : marked("span", look, mark.html)
    if (isPressed) {
      set(flag, {"aria-label": mark.label, title: mark.label})
      flag.addEventListener("click", () => this.plot.page.send(this.#asked(mark)))
    }
    this.plot.controls.append(flag)
    return {mark, line, flag, at: 0}
  }

  // The message of a flag that is pressed.
  /** @param {page.Mark} mark @returns {page.Said} */
  #asked({act, set: name, exactly, at, axis}) {
    if (act) return {type: "act", name: act}
    const {scalars} = this.plot.view
    return {type: "set", values: {[name]: exactly ? scalars[exactly] : toSI(this.plot[axis], scalars[at])}}
  }

  /** @param {{mark: page.Mark, line: SVGLineElement, flag: HTMLElement, at: number}} one */
  #place(one) {
    const {mark, line, flag} = one
    const at = this.plot.view.scalars[mark.at]
    const {left, top, width, height} = this.plot.frame
    const across = mark.axis === "y"
    const place = across ? this.plot.py(at) : this.plot.px(at)
    const shown =
      at !== undefined && place >= (across ? top : left) - 0.5 && place <= (across ? top + height : left + width) + 0.5
    line.style.display = flag.style.display = shown ? "" : "none"
    if (!shown) return
    const ends = across
      ? {x1: left, x2: left + width, y1: place, y2: place}
      : {x1: place, x2: place, y1: top, y2: top + height}
    set(line, ends)
    one.at = (across ? left + width : place) + mark.shift
    flag.style.left = long(one.at)
    flag.style.top = long((across ? place - 12 : top) - (mark.lift ?? (across ? 0 : LIFT)))
    flag.hidden = flag.innerHTML === ""
  }

  // Flags that would overlap stand side by side, within the plot; their lines tell where they belong.
  #spread() {
    const flags = this.marks
      .filter(({mark, flag}) => mark.axis !== "y" && flag.style.display !== "none" && !flag.hidden)
      .map(({flag, mark, at}) => ({flag, at, half: flag.offsetWidth / unitSize() / 2 + 3, lift: mark.lift}))
      .toSorted((a, b) => a.at - b.at)
    for (const row of new Set(flags.map(flag => flag.lift))) {
      const side = flags.filter(flag => flag.lift === row)
      const places = sideBySide(side, this.plot.host.clientWidth / unitSize())
      for (const [i, {flag}] of side.entries()) flag.style.left = long(places[i])
    }
  }
}

/**
 * Middles of flags from left to right, moved right as far as they would touch; those pushed out at the right push back.
 * @param {{at: number, half: number}[]} flags where each wants to stand, and half its width @param {number} width
 */
export function sideBySide(flags, width) {
  const places = []
  let end = -Infinity
  for (const {at, half} of flags) {
    places.push(Math.max(at, end + half))
    end = places[places.length - 1] + half
  }
  const last = flags.length - 1
  let start = places[last] > flags[last].at ? width : Infinity
  for (let i = last; i >= 0; i--) {
    places[i] = Math.min(places[i], start - flags[i].half)
    start = places[i] - flags[i].half
  }
  return places
}

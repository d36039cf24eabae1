// Labels over a plot that move only with a change: numbers at the axes, names of curves and bands, flags at marks.

import {toSI} from "../core/ruler.js"
import {long, marked, setAttributes, shrunk, svg, textWidth, units, unitSize, words} from "../core/dom.js"
import {everyWhich, inLine, places} from "./places.js"

const LINE = 1.1 // distance of lines, relative to the size of the text
const OVERHANG = 6 // units by which a number with its unit may exceed the left margin, before the unit goes below it

const PILL = 24 // units: the height of a handle
const LEAST = 20 // units: the least thickness of a band at its name
const ALIKE = 0.02 // a band that is thicker by less than this share counts as equally thick
const HALF = 7 // units: half the height of a line of a band's name
const WIDER = 1.2 // width of its bold type, relative to small text
const LIFT = 44 // units from a flag to the frame; stacked flags are higher
const GAP = 6 // units from a flag to the next one
const AROUND = 12 + GAP // with the edges of the flag

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

  /** Hides the number at the vertical axis that a handle at this height covers. @param {number} height */
  clear(height) {
    for (const number of this.scale.children) {
      const isUnder = Math.abs(Number(number.getAttribute("y")) - 4.5 - height) < (units("t0") + PILL) / 2
      setAttributes(number, {visibility: isUnder ? "hidden" : "visible"})
    }
  }

  place() {
    this.#numbers()
    this.#nameCurves()
    const {left, top, width, height} = this.plot.frame
    const room = {left, right: left + width, top, bottom: top + height}
    const found = places(this.bands.map(({band}) => ({wishes: this.#thickest(band), room})))
    for (const [i, {text}] of this.bands.entries()) {
      const place = found[i]
      text.style.display = place ? "" : "none"
      if (place) setAttributes(text, {x: (place.left + place.right) / 2, y: (place.top + place.bottom) / 2 + 5})
    }
  }

  // Numbers at the vertical axis. Bokeh's own would move the frame, and stacked plots share a time axis. The lowest
  // number is above the lower edge, so that the handle of the time does not cover it.
  #numbers() {
    const {left, top, height} = this.plot.frame
    const {ticks, labels} = this.plot.y
    const last = ticks.length - 1
    // A number that is too wide has its unit below it.
    const lines = labels.map(label => (textWidth(label) > left + OVERHANG ? label.split(/ (.*)/, 2) : [label]))
    const [size, more] = [units("t0"), LINE * units("t0")]
    const feet = ticks.map(tick => {
      const y = this.plot.py(tick)
      return Math.min(y + 4.5, Math.max(y - 3, top + height - 2)) // keep two numbers near the lower edge apart
    })
    const spans = feet.map((foot, i) => {
      const under = (lines[i].length - 1) * more
      return {at: foot + under / 2, size: size + under}
    })
    const step = everyWhich(spans)
    this.scale.replaceChildren(
      ...(this.plot.block.plain ? [] : ticks).flatMap((tick, i) => {
        const y = this.plot.py(tick)
        if (y < top - 1 || y > top + height + 1 || (last - i) % step || this.plot.handles?.cuts(i, "y")) return []
        const parts = lines[i].map((text, n) => svg("tspan", {x: left - 7, dy: n ? `${LINE}em` : "0"}, text))
        return [svg("text", {"text-anchor": "end", x: left - 7, y: feet[i]}, ...parts)]
      }),
    )
  }

  // Names at the right end of each curve.
  #nameCurves() {
    const {left, top, width, height} = this.plot.frame
    const shown = []
    for (const {curve, text} of this.curves) {
      const column = this.plot.view.columns[curve.source]?.[curve.y] ?? this.#middle(curve.y)
      const isShown = column?.length && !this.plot.hidden.has(curve.group)
      text.style.display = isShown ? "" : "none"
      if (!isShown) continue
      shown.push({text, at: this.plot.py(column[column.length - 1])})
    }
    const {ghost} = this.plot
    if (ghost && ghost.end !== null) shown.push({text: ghost.name, at: ghost.end})
    const size = units("t1") + 2
    const spans = shown.map(({at}) => ({at, size}))
    const heights = inLine(spans, top + 4 - size / 2, top + height - 2 + size / 2)
    // If the frame needs a part of their room, long names begin in the frame.
    const edge = this.plot.host.clientWidth / unitSize()
    const isTight = edge + 1 < left + width + this.plot.block.room.right
    for (const [i, {text}] of shown.entries()) {
      text.style.fontSize = ""
      const most = isTight ? edge - shrunk(text, edge - left).width : Infinity
      setAttributes(text, {x: Math.min(left + width + 7, most), y: heights[i] + 4})
    }
  }

  /** The name of a curve that is drawn as a band is at the band's middle. @param {string} name */
  #middle(name) {
    const band = this.plot.block.regions.find(({of}) => of === name)
    if (!band) return undefined
    const {[band.low]: low, [band.high]: high} = this.plot.view.columns[band.source] ?? {}
    return low?.length ? [(low[low.length - 1] + high[high.length - 1]) / 2] : undefined
  }

  /**
   * The position for the name of a band: where the band is thickest; none if it is too thin. @param {page.Region} band
   */
  #thickest({source, x, high: upper, low: lower, label}) {
    const {[upper]: high, [lower]: low, [x]: xs} = this.plot.view.columns[source] ?? {}
    const count = Math.min(high?.length ?? 0, low?.length ?? 0)
    const half = (WIDER * textWidth(label.map(({text}) => text).join(""))) / 2
    const wishes = []
    for (let i = Math.floor(count * 0.1); i < count * 0.9; i++) {
      const [top, bottom] = [this.plot.py(high[i]), this.plot.py(low[i])]
      const [across, middle, thick] = [this.plot.px(xs[i]), (top + bottom) / 2, Math.abs(top - bottom)]
      if (thick < LEAST) continue
      const box = {left: across - half, right: across + half, top: middle - HALF, bottom: middle + HALF}
      wishes.push({thick: Math.round(Math.log(thick) / ALIKE), box})
    }
    return wishes.toSorted((one, other) => other.thick - one.thick).map(({box}) => box)
  }
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
      setAttributes(flag, {"aria-label": mark.label, title: mark.label})
      flag.addEventListener("click", () => this.plot.page.send(this.#asked(mark)))
    }
    this.plot.controls.append(flag)
    return {mark, line, flag, at: 0}
  }

  // The message that a press on a flag sends.
  /** @param {page.Mark} mark @returns {page.BrowserMessage} */
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
    setAttributes(line, ends)
    one.at = (across ? left + width : place) + mark.shift
    flag.style.left = long(one.at)
    flag.style.top = long((across ? place - 12 : top) - (mark.lift ?? (across ? 0 : LIFT)))
    flag.hidden = flag.innerHTML === ""
  }

  // Flags that would overlap are moved to the side, within the plot; their lines stay in place. Flags that are too wide
  // together are smaller.
  #spread() {
    const width = this.plot.host.clientWidth / unitSize()
    const shown = this.marks.filter(
      ({mark, flag}) => mark.axis !== "y" && flag.style.display !== "none" && !flag.hidden,
    )
    for (const row of new Set(shown.map(({mark}) => mark.lift))) {
      const flags = shown.filter(({mark}) => mark.lift === row)
      for (const {flag} of flags) flag.style.fontSize = ""
      const around = AROUND * flags.length
      const share = (width - around) / (flags.reduce((sum, {flag}) => sum + sizeOf(flag), 0) - around)
      if (share < 1) for (const {flag} of flags) flag.style.fontSize = `calc(${share} * var(--t0))`
      const side = flags.map(({flag, at}) => ({flag, at, size: sizeOf(flag)}))
      const starts = side.map(({at, size}) => at - size / 2)
      const ends = side.map(({at, size}) => at + size / 2)
      const middles = inLine(side, Math.min(0, ...starts), Math.max(width, ...ends))
      for (const [i, {flag}] of side.entries()) flag.style.left = long(middles[i])
    }
  }
}

/** The width of a flag with the gap to the next one, in units. @param {HTMLElement} flag */
const sizeOf = flag => flag.offsetWidth / unitSize() + GAP

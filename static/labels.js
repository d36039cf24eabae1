// What stands still over a plot between changes: numbers beside it, names of its curves and bands, flags at its marks.

import {colour, element, svg, textWidth, words} from "./dom.js"

const OVERHANG = 6 // a number with its unit may stand out by so much to the left before the unit goes under it

export class Labels {
  constructor(plot) {
    const {curves, bands} = plot.block
    this.plot = plot
    this.curves = curves.filter(c => c.label).map(curve => ({curve, text: svg("text", {class: `curve-label ${curve.tint}`}, ...words(curve.label))}))
    this.bands = bands.filter(b => b.label).map(band => ({band, text: svg("text", {class: "band-label", "text-anchor": "middle"}, ...words(band.label))}))
    this.scale = svg("g", {class: "scale"})
    plot.over.append(this.scale, ...this.curves.map(l => l.text), ...this.bands.map(l => l.text))
  }

  place() {
    const taken = []
    this.#numbers()
    this.#nameCurves()
    for (const {band, text} of this.bands) this.#labelBand(band, text, taken)
  }

  // Numbers beside the vertical axis. They are not Bokeh's, which would move the frame: stacked plots share a time axis.
  #numbers() {
    const {left, top, height} = this.plot.frame, {ticks, labels} = this.plot.y
    this.scale.replaceChildren(...(this.plot.block.plain ? [] : ticks).flatMap((tick, i) => {
      const y = this.plot.py(tick)
      if (y < top - 1 || y > top + height + 1) return []
      const [value, ...rest] = textWidth(labels[i]) > left + OVERHANG ? labels[i].split(" ") : [labels[i]], unit = rest.join(" ")
      const lines = [svg("tspan", {x: left - 7}, value), ...(unit ? [svg("tspan", {x: left - 7, dy: "1.1em"}, unit)] : [])]
      return [svg("text", {"text-anchor": "end", y: y + 4.5}, ...lines)]
    }))
  }

  // At the right end of each curve; where they would touch, one under the other.
  #nameCurves() {
    const {left, top, width, height} = this.plot.frame
    const placed = []
    for (const {curve, text} of this.curves) {
      const column = this.plot.state.columns[curve.source]?.[curve.name] ?? this.#middle(curve.name)
      const shown = column?.length && !this.plot.hidden.has(curve.group)
      text.style.display = shown ? "" : "none"
      if (!shown) continue
      const y = Math.min(Math.max(this.plot.py(column[column.length - 1]), top + 4), top + height - 2)
      placed.push({text, y})
    }
    placed.sort((a, b) => a.y - b.y)
    const gap = parseFloat(colour("t1")) + 2
    for (let i = 1; i < placed.length; i++) placed[i].y = Math.max(placed[i].y, placed[i - 1].y + gap)
    const over = placed.length ? placed[placed.length - 1].y - (top + height) : 0
    for (const [i, {text, y}] of placed.entries()) {
      text.setAttribute("x", left + width + 7)
      text.setAttribute("y", (over > 0 ? Math.min(y, top + height - (placed.length - 1 - i) * gap) : y) + 4)
    }
  }

  // Where a curve is drawn as its band, its name stands at the band's middle.
  #middle(name) {
    const {[`${name}_lo`]: low, [`${name}_hi`]: high} = this.plot.state.columns.band ?? {}
    return low?.length ? [(low[low.length - 1] + high[high.length - 1]) / 2] : undefined
  }

  // The name of a band stands where the band is thickest.
  #labelBand(band, text, taken) {
    const columns = this.plot.state.columns[band.source] ?? {}
    const high = columns[band.high], low = columns[band.low], xs = columns[this.plot.block.x_column]
    text.style.display = "none"
    if (!high?.length || !low?.length) return
    let best = -1, size = 0
    for (let i = Math.floor(high.length * 0.1); i < high.length * 0.9; i++) {
      const thick = Math.abs(high[i] - low[i]), x = this.plot.px(xs[i]), y = this.plot.py((high[i] + low[i]) / 2)
      if (thick <= size * 1.02 || taken.some(other => Math.abs(other.x - x) < 56 && Math.abs(other.y - y) < 14)) continue
      [best, size] = [i, thick]
    }
    if (best < 0 || size / (this.plot.y.end - this.plot.y.start) * this.plot.frame.height < 20) return
    text.style.display = ""
    const place = {x: this.plot.px(xs[best]), y: this.plot.py((high[best] + low[best]) / 2)}
    taken.push(place)
    text.setAttribute("x", place.x)
    text.setAttribute("y", place.y + 5)
  }
}

export class Flags {
  constructor(plot) {
    this.plot = plot
    this.marks = plot.block.marks.map(mark => this.#mark(mark))
  }

  place() {
    for (const mark of this.marks) this.#place(mark)
    this.#spread()
  }

  #mark(mark) {
    const line = svg("line", {class: `mark ${mark.tint} ${mark.style ?? ""}`})
    this.plot.over.append(line)
    const pressed = mark.set || mark.act
    const flag = element(pressed ? "button" : "span", {class: `flag ${mark.tint} ${mark.flag ?? ""}`, type: pressed ? "button" : undefined})
    flag.innerHTML = mark.html ?? ""
    if (pressed) {
      flag.setAttribute("aria-label", mark.label)
      flag.title = mark.label
      flag.addEventListener("click", () => this.plot.page.send(mark.act ? {type: "act", name: mark.act} : {type: "set", values: {[mark.set]: this.plot.state.scalars[`${mark.at}_si`] ?? this.plot.si(this.plot.state.scalars[mark.at], mark.axis)}}))
    }
    this.plot.handles.append(flag)
    return {mark, line, flag}
  }

  #place({mark, line, flag}) {
    const at = this.plot.state.scalars[mark.at], {left, top, width, height} = this.plot.frame, across = mark.axis === "y"
    const place = across ? this.plot.py(at) : this.plot.px(at)
    const shown = at !== undefined && place >= (across ? top : left) - 0.5 && place <= (across ? top + height : left + width) + 0.5
    line.style.display = flag.style.display = shown ? "" : "none"
    if (!shown) return
    const ends = across ? {x1: left, x2: left + width, y1: place, y2: place} : {x1: place, x2: place, y1: top, y2: top + height}
    for (const [key, value] of Object.entries(ends)) line.setAttribute(key, value)
    flag.style.left = `${(across ? left + width : place) + (mark.shift ?? 0)}px`
    flag.style.top = `${(across ? place - 12 : top) - (mark.lift ?? (across ? 0 : 44))}px`
    flag.hidden = flag.innerHTML === ""
  }

  // Flags that would overlap stand side by side, within the plot; their lines tell where they belong.
  #spread() {
    const flags = this.marks.filter(({mark, flag}) => mark.axis !== "y" && flag.style.display !== "none" && !flag.hidden)
      .map(({flag, mark}) => ({flag, at: parseFloat(flag.style.left), half: flag.offsetWidth / 2 + 3, lift: mark.lift}))
      .sort((a, b) => a.at - b.at)
    for (const row of new Set(flags.map(flag => flag.lift))) this.#sideBySide(flags.filter(flag => flag.lift === row))
  }

  #sideBySide(flags) {
    let end = -Infinity
    for (const one of flags) end = (one.x = Math.max(one.at, end + one.half)) + one.half
    // Those pushed out at the right push back.
    const last = flags[flags.length - 1]
    let start = last.x > last.at ? this.plot.host.clientWidth : Infinity
    for (const one of flags.reverse()) {
      one.x = Math.min(one.x, start - one.half)
      start = one.x - one.half
      one.flag.style.left = `${one.x}px`
    }
  }
}

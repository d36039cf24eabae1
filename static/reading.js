// The numbers at the pointer, over a plot.

import {element, svg} from "./dom.js"

export class Reading {
  constructor(plot) {
    this.plot = plot
    this.aim = svg("line", {class: "aim"})
    this.box = element("div", {class: "reading", hidden: ""})
    plot.over.append(this.aim)
    plot.host.append(this.box)
  }

  hide() {
    this.box.hidden = true
    this.aim.style.display = "none"
  }

  show(event) {
    if (!this.plot.state || this.plot.block.square || event.pointerType === "touch" || !this.plot.inside(event) || event.target.closest?.(".pill, .flag")) return this.hide()
    const value = this.plot.valueAt(event), lines = []
    for (const curve of this.plot.block.curves) {
      const columns = this.plot.state.columns[curve.source] ?? {}, ys = columns[curve.name], xs = columns[curve.x]
      if (!ys?.length || this.plot.hidden.has(curve.group) || !(curve.label || curve.read)) continue
      const y = interpolate(xs, ys, value)
      if (y !== null) lines.push(element("span", {class: `tint ${curve.tint}`}, `${plain(curve.label || curve.read)} ${measured(y, this.plot.y)}`))
    }
    for (const band of this.plot.block.bands) {
      const columns = this.plot.state.columns[band.source] ?? {}
      if (!band.label || !columns[band.high]?.length || !columns[band.low]?.length) continue
      const xs = columns[this.plot.block.x_column]
      lines.push(element("span", {}, `${plain(band.label)} ${measured(Math.abs(interpolate(xs, columns[band.high], value) - interpolate(xs, columns[band.low], value)), this.plot.y)}`))
    }
    if (!lines.length) return this.hide()
    this.box.replaceChildren(element("b", {}, measured(value, this.plot.x)), ...lines)
    this.box.hidden = false
    const x = this.plot.px(value), {left, top, width, height} = this.plot.frame
    this.box.style.left = `${x > left + width / 2 ? x - this.box.offsetWidth - 10 : x + 10}px`
    this.box.style.top = `${top}px`
    this.aim.style.display = ""
    for (const [key, at] of [["x1", x], ["x2", x], ["y1", top], ["y2", top + height]]) this.aim.setAttribute(key, at)
  }
}

function interpolate(xs, ys, x) {
  if (!xs?.length || x < xs[0] || x > xs[xs.length - 1]) return null
  let low = 0, high = xs.length - 1
  while (high - low > 1) {
    const middle = (low + high) >> 1
    if (xs[middle] <= x) low = middle
    else high = middle
  }
  const span = xs[high] - xs[low]
  return span > 0 ? ys[low] + (ys[high] - ys[low]) * (x - xs[low]) / span : ys[low]
}

const plain = label => label.replaceAll(/[*_{}]/g, "")
const number = value => (Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3) ? value.toExponential(2) : Number(value.toPrecision(3)).toString()).replace("-", "−")
const measured = (value, {unit}) => `${number(value)}${unit === "°" ? "" : " "}${unit}`.trim()

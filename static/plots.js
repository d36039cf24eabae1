// Mounts the Bokeh figures, fills them with the columns of a message, and draws over them what moves: the time cursor,
// the dots, the labels at the curves' ends, the marks and the handles.

import {colour, element, svg, words} from "./dom.js"

const ruler = document.createElement("canvas").getContext("2d")

// Pixels that a number at an axis takes.
function width(text) {
  ruler.font = `${colour("t0")} ${colour("sans")}`
  return ruler.measureText(text).width
}

export class Plot {
  constructor(block, host, page) {
    Object.assign(this, {block, host, page, x: {start: 0, end: 1}, y: {start: 0, end: 1}, columns: {}, hidden: new Set()})
    this.figure = element("div", {class: "figure"})
    this.over = svg("svg", {class: "over", "aria-hidden": "true"})
    this.handles = element("div", {class: "handles"})
    host.append(this.figure, this.over, this.handles)
    this.cursor = block.cursor ? svg("line", {class: "now"}) : null
    this.aim = svg("line", {class: "aim"})
    this.reading = element("div", {class: "reading", hidden: ""})
    this.marks = block.marks.map(mark => this.#mark(mark))
    this.labels = block.curves.filter(c => c.label).map(curve => ({curve, text: svg("text", {class: `curve-label ${curve.tint}`}, ...words(curve.label))}))
    this.bandLabels = block.bands.filter(b => b.label).map(band => ({band, text: svg("text", {class: "band-label", "text-anchor": "middle"}, ...words(band.label))}))
    this.scale = svg("g", {class: "scale"})
    this.over.append(this.scale, ...this.labels.map(l => l.text), ...this.bandLabels.map(l => l.text), this.aim)
    if (this.cursor) this.over.append(this.cursor)
    this.dots = block.curves.filter(c => c.signal).map(curve => {
      const dot = svg("circle", {class: `dot ${curve.tint}`, r: 4.5})
      this.over.append(dot)
      return {curve, dot}
    })
    host.append(this.reading)
    this.pills = block.handles.map(handle => this.#pill(handle.tint, handle.symbol, handle.label, handle))
    if (block.handles.some(handle => handle.axis === "y")) host.style.touchAction = "none"
    if (block.cursor === "time" && block.x_labels) this.timePill = this.#pill("ink", "", "Time")
    this.#pointer()
  }

  async embed() {
    const manager = await Bokeh.embed.embed_item(this.block.item, this.figure)
    this.view = [...manager][0]
    this.model = this.view.model
    this.view.canvas_view.events_el.removeAttribute("tabindex") // the keys have nothing to do on the figure itself
    this.sources = Object.fromEntries([...this.sourceNames()].map(name => [name, this.model.document.get_model_by_name(name)]))
    this.theme()
    new ResizeObserver(() => requestAnimationFrame(() => this.layout())).observe(this.figure)
  }

  sourceNames() {
    return new Set([...this.block.curves, ...this.block.bands].map(part => part.source))
  }

  // Position of a number of the axis on the page, in pixels from the host's upper left corner.
  px(value) {
    return this.frame.left + (value - this.x.start) / (this.x.end - this.x.start) * this.frame.width
  }

  py(value) {
    return this.frame.top + (this.y.end - value) / (this.y.end - this.y.start) * this.frame.height
  }

  get frame() {
    return this.box ?? {left: 0, top: 0, width: 1, height: 1}
  }

  // The frame and the axes as named quantities for a stage whose upper left corner is at (left, top) on the page.
  geometry(origin) {
    const box = this.host.getBoundingClientRect(), name = this.block.name
    const dx = box.left - origin.left, dy = box.top - origin.top
    return {
      [`${name}.left`]: this.frame.left + dx, [`${name}.right`]: this.frame.left + this.frame.width + dx,
      [`${name}.top`]: this.frame.top + dy, [`${name}.bottom`]: this.frame.top + this.frame.height + dy,
      [`${name}.x0`]: this.px(0) + dx, [`${name}.x1`]: this.frame.width / (this.x.end - this.x.start),
      [`${name}.y0`]: this.py(0) + dy, [`${name}.y1`]: -this.frame.height / (this.y.end - this.y.start),
    }
  }

  layout() {
    const box = this.view?.frame?.bbox
    if (!box || !box.width) return
    this.box = {left: box.left, top: box.top, width: box.width, height: box.height}
    if (this.state && !this.absent) {
      if (this.block.square) this.#ranges()
      this.#abscissae()
    }
    this.still()
    this.page.redraw()
  }

  update(state) {
    this.state = state
    this.absent = !state.axes[this.block.x] || !state.axes[this.block.y]
    // An axis stands still while a handle is dragged along it: what moves the value must not move the scale.
    const axis = name => (this.held?.[name]?.exponent === state.axes[name]?.exponent ? this.held?.[name] : null) ?? state.axes[name]
    this.asked = {x: axis(this.block.x), y: axis(this.block.y)}
    this.x = this.asked.x ?? this.x
    this.y = this.asked.y ?? this.y
    this.hidden = new Set(state.hidden)
    this.host.parentElement.style.display = this.block.show && !state.forms[this.block.show] ? "none" : ""
    if (this.absent) return
    for (const [name, source] of Object.entries(this.sources)) this.#fill(source, state.columns[name] ?? {})
    this.#ranges()
    this.#abscissae()
    this.model.below[0].ticker.ticks = this.x.ticks
    this.model.left[0].ticker.ticks = this.y.ticks
    for (const renderer of this.model.renderers) {
      const given = state.columns[renderer.data_source.name] ?? {}, {glyph} = renderer
      const needed = [glyph.x, glyph.y, glyph.y1, glyph.y2].filter(Boolean).map(value => value.field)
      renderer.visible = !this.hidden.has(renderer.tags?.[1]) && needed.every(column => given[column]?.length)
    }
    this.still()
  }

  // Where numbers would touch, every second one is left out, or more; the last, which carries the unit, stays.
  #abscissae() {
    const {ticks, labels} = this.x, last = ticks.length - 1
    const touch = (i, j) => this.px(ticks[j]) - this.px(ticks[i]) < (width(labels[i]) + width(labels[j])) / 2 + 4
    let step = 1
    if (this.box) while (ticks.some((_, i) => (last - i) % step === 0 && i + step <= last && touch(i, i + step))) step++
    this.model.below[0].major_label_overrides = new Map(ticks.map((tick, i) => [tick, (last - i) % step ? "" : labels[i]]))
  }

  // Columns that the picture does without (their renderers are not drawn) are filled up to the common length.
  #fill(source, given) {
    const length = Object.values(given)[0]?.length ?? 0, nothing = new Float32Array(length)
    source.data = Object.fromEntries(Object.keys(source.data).map(key => [key, given[key] ?? nothing]))
  }

  #ranges() {
    let {x, y} = this
    if (this.block.square && this.box) {
      ({x, y} = this.asked)
      // One scale for both axes: the axis with room to spare shows more than it was asked to.
      const scale = Math.max((x.end - x.start) / this.box.width, (y.end - y.start) / this.box.height)
      const wide = (axis, pixels) => {
        const middle = (axis.start + axis.end) / 2, half = scale * pixels / 2
        return {...axis, start: middle - half, end: middle + half}
      }
      this.x = x = wide(x, this.box.width)
      this.y = y = wide(y, this.box.height)
    }
    this.model.x_range.setv({start: x.start, end: x.end})
    this.model.y_range.setv({start: y.start, end: y.end})
  }

  theme() {
    const set = (model, values) => model.setv(values)
    for (const renderer of this.model.renderers) {
      const ink = colour(renderer.tags?.[0] || "ink"), glyph = renderer.glyph
      if ("line_color" in glyph && glyph.type !== "VArea") set(glyph, {line_color: ink})
      if ("fill_color" in glyph) set(glyph, {fill_color: renderer.tags?.[2] === "ring" ? colour("paper") : ink})
    }
    for (const span of this.model.center.filter(m => m.type === "Span")) set(span, {line_color: colour("rule")})
    for (const grid of this.model.center.filter(m => m.type === "Grid")) set(grid, {grid_line_color: colour("grid")})
    for (const axis of [...this.model.below, ...this.model.left]) {
      set(axis, {major_label_text_color: colour("mute"), major_label_text_font: colour("sans"), major_label_text_font_size: colour("t0")})
    }
  }

  // What stands still between changes: end labels, band labels, marks.
  still() {
    if (!this.box || !this.state || this.absent) return
    const {left, top, width, height} = this.frame
    this.#numbers()
    const placed = []
    for (const {curve, text} of this.labels) {
      const column = this.state.columns[curve.source]?.[curve.name] ?? this.#middle(curve.name)
      const shown = column?.length && !this.hidden.has(curve.group)
      text.style.display = shown ? "" : "none"
      if (!shown) continue
      const y = Math.min(Math.max(this.py(column[column.length - 1]), top + 4), top + height - 2)
      placed.push({text, y})
    }
    placed.sort((a, b) => a.y - b.y)
    const gap = parseFloat(colour("t1")) + 2
    for (let i = 1; i < placed.length; i++) placed[i].y = Math.max(placed[i].y, placed[i - 1].y + gap)
    const over = placed.length ? placed[placed.length - 1].y - (top + height + 6) : 0
    for (const [i, {text, y}] of placed.entries()) {
      text.setAttribute("x", left + width + 7)
      text.setAttribute("y", (over > 0 ? Math.min(y, top + height + 6 - (placed.length - 1 - i) * gap) : y) + 4)
    }
    const taken = []
    for (const {band, text} of this.bandLabels) this.#labelBand(band, text, taken)
    for (const mark of this.marks) this.#placeMark(mark)
    this.#spreadFlags()
    for (const pill of this.pills) {
      const {parameter, text, show, bare} = pill.handle
      pill.off = Boolean(show) && !this.state.forms[show]
      pill.hidden = pill.off || Boolean(bare)
      this.#placePill(pill, this.#handleValue(pill), this.state.values[text] ?? brief(this.state.params[parameter]?.text))
    }
  }

  // Numbers beside the vertical axis. They are not Bokeh's, which would move the frame: stacked plots share a time axis.
  #numbers() {
    const {left, top, height} = this.frame, {ticks, labels} = this.y
    this.scale.replaceChildren(...(this.block.plain ? [] : ticks).flatMap((tick, i) => {
      const y = this.py(tick)
      if (y < top - 1 || y > top + height + 1) return []
      const [value, ...rest] = width(labels[i]) > left - 8 ? labels[i].split(" ") : [labels[i]], unit = rest.join(" ")
      const lines = [svg("tspan", {x: left - 7}, value), ...(unit ? [svg("tspan", {x: left - 7, dy: "1.1em"}, unit)] : [])]
      return [svg("text", {"text-anchor": "end", y: y + 4.5}, ...lines)]
    }))
  }

  // Where a curve is drawn as its band, its name stands at the band's middle.
  #middle(name) {
    const {[`${name}_lo`]: low, [`${name}_hi`]: high} = this.state.columns.band ?? {}
    return low?.length ? [(low[low.length - 1] + high[high.length - 1]) / 2] : undefined
  }

  // The name of a band stands where the band is thickest.
  #labelBand(band, text, taken) {
    const columns = this.state.columns[band.source] ?? {}
    const high = columns[band.high], low = columns[band.low], xs = columns[this.block.x_column]
    text.style.display = "none"
    if (!high?.length || !low?.length) return
    let best = -1, size = 0
    for (let i = Math.floor(high.length * 0.1); i < high.length * 0.9; i++) {
      const thick = Math.abs(high[i] - low[i]), x = this.px(xs[i]), y = this.py((high[i] + low[i]) / 2)
      if (thick <= size * 1.02 || taken.some(other => Math.abs(other.x - x) < 56 && Math.abs(other.y - y) < 14)) continue
      [best, size] = [i, thick]
    }
    if (best < 0 || size / (this.y.end - this.y.start) * this.frame.height < 20) return
    text.style.display = ""
    const place = {x: this.px(xs[best]), y: this.py((high[best] + low[best]) / 2)}
    taken.push(place)
    text.setAttribute("x", place.x)
    text.setAttribute("y", place.y + 5)
  }

  #mark(mark) {
    const line = svg("line", {class: `mark ${mark.tint} ${mark.style ?? ""}`})
    this.over.append(line)
    const flag = element(mark.set ? "button" : "span", {class: `flag ${mark.tint} ${mark.flag ?? ""}`, type: mark.set ? "button" : undefined})
    flag.innerHTML = mark.html ?? ""
    if (mark.set) {
      flag.setAttribute("aria-label", mark.label)
      flag.title = mark.label
      flag.addEventListener("click", () => this.page.send({type: "set", values: {[mark.set]: this.state.scalars[`${mark.at}_si`] ?? this.#si(this.state.scalars[mark.at], mark.axis)}}))
    }
    this.handles.append(flag)
    return {mark, line, flag}
  }

  #placeMark({mark, line, flag}) {
    const at = this.state.scalars[mark.at], {left, top, width, height} = this.frame, across = mark.axis === "y"
    const place = across ? this.py(at) : this.px(at)
    const shown = at !== undefined && place >= (across ? top : left) - 0.5 && place <= (across ? top + height : left + width) + 0.5
    line.style.display = flag.style.display = shown ? "" : "none"
    if (!shown) return
    const ends = across ? {x1: left, x2: left + width, y1: place, y2: place} : {x1: place, x2: place, y1: top, y2: top + height}
    for (const [key, value] of Object.entries(ends)) line.setAttribute(key, value)
    flag.style.left = `${(across ? left + width : place) + (mark.shift ?? 0)}px`
    flag.style.top = `${(across ? place - 12 : top) - (mark.lift ?? (across ? 0 : 44))}px`
    flag.hidden = flag.innerHTML === ""
  }

  // Flags that would overlap stand side by side; their lines tell where they belong.
  #spreadFlags() {
    const flags = this.marks.filter(({mark, flag}) => mark.axis !== "y" && flag.style.display !== "none" && !flag.hidden)
      .map(({flag, mark}) => ({flag, x: parseFloat(flag.style.left), half: flag.offsetWidth / 2 + 3, lift: mark.lift}))
      .sort((a, b) => a.x - b.x)
    for (let i = 1; i < flags.length; i++) {
      const gap = flags[i - 1].x + flags[i - 1].half + flags[i].half
      if (flags[i].lift === flags[i - 1].lift && flags[i].x < gap) flags[i].x = gap
    }
    for (const {flag, x} of flags) flag.style.left = `${x}px`
  }

  #pill(tint, symbol, label, handle = null) {
    const upright = handle?.axis === "y"
    const pill = element("div", {class: `pill ${tint} ${upright ? "upright" : ""}`, role: "slider", tabindex: 0, "aria-label": label, "aria-orientation": upright ? "vertical" : "horizontal"})
    Object.assign(pill, {symbol, handle})
    this.handles.append(pill)
    pill.addEventListener("keydown", event => {
      const step = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10}[event.key]
      if (!step && event.key !== "Home" && event.key !== "End") return
      event.preventDefault()
      const axis = this.#axis(pill), span = axis.end - axis.start, here = handle ? this.#handleValue(pill) : this.page.clock.t
      this.#moveTo(pill, event.key === "Home" ? axis.start : event.key === "End" ? axis.end : here + step * span / (event.shiftKey ? 20 : 200))
    })
    pill.addEventListener("pointerdown", event => this.#drag(event, pill))
    return pill
  }

  #axis(pill) {
    return pill.handle?.axis === "y" ? this.y : this.x
  }

  #placePill(pill, value, text) {
    const {left, top, width, height} = this.frame, axis = this.#axis(pill)
    const inside = Math.min(Math.max(value, axis.start), axis.end)
    if (axis === this.y) {
      pill.style.left = `${left - 6}px`
      pill.style.top = `${this.py(inside) - 12}px`
    } else {
      pill.style.left = `${this.px(inside)}px`
      pill.style.top = `${top + height + 3}px`
    }
    pill.classList.toggle("outside", inside !== value)
    const shown = `${pill.symbol ? `${pill.symbol} ` : ""}${text ?? ""}${pill.handle?.unit ?? ""}`
    if (pill.textContent !== shown) pill.textContent = shown
    const facts = {"aria-valuenow": value, "aria-valuetext": text ?? "", "aria-valuemin": axis.start, "aria-valuemax": axis.end}
    for (const [key, fact] of Object.entries(facts)) pill.setAttribute(key, fact)
  }

  // From a number of an axis to SI, and back.
  #si(value, which = "x") {
    const axis = this[which ?? "x"]
    return (axis.log ? 10 ** value : value ** (1 / axis.power) * 10 ** (axis.exponent / axis.power)) * axis.factor
  }

  #handleValue(pill) {
    const axis = this.#axis(pill), value = this.state.params[pill.handle.parameter].value
    return axis.log ? Math.log10(value / axis.factor) : (value / axis.factor / 10 ** (axis.exponent / axis.power)) ** axis.power
  }

  #moveTo(pill, value) {
    const axis = this.#axis(pill), inside = Math.min(Math.max(value, axis.start), axis.end)
    if (!pill.handle) this.page.clock.seek(inside)
    else this.page.send({type: "set", values: {[pill.handle.parameter]: this.#rounded(inside, pill.handle)}})
  }

  // Four digits of the unit of the axis; `least` is the lowest value that a handle may have.
  #rounded(value, {axis = "x", least = -Infinity}) {
    const {factor, log, power} = this[axis]
    const si = factor === 1 || log || power > 1 ? this.#si(value, axis).toPrecision(4) : this.#si(Number(value.toPrecision(4)), axis).toPrecision(15)
    return Math.max(Number(si), least)
  }

  #value(event, which = "x") {
    const box = this.host.getBoundingClientRect()
    if (which === "y") return this.y.end - (event.clientY - box.top - this.frame.top) / this.frame.height * (this.y.end - this.y.start)
    return this.x.start + (event.clientX - box.left - this.frame.left) / this.frame.width * (this.x.end - this.x.start)
  }

  #drag(event, pill) {
    event.preventDefault()
    pill.focus({preventScroll: true})
    pill.setPointerCapture(event.pointerId)
    const {clock} = this.page, playing = clock.playing
    if (!pill.handle) clock.playing = false
    const move = moved => this.#moveTo(pill, this.#value(moved, pill.handle?.axis))
    if (pill.handle) this.#hold([pill])
    const stop = () => {
      pill.removeEventListener("pointermove", move)
      if (pill.handle) return this.#release()
      clock.playing = playing
      clock.touch()
    }
    pill.addEventListener("pointermove", move)
    pill.addEventListener("lostpointercapture", stop, {once: true})
  }

  // Over a plot: the numbers at the pointer; a press on a time plot moves the instant there.
  #pointer() {
    this.host.addEventListener("pointermove", event => this.#read(event))
    this.host.addEventListener("pointerleave", () => this.#unread())
    this.host.addEventListener("pointerdown", event => {
      if (event.target.closest(".pill, .flag") || !this.#inside(event)) return
      const point = this.block.pick && this.#nearest(event)
      if (point) this.page.send({type: "choose", name: this.block.pick, value: point})
      else if (this.block.cursor === "time") this.page.clock.seek(this.#value(event))
      else if (this.pills.length) this.#dragPoint(event)
    })
  }

  // A press on a plot takes all of its handles there at once, and they follow until it ends.
  #dragPoint(event) {
    event.preventDefault()
    this.host.setPointerCapture(event.pointerId)
    const pills = this.pills.filter(pill => !pill.off)
    const move = moved => pills.forEach(pill => this.#moveTo(pill, this.#value(moved, pill.handle.axis)))
    this.#hold(pills)
    move(event)
    const stop = () => {
      this.host.removeEventListener("pointermove", move)
      this.#release()
    }
    this.host.addEventListener("pointermove", move)
    this.host.addEventListener("lostpointercapture", stop, {once: true})
  }

  #hold(pills) {
    const {x, y, square} = this.block
    const names = square ? [x, y] : pills.map(pill => (pill.handle.axis === "y" ? y : x))
    this.held = Object.fromEntries(names.map(name => [name, this.state.axes[name]]))
  }

  #release() {
    this.held = null
    this.update(this.state)
    this.page.redraw()
  }

  // The point nearest to a press, at most 16 pixels away, as [source, place in its column].
  #nearest(event) {
    const box = this.host.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top
    let best = null, closest = 16
    for (const curve of this.block.curves) {
      const {[curve.x]: xs, [curve.name]: ys} = this.state.columns[curve.source] ?? {}
      if (this.hidden.has(curve.group)) continue
      for (let i = 0; i < (ys?.length ?? 0); i++) {
        const distance = Math.hypot(this.px(xs[i]) - x, this.py(ys[i]) - y)
        if (distance < closest) [best, closest] = [[curve.source, String(i)], distance]
      }
    }
    return best
  }

  #inside(event) {
    const box = this.host.getBoundingClientRect(), {left, top, width, height} = this.frame
    const x = event.clientX - box.left, y = event.clientY - box.top
    return x >= left && x <= left + width && y >= top && y <= top + height
  }

  #unread() {
    this.reading.hidden = true
    this.aim.style.display = "none"
  }

  #read(event) {
    if (!this.state || this.block.square || event.pointerType === "touch" || !this.#inside(event) || event.target.closest?.(".pill, .flag")) return this.#unread()
    const value = this.#value(event), lines = []
    for (const curve of this.block.curves) {
      const columns = this.state.columns[curve.source] ?? {}, ys = columns[curve.name], xs = columns[curve.x]
      if (!ys?.length || this.hidden.has(curve.group) || !curve.label) continue
      const y = interpolate(xs, ys, value)
      if (y !== null) lines.push(element("span", {class: `tint ${curve.tint}`}, `${plain(curve.label)} ${number(y)}`))
    }
    for (const band of this.block.bands) {
      const columns = this.state.columns[band.source] ?? {}
      if (!band.label || !columns[band.high]?.length || !columns[band.low]?.length) continue
      const xs = columns[this.block.x_column]
      lines.push(element("span", {}, `${plain(band.label)} ${number(Math.abs(interpolate(xs, columns[band.high], value) - interpolate(xs, columns[band.low], value)))}`))
    }
    if (!lines.length) return this.#unread()
    this.reading.replaceChildren(element("b", {}, `${number(value)} ${this.x.unit}`), ...lines)
    this.reading.hidden = false
    const x = this.px(value), {left, top, width, height} = this.frame
    this.reading.style.left = `${x > left + width / 2 ? x - this.reading.offsetWidth - 10 : x + 10}px`
    this.reading.style.top = `${top}px`
    this.aim.style.display = ""
    for (const [key, at] of [["x1", x], ["x2", x], ["y1", top], ["y2", top + height]]) this.aim.setAttribute(key, at)
  }

  // Once a frame: cursor and dots at the instant shown.
  draw(named, t, timeText) {
    if (!this.box || !this.state || this.absent) return
    const {left, top, width, height} = this.frame
    if (this.cursor) {
      const x = this.px(t)
      for (const [key, value] of [["x1", x], ["x2", x], ["y1", top], ["y2", top + height]]) this.cursor.setAttribute(key, value)
      if (this.timePill) this.#placePill(this.timePill, t, timeText)
    }
    for (const {curve, dot} of this.dots) {
      const [xName, yName] = curve.signal.includes(",") ? curve.signal.split(",") : [null, curve.signal]
      const x = this.px(xName ? named[xName] : t), y = this.py(named[yName])
      const shown = named[yName] !== undefined && !this.hidden.has(curve.group)
        && x >= left - 1 && x <= left + width + 1 && y >= top - 2 && y <= top + height + 2
      dot.style.display = shown ? "" : "none"
      if (!shown) continue
      dot.setAttribute("cx", x)
      dot.setAttribute("cy", y)
    }
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

// A handle shows three digits of a number that was typed with more.
const brief = text => (text?.length > 7 && !text.includes("e") ? String(Number(text).toPrecision(3)) : text)?.replace("-", "−")
const plain = label => label.replaceAll(/[*_{}]/g, "")
const number = value => (Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3) ? value.toExponential(2) : Number(value.toPrecision(3)).toString()).replace("-", "−")

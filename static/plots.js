// Mounts the Bokeh figures, fills them with the columns of a message, and draws over them what moves: the time cursor,
// the dots and the handles.

import {colour, element, svg, textWidth} from "./dom.js"
import {Flags, Labels} from "./labels.js"
import {Reading} from "./reading.js"

export class Plot {
  constructor(block, host, page) {
    Object.assign(this, {block, host, page, x: {start: 0, end: 1}, y: {start: 0, end: 1}, columns: {}, hidden: new Set()})
    this.figure = element("div", {class: "figure"})
    this.over = svg("svg", {class: "over", "aria-hidden": "true"})
    this.handles = element("div", {class: "handles"})
    host.append(this.figure, this.over, this.handles)
    this.cursor = block.cursor ? svg("line", {class: "now"}) : null
    this.flags = new Flags(this)
    this.labels = new Labels(this)
    this.reading = new Reading(this)
    if (this.cursor) this.over.append(this.cursor)
    this.dots = block.curves.filter(c => c.signal).map(curve => {
      const dot = svg("circle", {class: `dot ${curve.tint}`, r: 4.5})
      this.over.append(dot)
      return {curve, dot}
    })
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
    const touch = (i, j) => this.px(ticks[j]) - this.px(ticks[i]) < (textWidth(labels[i]) + textWidth(labels[j])) / 2 + 4
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
    this.labels.place()
    this.flags.place()
    for (const pill of this.pills) {
      const {parameter, text, show, bare} = pill.handle
      pill.off = Boolean(show) && !this.state.forms[show]
      pill.hidden = pill.off || Boolean(bare)
      this.#placePill(pill, this.#handleValue(pill), this.state.values[text] ?? brief(this.state.params[parameter]?.text))
    }
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
    const bare = `${pill.symbol ? `${pill.symbol} ` : ""}${text ?? ""}${pill.handle?.unit ?? ""}`
    const shown = pill.handle?.covering && this.#hidesUnit(bare, inside) ? `${bare} ${pill.handle.covering}` : bare
    if (pill.textContent !== shown) pill.textContent = shown
    const facts = {"aria-valuenow": value, "aria-valuetext": text ?? "", "aria-valuemin": axis.start, "aria-valuemax": axis.end}
    for (const [key, fact] of Object.entries(facts)) pill.setAttribute(key, fact)
  }

  // Whether a handle with this text hides the last number of the axis, with which the unit stands.
  #hidesUnit(text, at) {
    const {ticks, labels} = this.x, last = ticks.length - 1
    return Math.abs(this.px(ticks[last]) - this.px(at)) < (textWidth(labels[last]) + textWidth(text)) / 2 + 12
  }

  // From a number of an axis to SI, and back.
  si(value, which = "x") {
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

  // Four digits of the unit of the axis, two where it spans many decades; `least` is the lowest value of a handle.
  #rounded(value, {axis = "x", least = -Infinity}) {
    const {factor, log, power, start, end} = this[axis]
    const si = factor === 1 || log || power > 1 ? this.si(value, axis).toPrecision(log && end - start > 4 ? 2 : 4) : this.si(Number(value.toPrecision(4)), axis).toPrecision(15)
    return Math.max(Number(si), least)
  }

  valueAt(event, which = "x") {
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
    const move = moved => this.#moveTo(pill, this.valueAt(moved, pill.handle?.axis))
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
    this.host.addEventListener("pointermove", event => this.reading.show(event))
    this.host.addEventListener("pointerleave", () => this.reading.hide())
    this.host.addEventListener("pointerdown", event => {
      if (event.target.closest(".pill, .flag") || !this.inside(event)) return
      const point = this.block.pick && this.#nearest(event)
      if (point) this.page.send({type: "choose", name: this.block.pick, value: point})
      else if (this.block.cursor === "time") this.page.clock.seek(this.valueAt(event))
      else if (this.pills.length) this.#dragPoint(event)
    })
  }

  // A press on a plot takes all of its handles there at once, and they follow until it ends.
  #dragPoint(event) {
    event.preventDefault()
    this.host.setPointerCapture(event.pointerId)
    const pills = this.pills.filter(pill => !pill.off)
    const move = moved => pills.forEach(pill => this.#moveTo(pill, this.valueAt(moved, pill.handle.axis)))
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

  inside(event) {
    const box = this.host.getBoundingClientRect(), {left, top, width, height} = this.frame
    const x = event.clientX - box.left, y = event.clientY - box.top
    return x >= left && x <= left + width && y >= top && y <= top + height
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

// A handle shows three digits of a number that was typed with more.
const brief = text => (text?.length > 7 && !text.includes("e") ? String(Number(text).toPrecision(3)) : text)?.replace("-", "−")

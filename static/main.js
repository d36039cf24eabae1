// A scene's page, kept in step: one message from the server repaints all, the clock moves the rest.

import {buildControls} from "./controls.js"
import {Clock} from "./clock.js"
import {element, live} from "./dom.js"
import {Sheet} from "./sheet.js"
import {evaluate} from "./signals.js"
import {Transport} from "./transport.js"

const MOMENT = 200 // ms without a further change until the address is written: browsers ration that
// What a motion of the chain is made of; the drive may be missing.
const MOTION = ["m1", "m2", "k1", "k2", "x1_0", "x2_0", "v1_0", "v2_0", "F_0", "omega"]

class Page {
  constructor(model, spec, extras) {
    Object.assign(this, {model, spec, extras})
    this.opening = unpacked(model.state)
    this.outbox = []
    this.waiting = false
    this.number = 0
    this.clock = new Clock(t => this.draw(t))
    this.root = element("div", {class: `page ${this.spec.slug}`})
    this.#build()
  }

  #build() {
    this.paper = element("main", {class: "paper"})
    this.notice = element("div", {class: "notice", role: "alert", hidden: ""})
    this.sheet = new Sheet(this.spec.sheet, this)
    this.paper.append(element("h1", {}, this.spec.headline), this.notice, this.sheet.element)
    this.transport = this.spec.runs ? new this.extras.RunBar(this) : new Transport(this)
    this.paper.append(this.transport.element)
    this.panel = element("aside", {class: "panel", "aria-label": "Controls"})
    this.controls = buildControls(this.panel, this.spec.controls, message => this.send(message), this.extras.buildPicker)
    this.plots = this.sheet.plots
    this.stages = [...this.sheet.stages, ...this.controls.stages]
    for (const stage of this.stages) stage.onresize = () => this.redraw()
    if (this.spec.about) this.panel.append(this.#aboutNumbers())
    this.panel.append(this.#tools())
    this.root.append(this.paper, this.panel)
  }

  #aboutNumbers() {
    const fold = element("details", {class: "about"}, element("summary", {}, "About these numbers"))
    const open = async () => {
      const {About} = await import("./later/about.js")
      this.about = new About(fold, message => this.send(message))
    }
    fold.addEventListener("toggle", open, {once: true})
    return fold
  }

  #tools() {
    const link = element("button", {type: "button", class: "chip"}, "Copy link")
    link.addEventListener("click", async () => {
      const copied = await copy(new URL(this.link, location.href).href)
      link.textContent = copied ? "Copied" : "See the address bar"
      setTimeout(() => { link.textContent = "Copy link" }, 1500)
    })
    const csv = element("button", {type: "button", class: "chip"}, "CSV")
    csv.addEventListener("click", () => this.send({type: "csv"}))
    return element("div", {class: "tools"}, link, csv, ...this.#measure())
  }

  // A scene with a motion of the chain hands it over to the accuracy scene.
  #measure() {
    if (!MOTION.slice(0, 8).every(name => name in this.opening.params) || this.spec.runs) return []
    const link = element("a", {class: "chip", href: "#"}, "Error and time")
    link.addEventListener("click", event => {
      event.preventDefault()
      const values = MOTION.filter(name => name in this.state.params).map(name => `${name}=${this.state.params[name].value}`)
      location.search = `?scene=accuracy&system=own&${values.join("&")}`
    })
    return [link]
  }

  // One message in flight; of what waits, the newest value of each parameter wins.
  send(message) {
    const last = this.outbox[this.outbox.length - 1]
    if (message.type === "set" && last?.type === "set") Object.assign(last.values, message.values)
    else this.outbox.push({...message, values: message.values && {...message.values}})
    this.#flush()
  }

  #flush() {
    if (this.waiting || !this.outbox.length) return
    this.waiting = true
    const message = this.outbox.shift()
    if (message.values === undefined) delete message.values
    this.model.send_msg({...message, number: ++this.number})
  }

  receive(message) {
    if (message.file) return this.#download(message)
    if (message.about) return this.#tell(message)
    const state = unpacked(message)
    if (state.answer !== undefined) this.waiting = false
    this.apply(state)
    this.#flush()
  }

  #download({file, text}) {
    this.waiting = false
    const link = element("a", {href: URL.createObjectURL(new Blob([text], {type: "text/csv"})), download: file})
    link.click()
    URL.revokeObjectURL(link.href)
    this.#flush()
  }

  #tell({about}) {
    this.waiting = false
    this.about.show(about)
    this.#flush()
  }

  apply(state) {
    this.state = state
    this.about?.changed()
    this.sheet.update(state)
    for (const [name, elements] of this.named) {
      if (name in state.values) for (const one of elements) one.textContent = state.values[name]
    }
    for (const plot of this.plots) plot.update(state)
    this.controls.update(state)
    this.measured = false
    this.clock.update(state.axes.t ?? {end: 1, exponent: 0}, state.scalars)
    this.transport.update(state)
    if (state.problems?.length) this.#notify(state.problems)
    clearTimeout(this.writing)
    this.writing = setTimeout(() => history.replaceState(null, "", this.link), MOMENT)
    requestAnimationFrame(() => requestAnimationFrame(() => document.dispatchEvent(new CustomEvent("oscillations:painted"))))
  }

  get link() {
    return this.state.query ? `?${this.state.query}` : location.pathname
  }

  #notify(problems) {
    const close = element("button", {type: "button", "aria-label": "Close"}, "×")
    close.addEventListener("click", () => { this.notice.hidden = true })
    this.notice.replaceChildren(element("span", {}, problems.join(" ")), close)
    this.notice.hidden = false
  }

  redraw() {
    this.measured = false
    this.clock.dirty = true
  }

  draw(t) {
    if (!this.state) return
    const {signals, scalars, axes} = this.state
    const named = evaluate(signals, scalars, t)
    for (const [name, [places, signed]] of Object.entries(this.state.live)) {
      const text = live(named[name], places, signed)
      for (const one of this.named.get(name) ?? []) one.textContent = text
    }
    const timeText = `${t.toFixed(this.timePlaces ?? 2)} ${axes.t?.unit ?? ""}`
    if (!this.measured) this.stages.forEach(stage => stage.measure(this.plots))
    this.measured = true
    this.stages.forEach(stage => stage.frame(named))
    this.plots.forEach(plot => plot.draw(named, t, timeText))
  }

  async start() {
    this.named = new Map()
    for (const one of this.root.querySelectorAll("[data-value]")) {
      const name = one.dataset.value
      this.named.set(name, [...(this.named.get(name) ?? []), one])
    }
    await Promise.all(this.plots.map(plot => plot.embed()))
    this.apply(this.opening)
    this.plots.forEach(plot => plot.layout())
    document.documentElement.dataset.ready = "true"
  }

  theme() {
    this.plots.forEach(plot => plot.theme())
  }
}

// A page that came over plain http from another machine has no clipboard.
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    return false
  }
}

// The columns of a message come end to end in one array; of each the text tells the length.
function unpacked({facts, numbers}) {
  const state = JSON.parse(facts)
  let start = numbers.byteOffset
  for (const columns of Object.values(state.columns)) {
    for (const [name, length] of Object.entries(columns)) {
      columns[name] = new Float32Array(numbers.buffer, start, length)
      start += columns[name].byteLength
    }
  }
  return state
}

function shell(page) {
  const menu = document.querySelector(".scene-menu")
  menu?.addEventListener("toggle", () => document.querySelector(".nav nav").classList.toggle("open", menu.open))
  const button = document.getElementById("theme")
  if (button) button.onclick = () => {
    const root = document.documentElement
    root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark"
    localStorage.setItem("theme", root.dataset.theme)
    page.theme()
  }
}

// What only some scenes need, asked for by them alone.
async function extrasFor({runs, controls}) {
  const wanted = []
  if (runs) wanted.push(import("./later/runbar.js"))
  if (controls.groups.some(group => Object.keys(group.pictures).length)) wanted.push(import("./later/picker.js"))
  return Object.assign({}, ...await Promise.all(wanted))
}

export async function mount(model) {
  const spec = JSON.parse(model.description)
  const page = new Page(model, spec, await extrasFor(spec))
  shell(page)
  globalThis.oscillations = page
  model.on("msg:custom", message => page.receive(message))
  model.on("remove", () => {
    page.clock.stop()
    page.root.remove()
  })
  // The page's own document is the place, not the component's shadow root: one style sheet serves all of it.
  document.getElementById("app").append(page.root)
  page.start()
  return document.createElement("div")
}

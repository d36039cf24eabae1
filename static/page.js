// The paper and the panel of one scene, built from its sheet: a message from the server repaints all, the clock moves
// the rest.

import {bokeh} from "./bokeh.js"
import {buildControls} from "./controls.js"
import {Clock} from "./clock.js"
import {Compare} from "./compare.js"
import {coverNumber, coveredPlots} from "./cover.js"
import {copyButton} from "./copy.js"
import {element} from "./dom.js"
import {Hand} from "./hand.js"
import {using} from "./later.js"
import {fixed} from "./numbers.js"
import {Sheet} from "./sheet.js"
import {tables} from "./tables.js"
import {Transport} from "./transport.js"

/**
 * What only some sheets need.
 * @typedef {{RunBar?: typeof import("./later/runbar.js").RunBar,
 *   buildPicker?: typeof import("./later/picker.js").buildPicker}} Extras
 * @typedef {import("./main.js").Lecture} Lecture
 * @typedef {import("./plots.js").Plot} Plot
 * @typedef {import("./stage.js").Stage} Stage
 * @typedef {Plot | Stage} Subject
 */

const SAVE =
  '<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M8 2v8' +
  'M4.5 6.5 8 10l3.5-3.5M2.5 13.5h11"/></svg>'

export class Page {
  /** @type {Drawn} what is shown, from the first picture on */
  shown

  /** @type {import("./later/about.js").About | undefined} */
  about

  /** @type {import("./later/voice.js").Voice | undefined} for those who do not see it; it comes when all is drawn */
  voice

  /** @type {import("./later/print.js").Print | undefined} */
  print

  /** @type {Map<string, Element[]>} the elements of each live number */
  named = new Map()

  /** @type {Waits} what has been set and waits for the server */
  waiting = new Map()

  timePlaces = 2

  /** @type {Promise<void> | null} until every plot that is seen has its figure */
  joining = null

  left = false

  /**
   * `lecture` sends what the visitor does.
   * @param {page.SceneSheet} sheet @param {Extras} extras @param {Lecture} lecture
   */
  constructor(sheet, extras, lecture) {
    this.spec = sheet
    this.extras = extras
    this.lecture = lecture
    this.clock = new Clock(t => this.draw(t))
    this.hand = new Hand(this)
    this.root = element("div", {class: `page ${sheet.slug}`})
    this.paper = element("main", {class: "paper"})
    this.notice = element("div", {class: "notice", role: "alert", hidden: ""})
    this.sheet = new Sheet(this.spec.paper, this)
    this.heading = element("h1", {tabindex: -1}, this.spec.headline)
    this.paper.append(this.heading, this.notice, this.sheet.element)
    this.transport = extras.RunBar ? new extras.RunBar(this) : new Transport(this)
    this.paper.append(this.transport.element)
    this.panel = element("aside", {class: "panel", "aria-label": "Controls"})
    this.controls = buildControls(
      this.panel,
      this.spec.panel,
      message => this.send(message),
      sets => this.lecture.take(sets),
      extras.buildPicker,
    )
    this.controls.presets.element.append(this.lecture.undo.element)
    this.plots = this.sheet.plots
    this.stages = [...this.sheet.stages, ...this.controls.stages]
    for (const stage of this.stages) stage.resized = () => this.redraw()
    for (const plot of this.plots) plot.handles.help(this.controls)
    this.compare = new Compare(this)
    if (this.spec.about) this.panel.append(this.#aboutNumbers())
    this.panel.append(this.#tools())
    this.panel.append(lecture.hall.tab())
    this.root.append(this.paper, this.panel)
  }

  #aboutNumbers() {
    const fold = element("details", {class: "about"}, element("summary", {}, "About these numbers"))
    const open = () =>
      using("about", ({About}) => {
        if (!this.left) this.about = new About(fold, message => this.send(message))
      })
    fold.addEventListener("toggle", open, {once: true})
    return fold
  }

  #tools() {
    const link = copyButton(() => this.link)
    const title = "The numbers of all plots as a CSV file; several tables come in one ZIP file"
    this.csv = element("button", {type: "button", class: "chip", title}, "CSV")
    this.csv.addEventListener("click", () => this.send({type: "csv", page: location.origin + location.pathname}))
    const pictures = element("button", {type: "button", class: "chip"}, "Pictures")
    pictures.addEventListener("click", () => this.#take())
    for (const stage of this.sheet.stages.filter(({svg}) => svg.role === "img"))
      this.#takeable(stage.host, stage, stage.svg.getAttribute("aria-label") ?? "")
    for (const plot of this.plots) this.#takeable(plot.host.parentElement, plot, plot.block.title)
    const chips = element(
      "div",
      {class: "chips"},
      link,
      this.csv,
      pictures,
      ...this.spec.onward.map(way => this.#onward(way)),
    )
    const away = element("details", {class: "fold away"}, element("summary", {}, "Save and share"), chips)
    return element("div", {class: "tools"}, ...this.compare.buttons, away)
  }

  /**
   * A button on a plot or a stage, for the pointer; the keys have that among the tools.
   * @param {HTMLElement | null} host @param {Subject} subject @param {string} name
   */
  #takeable(host, subject, name) {
    const title = "Save the picture, or read its table"
    const button = element("button", {type: "button", class: "take", tabindex: -1, title})
    button.innerHTML = SAVE
    button.setAttribute("aria-label", `${title}: ${name}`)
    button.addEventListener("click", () => this.#take(subject))
    host?.append(button)
  }

  /** @param {Subject} [subject] */
  #take(subject) {
    using("take", ({take}) => this.left || take(this, subject))
  }

  /** A link that takes values of this scene along to another. @param {page.Onward} way */
  #onward({label, scene, given, taken}) {
    const link = element("a", {class: "chip", href: "#"}, label)
    link.addEventListener("click", event => {
      event.preventDefault()
      const values = Object.fromEntries(taken.map(name => [name, this.shown.settings[name].value]))
      this.lecture.open({scene, parameters: {...given, ...values}})
    })
    return link
  }

  /** @param {page.Said} message */
  send(message) {
    this.lecture.send(message)
  }

  /** @param {Drawn} shown @param {import("./line.js").Asked | null} [asked] what it is the answer to */
  apply(shown, asked = null) {
    this.shown = shown
    const {view, state} = shown
    this.compare.stand(shown)
    this.about?.changed()
    this.voice?.changed()
    this.sheet.update(shown)
    for (const [name, elements] of this.named) {
      if (name in view.values) for (const one of elements) one.textContent = view.values[name]
    }
    for (const name of view.left_out) for (const one of this.named.get(name) ?? []) coverNumber(one)
    this.hand.heard(shown)
    const absent = view.left_out.filter(name => !(name in view.signals || name in view.scalars))
    for (const stage of this.stages) stage.update(absent, coveredPlots(state))
    this.root.classList.toggle("at-rest", state.covered.includes("stage") && !state.before)
    this.root.classList.toggle("without-table", state.covered.includes("table"))
    for (const plot of this.plots) plot.update(shown)
    if (this.plots.some(plot => plot.waits)) this.join()
    this.controls.update(shown)
    this.compare.update(shown, asked)
    const blocks = this.plots.map(({block}) => block)
    if (this.csv) this.csv.textContent = tables(blocks, view) > 1 ? "CSV (ZIP)" : "CSV"
    this.measured = false
    this.clock.update(view.axes[view.time], view.pace)
    this.transport.update(shown)
    this.lecture.hall.shown(this)
    const {errors} = shown
    const problems = [...shown.problems, errors.message, errors.state].filter(Boolean)
    if (problems.length) this.notify(problems)
    requestAnimationFrame(() =>
      requestAnimationFrame(() => document.dispatchEvent(new CustomEvent("oscillations:painted"))),
    )
  }

  /** The curves switched off, by group. */
  get hidden() {
    return this.shown.state.hidden ?? this.spec.hidden
  }

  get link() {
    return `?${this.shown.query}${this.lecture.hall.ending}`
  }

  /** @param {string[]} problems */
  notify(problems) {
    const close = element("button", {type: "button", "aria-label": "Close"}, "×")
    close.addEventListener("click", () => {
      this.notice.hidden = true
    })
    this.notice.replaceChildren(element("span", {}, problems.join(" ")), close)
    this.notice.hidden = false
  }

  redraw() {
    this.measured = false
    this.clock.dirty = true
  }

  /** @param {number} at an instant, which passes unless all stands still */
  draw(at) {
    if (!this.shown) return
    const {axes, time, live: moving} = this.shown.view
    const named = this.compare.named(at)
    const {t} = named
    for (const [name, [places, signed]] of Object.entries(moving)) {
      const text = fixed(named[name], places, signed)
      for (const one of this.named.get(name) ?? []) one.textContent = text
    }
    const timeText = `${t.toFixed(this.timePlaces)} ${axes[time]?.unit ?? ""}`
    if (!this.measured) this.stages.forEach(stage => stage.measure(this.plots))
    this.measured = true
    this.compare.frame(t)
    this.stages.forEach(stage => stage.frame(named))
    this.plots.forEach(plot => plot.draw(named, t, timeText))
  }

  /** Shows the first picture: all but the figures, which join when they are ready. @param {Drawn} shown */
  start(shown) {
    this.name(this.root)
    this.apply(shown)
    this.stages.forEach(stage => stage.fit())
    const places = this.plots.map(plot => plot.place()) // all are read before anything is written
    this.plots.forEach((plot, i) => plot.layout(places[i]))
    this.draw(this.clock.t)
  }

  /** The live numbers of a part that has come to the page. @param {Element} part */
  name(part) {
    for (const one of part.querySelectorAll("[data-value]")) {
      const name = one.getAttribute("data-value") ?? ""
      this.named.set(name, [...(this.named.get(name) ?? []).filter(other => other.isConnected), one])
      one.textContent = this.shown?.view.values[name] ?? ""
    }
    this.redraw()
  }

  /** Each plot that is seen gets its figure, one a frame, so that what moves goes on moving. */
  join() {
    this.joining ??= this.#joinNext().finally(() => {
      this.joining = null
    })
    return this.joining
  }

  speak() {
    using("voice", ({Voice}) => this.left || (this.voice ??= new Voice(this)))
    using("print", ({Print}) => this.left || (this.print ??= new Print(this)))
    this.hand.introduce()
  }

  async #joinNext() {
    await frame()
    const plot = this.left ? undefined : this.plots.find(one => one.waits)
    if (!plot) return
    try {
      await bokeh()
    } catch {
      plot.figure.lacks() // until the connection is tried again, which needs it too
      return
    }
    if (this.left) return
    await plot.mount()
    await this.#joinNext()
  }

  leave() {
    this.left = true
    this.clock.stop()
    this.compare.leave()
    this.about?.leave()
    this.voice?.leave()
    this.print?.leave()
    for (const part of [...this.plots, ...this.stages]) part.leave()
    this.root.remove()
  }

  theme() {
    this.plots.forEach(plot => plot.theme())
  }
}

/** The next frame; a page in a tab that nobody sees is not waited for. */
export const frame = () => Promise.race([new Promise(requestAnimationFrame), new Promise(done => setTimeout(done, 50))])

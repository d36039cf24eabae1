// The page of one scene, with its control panel, built from its sheet. Each new picture goes to all parts in order; the
// clock updates the moving parts.

import {bokeh} from "../net/bokeh.js"
import {Controls, isPicker} from "../controls/controls.js"
import {Clock} from "../core/clock.js"
import {Compare} from "../compare/compare.js"
import {element, frame, setAttributes, unitSize} from "../core/dom.js"
import {guarded} from "../core/faults.js"
import {Hand} from "../controls/hand.js"
import {later, using} from "../later.js"
import {Live} from "./live.js"
import {Notice} from "../core/notes.js"
import {ReadingOrder} from "./reading_order.js"
import {Sheet} from "./sheet.js"
import {Tools} from "../shell/tools.js"
import {PAPER, Views} from "./views.js"
import {Transport} from "../controls/transport.js"

/**
 * Modules that only some sheets need.
 * @typedef {{RunBar?: typeof import("./run_bar.js").RunBar,
 *   pictured?: typeof import("./picker.js").pictured}} Extras
 */

const BETWEEN_TEXTS = 80 // ms between changes of moving numbers while playing, because each costs layout

/** @implements {PartHost} */
export class Page {
  /** @type {Drawn} the current picture, set from the first one on */
  shown

  /** @type {import("./about.js").About | undefined} */
  about

  /** @type {import("./voice.js").Voice | undefined} for screen readers; loaded when everything is drawn */
  voice

  /** @type {import("../export/print.js").Print | undefined} */
  print

  /** @type {Waits} values that wait to be sent */
  waiting = new Map()

  /** @type {Promise<void> | null} resolves when every visible plot has its figure */
  joining = null

  /** @type {Hand} */ hand
  /** @type {Sheet} */ sheet
  /** @type {Transport | import("./run_bar.js").RunBar} */ transport
  /** @type {Compare} */ compare

  writtenAt = -Infinity // ms, when the moving numbers were last written
  timeText = "" // the text of the time that was written then
  isMeasuring = false // set once the view of measured points has been shown
  left = false
  live = new Live()
  notice = new Notice()

  /** @param {page.SceneSheet} sheet @param {Extras} extras @param {PageHost} host */
  constructor(sheet, {RunBar, pictured}, host) {
    this.spec = sheet
    this.host = host
    this.clock = new Clock(t => this.draw(t))
    this.hand = new Hand(this)
    this.root = element("div", {class: `page ${sheet.slug}`})
    this.paper = element("main", {class: "paper"})
    this.sheet = new Sheet(sheet.paper, this)
    setAttributes(this.sheet.element, {id: PAPER, role: sheet.views.length ? "tabpanel" : null})
    this.heading = element("h1", {tabindex: -1}, sheet.headline)
    this.transport = new (RunBar ?? Transport)(this)
    const send = (/** @type {page.BrowserMessage} */ message) => this.send(message)
    this.views = new Views(sheet.views, send)
    this.root.classList.toggle("in-views", sheet.views.length > 0)
    const {heading, notice, views, transport} = this
    this.paper.append(heading, notice.element, views.element, this.sheet.element, transport.element)
    this.panel = element("aside", {class: "panel", "aria-label": "Controls"})
    this.controls = new Controls(this.panel, sheet, send, sets => host.take(sets), pictured)
    this.plots = this.sheet.plots
    this.stages = [...this.sheet.stages, ...this.controls.stages]
    for (const stage of this.stages) stage.resized = () => this.redraw()
    for (const plot of this.plots) plot.handles.help(this.controls)
    this.compare = new Compare(this)
    if (sheet.about) this.panel.append(this.#aboutNumbers())
    this.tools = new Tools(this)
    this.panel.append(this.tools.element)
    this.root.append(this.paper, this.panel)
    this.order = new ReadingOrder(this)
    this.parts = this.#parts()
  }

  /** The parts in the order in which they get a picture, including those loaded later. @returns {Part[]} */
  #parts() {
    const {compare, views, sheet, order, live, hand, stages, plots, controls, clock, transport, notice, tools} = this
    const freeze = {update: (/** @type {Drawn} */ shown) => compare.freeze(shown)} // before other parts
    const parts = [views, sheet, order, live, hand, ...stages, ...plots]
    return [freeze, ...parts, controls, compare, clock, transport, notice, tools]
  }

  #aboutNumbers() {
    const fold = element("details", {class: "about"}, element("summary", {}, "About these numbers"))
    const open = () =>
      using("scene/about", ({About}) => {
        if (!this.left) this.parts.push((this.about = new About(fold, message => this.send(message))))
      })
    fold.addEventListener("toggle", open, {once: true})
    return fold
  }

  /** Fetches the part for measured points when its view is first shown; a follower of a class has none. */
  #measure() {
    const {measured} = this.sheet
    const isSeen = [...measured.values()].some(host => !host.closest("[hidden]"))
    if (this.isMeasuring || !isSeen || !this.host.messages.request) return
    this.isMeasuring = true
    using("measured/measured", ({MeasuredView}) => this.left || this.parts.push(new MeasuredView(this, measured)))
  }

  /** @param {page.BrowserMessage} message */
  send(message) {
    this.host.send(message)
  }

  /** @param {Drawn} shown @param {import("../net/messages.js").Asked | null} [asked] the message that it answers */
  apply(shown, asked = null) {
    this.shown = shown
    unitSize() // also reads all computed styles before anything is written
    for (const part of this.parts) guarded(() => part.update?.(shown, asked))
    this.redraw()
    this.#measure()
    requestAnimationFrame(() =>
      requestAnimationFrame(() => document.dispatchEvent(new CustomEvent("oscillations:painted"))),
    )
  }

  /**
   * Handles `Kept`, the answer for an unchanged picture: only parts that wait for an answer get it.
   * @param {Drawn["answer"]} answer @param {import("../net/messages.js").Asked | null} asked
   */
  keep(answer, asked) {
    const shown = {...this.shown, answer}
    guarded(() => this.hand.update(shown))
    guarded(() => this.compare.update(shown, asked))
  }

  /** The groups of curves that are switched off. */
  get hidden() {
    return this.shown.state.hidden ?? this.spec.hidden
  }

  get link() {
    return `?${this.shown.query}${this.host.hall.ending}`
  }

  redraw() {
    this.measured = false
    this.writtenAt = -Infinity
    this.clock.dirty = true
  }

  /** @param {number} at an instant; ignored if nothing moves */
  draw(at) {
    if (!this.shown) return
    unitSize() // as above, because reading after writing would compute the layout twice in a frame
    if (!this.measured) guarded(() => this.order.follow())
    const {axes, time} = this.shown.view
    const named = this.compare.named(at)
    const {t} = named
    const now = performance.now()
    const writes = !this.clock.playing || now - this.writtenAt > BETWEEN_TEXTS
    if (writes) {
      this.writtenAt = now
      this.timeText = `${t.toFixed(this.clock.places)} ${axes[time]?.unit ?? ""}`
      guarded(() => this.live.draw(named))
    }
    if (!this.measured) this.stages.forEach(stage => guarded(() => stage.measure(this.plots)))
    this.measured = true
    guarded(() => this.compare.frame(t, writes))
    this.stages.forEach(stage => guarded(() => stage.frame(named)))
    this.plots.forEach(plot => guarded(() => plot.draw(named, t, this.timeText)))
  }

  /** Shows the first picture, except the figures, which come later. @param {Drawn} shown */
  start(shown) {
    this.live.find(this.root)
    this.order.follow() // before rows that scroll have a position, which a move would reset
    this.apply(shown)
    this.place()
    this.draw(this.clock.t)
  }

  /** Updates the layout of everything that is drawn in pixels. */
  place() {
    this.stages.forEach(stage => stage.place())
    const rooms = this.plots.map(plot => plot.room) // read all sizes before anything is written
    this.plots.forEach((plot, i) => plot.place(rooms[i]))
    this.redraw()
  }

  /** Creates the figures of visible plots, one per frame, so that the animation does not stop. */
  join() {
    this.joining ??= this.#joinNext().finally(() => {
      this.joining = null
    })
    return this.joining
  }

  speak() {
    using("scene/voice", ({Voice}) => this.left || this.voice || this.parts.push((this.voice = new Voice(this))))
    using("export/print", ({Print}) => this.left || this.print || this.parts.push((this.print = new Print(this))))
  }

  async #joinNext() {
    await frame()
    const plot = this.left ? undefined : this.plots.find(one => one.needsFigure)
    if (!plot) return
    try {
      await bokeh()
    } catch {
      plot.figure.lacks() // try again with the next connection
      return
    }
    if (this.left) return
    await plot.mount()
    await this.#joinNext()
  }

  leave() {
    this.left = true
    for (const part of this.parts) guarded(() => part.leave?.())
    this.root.remove()
  }

  theme() {
    this.plots.forEach(plot => plot.theme())
  }
}

/** Loads the modules that only some scenes need. @param {page.SceneSheet} sheet @returns {Promise<Extras>} */
export async function extrasFor({runs, panel}) {
  const picks = panel.groups.some(group => group.rows.some(isPicker))
  const [bar, picker] = await Promise.all([runs && later("scene/run_bar"), picks && later("scene/picker")])
  return {...bar, ...picker}
}

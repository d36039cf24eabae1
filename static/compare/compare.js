// Comparison: the held picture next to the current one, the curves from before a drag, and the parts that are hidden
// until the visitor has predicted them. The drawing modules are loaded when they are needed.

import {chip} from "../core/dom.js"
import {later, using} from "../later.js"
import {toSI} from "../core/ruler.js"
import {evaluate, roots} from "../core/signals.js"

const LINGER = 1500 // ms for which the earlier curves stay visible after a drag
const LAST = 500 // ms without another key press, after which a change by keys counts as finished

export class Compare {
  /** @type {import("./ghosts.js").Ghosts | undefined} */
  ghosts

  /** @type {Promise<void> | undefined} */
  coming

  /** @type {Drawn | null} the picture from before a drag */
  beforeDrag = null

  /** @type {string} id of the press of a pointer or key that changes the picture */
  press = ""

  pressed = false

  /** @type {Named | null} the frozen time and signals, while the visitor predicts */
  still = null

  /** @type {number | undefined} */
  ending

  /** @type {number | undefined} set until the server knows that the drag or key press has ended */
  leaving

  undoGroup = "" // one undo takes back the drag and the fit of the frame after it

  /** @type {string[]} the axes along which handles were moved during this drag */
  along = []

  /** @type {Drawn | null} */
  last = null

  /** @param {PartHost} page */
  constructor(page) {
    this.page = page
    this.hold = chip("Hold", () => this.toggle(), {title: "Keep these curves for comparison (H)"})
    this.predict = chip("Predict", () => this.#predict(), {title: "Hide a picture and guess it first"})
    this.gone = new AbortController()
    const how = {capture: true, signal: this.gone.signal}
    for (const name of ["pointerdown", "keydown"]) addEventListener(name, () => (this.pressed = true), how)
    for (const name of ["pointerup", "pointercancel", "keyup"])
      addEventListener(name, event => this.#released(event), how)
  }

  /** Button Hold: keeps the current picture for comparison, or drops the one that was kept. */
  toggle() {
    this.page.host.change(({held, before, parameters}) => ({held: held ? null : (before ?? parameters)}))
  }

  /** Button Predict: lets the visitor choose parts to cover. If some are covered, it uncovers them all. */
  #predict() {
    const {host, shown} = this.page
    if (shown.state.covered.length) return host.change(() => ({covered: []}))
    using("compare/predict", ({choose}) => choose(this.page, this.predict))
  }

  /** Covers one more part of the page, until the visitor has predicted it. @param {string} cover */
  cover(cover) {
    this.page.host.change(({covered}) => ({covered: [...covered, cover]}))
  }

  /** Uncovers a part, and also the stage, because its motion shows the answer. @param {string} cover */
  reveal(cover) {
    const open = new Set([cover, "next", "stage"])
    this.page.host.change(({covered}) => ({covered: covered.filter(name => !open.has(name))}))
  }

  /**
   * Remembers the current curves when a pointer or key makes its first change.
   * @param {string} press @param {string} undoGroup @param {page.BrowserMessage} message
   */
  set(press, undoGroup, message) {
    if (!undoGroup) return
    const goesOn = press === this.press || (this.beforeDrag && press.startsWith("key") && this.press.startsWith("key"))
    if (!goesOn || !this.beforeDrag) this.beforeDrag = this.page.shown
    this.press = press
    this.undoGroup = "holding" in message ? "" : undoGroup // a grip reports the end of its drag itself
    clearTimeout(this.ending)
    clearTimeout(this.leaving)
    if (!this.pressed) this.#released()
  }

  /** @param {Event} [event] */
  #released(event) {
    this.pressed = false
    if (!this.beforeDrag) return
    clearTimeout(this.leaving)
    const isLast = !this.press.startsWith("key") || (event instanceof KeyboardEvent && event.key === "Enter")
    this.leaving = setTimeout(() => this.#letGo(), isLast ? 0 : LAST)
  }

  /**
   * Tells the server that the change by a slider or key has ended. The server may then fit the frame again; one undo
   * takes back the change and the fit.
   */
  #letGo() {
    const {undoGroup} = this
    if (undoGroup)
      this.page.host.messages.send({type: "set", values: {}, holding: false, along: this.along}, {undoGroup})
    Object.assign(this, {undoGroup: "", press: "", along: []})
  }

  /** Shows the curves of this picture under the next picture, in the same frame. */
  keep() {
    this.beforeDrag = this.page.shown
    this.press = ""
    clearTimeout(this.ending)
  }

  #forget() {
    this.beforeDrag = null
    this.#draw()
  }

  /**
   * Freezes the drawing while the visitor has to predict a change. When the change is revealed, the clock restarts from
   * 0.
   * @param {Drawn} shown
   */
  freeze({state, view: {signals, scalars}}) {
    const {clock, hand, transport} = this.page
    const isAsked = Boolean(state.before)
    if (isAsked) clock.playing = false
    if (isAsked === Boolean(this.still)) return
    // Disable every control except the note with the reason, which screen readers read out.
    for (const part of transport.element.children) part.toggleAttribute("inert", isAsked && part !== transport.note)
    const {t} = clock
    this.still = isAsked ? {...roots(signals, evaluate(signals, scalars, t, hand.grab?.named ?? {})), t} : null
    if (!isAsked) clock.restart()
  }

  /** The drawn numbers at time `t`; a drag in progress replaces some of them. @param {number} t */
  named(t) {
    const {hand, shown} = this.page
    const {signals, scalars} = shown.view
    const named = evaluate(signals, scalars, this.still?.t ?? t, {...this.still, ...hand.pointed, ...hand.grab?.named})
    if (this.still && hand.grab) this.still = {...roots(signals, named), t: named.t}
    return named
  }

  /** @param {Drawn} shown @param {import("../net/messages.js").Asked | null} asked */
  update(shown, asked) {
    const {held, state} = shown
    if (asked && !asked.undoGroup) this.beforeDrag = null
    if (hasLetGo(asked?.message)) this.ending = setTimeout(() => this.#forget(), LINGER)
    if (this.last && isCloser(shown, this.last)) clearTimeout(this.ending) // keep them for now
    this.last = shown
    const isHeld = Boolean(state.held)
    this.hold.textContent = isHeld ? "Release" : "Hold"
    this.hold.setAttribute("aria-pressed", String(isHeld))
    const isCovered = state.covered.length > 0
    this.predict.textContent = isCovered ? "Reveal" : "Predict"
    this.predict.setAttribute("aria-pressed", String(isCovered))
    this.predict.hidden = Boolean(state.step)
    if (held || this.beforeDrag) this.coming ??= this.#come()
    this.#draw()
  }

  /** A sentence on what the visitor has covered, and how it comes back. @param {page.State} state */
  says({covered, before, step}) {
    if (step || !covered.length) return ""
    if (before) return "Covered: what do you expect? Press Reveal to see it and to play."
    if (covered.includes("next")) return "The next change is covered until you press Reveal: change something."
    return "Covered until you press Reveal."
  }

  async #come() {
    const {Ghosts} = await later("compare/ghosts")
    this.ghosts = new Ghosts(this.page)
    this.#draw()
  }

  /** True if the parameters are no longer those of the earlier curves. */
  #differs() {
    const {held, parameters} = this.page.shown.state
    const earlier = held ?? this.beforeDrag?.state.parameters
    return JSON.stringify(earlier) !== JSON.stringify(parameters)
  }

  /** Draws the compared picture, or else the one from before a drag. */
  #draw() {
    const {shown} = this.page
    const {held, view, state} = shown
    const name = state.step && this.#differs() ? "before" : "" // in a step of a walk, label the curves of the question
    /** @type {import("./ghosts.js").Under | null} */
    let under = null
    if (held) under = {columns: held.columns, axes: view.axes, name: name || "held"}
    else if (this.beforeDrag && this.beforeDrag !== shown) {
      under = {columns: this.beforeDrag.view.columns, axes: this.beforeDrag.view.axes, name}
    }
    this.ghosts?.update(under, held)
  }

  /** Called in each animation frame. @param {number} t @param {boolean} writes true if numbers are written again */
  frame(t, writes) {
    this.ghosts?.frame(t, writes)
  }

  leave() {
    this.gone.abort()
    clearTimeout(this.ending)
    clearTimeout(this.leaving)
  }
}

/** @param {page.BrowserMessage | undefined} message */
const hasLetGo = message => message?.type === "set" && message.holding === false

/**
 * True if an axis shows a smaller range than before: then it was fitted again.
 * @param {Drawn} shown @param {Drawn} before
 */
function isCloser({view: {axes}}, {view: {axes: old}}) {
  return Object.keys(axes).some(name => name in old && size(axes[name]) < 0.999 * size(old[name]))
}

/** @param {page.Ruler} ruler */
const size = ruler => Math.abs(toSI(ruler, ruler.end) - toSI(ruler, ruler.start))

// The entry module: one connection to the server, and one page per scene, which replace each other without a reload.

import {Address, plainLink, written} from "./net/address.js"
import {unpacked} from "./net/columns.js"
import {Classes} from "./live_class/classes.js"
import {Busy} from "./core/busy.js"
import {anchor} from "./controls/anchor.js"
import {Connection} from "./net/connection.js"
import {Hall} from "./shell/hall.js"
import {frame} from "./core/dom.js"
import {guarded, report, watch} from "./core/faults.js"
import {listen} from "./controls/keys.js"
import {Messages} from "./net/messages.js"
import {Page, extrasFor} from "./scene/page.js"
import {download} from "./export/save.js"
import {Sheets} from "./net/sheets.js"
import {Shell} from "./shell/shell.js"
import {Undo} from "./shell/undo.js"
import {tabStorage} from "./core/storage.js"
import {showWaiting} from "./controls/waiting.js"
import {Walks} from "./walks/walks.js"

/** @typedef {import("./net/messages.js").Asked} Asked */

const UNANSWERED = "left" // unanswered messages of the previous page

/** @implements {LectureHost} */
export class Lecture {
  /** @type {Page} the visible page */
  page

  sheets = new Sheets()

  /** @type {Promise<unknown>} */
  turning = Promise.resolve()

  /** @type {Promise<void> | undefined} resolves when the first try to connect has ended */
  connected

  /** @type {Hall} */ hall
  /** @type {Walks} */ walks
  /** @type {Classes} */ classes

  busy = new Busy()

  address = new Address()

  /** @param {string} token of the session that the page was served with */
  constructor(token) {
    this.token = token
    this.messages = new Messages(
      packet => this.#unpacked(packet),
      (message, asked) => this.#handle(message, asked),
      error => this.#fail(error),
      report,
    )
    this.undo = new Undo(
      (open, about) => this.#go(open, about),
      () => this.open({scene: this.kept.scene}),
    )
    this.shell = new Shell(this)
    this.hall = new Hall(this)
    listen(this)
    this.walks = new Walks(this)
    this.classes = new Classes(this)
    this.connection = new Connection(this.messages, {
      link: () => plainLink(this.page.spec.slug),
      changed: () => this.#connected(),
      outdated: () => this.busy.whenFree(() => this.#reload()),
    })
    this.host = /** @type {HTMLElement} */ (document.getElementById("app"))
    // the address omits changes that are not answered yet
    addEventListener("pagehide", () => tabStorage.keep(UNANSWERED, this.messages.rests ? null : this.left))
    addEventListener("popstate", ({state: entry}) => {
      const {waiting: _, ...state} = entry ?? {}
      if (entry) this.#go({type: "open", state})
    })
  }

  /** The last state that the server sent. */
  get kept() {
    return this.messages.state
  }

  // Available to tests and in the browser's console.
  get clock() {
    return this.page.clock
  }
  get shown() {
    return this.page.shown
  }
  get plots() {
    return this.page.plots
  }
  get stages() {
    return this.page.stages
  }
  get about() {
    return this.page.about
  }

  /** @param {page.BrowserMessage} message */
  send(message) {
    this.page.compare.set(this.undo.press, this.undo.undoGroup(message), message)
    this.messages.send(message, {undoGroup: this.undo.undoGroup(message)})
    this.#wait()
  }

  /** Opens a state, which resets every control. @type {Messages["send"]} */
  #go(message, about) {
    this.page?.controls.release() // there is no page yet if the visitor follows a link early
    this.messages.send(message, about)
    this.#wait()
  }

  /** Shows values that have not been sent yet as if they were set. */
  #wait() {
    if (!this.page) return
    showWaiting(this.page, this.messages.waiting)
    this.connection.status.waits(this.messages.changes, this.shell.titleOf(this.messages.turnsTo))
  }

  #connected() {
    this.#wait()
    if (!this.connection.wire) return
    this.classes.connected()
    this.#complete(this.page)
  }

  /** Plots that could not be drawn are drawn after the next connection. @param {Page} page */
  async #complete(page) {
    await page.join()
    page.speak()
  }

  /** The state and the unsent values, for the page after a reload. */
  get left() {
    return {...this.messages.state, waiting: this.messages.left}
  }

  /** Reloads the page because the server has another version; state and unsent values are kept. */
  #reload() {
    const {address} = written(this.page.shown, this.hall.ending)
    this.address.write({address, entry: this.left}, false)
    this.address.settle()
    location.reload()
  }

  /**
   * Opens another scene, or another state of this one, in this session; missing parameters get their defaults.
   * If `carried`, parameters that the scenes share keep their values.
   * @param {Pick<page.State, "scene"> & Partial<page.State>} state
   */
  open(state, carried = false) {
    this.#go({type: "open", state: /** @type {page.State} */ (state), carried}, {turn: true})
  }

  /** Opens the current state with some changes. @param {(state: page.State) => Partial<page.State>} change */
  #changed(change) {
    return (/** @type {page.State} */ state) => ({
      type: /** @type {const} */ ("open"),
      state: {...state, ...change(state)},
    })
  }

  /** Applies a preset with a fitted frame, from t = 0; the back button undoes it. @param {page.State["parameters"]}
   * sets */
  take(sets) {
    const open = this.#changed(({parameters}) => ({frame: null, parameters: {...parameters, ...sets}}))
    this.#go(open, {turn: true, start: true, sets})
  }

  /** Opens another state with the same values. @param {(state: page.State) => Partial<page.State>} to */
  change(to) {
    this.messages.send(this.#changed(to))
  }

  /** Fits the frame to the current picture. */
  fit() {
    this.change(() => ({frame: null}))
  }

  /** @param {Packet} packet */
  async #unpacked({sheet, data}) {
    return unpacked(data, sheet ? (await this.sheets.fetch(sheet)).preset_dictionary : "")
  }

  /** Reconnects after an unreadable message or a failed request. */
  #fail(/** @type {unknown} */ error) {
    console.warn(error)
    if (!this.page) throw error
    this.connection.lose()
  }

  /** @param {ServerMessage} message @param {Asked | null} asked the message that it answers */
  #handle(message, asked) {
    guarded(() => asked?.answered?.(message))
    if (message.type === "about") this.page.about?.show(message)
    if (message.type === "file") download(message)
    const {answer} = message
    if (message.type === "kept") this.#next(() => this.page.keep(answer, asked))
    if (message.type !== "shown") return
    guarded(() => this.undo.record(message.state, asked ?? {}))
    this.#next(() => this.#show(message, asked))
  }

  /** Shows pictures in the order of their messages. @param {() => unknown} act */
  #next(act) {
    this.turning = this.turning.then(act).catch(report)
  }

  /** @param {Drawn} shown @param {Asked | null} asked */
  async #show(shown, asked) {
    guarded(() => this.hall.applyStep(shown.state))
    if (shown.scene === this.page?.spec.slug) {
      guarded(() => this.#wait()) // the picture overwrites the marks, so mark unsent values before and after
      this.page.apply(shown, asked)
      guarded(() => this.hall.shown(this.page))
      guarded(() => this.#wait())
    } else if (!(await this.#turn(shown))) return
    const refused = Object.keys(shown.errors).length > 0
    if (asked?.start && !refused && !shown.state.before) this.page.clock.restart()
    guarded(() => this.#write(shown, Boolean(asked?.turn) && !refused))
    guarded(() => this.walks.shown(shown))
  }

  /** Replaces the page by another scene's; its figures are added later. @param {Drawn} shown */
  async #turn(shown) {
    document.documentElement.dataset.ready = "false"
    const [fetched] = await Promise.all([this.#fetched(shown.sheet), this.walks.prepare(shown.state)])
    const page = fetched && this.#built(fetched, shown)
    if (!page) document.documentElement.dataset.ready = "true" // the old page stays
    return Boolean(page)
  }

  /** Loads the sheet and modules of a page; null if that fails. @param {string} address of the sheet */
  async #fetched(address) {
    try {
      const sheet = await this.sheets.fetch(address)
      return {sheet, extras: await extrasFor(sheet)}
    } catch (error) {
      this.#fail(error)
      return null
    }
  }

  /**
   * Builds the page of another scene and shows it; null if a script fails.
   * @param {{sheet: page.SceneSheet, extras: import("./scene/page.js").Extras}} fetched @param {Drawn} shown
   */
  #built({sheet, extras}, shown) {
    try {
      const page = new Page(sheet, extras, this)
      const before = this.page
      page.controls.presets.title.after(this.undo.element)
      page.panel.append(this.hall.tab())
      this.host.querySelector(".page")?.remove()
      this.host.append(page.root)
      page.start(shown)
      this.hall.shown(page)
      showWaiting(page, this.messages.waiting)
      this.page = page
      this.shell.turned(sheet, Boolean(before))
      this.#whole(page, before)
      return page
    } catch (error) {
      report(error)
      return null
    }
  }

  /** @param {Page} page @param {Page} [before] */
  async #whole(page, before) {
    await frame()
    before?.leave()
    this.connected ??= this.connection.begin(this.token)
    await Promise.all([this.connected, page.join()])
    if (page === this.page) document.documentElement.dataset.ready = "true"
    await this.#complete(page)
  }

  /**
   * Updates the address. Another scene, step or view (`turn`) adds a history entry; a value only changes the current
   * entry.
   * @param {Drawn} shown @param {boolean} turn
   */
  #write(shown, turn) {
    const what = written(shown, this.hall.ending)
    if (turn) this.address.turn(what)
    else this.address.write(what, Boolean(this.messages.asked))
  }

  /** Updates the address after a change of display. */
  readdress() {
    this.#write(this.page.shown, false)
    this.address.settle()
  }
}

/** Reads the first picture, which is part of the page and packed like any message. */
export function begin() {
  watch()
  anchor()
  const {token, sheet, data} = JSON.parse(document.getElementById("opening")?.textContent ?? "")
  const [came] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType("navigation"))
  const {waiting, ...state} = (came?.type === "reload" && tabStorage.value(UNANSWERED)) || history.state || {}
  tabStorage.forget(UNANSWERED)
  const {messages} = (globalThis.oscillations = new Lecture(token))
  messages.receive({sheet, data: Uint8Array.from(atob(data), sign => sign.charCodeAt(0)).buffer})
  // State that an earlier version of this page left before it reloaded.
  if (waiting) for (const message of [{type: "open", state}, ...waiting]) messages.send(message)
}

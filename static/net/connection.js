// The connection to the server. If it breaks, the page says so and reconnects with a new token and the current state.

import {bokeh} from "./bokeh.js"
import {Status} from "./status.js"
import {connect} from "./wire.js"

const FIRST = 1000 // ms, the pause after the first failed try; each later one is twice as long
const LONGEST = 30000
const STEADY = 10000 // ms; if a connection that lasted this long breaks, the first try follows at once
const PATIENCE = 15000 // ms until a try counts as failed

/**
 * `link` returns the address from which the page is fetched again. `changed` is called when the
 * connection is lost or restored, `outdated` when the server has another version of the page.
 * @typedef {{link: () => string, changed: () => void, outdated: () => void}} Options
 */

export class Connection {
  /** @type {import("./wire.js").Wire | null} */
  wire = null

  isOutdated = false
  trying = false
  tries = -1 // failed tries since the last connection that lasted
  refused = 0 // attempts in which the page was loaded but the socket failed
  since = 0
  token = "" // the last signed token of this page, by which the server recognises it
  ticket = "" // proof of its place in the line while the server is full

  /** @type {number | undefined} */
  timer

  /** @param {import("./messages.js").Messages} messages @param {Options} options */
  constructor(messages, options) {
    this.messages = messages
    this.options = options
    this.status = new Status(() => this.#again())
    messages.overdue = () => this.lose()
    addEventListener("offline", () => this.lose())
    addEventListener("online", () => this.#again())
    document.addEventListener("visibilitychange", () => document.hidden || this.#wake())
    addEventListener("pageshow", ({persisted}) => persisted && this.#wake())
    document.documentElement.dataset.connected = "false"
  }

  /** Connects with the page's own token, which may have expired. @param {string} token */
  async begin(token) {
    await this.#try(() => this.#open(token, false))
  }

  /** @param {string} token @param {boolean} isNew for a new session */
  async #open(token, isNew) {
    this.token = token
    await bokeh()
    const opened = connect(
      token,
      packet => this.messages.receive(packet),
      () => this.lose(),
    )
    try {
      this.wire = await inTime(opened)
    } catch (reason) {
      opened.then(
        late => late.close(),
        () => {},
      )
      this.refused++
      throw reason
    }
    this.since = performance.now()
    this.refused = 0
    this.messages.attach(this.wire, isNew)
    this.status.found()
    this.#tell()
    document.dispatchEvent(new CustomEvent("oscillations:connected"))
  }

  lose() {
    if (!this.wire) return
    if (performance.now() - this.since > STEADY) this.tries = 0
    this.wire.close()
    this.wire = null
    this.messages.detach()
    this.#showStatus()
    this.#pause()
  }

  #showStatus() {
    this.status.say(this.refused > 1)
    this.#tell()
  }

  #tell() {
    document.documentElement.dataset.connected = String(Boolean(this.wire))
    this.options.changed()
  }

  /**
   * Reconnects at once if the last connection lasted, else after growing random pauses, so that visitors do not all
   * come at once.
   */
  #pause() {
    const pause = this.tries ? Math.min(FIRST * 2 ** (this.tries - 1), LONGEST) * (0.5 + Math.random()) : 0
    this.status.wait(pause)
    clearTimeout(this.timer)
    this.timer = setTimeout(() => this.#again(), pause)
  }

  /** Reconnects when the page becomes visible again. */
  #wake() {
    this.messages.probe()
    this.#again()
  }

  async #again() {
    if (!this.wire && !this.isOutdated) await this.#try(() => this.#renew())
  }

  async #renew() {
    const {token, version} = await this.#served(this.options.link())
    if (version === versionOf(document)) return this.#open(token, true)
    this.isOutdated = true
    this.status.outdated()
    this.options.outdated()
  }

  /** Fetches a token for a new session, and the version of its page. @param {string} link */
  async #served(link) {
    const headers = {"Page-Token": this.token, "Page-Ticket": this.ticket}
    const answer = await fetch(link, {cache: "no-store", headers, signal: AbortSignal.timeout(PATIENCE)})
    this.ticket = answer.headers.get("Page-Ticket") ?? ""
    const page = new DOMParser().parseFromString(await answer.text(), "text/html")
    const {token} = JSON.parse(page.getElementById("opening")?.textContent ?? "")
    return {token, version: versionOf(page)}
  }

  /** @param {() => Promise<void>} attempt */
  async #try(attempt) {
    if (this.trying) return
    clearTimeout(this.timer)
    this.trying = true
    try {
      await attempt()
    } catch {
      this.#showStatus()
    }
    this.trying = false
    this.tries++
    if (!this.wire && !this.isOutdated) this.#pause()
  }
}

/** The addresses of the scripts and of all sheets in a page. @param {Document} page */
function versionOf(page) {
  const sheets = [...page.querySelectorAll("[data-sheet]")].map(link => link.getAttribute("data-sheet"))
  return [page.documentElement.dataset.version, ...sheets].join()
}

/**
 * @template Value
 * @param {Promise<Value>} promise @returns {Promise<Value>}
 */
const inTime = promise =>
  Promise.race([
    promise,
    new Promise((_, failed) => setTimeout(() => failed(new Error("There is no answer.")), PATIENCE)),
  ])

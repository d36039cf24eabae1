// A phone as the instructor's remote control. After the instructor's screen has let it in, it shows the question, the
// answers of the class, and what the next press does.

import {button, chip, element, marked} from "../core/dom.js"
import {inWords} from "../core/notes.js"
import {tabStorage} from "../core/storage.js"
import {Countdown} from "./countdown.js"
import {Timing} from "./timing.js"
import {brief, haveAllAnswered} from "./brief.js"
import {Refusal, fetchJson, hasEnded, insist, isMissing} from "./requests.js"

const DOUBTS = 30 // number of requests for a missing class before it counts as over; its server may be restarting
const ASKING = 1000 // ms between requests
const BUZZ = 200 // ms of vibration when everyone has answered
const DEEDS = /** @type {[string, page.Deed][]} */ ([
  ["How it follows", "derive"], ["Show the answer", "show"], ["Vote again", "again"], ["How sure?", "sure"],
  ["30 s", "countdown"],
  ["Close at 0", "closing"],
  ["Vote A to D", "poll"],
  ["Contents", "go"], ["Close the QR code", "close"], ["Blank the screen", "blank"], ["Back", "back"], ["Next", "next"],
]) // prettier-ignore

/** @param {string} code @param {string} ticket */
export async function control(code, ticket) {
  const host = /** @type {HTMLElement} */ (document.querySelector(".class-wait"))
  host.classList.add("class-remote")
  try {
    const paired = await pairedWith(code, ticket, why => host.replaceChildren(element("h1", {}, why)))
    history.replaceState(null, "", location.search)
    new Remote(host, code, paired).look()
  } catch (reason) {
    host.replaceChildren(element("h1", {}, inWords(reason)))
  }
}

/**
 * The key of this remote control. It is stored, so that a reloaded page keeps it.
 * @param {string} code @param {string} ticket @param {(why: string) => void} say @returns {Promise<page.Paired>}
 */
async function pairedWith(code, ticket, say) {
  const name = `remote-${code}-${ticket}`
  const kept = /** @type {page.Paired | null} */ (tabStorage.value(name))
  if (kept) return kept
  const request = () => fetchJson(`${code}/remote`, {method: "PUT", body: {address: ticket}})
  const paired = await insist(request, {failed: reason => say(inWords(reason))})
  tabStorage.keep(name, paired)
  return paired
}

class Remote {
  /** @param {HTMLElement} host @param {string} code @param {page.Paired} paired */
  constructor(host, code, paired) {
    this.host = host
    this.code = code
    this.paired = paired
    this.state = element("p", {role: "status"})
    this.host.replaceChildren(
      element("h1", {class: "digits"}, paired.digits),
      element("p", {}, "Confirm on the lecturer's screen: it shows these two digits."),
    )
  }

  isIn = false
  over = false
  doubts = 0

  /** @type {page.RemoteView | null} the data that are shown */
  view = null

  async look() {
    const {code, paired, view} = this
    const after = view ? `?after=${view.number}` : ""
    /** @type {page.RemoteView | null | undefined} */
    const news = await fetchJson(`${code}/remote${after}`, {word: paired.key}).catch(reason => this.#failed(reason))
    if (this.over) return
    if (news !== undefined) this.doubts = 0
    if (news === null && !this.isIn) this.state.textContent = "" // it waits
    if (news) this.#show(news)
    setTimeout(() => this.look(), ASKING)
  }

  /** @param {page.RemoteView} view */
  #show(view) {
    const before = this.view
    this.view = view
    if (!this.isIn) this.#enter()
    this.state.textContent = view.question.place || "No question is open now."
    this.countdown.show(view.question)
    this.#fill()
    this.#ready()
    if (haveAllAnswered(view) && !haveAllAnswered(before)) navigator.vibrate?.(BUZZ)
  }

  body = this.#body()
  isPressed = false // do not update while a finger presses a button

  #body() {
    const body = element("div", {class: "remote-body"})
    body.addEventListener("pointerdown", () => (this.isPressed = true))
    for (const end of ["click", "pointercancel"])
      body.addEventListener(end, () => {
        this.isPressed = false
        this.#fill()
      })
    return body
  }

  #fill() {
    if (!this.view || this.isPressed) return
    const moderate = (/** @type {string} */ text, /** @type {boolean} */ shows) =>
      this.#do({deed: shows ? "allow" : "remove", text})
    this.body.replaceChildren(...brief(this.view, this.code, moderate))
  }

  /** The buttons stay in the document, because a press on a button that is replaced meanwhile would be lost. */
  buttons = DEEDS.map(([name, deed]) => ({
    name,
    deed,
    element: button({class: deed === "next" ? "act filled" : "act"}, () => this.#press(deed), name),
  }))

  /** Shows the buttons for what the instructor's screen can do now. */
  #ready() {
    const {next = "", blank = false, deeds = []} = this.view?.screen ?? {}
    for (const {name, deed, element: pressed} of this.buttons) {
      const words = {next, ...this.#words(blank)}[deed] ?? name
      const isOffered = deed === "next" || deed === "blank" || (deeds.includes(deed) && words !== next)
      pressed.textContent = words
      pressed.hidden = !isOffered || !words
    }
  }

  /**
   * Labels of buttons whose effect has changed. @param {boolean} isBlank @returns {Partial<Record<page.Deed, string>>}
   */
  #words(isBlank) {
    const counts = this.countdown.left > 0
    const closes = this.view?.question.closes
    return {
      ...(isBlank ? {blank: "Show the screen"} : {}),
      ...(counts ? {countdown: "15 s more"} : {}),
      ...(closes ? {closing: "Stay open at 0"} : {}),
    }
  }

  countdown = new Countdown(new Timing())

  #enter() {
    this.isIn = true
    this.#ready()
    const deeds = element("div", {class: "remote-deeds"}, ...this.buttons.map(({element: pressed}) => pressed))
    const end = chip("End the class", () => this.#confirm())
    this.host.replaceChildren(this.state, this.countdown.element, this.body, end, deeds)
  }

  /** @param {page.Deed} deed */
  #press(deed) {
    if (deed === "go") this.#list()
    else this.#do({deed})
  }

  /** Asks before the class ends. The instructor's screen asks too, and says what is deleted. */
  #confirm() {
    this.#do({deed: "end"})
    const back = () => {
      this.#do({deed: "close"})
      this.#enter()
    }
    const words = element(
      "p",
      {},
      "The lecturer's screen shows how many answers this deletes. They can be saved there.",
    )
    const cancel = button({class: "act filled"}, back, "Cancel")
    const end = button({class: "act"}, () => this.#do({deed: "end"}), "End the class")
    this.host.replaceChildren(element("h1", {}, "End the class?"), words, this.state)
    this.host.append(element("div", {class: "remote-deeds"}, cancel, end))
  }

  /** Replaces the buttons by the list of the walk's steps; a press opens the step. */
  async #list() {
    const {code, paired} = this
    /** @type {page.Listed[] | undefined} */
    const steps = await fetchJson(`${code}/steps`, {word: paired.key}).catch(reason => this.#failed(reason))
    if (!steps || this.over) return
    const rows = steps.map(({step, title}) => {
      const go = () => {
        this.#do({deed: "go", step})
        this.#enter()
      }
      return element("li", {}, button({}, go, marked("span", {}, title)))
    })
    const close = button({class: "act"}, () => this.#enter(), "Close")
    this.host.replaceChildren(this.state, element("ol", {class: "remote-steps"}, ...rows), close)
  }

  /** Presses, one after the other. @type {Promise<unknown>} */
  deeds = Promise.resolve()

  /** @param {Pick<page.Done, "deed"> & Partial<page.Done>} done */
  #do(done) {
    const {code, paired} = this
    this.deeds = this.deeds
      .then(() => fetchJson(`${code}/remote`, {method: "POST", body: done, word: paired.key}))
      .catch(reason => this.#failed(reason))
  }

  /** @param {unknown} reason */
  #failed(reason) {
    const status = reason instanceof Refusal && reason.isSaid ? reason.status : 0
    // A missing class is over too: this remote control ended it, so nothing is left to wait for.
    const isOver = isMissing(reason) || hasEnded(reason)
    this.over ||= isOver || (status === 403 && this.doubts++ >= DOUBTS)
    const why = isOver ? inWords(reason) : "This phone is no longer the remote control of a class."
    if (this.over) this.host.replaceChildren(element("h1", {}, why))
    this.state.textContent = reason instanceof Refusal ? reason.message : String(reason)
    if (!this.isIn && !this.over) this.host.append(this.state)
  }
}

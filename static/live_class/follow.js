// The page of a follower: draws the instructor's messages with the same modules, without a session.

import {unpacked} from "../net/columns.js"
import {element, frame} from "../core/dom.js"
import {watch} from "../core/faults.js"
import {inWords} from "../core/notes.js"
import {Page, extrasFor} from "../scene/page.js"
import {Sheets} from "../net/sheets.js"
import {tabStorage} from "../core/storage.js"
import {turnTheme} from "../shell/theme.js"
import {ClassQuestion} from "./class_question.js"
import {FollowBar} from "./follow_bar.js"
import {entered, forget} from "./my_answers.js"
import {Refusal} from "./requests.js"
import {Stream} from "./stream.js"
import {Timing} from "./timing.js"

const PATIENCE = 10000 // ms to wait for a sheet, at most
const RENEWED = "class-renewed" // name in the storage: time of the last reload for a new version
const PAUSE = 10000 // ms from that reload to the next, at least
const AGAIN = 500 // ms until a failed request is repeated
const OVER = "The class is over. Thank you for coming."

/** @implements {PageHost} */
export class Following {
  /** @type {Page} */
  page

  /** @type {Drawn} */
  shown

  /** @type {Partial<page.News>} the latest news of each kind */
  news = {}

  sheets = new Sheets(PATIENCE)

  /** @type {Promise<unknown>} */
  turning = Promise.resolve()

  // A follower cannot change parameters, so these do nothing.
  hall = {on: false, ending: ""}
  messages = {send() {}, last: 0, rests: true}
  send() {}
  take() {}
  change() {}
  fit() {}

  /** @param {string} code @param {string} token */
  constructor(code, token) {
    this.code = code
    this.token = token
    this.host = /** @type {HTMLElement} */ (document.getElementById("app"))
    this.timing = new Timing(() => this.bar?.update())
    this.bar = new FollowBar(this)
    this.asked = new ClassQuestion(this)
    this.stream = new Stream(code, token, {
      news: news => this.#receive(news),
      refused: refusal => this.#over(this.news.number ? OVER : refusal.message),
      connected: (is, why) => this.#connected(is, why),
      outdated,
      sleeps: true,
    })
  }

  /** @param {boolean} is @param {string} [why] the reason if not */
  #connected(is, why) {
    const isBack = is && this.bar.away
    this.bar.connected(is, why)
    if (isBack) this.asked.wake()
  }

  /** The id of the current server process. */
  get server() {
    return this.news.number?.split(".")[0] ?? ""
  }

  get clock() {
    return this.page.clock
  }
  get plots() {
    return this.page.plots
  }

  /** @param {Partial<page.News>} news */
  #receive(news) {
    if (news.ended) return this.#over(OVER)
    if (news.question) this.news.answered = 0 // until the new answers are counted
    Object.assign(this.news, news)
    this.bar.update()
    this.asked.count()
    if (news.picture) this.#next(() => this.#show(/** @type {page.SentPicture} */ (news.picture)))
    if (news.clock) this.#run()
    if (news.question) this.#next(() => this.asked.show(/** @type {page.PutTo} */ (news.question)))
  }

  /** @param {() => Promise<void>} act */
  #next(act) {
    this.turning = this.turning.then(act).catch(error => console.warn(error))
  }

  /** Draws a picture, unless a newer one has arrived. @param {page.SentPicture} picture */
  async #show(picture) {
    if (picture !== this.news.picture) return
    const sheet = await this.sheets.fetch(picture.sheet).catch(() => null)
    if (!sheet) return void setTimeout(() => this.#next(() => this.#show(picture)), AGAIN)
    const {preset_dictionary} = sheet
    const bytes = Uint8Array.from(atob(String(picture.data)), sign => sign.charCodeAt(0))
    const message = await unpacked(bytes.buffer, preset_dictionary)
    if (message.type !== "shown") return
    this.shown = message
    if (message.scene === this.page?.spec.slug) this.page.apply(message)
    else await this.#turn(message)
    this.asked.shown(message)
    this.bar.update()
  }

  /** @param {Drawn} shown */
  async #turn(shown) {
    document.documentElement.dataset.ready = "false"
    const sheet = await this.sheets.fetch(shown.sheet)
    const page = new Page(sheet, await extrasFor(sheet), this)
    this.page?.leave()
    this.host.replaceChildren(page.root)
    this.page = page
    page.start(shown)
    for (const part of page.root.querySelectorAll(".transport, .handles, .grips, .seg")) part.setAttribute("inert", "")
    document.title = `${sheet.headline} – Oscillations`
    const place = document.querySelector(".class-place")
    if (place) place.textContent = sheet.title
    this.#run()
    await frame()
    await page.join().catch(error => console.warn(error))
    document.documentElement.dataset.ready = "true"
  }

  /** Leaves the class for a page with the case that a reply mentions. @param {page.State} state */
  open(state) {
    this.bar.leave({...state, step: "", covered: []})
    location.assign(`./?scene=${state.scene}`)
  }

  /**
   * Follows the instructor's clock. If the browser asks for reduced motion, time does not run here: it changes when the
   * instructor sets another time.
   */
  #run() {
    const {clock} = this.news
    if (!clock || !this.page) return
    const {t, rate, end, at} = clock
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches
    this.page.clock.follow(rate > 0, () => {
      const now = t + (still ? 0 : (rate * (this.timing.now - at)) / 1000)
      return now > end ? now % end : Math.max(now, 0)
    })
  }

  /** @param {string} sentence */
  #over(sentence) {
    this.stream?.close()
    this.asked.close()
    this.bar.over()
    this.page?.leave()
    forget(this.code)
    const again = element("a", {class: "chip", href: "./"}, "Look around on your own")
    this.host.replaceChildren(
      element("main", {class: "class-wait", role: "status"}, element("h1", {}, sentence), again),
    )
  }
}

/**
 * Reloads the page because the server has another version. During an upgrade both versions may answer, so it reloads at
 * most every 10 s.
 */
function outdated() {
  const last = Number(tabStorage.text(RENEWED))
  setTimeout(
    () => {
      // Without storage, the page would reload again and again.
      if (tabStorage.keep(RENEWED, Date.now())) location.reload()
    },
    last + PAUSE - Date.now(),
  )
}

async function begin() {
  const query = new URLSearchParams(location.search)
  const typed = query.get("class") ?? ""
  watch()
  theme()
  if (query.has("remote")) {
    const {control} = await import("./remote.js")
    return control(typed, query.get("remote") ?? "")
  }
  if (query.has("lead")) {
    const {takeOver} = await import("./class_backup.js")
    return takeOver(typed, query.get("lead") ?? "").catch(reason => wait(inWords(reason)))
  }
  try {
    if (!/^[\s-]*([0-9a-z][\s-]*){4}$/i.test(typed)) throw new Refusal("A code has four letters and digits.", 404)
    const {code, token} = await entered(typed, query.get("join") ?? "", say)
    globalThis.oscillations = new Following(code, token)
  } catch (reason) {
    wait(inWords(reason))
  }
}

/** @param {unknown} reason why the class cannot be joined yet */
function say(reason) {
  const heading = document.querySelector(".class-wait h1")
  if (heading) heading.textContent = `${inWords(reason)} Trying again.`
}

/** A field for another code. @param {string} sentence */
function wait(sentence) {
  const field = element("input", {name: "class", "aria-label": "Code of the class", autocapitalize: "characters",
    autocomplete: "off", maxlength: 8, required: ""}) // prettier-ignore
  const form = element("form", {}, field, element("button", {class: "act filled"}, "Join"))
  form.addEventListener("submit", event => {
    event.preventDefault()
    location.assign(`./?class=${encodeURIComponent(field.value)}`)
  })
  document.querySelector(".class-wait")?.replaceChildren(element("h1", {}, sentence), form)
  field.focus()
}

function theme() {
  document.querySelector("#theme")?.addEventListener("click", () => {
    turnTheme()
    globalThis.oscillations?.page?.theme()
  })
}

begin()

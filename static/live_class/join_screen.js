// The join screen: the code and its QR code over the whole page, readable from the last row, and the other controls of
// the class.

import {button, chip, element, marked} from "../core/dom.js"
import {inWords} from "../core/notes.js"
import {Ending, saveAnswers} from "./ending.js"
import {earlier} from "./earlier.js"
import {place} from "./join_badge.js"
import {fetchJson} from "./requests.js"
import {summary} from "./summary.js"

export class JoinScreen {
  /** @type {HTMLDialogElement | null} */
  dialog = null

  /** @type {HTMLElement | null} the number of followers */
  here = null

  /** The digits that remote controls show that wait for permission. @type {string[]} */
  remotes = []

  asking = element("div", {class: "class-asking", role: "status"}) // whether they are

  status = element("p", {class: "done", role: "status"})

  /** @param {import("./teach.js").Teach} teach */
  constructor(teach) {
    this.teach = teach
    this.ending = new Ending(teach.room, {
      end: () => teach.end(),
      tell: sentence => teach.lecture.page.notice.tell(sentence),
    })
  }

  toggle() {
    if (this.dialog) this.close()
    else this.open()
  }

  close() {
    this.dialog?.remove()
    this.dialog = null
  }

  open() {
    const {room, news} = this.teach
    this.here = element("b", {})
    const square = marked("div", {class: "class-square", role: "img", "aria-label": "QR code"}, room.square)
    const words = element(
      "div",
      {class: "class-words"},
      element("span", {}, "Join at"),
      element("b", {class: "at"}, place(room.address)),
      element("span", {}, "or with the code"),
      element("b", {class: "code"}, room.code),
    )
    words.append(element("p", {}, this.here, " here"))
    this.#showMessage("done", "")
    const tools = element("div", {class: "class-tools"}, this.asking, this.status, ...this.#tools())
    this.dialog = element("dialog", {class: "class-large", "aria-label": "Join the class"}, square, words, tools)
    this.dialog.addEventListener("close", () => this.close())
    document.body.append(this.dialog)
    this.dialog.show()
    this.say(news.here ?? 0)
    const [close] = [...tools.querySelectorAll("button")].slice(-1)
    close?.focus()
  }

  #tools() {
    const deeds = /** @type {[string, () => void][]} */ ([
      ["Remote control", () => this.#try(() => this.#remote())],
      ["Another computer", () => this.#try(() => this.#handOver())],
      ["Summary", () => this.#try(() => summary(this.teach.room))],
      ["Votes of an earlier class", () => this.#earlier()],
      ["Answers as CSV", () => this.#try(() => saveAnswers(this.teach.room))],
      ["End the class", () => this.#try(() => this.ending.open())],
    ])
    const chips = deeds.map(([name, act]) => chip(name, act))
    return [...chips, button({class: "act filled"}, () => this.close(), "Close (J)")]
  }

  /** @param {number} here */
  say(here) {
    if (this.here) this.here.textContent = String(here)
  }

  /** @param {"done" | "problem"} kind @param {string} sentence */
  #showMessage(kind, sentence) {
    this.status.className = kind
    this.status.textContent = sentence
  }

  /** Runs an action, or shows why it fails. @param {() => unknown} act */
  async #try(act) {
    try {
      this.#showMessage("done", "")
      await act()
    } catch (reason) {
      this.#showMessage("problem", inWords(reason))
    }
  }

  /** Reads the chosen CSV of an earlier class, whose votes are then shown behind the current ones. */
  #earlier() {
    const field = element("input", {type: "file", accept: ".csv,text/csv"})
    field.addEventListener("change", () => this.#try(() => this.#take(field.files?.[0])))
    field.click()
  }

  /** @param {File | undefined} file */
  async #take(file) {
    if (!file) return
    const {votes, lecture} = this.teach
    votes.earlier = earlier(await file.text(), lecture.walks.names)
    votes.update()
    this.#showMessage(
      "done",
      `Its votes on ${votes.earlier.size} question${votes.earlier.size === 1 ? "" : "s"} are outlined.`,
    )
  }

  /** Shows a word with which another computer can take over the class. */
  async #handOver() {
    const {copies, lecture, room} = this.teach
    const {code, key} = room
    const query = `${lecture.page.shown.query}${lecture.hall.ending}`
    const body = {query, shown: Object.fromEntries(Object.entries(copies.room.shown ?? {}).slice(-100))}
    const {address} = await fetchJson(`${code}/word`, {method: "POST", body, word: key})
    const words = element(
      "div",
      {class: "class-words"},
      element("span", {}, "On the other computer open, within two minutes,"),
      element("b", {class: "at"}, place(address)),
      element("span", {}, "It then leads the class, and this one does not."),
    )
    this.dialog?.querySelector(".class-square")?.replaceChildren() // this code is not for phones
    this.dialog?.querySelector(".class-words")?.replaceWith(words)
  }

  /** A code with which one phone can become the remote control, within a minute. */
  async #remote() {
    const {dialog} = this
    const {code, key} = this.teach.room
    const ticket = await fetchJson(`${code}/tickets`, {method: "POST", word: key})
    const square = this.dialog?.querySelector(".class-square")
    if (!square || dialog !== this.dialog) return // the screen was closed meanwhile
    square.innerHTML = ticket.square
    square.setAttribute("aria-label", "QR code of the remote control")
    const words = element("div", {class: "class-words"}, element("b", {class: "at"}, "A remote control"))
    words.append(element("span", {}, "Scan it with one phone within a minute, then confirm its two digits here."))
    this.dialog?.querySelector(".class-words")?.replaceWith(words)
  }

  /**
   * Asks whether to let in the phones that show these digits; opens the screen for a new one. @param {string[]} digits
   * all that wait
   */
  wait(digits) {
    const isNew = digits.some(each => !this.remotes.includes(each))
    this.remotes = digits
    this.asking.replaceChildren(...digits.map(each => this.#question(each)))
    if (isNew && !this.dialog) this.open()
  }

  /** @param {string} digits */
  #question(digits) {
    const {code, key} = this.teach.room
    const decide = (/** @type {string} */ method, /** @type {string} */ done) =>
      this.#try(async () => {
        const control = await fetchJson(`${code}/tickets`, {method, body: {digits}, word: key})
        if (control) this.teach.copies.save(control)
        this.#showMessage("done", done)
      })
    const yes = button(
      {class: "act filled"},
      () => decide("PUT", "The remote control is connected."),
      "Yes, connect it",
    )
    const no = button({class: "act"}, () => decide("DELETE", "The phone was rejected."), "No")
    const words = element("span", {}, "Does the phone in your hand show ", element("b", {}, digits), "?")
    return element("p", {}, words, yes, no)
  }
}

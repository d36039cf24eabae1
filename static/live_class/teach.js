// The instructor's side of a live class: sends the page's picture, clock and question to the class.

import {button, chip, element} from "../core/dom.js"
import {inWords, note} from "../core/notes.js"
import {blank} from "../shell/blank.js"
import {LED, tabStorage} from "../core/storage.js"
import {JoinBadge} from "./join_badge.js"
import {Copies} from "./class_backup.js"
import {Countdown, FIRST, MORE} from "./countdown.js"
import {JoinScreen} from "./join_screen.js"
import {poll} from "./poll.js"
import {Refusal, fetchJson, isMissing, pause} from "./requests.js"
import {describedScreen} from "./screen.js"
import {Stream} from "./stream.js"
import {Timing} from "./timing.js"
import {Votes} from "./votes.js"

const LOOK = 50 // ms between two checks of the clock
const OFF = 0.04 // s; the clock is sent again if followers are off by more
const AGAIN = 1000 // ms until an order is sent again
const PASSED = "led by another computer"
const SAVING = 60000 // ms between two entries in the browser's storage which say that the class is still led

/** @typedef {import("../walks/walk.js").Walk} Walk */

export class Teach {
  /** @type {Partial<page.News>} */
  news = {}

  /** @type {page.RunClock | null} the clock that was last sent to followers */
  sentClock = null

  /** @type {string} the name of the followers' question */
  askedStep = ""

  /** @type {page.WalkSheet | undefined} the walk of that question; reading a file again gives a new one */
  sheet

  away = false
  isOver = false
  looking = 0

  /** Orders to the room, one after the other. @type {Promise<unknown>} */
  orders = Promise.resolve()

  /** @param {LectureHost} lecture @param {Copies} copies */
  constructor(lecture, copies) {
    const {room} = copies
    this.lecture = lecture
    this.copies = copies
    this.room = room
    this.timing = new Timing()
    this.countdown = new Countdown(this.timing)
    this.votes = new Votes(this)
    this.joinScreen = new JoinScreen(this)
    this.badge = new JoinBadge(room, () => this.joinScreen.toggle())
    this.sign = button({class: "class-code", title: "Join code, large (J)"}, () => this.joinScreen.toggle())
    // Remove the badge of an earlier class, which another computer leads now.
    for (const old of document.querySelectorAll("button.class-code, .class-corner")) old.remove()
    document.querySelector("#keys")?.before(this.sign)
    document.documentElement.dataset.class = room.code
    this.stream = this.#listen()
    this.looking = setInterval(() => this.#look(), LOOK)
    this.saving = setInterval(() => copies.save(), SAVING)
    this.lead()
    this.say()
  }

  #listen() {
    const {code, key} = this.room
    return new Stream(code, key, {
      news: news => this.#receive(news),
      refused: refusal => (refusal.status === 404 ? this.reopen() : this.#over(refusal.message)),
      connected: is => this.#connected(is),
      doubt: 0,
    })
  }

  /** @type {Promise<void> | null} */
  reopening = null

  /** Restores a class that the server has lost. */
  reopen() {
    this.reopening ??= this.#restore().finally(() => (this.reopening = null))
    return this.reopening
  }

  /** @returns {Promise<void>} */
  async #restore() {
    try {
      await this.copies.restore()
    } catch (reason) {
      if (!(reason instanceof Refusal && reason.passes)) return this.#over(inWords(reason))
      await pause(AGAIN)
      return this.isOver ? undefined : this.#restore()
    }
    this.sentClock = null
    this.described = ""
    this.lead()
    this.stream.close()
    this.stream = this.#listen()
    this.votes.count()
  }

  /** Makes the current session publish its picture to the class. */
  lead() {
    if (this.away) this.stream.wake()
    this.lecture.messages.send({type: "lead", code: this.room.code, key: this.room.key})
  }

  /** @param {boolean} is */
  #connected(is) {
    this.away = !is
    this.say()
  }

  say() {
    const {here = 0, lost} = this.news
    const state = this.away || lost ? "not connected" : `${here} here`
    this.sign.replaceChildren(element("b", {}, this.room.code), element("span", {role: "status"}, state))
    this.badge.say(state)
    this.joinScreen.say(here ?? 0)
  }

  /** @param {Partial<page.News>} news */
  #receive(news) {
    if (news.ended) return this.#over("The class is over.")
    const isFirst = !this.news.number
    const wasShown = this.news.question?.lesson
    Object.assign(this.news, news)
    this.copies.receive(news)
    this.say()
    const {walks} = this.lecture
    const {walk} = walks
    if (isFirst && walk) this.walked(walk)
    if (isFirst) walks.lead(this.copies.walks, this.news.question)
    // Another window of the instructor has shown the answer.
    if (news.question?.lesson && !wasShown && !isFirst && walk?.card && !walk.lesson && this.#isAsked(walk))
      walk.show(true)
    if (news.question && this.isTakenBack(walk)) this.votes.open()
    if (news.question) this.countdown.show(news.question)
    if (news.answers || news.question || news.lost === false) this.votes.count()
    else if (news.here !== undefined) this.votes.update()
    if (news.remotes) this.joinScreen.wait(news.remotes)
    if (news.deed) this.#obey(news)
  }

  /** Executes an order of the remote control. @param {Partial<page.News>} news */
  #obey({deed, step}) {
    const {walks} = this.lecture
    const {walk} = walks
    if (deed === "close" && !this.joinScreen.ending.close()) this.joinScreen.close()
    else if (deed === "end") this.joinScreen.ending.press()
    else if (deed === "taken") this.#pass()
    else if (deed === "blank") blank()
    else if (deed === "again") this.again()
    else if (deed === "poll") this.poll()
    else if (deed === "sure") this.askSure()
    else if (deed === "countdown") this.countDown()
    else if (deed === "closing") this.closeAtEnd()
    else if (deed === "go") walk?.go(walk.sheet.steps.findIndex(one => one.id === step))
    else if (deed === "back") walks.turn(-1)
    else if (deed === "next") walks.turn(1)
    else if (deed === "show" && walk && !walk.lesson) walk.show(true)
    else if (deed === "derive" && walk?.lesson) this.#derive(walk)
  }

  /** Shows the formulas of the explanation. @param {Walk} walk */
  #derive(walk) {
    if (this.votes.isOpen) this.votes.close()
    walk.card?.derive()
  }

  /** Gives an order; resolves with true on success. @param {page.Order} order @returns {Promise<boolean>} */
  order(order) {
    const done = this.orders.then(() => this.#sent(order))
    this.orders = done
    return done
  }

  /**
   * Repeats an order until the server answers; no later order overtakes it.
   * @param {page.Order} order @returns {Promise<boolean>}
   */
  async #sent(order) {
    const {code, key} = this.room
    if (this.isOver || (order.type === "clock" && order !== this.sentClock)) return false // a newer clock will be sent
    try {
      await fetchJson(`${code}/lead`, {method: "POST", body: order, word: key})
      return true
    } catch (reason) {
      if (isMissing(reason) && order.type !== "end") {
        await this.reopen()
        return this.#sent(order)
      }
      if (order.type !== "clock" && !(reason instanceof Refusal && reason.passes)) {
        this.lecture.page.notice.tell(inWords(reason))
        return false
      }
    }
    await pause(AGAIN)
    if (order.type !== "clock") return this.#sent(order)
    if (order === this.sentClock) this.sentClock = null // the current clock is sent instead
    return false
  }

  /** Sends the clock if followers would show another time than this page. */
  #look() {
    this.badge.attach(this.lecture.page.root)
    this.#describe()
    this.#closeInTime()
    if (this.timing.bound === Infinity) return
    const {clock} = this.lecture
    const now = this.timing.now
    const rate = clock.playing && clock.running ? clock.factor / clock.unit : 0
    const {sentClock} = this
    const expected = sentClock
      ? (sentClock.t + (sentClock.rate * (now - sentClock.at)) / 1000) % (sentClock.end || 1)
      : NaN
    const off = Math.abs(expected - clock.t)
    const apart = Math.min(off, Math.abs(clock.end - off))
    const slack = rate ? OFF * rate : 1e-9 * clock.end
    if (sentClock && sentClock.rate === rate && sentClock.end === clock.end && apart <= slack) return
    this.sentClock = {type: "clock", t: clock.t, rate, end: clock.end, at: now}
    this.order(this.sentClock)
  }

  /** Describes the screen to a remote control, if it has changed. */
  #describe() {
    if (!this.copies.room.control || this.away) return
    const screen = describedScreen(this.lecture.walks, {
      canRepeat: this.votes.canRepeat,
      asksSure: Boolean(this.news.question?.sure),
      isOpen: !this.news.question?.closed,
      counts: this.countdown.left > 0,
      joins: this.joinScreen.dialog !== null,
    })
    const described = JSON.stringify(screen)
    if (described !== this.described) this.order(screen)
    this.described = described
  }

  /** Closes a vote once at the end of its countdown, if it was set to close. */
  #closeInTime() {
    const {countdown, news} = this
    if (!countdown.isOver || !news.question?.closes || this.closedAt === countdown.until) return
    this.closedAt = countdown.until
    this.close()
  }

  closedAt = 0 // the end of the last countdown that has closed a vote

  described = "" // the last description that was sent

  /** Called after every change in a walk; null when it is left. @param {Walk | null} walk */
  walked(walk) {
    if (!this.news.number) return // the current question is not known yet
    if (walk?.numbers) return walk.go(walk.place) // everyone in a class has the numbers of the file
    if (nameOf(walk) !== this.askedStep || (walk && walk.sheet !== this.sheet)) this.#arrive(walk)
    else if (walk?.card && this.votes.card !== walk.card) {
      this.votes.begin(walk)
      if (walk.lesson && this.shown) this.votes.open() // the card was built again, so show the votes on it
      else if (this.shown) this.#askClass(walk) // the answer was hidden again, so ask again
    }
    if (walk?.lesson && !this.shown) {
      this.shown = true
      this.order({type: "show"})
      this.votes.open()
    } else if (!walk?.lesson) this.shown = false
    this.votes.update()
  }

  shown = false

  /** Called when the walk is at another step. Shows the answer if the class has seen it. @param {Walk | null} walk */
  async #arrive(walk) {
    const isShown = this.#isShown(walk)
    const isTakenBack = this.isTakenBack(walk)
    const step = (this.askedStep = nameOf(walk))
    this.sheet = walk?.sheet
    this.votes.begin(walk)
    if (!walk?.step) return this.order({type: "withdraw"})
    if (!isShown) await this.#askClass(walk)
    const isAnswered = isShown || (this.copies.isAnswered(step) && !isTakenBack)
    if (isAnswered && step === this.askedStep && !walk.lesson) walk.show(true)
  }

  /** True if the class has seen the answer to this question and it is hidden again. @param {Walk | null} walk */
  isTakenBack(walk) {
    return Boolean(this.news.question?.answered && !walk?.lesson && this.#isAsked(walk))
  }

  /** True if the class has seen the answer; then a reloaded page does not ask again. @param {Walk | null} walk */
  #isShown(walk) {
    return !this.sheet && this.news.question?.lesson && this.#isAsked(walk)
  }

  /** @param {Walk | null} walk */
  #isAsked(walk) {
    const {question} = this.news
    return nameOf(walk) === `${question?.walk}/${question?.step}`
  }

  /** If the walk was opened from a file, sends it to the room before its first question is asked. @param {Walk} walk */
  async #askClass({sheet: {name}, step, walks: {own, texts}}) {
    const {askedStep} = this
    if (own.has(name)) {
      const text = texts[name]
      if (!(await this.order({type: "walk", name, text}))) return
      this.copies.take(name, text)
    }
    if (askedStep !== this.askedStep) return
    // Restores the earlier state of the question.
    const [vote, answered] = [this.copies.last(askedStep), this.copies.isAnswered(askedStep)]
    this.order({type: "put", walk: name, step: step.id, vote, answered})
  }

  /** Starts a vote on a question asked aloud. */
  async poll() {
    const refused = await poll(this.lecture)
    if (refused) this.lecture.page.notice.tell(refused)
  }

  /** Asks the students how sure they are of their answers. */
  askSure() {
    const {walk} = this.lecture.walks
    if (walk?.step && !walk.lesson) this.order({type: "sure"})
    else this.lecture.page.notice.tell("How sure the class is can be asked while a question is open.")
  }

  /** Starts a countdown, or extends a running one. */
  countDown() {
    const {walk} = this.lecture.walks
    const {question} = this.news
    if (!walk?.step || walk.lesson || question?.closed)
      return this.lecture.page.notice.tell("A countdown needs a vote that is open.")
    const isOn = this.countdown.left > 0
    const closes = question?.until ? question.closes : walk.step.closes || Boolean(question?.closes)
    this.order({type: "countdown", seconds: isOn ? MORE : FIRST, closes})
  }

  /** Switches whether the vote closes at the end of its countdown. */
  closeAtEnd() {
    this.order({type: "countdown", seconds: 0, closes: !this.news.question?.closes})
  }

  /** Shows the hall an answer in words, or removes it. @param {string} text @param {boolean} shows */
  moderate = (text, shows) => void this.order({type: "moderate", text, shows})

  /** Takes no more answers. */
  close() {
    this.order({type: "close"})
  }

  /** Puts the question again after a discussion; the first votes are outlined behind the new ones. */
  again() {
    const {walk} = this.lecture.walks
    if (!walk?.step || walk.lesson) return
    this.votes.close()
    const vote = (this.news.question?.vote ?? 1) + 1
    const {sheet, step} = walk
    this.order({type: "put", walk: sheet.name, step: step.id, vote, answered: false}).then(() => this.votes.count())
  }

  end() {
    clearInterval(this.looking) // a class that is over gets no more orders
    this.order({type: "end"})
  }

  /** Another computer leads now; this page keeps its picture and the code of the class. */
  #pass() {
    this.#leave()
    this.sign.disabled = this.badge.element.disabled = true
    const words = element("span", {role: "status"}, PASSED)
    this.sign.replaceChildren(element("b", {}, this.room.code), words)
    this.badge.say(PASSED)
    if (![words, this.badge.state].some(part => part.checkVisibility())) note(`The class is ${PASSED}.`) // on a phone
  }

  /** @param {string} sentence */
  #over(sentence) {
    this.#leave()
    this.sign.remove()
    this.badge.leave()
    delete document.documentElement.dataset.class
    this.lecture.page.notice.tell(sentence)
  }

  #leave() {
    this.isOver = true
    this.stream.close()
    clearInterval(this.looking)
    clearInterval(this.saving)
    this.countdown.end()
    this.joinScreen.ending.close()
    this.joinScreen.close()
    this.votes.leave()
    this.copies.forget()
    tabStorage.forget(LED)
    this.lecture.classes.led = null
    this.lecture.messages.send({type: "lead", code: "", key: ""})
  }
}

/** The current question of a walk. @param {Walk | null} walk */
const nameOf = walk => (walk?.step ? `${walk.sheet.name}/${walk.step.id}` : "")

/** The room for which this browser has the key, or a new one. @param {LectureHost} lecture */
export async function teach(lecture) {
  const copies = (await Copies.find()) ?? new Copies(await opened())
  tabStorage.keep(LED, "open") // this tab returns to it after a reload
  return new Teach(lecture, copies)
}

/** A new room, with the instructors' passphrase if the server asks for one. @returns {Promise<page.Opened>} */
async function opened(phrase = "") {
  try {
    return await fetchJson("", {method: "POST", word: encodeURIComponent(phrase)})
  } catch (reason) {
    if (!(reason instanceof Refusal) || reason.status !== 401) throw reason
    const typed = await passphrase(reason.message)
    if (!typed) throw new Refusal("No class was opened.", 401)
    return opened(typed)
  }
}

/** The typed passphrase, or nothing if the dialog was closed. @param {string} sentence @returns {Promise<string>} */
function passphrase(sentence) {
  const field = element("input", {type: "password", name: "passphrase", autocomplete: "current-password"})
  const label = element("label", {}, element("span", {}, "Passphrase"), field)
  const tools = element("div", {class: "tools"}, element("button", {class: "act filled"}, "Open the class"))
  tools.append(chip("Cancel", () => dialog.close("given up")))
  const form = element("form", {class: "ask-form", method: "dialog"}, label, tools)
  const dialog = element("dialog", {class: "asking", "aria-label": "Passphrase"}, element("h1", {}, sentence), form)
  return new Promise(done => {
    dialog.addEventListener("cancel", () => (dialog.returnValue = "given up"))
    dialog.addEventListener("close", () => {
      dialog.remove()
      done(dialog.returnValue ? "" : field.value)
    })
    document.body.append(dialog)
    dialog.showModal()
  })
}

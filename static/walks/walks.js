// The list of guided walks; starts and ends them. The modules of a walk are loaded when one starts.

import {insisting, later} from "../later.js"
import {Menu} from "./menu.js"
import {tabStorage} from "../core/storage.js"

/** @typedef {import("./walk.js").Walk} Walk */

const OWN = "own-walks"
const PATIENCE = 4000 // ms that a picture waits at most for the card of its step
const AGAIN = 1000 // ms until a request is repeated if the server is busy
const NOT_READ = "the server could not read this file. Nothing has changed."

export class Walks {
  /** @type {Walk | null} the current walk */
  walk = null

  /**
   * The step that was left for a scene.
   * @type {{walk: string, place: number, state: page.State, known: import("./answers.js").Answered | null} | null}
   */
  left = null

  /** @type {Promise<void> | null} resolves when the step in the address is shown, if its walk is from a file */
  coming = null

  /** @type {Map<string, page.WalkSheet>} walks that only this session knows */
  own = new Map()

  /** @param {LectureHost} lecture */
  constructor(lecture) {
    this.lecture = lecture
    /** @type {Record<string, string>} by name */
    this.texts = tabStorage.value(OWN) ?? {}
    this.menu = new Menu(this)
    // A new session does not know these walks, so it gets them before any request.
    lecture.messages.greeting = () => Object.entries(this.texts).map(([name, text]) => ({type: "walk", name, text}))
    const {walk, step} = Object.fromEntries(new URLSearchParams(location.search))
    if (walk in this.texts) this.coming = this.#rejoin(walk, step)
  }

  get names() {
    return [...this.menu.names, ...this.own.keys()]
  }

  /** @param {string} name @returns {Promise<page.WalkSheet>} */
  async sheet(name) {
    const own = this.own.get(name)
    const address = this.menu.sheets.get(name)
    if (own) return own
    if (!address) throw new Error(`There is no walk ${name}.`)
    return insisting(() => this.lecture.sheets.fetch(address))
  }

  /** @param {string} name @param {number} [place] of the step */
  async enter(name, place = 0) {
    await this.#take(name)
    this.walk?.go(place)
  }

  /**
   * The steps of a walk as articles for a handout.
   * @param {string} name @param {boolean} isAnswered @param {(place: number) => void} begins
   */
  async onPaper(name, isAnswered, begins) {
    const [{articles}] = await Promise.all([later("export/articles"), this.enter(name)])
    return articles(/** @type {Walk} */ (this.walk), isAnswered, begins)
  }

  /** A step that is chosen in the contents. @param {string} name @param {number} place */
  choose(name, place) {
    this.enter(name, place)
  }

  /** True if this walk is the current one. A file that is opened again gives another walk. @param {string} name */
  #isWalked(name) {
    return this.walk?.sheet.name === name && this.walk.sheet === (this.own.get(name) ?? this.walk.sheet)
  }

  /** @param {string} name */
  async #take(name) {
    if (this.#isWalked(name)) return
    const [{Walk: Kind}, sheet] = await Promise.all([later("walks/walk"), this.sheet(name)])
    if (this.#isWalked(name)) return
    this.walk?.leave()
    this.walk = new Kind(this, sheet)
  }

  /** Loads the modules and the sheet of a step, so that its card appears with the first picture. @param {page.State}
   * state */
  async prepare({step}) {
    const [name] = step.split("/")
    if (!this.menu.sheets.has(name)) return
    const late = new Promise(done => setTimeout(done, PATIENCE))
    await Promise.race([Promise.all([later("walks/walk"), this.sheet(name)]), late])
  }

  /** Opens the step of a new picture, if its state has one. @param {Drawn} shown */
  async shown(shown) {
    this.latest = shown
    const [asked, step, seed] = shown.state.step.split("/")
    const name = (await this.#isKnown(asked)) ? asked : ""
    if (shown !== this.latest) return
    this.menu.walked(Boolean(name))
    if (name) {
      await this.#take(name)
      if (shown === this.latest) this.walk?.arrive(step, Number(seed ?? 0), shown)
      if (!this.walk?.isAloud) this.left = null // after a vote, return to this step
    } else {
      this.left = this.walk?.bookmark ?? this.left
      this.walk?.leave()
      this.walk = null
    }
    this.menu.begin()
    this.menu.offers(this.left ? `Back to step ${this.left.place + 1} (W)` : "")
  }

  /** Leaves the walk. The scene keeps its state; parts that an open question hides stay hidden. */
  leave() {
    this.menu.close()
    const {kept: state} = this.lecture
    if (state.step) this.lecture.open({...state, covered: this.walk?.lesson ? [] : state.covered, step: ""})
  }

  /** Returns to the step that was left. */
  async comeBack() {
    const {left} = this
    if (!left) return
    this.menu.close()
    await this.#take(left.walk)
    if (this.walk) this.walk.known = left.known
    this.lecture.open(left.state)
  }

  /** Ends a vote on a question asked aloud. */
  goOn() {
    return this.left ? this.comeBack() : this.leave()
  }

  /** Leaves the walk, returns to it, or opens the menu of walks. */
  toggle() {
    if (this.lecture.kept.step) this.leave()
    else if (this.left) this.comeBack()
    else this.menu.toggle()
  }

  /** True if the keys of a clicker have an effect. */
  get turns() {
    return Boolean(this.walk ?? this.left)
  }

  /** A press of a clicker: forward or back in the walk; from a scene, back to the walk. @param {1 | -1} way */
  turn(way) {
    const {walk} = this
    if (!walk) this.comeBack()
    else if (way < 0) walk.back()
    else walk.forward(true)
  }

  /** Uncovers everything that a step or the visitor has hidden. */
  reveal() {
    if (this.walk && !this.walk.lesson) this.walk.show(false)
    if (!this.walk && this.lecture.kept.covered.length) this.lecture.change(() => ({covered: []}))
  }

  /**
   * Requests an answer of the session; repeats the request while the server is busy.
   * @param {page.RunWalk | page.GiveAnswer} message @returns {Promise<ServerMessage>}
   */
  async request(message) {
    const answer = await this.lecture.messages.request(message)
    if (!("is_busy" in answer && answer.is_busy)) return answer
    await new Promise(done => setTimeout(done, AGAIN))
    return this.request(message)
  }

  /**
   * Adds a walk from a file to this session only. Returns why it cannot be run, or "".
   * @param {string} name @param {string} text @returns {Promise<string>}
   */
  async check(name, text) {
    const answer = await this.request({type: "walk", name, text})
    if (answer.type !== "walking") return NOT_READ
    const {sheet, refused} = answer
    if (!sheet) return refused
    this.own.set(name, sheet)
    this.texts[name] = text
    tabStorage.keep(OWN, this.texts)
    return ""
  }

  /** True if a walk is known; after a reload, a walk from a file is first checked again. @param {string} name */
  async #isKnown(name) {
    if (name in this.texts && !this.own.has(name)) await this.check(name, this.texts[name])
    return this.own.has(name) || this.menu.sheets.has(name)
  }

  /** Checks a walk from a file, and enters it. @param {string} name @param {string} text @param {number} [place] */
  async run(name, text, place = 0) {
    const refused = await this.check(name, text)
    if (!refused) await this.enter(name, place)
    return refused
  }

  /** A reloaded page has a new session that knows no walks from files. @param {string} name @param {string} id */
  async #rejoin(name, id) {
    const refused = await this.check(name, this.texts[name])
    if (refused) return this.lecture.page.notice.tell(refused)
    await this.#comeTo(name, id)
  }

  /** @param {string} name @param {string} id */
  async #comeTo(name, id) {
    const {steps} = await this.sheet(name)
    this.lecture.page.notice.hide() // close the notice that the walk is missing
    const place = steps.findIndex(step => step.id === id)
    await this.enter(name, Math.max(place, 0))
  }

  /** Sends walks from files one by one, as the server reads them. @param {string} name @param {string} text */
  async #takeAlong(name, text) {
    const refused = await this.check(name, text)
    if (refused) this.lecture.page.notice.tell(`${name}: ${refused}`)
  }

  /**
   * Prepares a page that has just begun to lead a class: adds the class's walks from files, and opens the step of the
   * current question.
   * @param {Map<string, string>} texts by name @param {page.PutTo | null | undefined} question
   */
  async lead(texts, question) {
    await this.coming
    const others = [...texts].filter(([name]) => !(name in this.texts))
    await others.reduce((earlier, [name, text]) => earlier.then(() => this.#takeAlong(name, text)), Promise.resolve())
    if (this.walk || this.lecture.kept.step || !question?.step || !this.names.includes(question.walk)) return
    await this.#comeTo(question.walk, question.step)
  }
}

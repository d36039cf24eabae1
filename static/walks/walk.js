// A guided walk: shows its steps one by one, first the question, then the explanation.

import {Answers, answered, forgetAnswered, keepAnswered} from "./answers.js"
import {ANSWER_FIRST, Card, FOLLOWS} from "./card.js"
import {Contents} from "./contents.js"
import {ALOUD} from "./draft.js"
import {Finish} from "./finish.js"
import {tabStorage} from "../core/storage.js"
import {ownSeed, seedOf, variant} from "./variants.js"

const SHORT = "core-steps"

const ASKED_NOW =
  "The lecture is at this step now. Press Back to the lecture: you see the answer together with the class."

/** @implements {WalkHost} */
export class Walk {
  /** @type {number} index of the step */
  place = -1

  /** @type {page.Lesson | null} the explanation of the step, after the answer */
  lesson = null

  isRevealing = false // true until the picture without covers arrives; earlier ones must not hide the answer

  /** @type {Card | null} */
  card = null

  /** @type {Contents | null} */
  contents = null

  /** @type {Finish | null} */
  finish = null

  /** @type {page.State | undefined} the last state from the server in this step */
  state

  numbers = 0 // the seed of the step's numbers, 0 for the numbers of its file

  unfolded = false

  known = answered() // the step that was open before the reload

  /** @type {import("../questions/question.js").Answer | null} the earlier answer, if the visitor answers again */
  earlierAnswer = null

  /** @param {LectureHost["walks"]} walks @param {page.WalkSheet} sheet */
  constructor(walks, sheet) {
    this.walks = walks
    this.lecture = walks.lecture
    this.sheet = sheet
    this.answers = new Answers()
  }

  /** The seed of the order of options: one for a class, another one for each visitor without a class. */
  get seed() {
    return this.lecture.classes.code || ownSeed()
  }

  /** @returns {page.StepCard} */
  get step() {
    const step = this.sheet.steps[this.place]
    return step && variant(step, this.numbers)
  }

  /** A step of a walk with the numbers of this visitor. @param {page.StepCard} step */
  numbered(step) {
    if (this.lecture.classes.hasNumbers) return step
    const stands = this.numbers && step === this.sheet.steps[this.place]
    return variant(step, stands ? this.numbers : seedOf(step))
  }

  /** The steps of this run: all, or only the core ones. */
  get steps() {
    const {steps} = this.sheet
    const core = this.isShort ? steps.filter(step => step.core) : []
    return core.length ? core : steps
  }

  isShort = Boolean(tabStorage.value(SHORT))

  /** @param {boolean} isShort */
  shorten(isShort) {
    this.isShort = isShort
    tabStorage.keep(SHORT, isShort)
  }

  /** The position of the step in the lecture and in the walk. */
  get where() {
    const [own, all] = [this.sheet.steps[this.place], this.sheet.steps]
    const steps = this.steps.includes(own) ? this.steps : all
    return [this.step.place, `${steps.indexOf(own) + 1} of ${steps.length}`].filter(Boolean).join(" · ")
  }

  /** The index of the next step of this run, or of the one before. @param {1 | -1} way */
  #towards(way) {
    const {steps} = this.sheet
    let place = this.place + way
    while (steps[place] && !this.steps.includes(steps[place])) place += way
    return place
  }

  /** Opens a step with its hidden parts, at t = 0. @param {number} place */
  go(place) {
    const step = this.sheet.steps[place]
    if (!step) return
    this.contents?.close()
    this.#closeCard()
    this.lecture.open(this.numbered(step).opens)
  }

  /** Asks the question again; the earlier sketch stays, dotted. */
  again() {
    const given = this.card?.question.given() ?? null
    this.go(this.place)
    this.earlierAnswer = given
  }

  #closeCard() {
    forgetAnswered()
    this.lesson = null
    this.earlierAnswer = null
    this.card?.leave()
    this.card = null
  }

  /**
   * Called after every picture of a step. A link without a seed opens the step with the numbers of this visitor.
   * @param {string} id @param {number} numbers the seed of its numbers @param {Drawn} shown
   */
  arrive(id, numbers, shown) {
    const place = this.sheet.steps.findIndex(step => step.id === id)
    const {page} = this.lecture
    const isAsked = this.#isAsked(place, shown)
    const step = this.sheet.steps[place]
    if (step && isAsked && !numbers && this.numbered(step) !== step) {
      page.root.classList.add("walked", "asked") // until the server has sent the step with other numbers
      page.heading.textContent = ""
      return this.go(place)
    }
    const isAnother =
      place !== this.place || numbers !== this.numbers || page !== this.card?.page || this.seed !== this.card?.seed
    this.numbers = numbers
    if (!isAsked) this.isRevealing = false
    const isTakenBack = isAsked && !this.isRevealing
    if (isAnother || (this.lesson && isTakenBack)) this.#lay(place, isTakenBack)
    this.state = shown.state
    this.card?.update(shown)
    this.lecture.classes.led?.walked(this)
  }

  /** True if more is hidden now than after the answer. @param {number} place @param {Drawn} shown */
  #isAsked(place, {state}) {
    return state.covered.length > (this.sheet.steps[place]?.reveals.covered.length ?? 0)
  }

  /** @param {number} place @param {boolean} isTakenBack */
  #lay(place, isTakenBack) {
    if (place !== this.place || isTakenBack) this.lesson = null
    this.card?.leave()
    this.place = place
    if (!this.step) return
    this.card = new Card(this, this.lecture.page)
    if (this.lesson) return this.card.teach(this.lesson)
    this.#hold()
    if (this.known) this.#restore(this.known)
    this.known = null
  }

  /**
   * Shows an answer from before the reload.
   * @param {import("./answers.js").Answered} known
   */
  #restore({step, given}) {
    if (step !== this.#name) return
    this.card?.question.restore(given)
    this.show(true)
  }

  get #name() {
    return `${this.sheet.name}/${this.step.id}`
  }

  /** Stops the clock until the answer. */
  #hold() {
    const {clock} = this.lecture.page
    clock.playing = false
    clock.seek(0)
  }

  /**
   * The next action of the filled button or of Page Down. In a class, one press after the other shows the votes, the
   * answer, the explanation and the next step. Outside a class there are no votes.
   * @returns {Press}
   */
  get press() {
    const {led} = this.lecture.classes
    if (this.lesson) return this.#onward(this.card, led?.votes)
    if (led?.isTakenBack(this)) return {words: "Vote again", act: () => led.again()}
    if (led?.votes.isUnopened) return {words: "Show the votes", act: () => led.votes.open()}
    if (this.isAloud) return {words: "Go on", act: () => this.walks.goOn()}
    if (this.step.poll) return this.#leading()
    return {words: "Show the answer", needsAnswer: !led, act: always => this.show(always || Boolean(led))}
  }

  /**
   * The next action after the answer.
   * @param {Card | null} card @param {{isOpen: boolean, close(): void} | undefined} votes @returns {Press}
   */
  #onward(card, votes) {
    if (votes?.isOpen) return {words: "Show the explanation", act: () => votes.close()}
    if (this.step.derive && card?.fold && !card.fold.open) return {words: FOLLOWS, act: () => card.derive()}
    return this.#leading()
  }

  /** Opens the next step. @returns {Press} */
  #leading() {
    return {words: this.#isLast ? (this.isTour ? "Finish" : "Contents") : "Next", act: () => this.next()}
  }

  get #isLast() {
    return this.#towards(1) >= this.sheet.steps.length
  }

  /** True if the walk ends with scenes to try. On a phone, its steps then show the picture above the options. */
  get isTour() {
    return this.sheet.trials.length > 0
  }

  /** True during a vote on a question asked aloud. */
  get isAloud() {
    return Boolean(this.step?.poll) && this.sheet.name === ALOUD
  }

  /** Does what the filled button or Page Down does. @param {boolean} [always] true to show the answer without asking */
  forward(always = false) {
    this.press.act(always)
  }

  /** @param {number} place of an answer on the screen */
  choose(place) {
    this.card?.question.choose(place)
  }

  /** @param {boolean} always */
  async show(always) {
    if (this.step.poll) return
    if (this.lecture.classes.askedStep === this.#name) return this.card?.refuse(ASKED_NOW)
    const given = this.card?.question.given()
    if (!given && !always) return this.card?.refuse(`${ANSWER_FIRST}.`)
    const sent = {walk: this.sheet.name, step: this.step.id, seed: this.numbers, ...given}
    const answer = await this.#answerTo({type: "given", answer: sent})
    if (answer.type === "taught") this.#taught(answer)
  }

  /**
   * Sends an answer. If the session does not know the walk's file, sends the file and then the answer again. @param
   * {page.GiveAnswer} message
   */
  async #answerTo(message) {
    const {name} = this.sheet
    const {own, texts} = this.walks
    const answer = await this.walks.request(message)
    const isRead = !own.has(name) || (answer.type === "taught" && answer.lesson)
    return isRead || (await this.walks.check(name, texts[name])) ? answer : this.walks.request(message)
  }

  next() {
    if (!this.#isLast) this.go(this.#towards(1))
    else if (this.isTour) (this.finish ??= new Finish(this)).open()
    else this.open(true)
  }

  /**
   * Undoes the last press: closes the formulas, in a class hides the explanation, hides the answer, or returns to the
   * previous step.
   */
  back() {
    const {led} = this.lecture.classes
    if (!this.lesson) this.go(this.#towards(-1))
    else if (this.card?.fold?.open) this.card.derive()
    else if (led && !led.votes.isOpen) led.votes.open()
    else this.again()
  }

  /** The current step, to return to later. */
  get bookmark() {
    if (!this.step || !this.state || this.isAloud) return null
    const given = this.card?.question.given() ?? {}
    const known = this.lesson ? {step: this.#name, given} : null
    return {walk: this.sheet.name, place: this.place, state: this.state, known}
  }

  /** @param {page.Taught} message the server's message */
  #taught({step, lesson, refused}) {
    if (!this.card || this.lesson || step !== this.step.id) return
    if (!lesson) return this.card.refuse(refused)
    this.lesson = lesson
    this.isRevealing = true
    if (lesson.right !== null) {
      this.answers.keep(step, {said: this.card.question.said(), right: lesson.right, title: lesson.title})
    }
    keepAnswered({step: this.#name, given: this.card.question.given() ?? {}})
    this.card.teach(lesson)
    this.lecture.classes.led?.walked(this)
    this.lecture.page.compare.keep()
    const state = lesson.shows ?? this.step.reveals
    this.lecture.messages.send({type: "open", state, keeps: true}, {start: true, undoGroup: `reveal ${step}`})
  }

  /** Opens the contents of all walks. After the last step (`isOver`) they have a summary. @param {boolean} [isOver] */
  open(isOver = false) {
    this.contents ??= new Contents(this)
    this.contents.open(isOver)
  }

  leave() {
    this.contents?.leave()
    this.finish?.leave()
    this.contents = this.finish = null
    this.#closeCard()
    this.place = -1
    this.lecture.classes.led?.walked(null)
  }
}

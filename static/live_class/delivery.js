// The delivery of a phone's answers: each is kept, and sent until the class has it or refuses it.

import {amend, mine} from "./my_answers.js"
import {fetchJson, insist, isMissing, isRefused} from "./requests.js"

/** The stream finds out whether a missing class is over. @param {unknown} reason */
const isFinal = reason => isRefused(reason) && !isMissing(reason)

/**
 * @typedef {{readonly code: string, readonly token: string, readonly server: string}} Follower
 * `server` is the server process that was heard last
 */

export class Delivery {
  /** @type {Map<string, page.Given>} answers that the class lacks, by question; the newest of each */
  unsent

  /** @type {Map<string, page.Given>} answers that the class has, by question */
  sent

  /** @type {Map<string, string>} the server that took each answer: a restarted one may have lost it */
  takenBy = new Map()

  /** @type {Map<string, string>} why an answer does not count, by question */
  refused = new Map()

  /** @type {page.Given | undefined} the answer that was sent last, accepted or not */
  tried

  isFailing = false
  isSending = false
  isOver = false
  retry = new AbortController()

  /** @param {Follower} follower @param {() => void} changed called after each try */
  constructor(follower, changed) {
    const {answers = {}, unsent = {}} = mine(follower.code) ?? {}
    this.follower = follower
    this.changed = changed
    this.sent = new Map(Object.entries(answers))
    this.unsent = new Map(Object.entries(unsent))
    this.#deliver()
  }

  /** Send an answer. @param {string} question @param {page.Given} answer */
  give(question, answer) {
    this.refused.clear()
    this.unsent.set(question, answer)
    amend(this.follower.code, known => (known.unsent[question] = answer))
    this.#deliver()
  }

  /** The newest answer to a question, sent or not. @param {string} question */
  answer(question) {
    return this.unsent.get(question) ?? this.sent.get(question) ?? null
  }

  /** Whether the class has the newest answer to a question. @param {string} question */
  isSent(question) {
    return this.sent.has(question) && this.answer(question) === this.sent.get(question)
  }

  /** Whether the server that was heard last took the answer to a question. @param {string} question */
  isTaken(question) {
    return this.takenBy.get(question) === this.follower.server
  }

  /** Give a restarted server the answer that it may have lost. @param {string} question */
  resend(question) {
    const answer = this.sent.get(question)
    if (!answer || this.unsent.has(question) || this.isTaken(question)) return
    this.unsent.set(question, answer)
    this.#deliver()
  }

  /** The server is back: what is unsent is sent at once. */
  wake() {
    this.retry.abort()
    this.retry = new AbortController()
  }

  close() {
    this.isOver = true
    this.wake()
  }

  /** One answer after the other: none overtakes a newer one. @returns {Promise<void>} */
  async #deliver() {
    const [question] = this.unsent.keys()
    if (this.isSending || question === undefined || this.isOver) return
    this.isSending = true
    const failed = () => {
      this.isFailing = true
      this.changed()
    }
    const how = {failed, isFinal, woken: () => this.retry.signal}
    await insist(() => this.#send(question), how).catch(reason => this.#drop(question, reason))
    this.isSending = false
    this.isFailing = false
    this.changed()
    return this.#deliver()
  }

  /** @param {string} question */
  async #send(question) {
    const {code, token, server} = this.follower
    const answer = (this.tried = this.unsent.get(question))
    if (!answer || this.isOver) return
    await fetchJson(`${code}/answer`, {method: "PUT", body: answer, word: token})
    this.sent.set(question, answer)
    this.takenBy.set(question, server)
    amend(code, known => (known.answers[question] = answer))
    this.#settle(question, answer)
  }

  /** @param {string} question @param {Error} reason */
  #drop(question, {message}) {
    const {tried} = this
    const isNews = tried !== this.sent.get(question) // an answer that is sent again may be there already
    if (this.#settle(question, tried) && isNews) this.refused.set(question, message)
  }

  /** Whether it is the newest: a newer one stays unsent. @param {string} question @param {page.Given} [answer] */
  #settle(question, answer) {
    if (this.unsent.get(question) !== answer) return false
    this.unsent.delete(question)
    amend(this.follower.code, known => delete known.unsent[question])
    return true
  }
}

// Delivers a phone's answers: stores each one, and sends it until the class accepts or refuses it.

import {amend, mine} from "./my_answers.js"
import {fetchJson, insist, isMissing, isRefused} from "./requests.js"

/** A class that is not found may be restored soon; the stream decides when it is over. @param {unknown} reason */
const isFinal = reason => isRefused(reason) && !isMissing(reason)

/**
 * @typedef {{readonly code: string, readonly token: string, readonly server: string}} Follower
 * `server` identifies the current server process
 */

export class Delivery {
  /** @type {Map<string, page.Given>} answers that the class lacks, by question; the newest of each */
  unsent

  /** @type {Map<string, page.Given>} answers that the class has, by question */
  sent

  /**
   * @type {Map<string, string>} the server process that accepted each answer, because a restarted one may have lost it
   */
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

  /** True if the class has the newest answer to a question. @param {string} question */
  isSent(question) {
    return this.sent.has(question) && this.answer(question) === this.sent.get(question)
  }

  /** True if the current server process accepted the answer to a question. @param {string} question */
  isTaken(question) {
    return this.takenBy.get(question) === this.follower.server
  }

  /** Give a restarted server the answer that it lacks or may have lost. @param {string} question */
  resend(question) {
    if (this.unsent.has(question)) return this.wake()
    const answer = this.sent.get(question)
    if (!answer || this.isTaken(question)) return
    this.unsent.set(question, answer)
    this.#deliver()
  }

  /** Sends unsent answers at once, because the server can be reached again. */
  wake() {
    this.retry.abort()
    this.retry = new AbortController()
  }

  close() {
    this.isOver = true
    this.wake()
  }

  /** Sends one answer after the other, so that an old one cannot replace a newer one. @returns {Promise<void>} */
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
    const isNews = tried !== this.sent.get(question) // the class may already have an answer that is sent again
    if (this.#settle(question, tried) && isNews) this.refused.set(question, message)
  }

  /**
   * Marks an answer as handled. Returns false if there is a newer one, which stays unsent. @param {string} question
   * @param {page.Given} [answer]
   */
  #settle(question, answer) {
    if (this.unsent.get(question) !== answer) return false
    this.unsent.delete(question)
    amend(this.follower.code, known => delete known.unsent[question])
    return true
  }
}

// HTTP requests to a live class, and the reasons with which it refuses them.

import {inWords} from "../core/notes.js"

const LIMIT = 10000 // ms for one request: a dead connection may never report an error
const SHORTEST = 300 // ms until the second try; each pause is twice the one before
const LONGEST = 8000
const PASSING = new Set([408, 425, 429])

/**
 * A refusal in a sentence. `status` is 0 if the server does not answer; `isSaid` if the sentence comes from the server.
 */
export class Refusal extends Error {
  /** @param {string} sentence @param {number} status @param {boolean} [isSaid] */
  constructor(sentence, status, isSaid = false) {
    super(sentence)
    this.status = status
    this.isSaid = isSaid
  }

  /** True if another try may succeed: the server is busy, or a proxy answered, which knows nothing about the class. */
  get passes() {
    return !this.isSaid || this.status >= 500 || PASSING.has(this.status)
  }
}

/**
 * Sends one request; returns the answer, or null if it has no content.
 * @typedef {{method?: string, body?: unknown, word?: string, signal?: AbortSignal}} How
 * @param {string} path below class/ @param {How} [how]
 */
export async function fetchJson(path, {method = "GET", body, word = "", signal} = {}) {
  const answer = await asked(path, {method, body, word, signal})
  if (answer.status === 204) return null
  return answer.json().catch(reason => {
    throw new Refusal(`The server's answer cannot be read: ${inWords(reason)}.`, 0)
  })
}

/**
 * Options for repeating a request: `failed` is called after each failure; `woken` gives the signal that ends a pause;
 * a final failure is not repeated.
 * @typedef {{failed?: (reason: unknown) => void, woken?: () => AbortSignal,
 *   isFinal?: (reason: unknown) => boolean}} Insisting
 */

/**
 * Repeat a request with growing pauses until it is answered; throw a final refusal.
 * @template Answer @param {() => Promise<Answer>} request @param {Insisting} [how] @returns {Promise<Answer>}
 */
export async function insist(request, how = {}, tries = 0) {
  const {failed, woken, isFinal = isRefused} = how
  try {
    return await request()
  } catch (reason) {
    if (isFinal(reason)) throw reason
    failed?.(reason)
  }
  await pause(pauseAfter(tries), woken?.())
  return insist(request, how, tries + 1)
}

/** True if another try cannot succeed. @param {unknown} reason */
export const isRefused = reason => reason instanceof Refusal && !reason.passes

/** True if the server does not know the class, for example after a restart. @param {unknown} reason */
export const isMissing = reason => reason instanceof Refusal && reason.isSaid && reason.status === 404

/** True if the class has ended for good. @param {unknown} reason */
export const hasEnded = reason => reason instanceof Refusal && reason.isSaid && reason.status === 410

/**
 * The pause after a number of failures, in ms. It is random, so that clients that failed at the same time do not return
 * at the same time. @param {number} tries
 */
export const pauseAfter = tries => Math.min(SHORTEST * 2 ** tries, LONGEST) * (0.5 + Math.random())

/** @param {string} path @param {How} how */
export async function asked(path, {method = "GET", body, word = "", signal = AbortSignal.timeout(LIMIT)}) {
  /** @type {Record<string, string>} */
  const headers = {"X-Page-Path": new URL(".", document.baseURI).pathname}
  if (word) headers.Authorization = `Bearer ${word}`
  const json = body === undefined ? undefined : JSON.stringify(body)
  /** @type {Response} */
  let answer
  try {
    const how = {method: method ?? "GET", headers, body: json, cache: /** @type {RequestCache} */ ("no-store"), signal}
    answer = await fetch(address(path), how)
  } catch (reason) {
    throw new Refusal(`The server does not answer: ${inWords(reason)}.`, 0)
  }
  if (answer.ok) return answer
  const answered = await answer.json().catch(() => null)
  throw new Refusal(answered?.sentence ?? "The class does not answer.", answer.status, Boolean(answered?.sentence))
}

/**
 * Waits for a time, or until the signal aborts.
 * @param {number} ms @param {AbortSignal} [signal] @returns {Promise<void>}
 */
export const pause = (ms, signal) =>
  new Promise(done => {
    setTimeout(done, ms)
    signal?.addEventListener("abort", () => done())
  })

/** @param {string} path */
const address = path => new URL(`class${path ? "/" : ""}${path}`, document.baseURI)

// Requests to a live class over HTTP, and its refusals.

import {inWords} from "../core/notes.js"

const LIMIT = 10000 // ms for one question: a dead connection may never say that it is

/** A refusal of the server's, in a sentence; `status` is 0 where nobody answers. */
export class Refusal extends Error {
  /** @param {string} sentence @param {number} status */
  constructor(sentence, status) {
    super(sentence)
    this.status = status
  }

  /** Whether it may be answered another time. */
  get passes() {
    return !this.status || this.status === 429 || this.status >= 500
  }
}

/**
 * One question to the server; what it answers, or null where it has nothing to say.
 * @typedef {{method?: string, body?: unknown, word?: string, signal?: AbortSignal}} How
 * @param {string} path below class/ @param {How} [how]
 */
export async function ask(path, {method = "GET", body, word = "", signal} = {}) {
  const answer = await asked(path, {method, body, word, signal})
  return answer.status === 204 ? null : answer.json()
}

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
  const said = await answer.json().catch(() => ({}))
  throw new Refusal(said.sentence ?? "The class does not answer.", answer.status)
}

/**
 * Until the time is over, or a signal ends it.
 * @param {number} ms @param {AbortSignal} [signal] @returns {Promise<void>}
 */
export const pause = (ms, signal) =>
  new Promise(done => {
    setTimeout(done, ms)
    signal?.addEventListener("abort", () => done())
  })

/** @param {string} path */
const address = path => new URL(`class${path ? "/" : ""}${path}`, document.baseURI)

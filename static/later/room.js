// A room of the live class, over HTTP: what is asked of it, and the stream of what is new in it.

import {inWords} from "../notes.js"

const PATIENCE = 3000 // ms until a stream that brings nothing is given up for asking again and again
const BUSY = 250 // ms of it
const HASTE = 150 // ms, in its place, for the first try of a phone that wakes: its old connections may be dead
const SLOWING = 1.5 // times as long for each try after it
const HASTY = 6 // tries
const CONNECTIONS = 6 // that a browser keeps to one server
const SILENCE = 25000 // ms after which a stream is taken up anew: the server says something every 15 s
const ASKING = 1000 // ms between questions
const LONGEST = 8000 // ms between tries
const LIMIT = 10000 // ms for one question: a dead connection may never say that it is
/** Tries until it is believed that there is no such class: its store may just be filled anew. */
export const DOUBTS = 3
const TRIAL = 60000 // ms, after which a stream is tried again where none came through

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

/** @param {number} ms @returns {Promise<void>} */
export const pause = ms => new Promise(done => setTimeout(done, ms))

/** @param {string} path */
const address = path => new URL(`class${path ? "/" : ""}${path}`, document.baseURI)

/**
 * All that is new of a room. Where nothing comes through a stream, it asks once a second.
 * @typedef {{news: (news: Partial<page.News>) => void, refused: (refusal: Refusal) => void,
 *   connected: (is: boolean, why?: string) => void, outdated?: () => void}} Ears
 */
export class Stream {
  /** @type {AbortController} */
  control = new AbortController()

  listening = new AbortController()
  polls = false
  over = false
  atOnce = false // what is given up is begun anew without a pause
  number = ""
  last = 0 // when something was heard, by the time of day: it goes on while a phone sleeps
  tries = 0
  doubts = 0

  hasty = 0 // tries that are left of a phone that has just woken

  /** @type {number | undefined} until the next try */
  timer

  /** @param {string} code @param {string} word a token or the key @param {Ears} ears */
  constructor(code, word, ears) {
    this.code = code
    this.word = word
    this.ears = ears
    const {signal} = this.listening
    document.addEventListener("visibilitychange", () => document.hidden || this.#anew(), {signal})
    addEventListener("pageshow", event => event.persisted && this.#anew(), {signal})
    addEventListener("online", () => this.#anew(), {signal})
    this.watching = setInterval(() => this.#watch(), ASKING)
    this.#go()
  }

  /** A phone that wakes has slept through what was said, and its stream may be dead without a word. */
  #anew() {
    this.tries = 0
    this.hasty = HASTY
    this.atOnce = true
    this.control.abort()
    if (this.timer) this.#go()
  }

  #watch() {
    if (!this.timer && Date.now() - this.last > SILENCE) this.control.abort()
  }

  async #go() {
    clearTimeout(this.timer)
    this.timer = undefined
    this.atOnce = false
    this.last = Date.now()
    this.control = new AbortController()
    let why = ""
    try {
      await (this.polls ? this.#poll(this.control) : this.#read(this.control))
    } catch (reason) {
      if (reason instanceof Refusal && reason.status) {
        if (!reason.passes && this.doubts++ >= DOUBTS) return this.ears.refused(reason)
        why = reason.message
      }
    }
    if (this.over) return
    if (this.atOnce) return void this.#go()
    this.ears.connected(false, why)
    const longest = Math.min(300 * 2 ** this.tries++, LONGEST)
    this.timer = setTimeout(() => this.#go(), longest * (0.5 + Math.random()))
  }

  /** @param {AbortController} control */
  async #read(control) {
    const came = this.#expect(control)
    try {
      const answer = await asked(`${this.code}/events?after=${this.number}`, {word: this.word, signal: control.signal})
      if (answer.headers.get("Lecture-Version") !== document.documentElement.dataset.version) this.ears.outdated?.()
      await heard(answer, text => {
        came()
        this.#hear(JSON.parse(text))
      })
    } finally {
      came()
    }
  }

  /** @param {AbortController} control @returns {Promise<void>} */
  #poll(control) {
    return new Promise((_, failed) => {
      control.signal.addEventListener("abort", failed)
      const look = async () => {
        const came = this.#expect(control)
        const how = {word: this.word, signal: control.signal}
        const news = await ask(`${this.code}/now?after=${this.number}`, how).finally(came)
        if (news) this.#hear(news)
        else this.#hears()
        if (Date.now() > this.trial) this.#knock()
        if (!this.over) setTimeout(() => look().catch(failed), ASKING)
      }
      look().catch(failed)
    })
  }

  /**
   * What brings nothing is given up: a proxy may hold back even the head of a stream, a connection may be dead.
   * @param {AbortController} control @returns {() => void} to be called when something came
   */
  #expect(control) {
    const {hasty} = this
    const patience = hasty ? HASTE * SLOWING ** (HASTY - hasty) : PATIENCE
    const probing = new AbortController()
    if (hasty && hasty < HASTY) probe(probing.signal)
    const end = () => {
      this.atOnce = hasty > 0 || !this.polls
      if (!hasty && !this.polls) {
        this.polls = true
        this.trial = Date.now() + TRIAL
      }
      this.hasty = Math.max(0, hasty - 1)
      control.abort()
    }
    // In a page that was too busy to listen, what has come is heard first.
    const busy = Math.min(BUSY, patience / 2)
    let giveUp = setTimeout(() => {
      giveUp = setTimeout(end, busy)
    }, patience - busy)
    return () => {
      clearTimeout(giveUp)
      probing.abort()
    }
  }

  trial = 0 // when a stream is tried again

  /** Asking costs the server more than a stream: now and then one is tried, beside the asking. */
  async #knock() {
    this.trial = Date.now() + TRIAL
    const control = new AbortController()
    const giveUp = setTimeout(() => control.abort(), PATIENCE)
    try {
      const answer = await asked(`${this.code}/events`, {word: this.word, signal: control.signal})
      await heard(answer, () => {
        this.polls = false
        control.abort()
        this.#anew()
      })
    } catch {
      // Nothing comes through as yet.
    }
    clearTimeout(giveUp)
  }

  #hears() {
    this.last = Date.now()
    this.tries = 0
    this.doubts = 0
    this.hasty = 0
    this.ears.connected(true)
  }

  /** @param {Partial<page.News>} news */
  #hear(news) {
    this.#hears()
    this.number = news.number ?? ""
    this.over = Boolean(news.ended)
    this.ears.news(news)
  }

  close() {
    this.over = true
    clearTimeout(this.timer)
    clearInterval(this.watching)
    this.listening.abort()
    this.control.abort()
  }
}

/**
 * Each connection that died while the phone slept takes a request with it: these take all that the browser keeps.
 * @param {AbortSignal} signal when something has come, or nothing will
 */
function probe(signal) {
  for (let i = 1; i < CONNECTIONS; i++) ask("time", {signal}).catch(() => {})
}

/**
 * Each event of a stream, until it ends.
 * @param {Response} answer @param {(text: string) => void} event @returns {Promise<void>}
 */
function heard(answer, event) {
  const reader = /** @type {ReadableStream<Uint8Array<ArrayBuffer>>} */ (answer.body).getReader()
  const decoder = new TextDecoder()
  let text = ""
  return new Promise((ended, failed) => {
    const more = async () => {
      const {done, value} = await reader.read()
      if (done) return ended()
      const events = (text + decoder.decode(value, {stream: true})).split("\n\n")
      text = events.pop() ?? ""
      for (const each of events) event(each.slice("data: ".length))
      more().catch(failed)
    }
    more().catch(failed)
  })
}

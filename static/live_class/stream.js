// The stream of what is new in a live class: taken up anew where it breaks, and replaced by questions where none comes.

import {Refusal, ask, asked, pause, pauseAfter} from "./requests.js"

const PATIENCE = 3000 // ms until an attempt that brings nothing is given up
const HASTE = 150 // ms, in its place, for the first try of a page that wakes: its old connections may be dead
const SLOWING = 1.5 // times as long for each try after it
const HASTY = 6 // tries of a page that wakes
const BUSY = 250 // ms of a patience, in which a page that was too busy to listen hears what has come
const CONNECTIONS = 6 // that a browser keeps to one server
const SILENCE = 25000 // ms after which a stream is taken up anew: the server says something every 15 s
const ASKING = 1000 // ms between questions
const TRIAL = 60000 // ms, after which a stream is tried again where none came through
const SLEEP = 1e8 // ms, more than a day: until the page is seen again
const DOUBT = 30000 // ms for which a class is not there until that is believed: its server may begin anew
const NOW = "at once" // why an attempt ends that is followed by another without a pause

/**
 * A state, by how the room is asked: by a stream of events or by a question for what is new now; how long nothing may
 * come; whether dead connections are used up meanwhile; which state follows where nothing came, and whether at once.
 * @typedef {{by: "events" | "now", patience: number, probes?: boolean, late: string, rests?: boolean}} StreamState
 * @type {Record<string, StreamState>}
 */
export const STATES = {
  events: {by: "events", patience: PATIENCE, late: "now"}, // a proxy may hold back even the head of a stream
  now: {by: "now", patience: PATIENCE, late: "now", rests: true},
  ...woken("events"),
  ...woken("now"),
}

/** The states of a page that has just woken. @param {"events" | "now"} by @returns {Record<string, StreamState>} */
function woken(by) {
  const states = Array.from({length: HASTY}, (_, i) => {
    const late = i + 1 < HASTY ? `${by} woken ${i + 1}` : by
    return [`${by} woken ${i}`, {by, patience: HASTE * SLOWING ** i, probes: i > 0, late}]
  })
  return Object.fromEntries(states)
}

/**
 * @typedef {{news: (news: Partial<page.News>) => void, refused: (refusal: Refusal) => void,
 *   connected: (is: boolean, why?: string) => void, outdated?: () => void,
 *   sleeps?: boolean, doubt?: number}} StreamListener
 * One that `sleeps` has no stream while its page is hidden: a phone in a pocket is not counted. `doubt` is the time
 * in ms for which a class is not there until that is believed.
 */
export class Stream {
  state = "events"
  number = "" // of the last that was heard
  heardAt = 0 // by the time of day: it goes on while a phone sleeps
  knockAt = 0 // when a stream is tried beside the questions
  tries = 0 // that failed since something was heard
  missedAt = 0 // when the server has first said that there is no such class
  over = false

  /** Ends the attempt or the pause that is on. */
  control = new AbortController()

  listening = new AbortController()

  /** @param {string} code @param {string} word a token or the key @param {StreamListener} listener */
  constructor(code, word, listener) {
    this.code = code
    this.word = word
    this.listener = listener
    const {signal} = this.listening
    document.addEventListener("visibilitychange", () => (document.hidden ? this.#sleep() : this.wake()), {signal})
    addEventListener("pageshow", event => event.persisted && this.wake(), {signal})
    addEventListener("online", () => this.wake(), {signal})
    this.watching = setInterval(() => this.#watch(), ASKING)
    this.#go()
  }

  get by() {
    return STATES[this.state].by
  }

  /** The server is there, as is known; or a page wakes: it has slept through what was said, its stream may be dead. */
  wake() {
    this.tries = 0
    this.missedAt = 0
    this.state = `${this.by} woken 0`
    this.control.abort(NOW)
  }

  #sleep() {
    if (this.sleeps) this.control.abort(NOW)
  }

  get sleeps() {
    return document.hidden && this.listener.sleeps
  }

  #watch() {
    if (!this.sleeps && Date.now() - this.heardAt > SILENCE) this.control.abort()
  }

  /** One attempt after the other. */
  async #go() {
    if (this.sleeps) await this.#rest(SLEEP)
    if (this.over) return
    this.heardAt = Date.now()
    this.control = new AbortController()
    const {signal} = this.control
    const attempt = this.by === "events" ? this.#read(signal).then(() => this.#failed()) : this.#look(signal)
    const rest = await attempt.catch(reason => (signal.reason === NOW ? 0 : this.#failed(reason)))
    if (this.over) return
    if (rest) await this.#rest(rest)
    if (!this.over) this.#go()
  }

  /** @param {number} ms */
  #rest(ms) {
    this.heardAt = Date.now()
    this.control = new AbortController()
    return pause(ms, this.control.signal)
  }

  /** The time until the next try, in ms. @param {unknown} [reason] */
  #failed(reason) {
    const refusal = reason instanceof Refusal && reason.status ? reason : null
    const isMissed = refusal && !refusal.passes
    if (isMissed) this.missedAt ||= Date.now()
    if (isMissed && Date.now() - this.missedAt >= (this.listener.doubt ?? DOUBT)) {
      this.close()
      this.listener.refused(refusal)
    } else if (!this.over) this.listener.connected(false, refusal?.message)
    return pauseAfter(this.tries++)
  }

  /** All that a stream brings, until it ends. @param {AbortSignal} signal */
  async #read(signal) {
    const came = this.#expect()
    try {
      const answer = await asked(`${this.code}/events?after=${this.number}`, {word: this.word, signal})
      if (answer.headers.get("Lecture-Version") !== document.documentElement.dataset.version) this.listener.outdated?.()
      await heard(answer, text => {
        came()
        this.#hear(JSON.parse(text))
      })
    } finally {
      came()
    }
  }

  /** A question for what is new now, and the time until the next. @param {AbortSignal} signal */
  async #look(signal) {
    const came = this.#expect()
    const news = await ask(`${this.code}/now?after=${this.number}`, {word: this.word, signal}).finally(came)
    if (news) this.#hear(news)
    else this.#heard()
    if (Date.now() > this.knockAt) this.#knock()
    return ASKING
  }

  /** Gives the attempt up where nothing comes in time. @returns {() => void} to be called when something came */
  #expect() {
    const {control} = this
    const {patience, probes, late, rests} = STATES[this.state]
    const probing = new AbortController()
    if (probes) probe(probing.signal)
    const end = () => {
      if (this.state === "events") this.knockAt = Date.now() + TRIAL
      this.state = late
      control.abort(rests ? undefined : NOW)
    }
    const busy = Math.min(BUSY, patience / 2)
    let timer = setTimeout(() => {
      timer = setTimeout(end, busy)
    }, patience - busy)
    return () => {
      clearTimeout(timer)
      probing.abort()
    }
  }

  /** Asking costs the server more than a stream: now and then one is tried, beside the asking. */
  async #knock() {
    this.knockAt = Date.now() + TRIAL
    const control = new AbortController()
    const timer = setTimeout(() => control.abort(), PATIENCE)
    try {
      const answer = await asked(`${this.code}/events`, {word: this.word, signal: control.signal})
      await heard(answer, () => {
        control.abort()
        this.state = "events"
        this.wake()
      })
    } catch {
      // Nothing comes through as yet.
    }
    clearTimeout(timer)
  }

  #heard() {
    this.heardAt = Date.now()
    this.tries = 0
    this.missedAt = 0
    this.state = this.by
    this.listener.connected(true)
  }

  /** @param {Partial<page.News>} news */
  #hear(news) {
    this.#heard()
    this.number = news.number ?? ""
    this.over = Boolean(news.ended)
    try {
      this.listener.news(news)
    } catch (reason) {
      console.warn(reason) // a fault of the page says nothing about the connection
    }
  }

  close() {
    this.over = true
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

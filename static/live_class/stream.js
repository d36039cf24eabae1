// The stream of updates of a live class: reopened if it breaks, and replaced by polling if a proxy holds it back.

import {Refusal, fetchJson, asked, hasEnded, pause, pauseAfter} from "./requests.js"

const PATIENCE = 3000 // ms without data until an attempt is given up
const HASTE = 150 // the same for the first try of a page that becomes visible again, whose old connections may be dead
const SLOWING = 1.5 // factor for each further try
const HASTY = 6 // number of such short tries
const BUSY = 250 // extra ms, so that a busy page can read data that has arrived
const CONNECTIONS = 6 // number of connections that a browser keeps to one server
const SILENCE = 25000 // ms after which a stream is reopened: the server sends something every 15 s
const ASKING = 1000 // ms between requests during polling
const TRIAL = 60000 // ms until a stream is tried again during polling
const SLEEP = 1e8 // ms, more than a day: the pause of a hidden page
const DOUBT = 30000 // ms until a missing class counts as over, because its server may be restarting
const NOW = "at once" // the reason to end an attempt and start the next without a pause

/**
 * A state of the connection. `by`: the kind of request, a stream of events or one request for the news until now.
 * `patience`: the longest silence in ms. `probes`: true to use up dead connections meanwhile. `late`: the next state if
 * nothing comes. `rests`: true for a pause before the next request.
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
 * A listener that `sleeps` has no stream while its page is hidden: a phone in a pocket is not counted. `doubt` is the
 * time in ms until a missing class counts as over.
 */
export class Stream {
  state = "events"
  number = "" // number of the last news that were received
  receivedAt = 0 // time of the last data, by the time of day, which continues while a phone sleeps
  knockAt = 0 // time at which polling tries a stream next
  tries = 0 // failed tries since the last data
  missedAt = 0 // when the server first reported that there is no such class
  over = false

  /** Ends the current attempt or pause. */
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

  /**
   * Tries again at once, because the server can be reached, or because the page becomes visible with a stream that may
   * be dead.
   */
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
    if (!this.sleeps && Date.now() - this.receivedAt > SILENCE) this.control.abort()
  }

  /** Makes one attempt after the other. */
  async #go() {
    if (this.sleeps) await this.#rest(SLEEP)
    if (this.over) return
    this.receivedAt = Date.now()
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
    this.receivedAt = Date.now()
    this.control = new AbortController()
    return pause(ms, this.control.signal)
  }

  /** The time until the next try, in ms. @param {unknown} [reason] */
  #failed(reason) {
    const refusal = reason instanceof Refusal && reason.status ? reason : null
    const isMissed = refusal && !refusal.passes
    if (isMissed) this.missedAt ||= Date.now()
    const doubt = hasEnded(refusal) ? 0 : (this.listener.doubt ?? DOUBT)
    if (isMissed && Date.now() - this.missedAt >= doubt) {
      this.close()
      this.listener.refused(refusal)
    } else if (!this.over) this.listener.connected(false, refusal?.message)
    return pauseAfter(this.tries++)
  }

  /** Reads a stream until it ends. @param {AbortSignal} signal */
  async #read(signal) {
    const came = this.#expect()
    try {
      const answer = await asked(`${this.code}/events?after=${this.number}`, {word: this.word, signal})
      if (answer.headers.get("Lecture-Version") !== document.documentElement.dataset.version) this.listener.outdated?.()
      await heard(answer, text => {
        came()
        this.#receive(JSON.parse(text))
      })
    } finally {
      came()
    }
  }

  /** Requests the news until now, and returns the time until the next request. @param {AbortSignal} signal */
  async #look(signal) {
    const came = this.#expect()
    const news = await fetchJson(`${this.code}/now?after=${this.number}`, {word: this.word, signal}).finally(came)
    if (news) this.#receive(news)
    else this.#received()
    if (Date.now() > this.knockAt) this.#knock()
    return ASKING
  }

  /** Ends the attempt if nothing comes in time. @returns {() => void} function to call when data come */
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

  /** Tries a stream now and then during polling, because polling costs the server more. */
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
      // Streams are still held back.
    }
    clearTimeout(timer)
  }

  #received() {
    this.receivedAt = Date.now()
    this.tries = 0
    this.missedAt = 0
    this.state = this.by
    this.listener.connected(true)
  }

  /** @param {Partial<page.News>} news */
  #receive(news) {
    this.#received()
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
 * Uses up the connections that died while the phone slept, with one request for each that the browser keeps.
 * @param {AbortSignal} signal aborts when data have come, or none will
 */
function probe(signal) {
  for (let i = 1; i < CONNECTIONS; i++) fetchJson("time", {signal}).catch(() => {})
}

/**
 * Calls `event` with each event of a stream until it ends.
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

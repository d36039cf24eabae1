// A room of the live class, over HTTP: what is asked of it, and the stream of what is new in it.

const PATIENCE = 3000 // ms until a stream that brings nothing is given up for asking again and again
const SILENCE = 25000 // ms after which a stream is taken up anew: the server says something every 15 s
const ASKING = 1000 // ms between questions
const LONGEST = 8000 // ms between tries

/** A refusal of the server's, in a sentence; `status` is 0 where nobody answers. */
export class Refusal extends Error {
  /** @param {string} sentence @param {number} status */
  constructor(sentence, status) {
    super(sentence)
    this.status = status
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
export async function asked(path, {method = "GET", body, word = "", signal}) {
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
    throw new Refusal(`Nobody answers: ${reason instanceof Error ? reason.message : reason}.`, 0)
  }
  if (answer.ok) return answer
  const said = await answer.json().catch(() => ({}))
  throw new Refusal(said.sentence ?? "The class does not answer.", answer.status)
}

/** @param {string} path */
const address = path => new URL(`class${path ? "/" : ""}${path}`, document.baseURI)

/**
 * All that is new of a room. Where nothing comes through a stream, it asks once a second.
 * @typedef {{news: (news: Partial<page.News>) => void, refused: (refusal: Refusal) => void,
 *   connected: (is: boolean) => void}} Ears
 */
export class Stream {
  /** @type {AbortController | null} */
  control = null

  polls = false
  over = false
  number = ""
  last = 0
  tries = 0

  /** @param {string} code @param {string} word a token or the key @param {Ears} ears */
  constructor(code, word, ears) {
    this.code = code
    this.word = word
    this.ears = ears
    document.addEventListener("visibilitychange", () => document.hidden || this.#wake())
    addEventListener("online", () => this.#wake())
    setInterval(() => this.#watch(), 1000)
    this.#go()
  }

  /** A phone that wakes has slept through what was said. */
  #wake() {
    this.tries = 0
    if (performance.now() - this.last > 2000) this.control?.abort()
  }

  #watch() {
    if (performance.now() - this.last > SILENCE) this.control?.abort()
  }

  async #go() {
    this.control = new AbortController()
    try {
      await (this.polls ? this.#poll(this.control.signal) : this.#read(this.control))
    } catch (reason) {
      if (reason instanceof Refusal && reason.status >= 400 && reason.status < 500 && reason.status !== 429) {
        this.ears.refused(reason)
        return
      }
    }
    this.last = performance.now()
    if (this.over) return
    this.ears.connected(false)
    const longest = Math.min(300 * 2 ** this.tries++, LONGEST)
    setTimeout(() => this.over || this.#go(), longest * (0.5 + Math.random()))
  }

  /** @param {AbortController} control */
  async #read(control) {
    const answer = await asked(`${this.code}/events`, {word: this.word, signal: control.signal})
    const reader = /** @type {ReadableStream<Uint8Array<ArrayBuffer>>} */ (answer.body).getReader()
    const giveUp = setTimeout(() => {
      this.polls = true
      control.abort()
    }, PATIENCE)
    const decoder = new TextDecoder()
    let text = ""
    const more = async () => {
      const {done, value} = await reader.read()
      clearTimeout(giveUp)
      if (done) return
      text += decoder.decode(value, {stream: true})
      const events = text.split("\n\n")
      text = events.pop() ?? ""
      for (const event of events) this.#hear(JSON.parse(event.slice("data: ".length)))
      await more()
    }
    await more()
  }

  /** @param {AbortSignal} signal */
  async #poll(signal) {
    const news = await ask(`${this.code}/now?after=${this.number}`, {word: this.word, signal})
    if (news) this.#hear(news)
    this.last = performance.now()
    await new Promise(done => setTimeout(done, ASKING))
    if (!this.over) await this.#poll(signal)
  }

  /** @param {Partial<page.News>} news */
  #hear(news) {
    this.last = performance.now()
    this.tries = 0
    this.number = news.number ?? ""
    this.ears.connected(true)
    this.over = Boolean(news.ended)
    this.ears.news(news)
  }

  close() {
    this.over = true
    this.control?.abort()
  }
}

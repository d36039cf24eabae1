// The queue of messages: one in flight, numbered, repeated if its answer is lost. They wait while there is no
// connection.

const PATIENCE = 5000 // ms without an answer until a message is repeated, and until the connection counts as lost
const PROBE = 2500 // the same for a page that becomes visible again
const AGAIN = 1000 // ms until a message is repeated that the server was too busy to answer
const JOBS = new Set(["about", "csv", "rows"]) // messages for the worker process, which may still be starting
const LONGER = 4 // factor on the waiting time for these messages

/**
 * Local data about a message: `turn`: it adds an entry to the browser's history; `start`: the clock
 * restarts with its answer; `sets`: the values that it sets if it is built later; `repeated`: it is sent to each new
 * session; `answered`: callback for its answer; `way` and `undoGroup`: for undo.
 * @typedef {{turn?: boolean, start?: boolean, sets?: Record<string, page.Value>, repeated?: boolean,
 *   answered?: (message: ServerMessage) => void, way?: import("../shell/undo.js").Direction,
 *   undoGroup?: string}} Envelope
 * @typedef {Envelope & {message: page.BrowserMessage}} Asked
 * @typedef {Envelope & {message: page.BrowserMessage | ((state: page.State) => page.BrowserMessage | null)}} Waiting
 */

export class Messages {
  /** @type {Waiting[]} messages that are not sent yet */
  outbox = []

  /** @type {Asked | null} the message that is sent but not answered */
  asked = null

  /** @type {import("./wire.js").Wire | null} */
  wire = null

  /** @type {page.State} the last state that the server sent */
  state

  behind = true // true until the messages that waited for a connection are answered

  /** The messages that a new session gets first. @returns {page.BrowserMessage[]} */
  greeting = () => []

  /** Called when a message has been sent twice without an answer. */
  overdue = () => {}

  lostConnections = 0
  number = 0
  patience = PATIENCE

  /** @type {number | undefined} */
  reminder

  /** @type {Promise<unknown>} messages are handled in the order of their arrival */
  handled = Promise.resolve()

  /**
   * `unpack` reads a packet. `handle` handles a message and, if it is an answer, the message that it answers. `fail` is
   * called if a packet cannot be read, `report` with exceptions of `handle`, which say nothing about the connection.
   * @param {(packet: Packet) => Promise<ServerMessage>} unpack
   * @param {(message: ServerMessage, asked: Asked | null) => void} handle
   * @param {(error: unknown) => void} fail @param {(error: unknown) => void} report
   */
  constructor(unpack, handle, fail, report) {
    this.unpack = unpack
    this.handle = handle
    this.fail = fail
    this.report = report
  }

  /**
   * Takes a connection to the same session or to a new one. A new session gets the current state before the unanswered
   * message is sent again.
   * @param {import("./wire.js").Wire} wire @param {boolean} isNew for a new session
   */
  attach(wire, isNew) {
    this.wire = wire
    if (isNew) {
      if (this.asked && !this.asked.repeated) this.outbox.unshift(this.asked)
      this.asked = null
      const greeting = this.greeting().map(message => ({repeated: true, message}))
      const open = {
        repeated: true,
        message: (/** @type {page.State} */ state) => ({type: /** @type {const} */ ("open"), state}),
      }
      this.outbox = [...greeting, open, ...this.outbox.filter(waiting => !waiting.repeated)]
    }
    this.#flush()
    this.behind = Boolean(this.asked)
  }

  /** Called when the connection is lost. */
  detach() {
    clearTimeout(this.reminder)
    this.wire = null
    this.lostConnections++
    this.handled = Promise.resolve()
    this.behind = true
  }

  /**
   * Queues a message. One that depends on the state is built after the answers to all earlier ones, or dropped.
   * @param {Waiting["message"]} message @param {Envelope} [about]
   */
  send(message, about = {}) {
    const names = namesIn(message)
    if (names.length) this.#supersede(names)
    const last = this.outbox[this.outbox.length - 1]
    const values = valuesOf(message)
    const earlier = last && valuesOf(last.message)
    const copy = values ? {.../** @type {page.SetValues} */ (message), values: {...earlier, ...values}} : message
    if (earlier && values) Object.assign(last, about, {message: copy})
    else this.outbox.push({...about, message: copy})
    this.#flush()
  }

  /**
   * Sends a message and resolves with its answer.
   * @param {page.BrowserMessage} message @returns {Promise<ServerMessage>}
   */
  request(message) {
    return new Promise(answered => this.send(message, {answered}))
  }

  /** Stops waiting for the answer to a message of this type. @param {page.BrowserMessage["type"]} type */
  abandon(type) {
    if (this.asked?.message.type !== type) return
    clearTimeout(this.reminder)
    this.asked = null
    this.#flush()
  }

  /** Tests the connection, because a phone that slept does not notice a lost one. */
  probe() {
    if (!this.wire) return
    if (!this.asked) this.send({type: "set", values: {}}, {repeated: true})
    clearTimeout(this.reminder)
    this.reminder = setTimeout(() => this.overdue(), PROBE)
  }

  /** Removes unsent values of these parameters, because newer ones replace them. @param {string[]} names */
  #supersede(names) {
    for (let i = this.outbox.length - 1; i >= 0; i--) {
      const {message} = this.outbox[i]
      if (!namesIn(message).length) return // this message may depend on the messages before it
      for (const name of names) delete valuesOf(message)?.[name]
      if (namesIn(message).every(name => names.includes(name))) this.outbox.splice(i, 1)
    }
  }

  /** The number of the last message, sent or not. */
  get last() {
    return this.number + this.outbox.length
  }

  /** True if every message has been answered. */
  get rests() {
    return !this.#queue.length
  }

  /** The unsent values by parameter: the newest, or the typed text. @returns {Waits} */
  get waiting() {
    return new Map(this.#late.flatMap(({message, sets}) => Object.entries(sets ?? givenIn(message))))
  }

  /** The number of unsent changes; one message counts once. */
  get changes() {
    return this.#late.length
  }

  /** The scene that will be opened, or "". */
  get turnsTo() {
    const opens = this.#late.flatMap(({message}) =>
      typeof message !== "function" && message.type === "open" ? message.state.scene : [],
    )
    const scene = opens.at(-1) ?? ""
    return scene === this.state.scene ? "" : scene
  }

  /** The visitor's messages that wait for a connection. */
  get #late() {
    return this.behind ? this.#queue.filter(({repeated}) => !repeated) : []
  }

  /** The unsent messages, for a page that replaces this one. @returns {page.BrowserMessage[]} */
  get left() {
    let {state} = this
    const plain = this.#queue.flatMap(({message: made, repeated}) => {
      if (repeated) return []
      const message = typeof made === "function" ? made(state) : made
      if (message?.type === "rows") return [] // measured points are never stored
      if (message?.type === "open") ({state} = message)
      if (message?.type === "set") state = {...state, parameters: {...state.parameters, ...message.values}}
      return message
    })
    return plain.filter(message => message !== null)
  }

  /** @returns {Waiting[]} */
  get #queue() {
    return this.asked ? [this.asked, ...this.outbox] : this.outbox
  }

  #flush() {
    while (this.wire && !this.asked && this.outbox.length) {
      const next = /** @type {Waiting} */ (this.outbox.shift())
      const message = typeof next.message === "function" ? next.message(this.state) : next.message
      if (!message) continue
      this.asked = {...next, message: {...message, number: message.number ?? ++this.number}}
      this.#sendAsked()
    }
  }

  #sendAsked() {
    this.#sendWithReminder(() => this.#sendWithReminder(() => this.overdue()))
  }

  // Sends a message again that may be lost. The server applies each number only once.
  #sendWithReminder(/** @type {() => void} */ otherwise) {
    const {asked} = this
    if (asked) this.wire?.send(asked.message)
    const isJob = asked && JOBS.has(asked.message.type)
    this.reminder = setTimeout(otherwise, this.patience * (isJob ? LONGER : 1))
  }

  /** @param {Packet} packet */
  receive(packet) {
    const {lostConnections} = this
    const unpacked = this.unpack(packet)
    // Ignore packets of a lost connection, because the server repeats them on the next one.
    const current = () => lostConnections === this.lostConnections
    this.handled = this.handled
      .then(() => unpacked)
      .then(
        message => current() && this.#receive(message),
        error => current() && this.fail(error),
      )
  }

  /**
   * Handles a message of the server. Answers to other than the awaited message are repetitions and are dropped;
   * messages that have no number are not answers.
   * @param {ServerMessage} message
   */
  #receive(message) {
    if (message.answer === null) return this.#take(message, null)
    const {asked} = this
    if (message.answer !== asked?.message.number) return
    clearTimeout(this.reminder)
    if (asked.repeated && "is_busy" in message && message.is_busy) {
      this.reminder = setTimeout(() => this.#sendAsked(), AGAIN) // later messages depend on this state
      return
    }
    this.asked = null
    this.#take(message, asked)
    this.#flush()
    if (!this.asked) this.behind = false
  }

  /** @param {ServerMessage} message @param {Asked | null} asked the message that it answers */
  #take(message, asked) {
    if (message.type === "shown") this.state = message.state
    try {
      this.handle(message, asked)
    } catch (error) {
      this.report(error)
    }
  }
}

/** The values that a message sets. @param {Waiting["message"]} message @returns {Record<string, page.Value>} */
function givenIn(message) {
  if (typeof message === "function") return {}
  if (message.type === "set") return message.values
  if (message.type === "typed") return {[message.name]: message.text}
  return message.type === "choose" ? {[message.name]: message.value} : {}
}

/** @param {Waiting["message"]} message */
const namesIn = message => Object.keys(givenIn(message))

/** The values that a slider or handle sets; null for other messages. @param {Waiting["message"]} message */
const valuesOf = message => (typeof message !== "function" && message.type === "set" ? message.values : null)

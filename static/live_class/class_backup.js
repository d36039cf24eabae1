// Copies of a class's data in the instructor's browser, from which a restarted server can restore the class.

import {LED, browserStorage, tabStorage} from "../core/storage.js"
import {Refusal, fetchJson, pause} from "./requests.js"

const ROOM = "class-room"
const GIVEN = "class-given"
const WALK = "class-walk"
const BREAK = 20 * 60000 // ms; every server ends a class that nobody has led for so long
const COPYING = 5000 // ms between two copies of new answers
const LONGEST = 40000 // largest length of an order in characters
const AGAIN = 1000 // ms until an order is sent again

/** Until a restored class gets a question or this order, phones keep their answers and try again. */
const NO_QUESTION = /** @type {const} */ ({type: "withdraw"})

/**
 * A room as it is stored: its remote control, the current question (`put`), for each question its last vote (`last`)
 * and its last vote with a shown answer (`shown`), and the time when an instructor last led the room (`seen`).
 * @typedef {{walk: string, step: string, vote: number, isShown: boolean, isClosed: boolean, answered: boolean,
 *   sure: boolean}} Put
 * @typedef {page.Opened & {control?: string, put?: Put | null, last?: Record<string, number>,
 *   shown?: Record<string, number>, seen?: number, isLost?: boolean}} Room; `isLost` until it is completely restored
 * @typedef {Record<string, page.Voted>} Ballot the answer of each voter
 */

export class Copies {
  /** Votes of which not all answers are copied. @type {Set<string>} */
  stale = new Set()

  /** @type {number | undefined} */
  timer

  isBehind = false // true while copies of earlier answers are missing; they are then fetched without pauses

  /** @param {Room} room */
  constructor(room) {
    this.room = room
    browserStorage.forget(...copies().filter(name => name.split(" ")[1] !== room.code))
    /** @type {Map<string, Ballot>} by vote: the step and the number of the vote */
    this.answers = copied(GIVEN, room.code, name => browserStorage.value(name) ?? {})
    /** @type {Map<string, string>} texts of walks from files that were asked, by name */
    this.walks = copied(WALK, room.code, name => browserStorage.text(name) ?? "")
    this.save()
  }

  /** @param {Partial<Room>} [more] */
  save(more) {
    Object.assign(this.room, more)
    browserStorage.keepOrSay(ROOM, {...this.room, seen: Date.now()})
  }

  /** @param {Partial<page.News>} news */
  receive({question, answers}) {
    if (this.room.isLost) return
    if (question) {
      const {walk, step, vote, lesson, closed, answered, sure} = question
      const put = step ? {walk, step, vote, isShown: Boolean(lesson), isClosed: closed, answered, sure} : null
      const {last, shown} = this.room
      const known = {[`${walk}/${step}`]: vote}
      this.save({put, last: put ? {...last, ...known} : last, shown: lesson ? {...shown, ...known} : shown})
    }
    const {put} = this.room
    if (answers && put) this.stale.add(voteOf(put))
    this.#wait()
  }

  #wait() {
    if (this.stale.size) this.timer ??= setTimeout(() => this.#copy(), this.isBehind ? 0 : COPYING)
  }

  /** Copies the answers that the class gave before this computer led it. */
  async #copyAll() {
    const {code, key} = this.room
    /** @type {page.StepSummary[]} */
    const steps = await fetchJson(`${code}/summary`, {word: key}).catch(() => [])
    const last = {...this.room.last}
    for (const {walk, step, votes} of steps)
      for (const {vote} of votes) {
        this.stale.add(voteOf({walk, step, vote}))
        last[`${walk}/${step}`] ??= votes[votes.length - 1].vote
      }
    this.save({last})
    this.isBehind = true
    this.#wait()
  }

  /** Saves a copy of one vote's answers. */
  async #copy() {
    const {code, key} = this.room
    const [vote] = this.stale
    this.stale.delete(vote)
    const path = `${code}/answers?question=${encodeURIComponent(vote)}`
    const answers = await fetchJson(path, {word: key}).catch(() => null)
    if (answers) {
      this.answers.set(vote, answers)
      browserStorage.keep(copyOf(GIVEN, code, vote), answers) // if the storage is full, only this page has them
    } else this.stale.add(vote)
    this.isBehind &&= Boolean(answers) && this.stale.size > 0
    this.timer = undefined
    this.#wait()
  }

  /** The last vote on a question; 0 if there was none. @param {string} question */
  last(question) {
    return this.room.last?.[question] ?? 0
  }

  /** True if the class has seen the answer to a question since the last vote. @param {string} question */
  isAnswered(question) {
    return this.last(question) > 0 && this.room.shown?.[question] === this.last(question)
  }

  /** Adds a walk from a file to the copies. @param {string} name @param {string} text */
  take(name, text) {
    this.walks.set(name, text)
    browserStorage.keep(copyOf(WALK, this.room.code, name), text)
  }

  /** Opens the room again, with its questions and answers. */
  async restore() {
    const {code, key, control = "", put} = this.room
    this.save({isLost: true})
    this.save(await fetchJson(`${code}/lead`, {method: "PUT", body: {control}, word: key}))
    /** @type {page.Order[]} */
    const orders = [...this.walks].map(([name, text]) => ({type: "walk", name, text}))
    if (put) {
      const {walk, step, vote, answered = false} = put
      orders.push({type: "put", walk, step, vote, answered})
    } else orders.push(NO_QUESTION)
    if (put?.sure) orders.push({type: "sure"})
    if (put?.isClosed) orders.push({type: "close"})
    if (put?.isShown) orders.push({type: "show"})
    const lost = [...this.answers.values()].flatMap(parcels)
    orders.push(...lost.map(answers => /** @type {const} */ ({type: "restore", answers})))
    await orders.reduce((done, order) => done.then(() => this.#order(order)), Promise.resolve())
    this.save({isLost: false})
  }

  /**
   * Sends an order to the server. A final refusal does not stop later orders. @param {page.Order} order @returns
   * {Promise<void>}
   */
  async #order(order) {
    const {code, key} = this.room
    try {
      await fetchJson(`${code}/lead`, {method: "POST", body: order, word: key})
    } catch (reason) {
      if (!(reason instanceof Refusal) || reason.status === 404) throw reason
      if (reason.passes) {
        await pause(AGAIN)
        return this.#order(order)
      }
      console.warn(reason)
      if (order.type === "put") await this.#order(NO_QUESTION)
    }
  }

  /** The class is over. */
  forget() {
    clearTimeout(this.timer)
    browserStorage.forget(ROOM, ...copies())
  }

  /** The class that this browser led until recently, if it continues. */
  static async find() {
    const room = /** @type {Room | null} */ (browserStorage.value(ROOM))
    if (!room) return null
    try {
      const found = new Copies({...room, ...(await fetchJson(`${room.code}/lead`, {word: room.key}))})
      if (!room.seen) found.#copyAll()
      if (room.isLost) await found.restore()
      return found
    } catch (reason) {
      if (!(reason instanceof Refusal) || reason.passes) throw reason
    }
    if (Date.now() - (room.seen ?? 0) > BREAK) return null
    const found = new Copies(room)
    return found.restore().then(
      () => found,
      () => null,
    )
  }
}

/**
 * Makes this computer lead a class. `word` is a secret: the computer that led the class before shows it.
 * @param {string} code @param {string} word
 */
export async function takeOver(code, word) {
  /** @type {page.TakenOver} */
  const {query, walks, ...room} = await fetchJson(`${code}/word`, {method: "PUT", body: {word}})
  for (const [name, text] of Object.entries(walks)) browserStorage.keep(copyOf(WALK, room.code, name), text)
  browserStorage.keepOrSay(ROOM, room)
  tabStorage.keep(LED, "open") // the next page of this tab returns to the class
  location.replace(`./?${query}`)
}

/** The names of all copies of classes, "class-given EUW5 d31/d31-03/1". */
const copies = () => browserStorage.names().filter(name => name.startsWith(GIVEN) || name.startsWith(WALK))

/** @param {string} kind @param {string} code @param {string} of a vote or walk */
const copyOf = (kind, code, of) => `${kind} ${code} ${of}`

/**
 * All copies of one kind that belong to a class, by vote or walk.
 * @template Value @param {string} kind @param {string} code @param {(name: string) => Value} read
 */
function copied(kind, code, read) {
  const all = copyOf(kind, code, "")
  const own = copies().filter(name => name.startsWith(all))
  return new Map(own.map(name => [name.slice(all.length), read(name)]))
}

/** @param {{walk: string, step: string, vote: number}} put */
const voteOf = ({walk, step, vote}) => `${walk}/${step}/${vote}`

/** Splits answers into parts that fit into one order. @param {Ballot} answers @returns {Ballot[]} */
function parcels(answers) {
  /** @type {Ballot[]} */
  const all = []
  let size = LONGEST
  for (const [name, one] of Object.entries(answers)) {
    const length = name.length + JSON.stringify(one).length
    if (size + length > LONGEST) {
      all.push({})
      size = 0
    }
    size += length
    all[all.length - 1][name] = one
  }
  return all
}

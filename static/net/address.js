// The address of a page: a link with its complete state, if it is not too long for the server.

const REST = 350 // ms between two writes on average: Safari allows 100 in 30 s
const AHEAD = 10 // changes that are written at once, so that a reload right after them keeps them
const LONGEST = 8000 // maximum length of a query, as in components/serving/pages.py

/** @param {string} query */
export const isTooLong = query => query.length > LONGEST

/** A link to a scene with its defaults; a message then brings the state. @param {string} scene */
export const plainLink = scene => `?scene=${scene}`

/**
 * The address of a state, and the state to store in the browser's history entry. If the address would be too long, it
 * names only the scene, and a page that is loaded from it opens the stored state (`begin` in main.js). `ending`:
 * parameters of the address that are not part of the state.
 * @param {{query: string, state: page.State}} shown @param {string} ending
 */
export const written = ({query, state}, ending) =>
  isTooLong(query)
    ? {address: plainLink(state.scene) + ending, entry: {...state, waiting: []}}
    : {address: `?${query}${ending}`, entry: state}

/** The address bar and the entries of the browser's history. */
export class Address {
  /** @type {(() => void) | null} writes what is not written yet */
  #late = null

  #due = -Infinity // time of the next permitted write

  /** @type {number | undefined} */
  #timer

  constructor() {
    addEventListener("pagehide", () => this.settle()) // for the back button; too late for a reload
    addEventListener("popstate", () => (this.#late = null)) // the pending write was meant for the previous entry
  }

  /**
   * Writes to the current entry, at once if no more changes are expected and few were written recently.
   * @param {{address: string, entry: unknown}} what @param {boolean} more
   */
  write({address, entry}, more) {
    clearTimeout(this.#timer)
    this.#late = () => history.replaceState(entry, "", address)
    const wait = more ? REST : this.#due - Date.now()
    if (wait <= 0) this.settle()
    else this.#timer = setTimeout(() => this.settle(), wait)
  }

  /** Adds an entry if the address is new. @param {{address: string, entry: unknown}} what */
  turn(what) {
    this.settle()
    if (what.address === location.search) this.write(what, false)
    else history.pushState(what.entry, "", what.address)
  }

  settle() {
    clearTimeout(this.#timer)
    if (!this.#late) return
    this.#late()
    this.#late = null
    this.#due = Math.max(this.#due, Date.now() - AHEAD * REST) + REST
  }
}

// Storage: texts and JSON by name, in the browser or in one tab. Nothing here throws. If storage is disabled, reads are
// empty, and a visitor who would lose something gets one notice.

import {note} from "./notes.js"

const NOTHING = "This browser stores nothing for this page: your choices and answers are lost when it is closed."

let wasReported = false

class Shelf {
  /** @param {() => Storage} find returns the storage; a function, because even access to it can throw */
  constructor(find) {
    this.find = find
  }

  /** The text under a name. @param {string} name @returns {string | null} */
  text(name) {
    return this.#tried(storage => storage.getItem(name)) ?? null
  }

  /** The JSON under a name; null where there is none. @template Value @param {string} name @returns {Value | null} */
  value(name) {
    return this.#tried(storage => JSON.parse(storage.getItem(name) ?? "null")) ?? null
  }

  /** Stores a text, or a value as JSON; returns true on success. @param {string} name @param {unknown} value */
  keep(name, value) {
    const text = typeof value === "string" ? value : JSON.stringify(value)
    return Boolean(this.#tried(storage => (storage.setItem(name, text), true)))
  }

  /** Stores data that a visitor would miss, or shows a notice. @param {string} name @param {unknown} value */
  keepOrSay(name, value) {
    if (this.keep(name, value)) return
    if (!wasReported) note(NOTHING)
    wasReported = true
  }

  /** @param {string[]} names */
  forget(...names) {
    for (const name of names) this.#tried(storage => storage.removeItem(name))
  }

  /** @returns {string[]} */
  names() {
    return this.#tried(storage => Object.keys(storage)) ?? []
  }

  /** @template Found @param {(storage: Storage) => Found} act */
  #tried(act) {
    try {
      return act(this.find())
    } catch {
      return undefined
    }
  }
}

/** The name of a frame that shares no storage with the tab around it. */
export const APART = "oscillations-apart"
const apart = globalThis.window?.name === APART ? new Map() : null

/** Storage of a page in such a frame, which lasts as long as the page. */
const own = apart && {
  getItem: (/** @type {string} */ name) => apart.get(name) ?? null,
  setItem: (/** @type {string} */ name, /** @type {string} */ text) => apart.set(name, text),
  removeItem: (/** @type {string} */ name) => apart.delete(name),
}

export const browserStorage = new Shelf(() => localStorage)
export const tabStorage = new Shelf(() => /** @type {Storage} */ (own ?? sessionStorage))

// Names in a tab's storage that several modules use.
export const LED = "class-room" // that the tab leads a class
export const LEFT = "class-left" // the code of the class that a follower has left to look around
export const SOUGHT = "class-sought" // the state for which a follower has left the class

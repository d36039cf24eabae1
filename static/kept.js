// What the browser keeps for the next visit. One that keeps nothing is as good, and that is said once.

import {note} from "./notes.js"

const NOTHING = "This browser keeps nothing for this page: what you chose or answered lasts until the page is closed."

let told = false

/** @param {string} name */
export function kept(name) {
  try {
    return localStorage.getItem(name)
  } catch {
    return null
  }
}

/** @param {string} name @param {string} text */
export function keep(name, text) {
  try {
    localStorage.setItem(name, text)
  } catch {
    if (!told) note(NOTHING)
    told = true
  }
}

// What the browser keeps for the next visit. One that keeps nothing is as good, and that is said once.

import {note} from "./notes.js"

const NOTHING = "This browser stores nothing for this page: your choices and answers are lost when it is closed."

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

/** Light in place of dark or dark in place of light, from now on. */
export function turnTheme() {
  const {dataset} = document.documentElement
  dataset.theme = dataset.theme === "dark" ? "light" : "dark"
  keep("theme", dataset.theme)
}

// The draft of a walk: the steps written on the page, and their file: TOML, as docs/writing-a-walk.md says.

import {browserStorage} from "../core/storage.js"

const KEY = "asked-steps"

export const ALOUD = "votes" // the name of the walk of what is asked aloud

/** @typedef {import("../questions/question.js").Fields} Fields */

export class Draft {
  /** @type {Fields[]} in the order of the questions */
  steps = []

  title = "My walk"

  constructor() {
    Object.assign(this, browserStorage.value(KEY))
  }

  keep() {
    browserStorage.keepOrSay(KEY, {steps: this.steps, title: this.title})
  }

  /** An id that no other step has. */
  get nextId() {
    const taken = new Set(this.steps.map(step => step.id))
    let n = this.steps.length + 1
    while (taken.has(`asked-${n}`)) n++
    return `asked-${n}`
  }

  /** A walk's file. @param {Fields[]} [steps] */
  file(steps = this.steps) {
    return walkText(this.title, steps)
  }
}

/** A walk's file. @param {string} title @param {Fields[]} steps */
export const walkText = (title, steps) => [`${line(["title", title])}\n`, ...steps.map(stepText)].join("")

/** A step in such a file. @param {Fields} step */
export const stepText = step => ["\n[[step]]", ...Object.entries(step).map(line), ""].join("\n")

/** The link to the picture of a step. Its covers are in a separate field. @param {string} query */
export const shownBy = query =>
  `?${query
    .split("&")
    .filter(part => !part.startsWith("cover="))
    .join("&")}`

/** @param {[string, Toml]} field */
const line = ([name, value]) => `${name} = ${written(value)}`

/** Strings of JSON are strings of TOML, but for one sign. @param {Toml} value @returns {string} */
function written(value) {
  if (Array.isArray(value)) {
    const items = value.map(written)
    return typeof value[0] === "object" ? `[\n${items.map(item => `  ${item},\n`).join("")}]` : `[${items.join(", ")}]`
  }
  if (typeof value === "object") return `{ ${Object.entries(value).map(line).join(", ")} }`
  if (typeof value === "string") return JSON.stringify(value).replaceAll("\u007f", "\\u007f")
  return String(value)
}

// The draft of a walk: the steps that a visitor writes on the page, and their file in TOML (docs/writing-a-walk.md).

import {browserStorage} from "../core/storage.js"

const KEY = "asked-steps"

export const ALOUD = "votes" // the name of the walk for questions that are asked aloud

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

  /** The text of the walk's file. @param {Fields[]} [steps] */
  file(steps = this.steps) {
    return walkText(this.title, steps)
  }
}

/** The text of a walk's file. @param {string} title @param {Fields[]} steps */
export const walkText = (title, steps) => [`${line(["title", title])}\n`, ...steps.map(stepText)].join("")

/** The text of a step. @param {Fields} step */
export const stepText = step => ["\n[[step]]", ...Object.entries(step).map(line), ""].join("\n")

/** The link to the picture of a step. Its covers are in a separate field. @param {string} query */
export const shownBy = query =>
  `?${query
    .split("&")
    .filter(part => !part.startsWith("cover="))
    .join("&")}`

/** @param {[string, Toml]} field */
const line = ([name, value]) => `${name} = ${written(value)}`

/** A value in TOML. Its strings are those of JSON, except for one character. @param {Toml} value @returns {string} */
function written(value) {
  if (Array.isArray(value)) {
    const items = value.map(written)
    return typeof value[0] === "object" ? `[\n${items.map(item => `  ${item},\n`).join("")}]` : `[${items.join(", ")}]`
  }
  if (typeof value === "object") return `{ ${Object.entries(value).map(line).join(", ")} }`
  if (typeof value === "string") return JSON.stringify(value).replaceAll("\u007f", "\\u007f")
  return String(value)
}

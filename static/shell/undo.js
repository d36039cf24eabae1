// Undo and redo: opens earlier states of a scene again.

import {button, element, setAttributes, svg} from "../core/dom.js"

const ARROWS = {past: "M9 14l-5-5 5-5M4 9h10a5 5 0 0 1 0 10h-4", future: "M15 14l5-5-5-5M20 9H10a5 5 0 0 0 0 10h4"}
const RESET = "M5 5v14M19 6l-9 6 9 6z"
const MOST = 200 // states kept per scene

/**
 * @typedef {"past" | "future"} Direction
 * @typedef {{past: page.State[], future: page.State[], now: page.State, undoGroup: string}} Story
 * @typedef {(open: () => page.Open | null, about: {way: Direction}) => void} SendBack
 */

export class Undo {
  /** @type {Map<string, Story>} the states of each scene */
  stories = new Map()

  /** @type {Story | undefined} the states of the current scene */
  story

  gesture = 0
  press = "" // of what, and which

  /** `reset` returns the scene to its opening state. @param {SendBack} send @param {() => void} reset */
  constructor(send, reset) {
    this.send = send
    this.buttons = {past: this.#button("Undo", "past"), future: this.#button("Redo", "future")}
    this.reset = drawn("Reset", "Reset the scene to its opening state", RESET, reset)
    this.element = element("div", {class: "undo"}, this.reset, this.buttons.past, this.buttons.future)
    addEventListener("pointerdown", () => this.#press("pointer"), true)
    addEventListener("keydown", event => this.#key(event), true)
  }

  #press(/** @type {"pointer" | "key"} */ kind) {
    this.gesture++
    this.press = `${kind} ${this.gesture}`
  }

  /** @param {string} name @param {Direction} way */
  #button(name, way) {
    const keys = way === "past" ? "Control+Z" : "Control+Shift+Z"
    const made = drawn(name, `${name} (${keys.replace("Control", "Ctrl")})`, ARROWS[way], () => this.go(way))
    setAttributes(made, {"aria-keyshortcuts": keys, disabled: ""})
    return made
  }

  /** A text field has its own undo. @param {KeyboardEvent} event */
  #key(event) {
    if (!event.repeat) this.#press("key")
    const isOurs = (event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === "z"
    if (!isOurs || undoesItself(event.target)) return
    event.preventDefault()
    this.go(event.shiftKey ? "future" : "past")
  }

  /** The undo group of a message: all messages of one press have the same group, and are undone together. */
  undoGroup(/** @type {page.BrowserMessage} */ {type}) {
    return type === "set" || type === "typed" ? `${type} ${this.gesture}` : ""
  }

  /** Opens the state before or after; covers and the compared picture stay. @param {Direction} way */
  go(way) {
    this.send(
      () => {
        const to = this.story?.[way].at(-1)
        if (!this.story || !to) return null
        const {parameters, frame, hidden} = to
        return {type: "open", state: {...this.story.now, parameters, frame, hidden}}
      },
      {way},
    )
  }

  /**
   * Records a state from the server. `asked`: data of the message that it answers.
   * @param {page.State} state @param {{way?: Direction, undoGroup?: string}} asked
   */
  record(state, {way, undoGroup = ""}) {
    const story = this.stories.get(state.scene) ?? {past: [], future: [], now: state, undoGroup: ""}
    this.stories.set(state.scene, story)
    this.story = story
    if (isSame(story.now, state)) {
      if (way) story[way].pop() // drop a state that the server refused, because it would refuse it again
    } else if (way) {
      story[way].pop()
      story[way === "past" ? "future" : "past"].push(story.now)
      story.undoGroup = ""
    } else advance(story, state, undoGroup)
    story.now = state
    this.reset.disabled = Boolean(state.step) || isSame(state, {...state, parameters: {}, frame: null, hidden: null})
    for (const one of /** @type {Direction[]} */ (["past", "future"])) this.buttons[one].disabled = !story[one].length
  }
}

/** A button with a drawing. @param {string} name @param {string} title @param {string} d @param {() => void} act */
function drawn(name, title, d, act) {
  const look = {viewBox: "0 0 24 24", width: "1.25rem", height: "1.25rem", "aria-hidden": "true"}
  const line = svg("path", {d, fill: "none", stroke: "currentColor", "stroke-width": 1.75})
  return button({"aria-label": name, title}, act, svg("svg", look, line))
}

/**
 * A gesture that ends where it began has changed nothing.
 * @param {Story} story @param {page.State} state @param {string} undoGroup
 */
function advance(story, state, undoGroup) {
  const {past} = story
  const goesOn = undoGroup && undoGroup === story.undoGroup
  story.future = []
  story.undoGroup = undoGroup
  if (!goesOn) past.push(story.now)
  else if (isSame(past[past.length - 1], state)) {
    past.pop()
    story.undoGroup = ""
  }
  if (past.length > MOST) past.shift()
}

/** @param {page.State} one @param {page.State} other */
const isSame = (one, other) => essence(one) === essence(other)

/** @param {page.State} state */
const essence = ({parameters, frame, hidden}) => JSON.stringify([parameters, frame, hidden])

/** @param {EventTarget | null} target */
const undoesItself = target =>
  target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type === "text")

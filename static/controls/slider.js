// A slider with a field: sends values, shows them before they are answered, and shows the answer.

import {element, reword} from "../core/dom.js"
import {fitting} from "./fitting.js"
import {Finger, keyed} from "./slider_moves.js"
import {steady} from "./drag.js"
import {BEGINS_NUMBER, tidy, withTrueMinus, withUnit} from "../core/numbers.js"
import {sliderPlace, sliderValue, stepped} from "./scales.js"

const STEPS = 1000 // the number of steps of a slider
const PATIENCE = 1000 // ms after a slider moved in which the answer to an older message does not move it back

/** @type {Record<string, 1 | -1>} */
const UPWARDS = {ArrowUp: 1, ArrowDown: -1}

const TYPED = {value: null, since: 0}

/** k_2: a serif italic letter with its subscript. @param {string} text */
export function symbol(text) {
  const [letter, index] = text.split("_")
  return element("span", {class: "v"}, letter, ...(index ? [element("sub", {}, index)] : []))
}

/** The element for an error message of a control; it takes no room while it is empty. @param {string} id */
export function problemElement(id) {
  return element("p", {class: "problem", role: "alert", id})
}

// A slider, with the field in which its value can be typed.
export class Slider {
  /** @type {page.Setting} the last setting from the server */
  state

  /** @type {{value: number | null, since: number} | null} sent but not answered; its value is null for a typed text */
  asked = null

  /** @type {Finger} */
  finger

  isPending = false // true while the value waits to be sent

  unsent = false // true if a text is typed and not sent yet
  isPressed = false // true while a pointer drags it

  /** @type {() => void} ends the fixing of the page's position during a press */
  free = () => {}

  typed = ""

  /** @param {page.SliderRow} spec @param {Send} send */
  constructor(spec, send) {
    this.spec = spec
    this.send = send
    this.soft = spec.soft
    const {name, unit} = spec
    const label = withIts(spec.label, unit)
    this.slider = element("input", {
      type: "range",
      name: `${name}-slider`,
      min: 0,
      max: 1,
      step: "any",
      "aria-label": label,
    })
    // The Tab key stops once per parameter, at the slider. There, Enter or a digit moves the focus to the field.
    this.field = element("input", {
      type: "text",
      name,
      id: `field-${name}`,
      tabindex: -1,
      inputmode: "decimal",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": label,
    })
    this.problem = problemElement(`problem-${name}`)
    this.unit = element("span", {class: "unit", "aria-hidden": "true"}, unit)
    this.label = element("label", {for: `field-${name}`, title: label}, symbol(spec.symbol))
    const number = element("span", {class: "num"}, this.field, this.unit)
    const words = spec.label.replace(/^[^,]*, /, "") // without the symbol, which the label shows
    const called = element("span", {class: "called", "aria-hidden": "true"}, words)
    this.element = element("div", {class: "control"}, this.label, this.slider, called, number, this.problem)
    this.size = 1 // the shown unit, divided by the quantity's own unit
    if (spec.marks.length) this.#mark(spec.marks)
    this.element.style.setProperty("--c", `var(--${spec.tint})`)
    this.#describe()
    this.#listenToSlider()
    this.#listenToField()
    this.write = fitting(this.field) // after the field's listener, which sends the full text
  }

  /** Named values below the slider, in an additional row. @param {page.NamedValue[]} marks */
  #mark(marks) {
    this.element.classList.add("marked")
    const rule = element(
      "div",
      {class: "marks", "aria-hidden": "true"},
      ...marks.map(({value, text}) => {
        const mark = element("span", {}, text)
        mark.style.setProperty("--at", String(sliderPlace(this.spec.scale, value, this.soft)))
        return mark
      }),
    )
    this.slider.after(rule)
  }

  #listenToSlider() {
    const {slider} = this
    this.finger = new Finger(slider)
    slider.addEventListener("input", () => {
      if (!this.finger.onlyTouched()) this.#slide(this.#atSlider())
    })
    slider.addEventListener("keydown", event => this.#stepSlider(event))
    slider.addEventListener("pointerdown", () => {
      this.isPressed = true
      this.free = steady(slider)
    })
    for (const end of ["pointerup", "pointercancel", "change", "blur"]) {
      slider.addEventListener(end, () => {
        this.isPressed = false
        this.free()
        if (this.state && !this.asked) this.#place(this.state.value)
      })
    }
  }

  #listenToField() {
    const {field} = this
    field.addEventListener("input", () => {
      this.unsent = true
    })
    field.addEventListener("change", () => this.#commit())
    field.addEventListener("blur", () => this.#commit())
    field.addEventListener("keydown", event => {
      const direction = UPWARDS[event.key]
      if (event.key === "Enter") this.#commit()
      else if (event.key === "Escape") this.#giveUp()
      else if (direction) {
        event.preventDefault()
        this.#stepField(direction)
      }
    })
  }

  /** @param {number} value */
  #slide(value) {
    this.typed = this.spec.scale === "count" ? String(value) : withTrueMinus(tidy(this.#shown(value)))
    this.write(this.typed)
    this.unsent = false
    this.#fill(value)
    this.asked = {value, since: performance.now()}
    this.send({type: "set", values: {[this.spec.name]: value}})
  }

  /** @param {KeyboardEvent} event */
  #stepSlider(event) {
    const {key, ctrlKey, metaKey, altKey} = event
    if (ctrlKey || metaKey || altKey) return
    if (key === "Enter" || BEGINS_NUMBER.test(key)) return this.field.select()
    const soft = this.#shownSoft()
    const value = keyed(key, this.spec.scale, this.#shown(this.#atSlider()), soft, direction => this.#next(direction))
    if (value === null) return
    event.preventDefault()
    this.slider.value = String(sliderPlace(this.spec.scale, value, soft))
    this.#slide(this.#own(value))
  }

  /** The next different value of the slider in the shown unit. @param {1 | -1} direction */
  #next(direction) {
    const start = this.#atSlider()
    const place = Number(this.slider.value)
    for (let step = 1; step <= STEPS && this.#atSlider() === start; step++) {
      this.slider.value = String(place + (direction * step) / STEPS)
    }
    return this.#shown(this.#atSlider())
  }

  /** @param {1 | -1} direction */
  #stepField(direction) {
    const text = stepped(this.field.value, direction)
    if (text === null) return
    this.field.value = withTrueMinus(text)
    this.unsent = true
    this.#commit()
  }

  #commit() {
    if (!this.unsent) return
    this.unsent = false
    this.typed = this.field.value
    this.asked = TYPED
    this.send({type: "typed", name: this.spec.name, text: this.typed})
  }

  #giveUp() {
    this.unsent = false
    this.asked = null
    this.#accept()
  }

  // Another state resets the field: typed and rejected texts disappear.
  release() {
    this.unsent = false
    this.asked = TYPED
  }

  /** Shows a value that waits for the server; undefined if none waits. @param {page.Value | undefined} value */
  wait(value) {
    this.isPending = value !== undefined
    this.element.classList.toggle("waits", this.isPending)
    if (typeof value !== "number" || value === this.asked?.value) return
    this.asked = {value, since: performance.now()}
    this.write(withTrueMinus(tidy(this.#shown(value))))
    this.#place(value)
  }

  /** @param {page.Setting} state @param {string | undefined} error */
  update(state, error) {
    if (this.isPending) {
      this.state = state
      return
    }
    const moved = state.value !== this.state?.value
    this.state = state
    if (state.soft) this.soft = state.soft
    this.#measure(state)
    if (error) return this.#refuse(error)
    if (this.problem.textContent && !moved && !this.asked) return // this answer belongs to another control
    const {value, since} = this.asked ?? TYPED
    if (value !== null && value !== state.value && performance.now() - since < PATIENCE) return
    this.asked = null
    this.#accept()
  }

  /** @param {page.Setting} state */
  #measure({unit: other, size}) {
    const unit = other ?? this.spec.unit
    this.size = size
    if (!reword(this.unit, unit)) return
    const label = withIts(this.spec.label, unit)
    for (const part of [this.slider, this.field]) part.setAttribute("aria-label", label)
    this.label.title = label
  }

  #accept() {
    this.#showProblem("")
    if (!this.unsent) this.write(this.state.text)
    if (!this.isPressed) this.#place(this.state.value)
  }

  /** @param {string} error */
  #refuse(error) {
    this.asked = null
    this.#showProblem(error)
    if (!this.unsent) this.field.value = this.typed
    if (!this.isPressed) this.#place(this.state.value)
  }

  /** @param {string} error */
  #showProblem(error) {
    reword(this.problem, error)
    this.element.classList.toggle("bad", Boolean(error))
    if (error) this.field.setAttribute("aria-invalid", "true")
    else this.field.removeAttribute("aria-invalid")
    this.#describe()
  }

  #describe() {
    const help = `help-${this.spec.name}`
    this.field.setAttribute("aria-describedby", this.problem.textContent ? `${this.problem.id} ${help}` : help)
    this.slider.setAttribute("aria-describedby", help)
  }

  // A slider has round numbers in the shown unit.
  #atSlider() {
    return this.#own(sliderValue(this.spec.scale, Number(this.slider.value), this.#shownSoft()))
  }

  /** @returns {[number, number]} the ends of the slider in the unit shown */
  #shownSoft() {
    const [low, high] = this.soft
    return [low / this.size, high / this.size]
  }

  /** Converts a number from the shown unit to the quantity's own unit. @param {number} number */
  #own(number) {
    return this.size === 1 ? number : Number((number * this.size).toPrecision(15))
  }

  /** @param {number} value */
  #shown(value) {
    return this.size === 1 ? value : Number((value / this.size).toPrecision(12))
  }

  /** Moves the slider, unless its position already means this value. @param {page.Setting["value"]} value */
  #place(value) {
    if (typeof value !== "number") return
    if (this.#atSlider() !== value) this.slider.value = String(sliderPlace(this.spec.scale, value, this.soft))
    this.#fill(value)
  }

  /** @param {number} value */
  #fill(value) {
    this.slider.style.setProperty("--at", this.slider.value)
    const number = withTrueMinus(tidy(this.#shown(value)))
    this.slider.setAttribute("aria-valuetext", withUnit(number, this.unit.textContent ?? ""))
  }
}

/** The name of a slider with its unit. @param {string} label @param {string} unit */
const withIts = (label, unit) => [label, unit].filter(Boolean).join(", ")

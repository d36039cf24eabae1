// A slider with a typed field: where a value stands on it, what is shown while it is dragged, and what becomes of the answer.

import {element} from "./dom.js"

const STEPS = 1000 // of a slider moved by arrow keys
const PATIENCE = 1000 // ms for which the answer to an older message is not shown over a newer slider position

// Where a value stands on its slider, from 0 to 1, and back.
const linear = {
  value: (place, low, high) => low + (high - low) * place,
  place: (value, low, high) => (value - low) / (high - low),
  finest: (low, high) => (high - low) / 400,
}
const SCALES = {
  linear,
  count: {...linear, finest: () => 1},
  log: {
    value: (place, low, high) => low * (high / low) ** place,
    place: (value, low, high) => Math.log(value / low) / Math.log(high / low),
    finest: () => 0,
  },
  near0: {
    value: (place, low, high) => high * place ** 3,
    place: (value, low, high) => Math.cbrt(value / high),
    finest: (low, high) => high / 10000,
  },
}

export function sliderValue(scale, place, [low, high]) {
  const {value, finest} = SCALES[scale]
  const raw = value(place, low, high)
  if (!finest(low, high)) return Number(raw.toPrecision(3))
  const unit = 10 ** Math.floor(Math.log10(finest(low, high)))
  return Number((Math.round(raw / unit) * unit).toPrecision(3)) + 0
}

export function sliderPlace(scale, value, [low, high]) {
  const place = SCALES[scale].place(Math.min(Math.max(value, low), high), low, high)
  return Math.min(Math.max(place, 0), 1)
}

// As the server writes a field; it puts its own text there with the answer.
function fieldText(value) {
  if (value === 0) return "0.00"
  const size = Math.abs(value)
  return size >= 1e-3 && size < 1000 ? value.toPrecision(3) : String(value).replace("e+", "e")
}

// The number in `text` one unit of its last digit further up or down; null where it is no plain number.
export function stepped(text, direction) {
  const match = text.trim().replace("−", "-").replace(",", ".").match(/^([+-]?)(\d+)(?:\.(\d*))?(e[+-]?\d+)?$/i)
  if (!match) return null
  const [, sign, whole, fraction = "", exponent = ""] = match
  const units = BigInt(`${sign === "-" ? "-" : ""}${whole}${fraction}`) + BigInt(direction)
  const digits = String(units < 0n ? -units : units).padStart(fraction.length + 1, "0")
  const point = digits.length - fraction.length
  const shown = fraction ? `${digits.slice(0, point)}.${digits.slice(point)}` : digits
  return (units < 0n ? "-" : "") + shown + exponent
}

// k_2: a serif italic letter with its subscript.
export function symbol(text) {
  const [letter, index] = text.split("_")
  return element("span", {class: "v"}, letter, ...(index ? [element("sub", {}, index)] : []))
}

// A message that the row of its control makes room for; without text it takes none.
export function problemElement(id) {
  return element("p", {class: "problem", role: "alert", id})
}

// One slider with its typed field: `spec` is what row() of components/controls.py says of a quantity, `send` takes the
// messages, `speak` is called with the spec when the visitor turns to it.
export class Slider {
  constructor(spec, send, speak) {
    Object.assign(this, {spec, send, soft: spec.soft, state: null, asked: null, unsent: false, held: false, typed: ""})
    const {name, label, unit} = spec
    this.slider = element("input", {type: "range", name: `${name}-slider`, min: 0, max: 1, step: "any", "aria-label": label})
    this.field = element("input", {
      type: "text", name, id: `field-${name}`, inputmode: "decimal", autocomplete: "off", spellcheck: "false", "aria-label": label,
    })
    this.problem = problemElement(`problem-${name}`)
    this.element = element("div", {class: "control"},
      element("label", {for: `field-${name}`, title: label}, symbol(spec.symbol)),
      this.slider,
      element("span", {class: "num"}, this.field, element("span", {class: "unit", "aria-hidden": "true"}, unit)),
      this.problem)
    this.unit = this.element.querySelector(".unit")
    this.size = 1 // of the unit shown, in the quantity's own
    if (spec.marks) this.#mark(spec.marks)
    this.element.style.setProperty("--c", `var(--${spec.tint})`)
    this.element.addEventListener("focusin", () => speak(spec))
    this.#describe()
    this.#listenToSlider()
    this.#listenToField()
  }

  // Named values under the slider, which then has a row of its own.
  #mark(marks) {
    this.element.classList.add("marked")
    const rule = element("div", {class: "marks", "aria-hidden": "true"}, ...marks.map(({value, text}) => {
      const mark = element("span", {}, text)
      mark.style.setProperty("--at", sliderPlace(this.spec.scale, value, this.soft))
      return mark
    }))
    this.slider.after(rule)
  }

  #listenToSlider() {
    const {slider} = this
    slider.addEventListener("input", () => this.#slide())
    slider.addEventListener("keydown", event => this.#stepSlider(event))
    slider.addEventListener("pointerdown", () => { this.held = true })
    for (const end of ["pointerup", "pointercancel", "change", "blur"]) {
      slider.addEventListener(end, () => {
        if (this.held) this.held = false
        if (this.state && !this.asked) this.#place(this.state.value)
      })
    }
  }

  #listenToField() {
    const {field} = this
    field.addEventListener("input", () => { this.unsent = true })
    field.addEventListener("change", () => this.#commit())
    field.addEventListener("blur", () => this.#commit())
    field.addEventListener("keydown", event => {
      const direction = {ArrowUp: 1, ArrowDown: -1}[event.key]
      if (event.key === "Enter") this.#commit()
      else if (event.key === "Escape") this.#giveUp()
      else if (direction) {
        event.preventDefault()
        this.#stepField(direction)
      }
    })
  }

  #slide() {
    const value = this.#atSlider()
    this.typed = this.field.value = this.spec.scale === "count" ? String(value) : fieldText(this.#shown(value))
    this.unsent = false
    this.#fill(value)
    this.asked = {value, since: performance.now()}
    this.send({type: "set", values: {[this.spec.name]: value}})
  }

  // An arrow key goes to the next value, however many places that takes where the scale is fine.
  #stepSlider(event) {
    const direction = {ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1}[event.key]
    if (!direction) return
    event.preventDefault()
    const start = this.#atSlider()
    const place = Number(this.slider.value)
    for (let step = 1; step <= STEPS; step++) {
      this.slider.value = place + direction * step / STEPS
      if (this.#atSlider() !== start) return this.#slide()
    }
  }

  #stepField(direction) {
    const text = stepped(this.field.value, direction)
    if (text === null) return
    this.field.value = text
    this.unsent = true
    this.#commit()
  }

  #commit() {
    if (!this.unsent) return
    this.unsent = false
    this.typed = this.field.value
    this.asked = {}
    this.send({type: "typed", name: this.spec.name, text: this.typed})
  }

  #giveUp() {
    this.unsent = false
    this.asked = null
    this.#accept()
  }

  // A preset speaks for every control: what was typed or refused before it is over.
  release() {
    this.unsent = false
    this.asked = {}
  }

  update(state, error) {
    const moved = state.value !== this.state?.value
    this.state = state
    if (state.soft) this.soft = state.soft
    this.#measure(state)
    if (error) return this.#refuse(error)
    if (this.problem.textContent && !moved && !this.asked) return // the answer to another control
    const {value, since} = this.asked ?? {}
    if (value !== undefined && value !== state.value && performance.now() - since < PATIENCE) return
    this.asked = null
    this.#accept()
  }

  #measure({unit = this.spec.unit, size = 1}) {
    this.size = size
    if (this.unit.textContent === unit) return
    this.unit.textContent = unit
    const label = [this.spec.label.replace(`, ${this.spec.unit}`, ""), unit].filter(Boolean).join(", ")
    for (const part of [this.slider, this.field]) part.setAttribute("aria-label", label)
    this.element.querySelector("label").title = label
  }

  #accept() {
    this.#say("")
    if (!this.unsent) this.field.value = this.state.text
    if (!this.held) this.#place(this.state.value)
  }

  #refuse(error) {
    this.asked = null
    this.#say(error)
    if (!this.unsent) this.field.value = this.typed
    if (!this.held) this.#place(this.state.value)
  }

  #say(error) {
    if (this.problem.textContent !== error) this.problem.textContent = error
    this.element.classList.toggle("bad", Boolean(error))
    if (error) this.field.setAttribute("aria-invalid", "true")
    else this.field.removeAttribute("aria-invalid")
    this.#describe()
  }

  #describe() {
    const bad = this.problem.textContent
    this.field.setAttribute("aria-describedby", bad ? `${this.problem.id} controls-says` : "controls-says")
    this.slider.setAttribute("aria-describedby", "controls-says")
  }

  // A slider goes in round numbers of the unit shown.
  #atSlider() {
    const {size} = this, number = sliderValue(this.spec.scale, Number(this.slider.value), this.soft.map(end => end / size))
    return size === 1 ? number : Number((number * size).toPrecision(15))
  }

  #shown(value) {
    return this.size === 1 ? value : Number((value / this.size).toPrecision(12))
  }

  // A slider that already stands for the value stays where the hand has left it.
  #place(value) {
    if (value === null) return
    if (this.#atSlider() !== value) this.slider.value = sliderPlace(this.spec.scale, value, this.soft)
    this.#fill(value)
  }

  #fill(value) {
    this.slider.style.setProperty("--at", this.slider.value)
    this.slider.setAttribute("aria-valuetext", `${fieldText(this.#shown(value)).replace("-", "−")} ${this.unit.textContent}`.trim())
  }
}

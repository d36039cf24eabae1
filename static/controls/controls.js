// The control panel: presets, sliders with typed fields, and choices. It shows the state that the server sends and
// sends what the visitor does; it never decides what is possible.

import {button, chip, element, intoView, marked, svg} from "../core/dom.js"
import {Slider, problemElement, symbol} from "./slider.js"
import {viewOf} from "../scene/views.js"

const TYPING = "Type a digit to open the field; Enter sets the number, Escape cancels."

/**
 * The function that draws the small pictures of a choice; only some scenes have one, and fetch it.
 * @typedef {typeof import("../scene/picker.js").pictured} Pictured
 * @typedef {(sets: Record<string, page.Value>) => void} Take applies a preset
 * @typedef {Pick<Drawn, "settings" | "errors" | "preset" | "here">} PanelAnswer
 * @typedef {PanelAnswer & {view: Pick<page.PagePicture, "forms">}} PanelState
 */

/** A small drawing of a preset, if it has one. @param {string} d */
function outline(d) {
  return d ? svg("svg", {viewBox: "0 0 128 46", "aria-hidden": "true"}, svg("path", {class: "ln m1", d})) : ""
}

class Presets {
  /** @type {page.PresetButton | undefined} the preset that was pressed last */
  taken

  /** @param {page.Panel} panel @param {Take} take */
  constructor({start, folded, presets}, take) {
    this.presets = presets
    this.buttons = presets.map(preset =>
      presetButton(preset, () => {
        this.taken = preset
        take(preset.sets)
      }),
    )
    const look = presets.some(preset => preset.outline) ? "tiles pair" : "chips"
    const chips = element("div", {class: look, role: "group", "aria-label": start}, ...this.buttons)
    this.title = folded
      ? element("details", {class: "fold"}, element("summary", {}, start), chips)
      : element("h2", {}, start)
    this.element = element("section", {class: "group"}, this.title, ...(folded ? [] : [chips]))
  }

  /** Shows what to watch in the current preset if the visitor has pressed its button. @param {string | null} preset */
  watch(preset) {
    return (this.taken?.name === preset && this.taken.watch) || ""
  }

  /** Marks a preset as chosen, but not yet sent, if all its values wait to be sent. @param {Waits} waiting */
  wait(waiting) {
    const late = this.presets.map(({sets}) => isWithin(Object.entries(sets), waiting))
    for (const [i, one] of this.buttons.entries()) {
      one.classList.toggle("waits", late[i])
      if (late.includes(true)) one.setAttribute("aria-pressed", String(late[i]))
    }
  }

  /** @param {string | null} preset */
  update(preset) {
    for (const one of this.buttons) one.setAttribute("aria-pressed", String(one.dataset.preset === preset))
  }
}

/** @param {[string, page.Value][]} values @param {Waits} waiting */
const isWithin = (values, waiting) =>
  values.length > 0 && values.every(([name, value]) => JSON.stringify(waiting.get(name)) === JSON.stringify(value))

/** @param {page.PresetButton} preset @param {() => void} take */
function presetButton({name, label, outline: drawing}, take) {
  const look = {class: drawing ? "tile" : "chip", "aria-pressed": "false", "data-preset": name}
  return button(look, take, outline(drawing), element("span", {}, label))
}

/**
 * Joined buttons for a parameter with a few values; tiles if the options have pictures.
 * @param {HTMLElement} host @param {Pick<page.ChoiceRow, "name" | "label" | "options">} spec @param {Send} send
 * @param {ReturnType<Pictured>["draw"]} [draw]
 */
export function buildChoice(host, spec, send, draw) {
  const buttons = spec.options.map(option => {
    const look = {class: draw && "tile", "aria-pressed": "false", "data-option": option.value}
    const act = () => send({type: "choose", name: spec.name, value: option.value})
    return button(look, act, ...(draw?.(option) ?? [option.label]))
  })
  const look = {class: draw ? "tiles" : "seg", role: "group", "aria-label": spec.label, "data-name": spec.name}
  host.append(element("div", look, ...buttons))
  return {
    /** @param {Record<string, page.Setting>} settings */
    update(settings) {
      const now = settings[spec.name].value
      for (const one of buttons) {
        const isChosen = one.dataset.option === now
        if (draw && isChosen && one.getAttribute("aria-pressed") !== "true") intoView(one)
        one.setAttribute("aria-pressed", String(isChosen))
      }
    },
  }
}

/** Rows of cells with live numbers. @param {page.Html[][]} rows */
function factTable(rows) {
  const lines = rows.map(row => {
    const cells = row.map(html => marked("td", {}, html))
    return element("tr", {class: `cells-${row.length}`}, ...cells)
  })
  return element("table", {class: "facts-table"}, ...lines)
}

export class Controls {
  /** @type {Map<string, Slider>} */
  sliders = new Map()

  /** @type {ReturnType<typeof buildChoice>[]} */
  choices = []

  /**
   * @type {Map<string, {row: HTMLElement, place: Comment, form: string}>} the rows, each with its position and the form
   * in which it is shown
   */
  rows = new Map()

  /** @type {{rows: HTMLDetailsElement, names: string[], wanted: boolean}[]} */
  folds = []

  /** @type {import("../scene/stage.js").Stage[]} */
  stages = []

  /** @type {HTMLElement[]} */
  actionProblems = []

  /** @type {string | undefined} the view whose controls are first */
  view

  /** @type {boolean[]} for each group: true if all of its controls are among the view's key controls */
  bare = []

  /** @type {{span: HTMLElement, hint: string, names: string[]}[]} hints next to the titles of groups */
  hints = []

  /**
   * @param {HTMLElement} host @param {page.SceneSheet} sheet @param {Send} send @param {Take} take
   * @param {Pictured} [pictured]
   */
  constructor(host, {panel: spec, views}, send, take, pictured) {
    this.host = host
    this.spec = spec
    this.views = views
    this.picturesTitle = element("h2")
    this.pictures = element("section", {class: "group keys-of-view pictures", hidden: ""}, this.picturesTitle)
    this.keys = element("section", {class: "group keys-of-view", hidden: ""}, element("h2", {}, "Move this"))
    this.send = send
    this.pictured = pictured
    // Show help only for the focused control.
    this.says = element("p", {class: "says", id: "controls-says"})
    this.sections = spec.groups.map(group => this.#section(group))
    this.presets = new Presets(spec, take)
    host.classList.add("controls")
    if (views.length) host.append(this.pictures, this.keys)
    if (spec.presets.length) host.append(this.presets.element)
    host.append(...this.sections, this.says)
  }

  /** Resets every control for another state: typed and rejected texts disappear. */
  release() {
    for (const slider of this.sliders.values()) slider.release()
  }

  /** @param {page.GroupSection} group */
  #section(group) {
    const look = {class: `group ${group.dense ? "dense" : ""}`, "aria-label": group.title || undefined}
    const section = element("section", look)
    if (group.title) section.append(element("h2", {}, group.title, this.#hint(group.hint)))
    else section.classList.add("on")
    const rows = group.folded ? this.#fold(group) : section
    this.hints[this.hints.length - 1]?.names.push(...group.rows.map(row => row.name))
    for (const row of group.rows) this.#placed(rows, row, group.form)
    const actions = group.title ? section : rows
    if (group.actions.length) actions.append(this.#actions(group.actions))
    if (group.facts.length) section.append(factTable(group.facts))
    if (rows !== section) section.append(rows)
    return section
  }

  /** @param {string} hint */
  #hint(hint) {
    const span = element("span", {}, hint)
    this.hints.push({span, hint, names: []})
    return span
  }

  /** Shows values that the server has not answered yet as the visitor set them. @param {Waits} waiting */
  wait(waiting) {
    this.presets.wait(waiting)
    for (const [name, slider] of this.sliders) slider.wait(waiting.get(name))
    for (const {span, hint, names} of this.hints) {
      const count = names.filter(name => waiting.has(name)).length
      span.textContent = count ? `${count} value${count > 1 ? "s wait" : " waits"}` : hint
    }
  }

  /** @param {page.GroupSection} group */
  #fold(group) {
    const summary = group.title
      ? element("summary", {}, "Set each value")
      : element("summary", {}, `${group.hint} `, this.#hint(""))
    const rows = element("details", {class: "fold"}, summary)
    this.folds.push({rows, names: group.rows.map(row => row.name), wanted: false})
    return rows
  }

  /** @param {HTMLElement} host @param {page.ControlRow} row @param {string} form */
  #placed(host, row, form) {
    const place = document.createComment(row.name)
    host.append(place)
    this.#row(host, row)
    this.rows.set(row.name, {row: /** @type {HTMLElement} */ (host.lastElementChild), place, form})
  }

  /** Puts the controls of the view's task first; the others stay in their groups. @param {string} view */
  #arrange(view) {
    if (this.view === view) return
    this.view = view
    for (const {row, place} of this.rows.values()) {
      place.after(row)
      row.hidden = false
    }
    const keys = this.views.find(({word}) => word === view)?.keys ?? []
    for (const name of keys) {
      const {row} = /** @type {{row: HTMLElement}} */ (this.rows.get(name))
      const isPictures = row.classList.contains("tiles")
      if (isPictures) this.picturesTitle.textContent = row.getAttribute("aria-label")
      ;(isPictures ? this.pictures : this.keys).append(row)
    }
    this.bare = this.spec.groups.map(
      ({rows, actions, facts}) => rows.every(({name}) => keys.includes(name)) && !actions.length && !facts.length,
    )
  }

  /** @param {HTMLElement} host @param {page.ControlRow} row */
  #row(host, row) {
    if (row.kind === "slider") return this.#slider(host, row)
    if (!isPicker(row)) return this.choices.push(buildChoice(host, row, this.send))
    const {draw, stages} = /** @type {Pictured} */ (this.pictured)(row)
    this.choices.push(buildChoice(host, row, this.send, draw))
    this.stages.push(...stages)
  }

  /** @param {HTMLElement} host @param {page.SliderRow} row */
  #slider(host, row) {
    const slider = new Slider(row, this.send)
    this.sliders.set(row.name, slider)
    this.help(slider.element, row.name)
    const says = `${row.symbol.replace("_", "")} ${row.says} ${TYPING}`
    slider.element.append(element("span", {class: "heard", id: `help-${row.name}`}, says))
    host.append(slider.element)
  }

  /**
   * Shows the help of this parameter while the focus is in `part`: its slider, or a handle that sets it.
   * @param {HTMLElement} part @param {string} name
   */
  help(part, name) {
    part.addEventListener("focusin", () => this.#speak(name))
    part.addEventListener("focusout", () => this.says.replaceChildren())
  }

  /** @param {string} name */
  #speak(name) {
    const spec = this.sliders.get(name)?.spec
    if (!spec) return
    const {symbol: letter, says} = spec
    const [first, ...rest] = says.split(/(?<=\.) /)
    this.says.replaceChildren(symbol(letter), " ", element("b", {}, first), rest.length ? ` ${rest.join(" ")}` : "")
  }

  /** Buttons that set several parameters at once, to values from the server. @param {page.ActionButton[]} actions */
  #actions(actions) {
    const buttons = actions.map(({name, label, place}) =>
      chip(label, () => this.send({type: "act", name}), {"data-place": place ? name : undefined}),
    )
    const problem = problemElement(`problem-${actions[0].name}`)
    this.actionProblems.push(problem)
    return element("div", {class: "chips"}, ...buttons, problem)
  }

  /** @param {PanelState} state the state from the server */
  update({settings, errors, preset, here, view: {forms}}) {
    this.#arrange(viewOf(settings))
    for (const [i, {form}] of this.spec.groups.entries())
      this.sections[i].hidden = this.bare[i] || (Boolean(form) && !forms[form])
    for (const section of [this.pictures, this.keys]) {
      const rows = [...this.rows.values()].filter(({row}) => row.parentElement === section)
      for (const {row, form} of rows) row.hidden = Boolean(form) && !forms[form]
      section.hidden = rows.every(({row}) => row.hidden)
    }
    for (const [name, slider] of this.sliders) slider.update(settings[name], errors[name])
    for (const choice of this.choices) choice.update(settings)
    this.presets.update(preset)
    for (const problem of this.actionProblems) problem.textContent = errors.action ?? ""
    for (const one of this.host.querySelectorAll("[data-place]")) {
      one.setAttribute("aria-pressed", String(here.includes(one.getAttribute("data-place") ?? "")))
    }
    for (const fold of this.folds) {
      const wanted = fold.names.some(name => settings[name].changed)
      // A folded group that the visitor has closed opens again only for a new reason.
      if (wanted && !fold.wanted) fold.rows.open = true
      fold.wanted = wanted
    }
  }
}

/** True if a row is a choice of small pictures. @param {page.ControlRow} row */
export const isPicker = row => row.kind === "choice" && Object.keys(row.pictures).length > 0

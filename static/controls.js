// The control panel: presets, sliders with typed fields, and choices. It shows the state that the server sends and
// sends what the visitor does; it never decides what is possible.

import {element, svg} from "./dom.js"
import {Slider, problemElement, symbol} from "./slider.js"

// A small drawing, if there is one.
function outline(d) {
  return d ? svg("svg", {viewBox: "0 0 128 46", "aria-hidden": "true"}, svg("path", {class: "ln m1", d})) : ""
}

class Presets {
  constructor({start, presets, drawings = {}}, choose) {
    this.buttons = presets.map(label => {
      const button = element("button", {type: "button", class: drawings[label] ? "tile" : "chip", "aria-pressed": "false"}, outline(drawings[label]), element("span", {}, label))
      button.addEventListener("click", () => choose(label))
      return button
    })
    this.problem = problemElement("problem-preset")
    const chips = element("div", {class: Object.keys(drawings).length ? "tiles pair" : "chips", role: "group", "aria-label": start}, ...this.buttons)
    this.element = element("section", {class: "group"}, element("h2", {}, start), chips, this.problem)
  }

  update(preset, error = "") {
    for (const button of this.buttons) button.setAttribute("aria-pressed", String(button.textContent === preset))
    if (this.problem.textContent !== error) this.problem.textContent = error
  }
}

// Joined buttons for a parameter with a few values: {name, label, options: [{value, label}]}.
export function buildChoice(host, spec, send) {
  const buttons = spec.options.map(({value, label}) => {
    const button = element("button", {type: "button", "aria-pressed": "false", "data-option": value}, label)
    button.addEventListener("click", () => send({type: "choose", name: spec.name, value}))
    return button
  })
  host.append(element("div", {class: "seg", role: "group", "aria-label": spec.label}, ...buttons))
  return {
    update(params) {
      const now = String(params[spec.name]?.value)
      for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.option === now))
    },
  }
}

// Rows of cells with live numbers; the last but one of four and the last of two are numbers.
function factTable(rows) {
  const cells = row => row.map(html => Object.assign(element("td", {}), {innerHTML: html}))
  return element("table", {class: "facts-table"}, ...rows.map(row => element("tr", {class: `cells-${row.length}`}, ...cells(row))))
}

// Buttons that have the server set several parameters at once.
function actionButtons(actions, send, problems) {
  const buttons = actions.map(({name, label, place}) => {
    const button = element("button", {type: "button", class: "chip", "data-place": place ? name : undefined}, label)
    button.addEventListener("click", () => send({type: "act", name}))
    return button
  })
  problems.push(problemElement(`problem-${actions[0].name}`))
  return element("div", {class: "chips"}, ...buttons, problems[problems.length - 1])
}

// Builds the panel in `host`. `send` takes the messages of components/controls.py; `update` takes what that module
// calls the state of the parameters, the errors of the last message by parameter, the label of the preset in force, and
// the places where the scene is.
export function buildControls(host, spec, send, buildPicker) {
  const says = element("p", {class: "says", id: "controls-says"})
  let spoken = null
  const speak = spec => {
    const {symbol: letter, says: sentence} = spec
    spoken = spec
    const [first, ...rest] = sentence.split(/(?<=\.) /)
    says.replaceChildren(symbol(letter), " ", element("b", {}, first), rest.length ? ` ${rest.join(" ")}` : "")
  }
  const controls = new Map()
  const choices = []
  const folds = []
  const stages = []
  const actionProblems = []
  const sections = spec.groups.map(group => {
    const section = element("section", {class: `group ${group.dense ? "dense" : ""}`, "aria-label": group.title || undefined})
    if (group.title) section.append(element("h2", {}, group.title, element("span", {}, group.hint)))
    else section.classList.add("on")
    const rows = group.folded ? element("details", {class: "fold"}, element("summary", {}, "Set each value")) : section
    if (group.folded) folds.push({rows, names: group.rows.map(row => row.name)})
    for (const row of group.rows) {
      if (row.options && group.pictures?.[row.options[0].value]) {
        const picker = buildPicker(rows, row, group.pictures, send)
        choices.push(picker)
        stages.push(...picker.stages)
      } else if (row.options) choices.push(buildChoice(rows, row, send))
      else {
        const control = new Slider(row, send, speak)
        controls.set(row.name, control)
        rows.append(control.element)
      }
    }
    if (group.actions.length) section.append(actionButtons(group.actions, send, actionProblems))
    if (group.facts?.length) section.append(factTable(group.facts))
    if (rows !== section) section.append(rows)
    return section
  })
  const presets = new Presets(spec, label => {
    for (const control of controls.values()) control.release()
    send({type: "preset", label})
  })
  host.classList.add("controls")
  if (spec.presets.length) host.append(presets.element)
  host.append(...sections, says)
  const first = controls.values().next().value
  if (first) speak(first.spec)
  // What is said belongs to a control that is seen.
  const showGroups = forms => {
    spec.groups.forEach((group, i) => { sections[i].hidden = Boolean(group.show) && !forms[group.show] })
    const seen = spec.groups.filter((group, i) => !sections[i].hidden).flatMap(group => group.rows).filter(row => controls.has(row.name))
    if (seen.length && !seen.some(row => row.name === spoken?.name)) speak(seen[0])
  }
  return {
    sections,
    stages,
    update({params, errors = {}, preset = null, forms = {}, here = []}) {
      showGroups(forms)
      for (const [name, control] of controls) if (params[name]) control.update(params[name], errors[name])
      for (const choice of choices) choice.update(params)
      presets.update(preset, errors.preset)
      for (const problem of actionProblems) problem.textContent = errors.action ?? ""
      for (const button of host.querySelectorAll("[data-place]")) button.setAttribute("aria-pressed", String(here.includes(button.dataset.place)))
      for (const {rows, names} of folds) if (names.some(name => params[name]?.changed)) rows.open = true
    },
  }
}

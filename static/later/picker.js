// A choice whose options are small pictures, drawn and moved as the stage is.

import {element} from "../dom.js"
import {Stage} from "../stage.js"

/**
 * @param {HTMLElement} host @param {page.ChoiceRow} spec @param {(message: page.Said) => void} send
 */
export function buildPicker(host, spec, send) {
  /** @type {Stage[]} */
  const stages = []
  const buttons = spec.options.map(({value, label}) => {
    const picture = element("div", {class: "picture"})
    stages.push(new Stage({shapes: spec.pictures[value], label: ""}, picture))
    const button = element(
      "button",
      {type: "button", class: "tile", "aria-pressed": "false", "data-option": value},
      picture,
      element("span", {}, label),
    )
    button.addEventListener("click", () => send({type: "choose", name: spec.name, value}))
    return button
  })
  host.append(
    element("div", {class: "tiles", role: "group", "aria-label": spec.label, "data-name": spec.name}, ...buttons),
  )
  return {
    stages,
    /** @param {Record<string, page.Setting>} settings */
    update(settings) {
      const now = settings[spec.name].value
      for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.option === now))
    },
  }
}

// A choice whose options are small pictures, drawn and moved as the stage is.

import {button, element} from "../dom.js"
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
    const look = {class: "tile", "aria-pressed": "false", "data-option": value}
    const act = () => send({type: "choose", name: spec.name, value})
    return button(look, act, picture, element("span", {}, label))
  })
  host.append(
    element("div", {class: "tiles", role: "group", "aria-label": spec.label, "data-name": spec.name}, ...buttons),
  )
  return {
    stages,
    /** @param {Record<string, page.Setting>} settings */
    update(settings) {
      const now = settings[spec.name].value
      for (const one of buttons) one.setAttribute("aria-pressed", String(one.dataset.option === now))
    },
  }
}

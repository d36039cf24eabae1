// A choice whose options are small pictures, drawn and moved as the stage is.

import {element} from "../dom.js"
import {Stage} from "../stage.js"

// Shapes by value: {value: [shape, ...]}; the rest of `spec` is a choice as buildChoice takes it.
export function buildPicker(host, spec, pictures, send) {
  const stages = []
  const buttons = spec.options.map(({value, label}) => {
    const picture = element("div", {class: "picture"})
    stages.push(new Stage({shapes: pictures[value]}, picture))
    const button = element("button", {type: "button", class: "tile", "aria-pressed": "false", "data-option": value}, picture, element("span", {}, label))
    button.addEventListener("click", () => send({type: "choose", name: spec.name, value}))
    return button
  })
  host.append(element("div", {class: "tiles", role: "group", "aria-label": spec.label}, ...buttons))
  return {
    stages,
    update(params) {
      const now = String(params[spec.name]?.value)
      for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.option === now))
    },
  }
}

// The small pictures of a choice, drawn and moved as the stage is.

import {element} from "../core/dom.js"
import {Stage} from "./stage.js"

/** Draws the picture on the button of an option; returns the stages drawn so far. @param {page.ChoiceRow} row */
export function pictured({pictures}) {
  /** @type {Stage[]} */
  const stages = []
  /** @param {page.ChoiceRow["options"][0]} option */
  const draw = ({value, label}) => {
    const picture = element("div", {class: "picture"})
    const stage = new Stage({shapes: pictures[value], label: ""}, picture)
    stage.skipUnseen()
    stages.push(stage)
    return [picture, element("span", {}, label)]
  }
  return {stages, draw}
}

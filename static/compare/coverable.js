// The parts of a page that a visitor can cover, each with the name that the screen shows for it.

import {plain} from "../core/plain.js"

const LONGEST = 48 // a text with at least so many characters is a sentence

/**
 * A part that can be covered: its name in covers and its name in a list.
 * @typedef {{cover: string, text: string}} Coverable
 */

/** Plots, numbers and the stage. @param {PartHost} page @returns {Coverable[]} */
export function parts({plots, spec, stages}) {
  const seen = plots.filter(({absent, host}) => !absent && host.offsetParent)
  const numbers = Object.entries(spec.spoken).flatMap(([name, text]) => {
    const [, value] = text.match(/\{(\w+)\}/) ?? []
    return value ? [{cover: `value:${value}`, text: `Number: ${name}`}] : []
  })
  const moves = stages.some(stage => stage.svg.role === "img")
  return [
    ...seen.map(({block}) => ({cover: `plot:${block.name}`, text: block.brief})),
    ...numbers,
    ...(moves ? [{cover: "stage", text: "Motion and numbers of the apparatus"}] : []),
  ]
}

/**
 * The sentences and formulas that depend on the parameters, each listed by its first words.
 * @param {PartHost} page @returns {Coverable[]}
 */
export const sentences = ({sheet}) =>
  sheet.items.flatMap(({name, holder}) => {
    const text = holder.hidden || !holder.offsetParent ? "" : plain(holder).trim()
    const [start] = text.match(new RegExp(`^.{0,${LONGEST}}(?!\\S)`, "u")) ?? [text.slice(0, LONGEST)]
    return text ? [{cover: `form:${name}`, text: `Text: ${start}${start === text ? "" : " …"}`}] : []
  })

// The caption of a picture: the parameters as the panel shows them, the instant, and the link.

import {marked} from "../core/dom.js"
import {brief} from "../controls/handles.js"
import {withTrueMinus, withUnit} from "../core/numbers.js"
import {indexed, plain} from "../core/plain.js"

/** The rows of the panel's tables, then its parameters, such as "m₁ = 2.00 kg". @param {PartHost} page */
export function parameters({spec, panel, shown: {settings, view}}) {
  const groups = spec.panel.groups.filter(({form}) => !form || view.forms[form])
  const rows = groups.flatMap(group => group.rows).filter(row => row.kind === "slider")
  const set = rows.map(row => {
    const {text, unit} = settings[row.name]
    return `${indexed(row.symbol)} = ${withUnit(withTrueMinus(brief(text)), unit ?? row.unit)}`
  })
  const lines = [...panel.querySelectorAll("section:not([hidden], :has(.control)) .cells-1")].map(row =>
    plain(row).replace(/,$/, ""),
  )
  return [...lines, ...set]
}

/** @param {PartHost} page */
export const link = page => new URL(page.link, location.href).href

/** @param {PartHost} page */
export const instant = page => (page.shown.view.time ? `t = ${page.clock.t.toFixed(page.clock.places)} s` : "")

/**
 * The numbers that differ in the compared picture; `drawn` describes its lines.
 * @param {PartHost} page @param {string} drawn
 */
export function held({shown}, drawn) {
  const rows = shown.held?.ledger.filter(({same}) => !same) ?? []
  const numbers = rows.map(({symbol, held: number, unit}) => {
    return `${plain(marked("i", {}, symbol))} = ${withUnit(number, unit)}`
  })
  return numbers.length ? [`${drawn}: held, ${numbers[0]}`, ...numbers.slice(1)] : []
}

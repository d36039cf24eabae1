// The values of the panel in one line, for hall mode, in which the panel is folded.

import {element} from "../core/dom.js"
import {brief} from "../controls/handles.js"
import {MINUS, short, withUnit} from "../core/numbers.js"
import {symbol} from "../controls/slider.js"

/** @param {PartHost} page */
export function values({spec, shown: {settings, view}, transport}) {
  const groups = spec.panel.groups.filter(({form, folded}) => !folded && (!form || view.forms[form]))
  const rows = groups.flatMap(group => group.rows).filter(row => row.kind === "slider")
  const parts = rows.map(row => {
    const {text, unit} = settings[row.name]
    const isRaised = text.includes("e")
    const number = isRaised ? short(Number(text.replaceAll(MINUS, "-"))) : brief(text)
    return element(
      "span",
      {},
      element("span", {class: `tint ${row.tint}`}, symbol(row.symbol)),
      ` ${withUnit(number, unit ?? row.unit)}`,
    )
  })
  const line = transport.element.querySelector(".in-force") ?? element("div", {class: "in-force"})
  line.replaceChildren(...parts)
  transport.element.append(line)
}

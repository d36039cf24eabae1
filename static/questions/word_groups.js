// Equal answers in words, in a row of a list.

import {button, element} from "../core/dom.js"

/** @typedef {(text: string, shows: boolean) => void} Moderate shows an answer to the hall, or removes it */

/**
 * A row, with buttons that show them to the hall and remove them.
 * @param {page.WordGroup} group @param {Moderate} [moderate]
 */
export function grouped({text, count, shown}, moderate) {
  const row = element("li", {class: shown ? "shown" : ""}, element("span", {}, text))
  if (count > 1) row.append(element("b", {}, ` × ${count}`))
  if (!moderate) return row
  if (!shown) row.append(button({class: "chip"}, () => moderate(text, true), "Show"))
  row.append(button({class: "chip"}, () => moderate(text, false), "Remove"))
  return row
}

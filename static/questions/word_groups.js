// A row of a list: equal answers in words, with their count.

import {button, element} from "../core/dom.js"

/** @typedef {(text: string, shows: boolean) => void} Moderate shows an answer to the hall, or removes it */

/**
 * The row of a group of equal answers, with a button that shows them to the hall or removes them.
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

// The list of keys next to the paper. You can try each key while you read it, or press it as a button.

import {button, chip, element} from "../core/dom.js"

/**
 * @typedef {{shown: string, does: string}} Listed
 * @typedef {{off: boolean, set: (off: boolean) => void}} Singles whether keys of a single letter act
 */

/** @template {Listed} Known @param {Known[]} keys @param {Singles} singles @param {(key: Known) => void} press */
export function toggleList(keys, singles, press) {
  const open = document.querySelector("dialog.keys[open]")
  if (open) return open.remove()
  const dialog = element("dialog", {class: "keys", "aria-label": "Keys"})
  const rows = keys.map(key => row(key, () => press(key)))
  dialog.addEventListener("close", () => dialog.remove())
  const close = chip("Close", () => dialog.close())
  const head = element("header", {}, element("h2", {}, "Keys"), close)
  dialog.append(head, element("ul", {}, ...rows, arrows()), choice(singles))
  document.body.append(dialog)
  dialog.show()
  close.focus()
}

/** @param {Listed} key @param {() => void} press */
function row({shown, does}, press) {
  return element("li", {}, button({}, press, element("kbd", {}, shown), element("span", {}, does)))
}

/** Keys that have no action here. */
const arrows = () =>
  element(
    "li",
    {},
    element("p", {}, element("kbd", {}, "Arrows"), element("span", {}, "Move the slider or mark that has the focus")),
  )

/** @param {Singles} singles */
function choice(singles) {
  const box = element("input", {type: "checkbox"})
  box.checked = !singles.off
  box.addEventListener("change", () => singles.set(!box.checked))
  return element("label", {class: "singles"}, box, " Single-letter shortcuts on")
}

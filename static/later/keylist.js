// The list of the keys: beside the paper, so that each can be tried while it is read, and pressed as a button.

import {element} from "../dom.js"
import {KEYS, singles} from "../keys.js"

/** @param {import("../main.js").Lecture} lecture */
export function toggleList(lecture) {
  const open = document.querySelector("dialog.keys")
  if (open) return open.remove()
  const dialog = element("dialog", {class: "keys", "aria-label": "Keys"})
  const rows = KEYS.map(key => row(key, lecture))
  const close = element("button", {type: "button", class: "chip"}, "Close")
  close.addEventListener("click", () => dialog.remove())
  const head = element("header", {}, element("h2", {}, "Keys"), close)
  dialog.append(head, element("ul", {}, ...rows, arrows()), choice())
  document.body.append(dialog)
  dialog.show()
  close.focus()
}

/**
 * @param {import("../keys.js").Key} key
 * @param {import("../main.js").Lecture} lecture
 */
function row({shown, does, act}, lecture) {
  const button = element("button", {type: "button"}, element("kbd", {}, shown), element("span", {}, does))
  button.addEventListener("click", () => act(lecture))
  return element("li", {}, button)
}

/** They have no deed of their own. */
const arrows = () =>
  element(
    "li",
    {},
    element("p", {}, element("kbd", {}, "Arrows"), element("span", {}, "Move the slider or mark that has the focus")),
  )

function choice() {
  const box = element("input", {type: "checkbox"})
  box.checked = !singles.off
  box.addEventListener("change", () => singles.set(!box.checked))
  return element("label", {class: "singles"}, box, " Single-letter shortcuts on")
}

// A sentence at the foot of the page: what the visitor should know, and what is seen stays as it is.

import {element} from "./dom.js"

/** What went wrong, as it says itself. @param {unknown} reason */
export const inWords = reason => (reason instanceof Error ? reason.message : String(reason))

/**
 * Said until it is closed, or what is returned is called.
 * @param {string} sentence @param {HTMLElement[]} parts
 */
export function note(sentence, ...parts) {
  const close = element("button", {type: "button", "aria-label": "Close"}, "×")
  const said = element("div", {class: "remark", role: "status"}, close)
  close.addEventListener("click", () => said.remove())
  document.body.append(said)
  said.prepend(element("span", {}, sentence), ...parts) // what comes into a status that is there is read out
  return () => said.remove()
}

// Notices for the visitor: at the foot of the page, where they do not move the visible part, and over a scene.

import {button, element} from "./dom.js"

/** The text of an exception. @param {unknown} reason */
export const inWords = reason => (reason instanceof Error ? reason.message : String(reason))

/**
 * Shows a notice until the visitor closes it, or until the returned function is called.
 * @param {string} sentence @param {HTMLElement[]} parts
 */
export function note(sentence, ...parts) {
  const close = button({"aria-label": "Close"}, () => status.remove(), "×")
  const status = element("div", {class: "remark", role: "status"}, close)
  document.body.append(status)
  status.prepend(element("span", {}, sentence), ...parts) // announced, because the status element exists already
  return () => status.remove()
}

/** Shows a notice over the scene until it is closed, for example why a request was refused. */
export class Notice {
  element = element("div", {class: "notice", role: "alert", hidden: ""})

  /** @param {string} sentence */
  tell(sentence) {
    const close = button({"aria-label": "Close"}, () => this.hide(), "×")
    this.element.replaceChildren(element("span", {}, sentence), close)
    this.element.hidden = false
  }

  hide() {
    this.element.hidden = true
  }

  /** @param {Drawn} shown */
  update({problems, errors}) {
    const sentence = [...problems, errors.message, errors.state].filter(Boolean).join(" ")
    if (sentence) this.tell(sentence)
  }
}

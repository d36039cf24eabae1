// A text put where another program can take it up.

import {element} from "./dom.js"

/**
 * A page that came over plain http from another machine has no clipboard, nor has one in a frame that was not given it:
 * there what is selected can be copied.
 * @param {string} text
 */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    const {activeElement} = document
    const field = element("textarea", {class: "heard", "aria-hidden": "true"})
    field.value = text
    document.body.append(field)
    field.select()
    const copied = document.execCommand("copy")
    field.remove()
    if (activeElement instanceof HTMLElement) activeElement.focus({preventScroll: true})
    return copied
  }
}

// Copies the link of a page to the clipboard.

import {isTooLong} from "../net/address.js"
import {chip, element} from "../core/dom.js"
import {note} from "../core/notes.js"

const NAME = "Copy link"
const MOMENT = 1500 // ms for which a button shows its result

/** @param {() => string} link */
export function copyButton(link) {
  const button = chip(NAME, async () => {
    button.textContent = await taken(link())
    setTimeout(() => {
      button.textContent = NAME
    }, MOMENT)
  })
  return button
}

/** Copies a link, and returns the result in a word or two. @param {string} link */
async function taken(link) {
  if (isTooLong(link)) return "Too long"
  const address = new URL(link, location.href).href
  if (await copied(address)) return "Copied"
  const field = element("input", {type: "text", readonly: "", "aria-label": "Link", value: address})
  note("Copy this link:", field)
  field.select()
  return "Not copied"
}

/**
 * Copies a text. Pages over plain http, and frames without permission, cannot write to the clipboard; there it copies a
 * selection.
 * @param {string} text
 */
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    const {activeElement} = document
    const field = element("textarea", {class: "heard", "aria-hidden": "true"})
    field.value = text
    document.body.append(field)
    field.select()
    const isCopied = document.execCommand("copy")
    field.remove()
    if (activeElement instanceof HTMLElement) activeElement.focus({preventScroll: true})
    return isCopied
  }
}

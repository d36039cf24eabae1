// A field shows as many digits of its number as fit, and all digits while it has the focus.

import {MINUS, short} from "../core/numbers.js"

const MOST = 12 // digits with which shortening begins
const USUAL = 7 // characters assumed for a field without a layout yet

/** @param {HTMLInputElement} field */
export function fitting(field) {
  let whole = ""
  let frame = 0
  const isFocused = () => document.activeElement === field

  /** Measures at the next frame, because measuring between other changes of the page is slow. */
  function later() {
    cancelAnimationFrame(frame)
    frame = requestAnimationFrame(shorten)
  }

  function shorten() {
    if (isFocused()) return
    const value = Number(whole.replaceAll(MINUS, "-"))
    for (let count = MOST; count > 0 && !fits(field); count--) field.value = short(value, count)
    field.title = field.value === whole ? "" : whole
  }

  field.addEventListener("focus", () => {
    if (field.title) field.value = whole
    field.title = ""
  })
  field.addEventListener("blur", () => {
    if (field.value === whole) later()
  })

  /** @param {string} text a number as Python writes it */
  return text => {
    whole = field.value = text
    later()
  }
}

/** @param {HTMLInputElement} field */
function fits({clientWidth, scrollWidth, value}) {
  if (value.length < USUAL) return true
  return clientWidth ? scrollWidth <= clientWidth : value.length <= USUAL
}

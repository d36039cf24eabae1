// A pointer that the hall sees, while a pen, a finger or a mouse is held down.

import {element} from "../core/dom.js"

/** @type {HTMLElement | null} */
let disc = null

/** To be asked for as often as one likes. */
export function pointer() {
  if (disc) return
  disc = element("i", {class: "pointer", "aria-hidden": "true", hidden: ""})
  document.body.append(disc)
  for (const kind of ["pointerdown", "pointermove"]) addEventListener(kind, event => show(event), true)
  for (const kind of ["pointerup", "pointercancel"]) addEventListener(kind, () => hide(), true)
}

/** @param {Event} event */
function show(event) {
  if (!disc || !(event instanceof PointerEvent)) return
  const inHall = document.documentElement.dataset.mode === "projector"
  disc.hidden = !inHall || !event.buttons
  disc.style.transform = `translate(${event.clientX}px, ${event.clientY}px)`
}

function hide() {
  if (disc) disc.hidden = true
}

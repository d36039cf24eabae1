// A large pointer for a hall, visible while a mouse or pen moves or a finger touches. When the pointer rests, it
// disappears, and so do the numbers at the pointer over a plot: static/styles/hall.css.

import {element} from "../core/dom.js"

const REST = 1500 // ms without a move
const root = document.documentElement

/** @type {HTMLElement | null} */
let disc = null

/** @type {number | undefined} */
let timer

/** Idempotent. */
export function pointer() {
  if (disc) return
  disc = element("i", {class: "pointer", "aria-hidden": "true", hidden: ""})
  document.body.append(disc)
  for (const kind of ["pointerdown", "pointermove", "pointerup"]) addEventListener(kind, event => show(event), true)
  addEventListener("pointercancel", () => setVisible(false), true)
}

/** @param {Event} event */
function show(event) {
  if (!disc || !(event instanceof PointerEvent)) return
  const isHeld = event.buttons > 0
  setVisible(root.dataset.mode === "projector" && (isHeld || event.pointerType !== "touch"))
  disc.style.transform = `translate(${event.clientX}px, ${event.clientY}px)`
  clearTimeout(timer)
  if (!isHeld) timer = setTimeout(() => setVisible(false), REST)
}

/** @param {boolean} isSeen */
function setVisible(isSeen) {
  if (disc) disc.hidden = !isSeen
  root.toggleAttribute("data-pointing", isSeen)
}

// Scroll anchoring for browsers that have none, such as Safari: changes above the visible part do not move it.

import {steady} from "./drag.js"

const STEP = 12 // pixels between the points at which a part is looked for

let free = () => {}
let isHeld = false
let isDue = false

/** While nobody scrolls, keeps the topmost visible part in place when the layout above it changes. */
export function anchor() {
  if (CSS.supports("overflow-anchor", "auto")) return
  addEventListener("scroll", renew, {passive: true})
  addEventListener("pointerdown", () => hold(true), true) // during a press, the pressed part stays in place instead
  for (const kind of ["pointerup", "pointercancel"]) addEventListener(kind, () => hold(false), true)
}

/** @param {boolean} is */
function hold(is) {
  isHeld = is
  renew()
}

/** Chooses the part to keep, once per frame. */
function renew() {
  free()
  free = () => {}
  if (isDue) return
  isDue = true
  requestAnimationFrame(() => {
    isDue = false
    const part = !isHeld && scrollY > 0 && topmost()
    if (part) free = steady(part)
  })
}

/** The topmost visible part that scrolls with the page. */
function topmost() {
  for (let y = 0; y < innerHeight; y += STEP) {
    const found = document.elementFromPoint(innerWidth / 4, y)
    if (found && found.getBoundingClientRect().top >= 0 && scrolls(found)) return found
  }
  return null
}

/** @param {Element | null} part @returns {boolean} */
const scrolls = part =>
  !part || (!["sticky", "fixed"].includes(getComputedStyle(part).position) && scrolls(part.parentElement))

// Moves of a slider: sideways moves of a finger, and keys with steps that suit the value.

import {SIDEWAYS} from "./drag.js"
import {atTwoDigits, leapt} from "./scales.js"

/** @type {Record<string, 1 | -1>} */
const ALONG = {ArrowUp: 1, ArrowDown: -1, ArrowRight: 1, ArrowLeft: -1}

/** @type {Record<string, 1 | -1>} */
const LEAPS = {PageUp: 1, PageDown: -1}

// A vertical swipe that starts on a slider scrolls the page. So the slider moves only after a sideways move.
export class Finger {
  /** @type {{x: number, y: number, initial: string, sideways: boolean} | null} */
  swipe = null

  /** @param {HTMLInputElement} slider */
  constructor(slider) {
    this.slider = slider
    slider.addEventListener("pointerdown", ({pointerType, clientX: x, clientY: y}) => {
      this.swipe = pointerType === "touch" ? {x, y, initial: slider.value, sideways: false} : null
    })
    slider.addEventListener("pointermove", ({clientX, clientY}) => {
      if (!this.swipe) return
      const [across, along] = [Math.abs(clientX - this.swipe.x), Math.abs(clientY - this.swipe.y)]
      this.swipe.sideways ||= across > SIDEWAYS && across > along
    })
    slider.addEventListener("keydown", () => {
      this.swipe = null
    })
  }

  /** True if the last move was only a touch; the slider then goes back to its value. */
  onlyTouched() {
    if (!this.swipe || this.swipe.sideways) return false
    this.slider.value = this.swipe.initial
    return true
  }
}

/**
 * The value to which a key moves a slider from `value`; null for keys without an action.
 * @param {string} key @param {page.SliderRow["scale"]} scale @param {number} value @param {[number, number]} soft
 * @param {(direction: 1 | -1) => number} next the value after it on the slider
 */
export function keyed(key, scale, value, soft, next) {
  if (key in LEAPS) return leapt(scale, value, LEAPS[key], soft)
  const direction = ALONG[key]
  if (!direction) return null
  return scale === "log" ? atTwoDigits(value, direction, soft) : next(direction)
}

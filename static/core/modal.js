// The motion of a chain of equal masses as the sum of its modes: shapes from whole numbers, as in physics/chain.py.

import {circled} from "./damped.js"

/** @typedef {Pick<page.Modal, "ends" | "omega" | "sizes" | "phases" | "line">} Modes */

/** @type {Map<string, Float64Array>} the mode shapes computed last, by boundary condition and number of masses */
const known = new Map()
const MOST_KNOWN = 4

/**
 * The orthonormal mode shapes in one array: entry j N + p is mode j at mass p, both counted from 0. @param {Modes}
 * modes
 */
export function shapesOf({ends, omega: {length: count}}) {
  const key = `${ends} ${count}`
  const found = known.get(key)
  if (found) return found
  if (known.size >= MOST_KNOWN) known.clear()
  const shapes = new Float64Array(count * count)
  const [isFree, isHalf] = [ends === "free-free", ends === "fixed-free"]
  const parts = 2 * (isFree ? count : isHalf ? 2 * count + 1 : count + 1)
  const size = Math.sqrt((isHalf ? 8 : 4) / parts)
  for (let j = 0; j < count; j++) {
    const number = isFree ? j : isHalf ? 2 * j + 1 : j + 1
    for (let p = 0; p < count; p++) {
      const turn = isFree ? number * (2 * p + 1) + count : 2 * number * (p + 1)
      shapes[j * count + p] = isFree && !j ? Math.sqrt(1 / count) : size * sinOfPart(turn % (2 * parts), parts)
    }
  }
  known.set(key, shapes)
  return shapes
}

/**
 * sin(pi n/parts), n from 0 to 2 parts, from an angle of at most an eighth of a turn.
 * @param {number} n @param {number} parts @returns {number}
 */
function sinOfPart(n, parts) {
  if (n > parts) return -sinOfPart(n - parts, parts)
  const folded = Math.min(n, parts - n)
  return 4 * folded <= parts
    ? Math.sin((Math.PI * folded) / parts)
    : Math.cos((Math.PI * (parts - 2 * folded)) / (2 * parts))
}

/** The displacements of all masses at an instant. @param {Modes} modes @param {number} t */
export function displaced(modes, t) {
  const {omega, sizes, phases, line} = modes
  const {length: count} = omega
  const shapes = shapesOf(modes)
  const found = new Float64Array(count).fill(line[0] + line[1] * t)
  for (let j = 0; j < count; j++) {
    if (!sizes[j]) continue
    const q = sizes[j] * Math.sin(circled(omega[j] * t + phases[j]))
    for (let p = 0, at = j * count; p < count; p++, at++) found[p] += q * shapes[at]
  }
  return found
}

/**
 * Returns the displacement of the selected mass, and sets the displacements of all masses under their numbered names.
 * @param {page.Modal} signal @param {number} t @param {Named} named
 */
export function modal(signal, t, named) {
  const {name, at, of, by} = signal
  const scale = by ? named[of] / by : 1
  for (const [i, x] of displaced(signal, t).entries()) named[`${name}${i + 1}`] = scale * x
  return named[`${name}${Math.round(named[at])}`] ?? 0
}

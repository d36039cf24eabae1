// The masses of a chain on a stage: one path for all springs and one for the masses on each side.

import {setAttributes, svg, unitSize} from "../core/dom.js"
import {atInstant} from "../core/signals.js"
import {zigzag} from "./zigzag.js"

const SIDE = 54 // pixels: the side of the square of one of n masses is at most this over √(n + 1)
const WIDEST = 0.75 // of a spacing
const REACH = 24 // pixels: the largest distance at which a pointer grabs a mass

/**
 * The position of each mass, its place at rest, and its displacement.
 * @param {AtInstant<page.Beads>} s @param {Named} all
 */
function places(s, all) {
  return Array.from({length: s.count}, (_, i) => {
    const rest = s.x + (s.length * (s.first + i)) / s.parts
    const x = (all[`${s.of}${i + 1}`] ?? s.drift) - s.drift
    return {rest, shift: x, x: rest + s.along * x, y: s.y - s.across * x}
  })
}

/**
 * The springs: zigzags for up to 12 masses, straight lines for more. @param {Point[]} ends @param {number} count @param
 * {number} half
 */
function springs(ends, count, half) {
  if (count > 12) return `M${ends.map(({x, y}) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`
  const pairs = ends.slice(1).map((end, i) => [ends[i], end])
  return pairs.map(([from, to]) => zigzag(from.x, from.y, to.x, to.y, half, count > 4 ? 4 : 9)).join("")
}

/** @type {Kind<page.Beads>} */
export const beads = {
  make() {
    const looks = ["k", "m1", "m2"].flatMap(tint => [`stems ln ${tint}`, `mass ${tint}`])
    return ["spring", ...looks, "reach"].map(look => svg("path", {class: look}))
  },
  move(parts, s, all = {}) {
    const found = places(s, all)
    const side = Math.min(SIDE / Math.sqrt(s.count + 1), (WIDEST * s.length) / s.parts)
    const walls = [s.x, s.x + s.length].map(x => ({x, y: s.y}))
    const ends = [...(s.left ? [walls[0]] : []), ...found, ...(s.right ? [walls[1]] : [])]
    const squares = ["", "", ""]
    const stems = ["", "", ""]
    for (const {rest, shift, x, y} of found) {
      const way = shift > s.least ? 1 : shift < -s.least ? 2 : 0
      squares[way] += `M${(x - side / 2).toFixed(1)} ${(y - side / 2).toFixed(1)}h${side}v${side}h${-side}z`
      if (way && s.across) stems[way] += `M${rest.toFixed(1)} ${s.y}V${y.toFixed(1)}`
    }
    const looks = squares.flatMap((square, i) => [stems[i], square])
    const outlines = [springs(ends, s.count, Math.min(0.35 * side, 11)), ...looks, s.picks ? squares.join("") : ""]
    for (const [i, d] of outlines.entries()) setAttributes(parts[i], {d})
  },
}

/**
 * The number of the mass nearest to a point; 0 if none is near.
 * @param {AtInstant<page.Beads>} s @param {Named} all @param {Point} at
 */
function nearest(s, all, at) {
  const far = places(s, all).map(({x, y}) => Math.hypot(x - at.x, y - at.y))
  const least = Math.min(...far)
  return least <= REACH ? far.indexOf(least) + 1 : 0
}

/**
 * Moves the grip of the stage to the mass near the pointer, if there are many.
 * @param {import("./stage.js").Stage} stage @param {PartHost} page
 */
export function pointed(stage, page) {
  const chain = stage.shapes.find(({spec}) => spec.kind === "beads")
  const {grips, host, svg: drawing} = stage
  if (!chain || !grips) return
  const {hand, clock} = page
  const point = (/** @type {PointerEvent} */ event) => {
    const all = stage.named
    if (hand.grab || !all) return
    const {left, top} = drawing.getBoundingClientRect()
    const at = {x: (event.clientX - left) / unitSize(), y: (event.clientY - top) / unitSize()}
    const now = /** @type {AtInstant<page.Beads>} */ (atInstant(chain, all))
    const mass = now.picks ? nearest(now, all, at) : 0
    hand.pointed = mass ? {[now.at]: mass} : {}
    clock.dirty = true
  }
  const press = (/** @type {PointerEvent} */ event) => {
    point(event)
    page.draw(clock.t) // move the grip before the pointer is pressed
    if (!(event.target instanceof Element && event.target.closest(".grip"))) grips.press(event)
  }
  host.addEventListener("pointermove", point)
  host.addEventListener("pointerdown", press, {capture: true})
}

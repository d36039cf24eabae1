// The masses of a chain on a stage: one path for the springs and one for each side, so that a frame costs the same for
// one mass as for many.

import {setAttributes, svg, unitSize} from "../core/dom.js"
import {atInstant} from "../core/signals.js"

const SIDE = 54 // of a lone mass, in pixels; n + 1 masses share its area
const WIDEST = 0.75 // of a spacing
const REACH = 24 // pixels from a mass within which a pointer takes it
/** Number of masses and teeth of a spring up to it; with more masses a spring is a line. @type {[number, number][]} */
const TEETH = [
  [4, 9],
  [12, 4],
]

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

/** @param {Point} from @param {Point} to @param {number} teeth @param {number} half the width of the teeth */
function spring(from, to, teeth, half) {
  let d = `M${from.x.toFixed(1)} ${from.y.toFixed(1)}`
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const length = Math.hypot(dx, dy) || 1
  for (let i = 0; i < 2 * teeth; i++) {
    const share = (i + 0.5) / (2 * teeth)
    const off = (i % 2 ? half : -half) / length
    d += `L${(from.x + dx * share - dy * off).toFixed(1)} ${(from.y + dy * share + dx * off).toFixed(1)}`
  }
  return `${d}L${to.x.toFixed(1)} ${to.y.toFixed(1)}`
}

/** @type {Kind<page.Beads>} */
export const beads = {
  make: () => [
    svg("path", {class: "spring"}),
    ...["k", "m1", "m2"].flatMap(tint => [
      svg("path", {class: `stems ln ${tint}`}),
      svg("path", {class: `mass ${tint}`}),
    ]),
    svg("path", {class: "reach"}),
  ],
  move([springs, ...parts], s, all = {}) {
    const found = places(s, all)
    const side = Math.min(SIDE / Math.sqrt(s.count + 1), (WIDEST * s.length) / s.parts)
    const [, teeth] = TEETH.find(([most]) => s.count <= most) ?? [0, 0]
    const ends = [...(s.left ? [{x: s.x, y: s.y}] : []), ...found, ...(s.right ? [{x: s.x + s.length, y: s.y}] : [])]
    setAttributes(springs, {
      d: ends
        .slice(1)
        .map((end, i) => spring(ends[i], end, teeth, Math.min(0.35 * side, 11)))
        .join(""),
    })
    const look = ["", "", ""]
    const stems = ["", "", ""]
    for (const {rest, shift, x, y} of found) {
      const of = shift > s.least ? 1 : shift < -s.least ? 2 : 0
      look[of] += `M${(x - side / 2).toFixed(1)} ${(y - side / 2).toFixed(1)}h${side}v${side}h${-side}z`
      if (of && s.across) stems[of] += `M${rest.toFixed(1)} ${s.y}V${y.toFixed(1)}`
    }
    for (let i = 0; i < 3; i++) {
      setAttributes(parts[2 * i], {d: stems[i]})
      setAttributes(parts[2 * i + 1], {d: look[i]})
    }
    setAttributes(parts[6], {d: look.join("")})
  },
}

/**
 * The number of the mass nearest to a point; 0 where none is near.
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
    page.draw(clock.t) // the grip is where the pointer is before it is pressed
    if (!(event.target instanceof Element && event.target.closest(".grip"))) grips.press(event)
  }
  host.addEventListener("pointermove", point)
  host.addEventListener("pointerdown", press, {capture: true})
}

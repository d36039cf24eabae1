// Variants of a step: its question with other numbers, chosen by a seed. The browser of a visitor keeps its seed, which
// also gives the order of options. In a class, everybody has the numbers of the file.

import {hash} from "../questions/order.js"
import {browserStorage} from "../core/storage.js"

const KEY = "seed"
let own = ""

/** The seed of this browser, stored so that a reload shows the same numbers. */
export function ownSeed() {
  own ||= browserStorage.text(KEY) ?? String(crypto.getRandomValues(new Uint32Array(1))[0])
  browserStorage.keep(KEY, own)
  return own
}

/** The card with the numbers of a seed; 0 means the numbers of the file. @param {page.StepCard} step @param {number}
 * seed */
export const variant = (step, seed) => step.variants[seed - 1] ?? step

/** The seed of this visitor's numbers, 0 if everybody has the same numbers. @param {page.StepCard} step */
export const seedOf = ({id, variants}) => (variants.length ? 1 + (hash(`${id}/${ownSeed()}`) % variants.length) : 0)

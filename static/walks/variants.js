// Variants of a step: its question with other numbers. A visitor alone has one, in a class all have those of the file.

import {hash} from "../questions/order.js"
import {ownSeed} from "./seed.js"

/** The card with the numbers of a seed; 0 are those of the file. @param {page.StepCard} step @param {number} seed */
export const variant = (step, seed) => step.variants[seed - 1] ?? step

/** The seed of this visitor's numbers, 0 where all have the same. @param {page.StepCard} step */
export const seedOf = ({id, variants}) => (variants.length ? 1 + (hash(`${id}/${ownSeed()}`) % variants.length) : 0)

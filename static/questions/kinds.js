// The kinds of question by the names that walks give them: components/walks/walk.py has the same names.

import {Choice} from "./choice.js"
import {Numeric} from "./number.js"
import {AxisPlace} from "./point.js"
import {Sketch} from "./sketch.js"
import {Words} from "./words.js"

/** @type {Record<string, typeof import("./question.js").Question>} */
export const KINDS = {choice: Choice, number: Numeric, point: AxisPlace, sketch: Sketch, words: Words}

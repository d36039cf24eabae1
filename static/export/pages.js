// The pages of a handout. No step is split; the pages are as few and as full as possible. A step that has a page alone
// is drawn larger.

import {element, unitSize} from "../core/dom.js"

const HIGH = 950 // units, the space on a page that fits both A4 and Letter, upright, with margins of 12 mm
const LARGEST = 1.6 // times the size at which labels are 7 pt
const FINER = 0.1

/** Puts the content of a handout on pages. @param {HTMLElement} handout */
export function paged(handout) {
  const [head, ...articles] = /** @type {HTMLElement[]} */ ([...handout.children])
  const heights = articles.map(high)
  heights[0] += high(head)
  const parts = packed(heights, HIGH)
  const sheets = parts.map(([from, end]) => element("div", {class: "sheet"}, ...articles.slice(from, end)))
  sheets[0].prepend(head)
  handout.replaceChildren(...sheets)
  sheets.forEach(fill)
}

/** Makes the pictures of a page as large as there is room. @param {HTMLElement} sheet */
function fill(sheet) {
  let size = LARGEST
  const grow = () => sheet.style.setProperty("--grow", String(size))
  grow()
  while (size > 1 && high(sheet) > HIGH) {
    size = Math.max(1, size - FINER)
    grow()
  }
}

/** @param {HTMLElement} part */
const high = part => part.getBoundingClientRect().height / unitSize()

/**
 * The first and the end index of the steps on each page: as few pages as possible, evenly filled.
 * @param {number[]} heights @param {number} most of a page @returns {[number, number][]}
 */
export function packed(heights, most) {
  /** @type {{pages: [number, number][], waste: number}[]} the best distribution of the steps from each index on */
  const best = []
  best[heights.length] = {pages: [], waste: 0}
  for (let from = heights.length - 1; from >= 0; from--) {
    let used = 0
    for (let end = from + 1; end <= heights.length; end++) {
      used += heights[end - 1]
      if (used > most && end > from + 1) break
      const {pages, waste} = best[end]
      const [count, left] = [pages.length + 1, waste + Math.max(0, most - used) ** 2]
      const known = best[from]
      if (!known || count < known.pages.length || (count === known.pages.length && left < known.waste))
        best[from] = {pages: [[from, end], ...pages], waste: left}
    }
  }
  return best[0].pages
}

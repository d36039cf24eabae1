// The stages and plots that can be saved as pictures: visible, and not hidden by an open question.

import {isCovered} from "../compare/cover.js"

/** @param {PartHost} page */
export function things(page) {
  const stages = page.compare.still ? [] : page.stages.filter(stage => stage.svg.role === "img" && isSeen(stage.host))
  const plots = page.plots.filter(plot => plot.box && !plot.absent && !isCovered(plot) && isSeen(plot.host))
  return {stages, plots}
}

/** @param {HTMLElement} host */
export const isSeen = host => host.offsetParent !== null && host.clientWidth > 0

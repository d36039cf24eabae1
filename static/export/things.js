// The stages and plots that are seen and not covered: what pictures are made of.

/** @param {PartHost} page */
export function things(page) {
  const stages = page.compare.still
    ? []
    : page.stages.filter(stage => stage.svg.getAttribute("role") === "img" && isSeen(stage.host))
  const plots = page.plots.filter(plot => plot.box && !plot.absent && !isCovered(plot) && isSeen(plot.host))
  return {stages, plots}
}

/** @param {HTMLElement} host */
const isSeen = host => host.offsetParent !== null && host.clientWidth > 0

/** @param {import("../paper/plots.js").Plot} plot */
const isCovered = plot => plot.shown.state.covered.includes(`plot:${plot.block.name}`)

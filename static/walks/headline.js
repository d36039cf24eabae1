// The headline of the page in a walk: the question of the step, and after the answer its claim.

/**
 * Shows a text as the headline, or the scene's own headline if it is missing. @param {PartHost} page @param {page.Html}
 * [html]
 */
export function claim({heading, spec}, html) {
  heading.classList.remove("waits")
  if (html) heading.innerHTML = html
  else heading.textContent = spec.headline
}

/** Shows the question of a step as the headline. @param {PartHost} page @param {page.Html} html */
export function showQuestion({heading}, html) {
  heading.classList.add("waits")
  heading.innerHTML = html
}

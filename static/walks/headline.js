// The headline in a walk: the question of a step, and once it has been answered its claim.

/** The page's own headline, or another. @param {PartHost} page @param {page.Html} [html] */
export function claim({heading, spec}, html) {
  heading.classList.remove("waits")
  if (html) heading.innerHTML = html
  else heading.textContent = spec.headline
}

/** Shows the question in the claim's place. @param {PartHost} page @param {page.Html} html */
export function showQuestion({heading}, html) {
  heading.classList.add("waits")
  heading.innerHTML = html
}

// The headline in a walk: the claim of a step, once it has been answered.

import {element, marked} from "../core/dom.js"

/** The page's own headline, or another. @param {PartHost} page @param {page.Html} [html] */
export function claim({heading, spec}, html) {
  heading.classList.remove("waits")
  if (html) heading.innerHTML = html
  else heading.textContent = spec.headline
}

/**
 * It would give an answer away: in a hall the question stands in its place.
 * @param {PartHost} page @param {page.Html} question
 */
export function withhold({heading}, question) {
  const covered = element("span", {class: "on-desk"}, "Title hidden until you press Show the answer")
  heading.classList.add("waits")
  heading.replaceChildren(covered, marked("span", {class: "in-hall"}, question))
}

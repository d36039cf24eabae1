// Small pictures in motion.

const still = matchMedia("(prefers-reduced-motion: reduce)")

/** Plays the pictures in view, unless the visitor asks for less motion. @param {SVGSVGElement[]} pictures */
export function play(pictures) {
  /** @type {Set<Element>} */
  const seen = new Set()
  const update = () => {
    for (const picture of pictures) {
      if (still.matches || !seen.has(picture)) picture.pauseAnimations()
      else begin(picture)
    }
  }
  const observer = new IntersectionObserver(entries => {
    for (const {target, isIntersecting} of entries) seen[isIntersecting ? "add" : "delete"](target)
    update()
  })
  for (const picture of pictures) observer.observe(picture)
  still.addEventListener("change", update)
}

/** @param {SVGSVGElement} picture */
function begin(picture) {
  picture.unpauseAnimations()
  if (picture.hasAttribute("data-begun")) return
  picture.setAttribute("data-begun", "")
  for (const part of picture.querySelectorAll("animateTransform")) part.beginElement()
}

// A black screen, as a lecturer has it who wants to be looked at: over the whole page, until it is pressed.

/** Black, or back from it. */
export function blank() {
  const there = document.querySelector(".blank")
  if (there) return there.remove()
  const black = document.createElement("div")
  black.className = "blank"
  black.addEventListener("pointerdown", () => black.remove())
  document.body.append(black)
}

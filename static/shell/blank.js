// A black screen over the whole page, until a key or press, so that students look at the lecturer.

/** Makes the screen black, or shows the page again if it is black. */
export function blank() {
  const there = document.querySelector(".blank")
  if (there) return there.remove()
  const black = document.createElement("div")
  black.className = "blank"
  black.addEventListener("pointerdown", () => black.remove())
  document.body.append(black)
}

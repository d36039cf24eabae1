// Shows values that are not sent yet, with a dotted line.

/** @param {PartHost} page @param {Waits} waiting */
export function showWaiting(page, waiting) {
  if (!waiting.size && !page.waiting.size) return
  page.waiting = waiting
  page.controls.wait(waiting)
  page.views.wait(waiting)
  for (const part of page.root.querySelectorAll("[data-grab], [data-name]")) mark(part, waiting)
  for (const plot of page.plots) if (plot.shown) plot.handles.place()
}

/** Marks a handle, choice or field with an unsent parameter. @param {Element} part @param {Waits} waiting */
function mark(part, waiting) {
  const names = (part.getAttribute("data-grab") ?? part.getAttribute("data-name") ?? "").split(" ")
  const name = names.find(one => waiting.has(one))
  part.classList.toggle("waits", name !== undefined)
  if (name === undefined) return
  for (const option of part.querySelectorAll("[data-option]")) {
    option.setAttribute("aria-pressed", String(option.getAttribute("data-option") === waiting.get(name)))
  }
}

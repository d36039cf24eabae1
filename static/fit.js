// Fit: the frame that suits what is drawn now. Changes of values never shrink it, so this is how it comes back.

import {element} from "./dom.js"

/** The button, there while the frame is another one; its place is kept. */
export class Fit {
  /** @param {PartHost} page */
  constructor(page) {
    this.element = element(
      "button",
      {type: "button", class: "chip fit", title: "Fit axes, time window and speed (0)"},
      "Fit",
    )
    this.element.addEventListener("click", () => page.host.fit())
    page.paper.addEventListener("dblclick", event => {
      if (event.target instanceof Element && event.target.closest(".plot-area")) page.host.fit()
    })
  }

  /** @param {Drawn} shown */
  update({state}) {
    this.element.classList.toggle("fitted", !state.frame)
  }
}

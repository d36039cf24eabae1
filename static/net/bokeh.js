// Loads BokehJS, which draws the plots and has the connection to the server, after the first picture.

import {element} from "../core/dom.js"

/** @type {Promise<unknown> | undefined} */
let fetched

/** Resolves when BokehJS is loaded; failed requests are repeated. */
export function bokeh() {
  fetched ??= new Promise((done, failed) => {
    const script = element("script", {src: document.documentElement.dataset.bokeh})
    script.addEventListener("load", done)
    script.addEventListener("error", () => {
      fetched = undefined
      script.remove()
      failed(new Error("BokehJS could not be fetched."))
    })
    document.head.append(script)
  })
  return fetched
}

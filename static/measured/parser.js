// Papa Parse, which reads tables, fetched when a file is opened. The page has it under window.Papa.

import {element} from "../core/dom.js"

const NAME = "papaparse.min.js" // next to BokehJS: components/serving/assets.py

/** @type {Promise<import("./table.js").Parser> | undefined} */
let fetched

/** The parser, when it is loaded. */
export function parser() {
  fetched ??= new Promise((done, failed) => {
    const src = new URL(NAME, new URL(document.documentElement.dataset.bokeh ?? "", document.baseURI)).href
    const script = element("script", {src})
    script.addEventListener("load", () => done(/** @type {any} */ (window).Papa))
    script.addEventListener("error", () => {
      fetched = undefined
      script.remove()
      failed(new Error("The program that reads tables could not be loaded. Try again in a moment."))
    })
    document.head.append(script)
  })
  return fetched
}

// Faults of our own scripts: they are logged, reported to the visitor once, and do not stop other parts.

import {inWords, note} from "./notes.js"

/** @type {Set<string>} faults logged so far, because the same fault can occur in each frame */
const logged = new Set()

let wasReported = false

/** Logs each fault once, and notifies the visitor of the first one. @param {unknown} reason */
export function report(reason) {
  if (!logged.has(String(reason))) console.error(reason)
  logged.add(String(reason))
  tell(reason)
}

/** @param {unknown} reason */
function tell(reason) {
  if (wasReported) return
  wasReported = true
  note(`Part of this page does not work (${inWords(reason)}). The rest does; reloading the page may help.`)
}

/** Runs an action and reports its faults, so that other actions still run. @param {() => unknown} act */
export function guarded(act) {
  try {
    const done = act()
    if (done instanceof Promise) done.catch(report)
  } catch (reason) {
    report(reason)
  }
}

/** Reports uncaught faults, for example in the action of a button; the browser logs these already. */
export function watch() {
  // An event without an error is a notice of the browser, for example about a delayed ResizeObserver.
  addEventListener("error", ({error}) => error && tell(error))
  addEventListener("unhandledrejection", ({reason}) => tell(reason))
}

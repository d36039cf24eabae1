// The answer to the step that stands, kept by this tab: a page that is loaded anew shows what it has shown.

const KEY = "answered-step"

/** @typedef {{step: string, given: Partial<page.Vote>}} Answered to a step of a walk, "d34/d34-07" */

/** @returns {Answered | null} */
export function answered() {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "null")
  } catch {
    return null // a browser that keeps nothing asks again
  }
}

/** @param {Answered} known */
export function keepAnswered(known) {
  try {
    sessionStorage.setItem(KEY, JSON.stringify(known))
  } catch {
    // The same.
  }
}

export function forgetAnswered() {
  try {
    sessionStorage.removeItem(KEY)
  } catch {
    // Nothing was kept.
  }
}

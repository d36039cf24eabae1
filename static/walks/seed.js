// The seed of a visitor's order of answers. It is kept, so that a page loaded anew is as it was.

import {browserStorage} from "../core/storage.js"

const KEY = "seed"
let own = ""

/** The seed of this browser. */
export function ownSeed() {
  own ||= browserStorage.text(KEY) ?? String(crypto.getRandomValues(new Uint32Array(1))[0])
  browserStorage.keep(KEY, own)
  return own
}

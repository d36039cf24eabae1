// Modules that only some pages need, fetched on demand. While one cannot be fetched, a notice says so.

import {note} from "./core/notes.js"

const PAUSE = 10000 // ms until the next try, or until the network or the server is back

const MISSING = "Part of this page could not be loaded; it is loaded when the server can be reached again."

const PARTS = {
  "compare/ghosts": () => import("./compare/ghosts.js"),
  "compare/predict": () => import("./compare/predict.js"),
  "export/articles": () => import("./export/articles.js"),
  "export/handout": () => import("./export/handout.js"),
  "export/print": () => import("./export/print.js"),
  "export/take": () => import("./export/take.js"),
  "controls/key_list": () => import("./controls/key_list.js"),
  "controls/pointer": () => import("./controls/pointer.js"),
  "live_class/looking_around": () => import("./live_class/looking_around.js"),
  "live_class/teach": () => import("./live_class/teach.js"),
  "measured/measured": () => import("./measured/measured.js"),
  "scene/about": () => import("./scene/about.js"),
  "scene/picker": () => import("./scene/picker.js"),
  "scene/run_bar": () => import("./scene/run_bar.js"),
  "scene/voice": () => import("./scene/voice.js"),
  "shell/framed": () => import("./shell/framed.js"),
  "shell/hall_values": () => import("./shell/hall_values.js"),
  "walks/editor": () => import("./walks/editor.js"),
  "walks/own_walk": () => import("./walks/own_walk.js"),
  "walks/walk": () => import("./walks/walk.js"),
}

/**
 * @typedef {typeof PARTS} Parts
 * @typedef {keyof Parts} Name
 */

/** @type {Partial<Record<Name, Promise<unknown>>>} */
const fetched = {}

/** @type {Partial<Record<Name, unknown>>} the last action that waits for each part */
const last = {}

/** @type {() => void} removes the notice */
let found = () => {}
let missing = 0

/** Fetches a part. @template {Name} Key @param {Key} name @returns {ReturnType<Parts[Key]>} */
export function later(name) {
  let tries = 0
  /** Some browsers remember a failed import forever, so each further try has another address. */
  const fetching = () => (tries++ ? import(`./${name}.js?again=${tries}`) : PARTS[name]())
  return /** @type {ReturnType<Parts[Key]>} */ (fetched[name] ??= insisting(fetching))
}

/**
 * Calls `act` with a part as soon as it is fetched. Of several calls before that, only the last one has an effect.
 * @template {Name} Key @param {Key} name @param {(part: Awaited<ReturnType<Parts[Key]>>) => void} act
 */
export async function using(name, act) {
  last[name] = act
  const part = await later(name)
  if (last[name] === act) act(part)
}

/** Repeats a request until it succeeds, and returns its result. @template Part @param {() => Promise<Part>} fetching */
export async function insisting(fetching) {
  try {
    return await fetching()
  } catch {
    if (missing++ === 0) found = note(MISSING)
    const part = await again(fetching)
    if (--missing === 0) found()
    return part
  }
}

/** @template Part @param {() => Promise<Part>} fetching @returns {Promise<Part>} */
async function again(fetching) {
  await chance()
  try {
    return await fetching()
  } catch {
    return again(fetching)
  }
}

/** Waits for a moment at which another try makes sense. */
const chance = () =>
  new Promise(done => {
    setTimeout(done, PAUSE)
    addEventListener("online", done, {once: true})
    document.addEventListener("oscillations:connected", done, {once: true})
  })

// A walk on paper: its steps with their pictures and space for the answers, and separately the explanations. A second
// page in a hidden frame goes through the walk, so that this page and a class do not change.

import {element} from "../core/dom.js"
import {inWords} from "../core/notes.js"
import {APART} from "../core/storage.js"
import {until} from "./articles.js"
import {paged} from "./pages.js"

/** @typedef {import("../walks/walk.js").Walk} Walk */

const DESK = {width: 1280, height: 800} // px: a desktop layout, for any screen

/** Print a walk with the numbers of its file. @param {Walk} walk @param {boolean} isAnswered */
export async function handout(walk, isAnswered) {
  const {sheet, lecture} = walk
  const progress = element("p", {class: "offer", role: "status"}, "Preparing the handout.")
  document.body.append(progress)
  try {
    const articles = await gone(walk, isAnswered, place => {
      progress.textContent = `Preparing the handout: step ${place + 1} of ${sheet.steps.length}.`
    })
    paper(`${sheet.title}${isAnswered ? ": answers" : ""}`, articles)
  } catch (reason) {
    lecture.page.notice.tell(`The handout could not be prepared. ${inWords(reason)}`)
  }
  progress.remove()
}

/** @param {string} title @param {string} articles */
function paper(title, articles) {
  const section = element("section")
  section.innerHTML = articles
  section.prepend(element("h1", {}, title))
  const printed = element("div", {class: "printed handout", "data-theme": "light"}, section)
  document.body.append(printed)
  paged(section)
  addEventListener("afterprint", () => printed.remove(), {once: true})
  print()
}

/**
 * The articles of a walk that the hidden page has gone through.
 * @param {Walk} walk @param {boolean} isAnswered @param {(place: number) => void} begins @returns {Promise<string>}
 */
async function gone({sheet: {name, steps}, seed, walks: {own, texts}}, isAnswered, begins) {
  const src = `./?scene=${steps[0].opens.scene}`
  const frame = element("iframe", {...DESK, class: "apart", name: APART, src, "aria-hidden": "true", tabindex: -1})
  document.body.append(frame)
  try {
    const page = () => frame.contentWindow?.oscillations
    await until(() => page()?.connection?.wire)
    const {classes, walks} = page()
    classes.code = seed // use the numbers of the file, and the order of options on this page
    const refused = own.has(name) ? await walks.check(name, texts[name]) : ""
    if (refused) throw new Error(refused)
    return await walks.onPaper(name, isAnswered, begins)
  } finally {
    frame.remove()
  }
}

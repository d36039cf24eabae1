// A walk on paper: its steps with their pictures and space for the answers; and, printed apart, what each of them
// means. The walk is gone through once, as a visitor would; the pages are made of what it shows.

import {element, frame, marked} from "../core/dom.js"
import {paged} from "./pages.js"
import {plotPicture, stagePicture} from "./picture.js"
import {shown} from "./print.js"
import {things} from "./things.js"

/** @typedef {import("../walks/walk.js").Walk} Walk */

const PICTURE = 420 // units of a plot, half a page wide
const LONGEST = 20_000 // ms that a step may take to be shown

/** From the step that stands, and back to it. @param {Walk} walk @param {boolean} isAnswered */
export async function handout(walk, isAnswered) {
  const {place, sheet} = walk
  const progress = element("p", {class: "offer", role: "status"})
  document.body.append(progress)
  const title = `${sheet.title}${isAnswered ? ": answers" : ""}`
  const section = element("section", {}, element("h1", {}, title))
  try {
    await go(walk, 0, isAnswered, i => {
      progress.textContent = `Preparing the handout: step ${i + 1} of ${sheet.steps.length}.`
      return section
    })
  } finally {
    progress.remove()
    walk.go(place)
  }
  const paper = element("div", {class: "printed handout", "data-theme": "light"}, section)
  document.body.append(paper)
  paged(section)
  addEventListener("afterprint", () => paper.remove(), {once: true})
  print()
}

/**
 * From a step to the last: its question, or its answer.
 * @param {Walk} walk @param {number} i @param {boolean} isAnswered @param {(i: number) => HTMLElement} begin
 * @returns {Promise<void>}
 */
async function go(walk, i, isAnswered, begin) {
  const {lecture} = walk
  if (!walk.sheet.steps[i]) return
  const step = walk.numbered(walk.sheet.steps[i])
  const section = begin(i)
  walk.go(i)
  const isAsked = () => walk.place === i && !walk.lesson && walk.card?.page === lecture.page
  await until(() => isAsked() && stands(lecture, step.opens))
  // What another view of a scene has brought takes its place first.
  await frame()
  await frame()
  if (!isAnswered) section.append(question(walk, i + 1))
  else {
    walk.show(true)
    await until(() => walk.lesson && stands(lecture, step.reveals))
    await frame()
    await frame()
    section.append(answer(walk, i + 1))
  }
  await go(walk, i + 1, isAnswered, begin)
}

/** @param {() => unknown} isSo @param {number} [end] @returns {Promise<void>} */
async function until(isSo, end = performance.now() + LONGEST) {
  await frame()
  if (isSo()) return
  if (performance.now() > end) throw new Error("A step could not be shown.")
  await until(isSo, end)
}

/** @param {LectureHost} lecture @param {page.State} state */
const stands = ({kept, page}, {scene, step, covered}) =>
  kept.step === step && page.spec.slug === scene && page.shown.state.covered.length === covered.length

/** @param {Walk} walk @param {number} n */
function question({step, card, lecture: {page}}, n) {
  const head = element("h2", {}, `${n}. `, element("small", {}, step.place))
  const given = step.given ? [marked("p", {}, step.given)] : []
  const space = card?.question.space()
  return element(
    "article",
    {},
    head,
    ...given,
    marked("p", {class: "asks"}, step.question),
    element("div", {class: "printed-pictures"}, ...pictures(page, step), element("div", {class: "space"}, space ?? "")),
  )
}

/**
 * The stage, and where something is to be drawn or marked the plot for it, else the first that is not covered.
 * @param {PartHost} page @param {page.StepCard} step
 */
function pictures(page, step) {
  const {stages, plots} = things(page)
  const isApart = (/** @type {import("../paper/plots.js").Plot} */ {host}) =>
    host.closest(".column") !== stages[0]?.host.parentElement
  const asked = page.plots.filter(({block}) => block.name === step.plot)
  const others = asked.length ? asked : plots.filter(isApart).slice(0, 1)
  const drawn = [
    ...stages.slice(0, 1).map(stage => stagePicture(stage, page, false)),
    ...others.filter(plot => plot.box && !plot.absent).map(plot => plotPicture(plot, false, PICTURE)),
  ]
  return drawn.map(placed)
}

/** A picture in the size at which its labels are read. @param {import("./picture.js").Picture} picture */
function placed(picture) {
  const host = shown(picture)
  host.style.setProperty("--units", String(picture.width))
  return host
}

/** @param {Walk} walk @param {number} n */
function answer({step, lesson, card, lecture: {page}}, n) {
  const taught = /** @type {page.Lesson} */ (lesson)
  const drawn = page.plots.filter(({block, box}) => taught.findings.length && block.name === step.plot && box)
  const why = card?.element.querySelector(".why")?.cloneNode(true) ?? ""
  return element(
    "article",
    {},
    marked("h2", {}, `${n}. ${taught.title}`),
    ...(card?.question.printed(taught) ?? []),
    ...drawn.map(plot => element("div", {class: "printed-pictures"}, placed(plotPicture(plot, false, PICTURE)))),
    why,
  )
}

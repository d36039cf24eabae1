// The steps of a walk as articles for paper: the questions with space for the answers, or the explanations. The module
// goes through the walk once, as a visitor would, and copies the page at each step.

import {element, frame, marked} from "../core/dom.js"
import {plotPicture, stagePicture} from "./picture.js"
import {shown} from "./print.js"
import {things} from "./things.js"

/** @typedef {import("../walks/walk.js").Walk} Walk */

const PICTURE = 420 // units of a plot, half a page wide
const NARROWEST = 320 // units of a plot next to a stage
const LOW = 120 // units of the frame of a plot
const DRAWN_ON = {wide: 560, high: 165} // units of a plot on which students draw, and of its frame
const ROW = 945 // units of two pictures side by side on a page: their labels then have 7 pt
const LONGEST = 20_000 // ms within which a step must be visible

/**
 * The articles as HTML. `begins` is called with the place of each step.
 * @param {Walk} walk @param {boolean} isAnswered @param {(place: number) => void} begins @returns {Promise<string>}
 */
export async function articles(walk, isAnswered, begins) {
  const section = element("section")
  await go(walk, 0, isAnswered, i => {
    begins(i)
    return section
  })
  return section.innerHTML
}

/**
 * Adds the question, or the explanation, of each step from step `i` on.
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
  // Wait for the layout of another view of the scene.
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

/** Waits for a condition, at most 20 s. @param {() => unknown} isSo @param {number} [end] @returns {Promise<void>} */
export async function until(isSo, end = performance.now() + LONGEST) {
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
 * The stage, and one plot: the one on which students draw or mark something, else the first that is not hidden.
 * @param {PartHost} page @param {page.StepCard} step
 */
function pictures(page, step) {
  const {stages, plots} = things(page)
  const isApart = (/** @type {import("../scene/plots.js").Plot} */ plot) =>
    !stages.length || !page.sheet.isBeside(plot, stages[0])
  const asked = page.plots.filter(({block}) => block.name === step.plot)
  const others = asked.length ? asked : plots.filter(isApart).slice(0, 1)
  const [stage] = stages.slice(0, 1).map(one => stagePicture(one, page, false))
  const room = stage ? Math.min(PICTURE, ROW - stage.width) : PICTURE
  const drawn = others
    .filter(plot => plot.box && !plot.absent)
    .map(plot => {
      const isDrawnOn = asked.includes(plot) && !plot.block.square
      if (isDrawnOn) return plotPicture(plot, false, DRAWN_ON.wide, DRAWN_ON.high)
      return plotPicture(plot, false, asked.length || room < NARROWEST ? PICTURE : room, LOW)
    })
  return [...(stage ? [stage] : []), ...drawn].map(placed)
}

/** A picture at a size at which its labels can be read. @param {import("./picture.js").Picture} picture */
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

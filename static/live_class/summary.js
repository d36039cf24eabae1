// The summary of a class on one screen, or on one sheet of paper: each question with the number of right answers.

import {button, chip, element, marked} from "../core/dom.js"
import {fetchJson} from "./requests.js"

/** @param {page.Opened} room */
export async function summary({code, key}) {
  /** @type {page.StepSummary[]} */
  const steps = await fetchJson(`${code}/summary`, {word: key})
  const dialog = element("dialog", {class: "class-summary", "aria-label": "Summary of the class"})
  const tools = element(
    "div",
    {class: "tools"},
    chip("Print", () => onPaper(steps)),
  )
  tools.append(button({class: "act filled"}, () => dialog.close(), "Close"))
  dialog.append(element("header", {}, element("h1", {}, headline(steps)), tools))
  if (steps.length) dialog.append(table(steps))
  dialog.addEventListener("close", () => dialog.remove())
  document.body.append(dialog)
  dialog.showModal()
}

/** The step with the largest share of wrong answers in its last vote. @param {page.StepSummary[]} steps */
export function headline(steps) {
  if (!steps.length) return "Nobody has answered a question yet."
  const shares = steps.map(step => wrongOf(step) / last(step).answered)
  const most = Math.max(...shares)
  if (!most) return "All answers were right."
  const worst = steps.filter((_, i) => shares[i] === most)
  const several = new Set(steps.map(({walk}) => walk)).size > 1
  const names = worst.map(step => `step ${step.place}${several ? ` of ${step.walk}` : ""}`)
  return `Wrong most: ${names.join(", ")} (${Math.round(100 * most)} % of the answers)`
}

/** @param {page.StepSummary} step */
const last = ({votes}) => votes[votes.length - 1]

/** @param {page.StepSummary} step */
function wrongOf(step) {
  const {answered, right} = last(step)
  return answered - right
}

/** @param {page.StepSummary[]} steps */
function table(steps) {
  const names = ["Step", "Question", "Right", "Wrong most often"].map(name => element("th", {scope: "col"}, name))
  const head = element("thead", {}, element("tr", {}, ...names))
  return element("table", {}, head, element("tbody", {}, ...steps.map(row)))
}

/** @param {page.StepSummary} step */
function row({place, question, votes, mistake, mistaken}) {
  const counts = votes.map(({answered, right}) => `${right} of ${answered}`).join(" → ")
  const {answered, right} = votes[votes.length - 1]
  const bar = element("span", {class: "vote-bar"}, element("i", {style: `--share: ${right / answered}`}))
  const cells = [marked("td", {}, question), element("td", {}, counts, bar)]
  const wrong = element("td", {}, mistaken ? `${mistake} (${mistaken})` : "")
  return element("tr", {}, element("th", {scope: "row"}, String(place)), ...cells, wrong)
}

/** @param {page.StepSummary[]} steps */
function onPaper(steps) {
  const paper = element("div", {class: "printed handout class-summary", "data-theme": "light"})
  paper.append(element("h1", {}, headline(steps)), table(steps))
  document.body.append(paper)
  addEventListener("afterprint", () => paper.remove(), {once: true})
  print()
}

// Contents of the instructor's remote control: the question, the number of answers, the count of each option, notes.

import {element, marked} from "../core/dom.js"
import {orderOf} from "../questions/order.js"
import {mark} from "../questions/question.js"
import {grouped} from "../questions/word_groups.js"
import {haveAnswered} from "./counts.js"
import {sureness} from "./sureness.js"

const FEW = 5 // answers needed for an advice
const [LOW, HIGH] = [0.3, 0.7] // a discussion helps if the share of right answers is in this range

/** True if everyone who is here has answered. @param {page.RemoteView | null} view */
export function haveAllAnswered(view) {
  return Boolean(view?.here && view.tally && view.tally.now.answered >= view.here)
}

/**
 * @param {page.RemoteView} view @param {string} code of the class, which decides the order of the options
 * @param {import("../questions/word_groups.js").Moderate} moderate
 */
export function brief(view, code, moderate) {
  const {question, tally, notes} = view
  if (!question.card || !tally) return []
  return [
    marked("h2", {}, `${question.card.given} ${question.card.question}`),
    element("p", {class: "remote-count", role: "status"}, answeredBy(view)),
    ...split(view, question.card, code),
    element("ul", {class: "remote-words"}, ...tally.now.words.map(group => grouped(group, moderate))),
    ...paragraph(sureness(tally.now, true)),
    ...advice(view),
    ...notes.map(note => marked("p", {class: "remote-note"}, note)),
  ]
}

/** @param {page.RemoteView} view */
function answeredBy({question, tally, here}) {
  const turn = question.vote > 1 ? `Vote ${question.vote}: ` : ""
  const closed = question.closed && !question.lesson ? ". The vote is closed." : ""
  return `${turn}${haveAnswered(tally?.now.answered ?? 0, here)}${closed}`
}

/**
 * Rows with counts: the options with the right one marked, the features of a sketch, or the right answers.
 * @param {page.RemoteView} view @param {page.StepCard} card @param {string} code
 */
function split({tally, lesson, judges}, card, code) {
  if (!tally || !lesson) return []
  const {now, features, right} = tally
  if (card.options.length) {
    const rows = orderOf(card, code).map(i =>
      row(card.options[i], now.options[i] ?? 0, now.answered, lesson.verdicts[i]?.right),
    )
    return [element("ul", {class: "remote-split"}, ...rows)]
  }
  const truth = lesson.truth ? [element("p", {}, "Right: ", element("b", {}, lesson.truth))] : []
  if (features.length) {
    const rows = features.map((name, i) => row(name, now.having[i] ?? 0, now.answered))
    return [...truth, element("ul", {class: "remote-split"}, ...rows)]
  }
  return judges ? [...truth, element("ul", {class: "remote-split"}, row("right", right, now.answered))] : truth
}

/** @param {page.Html} html @param {number} count @param {number} all @param {boolean} [isRight] */
function row(html, count, all, isRight = false) {
  const bar = element("span", {class: "vote-bar"}, element("i", {style: `--share: ${count / Math.max(1, all)}`}))
  const name = marked("span", {}, html)
  if (isRight) name.append(" ", mark(true))
  return element("li", {class: isRight ? "right-vote" : ""}, name, element("b", {}, String(count)), bar)
}

/** @param {string} words */
const paragraph = words => (words ? [element("p", {}, words)] : [])

/** The advice to let students discuss, as in peer instruction. @param {page.RemoteView} view */
function advice({question, tally, judges}) {
  const answered = tally?.now.answered ?? 0
  if (!tally || !judges || question.lesson || answered < FEW) return []
  const share = tally.right / answered
  if (share < LOW || share > HIGH) return []
  const words = `${Math.round(100 * share)} % are right: let them talk, then vote again.`
  return [element("p", {class: "remote-advice"}, words)]
}

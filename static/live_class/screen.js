// The instructor's screen, described for a remote control: what the next press does, and which buttons do something.

/**
 * The description of the screen.
 * @param {LectureHost["walks"]} walks
 * @param {{canRepeat: boolean, asksSure: boolean, isOpen: boolean, counts: boolean, joins: boolean}} is true if the
 * question can be asked again, asks how sure the class is, takes answers, counts down; and if the join screen is open
 * @returns {page.DescribeScreen}
 */
export function describedScreen(walks, {canRepeat, asksSure, isOpen, counts, joins}) {
  const {walk} = walks
  const isAsked = Boolean(walk?.step && !walk.lesson)
  /** @type {[page.Deed, boolean][]} */
  const possible = [
    ["back", Boolean(walk && (walk.lesson || walk.place > 0))],
    ["show", isAsked && !walk?.step.poll],
    ["derive", Boolean(walk?.lesson && walk.card?.fold && !walk.card.fold.open)],
    ["again", isAsked && canRepeat],
    ["sure", isAsked && !asksSure],
    ["countdown", isAsked && isOpen],
    ["closing", isAsked && isOpen && counts],
    ["poll", true],
    ["go", Boolean(walk)],
    ["close", joins],
  ]
  return {
    type: "screen",
    next: walk?.step ? walk.press.words : walks.turns ? "Back to the walk" : "",
    blank: document.querySelector(".blank") !== null,
    deeds: possible.filter(([, is]) => is).map(([deed]) => deed),
  }
}
